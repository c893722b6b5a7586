//! Host time in nanoseconds per step of a chain, by mutation and number of coordinates.
//!
//! `cargo bench --bench chains`. Each figure is for 1,024 steps with PCG32 and the target, which takes a few
//! multiplications unless stated otherwise. Compare figures of one run only.

use divan::{Bencher, black_box};
use host::bench::repeat;
use microwarp::discrete::Cdf;
use microwarp::metropolis::*;
use microwarp::poly as mw;
use rand_pcg::rand_core::Rng;

fn main() {
    divan::main();
}

/// Times the steps of a chain.
fn steps<X: Copy, D: TargetDensity, M: Mutation<X>>(
    bencher: Bencher,
    start: X,
    target: impl Fn(X) -> D,
    mutation: M,
) {
    let mut chain = Chain::new(start, &target).unwrap();
    let mutation = black_box(mutation);
    repeat(bencher, |rng| chain.step(&target, &mutation, rng).state());
}

/// Two humps in one dimension.
fn humps(x: f32) -> f32 {
    (x - 0.5) * (x - 0.5)
}

/// A product of slopes, in any number of dimensions.
fn slopes<const D: usize>(x: [f32; D]) -> f32 {
    x.iter().fold(1.0, |product, x| product * (0.5 + x))
}

fn kelemen() -> LargeSmall<WrappedWalk<mw::LogUniformStep>> {
    let small = mw::LogUniformStep::new(1.0 / 1024.0, 1.0 / 64.0).unwrap();
    Mixture::large_small(0.3, WrappedWalk::new(small)).unwrap()
}

#[divan::bench]
fn a_floor_of_two_words(bencher: Bencher) {
    repeat(bencher, |rng| rng.next_u32() ^ rng.next_u32());
}

#[divan::bench]
fn uniform_1(bencher: Bencher) {
    steps(bencher, 0.1, humps, UniformStep::new());
}

#[divan::bench]
fn box_1(bencher: Bencher) {
    let inside = |x: f32| {
        if (0.0..=1.0).contains(&x) {
            humps(x)
        } else {
            0.0
        }
    };
    steps(bencher, 0.1, inside, BoxStep::new(0.1).unwrap());
}

#[divan::bench]
fn box_wrapped_1(bencher: Bencher) {
    steps(
        bencher,
        0.1,
        humps,
        WrappedWalk::new(BoxStep::new(0.1).unwrap()),
    );
}

#[divan::bench]
fn box_and_uniform_1(bencher: Bencher) {
    let small = WrappedWalk::new(BoxStep::new(0.1).unwrap());
    let mutation = Mixture::new((small, UniformStep::new()), &[0.9, 0.1]).unwrap();
    steps(bencher, 0.1, humps, mutation);
}

#[divan::bench]
fn normal_2(bencher: Bencher) {
    let log = |[x, y]: [f32; 2]| mw::LogDensity::new(-0.5 * (x * x + y * y));
    steps(
        bencher,
        [0.0; 2],
        log,
        mw::NormalStep::new([1.0; 2]).unwrap(),
    );
}

#[divan::bench(consts = [2, 8, 32])]
fn large_and_exponential<const D: usize>(bencher: Bencher) {
    steps(bencher, [0.5; D], slopes, kelemen());
}

#[divan::bench(consts = [2, 8, 32])]
fn one_coordinate<const D: usize>(bencher: Bencher) {
    let small = mw::LogUniformStep::new(1.0 / 1024.0, 1.0 / 4.0).unwrap();
    steps(
        bencher,
        [0.5; D],
        slopes,
        OneCoordinate::new(WrappedWalk::new(small)),
    );
}

/// The target takes a lobe's sample and density.
#[divan::bench]
fn lobe_driven(bencher: Bencher) {
    let lobe = mw::PhongLobe::new(20.0).unwrap();
    let target = primary_density(lobe, |[x, _, z]: [f32; 3]| if x > 0.0 { z } else { 0.0 });
    steps(bencher, [0.9, 0.1], target, kelemen());
}

#[divan::bench]
fn independence_of_a_warp(bencher: Bencher) {
    let proposal = mw::Linear::new(1.0, 2.0).unwrap();
    steps(bencher, 0.1, humps, Independence::new(proposal));
}

#[divan::bench]
fn independence_of_a_table_of_64(bencher: Bencher) {
    let weights: [f32; 64] = core::array::from_fn(|i| (i % 7) as f32 + 1.0);
    let target = |i: usize| (i % 5) as f32 + 1.0;
    let table = Cdf::new(&weights).unwrap();
    steps(bencher, 0, target, Independence::new(table));
}

#[divan::bench]
fn any_of_65536_indices(bencher: Bencher) {
    let picture: Vec<f32> = (0..65_536_u32).map(|i| (i % 251) as f32 + 1.0).collect();
    let target = |i: usize| picture[i];
    steps(bencher, 0, target, UniformIndex::new(65_536).unwrap());
}

#[divan::bench(consts = [16, 64])]
fn health_push<const LAGS: usize>(bencher: Bencher) {
    let mut health = Autocorrelation::<LAGS>::new();
    repeat(bencher, |rng| health.push(rng.next_u32() as f32));
}
