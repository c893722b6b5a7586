//! Tables: they select with the probabilities that they state, to the last bit, counted wherever there is something to
//! count; cells, curves, meshes and skies over them, and where they lie in memory.
//!
//! Truth is integers and `f64`. How samples of warps are distributed is in `tests/distributions`, errors of samples and
//! densities are in `tests/accuracy`.
#![expect(
    clippy::incompatible_msrv,
    reason = "tests compile with a newer compiler than the crate asks for"
)]

mod alias;
mod binomials;
mod cases;
mod counted;
mod counts;
mod curves;
mod edges;
mod ends;
mod exact;
mod hypergeometrics;
mod integers;
mod leftover;
mod light_reservoir;
mod masses;
mod meshes;
mod mixtures;
mod negative_binomials;
mod pictures;
mod places;
mod refused_ranges;
mod refused_weights;
mod resampling;
mod reservoir;
mod select_once;
mod signed;
mod skies;
mod stack;
mod storage;
mod sum_tree;
mod trusted;
mod weighted_reservoir;

use microwarp::Warp;
use microwarp::discrete::Cdf;
use rand_core::TryRng;
use std::convert::Infallible;

/// A generator that hands out given words, then none.
pub struct Given<'a>(pub &'a [u32]);

impl TryRng for Given<'_> {
    type Error = Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let (first, rest) = self.0.split_first().expect("no more words than documented");
        self.0 = rest;
        Ok(*first)
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        unreachable!("words of 32 bits are drawn")
    }
    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        unreachable!("words of 32 bits are drawn")
    }
}

/// The point of given words of the generator.
pub fn draw<W: Warp>(warp: &W, words: &[u32]) -> W::Point {
    warp.draw(&mut Given(words))
}

/// The words that a `u64` is drawn from.
pub fn halves(word: u64) -> [u32; 2] {
    [(word >> 32) as u32, word as u32]
}

/// The lower edges of equal cells, and the end: as documented, operation by operation.
pub fn edge([low, high]: [f32; 2], count: usize, index: usize) -> f32 {
    let t = index as f32 / count as f32;
    (1.0 - t) * low + t * high
}

/// The spacing of `f32` just below a magnitude.
pub fn step_below(x: f32) -> f64 {
    f64::from(x.abs()) - f64::from(x.abs().next_down())
}

/// A table of cells that all weigh the same.
pub fn equal(count: usize, memory: &mut [u32]) -> Cdf<&[u32]> {
    Cdf::<&[u32]>::from_integers_in(&vec![1; count], memory).unwrap()
}
