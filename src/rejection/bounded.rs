//! Rejection of a density below a multiple of another one, which can be sampled.

use super::{DEFAULT_BUDGET, Failure, Rejection, with_budget};
use crate::error::{Error, positive};
use crate::num::{Scaled, happens};
use crate::warp::Warp;
use core::convert::Infallible;
use rand_core::TryRng;

/// The largest excess of f/(c p) over 1 that still counts as 1: 2⁻²⁰, because f, c and p are rounded.
///
/// If the stated error of the proposal's `pdf` is larger than this, the bound c has to cover it.
pub const SLACK: f32 = 8.0 * f32::EPSILON;

/// Any density f ≤ c p, known up to a factor, by rejection from a warp of density p.
///
/// A proposed point is accepted with probability f/(c p).
///
/// # Density
/// f/∫f. The probability of acceptance is f/(c p) as an `f32`, exact to 2 ulp for all magnitudes (nothing overflows or
/// underflows on the way), then rounded to a multiple of 2⁻³². A ratio below 2⁻³³ is never accepted, a ratio of 1 always.
///
/// # Domain
/// - Point: that of the proposal, where f > 0.
/// - Words a try: those of the proposal, then one that decides.
/// - Parameters: the proposal, f, and the bound c. Each proposed point is checked against the bound. Where f exceeds it
///   by more than [`SLACK`], the draw fails with [`Failure::BoundExceeded`]; clamping would change the distribution
///   silently.
///
/// # Cost
/// Efficiency: (∫f)/c.
///
/// # Examples
/// ```
/// use microwarp::poly as mw;
/// use microwarp::rejection::{Bounded, Rejection};
/// use rand_pcg::Pcg32;
/// // f = 1/(1 + |x|²) on the disk, where p = 1/π: f/p is at most π, at the centre.
/// let f = |[x, y]: [f32; 2]| 1.0 / (1.0 + x * x + y * y);
/// let bumped = Bounded::new(mw::Disk::new(), f, core::f32::consts::PI)?;
/// let accepted = bumped.draw(&mut Pcg32::new(1, 1))?;
/// // The efficiency is π ln 2 / π = 69 %.
/// assert!(accepted.tries <= bumped.budget());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// `?` does not turn the [`Failure`] of a draw into the error of a constructor: a function that has both returns a
/// `Box<dyn Error>`, or maps them as the [example](Failure#examples) does.
///
/// # See also
/// - [`Region`](super::Region), where f is p or 0.
/// - [`metropolis`](crate::metropolis) needs no bound, but its points depend on each other.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "accept_reject")]
#[doc(alias = "rejection_sampling")]
#[doc(alias = "envelope")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bounded<W, F> {
    proposal: W,
    density: F,
    bound: f32,
    budget: u32,
}

impl<W, F> Bounded<W, F>
where
    W: Warp<Density = f32>,
    F: Fn(W::Point) -> f32,
{
    /// Samples the density f = `density` by points of `proposal`, with c = `bound` and the budget [`DEFAULT_BUDGET`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a bound that is NaN or infinite, [`Error::NotPositive`] for a bound of 0
    /// or less.
    pub fn new(proposal: W, density: F, bound: f32) -> Result<Self, Error> {
        Ok(Self {
            proposal,
            density,
            bound: positive(bound, 2)?,
            budget: DEFAULT_BUDGET,
        })
    }

    with_budget!();

    /// The warp that proposes points.
    pub const fn proposal(&self) -> &W {
        &self.proposal
    }

    /// The bound c.
    #[must_use]
    pub const fn bound(&self) -> f32 {
        self.bound
    }

    /// One try with the given uniforms and a word that decides: a smaller word accepts more points.
    ///
    /// For a uniform number v in [0, 1), pass the word `(v * 4_294_967_296.0) as u32`.
    ///
    /// # Errors
    /// [`Failure::BoundExceeded`], [`Failure::NotFinite`], [`Failure::Negative`] and
    /// [`Failure::ProposalDensity`], for any word.
    #[inline]
    pub fn attempt(
        &self,
        u: W::Uniforms,
        word: u32,
    ) -> Result<Option<W::Point>, Failure<Infallible>> {
        self.judge(self.proposal.sample(u), word)
    }

    #[inline]
    fn judge<E>(&self, point: W::Point, word: u32) -> Result<Option<W::Point>, Failure<E>> {
        let f = (self.density)(point);
        if !f.is_finite() {
            return Err(Failure::NotFinite);
        }
        if f < 0.0 {
            return Err(Failure::Negative);
        }
        let p = self.proposal.pdf(point);
        if !(p > 0.0 && p <= f32::MAX) {
            return Err(Failure::ProposalDensity);
        }
        if f == 0.0 {
            return Ok(None);
        }
        let ratio = quotient(f, p, self.bound);
        if ratio > 1.0 + SLACK {
            return Err(Failure::BoundExceeded { ratio });
        }
        Ok(happens(ratio, word).then_some(point))
    }
}

impl<W, F> Rejection for Bounded<W, F>
where
    W: Warp<Density = f32>,
    F: Fn(W::Point) -> f32,
{
    type Point = W::Point;

    #[inline]
    fn budget(&self) -> u32 {
        self.budget
    }

    #[inline]
    fn try_once<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Option<W::Point>, Failure<R::Error>> {
        let point = self.proposal.try_draw(rng).map_err(Failure::Generator)?;
        let word = rng.try_next_u32().map_err(Failure::Generator)?;
        self.judge(point, word)
    }
}

/// f/(p c) of three positive finite numbers. Only the result can overflow.
#[inline]
fn quotient(f: f32, p: f32, c: f32) -> f32 {
    Scaled::of(f)
        .over(Scaled::of(p))
        .over(Scaled::of(c))
        .value()
}
