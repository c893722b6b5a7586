//! The samplers of rand and rand_distr, and what their users put together from them where they have none. They reject,
//! so that the number of words they draw is random.

use super::uniform;
use rand::RngExt;
use rand::seq::SliceRandom;
use rand_distr::weighted::{WeightedAliasIndex, WeightedIndex, WeightedTreeIndex};
use rand_distr::{Distribution, Exp1, StandardNormal};
use rand_distr::{UnitBall, UnitCircle, UnitDisc, UnitSphere};
use rand_pcg::Pcg32;
use std::hint::black_box;

/// The unit disk: `UnitDisc`.
#[inline]
pub fn disk(rng: &mut Pcg32) -> [f32; 2] {
    UnitDisc.sample(rng)
}

/// The unit circle: `UnitCircle`.
#[inline]
pub fn circle(rng: &mut Pcg32) -> [f32; 2] {
    UnitCircle.sample(rng)
}

/// The unit sphere: `UnitSphere`.
#[inline]
pub fn sphere(rng: &mut Pcg32) -> [f32; 3] {
    UnitSphere.sample(rng)
}

/// The upper half of it: `UnitSphere`, folded.
#[inline]
pub fn hemisphere(rng: &mut Pcg32) -> [f32; 3] {
    let [x, y, z] = sphere(rng);
    [x, y, z.abs()]
}

/// In proportion to the cosine: `UnitDisc`, lifted.
#[inline]
pub fn cosine_hemisphere(rng: &mut Pcg32) -> [f32; 3] {
    let [x, y] = disk(rng);
    [x, y, (1.0 - (x * x + y * y)).max(0.0).sqrt()]
}

/// In proportion to the nth power of the cosine, of `exponent` 1/(n + 1): `UnitCircle` at a height that is a
/// power of a uniform.
#[inline]
pub fn lobe(exponent: f32, rng: &mut Pcg32) -> [f32; 3] {
    let z = uniform(rng).powf(exponent);
    let r = (1.0 - z * z).sqrt();
    let [x, y] = circle(rng);
    [r * x, r * y, z]
}

/// The exponential distribution of mean 1: `Exp1`.
#[inline]
pub fn exponential(rng: &mut Pcg32) -> f32 {
    Exp1.sample(rng)
}

/// One standard normal: `StandardNormal`.
#[inline]
pub fn normal(rng: &mut Pcg32) -> f32 {
    StandardNormal.sample(rng)
}

/// The unit ball: `UnitBall`.
#[inline]
pub fn ball(rng: &mut Pcg32) -> [f32; 3] {
    UnitBall.sample(rng)
}

/// An integer below n: `random_range`.
#[inline]
pub fn below(n: u32) -> impl Fn(&mut Pcg32) -> u32 {
    move |rng| rng.random_range(0..n)
}

/// An integer of a range: `random_range`.
#[inline]
pub fn range(low: i32, high: i32) -> impl Fn(&mut Pcg32) -> i32 {
    move |rng| rng.random_range(low..=high)
}

/// An integer of 64 bits below n: `random_range`.
#[inline]
pub fn below_of_64_bits(n: u64) -> impl Fn(&mut Pcg32) -> u64 {
    move |rng| rng.random_range(0..n)
}

/// Whether an event happens: `random_bool`.
#[inline]
pub fn chance(p: f64) -> impl Fn(&mut Pcg32) -> bool {
    move |rng| rng.random_bool(p)
}

/// A random order of numbers, again and again, of which the first is given: `SliceRandom::shuffle`.
#[inline]
pub fn shuffle(mut items: Vec<u32>) -> impl FnMut(&mut Pcg32) -> u32 {
    move |rng| {
        items.shuffle(rng);
        items.first().copied().unwrap_or(0)
    }
}

/// So many numbers in random order, of which the first is given: `SliceRandom::partial_shuffle`.
#[inline]
pub fn choose(mut items: Vec<u32>, chosen: usize) -> impl FnMut(&mut Pcg32) -> u32 {
    move |rng| {
        let (chosen, _) = items.partial_shuffle(rng, chosen);
        chosen.first().copied().unwrap_or(0)
    }
}

/// Indices by running sums: `WeightedIndex<f32>`.
#[inline]
pub fn cumulative(weights: &[f32]) -> impl Fn(&mut Pcg32) -> usize + use<> {
    let table = WeightedIndex::new(weights.iter().copied()).expect("weights");
    move |rng| table.sample(rng)
}

/// Indices by Walker's aliases: `WeightedAliasIndex<f32>`.
#[inline]
pub fn aliases(weights: &[f32]) -> impl Fn(&mut Pcg32) -> usize + use<> {
    let table = WeightedAliasIndex::new(weights.to_vec()).expect("weights");
    move |rng| table.sample(rng)
}

/// Indices by a tree of sums, of which the drawn one gets another weight: `WeightedTreeIndex<u32>`.
#[inline]
pub fn tree(weights: Vec<u32>) -> impl FnMut(&mut Pcg32) -> usize {
    let mut tree = WeightedTreeIndex::new(weights).expect("weights");
    move |rng| {
        let index = tree.sample(rng);
        let changed = tree.update(index, 1 + index as u32 % 4095);
        black_box(changed).expect("a weight");
        index
    }
}
