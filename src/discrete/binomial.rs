//! The binomial distribution of small variance: how many of so many trials succeed.

use super::word::drawn_by_word;
use crate::error::{Error, finite, tried};
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
/// - [`Geometric`](super::Geometric): how many trials fail before the first success.
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
    /// The count of the largest probability, but for rounding, and this probability.
    mode: u32,
    peak: Long,
    /// The smallest count that a word gives.
    first: u32,
    /// The last word of this count and of those behind it.
    ends: [u32; 128],
}

/// A number of which products are 0.
const NOTHING: Long = Long::of(0, 0);

/// How many words have their middle below a probability in units of 2⁻⁶⁴; without a carry.
const fn rounded(below: u64) -> u64 {
    (below >> 31).wrapping_add(1) >> 1
}

impl Binomial {
    /// So many trials that succeed with a probability from 0 to 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for p outside [0, 1], [`Error::TooLarge`] for a
    /// variance np(1 − p) above 100.
    pub const fn new(trials: u32, p: f32) -> Result<Self, Error> {
        let p = tried!(finite(p));
        if p < 0.0 || p > 1.0 {
            return Err(Error::OutOfRange);
        }
        if p == 0.0 {
            return Self::of(trials, NOTHING, Long::ONE);
        }
        let success = Long::of_f32(p);
        if p >= 1.0 {
            return Self::of(trials, success, NOTHING);
        }
        // Below 2⁻⁶⁴ the other probability is 1.
        let failure = match success.fraction() {
            0 => Long::ONE,
            part => Long::of(part.wrapping_neg(), 0),
        };
        Self::of(trials, success, failure)
    }

    /// So many trials that succeed in `part` of `whole` cases each, by integers alone.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if `whole` is 0, [`Error::OutOfRange`] for a part above the whole, [`Error::TooLarge`] for a
    /// variance np(1 − p) above 100.
    pub const fn from_ratio(trials: u32, part: u32, whole: u32) -> Result<Self, Error> {
        if whole == 0 {
            return Err(Error::NotPositive);
        }
        let Some(other) = whole.checked_sub(part) else {
            return Err(Error::OutOfRange);
        };
        let whole = Long::of(whole as u64, 64);
        let success = match part {
            0 => NOTHING,
            _ => Long::of(part as u64, 64).over(whole),
        };
        Self::of(trials, success, Long::of(other as u64, 64).over(whole))
    }

    const fn of(trials: u32, success: Long, failure: Long) -> Result<Self, Error> {
        let mean = Long::of(trials as u64, 64).times(success);
        let variance = mean.times(failure);
        // 100 is 25/32 of 2⁷.
        if variance.exponent > 7 || (variance.exponent == 7 && variance.mantissa > 25 << 59) {
            return Err(Error::TooLarge);
        }
        let ends = success.mantissa == 0 || failure.mantissa == 0;
        let (odds, inverse) = if ends {
            (NOTHING, NOTHING)
        } else {
            (success.over(failure), failure.over(success))
        };
        // The mode is (n + 1)p, cut to an integer, and n for p = 1.
        let next = Long::of((trials as u64).wrapping_add(1), 64).times(success);
        let mode = match next.exponent {
            whole @ 1..=33 => next.mantissa >> 64_u32.wrapping_sub(whole.unsigned_abs()),
            _ => 0,
        };
        let mode = if mode < trials as u64 {
            mode as u32
        } else {
            trials
        };
        let made = Self {
            trials,
            success,
            odds,
            inverse,
            mode,
            peak: Long::ONE,
            first: 0,
            ends: [u32::MAX; 128],
        };
        Ok(made.filled())
    }

    /// The probability of the next count from that of a count below n.
    const fn above(&self, count: u32, probability: Long) -> Long {
        let (left, next) = (self.trials.wrapping_sub(count), count.wrapping_add(1));
        let ratio = Long::of(left as u64, 64).over(Long::of(next as u64, 64));
        probability.times(self.odds).times(ratio)
    }

    /// The probability of the count before from that of a count above 0.
    const fn below(&self, count: u32, probability: Long) -> Long {
        let more = (self.trials.wrapping_sub(count) as u64).wrapping_add(1);
        let ratio = Long::of(count as u64, 64).over(Long::of(more, 64));
        probability.times(self.inverse).times(ratio)
    }

    /// The same with its table and the probability of its mode.
    const fn filled(mut self) -> Self {
        // 1/64 in place of this probability: the sum of all stays below 1, and what is left out is below 2⁻⁵⁰ of it.
        let start = Long::of(1, 58);
        let (mut sum, mut lowest, mut count) = (start.fraction(), start, self.mode);
        while count > 0 {
            let next = self.below(count, lowest);
            if next.fraction() == 0 {
                break;
            }
            sum = sum.wrapping_add(next.fraction());
            lowest = next;
            count = count.wrapping_sub(1);
        }
        let (mut next, mut up) = (start, self.mode);
        while up < self.trials {
            next = self.above(up, next);
            if next.fraction() == 0 {
                break;
            }
            sum = sum.wrapping_add(next.fraction());
            up = up.wrapping_add(1);
        }
        let whole = Long::of(sum, 0);
        self.peak = start.over(whole);
        let (mut probability, mut below) = (lowest.over(whole), 0_u64);
        let mut ends = self.ends;
        let mut rest: &mut [u32] = &mut ends;
        self.first = count;
        while count < self.trials {
            below = below.saturating_add(probability.fraction());
            probability = self.above(count, probability);
            count = count.wrapping_add(1);
            match rest {
                _ if rounded(below) == 0 => self.first = count,
                [slot, others @ ..] => {
                    *slot = rounded(below).wrapping_sub(1) as u32;
                    rest = others;
                }
                [] => break,
            }
        }
        self.ends = ends;
        self
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
        // The last end is the last word, so this is one of the counts.
        let passed = self.ends.partition_point(|&last| last < word);
        self.first.wrapping_add(passed as u32)
    }

    drawn_by_word!();

    /// The words that give a count; none beyond the end of either tail.
    #[must_use]
    pub fn words_of(&self, count: u32) -> Option<RangeInclusive<u32>> {
        let place = count.checked_sub(self.first)? as usize;
        let last = *self.ends.get(place)?;
        let Some(before) = place.checked_sub(1) else {
            return Some(0..=last);
        };
        let before = *self.ends.get(before)?;
        (before < last).then(|| before.wrapping_add(1)..=last)
    }

    /// The probability of a count; 0 only beyond n, below the smallest `f32`, and beside the one count of p = 0 and 1.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        /// Below this exponent numbers are far below the smallest `f32`, and become smaller with each step.
        const NONE: i32 = -200;
        let (mut at, mut probability) = (self.mode, self.peak);
        if count > self.trials {
            return 0.0;
        }
        while at < count && probability.exponent > NONE {
            probability = self.above(at, probability);
            at = at.wrapping_add(1);
        }
        while at > count && probability.exponent > NONE {
            probability = self.below(at, probability);
            at = at.wrapping_sub(1);
        }
        probability.value()
    }
}
