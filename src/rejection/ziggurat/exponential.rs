//! The exponential distribution by a ziggurat.

use super::layers::{Layers, Shape};
use super::{Law, attempt_at, try_draw, try_once, ziggurat};
use crate::error::Error;
use crate::rejection::{Accepted, Failure, Rejection, budgeted, with_budget};
use crate::tier::{Poly, Tier};
use crate::warp::{Exponential, Warp};
use rand_core::TryRng;

/// Where the tail starts. See `tests/rejection/layers.rs` for this and the next.
const START: f64 = 7.697_117_470_131_05;

/// The area of a layer.
const AREA: f64 = 0.003_949_659_822_581_557;

static LAYERS: Layers = Layers::new(Shape::Exponential, START, AREA);

/// The exponential law of rate 1.
struct Standard;

impl Law for Standard {
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

/// Exponential with rate 1, by a ziggurat: one word, one table entry of 8 bytes and one product in 97.8 draws of 100.
///
/// - Words a try: one. A second in 2.2 % of the tries; a second and a third in 0.045 %, for the tail.
/// - Range: 3.8e-9 to 52.76. Up to 7.697 the numbers lie on 256 grids laid
///   over each other, one a layer: the odd multiples of 2⁻²⁴ of its width, which is 0.0639 to 8.70. The tail beyond,
///   of probability 4.54e-4, is inverted at a uniform of full resolution.
/// - Density: e^(−x) for x ≥ 0; off as that of [`Exponential`] is.
/// - Efficiency: 98.9 %.
/// - Of one word, the first 23 bits are the place and the last 8 choose the layer, so that neither tells anything of
///   the other. Wedges and the tail are those of the polynomial tier.
/// - The numbers are not monotone in the words, and how many words a number takes is not fixed: for strata, replays
///   by the uniform and chains take [`Exponential`].
///
/// The density that is realised is off by 7e-7 of itself at most, and the grids' steps add 6e-8 to the probability of
/// an interval at each of its ends; `tests/rejection/layers.rs` compares them with f64.
///
/// Sources: G. Marsaglia, W. W. Tsang, "The Ziggurat Method for Generating Random Variables", 2000; J. A. Doornik,
/// "An Improved Ziggurat Method to Generate Normal Random Samples", 2005, which found that the former's layer and
/// place share bits.
///
/// ```
/// use microwarp::rejection::{Rejection, ZigguratStandardExponential};
/// use rand_pcg::Pcg32;
/// let wait = ZigguratStandardExponential::new();
/// let x = wait.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x > 0.0 && x < 52.77);
/// assert_eq!(wait.pdf(0.0), 1.0);
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZigguratStandardExponential {
    budget: u32,
}

budgeted!(ZigguratStandardExponential, 10);

/// Exponential with a rate, by a ziggurat: a standard exponential number over the rate, rounded once more.
///
/// - Words a try, efficiency: those of [`ZigguratStandardExponential`].
/// - Range: that of the standard numbers over the rate, 3.8e-9 to 52.76.
/// - Density: a e^(−ax) for x ≥ 0; off as that of [`Exponential`] is.
///
/// Sources: those of [`ZigguratStandardExponential`].
///
/// ```
/// use microwarp::rejection::{Rejection, ZigguratExponential};
/// use rand_pcg::Pcg32;
/// let free_path = ZigguratExponential::from_rate(2.0)?;
/// let x = free_path.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(free_path.pdf(x) > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZigguratExponential {
    law: Exponential<Poly>,
    rate: f32,
    budget: u32,
}

impl ZigguratStandardExponential {
    /// The share of tries that is accepted, in theory.
    pub const EFFICIENCY: f32 = 0.989_009_2;

    /// The density at a number; 0 for those below 0, NaN and infinity. Never 0 at a number that was drawn.
    #[must_use]
    #[inline]
    pub fn pdf(&self, x: f32) -> f32 {
        const LAW: Result<Exponential<Poly>, Error> = Exponential::from_rate(1.0);
        LAW.map_or(0.0, |law| law.pdf(x))
    }
}

impl ZigguratExponential {
    /// The share of tries that is accepted, in theory.
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
        match law {
            Ok(law) => Ok(Self {
                law,
                rate: law.rate(),
                budget: Self::BUDGET,
            }),
            Err(e) => Err(e),
        }
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

    /// The density at a number; 0 for those below 0, NaN and infinity. Never 0 at a number that was drawn.
    #[must_use]
    #[inline]
    pub fn pdf(&self, x: f32) -> f32 {
        self.law.pdf(x)
    }
}

ziggurat!(ZigguratStandardExponential: Standard, |_sampler, x| x);
ziggurat!(ZigguratExponential: Standard, |exponential, x| x / exponential.rate);
