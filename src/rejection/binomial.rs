//! The binomial distribution of large variance, by transformed rejection.

use super::stirling::{PEAK, deviance, excess};
use super::transformed::Hat;
use super::{Failure, Rejection, with_budget};
use crate::error::{Error, finite};
use crate::num::power_of_two;
use crate::tier::{Tier, sqrt};
use core::marker::PhantomData;
use rand_core::TryRng;

/// The number of successes in n independent trials, of a variance np(1 − p) from 10 up, by transformed rejection: a
/// population that survives, votes, cells of a large histogram.
///
/// The time of a draw hardly depends on n and p.
///
/// # Density
/// n!/(k!(n − k)!) pᵏ(1 − p)ⁿ⁻ᵏ for the count k.
///
/// # Domain
/// - Point: a `u32` from 0 to n.
/// - Words a try: two. The first proposes a count by integers alone, and counts increase with it; the second decides.
/// - Parameters: any n, and p between 0 and 1, where np(1 − p) is at least 10.
///
/// # Accuracy
/// A count k is drawn with its probability to a
/// relative error of 5e-6 + 1e-9 s + 1.3e-8 |k − np|, for |k − np| up to 4.5 s, where s² is the variance. Beyond that,
/// decisions by 32 bits show: the probability is right to 2⁻³³ of that with which k is proposed.
///
/// The pmf has
/// a relative error of 5e-7 (1 + L), where L is −ln of it, or an absolute one of 2⁻¹⁴⁸.
///
/// Both bounds are found, not proven: by exact counts for thousands of n and p, with a margin of 1.3.
///
/// # Cost
/// Efficiency: 0.77 for a variance of 10, 0.85 for 100, 0.89 for 65536.
///
/// The default budget of 32 tries is spent with a probability below 2⁻⁶⁴.
///
/// # Examples
/// ```
/// use microwarp::poly as mw;
/// use microwarp::rejection::Rejection;
/// use rand_pcg::Pcg32;
/// let heads = mw::BinomialRejection::new(1_000_000, 0.5)?; // of a million coins
/// let count = heads.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(count.abs_diff(500_000) < 4000);
/// assert!(heads.pmf(count) > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # See also
/// - [`discrete::Binomial`](crate::discrete::Binomial): variances up to 100 from one word, without rejection.
/// - [`HypergeometricRejection`](super::HypergeometricRejection): a sample without replacement.
/// - [`PoissonRejection`](super::PoissonRejection): events that have no largest number.
///
/// # Source
/// W. Hörmann, "The Generation of Binomial Random Variates", 1993, <https://doi.org/10.1080/00949659308811496>, with
/// constants of a closer hat. The pmf as C. Loader, "Fast and Accurate Computation
/// of Binomial Probabilities", 2000.
#[doc(alias = "btrs")]
#[doc(alias = "trials")]
#[doc(alias = "successes")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BinomialRejection<T> {
    trials: u32,
    success: f32,
    /// Whether failures are counted, the rarer event.
    turned: bool,
    hat: Hat,
    /// The mean number of the rarer event, and its part behind the point; the mean of the other event.
    mean: f32,
    rest: f32,
    other: f32,
    /// By how much ln n! is above Stirling's formula.
    excess: f32,
    budget: u32,
    tier: PhantomData<T>,
}

impl<T: Tier> BinomialRejection<T> {
    /// The default budget. A true random generator spends it with a probability below 2⁻⁶⁴.
    pub const BUDGET: u32 = 32;

    with_budget!(const);

    /// So many trials that succeed with a probability between 0 and 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for p outside [0, 1] and for a variance np(1 − p)
    /// below 10.
    pub fn new(trials: u32, p: f32) -> Result<Self, Error> {
        if !(0.0..=1.0).contains(&finite(p, 1)?) {
            return Err(Error::OutOfRange(1));
        }
        let turned = p > 0.5;
        // Exact, from 1/2 up.
        let rare = if turned { 1.0 - p } else { p };
        let n = trials as f32;
        let variance = n * rare * (1.0 - rare);
        if variance < 10.0 {
            return Err(Error::OutOfRange(1));
        }
        // The variance is at least 10, so that p is at least 2^-29 and its digits lie above 2^-52.
        let digits = (rare * power_of_two(52)) as u64;
        let mean = u128::from(digits).wrapping_mul(trials.into());
        let (whole, part) = ((mean >> 52) as u32, (mean as u64) << 12);
        let rest = part as f32 * power_of_two(-64);
        Ok(Self {
            trials,
            success: p,
            turned,
            hat: Hat::new(variance, whole, rest + 0.45 + 0.1 * rare),
            mean: whole as f32 + rest,
            rest,
            other: n * (1.0 - rare),
            excess: excess(trials),
            budget: Self::BUDGET,
            tier: PhantomData,
        })
    }

    /// The number of trials.
    #[must_use]
    pub const fn trials(&self) -> u32 {
        self.trials
    }

    /// The probability that a trial succeeds.
    #[must_use]
    pub const fn success(&self) -> f32 {
        self.success
    }

    /// The count of successes from that of the rarer event, and the other way round.
    #[inline]
    const fn turn(&self, count: u32) -> u32 {
        if self.turned {
            self.trials.wrapping_sub(count)
        } else {
            count
        }
    }

    /// One try with two given words, of which the first proposes a count and the second decides: a smaller one accepts
    /// more. `None` if the count is rejected.
    #[must_use]
    #[inline]
    pub fn attempt(&self, words: [u32; 2]) -> Option<u32> {
        let range = 0..=self.trials;
        let pmf = |count| self.pmf_of_rare(count);
        let count = self.hat.attempt(words, self.turned, range, pmf)?;
        Some(self.turn(count))
    }

    /// The probability of a count; 0 only above n and below the smallest `f32`.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        if count > self.trials {
            return 0.0;
        }
        self.pmf_of_rare(self.turn(count))
    }

    /// The probability of a count of the rarer event, up to n.
    fn pmf_of_rare(&self, count: u32) -> f32 {
        let left = self.trials.wrapping_sub(count);
        let away = self.hat.away(count, self.rest);
        // Without a success or a failure, its deviance is its mean, and Stirling's formula is not needed.
        let (first, second) = match (count, left) {
            (0, _) => (self.mean, deviance::<T>(left as f32, self.other, -away)),
            (_, 0) => (deviance::<T>(count as f32, self.mean, away), self.other),
            _ => {
                let both = deviance::<T>(count as f32, self.mean, away)
                    + deviance::<T>(left as f32, self.other, -away);
                let more = excess(count) + excess(left) - self.excess;
                let spread = 1.0 / count as f32 + 1.0 / left as f32;
                return T::exp(-(both + more)) * PEAK * sqrt(spread);
            }
        };
        T::exp(-(first + second))
    }
}

impl<T: Tier> Rejection for BinomialRejection<T> {
    type Point = u32;

    #[inline]
    fn budget(&self) -> u32 {
        self.budget
    }

    #[inline]
    fn try_once<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Option<u32>, Failure<R::Error>> {
        let place = rng.try_next_u32().map_err(Failure::Generator)?;
        let decision = rng.try_next_u32().map_err(Failure::Generator)?;
        Ok(self.attempt([place, decision]))
    }
}
