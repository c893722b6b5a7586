//! The log-normal distribution.

use super::location_scale::standardised;
use super::normal::{FRAC_1_SQRT_TAU, exponent};
use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, finite, positive, tried};
use crate::num::{
    SMALLEST, Scaled, clamp, folded, into_unit, power_of_two, product, quick_two_sum,
    representable, tail, two_product, two_sum,
};
use crate::tier::{
    LN_2, LOG2_E, Tier, density_of_tail, normal_quantile, normal_quantile_of_word,
    normal_quantiles_of_word, times_exp2,
};
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// Log-normal with the mean μ and the standard deviation σ of the logarithm: sizes, incomes, products of many factors.
///
/// x = e^μ·2^(σ log₂e·Φ⁻¹(u)), increasing with the uniform: never back from one uniform of the 24-bit grid to the next. e^μ is
/// known from the constructor; the power comes by a table, Φ⁻¹ as in [`Normal`](super::Normal).
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
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 4.4 + 64*d | proven |
/// | pdf, relative | 2.7e-7 + 0.056*s/max(0, 1 - w/1e6) | found |
/// | realised density, relative | 3e-7 + (3.9 + 43·d)·s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 7.9e-7 + 2e-6*d | found |
/// | inverse | 2.5e-7 + 0.11*r/max(0, 1 - w/1e6) | found |
/// | round trip | 2.3e-7 + (3.1 + 46·d)·r | found |
///
/// The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// A draw keeps the bound of a sample at the exact middle of its word. d is σ, and w is 1/σ. Little is stated of densities from
/// w = 1e6 on, where those of neighbouring `f32` differ by a factor. s and r are the relative change of the density and the
/// change of the inverse when x moves by one ulp. The part of the sample's error in proportion to σ comes from the last places of Φ⁻¹(u),
/// which is −14.2 at its lowest.
/// What is rounded to a sample below 2⁻¹²⁶ has its own density; what lies below 2⁻¹⁴⁹, the smallest number, has that of 2⁻¹⁴⁹.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost LogNormal -->90 instructions and 1,120 bytes of code on an M4F, 2,590 instructions on an M0<!-- -->.
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
    /// e^μ.
    median: Scaled,
    /// 64σ log₂e.
    step: f32,
    /// 1/(σ√2π).
    peak: f32,
    tier: PhantomData<T>,
}

/// 2⁶⁴ of the smallest numbers.
const SMALLEST_RAISED: f32 = power_of_two(-85);

impl<T: Tier> LogNormal<T> {
    /// Log-normal with this mean and this standard deviation of the logarithm.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a standard deviation of 0 or less,
    /// [`Error::TooLarge`] if a sample could overflow, [`Error::Empty`] if the density at the median could.
    pub const fn new(mean_of_log: f32, std_dev_of_log: f32) -> Result<Self, Error> {
        tried!(finite(mean_of_log, 0));
        tried!(positive(std_dev_of_log, 1));
        if mean_of_log + 6.4 * std_dev_of_log > 88.5 {
            return Err(Error::TooLarge(1));
        }
        let peak = FRAC_1_SQRT_TAU / std_dev_of_log;
        if !peak.is_finite() {
            return Err(Error::Empty(1));
        }
        let at_median = Scaled::of(peak).times_power(LOG2_E, (-mean_of_log, 0.0));
        if at_median.value().is_finite() {
            let (step, rest) = two_product(64.0 * std_dev_of_log, LOG2_E.0);
            Ok(Self {
                mean_of_log,
                std_dev_of_log,
                median: Scaled::ONE.times_power(LOG2_E, (mean_of_log, 0.0)),
                step: step + (rest + 64.0 * std_dev_of_log * LOG2_E.1),
                peak,
                tier: PhantomData,
            })
        } else {
            Err(Error::Empty(1))
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

    /// The point whose logarithm is so far from its mean, in units of (ln 2)/64.
    #[inline]
    fn at(&self, steps: f32) -> f32 {
        let x = times_exp2(self.median, steps, -0.0);
        // At least the smallest number.
        f32::from_bits(x.to_bits().max(1))
    }

    /// The same, and its density, from this distance in standard deviations and the probability beyond it on its side.
    #[inline]
    fn at_with_pdf(&self, steps: f32, z: f32, tail: f32) -> (f32, f32) {
        let x = self.at(steps);
        let (decayed, factor) = density_of_tail(tail, z);
        let density = if tail > 1.0e-30 && x > f32::MIN_POSITIVE {
            representable(self.peak * decayed / x)
        } else if times_exp2(self.median.raised(64), steps, -0.0) > SMALLEST_RAISED {
            // Of x before it lost its digits.
            let decayed = Scaled::of(decayed).times(Scaled::of(factor));
            let number = Scaled::of(self.peak).times(decayed).over(self.median);
            representable(times_exp2(number, -steps, -0.0))
        } else {
            self.pdf(x)
        };
        (x, density)
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        let [steps, z] = normal_quantiles_of_word::<T, 2>([self.step, 1.0], word);
        self.at_with_pdf(steps, z, folded(word).0)
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
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.at(self.step * normal_quantile::<T>(u.get()))
    }

    // As `try_draw` is, so that a loop which draws breaks the false dependency of the conversions.
    #[allow(clippy::inline_always, reason = "see there")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn sample_words(&self, word: u32) -> f32 {
        self.at(normal_quantile_of_word::<T>(self.step, word))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let u = u.get();
        let z = normal_quantile::<T>(u);
        self.at_with_pdf(self.step * z, z, tail(u))
    }

    drawn_with_pdf!(from of_word_with_pdf);

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
