//! The normal distribution by a ziggurat.

use super::layers::{Layers, Shape};
use super::{Distribution, attempt_at, try_draw, try_once, ziggurat};
use crate::error::{Error, tried};
use crate::rejection::{Accepted, Failure, Rejection, budgeted, with_budget};
use crate::tier::{Poly, Tier};
use crate::warp::{Normal, Warp};
use rand_core::TryRng;

/// Where the tail starts. `tests/rejection/layers.rs` checks this and the next two.
const START: f64 = 3.654_152_885_361_009;

/// The area of a layer.
const AREA: f64 = 0.004_928_673_233_974_65;

/// The probability of being beyond the start of one tail.
const BEYOND: f32 = 0.000_129_016_24;

static LAYERS: Layers = Layers::new(Shape::Normal, START, AREA);

/// The standard normal distribution.
struct Standard;

impl Distribution for Standard {
    #[inline]
    fn layers() -> &'static Layers {
        &LAYERS
    }

    #[inline]
    #[expect(
        clippy::cast_possible_wrap,
        reason = "two's complement is what is meant"
    )]
    fn place(word: u32) -> i32 {
        // From −(2²⁴ − 1) to 2²⁴ − 1. The lowest bit, which belongs to the layer, is set.
        (word as i32 >> 7) | 1
    }

    #[inline(never)]
    fn excess(width: f32, x: f32) -> f32 {
        Poly::exp_m1(0.5 * (width - x) * (width + x))
    }

    #[inline]
    fn tail(u: f32, x: f32) -> f32 {
        Poly::normal_quantile_lower(u * BEYOND).copysign(x)
    }
}

/// Standard normal (Gaussian), by a ziggurat: the fastest way to draw one number at a time.
///
/// 98.5 draws of 100 take one word, one table entry of 8 bytes and one product. The numbers are not monotone in the words, and the number of words is not fixed. For strata, for replays from the uniform and for chains, take [`Normal`].
///
/// # Density
/// e^(−x²/2)/√(2π), at least 2⁻¹⁴⁹ for every finite x, with the errors of [`Normal`].
///
/// # Domain
/// - Point: finite numbers up to ±10.08, never 0. Up to 3.654 they lie on 256 grids, one a layer: the odd multiples of
///   2⁻²⁴ of the layer's width, which is 0.215 to 3.91. The smallest number is 1.3e-8. Beyond lie the tails, each of
///   probability 1.29e-4, which are inverted at a uniform of full resolution.
/// - Words a try: one. A second in 1.5 % of the tries; a second and a third in 0.026 %, for the tails. The first 24 bits
///   of a word are the place and its last 8 choose the layer, so that neither depends on the other. Wedges and tails use
///   the functions of the polynomial tier.
///
/// # Accuracy
/// The density that is realised has a relative error of at most 7e-7. The steps of the grids add 6e-8 to the probability
/// of an interval at each of its ends. `tests/rejection/layers.rs` compares both with `f64`.
///
/// # Cost
/// Efficiency: 99.33 %. The table of 2 KB lies in flash.
///
/// # Examples
/// ```
/// use microwarp::rejection::{Rejection, ZigguratStandardNormal};
/// use rand_pcg::Pcg32;
/// let noise = ZigguratStandardNormal::new();
/// let x = noise.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(x.abs() < 10.08);
/// assert!((noise.pdf(0.0) - 0.398_942_3).abs() < 1e-7);
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
///
/// # See also
/// - [`ZigguratNormal`] has any mean and standard deviation.
/// - [`warp::Normal`](crate::warp::Normal) and [`warp::NormalPair`](crate::warp::NormalPair) take a fixed number of
///   uniforms and have an inverse. [`NormalPair::fill`](crate::Warp::fill) is the fastest way to fill a slice on a
///   PC.
///
/// # Source
/// G. Marsaglia and W. W. Tsang, "The Ziggurat Method for Generating Random Variables", 2000,
/// <https://doi.org/10.18637/jss.v005.i08>.
///
/// J. A. Doornik, "An Improved Ziggurat Method to Generate Normal Random Samples", 2005,
/// <https://www.doornik.com/research/ziggurat.pdf>. It found that layer and place shared bits in the original.
#[doc(alias = "gaussian")]
#[doc(alias = "normal")]
#[doc(alias = "randn")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZigguratStandardNormal {
    budget: u32,
}

