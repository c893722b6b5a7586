//! The Weibull distribution. Both tiers share its samples and density.

use super::located::by_tails;
use super::pareto::{log2_above, reciprocal};
use super::{Invert, Warp};
use crate::error::{Error, positive};
use crate::num::{Scaled, into_unit, product, quick_two_sum, representable};
use crate::tier::{LN_2, LOG2_E, Tier, exp2_pair, log2_of_sum, times};
use core::marker::PhantomData;

/// Weibull with a scale λ and a shape κ: life times, wind speeds, the weakest of many links.
///
/// x = λ(−ln(1 − u))^(1/κ), increasing with the uniform. Both logarithms and 1/κ have nine digits, so that a small shape, whose
/// power is large, costs none of a sample's.
///
#[cfg_attr(doc, doc = include_str!("../pictures/weibull.html"))]
///
/// # Density
/// (κ/λ)(x/λ)^(κ−1) e^(−(x/λ)^κ) for x ≥ 0, else 0. With κ < 1 it is infinite at 0, and the largest `f32` stands for it.
///
/// # Domain
/// - Point: drawn samples lie from (1.16e-10)^(1/κ)·λ to 22.9^(1/κ)·λ. Uniforms on the 24-bit grid reach 16.6^(1/κ)·λ; u = 0
///   counts as 2⁻¹⁴⁹. Samples below 2⁻¹⁵⁰ are 0, as many are for κ below 0.1.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a scale and a shape above 0 for which neither samples nor the density at the scale overflow. A scale of 1
///   takes shapes from 0.036.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, ulp | 1 | 1 |
/// | pdf, relative | 2.2e-6 | 2.2e-6 |
/// | realised density, relative | 4e-7 + s/max(0, 1 - k/1e6) | 4e-7 + s/max(0, 1 - k/1e6) |
/// | inverse | 7.2e-8 | 7.2e-8 |
/// | round trip | 1e-7 + 1.1*r | 1e-7 + 1.1*r |
///
/// k is κ. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by a factor. s and r
/// are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// <!-- generated: cost Weibull -->
/// Instructions of a draw, PCG32 included, and bytes of flash:
/// - `poly`: 353 on a Cortex-M4F (2,540 bytes), 19,796 on a Cortex-M0, 640 as WASM.
/// - `libm`: 353 on a Cortex-M4F (2,540 bytes), 19,796 on a Cortex-M0, 640 as WASM.
/// <!-- end -->
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let life = mw::Weibull::new(1000.0, 1.5)?; // hours, wearing out
/// assert!((life.invert(1000.0) - 0.632_120_6).abs() < 1e-6);
/// assert!((life.sample(0.5) - 783.219_2).abs() < 1e-3); // the median
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Exponential`](super::Exponential): shape 1, at a lower cost.
/// - [`Rayleigh`](super::Rayleigh): shape 2, at a lower cost.
/// - [`Gumbel`](super::Gumbel): the logarithm of this law, negated.
///
/// # Source
/// W. Weibull, "A Statistical Distribution Function of Wide Applicability", 1951, <https://doi.org/10.1115/1.4010337>. The
/// compensated form is this crate's own.
#[doc(alias = "reliability")]
#[doc(alias = "life_time")]
#[doc(alias = "wind_speed")]
#[doc(alias = "stretched_exponential")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Weibull<T> {
    scale: f32,
    shape: f32,
    /// 1/κ and its rounding error.
    root: (f32, f32),
    tier: PhantomData<T>,
}

impl<T: Tier> Weibull<T> {
    /// Weibull with this scale and this shape.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::TooLarge`] if a sample
    /// could overflow, [`Error::Empty`] if the density at the scale could.
    pub const fn new(scale: f32, shape: f32) -> Result<Self, Error> {
        let root = match (positive(scale), positive(shape)) {
            (Ok(_), Ok(_)) => reciprocal(shape),
            (Err(e), _) | (_, Err(e)) => return Err(e),
        };
        // log₂ of 22.88, beyond what the deepest word gives.
        let last = Scaled::of(scale).times_power((4.516, 0.0), root);
        if !last.value().is_finite() {
            Err(Error::TooLarge)
        } else if !(shape / scale).is_finite() {
            Err(Error::Empty)
        } else {
            Ok(Self {
                scale,
                shape,
                root,
                tier: PhantomData,
            })
        }
    }

    /// The scale.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    /// The shape.
    #[must_use]
    pub const fn shape(&self) -> f32 {
        self.shape
    }

    #[inline]
    fn beyond(&self, tail: f32, upper: bool) -> f32 {
        // log₂ of -ln(1 - u).
        let log = if !upper && tail < 1.0e-6 {
            // -ln(1 - u) = u(1 + u/2 + ...), without a subnormal number.
            let (log, rest) = Scaled::of(tail).log2();
            (log, rest + 0.5 * core::f32::consts::LOG2_E * tail)
        } else {
            let (log, rest) = log2_above(tail, upper);
            let (log, rest) = product(quick_two_sum(-log, -rest), LN_2);
            log2_of_sum(log, rest, 0.0)
        };
        Scaled::of(self.scale).times_power(log, self.root).value()
    }

    /// log₂ of x/λ, for an x above 0.
    #[inline]
    fn log2_of_ratio(&self, x: f32) -> (f32, f32) {
        Scaled::of(x).log2_over(Scaled::of(self.scale))
    }
}

impl<T: Tier> Warp for Weibull<T> {
    by_tails!();

    #[inline]
    #[expect(
        clippy::float_cmp,
        reason = "the exponential law alone has a density at 0"
    )]
    fn pdf(&self, x: f32) -> f32 {
        if !(0.0..=f32::MAX).contains(&x) {
            return 0.0;
        }
        if x == 0.0 {
            return representable(if self.shape < 1.0 {
                f32::MAX
            } else if self.shape == 1.0 {
                1.0 / self.scale
            } else {
                0.0
            });
        }
        // κ z e^(-z)/x with z = (x/λ)^κ.
        let log = self.log2_of_ratio(x);
        let whole = self.shape * (log.0 + log.1);
        let z = if whole > 8.0 {
            return representable(0.0);
        } else if whole > -40.0 {
            let (exact, small) = times(log, self.shape);
            exp2_pair(exact, small)
        } else {
            (0.0, 0.0)
        };
        let start = Scaled::of(self.shape).over(Scaled::of(x));
        let rising = start.times_power(log, (self.shape, 0.0));
        representable(rising.times_power(LOG2_E, (-z.0, -z.1)).value())
    }
}

impl<T: Tier> Invert for Weibull<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        if x > 0.0 {
            let log = self.log2_of_ratio(if x < f32::MAX { x } else { f32::MAX });
            let z = Scaled::ONE.times_power(log, (self.shape, 0.0)).value();
            into_unit(-T::exp_m1(-z))
        } else {
            0.0
        }
    }
}
