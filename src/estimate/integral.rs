//! An integral from samples of a density, with its error.

use super::Moments;
use crate::error::{Error, finite};
use crate::num::saturated;
use crate::tier::{Tier, sqrt};

/// The Monte Carlo estimate of an integral, with its error: the mean of f(X)/p(X) over samples X of density p.
///
/// It is unbiased if p is positive wherever f is not 0. Its variance is V/N, where V is the variance of f(X)/p(X): the
/// closer p is to a multiple of f, the smaller.
///
/// # Domain
///
/// - A sample is accepted if f is finite, p is positive and finite, and f/p is finite. f = 0 is accepted and adds 0.
/// - Any other sample is refused, and the estimate is the mean of the accepted ones. It is biased if the refused ones
///   matter, so look at [`Integral::refused`]. Where p = 0 means "adds nothing", push f = 0 with density 1.
/// - The estimate is [`None`] without samples, and the standard error with fewer than two. No result is infinite.
/// - Both bounds use the variance of the samples so far. If f/p has a heavy tail that few samples have met, that
///   variance and the bounds are too small.
///
/// # Accuracy
///
/// Each quotient is rounded; the sums have the errors of [`Moments`].
///
/// # Examples
///
/// ```
/// use microwarp::{Warp, estimate::Integral, poly as mw};
/// use rand_pcg::Pcg32;
///
/// // e^x over [0, 1], from samples of a density of similar slope.
/// let warp = mw::Linear::new(1.0, 2.0)?;
/// let mut rng = Pcg32::new(42, 54);
/// let mut integral = Integral::new();
/// for _ in 0..10_000 {
///     let x = warp.draw(&mut rng);
///     integral.push(x.exp(), warp.pdf(x));
/// }
/// let estimate = integral.estimate().unwrap_or(0.0);
/// let error = (estimate - 1.718_281_8).abs();
/// assert!(error < integral.normal_bound::<microwarp::tier::Poly>(0.99)?);
/// assert!(error < integral.chebyshev_bound(0.01)?);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`WeightedMean`](super::WeightedMean), if p is known only up to a factor.
/// - [`balance_heuristic`](super::balance_heuristic()), to combine two densities.
///
/// # Source
///
/// W. G. Cochran, "Sampling Techniques", 3rd edition, 1977; P. L. Chebyshev, "Des valeurs moyennes", 1867, for his bound.
#[doc(alias = "confidence_interval")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Integral {
    moments: Moments,
}

/// Accepts a probability strictly between 0 and 1.
const fn probability(x: f32) -> Result<f32, Error> {
    match finite(x, 0) {
        Ok(x) if x > 0.0 && x < 1.0 => Ok(x),
        Ok(_) => Err(Error::OutOfRange(0)),
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

    /// Takes in one sample: the integrand at the point, and the density that the point was sampled with.
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

    /// The mean and variance of the quotients f(X)/p(X).
    #[must_use]
    #[inline]
    pub const fn moments(&self) -> &Moments {
        &self.moments
    }

    /// The estimate of the integral, or [`None`] without samples.
    #[must_use]
    #[inline]
    pub fn estimate(&self) -> Option<f32> {
        self.moments.mean()
    }

    /// The standard error of the estimate, √(V/N), or [`None`] for fewer than two samples.
    #[must_use]
    #[inline]
    pub fn standard_error(&self) -> Option<f32> {
        self.moments.standard_error()
    }

    /// A bound on the error of the estimate that holds with probability at least 1 − `delta`, by Chebyshev's inequality:
    /// √(V/(N·delta)).
    ///
    /// It holds for any distribution of finite variance V, so it is wide. For fewer than two samples, which say nothing about
    /// V, it is the largest `f32`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for a `delta` not strictly between 0 and 1.
    #[inline]
    pub fn chebyshev_bound(&self, delta: f32) -> Result<f32, Error> {
        let delta = probability(delta)?;
        Ok(self.bound(|error| error / sqrt(delta)))
    }

    /// A bound on the error of the estimate that holds with probability `confidence` in the normal approximation: the standard
    /// error times Φ⁻¹((1 + `confidence`)/2).
    ///
    /// It holds for large N, by the central limit theorem. For fewer than two samples it is the largest `f32`. The confidence
    /// is resolved to 2⁻²⁴: 10⁻⁴ has three digits, and anything below 3·10⁻⁸ counts as 0.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for a `confidence` not strictly between 0 and 1.
    #[inline]
    pub fn normal_bound<T: Tier>(&self, confidence: f32) -> Result<f32, Error> {
        let tail = 0.5 * (1.0 - probability(confidence)?);
        let std_devs = -T::normal_quantile_lower(tail);
        // A confidence that rounds to 0 would give −0.
        let std_devs = if std_devs > 0.0 { std_devs } else { 0.0 };
        Ok(self.bound(|error| std_devs * error))
    }

    #[inline]
    fn bound(&self, of_error: impl Fn(f32) -> f32) -> f32 {
        self.standard_error()
            .map_or(f32::MAX, |error| saturated(of_error(error)))
    }
}
