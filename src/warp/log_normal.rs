//! The log-normal distribution.

use super::located::{by_tails, standardised};
use super::normal::{FRAC_1_SQRT_TAU, exponent};
use super::{Invert, Warp};
use crate::error::{Error, finite, positive};
use crate::num::{
    SMALLEST, Scaled, clamp, into_unit, product, quick_two_sum, representable, two_product, two_sum,
};
use crate::tier::{LN_2, LOG2_E, Tier};
use core::marker::PhantomData;

/// Log-normal with the mean μ and the standard deviation σ of the logarithm: sizes, incomes, products of many factors.
///
/// x = e^(μ + σΦ⁻¹(u)), increasing with the uniform. The rounding errors of the exponent go into the result.
///
#[cfg_attr(doc, doc = include_str!("../pictures/log_normal.html"))]
///
/// # Density
/// e^(−(ln x − μ)²/2σ²)/(xσ√2π) for x > 0, else 0.
///
/// # Domain
/// - Point: drawn samples lie from e^(μ−6.34σ) to e^(μ+6.34σ). Uniforms on the 24-bit grid give e^(μ−5.30σ) to e^(μ+5.30σ),
///   except u = 0: it counts as 2⁻¹⁴⁹ and gives e^(μ−14.2σ). Samples below 2⁻¹⁴⁹ are 2⁻¹⁴⁹.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a finite μ and a σ above 0 for which no sample overflows (μ + 6.4σ up to 88.5), nor the density at the
///   median (μ above −88 for common σ).
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, ulp | 2.1 + 33*d | 2.1 + 33*d |
/// | pdf, relative | 2.3e-7 + 0.05*s/max(0, 1 - w/1e6) | 2.3e-7 + 0.05*s/max(0, 1 - w/1e6) |
/// | realised density, relative | 3e-7 + (2 + 30·d)·s/max(0, 1 - w/1e6) | 3e-7 + (2 + 30·d)·s/max(0, 1 - w/1e6) |
/// | inverse | 1.8e-7 + 0.1*r/max(0, 1 - w/1e6) | 1.8e-7 + 0.1*r/max(0, 1 - w/1e6) |
/// | round trip | 2e-7 + (2 + 30·d)·r | 2e-7 + (2 + 30·d)·r |
///
/// d is σ, and w is 1/σ. Little is stated of densities from w = 1e6 on, where those of neighbouring `f32` differ by a factor. s
/// and r are the relative change of the density and the change of the inverse when x moves by one ulp. The 33 ulp of the sample
/// for each unit of σ come from the last place of Φ⁻¹(u).
///
/// # Cost
/// <!-- generated: cost LogNormal -->
/// Instructions of a draw, PCG32 included, and bytes of flash:
/// - `poly`: 137 on a Cortex-M4F (1,412 bytes), 6,570 on a Cortex-M0, 229 as WASM.
/// - `libm`: 146 on a Cortex-M4F (1,240 bytes), 6,301 on a Cortex-M0, 259 as WASM.
/// <!-- end -->
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let size = mw::LogNormal::new(0.0, 0.5)?;
/// assert_eq!(size.sample(0.5), 1.0);
/// assert!((size.sample(0.841_344_8) - 1.648_721).abs() < 1e-5); // e^σ
/// assert!((size.pdf(1.0) - 0.797_884_6).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Normal`](super::Normal): the logarithm.
/// - [`Pareto`](super::Pareto): a heavier tail.
/// - [`Weibull`](super::Weibull): life times by a shape.
///
/// # Source
/// J. Aitchison and J. A. C. Brown, "The Lognormal Distribution", 1957.
#[doc(alias = "lognormal")]
#[doc(alias = "galton")]
#[doc(alias = "geometric_noise")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LogNormal<T> {
    mean_of_log: f32,
    std_dev_of_log: f32,
    /// 1/(σ√2π).
    peak: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> LogNormal<T> {
    /// Log-normal with this mean and this standard deviation of the logarithm.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a standard deviation of 0 or less,
    /// [`Error::TooLarge`] if a sample could overflow, [`Error::Empty`] if the density at the median could.
    pub const fn new(mean_of_log: f32, std_dev_of_log: f32) -> Result<Self, Error> {
        match (finite(mean_of_log), positive(std_dev_of_log)) {
            (Ok(_), Ok(_)) => {}
            (Err(e), _) | (_, Err(e)) => return Err(e),
        }
        if mean_of_log + 6.4 * std_dev_of_log > 88.5 {
            return Err(Error::TooLarge);
        }
        let peak = FRAC_1_SQRT_TAU / std_dev_of_log;
        if !peak.is_finite() {
            return Err(Error::Empty);
        }
        let at_median = Scaled::of(peak).times_power(LOG2_E, (-mean_of_log, 0.0));
        if at_median.value().is_finite() {
            Ok(Self {
                mean_of_log,
                std_dev_of_log,
                peak,
                tier: PhantomData,
            })
        } else {
            Err(Error::Empty)
        }
    }

    /// The mean of the logarithm.
    #[must_use]
    pub const fn mean_of_log(&self) -> f32 {
        self.mean_of_log
    }

    /// The standard deviation of the logarithm.
    #[must_use]
    pub const fn std_dev_of_log(&self) -> f32 {
        self.std_dev_of_log
    }

    #[inline]
    fn beyond(&self, tail: f32, upper: bool) -> f32 {
        let quantile = T::normal_quantile_lower(tail);
        let (along, dropped) = two_product(
            self.std_dev_of_log,
            if upper { -quantile } else { quantile },
        );
        let (exponent, rest) = two_sum(self.mean_of_log, along);
        let x = T::exp(exponent);
        clamp(x + x * (rest + dropped), SMALLEST, f32::MAX)
    }

    /// The distance of ln x from its mean in standard deviations, and its rounding error; for an x above 0.
    #[inline]
    fn standardised(&self, x: f32) -> (f32, f32) {
        let (log, rest) = Scaled::of(x).log2();
        let (log, rest) = product(quick_two_sum(log, rest), LN_2);
        let (distance, dropped) = two_sum(log, -self.mean_of_log);
        // Again, since the rest may be as large as the distance.
        let (distance, rest) = two_sum(distance, dropped + rest);
        let (t, dropped) = standardised(distance, 0.0, self.std_dev_of_log);
        (t, dropped + rest / self.std_dev_of_log)
    }
}

impl<T: Tier> Warp for LogNormal<T> {
    by_tails!();

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if (SMALLEST..=f32::MAX).contains(&x) {
            let peak = Scaled::of(self.peak).over(Scaled::of(x));
            let exponent = exponent(self.standardised(x));
            representable(peak.times_power(LOG2_E, exponent).value())
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for LogNormal<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let (t, rest) = self.standardised(clamp(x, SMALLEST, f32::MAX));
        let t = t + rest;
        into_unit(if t > 0.0 {
            1.0 - T::normal_cdf_lower(-t)
        } else {
            T::normal_cdf_lower(t)
        })
    }
}
