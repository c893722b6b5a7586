//! The Hastings ratio T(x′→x)/T(x→x′), in the three forms a mutation may state.

use super::standing::Standing;
use super::{HastingsCounts, HastingsRatio};
use crate::num::Scaled;

/// A Hastings ratio in any of its forms.
#[derive(Clone, Copy, Debug)]
pub enum Hastings {
    One,
    HastingsCounts(HastingsCounts),
    HastingsRatio(HastingsRatio),
}

impl Hastings {
    /// Of two moves that are independent.
    #[inline]
    pub(super) const fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::One, ratio) | (ratio, Self::One) => ratio,
            (Self::HastingsCounts(a), Self::HastingsCounts(b)) => Self::HastingsCounts(a.times(b)),
            (Self::HastingsRatio(a), Self::HastingsRatio(b)) => Self::HastingsRatio(a.times(b)),
            (Self::HastingsRatio(ratio), Self::HastingsCounts(counts))
            | (Self::HastingsCounts(counts), Self::HastingsRatio(ratio)) => {
                Self::HastingsRatio(ratio.times(counts.ratio()))
            }
        }
    }
}

mod sealed {
    use super::{Hastings, Scaled, Standing};

    pub trait Stated: Copy {
        /// Whether there is a way there and back.
        fn standing(self) -> Standing;
        /// A positive ratio in floating point. [`None`] where the type says that it is always 1, so that a chain of such mutations
        /// links no code for ratios.
        fn value(self) -> Option<Scaled>;
        fn hastings(self) -> Hastings;
        /// Only mixtures and products call this, and their parts never carry more than this type can hold.
        fn of(ratio: Hastings) -> Self;
    }
}
pub(super) use sealed::Stated;

/// The Hastings ratio T(x′→x)/T(x→x′) of a proposal, in one of three forms: [`Symmetric`], which is 1 and costs nothing,
/// [`HastingsCounts`], a ratio of two integers, or a [`HastingsRatio`]. The trait is sealed.
#[diagnostic::on_unimplemented(
    message = "a mutation states its Hastings ratio as `Symmetric`, `HastingsCounts` or `HastingsRatio`, not `{Self}`",
    label = "not a form of the Hastings ratio"
)]
pub trait HastingsCorrection: Stated {
    /// The form that a mixture or a product of this one and of `C` takes.
    type With<C: HastingsCorrection>: HastingsCorrection;
    /// The form that a mixture or a product of this one and of [`HastingsCounts`] takes.
    type WithCounts: HastingsCorrection;
}

/// The Hastings ratio of a symmetric mutation: 1, since T(x′→x) = T(x→x′).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Symmetric;

impl Stated for Symmetric {
    #[inline]
    fn standing(self) -> Standing {
        Standing::Positive
    }

    #[inline]
    fn value(self) -> Option<Scaled> {
        None
    }

    #[inline]
    fn hastings(self) -> Hastings {
        Hastings::One
    }

    #[inline]
    fn of(_: Hastings) -> Self {
        Self
    }
}

impl HastingsCorrection for Symmetric {
    type With<C: HastingsCorrection> = C;
    type WithCounts = HastingsCounts;
}

impl Stated for HastingsCounts {
    #[inline]
    fn standing(self) -> Standing {
        self.way()
    }

    #[inline]
    fn value(self) -> Option<Scaled> {
        Some(self.quotient())
    }

    #[inline]
    fn hastings(self) -> Hastings {
        Hastings::HastingsCounts(self)
    }

    #[inline]
    fn of(ratio: Hastings) -> Self {
        match ratio {
            Hastings::HastingsCounts(counts) => counts,
            _ => Self::EQUAL,
        }
    }
}

impl HastingsCorrection for HastingsCounts {
    type With<C: HastingsCorrection> = C::WithCounts;
    type WithCounts = Self;
}

impl Stated for HastingsRatio {
    #[inline]
    fn standing(self) -> Standing {
        self.standing
    }

    #[inline]
    fn value(self) -> Option<Scaled> {
        Some(self.value)
    }

    #[inline]
    fn hastings(self) -> Hastings {
        Hastings::HastingsRatio(self)
    }

    #[inline]
    fn of(ratio: Hastings) -> Self {
        match ratio {
            Hastings::One => Self::ONE,
            Hastings::HastingsCounts(counts) => counts.ratio(),
            Hastings::HastingsRatio(ratio) => ratio,
        }
    }
}

impl HastingsCorrection for HastingsRatio {
    type With<C: HastingsCorrection> = Self;
    type WithCounts = Self;
}
