//! Rejection: points are proposed until one is accepted, for a number of tries given beforehand.
//!
//! Here live the loop, once, and the list of samplers: [`Region`] keeps the points of a warp for which a
//! predicate holds, [`Bounded`] turns the points of one density into points of another,
//! [`DiskRejection`] and [`BallRejection`] are the unit disk and ball without any elementary function, and
//! [`ZigguratNormal`] and [`ZigguratExponential`], each with a standard form, draw from the layers of a curve, in flash.
//! What a proposal is, is the business of [`warp`](crate::warp); the usual one is the bounding box,
//! [`Aabb`](crate::warp::Aabb). The disks whose points are fixed-point numbers are with their tier, feature `fixed`.
//!
//! # Efficiency
//! The share of proposals that is accepted is the **efficiency** e. For a region it is the probability that
//! the proposal gives to it; for a density f ≤ c p over proposals of (normalised) density p it is (∫f)/c,
//! which is 1/c where f is normalised too.
//!
//! | sampler | efficiency | words (`u32`) a try |
//! |---|--:|--:|
//! | [`DiskRejection`] | π/4 = 78.5 % | 2 |
//! | [`BallRejection`] | π/6 = 52.4 % | 3 |
//! | [`ZigguratStandardNormal`], [`ZigguratNormal`] | 99.3 % | 1, sometimes 2 or 3 |
//! | [`ZigguratStandardExponential`], [`ZigguratExponential`] | 98.9 % | 1, sometimes 2 or 3 |
//! | `fixed::DiskRejection` | π/4 = 78.5 % | 2 |
//! | `fixed::DiskRejection16` | π/4 = 78.5 % | 1 |
//! | [`Region`] | ∫ p over the region | what drawing the proposal takes |
//! | [`Bounded`] | (∫f)/c | what drawing the proposal takes, and 1 |
//!
//! The tries of an accepted point are geometrically distributed, with mean 1/e, and independent of the point.
//! Every [`Accepted`] carries them: accepted points over tries is the measured efficiency.
//!
//! # Budget
//! There is no unbounded loop. A sampler tries as often as its budget says, then reports
//! [`Failure::BudgetSpent`]; so a region that is empty, or a generator
//! stuck at values that are rejected, ends in an error and not in a hang.
//! [`budget_for`] gives a budget that a true random generator does not spend in practice.

mod ball;
mod bounded;
mod failure;
mod region;
mod ziggurat;

pub use self::ball::{BallRejection, DiskRejection};
pub use self::bounded::{Bounded, SLACK};
pub use self::failure::Failure;
pub use self::region::Region;
pub use self::ziggurat::{
    ZigguratExponential, ZigguratNormal, ZigguratStandardExponential, ZigguratStandardNormal,
};

use crate::error::{Error, positive};
use core::convert::Infallible;
use rand_core::{Rng, TryRng};

/// The budget of [`Region`] and [`Bounded`] where `with_budget` sets no other: 1000 tries.
///
/// A true random generator spends it with a probability below 2⁻⁶⁴ where the efficiency is 4.5 % or more. For less,
/// take [`budget_for`].
pub const DEFAULT_BUDGET: u32 = 1000;

/// A point that was accepted, and how many tries it took.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Accepted<P> {
    /// The point.
    pub point: P,
    /// The tries it took, itself included: from 1 to the budget.
    pub tries: u32,
}

/// A sampler that proposes a point and accepts it or not.
///
/// To write one of one's own, give the budget and a single try; the bounded loop is here.
///
/// Source: J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
///
/// ```
/// use microwarp::rejection::{DiskRejection, Rejection};
/// use rand_pcg::Pcg32;
///
/// let (mut rng, mut tries) = (Pcg32::new(1, 1), 0);
/// for _ in 0..1000 {
///     tries += DiskRejection::new().draw(&mut rng)?.tries;
/// }
/// let efficiency = 1000.0 / tries as f32;
/// assert!((efficiency - DiskRejection::EFFICIENCY).abs() < 0.05);
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
pub trait Rejection {
    /// The point: that of the proposal.
    type Point: Copy;

    /// How many points are proposed at most; at least one.
    #[must_use]
    fn budget(&self) -> u32;

    /// Proposes one point; `None` if it is not accepted.
    ///
    /// # Errors
    /// The generator's own error as [`Failure::Generator`], and what the sampler finds wrong.
    fn try_once<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Option<Self::Point>, Failure<R::Error>>;

    /// Draws one point.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if no point of the budget was accepted, and those of [`Self::try_once`].
    #[inline]
    fn try_draw<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<Self::Point>, Failure<R::Error>> {
        draw_after(0, self, rng)
    }

