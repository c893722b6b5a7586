//! The Hastings ratio T(x′→x)/T(x→x′), in the forms in which a mutation states it.

use super::weight::Standing;
use super::{Counts, Ratio};
use crate::num::Scaled;

/// The ratio of a proposal in any of its forms.
#[derive(Clone, Copy, Debug)]
pub enum Hastings {
    One,
    Counts(Counts),
    Ratio(Ratio),
}

impl Hastings {
    /// Whether there is a way there and back.
    #[inline]
    pub(super) const fn standing(self) -> Standing {
        match self {
            Self::One => Standing::Positive,
            Self::Counts(counts) => counts.standing(),
            Self::Ratio(ratio) => ratio.standing,
        }
    }

    /// A positive ratio in floating point; nothing where it is 1 for every proposal.
    #[inline]
    pub(super) fn value(self) -> Option<Scaled> {
        match self {
            Self::One => None,
            Self::Counts(counts) => Some(counts.quotient()),
            Self::Ratio(ratio) => Some(ratio.value),
        }
    }
}

mod sealed {
    use super::Hastings;

    pub trait Stated: Copy {
        fn hastings(self) -> Hastings;
        /// Only mixtures call this, and their parts never state more than this type can hold.
        fn of(ratio: Hastings) -> Self;
    }
}
pub(super) use sealed::Stated;

/// The ratio T(x′→x)/T(x→x′) of a proposal: [`Symmetric`], which is 1 and costs nothing, [`Counts`], which are
/// two integers, or a [`Ratio`]. The trait is sealed.
pub trait Correction: Stated {
    /// What a mixture of mutations of this kind and of another one states.
    type With<C: Correction>: Correction;
    /// What a mixture of mutations of this kind and of some with [`Counts`] states.
    type WithCounts: Correction;
}

/// The way back is as likely as the way there: T(x′→x) = T(x→x′).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Symmetric;

impl Stated for Symmetric {
    #[inline]
    fn hastings(self) -> Hastings {
        Hastings::One
    }

    #[inline]
    fn of(_: Hastings) -> Self {
        Self
    }
}

impl Correction for Symmetric {
    type With<C: Correction> = C;
    type WithCounts = Counts;
}

impl Stated for Counts {
    #[inline]
    fn hastings(self) -> Hastings {
        Hastings::Counts(self)
    }

    #[inline]
    fn of(ratio: Hastings) -> Self {
        match ratio {
            Hastings::Counts(counts) => counts,
            _ => Self::EQUAL,
        }
    }
}

impl Correction for Counts {
    type With<C: Correction> = C::WithCounts;
    type WithCounts = Self;
}

impl Stated for Ratio {
    #[inline]
    fn hastings(self) -> Hastings {
        Hastings::Ratio(self)
    }

    #[inline]
    fn of(ratio: Hastings) -> Self {
        match ratio {
            Hastings::One => Self::ONE,
            Hastings::Counts(counts) => counts.ratio(),
            Hastings::Ratio(ratio) => ratio,
        }
    }
}

impl Correction for Ratio {
    type With<C: Correction> = Self;
    type WithCounts = Self;
}