budgeted!(ZigguratStandardNormal, 9);

/// Normal (Gaussian) with a mean and a standard deviation, by a ziggurat.
///
/// μ + σz of a standard normal z, rounded twice. A standard deviation near the spacing of `f32` at the mean (6e-8 of it)
/// is lost in that rounding.
///
/// # Density
/// e^(−(x−μ)²/2σ²)/(σ√2π), at least 2⁻¹⁴⁹ for every finite x, with the errors of [`Normal`].
///
/// # Domain
/// - Point: μ ± 10.08σ.
/// - Words a try: those of [`ZigguratStandardNormal`].
/// - Parameters: a finite mean μ and a standard deviation σ > 0.
///
/// # Accuracy
/// z has the errors of [`ZigguratStandardNormal`].
///
/// # Cost
/// Efficiency: that of [`ZigguratStandardNormal`].
///
/// # Examples
/// The constructor returns an [`Error`], a draw a [`Failure`]; a function that uses both returns
/// `Box<dyn core::error::Error>`, or maps them: see [`Failure`].
/// ```
/// use microwarp::rejection::{Rejection, ZigguratNormal};
/// use rand_pcg::Pcg32;
/// let height = ZigguratNormal::new(10.0, 2.0)?;
/// let x = height.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(height.pdf(x) > 0.0);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
///
/// # See also
/// - [`ZigguratStandardNormal`] has mean 0 and standard deviation 1.
/// - [`warp::Normal`](crate::warp::Normal) and [`warp::NormalPair`](crate::warp::NormalPair) take a fixed number of
///   uniforms and have an inverse. `NormalPair` fills a slice faster.
///
/// # Source
/// That of [`ZigguratStandardNormal`].
#[doc(alias = "gaussian")]
#[doc(alias = "normal")]
#[doc(alias = "noise")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZigguratNormal {
    law: Normal<Poly>,
    mean: f32,
    std_dev: f32,
    budget: u32,
}

impl ZigguratStandardNormal {
    /// The share of tries that is accepted, by theory.
    pub const EFFICIENCY: f32 = 0.993_321_8;

    /// The density at a number. It is 0 for NaN and infinity, and never 0 at a drawn number.
    #[must_use]
    #[inline]
    pub fn pdf(&self, x: f32) -> f32 {
        const LAW: Result<Normal<Poly>, Error> = Normal::new(0.0, 1.0);
        LAW.map_or(0.0, |law| law.pdf(x))
    }
}

impl ZigguratNormal {
    /// The share of tries that is accepted, by theory.
    pub const EFFICIENCY: f32 = ZigguratStandardNormal::EFFICIENCY;

    /// The default budget, that of [`ZigguratStandardNormal`].
    pub const BUDGET: u32 = ZigguratStandardNormal::BUDGET;

    with_budget!(const);

    /// Normal with the given mean and standard deviation, and the budget [`Self::BUDGET`].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a standard deviation of 0 or less,
    /// [`Error::TooLarge`] if a number could overflow, [`Error::Empty`] if the density could.
    pub const fn new(mean: f32, std_dev: f32) -> Result<Self, Error> {
        let law = tried!(Normal::new(mean, std_dev));
        Ok(Self {
            law,
            mean,
            std_dev,
            budget: Self::BUDGET,
        })
    }

    /// The mean.
    #[must_use]
    pub const fn mean(&self) -> f32 {
        self.mean
    }

    /// The standard deviation.
    #[must_use]
    pub const fn std_dev(&self) -> f32 {
        self.std_dev
    }

    /// The density at a number. It is 0 for NaN and infinity, and never 0 at a drawn number.
    #[must_use]
    #[inline]
    pub fn pdf(&self, x: f32) -> f32 {
        self.law.pdf(x)
    }
}

ziggurat!(ZigguratStandardNormal: Standard, |_sampler, x| x);
ziggurat!(ZigguratNormal: Standard, |normal, x| normal.mean + normal.std_dev * x);
