//! The Hastings ratio T(x′→x)/T(x→x′), in the forms in which a mutation states it.

use super::target_value::Standing;
use super::{HastingsCounts, HastingsRatio};
use crate::num::Scaled;

/// The ratio of a proposal in any of its forms.
#[derive(Clone, Copy, Debug)]
pub enum Hastings {
    One,
    HastingsCounts(HastingsCounts),
    HastingsRatio(HastingsRatio),
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

/// The ratio T(x′→x)/T(x→x′) of a proposal: [`Symmetric`], which is 1 and costs nothing, [`HastingsCounts`], which are
/// two integers, or a [`HastingsRatio`]. The trait is sealed.
pub trait HastingsCorrection: Stated {
    /// What a mixture of mutations of this kind and of another one states.
    type With<C: HastingsCorrection>: HastingsCorrection;
    /// What a mixture of mutations of this kind and of some with [`HastingsCounts`] states.
    type WithCounts: HastingsCorrection;
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
