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

mod sealed {
    use super::{Hastings, Scaled, Standing};

    pub trait Stated: Copy {
        /// Whether there is a way there and back.
        fn standing(self) -> Standing;
        /// A positive ratio in floating point; nothing where it is 1 for every proposal, which the type says, so that a
        /// chain of such mutations links no ratio.
        fn value(self) -> Option<Scaled>;
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

impl Correction for Symmetric {
    type With<C: Correction> = C;
    type WithCounts = Counts;
}

impl Stated for Counts {
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
    fn standing(self) -> Standing {
        self.standing
    }

    #[inline]
    fn value(self) -> Option<Scaled> {
        Some(self.value)
    }

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
