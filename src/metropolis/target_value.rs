//! What a target says of a state, in general, and integer weights.

use crate::error::Error;

/// Whether a chain can be at a state, or can take a way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Standing {
    /// It can.
    Positive,
    /// It never does.
    Zero,
    /// The number is not a weight or a ratio at all.
    Unsound,
}

impl Standing {
    /// That of a density in `f32`.
    #[inline]
    pub(super) const fn of_density(x: f32) -> Self {
        if x > 0.0 && x <= f32::MAX {
            Self::Positive
        } else if x == 0.0 {
            Self::Zero
        } else {
            Self::Unsound
        }
    }

    /// That of a product.
    #[inline]
    pub(super) const fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Unsound, _) | (_, Self::Unsound) => Self::Unsound,
            (Self::Zero, _) | (_, Self::Zero) => Self::Zero,
            (Self::Positive, Self::Positive) => Self::Positive,
        }
    }
}

mod sealed {
    use super::{Error, Standing};

    pub trait Weighing: Copy {
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
    }
}
pub(super) use sealed::Weighing;

/// What a target says of a state: a [`TargetDensity`](super::TargetDensity), which is an `f32` or the logarithm of one, or
/// an integer, `u32`. The trait is sealed.
///
/// A weight of 0 is a state the chain never enters.
pub trait TargetValue: Weighing {}

impl Weighing for u32 {
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
}

impl TargetValue for u32 {}
