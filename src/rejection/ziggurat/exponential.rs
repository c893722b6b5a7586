//! The exponential distribution by a ziggurat.

use super::layers::{Layers, Shape};
use super::{Distribution, attempt_at, try_draw, try_once, ziggurat};
use crate::error::{Error, tried};
use crate::rejection::{Accepted, Failure, Rejection, budgeted, with_budget};
use crate::tier::{Poly, Tier};
use crate::warp::{Exponential, Warp};
use rand_core::TryRng;

/// Where the tail starts. `tests/rejection/layers.rs` checks this and the next.
const START: f64 = 7.697_117_470_131_05;

/// The area of a layer.
const AREA: f64 = 0.003_949_659_822_581_557;

static LAYERS: Layers = Layers::new(Shape::Exponential, START, AREA);

/// The exponential distribution of rate 1.
struct Standard;

impl Distribution for Standard {
    #[inline]
    fn layers() -> &'static Layers {
        &LAYERS
    }

    #[inline]
    #[expect(clippy::cast_possible_wrap, reason = "24 bits are left")]
    fn place(word: u32) -> i32 {
        // From 1 to 2²⁴ − 1. The bit that is set would be one more than an `f32` holds.
        ((word >> 8) | 1) as i32
    }

    #[inline(never)]
    fn excess(width: f32, x: f32) -> f32 {
        Poly::exp_m1(width - x)
    }

    #[inline]
    fn tail(u: f32, _: f32) -> f32 {
        START as f32 - Poly::ln(u)
    }
}

/// Exponential with rate 1, by a ziggurat: the cheapest way to draw it.
///
/// 97.8 draws of 100 take one word, one table entry of 8 bytes and one product. The numbers are not monotone in the words, and the number of words is not fixed. For strata, for replays from the uniform and for chains, take [`Exponential`].
///
/// # Density
/// e⁻ˣ for x ≥ 0, with the errors of [`Exponential`]; 0 below.
///
/// # Domain
/// - Point: 3.8e-9 to 52.76. Up to 7.697 the numbers lie on 256 grids, one a layer: the odd multiples of 2⁻²⁴ of the
///   layer's width, which is 0.0639 to 8.70. Beyond lies the tail, of probability 4.54e-4, which is inverted at a uniform
///   of full resolution.
/// - Words a try: one. A second in 2.2 % of the tries; a second and a third in 0.045 %, for the tail. The first 23 bits
///   of a word are the place and its last 8 choose the layer, so that neither depends on the other. Wedges and the tail
///   use the functions of the polynomial tier.
///
/// # Accuracy
/// The density that is realised has a relative error of at most 7e-7. The steps of the grids add 6e-8 to the probability
/// of an interval at each of its ends. `tests/rejection/layers.rs` compares both with `f64`.
///
/// # Cost
/// Efficiency: 98.9 %. The table of 2 KB lies in flash.
///
/// # Examples
/// ```
/// use microwarp::rejection::{Rejection, ZigguratStandardExponential};
/// use rand_pcg::Pcg32;
/// let wait = ZigguratStandardExponential::new();
/// let x = wait.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x > 0.0 && x < 52.77);
/// assert_eq!(wait.pdf(0.0), 1.0);
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
///
/// # See also
/// - [`ZigguratExponential`] has any rate or mean.
/// - [`warp::Exponential`](crate::warp::Exponential) and [`warp::ExponentialTail`](crate::warp::ExponentialTail) take a
///   fixed number of words and have an inverse. [`Exponential::fill`](crate::Warp::fill) is the fastest way to fill a
///   slice on a PC.
///
/// # Source
/// G. Marsaglia and W. W. Tsang, "The Ziggurat Method for Generating Random Variables", 2000,
/// <https://doi.org/10.18637/jss.v005.i08>.
///
/// J. A. Doornik, "An Improved Ziggurat Method to Generate Normal Random Samples", 2005,
/// <https://www.doornik.com/research/ziggurat.pdf>. It found that layer and place shared bits in the original.
#[doc(alias = "poisson_process")]
#[doc(alias = "waiting_time")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZigguratStandardExponential {
    budget: u32,
}

budgeted!(ZigguratStandardExponential, 10);

