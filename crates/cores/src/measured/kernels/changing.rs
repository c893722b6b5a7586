//! Weights that change in memory: one of a tree, and those of a stream.

use super::tables::{Tree, integers};
use crate::measured::registry::{kernels, loaded, ok, store};
use microwarp::discrete::WeightedReservoir;

kernels! {
    "sum_tree_64_set" (index: u32, weight: u32) -> u32 = {
        let tree: &mut Tree<64> = loaded(|| Tree::new(integers()));
        tree.set(index as usize & 63, weight >> 6).unwrap_or(0)
    }, store(ok(Tree::<64>::new(integers())));
    "weighted_reservoir_8" (weight: u32, word: u32) -> u32 = {
        let reservoir: &mut WeightedReservoir<u32, 8> = loaded(|| Ok(WeightedReservoir::new()));
        u32::from(reservoir.offer_with(word, weight, word))
    }, store(WeightedReservoir::<u32, 8>::new());
}
