//! An integral from samples of a density, with its error.

use super::Moments;
use crate::error::{Error, finite};
use crate::num::saturated;
use crate::tier::{Tier, sqrt};

/// The estimate of an integral: the mean of f(X)/p(X) over samples X of density p, with its error.
///
/// It is unbiased for every density that is positive wherever f is not 0, and its variance is V/N, V being
/// that of f(X)/p(X): the nearer p comes to a multiple of f, the smaller.
///
/// - Domain: finite f and densities p > 0 whose quotient is finite. A sample of another kind is refused, and
///   counted in [`Integral::refused`]: p = 0 is a point that was never sampled, and f/p beyond `f32` no
///   number to add. The estimate is then of what was accepted; whether that says anything, the caller knows.
///   f = 0 is a sample like any other, and adds 0.
/// - Range: the integral of no samples and the error from fewer than two are [`None`]; no result is infinite.
/// - Errors: each quotient is rounded, and from there those of [`Moments`].
///
/// Both bounds stand on the *estimated* variance. Where f/p has a heavy tail that few samples have met, it is
/// too small, and so are the bounds.
///
/// Source: W. G. Cochran, "Sampling Techniques", 3rd edition, 1977; P. L. Chebyshev, "Des valeurs
/// moyennes", 1867, for the bound of his name.
///
/// ```
/// use microwarp::{Warp, estimate::Integral, poly as mw};
/// use rand_pcg::Pcg32;
///
/// // e^x over [0, 1], from samples of a density that rises alike.
/// let warp = mw::Linear::new(1.0, 2.0)?;
/// let mut rng = Pcg32::new(42, 54);
/// let mut integral = Integral::new();
/// for _ in 0..10_000 {
///     let x = warp.draw(&mut rng);
///     integral.push(x.exp(), warp.pdf(x));
/// }
/// let estimate = integral.estimate().unwrap_or(0.0);
/// let error = (estimate - 1.718_281_8).abs();
/// assert!(error < integral.normal_bound::<mw::Tier>(0.99)?);
/// assert!(error < integral.chebyshev_bound(0.01)?);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Integral {
    moments: Moments,
}

/// Refuses what is no probability strictly between 0 and 1.
const fn probability(x: f32) -> Result<f32, Error> {
    match finite(x) {
        Ok(x) if x > 0.0 && x < 1.0 => Ok(x),
        Ok(_) => Err(Error::OutOfRange),
        Err(e) => Err(e),
    }
}

impl Integral {
    /// No samples yet.
    #[must_use]
    #[inline]
    pub const fn new() -> Self {
        Self {
            moments: Moments::new(),
        }
    }

    /// Takes in one sample: the integrand there, and the density it was sampled with.
    #[inline]
    pub fn push(&mut self, f: f32, pdf: f32) {
        let sampled = pdf > 0.0 && pdf <= f32::MAX;
        self.moments.push(if sampled { f / pdf } else { f32::NAN });
    }

    /// Takes in all samples of another estimate of the same integral.
    pub fn merge(&mut self, other: &Self) {
        self.moments.merge(&other.moments);
    }

    /// How many samples were taken in.
    #[must_use]
    #[inline]
    pub const fn count(&self) -> u64 {
        self.moments.count()
    }

    /// How many samples were refused.
    #[must_use]
    #[inline]
    pub const fn refused(&self) -> u64 {
        self.moments.refused()
    }

    /// Mean and variance of the samples' quotients f(X)/p(X).
    #[must_use]
    #[inline]
    pub const fn moments(&self) -> &Moments {
        &self.moments
    }

    /// The estimate of the integral; [`None`] without samples.
    #[must_use]
    #[inline]
    pub fn estimate(&self) -> Option<f32> {
        self.moments.mean()
    }

    /// The standard error of the estimate, √(V/N); [`None`] below two samples.
    #[must_use]
    #[inline]
    pub fn standard_error(&self) -> Option<f32> {
        self.moments.standard_error()
    }

    /// How far the estimate is off at most, with probability at least 1 − `delta`, by Chebyshev's
    /// inequality: √(V/(N·delta)).
    ///
    /// It holds for any distribution of finite variance V, hence is wide. Below two samples, which say
    /// nothing of V, it is the largest `f32`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for a `delta` not strictly between
    /// 0 and 1.
    #[inline]
    pub fn chebyshev_bound(&self, delta: f32) -> Result<f32, Error> {
        let delta = probability(delta)?;
        Ok(self.bound(|error| error / sqrt(delta)))
    }

    /// How far the estimate is off at most, with about the probability `confidence`, in the normal
    /// approximation: its standard error times Φ⁻¹((1 + `confidence`)/2).
    ///
    /// It holds for large N, by the central limit theorem. Below two samples it is the largest `f32`. A
    /// confidence counts to 2⁻²⁴, so that one of 10⁻⁴ has three digits and one below 3·10⁻⁸ is 0.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for a `confidence` not strictly
    /// between 0 and 1.
    #[inline]
    pub fn normal_bound<T: Tier>(&self, confidence: f32) -> Result<f32, Error> {
        let tail = 0.5 * (1.0 - probability(confidence)?);
        let deviations = -T::normal_quantile_lower(tail);
        // A confidence that rounding has made 0 leaves the sign of 0 behind.
        let deviations = if deviations > 0.0 { deviations } else { 0.0 };
        Ok(self.bound(|error| deviations * error))
    }

    #[inline]
    fn bound(&self, of_error: impl Fn(f32) -> f32) -> f32 {
        self.standard_error()
            .map_or(f32::MAX, |error| saturated(of_error(error)))
    }
}
