//! What a target returns for a state, and integer weights.

use crate::error::Error;

/// Whether a chain can be at a state, or can take a proposal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Standing {
    /// It can.
    Positive,
    /// It cannot.
    Zero,
    /// The number is not a valid density, weight or ratio.
    Unsound,
}

impl Standing {
    /// Judges a density in `f32`.
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

    /// Judges a product.
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
        /// Accepts only a weight at which a chain can be, and says what is wrong with any other.
        #[inline]
        fn positive(self) -> Result<(), Error> {
            match self.standing() {
                Standing::Positive => Ok(()),
                Standing::Zero => Err(Error::NotPositive),
                Standing::Unsound => Err(self.fault()),
            }
        }
        /// The error for an unsound weight.
        fn fault(self) -> Error;
    }
}
pub(super) use sealed::Weighing;

/// What the target of a chain returns for a state: a [`TargetDensity`](super::TargetDensity), which is an `f32` or a
/// [`LogDensity`](super::LogDensity), or an integer weight, `u32`; or one of them [`WithPayload`](super::WithPayload). The
/// trait is sealed.
///
/// A chain never enters a state of value 0.
#[diagnostic::on_unimplemented(
    message = "a target of a chain returns `f32`, `LogDensity` or `u32`, not `{Self}`",
    label = "not a value of a target",
    note = "what else the target finds goes along as `WithPayload::new(density, payload)`"
)]
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
