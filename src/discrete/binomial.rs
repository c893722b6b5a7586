//! The binomial distribution of small variance: how many of so many trials succeed.

use super::ends::{Ends, Kind, Law, NOTHING, chances, chances_of};
use super::word::drawn_by_word;
use crate::error::{Error, tried};
use crate::num::Long;
use core::ops::RangeInclusive;

/// The number of successes in n independent trials, of a variance np(1 − p) up to 100, by inversion: bits in error,
/// packets lost, cells hit.
///
/// Counts increase with the word. The constructor makes a table of the words of each count, and a draw is eight
/// comparisons of integers. So [`constant!`](crate::constant) suits it, where n and p are constants.
///
/// # Density
/// n!/(k!(n − k)!) pᵏ(1 − p)ⁿ⁻ᵏ for the count k.
///
/// # Domain
/// - Point: a `u32` from 0 to n. The tails of a single word end where a part of 2⁻³³ is left.
/// - Uniforms: one word.
/// - Parameters: any n, and p from 0 to 1 as an `f32` or as a ratio of integers, where np(1 − p) is at most 100. For
///   p = 0 all counts are 0, for p = 1 they are n.
///
/// # Accuracy
/// - Of the 2³² words, the cumulated probability times 2³² give k or less, rounded to the nearest integer.
///   [`words_of`](Self::words_of) says which give k. Before it is rounded, the number is off by less than 2⁻²⁰.
/// - The pmf is that of the formula for every count, to a relative error of 6.2e-8, or to the spacing of subnormals.
/// - A ratio of integers is cut by less than 2⁻⁶² of it.
///
/// # Cost
/// 592 bytes of memory, or flash where [`constant!`](crate::constant) makes it. The constructor goes through at most 450
/// counts, with a division of 64 bits each. From a ratio of integers to the count there is no floating-point operation.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::Binomial};
/// use rand_pcg::Pcg32;
/// const SIXES: Binomial = constant!(Binomial::from_ratio(10, 1, 6)); // of ten dice
/// let sixes = SIXES.draw(&mut Pcg32::new(1, 1));
/// assert!(SIXES.words_of(sixes).is_some());
/// assert_eq!((SIXES.count(0), SIXES.count(1 << 31), SIXES.count(u32::MAX)), (0, 2, 10));
/// assert!((SIXES.pmf(0) - 0.161_505_58).abs() < 1e-8);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`rejection::BinomialRejection`](crate::rejection::BinomialRejection): variances from 10 up.
/// - [`Poisson`](super::Poisson): events that have no largest number.
/// - [`Geometric`](super::Geometric), [`NegativeBinomial`](super::NegativeBinomial): how many trials fail before the first
///   success, or before several.
/// - [`Hypergeometric`](super::Hypergeometric): a sample without replacement.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapters III.2 and X.4 (inversion, the ratio of
/// neighbouring probabilities): <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "bernoulli")]
#[doc(alias = "trials")]
#[doc(alias = "successes")]
#[doc(alias = "bit_errors")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Binomial {
    trials: u32,
    success: Long,
    /// p/(1 − p) and the inverse; 0 for p = 0 and p = 1.
    odds: Long,
    inverse: Long,
    table: Ends<128>,
}

impl Binomial {
    /// So many trials that succeed with a probability from 0 to 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for p outside [0, 1], [`Error::TooLarge`] for a
    /// variance np(1 − p) above 100.
    pub const fn new(trials: u32, p: f32) -> Result<Self, Error> {
        let [success, failure] = tried!(chances(p, 1));
        Self::of(trials, success, failure, 1)
    }

    /// So many trials that succeed in `part` of `whole` cases each, by integers alone.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if `whole` is 0, [`Error::OutOfRange`] for a part above the whole, [`Error::TooLarge`] for a
    /// variance np(1 − p) above 100.
    pub const fn from_ratio(trials: u32, part: u32, whole: u32) -> Result<Self, Error> {
        let [success, failure] = tried!(chances_of(part, whole, 2));
        Self::of(trials, success, failure, Error::NO_PLACE)
    }

    /// With the place of a reason that lies in all parameters.
    const fn of(trials: u32, success: Long, failure: Long, all: usize) -> Result<Self, Error> {
        let mean = Long::of(trials as u64, 64).times(success);
        let variance = mean.times(failure);
        if variance.exceeds(Long::of(100, 64)) {
            return Err(Error::TooLarge(all));
        }
        let ends = success.mantissa == 0 || failure.mantissa == 0;
        let (odds, inverse) = if ends {
            (NOTHING, NOTHING)
        } else {
            (success.over(failure), failure.over(success))
        };
        // The mode is (n + 1)p, cut to an integer, and n for p = 1.
        let next = Long::of((trials as u64).wrapping_add(1), 64).times(success);
        let mode = if next.whole() < trials as u64 {
            next.whole() as u32
        } else {
            trials
        };
        let law = Law {
            kind: Kind::Trials(trials),
            odds,
            inverse,
        };
        Ok(Self {
            trials,
            success,
            odds,
            inverse,
            table: Ends::of(&law, mode),
        })
    }

    /// The number of trials.
    #[must_use]
    pub const fn trials(&self) -> u32 {
        self.trials
    }

    /// The probability that a trial succeeds.
    #[must_use]
    pub fn success(&self) -> f32 {
        self.success.value()
    }

    /// The count of a word.
    #[must_use]
    #[inline]
    pub fn count(&self, word: u32) -> u32 {
        self.table.count(word)
    }

    drawn_by_word!();

    /// The words that give a count; none beyond the end of either tail.
    #[must_use]
    pub fn words_of(&self, count: u32) -> Option<RangeInclusive<u32>> {
        self.table.words_of(count)
    }

    /// The probability of a count; 0 only beyond n, below the smallest `f32`, and beside the one count of p = 0 and 1.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        let law = Law {
            kind: Kind::Trials(self.trials),
            odds: self.odds,
            inverse: self.inverse,
        };
        self.table.pmf(&law, count)
    }
}
