//! Points: Sobol' with Owen's scrambling, additive recurrences, and random words by position.
//!
//! - `intervals`: the structure of Sobol' points, exactly; and their directions against the textbook's
//! - `integration`: errors of means and how they fall, discrepancy, seeds, truncation
//! - `latin`: strata of Latin hypercubes, and the errors of means
//! - `hashes`: the scrambling beside Owen's, and the statistics of words by position
//! - `neighbours`: words of neighbouring samples, pixels and seeded generators are independent
//! - `screen`, `pictures`: the order of a set over a picture, and the errors of neighbouring pixels
//! - `uses`: warps, strata and the integer tier take a point as a generator

mod hashes;
mod integration;
mod intervals;
mod latin;
mod neighbours;
mod pictures;
mod screen;
mod uses;

use microwarp::uniform::{Points, Recurrence, Sobol};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::sync::LazyLock;

/// What is tried: two words from a seed and an index.
type Set = fn(u32, u32) -> [u32; 2];

fn sobol(seed: u32, index: u32) -> [u32; 2] {
    Sobol::<2>::new(seed).unwrap().words(index)
}

/// The second group of two dimensions, which has an order of its own.
fn second_pair(seed: u32, index: u32) -> [u32; 2] {
    let set = Sobol::<2>::new(seed).unwrap();
    [2, 3].map(|dimension| set.word(index, dimension))
}

fn recurrence(seed: u32, index: u32) -> [u32; 2] {
    Recurrence::<2>::new(seed).unwrap().words(index)
}

/// Two words of a generator, whose state is moved on.
fn random(seed: u32, index: u32) -> [u32; 2] {
    let mut rng = Pcg32::new(seed.into(), 7);
    rng.advance(2 * u64::from(index));
    [rng.next_u32(), rng.next_u32()]
}

/// The first two dimensions of Sobol', by the definition: digits reversed, and sums of binomials modulo 2.
fn plain(index: u32) -> [u32; 2] {
    // The binomial of k over j is odd where j has no bit that k lacks.
    static COLUMNS: LazyLock<[u32; 32]> = LazyLock::new(|| {
        std::array::from_fn(|k| (0..32).fold(0, |word, j| word << 1 | u32::from(j & !k == 0)))
    });
    let bits = COLUMNS
        .iter()
        .enumerate()
        .filter(|(k, _)| index >> k & 1 == 1);
    [
        index.reverse_bits(),
        bits.fold(0, |sum, (_, column)| sum ^ column),
    ]
}
