//! Rejection sampling within a budget: points are proposed until one is accepted, for a limited number of tries.
//!
//! | sampler | what it draws | efficiency | words (`u32`) a try |
//! |---|---|--:|--:|
//! | [`Region`] | the points of a warp for which a predicate holds | ∫ p over the region | those of the warp |
//! | [`Bounded`] | a density f ≤ c p, from a warp of density p | (∫f)/c | those of the warp, and 1 |
//! | [`DiskRejection`] | the unit disk | π/4 = 78.5 % | 2 |
//! | [`BallRejection`] | the unit ball | π/6 = 52.4 % | 3 |
//! | [`ZigguratStandardNormal`], [`ZigguratNormal`] | normal numbers | 99.3 % | 1, sometimes 2 or 3 |
//! | [`ZigguratStandardExponential`], [`ZigguratExponential`] | exponential numbers | 98.9 % | 1, sometimes 2 or 3 |
//! | [`PoissonRejection`] | counts of events | 77 % to 89 % | 2 |
//! | [`BinomialRejection`] | counts of successes | 77 % to 89 % | 2 |
//! | [`HypergeometricRejection`] | counts of marked items in a sample | 77 % to 89 % | 2 |
//! | [`VonMises`] | angles about a mean direction | 66 % to 100 % | 2 |
//! | [`Gamma`] | waiting times for several events, chi-squared | 95 % to 100 % | 2, sometimes 3 |
//! | [`Beta`], [`Dirichlet`] | shares of a whole, probabilities | that of each share | those of each share |
//! | `fixed::DiskRejection` | the unit disk, in fixed point | π/4 = 78.5 % | 2 |
//! | `fixed::DiskRejection16` | the unit disk, in fixed point of 16 bits | π/4 = 78.5 % | 1 |
//!
//! A rejection sampler takes no fixed number of uniforms. For strata, low-discrepancy points, replays
//! from a uniform and chains, take a [`warp`](crate::warp). Warps also propose the points here; the usual one is the
//! bounding box, [`Aabb`](crate::warp::Aabb).
//!
//! # No inverse
//! The words that give a point are not a function of it: any decision that accepts gives the same point, tries that were rejected leave
//! no trace, and a gamma number below shape 1 is a product of two. An inverse of a gamma or a beta distribution would be one of their
//! distribution functions, incomplete gamma and beta functions, which nothing here evaluates: it would belong to another sampler, one
//! that solves for the number of a uniform. The members of these families that have a closed form are warps, with their inverses:
//! [`Exponential`](crate::warp::Exponential) (gamma of shape 1, chi-squared of 2 degrees), [`Power`](crate::warp::Power) (beta with a
//! shape of 1), [`Simplex`](crate::warp::Simplex) (Dirichlet with all shapes 1).
//!
//! # Efficiency
//! The **efficiency** e is the share of proposals that is accepted. For a region it is the probability that the proposal
//! gives to it. For a density f ≤ c p, where p is normalised, it is (∫f)/c; that is 1/c if f is normalised, too.
//!
//! The number of tries a point is geometrically distributed with mean 1/e, and independent of the point. Each [`Accepted`]
//! point carries it, so that accepted points over tries measure the efficiency.
//!
//! # Budget
//! No loop is unbounded. A sampler tries as often as its budget allows, then returns [`Failure::BudgetSpent`]. A region
//! that is empty, or a generator stuck at rejected values, thus ends in an error instead of a hang. Each constructor sets
//! a default budget, and `with_budget` another. [`budget_for`] computes one that a true random generator does not spend in
//! practice.
//!
//! A [`Failure`] is not the [`Error`] of a constructor, and `?` does not turn one into the other: a function that has both
//! returns a `Box<dyn Error>`, or maps them as the [example](Failure#examples) does.

mod ball;
mod beta;
mod binomial;
mod bounded;
mod dirichlet;
mod failure;
mod gamma;
mod gamma_density;
mod gamma_tries;
mod hypergeometric;
mod poisson;
mod region;
mod stirling;
mod transformed;
mod von_mises;
mod ziggurat;

pub use self::ball::{BallRejection, DiskRejection};
pub use self::beta::Beta;
pub use self::binomial::BinomialRejection;
pub use self::bounded::{Bounded, SLACK};
pub use self::dirichlet::Dirichlet;
pub use self::failure::Failure;
pub use self::gamma::Gamma;
pub use self::hypergeometric::HypergeometricRejection;
pub use self::poisson::PoissonRejection;
pub use self::region::Region;
pub use self::von_mises::VonMises;
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
    /// The number of tries, from 1 to the budget: the rejected ones and the accepted one.
    pub tries: u32,
}

