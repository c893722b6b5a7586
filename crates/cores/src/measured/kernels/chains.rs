//! Steps of a chain that lies in memory, with the generator, over a target of a few multiplications; and weights that change.

use super::tables::{Tree, integers};
use crate::measured::registry::{kernels, loaded, made, ok, store};
use microwarp::Error;
use microwarp::discrete::WeightedReservoir;
use microwarp::metropolis::{
    Chain, LargeSmall, LogUniformStep, Mixture, NormalStep, Tuning, UniformStep, WrappedWalk,
};
use microwarp::tier::{Libm, Poly, Tier};
use rand_pcg::Pcg32;

type Point = [f32; 2];
type LargeAndSmall<T> = (Chain<Point>, LargeSmall<WrappedWalk<LogUniformStep<T>>>);

fn slopes([x, y]: Point) -> f32 {
    (0.5 + x) * (0.5 + y)
}

fn large_and_small<T: Tier>() -> Result<LargeAndSmall<T>, Error> {
    let small = LogUniformStep::new(1.0 / 1024.0, 1.0 / 64.0)?;
    Ok((
        Chain::new([0.5; 2], slopes)?,
        Mixture::large_small(0.3, WrappedWalk::new(small))?,
    ))
}

fn uniform() -> Result<Chain<Point>, Error> {
    Chain::new([0.5; 2], slopes)
}

#[inline(always)]
fn step<T: Tier>((chain, mutation): &mut LargeAndSmall<T>, rng: &mut Pcg32) -> Point {
    chain.step(slopes, mutation, rng).state()
}

type Tuned<T> = Tuning<Point, NormalStep<Point, T>>;

fn tuning<T: Tier>() -> Result<Tuned<T>, Error> {
    Tuning::new(uniform()?, NormalStep::new([0.5; 2])?, 0.35)
}

#[inline(always)]
fn tune<T: Tier>(tuning: &mut Tuned<T>, rng: &mut Pcg32) -> f32 {
    tuning.step(slopes, rng);
    tuning.scale()
}

kernels! {
    "chain_uniform_2_pcg32" (rng) -> [f32; 2] =
        loaded(uniform).step(slopes, &UniformStep::new(), rng).state(), made(uniform);
    "poly_chain_large_small_2_pcg32" (rng) -> [f32; 2] =
        step(loaded(large_and_small::<Poly>), rng), made(large_and_small::<Poly>);
    "libm_chain_large_small_2_pcg32" (rng) -> [f32; 2] =
        step(loaded(large_and_small::<Libm>), rng), made(large_and_small::<Libm>);
    "poly_chain_tuning_2_pcg32" (rng) -> f32 =
        tune(loaded(tuning::<Poly>), rng), made(tuning::<Poly>);
    "libm_chain_tuning_2_pcg32" (rng) -> f32 =
        tune(loaded(tuning::<Libm>), rng), made(tuning::<Libm>);

    // Weights that change in memory: one of a tree, and those of a stream.
    "sum_tree_64_set" (index: u32, weight: u32) -> u32 = {
        let tree: &mut Tree<64> = loaded(|| Tree::new(integers()));
        tree.set(index as usize & 63, weight >> 6).unwrap_or(0)
    }, store(ok(Tree::<64>::new(integers())));
    "weighted_reservoir_8" (weight: u32, word: u32) -> u32 = {
        let reservoir: &mut WeightedReservoir<u32, 8> = loaded(|| Ok(WeightedReservoir::new()));
        u32::from(reservoir.offer_with(word, weight, word))
    }, store(WeightedReservoir::<u32, 8>::new());
}
