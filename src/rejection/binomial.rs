//! The binomial distribution of large variance, by transformed rejection.

use super::stirling::{PEAK, TAILS, deviance, excess};
use super::{Failure, Rejection, with_budget};
use crate::error::{Error, finite};
use crate::num::{happens, power_of_two};
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
    /// The mean number of the rarer event, cut to an integer, and what is left; the mean of the other event.
    whole: u32,
    rest: f32,
    mean: f32,
    other: f32,
    /// The slope of the map that proposes: in the tails, and at the centre.
    tail: f32,
    slope: f32,
    /// The bits behind the point of a proposal, and its centre in such steps; both slopes in steps of 32.
    places: u32,
    tail_steps: u64,
    slope_steps: u64,
    centre: i64,
    /// The density of proposals at a slope of 1, over its bound.
    scale: f32,
    /// By how much ln n! is above Stirling's formula.
    excess: f32,
    /// A second word below this accepts whatever does not lie in the tails.
    squeeze: u32,
    budget: u32,
    tier: PhantomData<T>,
}

/// How many places a proposal has beyond those of the slopes.
const FINER: u32 = 5;

/// The end of a word, in units of 2⁻³³, from which it proposes counts that are accepted.
const OUT: u64 = 1 << 10;

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
        if !(0.0..=1.0).contains(&finite(p)?) {
            return Err(Error::OutOfRange);
        }
        let turned = p > 0.5;
        // Exact, from 1/2 up.
        let rare = if turned { 1.0 - p } else { p };
        let n = trials as f32;
        let variance = n * rare * (1.0 - rare);
        if variance < 10.0 {
            return Err(Error::OutOfRange);
        }
        // The variance is at least 10, so that p is at least 2^-29 and its digits lie above 2^-52.
        let digits = (rare * power_of_two(52)) as u64;
        let mean = u128::from(digits).wrapping_mul(trials.into());
        let (whole, part) = ((mean >> 52) as u32, (mean as u64) << 12);
        let rest = part as f32 * power_of_two(-64);
        // The hat covers all n and p: the nearest it comes is a factor of 1.0009. A small p is the hardest.
        let slope = 0.966 + 2.5325 * sqrt(variance);
        let accepted = 0.9255 - 3.8 / (slope - 1.6);
        let tail = 0.0247 * slope - 0.056;
        // The slope is below 2^18, and has 31 bits in such steps; the tail has 26 and all its digits.
        let places = 157_u32.wrapping_sub(slope.to_bits() >> 23);
        let steps = 1_u64.wrapping_shl(places) as f32;
        Ok(Self {
            trials,
            success: p,
            turned,
            whole,
            rest,
            mean: whole as f32 + rest,
            other: n * (1.0 - rare),
            tail,
            slope,
            places: places.wrapping_add(FINER),
            tail_steps: (tail * steps) as u64,
            slope_steps: (slope * steps) as u64,
            centre: ((rest + 0.45 + 0.1 * rare) * steps * (1_u32 << FINER) as f32) as i64,
            scale: 1.0 / (1.1266 + 1.16 / (slope - 2.4)),
            excess: excess(trials),
            squeeze: (accepted * 4_294_967_296.0) as u32,
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
        let [place, decision] = words;
        let upper = place >> 31 == 1;
        let rank = if upper { !place } else { place };
        // The end of the words lies at 0, the middle at 2³², and each word between two.
        let end = u64::from(rank << 1 | 1);
        // So far out no decision accepts, and numbers might not fit.
        if end < OUT {
            return None;
        }
        let from_middle = (1_u64 << 32).wrapping_sub(end);
        let straight = self.slope_steps.wrapping_mul(from_middle) >> 33_u32.wrapping_sub(FINER);
        let bent = (self.tail_steps << 33_u32.wrapping_add(FINER)).checked_div(end)?;
        let away = straight
            .wrapping_add(bent)
            .wrapping_sub(self.tail_steps << 1_u32.wrapping_add(FINER));
        let x = if upper == self.turned {
            self.centre.wrapping_sub_unsigned(away)
        } else {
            self.centre.wrapping_add_unsigned(away)
        };
        let count = i64::from(self.whole).wrapping_add(x.wrapping_shr(self.places));
        let count = u32::try_from(count)
            .ok()
            .filter(|&count| count <= self.trials)?;
        let end = end as f32 * power_of_two(-33);
        if end >= TAILS && decision < self.squeeze {
            return Some(self.turn(count));
        }
        let slope = self.tail / (end * end) + self.slope;
        happens(self.pmf_of_rare(count) * slope * self.scale, decision).then_some(self.turn(count))
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
        let away = i64::from(count).wrapping_sub(i64::from(self.whole)) as f32 - self.rest;
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
