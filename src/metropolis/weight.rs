//! What a chain weighs its states by, in general: what a step asks of it, and integers.

use super::Chance;
use crate::error::Error;
use crate::num::Scaled as Apart;
use core::fmt::Debug;

/// What a weight says of its state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// A chain may be there.
    Positive,
    /// A chain is never there.
    Zero,
    /// Not a weight at all.
    Unsound,
}

mod sealed {
    use super::{Apart, Error, Standing};

    /// What acceptance, of type `A`, needs of a weight.
    pub trait Weighing<A>: Copy {
        fn standing(self) -> Standing;
        /// Refuses every weight where a chain cannot be, and says why.
        #[inline]
        fn positive(self) -> Result<(), Error> {
            match self.standing() {
                Standing::Positive => Ok(()),
                Standing::Zero => Err(Error::NotPositive),
                Standing::Unsound => Err(self.fault()),
            }
        }
        /// Why it is unsound.
        fn fault(self) -> Error;
        /// min(1, to/from), of two positive weights.
        fn accepted(from: Self, to: Self) -> A;
        /// Likewise with a ratio of the mutation.
        fn accepted_with_ratio(from: Self, to: Self, ratio: Apart) -> A;
        /// min(1, to·backward/(from·forward)), all positive, the counts up to 2⁶⁴.
        fn accepted_with_counts(from: Self, to: Self, forward: u128, backward: u128) -> A;
    }

    /// What a step needs of an acceptance.
    #[allow(
        unreachable_pub,
        reason = "it bounds a type of a public trait, which Rust 1.85 does not see"
    )]
    pub trait Probability: Copy {
        const NEVER: Self;
        const ALWAYS: Self;
        /// Whether a word accepts.
        fn happens(self, word: u32) -> bool;
    }
}
pub(super) use sealed::{Probability, Weighing};

/// What a target says of a state: a [`Density`](super::Density), which is an `f32` or the logarithm of one, or
/// an integer, `u32`. The trait is sealed.
///
/// A weight of 0 is a state the chain never enters.
pub trait Weight: Weighing<<Self as Weight>::Acceptance> {
    /// What the acceptance of a step is: `f32` of a density, an exact [`Chance`] of integers.
    type Acceptance: Probability + Debug + PartialEq;
}

impl Weighing<Chance> for u32 {
    #[inline]
    fn standing(self) -> Standing {
        if self > 0 {
            Standing::Positive
        } else {
            Standing::Zero
        }
    }

    #[inline]
    fn fault(self) -> Error {
        Error::NotPositive
    }

    #[inline]
    fn accepted(from: Self, to: Self) -> Chance {
        Chance::of(to.into(), from.into())
    }

    #[inline]
    fn accepted_with_ratio(from: Self, to: Self, ratio: Apart) -> Chance {
        Chance::of_apart(from, to, ratio)
    }

    #[inline]
    fn accepted_with_counts(from: Self, to: Self, forward: u128, backward: u128) -> Chance {
        Chance::of_counts(from, to, forward, backward)
    }
}

impl Weight for u32 {
    type Acceptance = Chance;
}
