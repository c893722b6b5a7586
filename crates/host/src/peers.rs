//! The peers: what a user of rand_distr, of micromath or of the formulas in books over libm would write in place of
//! a warp, each as a plain function.
//!
//! Maps take their uniforms explicitly, so that their errors can be measured beside ours; [`drawn`] puts a generator
//! before them. What rejects takes the generator itself. Everything is in `f32`, as far as the peer lets it be, and
//! marked to be inlined, as the generic functions of the peers and our own are wherever they are used.

use crate::contest::{Block, block_of};
use rand_distr::Distribution;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::fmt::Debug;
use std::hint::black_box;

/// A uniform as `rand` and everyone else makes it: the upper 24 bits of a word.
#[inline]
pub fn uniform(rng: &mut Pcg32) -> f32 {
    (rng.next_u32() >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// Draws the uniforms of a map, in order.
#[inline]
pub fn drawn<const N: usize, P>(map: impl Fn([f32; N]) -> P) -> impl Fn(&mut Pcg32) -> P {
    move |rng| map(std::array::from_fn(|_| uniform(rng)))
}

/// A law of rand_distr; the compiler may not know its parameters beforehand.
pub fn theirs<P, D: Distribution<P>>(law: D) -> impl Fn(&mut Pcg32) -> P {
    let law = black_box(law);
    move |rng| law.sample(rng)
}

/// Blocks of it.
pub fn block<P: 'static, D: Distribution<P> + 'static>(law: Result<D, impl Debug>) -> Block<P> {
    Box::new(block_of(theirs(law.expect("its parameters"))))
}

mod formulas;
pub mod kit;
pub mod micro;
pub mod rejecting;
pub mod renderer;
pub mod textbook;