/// A sampler that proposes a point and accepts it or not.
///
/// Implement [`budget`](Rejection::budget) and [`try_once`](Rejection::try_once); the bounded loop is provided.
///
/// # Examples
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
///
/// # See also
/// - [`Warp`](crate::Warp), for a fixed number of uniforms a point.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "accept_reject")]
#[doc(alias = "rejection_sampling")]
pub trait Rejection {
    /// The type of the points.
    type Point: Copy;

    /// The largest number of tries a point; at least 1.
    #[must_use]
    fn budget(&self) -> u32;

    /// Proposes one point; `None` if it is rejected.
    ///
    /// # Errors
    /// [`Failure::Generator`] with the error of a generator that fails, and the failures that the sampler documents.
    fn try_once<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Option<Self::Point>, Failure<R::Error>>;

    /// Draws one point from a generator that may fail.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if no point within the budget was accepted, and those of [`Self::try_once`].
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
    /// [`Failure::BudgetSpent`] if no point within the budget was accepted, and the failures that the sampler documents.
    #[inline]
    fn draw<R: Rng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<Self::Point>, Failure<Infallible>> {
        self.try_draw(rng)
    }
}

/// Draws one point after some tries that were rejected.
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

/// [`Rejection::try_draw`] for samplers with a short try and a budget above 0.
///
/// The first try, mostly the only one, stands ahead of the loop. It then needs none of the loop's registers, which saves
/// a fifth of the instructions.
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

/// The same for tries of more instructions: those after the first stand apart.
#[allow(clippy::inline_always, reason = "breaks a false dependency")]
#[cfg_attr(target_arch = "x86_64", inline(always))]
#[cfg_attr(not(target_arch = "x86_64"), inline)]
pub(crate) fn draw_first_alone<S: Rejection + Copy, R: TryRng + ?Sized>(
    sampler: &S,
    rng: &mut R,
) -> Result<Accepted<S::Point>, Failure<R::Error>> {
    // Of a copy, so that the compiler keeps apart what the first try needs.
    #[inline(never)]
    fn others<S: Rejection + Copy, R: TryRng + ?Sized>(
        sampler: S,
        rng: &mut R,
    ) -> Result<Accepted<S::Point>, Failure<R::Error>> {
        draw_after(1, &sampler, rng)
    }
    match sampler.try_once(rng)? {
        Some(point) => Ok(Accepted { point, tries: 1 }),
        None => others(*sampler, rng),
    }
}

/// A budget that independent tries of the given efficiency spend with a probability below 2⁻⁶⁴.
///
/// It is 44.4/e, rounded up, since (1 − e)ⁿ ≤ exp(−e n) < 2⁻⁶⁴. An efficiency above 1 counts as 1.
///
/// # Errors
/// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less,
/// [`Error::OutOfRange`] for an efficiency below 1.1e-8, whose budget a `u32` does not hold.
///
/// # Examples
/// ```
/// use microwarp::rejection::budget_for;
/// assert_eq!(budget_for(0.5), Ok(89));
/// ```
pub const fn budget_for(efficiency: f32) -> Result<u32, Error> {
    /// A little above 64 ln 2 = 44.361.
    const TRIES: f32 = 44.4;
    match positive(efficiency, 0) {
        Ok(e) if e < 1.1e-8 => Err(Error::OutOfRange(0)),
        Ok(e) => {
            let e = if e < 1.0 { e } else { 1.0 };
            // Below 4.04e9, so that neither the cast nor the next integer leaves a u32.
            Ok(((TRIES / e) as u32).wrapping_add(1))
        }
        Err(e) => Err(e),
    }
}

/// The method that sets the budget, the same for every sampler. It is `const` where the sampler needs no `Drop`.
macro_rules! with_budget {
    ($($const:ident)?) => {
        /// The same sampler with at most `budget` tries a point.
        ///
        /// # Errors
        /// [`Error::NotPositive`](crate::Error::NotPositive) for a budget of 0.
        pub $($const)? fn with_budget(mut self, budget: u32) -> Result<Self, crate::Error> {
            if budget == 0 {
                return Err(crate::Error::NotPositive(0));
            }
            self.budget = budget;
            Ok(self)
        }
    };
}
pub(crate) use with_budget;

/// The constructors of a sampler whose only field is its budget.
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

/// Implements [`Rejection`] for a sampler whose only field is its budget, from its short try.
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