/// Exponential with a rate or a mean, by a ziggurat: a standard exponential number over the rate, rounded once more.
///
/// # Density
/// a e⁻ᵃˣ for x ≥ 0 and rate a, with the errors of [`Exponential`]; 0 below.
///
/// # Domain
/// - Point: 3.8e-9/a to 52.76/a.
/// - Words a try: those of [`ZigguratStandardExponential`].
/// - Parameter: the rate a > 0, or the mean 1/a.
///
/// # Accuracy
/// The standard number has the errors of [`ZigguratStandardExponential`].
///
/// # Cost
/// Efficiency: that of [`ZigguratStandardExponential`].
///
/// # Examples
/// The constructor returns an [`Error`], a draw a [`Failure`]; a function that uses both returns
/// `Box<dyn core::error::Error>`, or maps them: see [`Failure`].
/// ```
/// use microwarp::rejection::{Rejection, ZigguratExponential};
/// use rand_pcg::Pcg32;
/// let free_path = ZigguratExponential::from_rate(2.0)?;
/// let x = free_path.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(free_path.pdf(x) > 0.0);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
///
/// # See also
/// - [`ZigguratStandardExponential`] has rate 1.
/// - [`warp::Exponential`](crate::warp::Exponential) and [`warp::ExponentialTail`](crate::warp::ExponentialTail) take a
///   fixed number of words and have an inverse. `Exponential` fills a slice faster.
///
/// # Source
/// That of [`ZigguratStandardExponential`].
#[doc(alias = "poisson_process")]
#[doc(alias = "waiting_time")]
#[doc(alias = "free_path")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZigguratExponential {
    law: Exponential<Poly>,
    rate: f32,
    budget: u32,
}

impl ZigguratStandardExponential {
    /// The share of tries that is accepted, by theory.
    pub const EFFICIENCY: f32 = 0.989_009_2;

    /// The density at a number. It is 0 below 0, for NaN and infinity, and never 0 at a drawn number.
    #[must_use]
    #[inline]
    pub fn pdf(&self, x: f32) -> f32 {
        const LAW: Result<Exponential<Poly>, Error> = Exponential::from_rate(1.0);
        LAW.map_or(0.0, |law| law.pdf(x))
    }
}

impl ZigguratExponential {
    /// The share of tries that is accepted, by theory.
    pub const EFFICIENCY: f32 = ZigguratStandardExponential::EFFICIENCY;

    /// The default budget, that of [`ZigguratStandardExponential`].
    pub const BUDGET: u32 = ZigguratStandardExponential::BUDGET;

    with_budget!(const);

    /// Exponential with the given rate (the reciprocal of the mean), and the budget [`Self::BUDGET`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::TooLarge`] for a rate
    /// so small that the tail overflows (below 3.1e-37).
    pub const fn from_rate(rate: f32) -> Result<Self, Error> {
        Self::of(Exponential::from_rate(rate))
    }

    /// Exponential with the given mean, and the budget [`Self::BUDGET`]. Its rate is 1/mean, rounded to `f32`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::Empty`] for a mean so
    /// small that the density overflows (below 2.9e-39), [`Error::TooLarge`] for one so large that the tail does
    /// (above 3.2e36).
    pub const fn from_mean(mean: f32) -> Result<Self, Error> {
        Self::of(Exponential::from_mean(mean))
    }

    const fn of(law: Result<Exponential<Poly>, Error>) -> Result<Self, Error> {
        let law = tried!(law);
        Ok(Self {
            law,
            rate: law.rate(),
            budget: Self::BUDGET,
        })
    }

    /// The rate.
    #[must_use]
    pub const fn rate(&self) -> f32 {
        self.rate
    }

    /// The mean, 1/rate rounded to `f32`.
    #[must_use]
    pub const fn mean(&self) -> f32 {
        1.0 / self.rate
    }

    /// The density at a number. It is 0 below 0, for NaN and infinity, and never 0 at a drawn number.
    #[must_use]
    #[inline]
    pub fn pdf(&self, x: f32) -> f32 {
        self.law.pdf(x)
    }
}

ziggurat!(ZigguratStandardExponential: Standard, |_sampler, x| x);
ziggurat!(ZigguratExponential: Standard, |exponential, x| x / exponential.rate);
