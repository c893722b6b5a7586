//! The hypergeometric distribution of large variance, by transformed rejection.

use super::stirling::{PEAK, deviance, excess};
use super::transformed::Hat;
use super::{Failure, Rejection, with_budget};
use crate::error::Error;
use crate::tier::{Tier, sqrt};
use core::marker::PhantomData;
use rand_core::TryRng;

/// The number of marked items among n that are drawn from N without replacement, of which K are marked, of a variance from 10 up,
/// by transformed rejection: votes of a sample, a census by recapture, a shuffled pool that is split.
///
/// The time of a draw hardly depends on the three numbers.
///
/// # Density
/// C(K, k) C(N − K, n − k)/C(N, n) for the count k, with binomial coefficients C.
///
/// # Domain
/// - Point: a `u32` from n + K − N, or 0, to the smaller of n and K.
/// - Words a try: two. The first proposes a count by integers alone, and counts increase with it; the second decides.
/// - Parameters: any N, and K and n up to N, where the variance nK(N − K)(N − n)/(N²(N − 1)) is at least 10.
///
/// # Accuracy
/// A count k is drawn with its probability to a
/// relative error of 6e-6 + 1.2e-9 s + 1.5e-8 |k − nK/N|, for |k − nK/N| up to 4.5 s, where s² is the variance. Beyond that,
/// decisions by 32 bits show: the probability is right to 2⁻³³ of that with which k is proposed.
///
/// The pmf has
/// a relative error of 6e-7 (1 + L), where L is −ln of it, or an absolute one of 2⁻¹⁴⁸.
///
/// Both bounds are found, not proven: by exact counts for thousands of urns, with a margin of 1.3.
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
/// // Of a million voters 48 % say yes; 2,000 are asked.
/// let poll = mw::HypergeometricRejection::new(1_000_000, 480_000, 2_000)?;
/// let yes = poll.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(yes.abs_diff(960) < 200);
/// assert!(poll.pmf(yes) > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # See also
/// - [`discrete::Hypergeometric`](crate::discrete::Hypergeometric): variances up to 100 from one word, without rejection.
/// - [`BinomialRejection`](super::BinomialRejection): with replacement.
///
/// # Source
/// W. Hörmann, "The Generation of Binomial Random Variates", 1993, <https://doi.org/10.1080/00949659308811496>, with
/// constants of a closer hat, which covers sums of unlike trials as well. The pmf in the manner of C. Loader, "Fast and Accurate
/// Computation of Binomial Probabilities", 2000.
#[doc(alias = "urn")]
#[doc(alias = "without_replacement")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HypergeometricRejection<T> {
    population: u32,
    marked: u32,
    drawn: u32,
    hat: Hat,
    /// The part of the mean behind the point.
    rest: f32,
    /// The mean numbers of the marked and of the others, among those drawn and among those left.
    means: [f32; 4],
    /// The factor of the pmf before the exponential, without the counts; what Stirling's formula leaves out of the rest.
    root: f32,
    excess: f32,
    budget: u32,
    tier: PhantomData<T>,
}

/// A count that is 0 enters the root of the pmf as 1/2π.
const NOBODY: f32 = 0.159_154_94;

impl<T: Tier> HypergeometricRejection<T> {
    /// The default budget. A true random generator spends it with a probability below 2⁻⁶⁴.
    pub const BUDGET: u32 = 32;

    with_budget!(const);

    /// Of a `population`, so many are `marked` and so many are `drawn`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for more marked or drawn than there are, and for a variance below 10.
    pub fn new(population: u32, marked: u32, drawn: u32) -> Result<Self, Error> {
        let (Some(others), Some(left)) = (
            population.checked_sub(marked),
            population.checked_sub(drawn),
        ) else {
            return Err(Error::OutOfRange(if marked > population { 1 } else { 2 }));
        };
        let all = population as f32;
        let mean = |a: u32, b: u32| u64::from(a).wrapping_mul(b.into()) as f32 / all;
        let means = [
            mean(marked, drawn),
            mean(others, drawn),
            mean(marked, left),
            mean(others, left),
        ];
        let [both, _, _, neither] = means;
        let variance = both * (neither / population.saturating_sub(1) as f32);
        // Of fewer it is NaN, and of 160 it first reaches 10.
        if population < 2 || variance < 10.0 {
            return Err(Error::OutOfRange(Error::NO_PLACE));
        }
        let product = u64::from(marked).wrapping_mul(drawn.into());
        let whole = product.checked_div(population.into()).unwrap_or(0);
        let over = product.wrapping_sub(whole.wrapping_mul(population.into()));
        let rest = over as f32 / all;
        let skew =
            |some: u32, other: u32| i64::from(other).wrapping_sub(i64::from(some)) as f32 / all;
        let centre = rest + 0.5 - 0.05 * skew(marked, others) * skew(drawn, left);
        let of_margins = excess(marked) + excess(others) + excess(drawn) + excess(left);
        Ok(Self {
            population,
            marked,
            drawn,
            hat: Hat::new(variance, whole as u32, centre),
            rest,
            means,
            root: PEAK * sqrt(both * neither) * sqrt(all),
            excess: of_margins - excess(population),
            budget: Self::BUDGET,
            tier: PhantomData,
        })
    }

    /// The number of all items.
    #[must_use]
    pub const fn population(&self) -> u32 {
        self.population
    }

    /// The number of marked items.
    #[must_use]
    pub const fn marked(&self) -> u32 {
        self.marked
    }

    /// The number of items drawn.
    #[must_use]
    pub const fn drawn(&self) -> u32 {
        self.drawn
    }

    /// One try with two given words, of which the first proposes a count and the second decides: a smaller one accepts
    /// more. `None` if the count is rejected.
    #[must_use]
    #[inline]
    pub fn attempt(&self, words: [u32; 2]) -> Option<u32> {
        let others = self.population.wrapping_sub(self.marked);
        let range = self.drawn.saturating_sub(others)..=self.marked.min(self.drawn);
        self.hat
            .attempt(words, false, range, |count| self.pmf(count))
    }

    /// The probability of a count; 0 only outside its range and below the smallest `f32`.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        self.known(count).unwrap_or(0.0)
    }

    /// The probability of a count that can be.
    fn known(&self, count: u32) -> Option<f32> {
        let away = self.hat.away(count, self.rest);
        let others = self.drawn.checked_sub(count)?;
        let marked_left = self.marked.checked_sub(count)?;
        let others_left = self
            .population
            .wrapping_sub(self.marked)
            .checked_sub(others)?;
        let counts = [count, others, marked_left, others_left];
        let (mut exponent, mut product) = (-self.excess, 1.0);
        for ((count, mean), away) in counts
            .into_iter()
            .zip(self.means)
            .zip([away, -away, -away, away])
        {
            if count == 0 {
                exponent += mean;
                product *= NOBODY;
            } else {
                exponent += deviance::<T>(count as f32, mean, away) + excess(count);
                product *= count as f32;
            }
        }
        Some(T::exp(-exponent) * (self.root / sqrt(product)))
    }
}

impl<T: Tier> Rejection for HypergeometricRejection<T> {
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
