//! Tables in flash and rejection, which belong to no tier.

use crate::registry::kernels;
use crate::registry::ok;
use fixed::types::I2F30;
use microwarp::Warp;
use microwarp::discrete::{Alias, AliasEntry, Cdf, PiecewiseConstant1d, PiecewiseConstant2d};
use microwarp::fixed as integer;
use microwarp::rejection::{BallRejection, DiskRejection, Rejection};
use rand_core::Rng;

/// Weights of a table, no two neighbours alike.
const fn weights<const N: usize>() -> [f32; N] {
    let mut weights = [0.0; N];
    let mut index = 0;
    while index < N {
        weights[index] = (index * 37 % 101 + 1) as f32;
        index += 1;
    }
    weights
}

/// Weights of a picture.
const fn picture() -> [[f32; 16]; 8] {
    let (flat, mut picture, mut index) = (weights::<128>(), [[0.0; 16]; 8], 0);
    while index < 128 {
        picture[index / 16][index % 16] = flat[index];
        index += 1;
    }
    picture
}

// The tables are statics of the kernels that select from them: one elsewhere would be built by the compiler with
// every function.

macro_rules! alias {
    ($n:literal) => {{
        static TABLE: Alias<[AliasEntry<u32>; $n]> =
            ok(Alias::<[AliasEntry<u32>; $n]>::new(&weights::<$n>()));
        &TABLE
    }};
}

macro_rules! cdf {
    ($n:literal) => {{
        static TABLE: Cdf<[u32; $n]> = ok(Cdf::<[u32; $n]>::new(&weights::<$n>()));
        &TABLE
    }};
}

macro_rules! pieces {
    ($n:literal) => {{
        static TABLE: PiecewiseConstant1d<[u32; $n]> = ok(
            PiecewiseConstant1d::<[u32; $n]>::from_weights(&weights::<$n>(), 0.0, 1.0),
        );
        &TABLE
    }};
}

macro_rules! picture {
    () => {{
        static TABLE: PiecewiseConstant2d<[u32; 8], [[u32; 16]; 8]> =
            ok(PiecewiseConstant2d::<[u32; 8], [[u32; 16]; 8]>::new(
                &picture(),
                [0.0, 1.0],
                [0.0, 1.0],
            ));
        &TABLE
    }};
}

kernels! {
    // The index that a word selects.
    "alias_8" (word: u32) -> usize = alias!(8).index(word);
    "alias_8_pcg32" (rng) -> usize = alias!(8).index(rng.next_u32());
    "alias_64" (word: u32) -> usize = alias!(64).index(word);
    "alias_64_pcg32" (rng) -> usize = alias!(64).index(rng.next_u32());
    "alias_1024" (word: u32) -> usize = alias!(1024).index(word);
    "alias_1024_pcg32" (rng) -> usize = alias!(1024).index(rng.next_u32());
    "cdf_8" (word: u32) -> usize = cdf!(8).index(word);
    "cdf_8_pcg32" (rng) -> usize = cdf!(8).index(rng.next_u32());
    "cdf_64" (word: u32) -> usize = cdf!(64).index(word);
    "cdf_64_pcg32" (rng) -> usize = cdf!(64).index(rng.next_u32());
    "cdf_1024" (word: u32) -> usize = cdf!(1024).index(word);
    "cdf_1024_pcg32" (rng) -> usize = cdf!(1024).index(rng.next_u32());

    // A point, which takes the rest of the word too.
    "piecewise_constant_1d_64" (u: f32) -> f32 = pieces!(64).sample(u);
    "piecewise_constant_1d_64_pcg32" (rng) -> f32 = pieces!(64).draw(rng);
    "piecewise_constant_2d_16_8" (u: f32, v: f32) -> [f32; 2] = picture!().sample([u, v]);
    "piecewise_constant_2d_16_8_pcg32" (rng) -> [f32; 2] = picture!().draw(rng);

    // Rejection, with its generator.
    "rejection_disk_pcg32" (rng) -> [f32; 2] = DiskRejection::new().draw(rng).map_or([0.0; 2], |accepted| accepted.point);
    "rejection_ball_pcg32" (rng) -> [f32; 3] = BallRejection::new().draw(rng).map_or([0.0; 3], |accepted| accepted.point);
    "fixed_rejection_disk_pcg32" (rng) -> [I2F30; 2] =
        integer::DiskRejection::new().draw(rng).map_or([I2F30::ZERO; 2], |accepted| accepted.point);
    "fixed_rejection_disk_16_pcg32" (rng) -> [I2F30; 2] =
        integer::DiskRejection16::new().draw(rng).map_or([I2F30::ZERO; 2], |accepted| accepted.point);
}