    /// Draws one point from a generator that cannot fail.
    ///
    /// # Errors
    /// As [`Self::try_draw`], except that the generator does not fail.
    #[inline]
    fn draw<R: Rng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<Self::Point>, Failure<Infallible>> {
        self.try_draw(rng)
    }
}

/// The tries after some that were not accepted.
#[inline]
fn draw_after<S: Rejection + ?Sized, R: TryRng + ?Sized>(
    mut tries: u32,
    sampler: &S,
    rng: &mut R,
) -> Result<Accepted<S::Point>, Failure<R::Error>> {
    let budget = sampler.budget();
    while tries < budget {
        tries = tries.wrapping_add(1);
        if let Some(point) = sampler.try_once(rng)? {
            return Ok(Accepted { point, tries });
        }
    }
    Err(Failure::BudgetSpent { tries: budget })
}

/// [`Rejection::try_draw`] of a sampler whose budget is not 0 and whose try is short: the first, which is mostly the
/// last, stands ahead of the loop, so that it does without the loop's registers (a fifth of the instructions less).
#[inline]
pub(crate) fn draw_first_ahead<S: Rejection + ?Sized, R: TryRng + ?Sized>(
    sampler: &S,
    rng: &mut R,
) -> Result<Accepted<S::Point>, Failure<R::Error>> {
    match sampler.try_once(rng)? {
        Some(point) => Ok(Accepted { point, tries: 1 }),
        None => draw_after(1, sampler, rng),
    }
}

/// A budget that independent tries of the given efficiency spend with a probability below 2⁻⁶⁴.
///
/// That is 44.4/e, rounded up: (1 − e)ⁿ ≤ exp(−e n) < 2⁻⁶⁴. An efficiency above 1 counts as 1.
///
/// # Errors
/// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less,
/// [`Error::OutOfRange`] for an efficiency below 1.1e-8, whose budget a `u32` does not hold.
///
/// ```
/// use microwarp::rejection::budget_for;
/// assert_eq!(budget_for(0.5), Ok(89));
/// ```
pub const fn budget_for(efficiency: f32) -> Result<u32, Error> {
    /// A little above 64 ln 2 = 44.361.
    const TRIES: f32 = 44.4;
    match positive(efficiency) {
        Ok(e) if e < 1.1e-8 => Err(Error::OutOfRange),
        Ok(e) => {
            let e = if e < 1.0 { e } else { 1.0 };
            // Below 4.04e9, so that neither the cast nor the next integer leaves a u32.
            Ok(((TRIES / e) as u32).wrapping_add(1))
        }
        Err(e) => Err(e),
    }
}

/// The method that sets a sampler's budget, the same for all; `const` where no error would have to drop the sampler.
macro_rules! with_budget {
    ($($const:ident)?) => {
        /// The same sampler with at most `budget` tries a point.
        ///
        /// # Errors
        /// [`Error::NotPositive`](crate::Error::NotPositive) for a budget of 0.
        pub $($const)? fn with_budget(mut self, budget: u32) -> Result<Self, crate::Error> {
            if budget == 0 {
                return Err(crate::Error::NotPositive);
            }
            self.budget = budget;
            Ok(self)
        }
    };
}
pub(crate) use with_budget;

/// Constructors of a sampler that is nothing but a budget.
macro_rules! budgeted {
    ($name:ident, $budget:literal) => {
        impl $name {
            /// The default budget. A true random generator spends it with a probability below 2⁻⁶⁴.
            pub const BUDGET: u32 = $budget;

            $crate::rejection::with_budget!(const);

            /// The sampler with the budget [`Self::BUDGET`].
            #[must_use]
            pub const fn new() -> Self {
                Self {
                    budget: Self::BUDGET,
                }
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}
pub(crate) use budgeted;

/// [`Rejection`] of a sampler that is nothing but a budget and a short try.
macro_rules! short_tries {
    ($name:ident: $point:ty, |$sampler:ident, $rng:ident| $try:expr) => {
        impl $crate::rejection::Rejection for $name {
            type Point = $point;

            #[inline]
            fn budget(&self) -> u32 {
                self.budget
            }

            #[inline]
            fn try_once<R: rand_core::TryRng + ?Sized>(
                &self,
                $rng: &mut R,
            ) -> Result<Option<$point>, $crate::rejection::Failure<R::Error>> {
                let $sampler = self;
                $try
            }

            #[inline]
            fn try_draw<R: rand_core::TryRng + ?Sized>(
                &self,
                rng: &mut R,
            ) -> Result<$crate::rejection::Accepted<$point>, $crate::rejection::Failure<R::Error>>
            {
                $crate::rejection::draw_first_ahead(self, rng)
            }
        }
    };
}
pub(crate) use short_tries;
