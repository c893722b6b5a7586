//! The acceptance of a proposal: what densities and integer weights have in common.

use super::HastingsCorrection;
use crate::num::happens;

/// A probability that random words decide about: an `f32`, or a [`Chance`](super::Chance).
pub trait Probability: Copy {
    const NEVER: Self;
    const ALWAYS: Self;

    fn accepts(self, word: u32) -> bool;
}

/// The acceptance of a proposal between values `D` of a target.
pub trait Acceptance<D>: Probability {
    /// min(1, f′T′/(fT)), of a proposal of value f′ by a chain at a state of value f, both positive.
    fn between(f: D, f_new: D, ratio: impl HastingsCorrection) -> Self;
}

impl Probability for f32 {
    const NEVER: Self = 0.0;
    const ALWAYS: Self = 1.0;

    #[inline]
    fn accepts(self, word: u32) -> bool {
        happens(self, word)
    }
}
