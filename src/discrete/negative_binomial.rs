//! The negative binomial distribution of small variance: how many failures come before so many successes.

use super::ends::{Ends, Kind, Law, NOTHING, chances, chances_of};
use super::word::drawn_by_word;
use crate::error::{Error, positive, tried};
use crate::num::Long;
use core::ops::RangeInclusive;

/// The number of failures before the r-th success, of a variance r(1 − p)/p² up to 200, by inversion: tries of a packet, counts
/// that scatter more than those of a [`Poisson`](super::Poisson).
///
/// The number of successes need not be an integer. Of a mean m, and of a variance m + m²/r, p is r/(r + m). The constructor
/// makes a table of the words of each count, and a draw is nine comparisons of integers. Counts increase with the word.
///
/// # Density
/// Γ(k + r)/(k! Γ(r)) pʳ(1 − p)ᵏ for the count k.
///
/// # Domain
/// - Point: a `u32`. The tails of a single word end where a part of 2⁻³³ is left; at most 256 counts have words.
/// - Uniforms: one word.
/// - Parameters: p from 0.1 to 1 as an `f32` or as a ratio of integers; with p as an `f32`, r as one from 2⁻⁷ up, otherwise an
///   integer above 0; where r(1 − p)/p² is at most 200. For p = 1 all counts are 0.
///
/// # Accuracy
/// - Of the 2³² words, the cumulated probability times 2³² give k or less, rounded to the nearest integer.
///   [`words_of`](Self::words_of) says which give k. Before it is rounded, the number is off by less than 2⁻¹⁶.
/// - The pmf is that of the formula for every count, to a relative error of 6.2e-8, or to the spacing of subnormals.
/// - A ratio of integers is cut by less than 2⁻⁶² of it.
///
/// # Cost
/// 1,104 bytes of memory, or flash where [`constant!`](crate::constant) makes it. The constructor goes through at most 750
/// counts, with a division of 64 bits each. From a ratio of integers to the count there is no floating-point operation.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::NegativeBinomial};
/// use rand_pcg::Pcg32;
/// const LOST: NegativeBinomial = constant!(NegativeBinomial::from_ratio(3, 3, 4)); // until three packets came
/// let lost = LOST.draw(&mut Pcg32::new(1, 1));
/// assert!(LOST.words_of(lost).is_some());
/// assert_eq!((LOST.count(0), LOST.count(1 << 31), LOST.count(u32::MAX)), (0, 1, 20));
/// assert_eq!(LOST.pmf(0), 0.421_875); // (3/4)³
/// let visits = NegativeBinomial::new(0.5, 0.2)?; // a mean of 2, a variance of 10
/// assert!((visits.pmf(0) - 0.447_213_6).abs() < 1e-7); // √0.2
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Geometric`](super::Geometric): failures before the first success, for any p.
/// - [`Binomial`](super::Binomial): successes of a number of trials.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapters III.2 and X.4 (inversion, the ratio of
/// neighbouring probabilities): <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "pascal")]
#[doc(alias = "polya")]
#[doc(alias = "overdispersed")]
#[doc(alias = "retries")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NegativeBinomial {
    /// r in units of 2⁻³¹.
    successes: u64,
    success: Long,
    /// 1 − p and the inverse; 0 for p = 1.
    failure: Long,
    inverse: Long,
    table: Ends<256>,
}

/// The number 1 in units of `successes`.
const ONE: u64 = 1 << 31;

impl NegativeBinomial {
    /// Failures before the last of so many successes, of a probability from 0.1 to 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] if one of the two is 0 or less,
    /// [`Error::OutOfRange`] for r below 2⁻⁷ and for p above 1, [`Error::TooLarge`] for p below 0.1, for r from 2³² up and for
    /// a variance r(1 − p)/p² above 200.
    pub const fn new(successes: f32, p: f32) -> Result<Self, Error> {
        let (successes, p) = (tried!(positive(successes, 0)), tried!(positive(p, 1)));
        if successes < 0.007_812_5 {
            return Err(Error::OutOfRange(0));
        }
        if successes >= 4_294_967_296.0 {
            return Err(Error::TooLarge(0));
        }
        let [success, failure] = tried!(chances(p, 1));
        // Exact: 24 digits above 2⁻³¹.
        let Long { mantissa, exponent } = Long::of_f32(successes);
        Self::of(
            Long::of(mantissa, exponent.wrapping_add(31)).whole(),
            success,
            failure,
            [1, 1],
        )
    }

    /// Failures before the last of so many successes, in `part` of `whole` cases each, by integers alone.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if one of the three is 0, [`Error::OutOfRange`] for a part above the whole,
    /// [`Error::TooLarge`] for p below 0.1 and for a variance r(1 − p)/p² above 200.
    pub const fn from_ratio(successes: u32, part: u32, whole: u32) -> Result<Self, Error> {
        if successes == 0 || part == 0 {
            return Err(Error::NotPositive(if successes == 0 { 0 } else { 1 }));
        }
        let [success, failure] = tried!(chances_of(part, whole, 2));
        let places = [2, Error::NO_PLACE];
        Self::of((successes as u64) << 31, success, failure, places)
    }

    /// With the places of a reason that lies in the probability, and of one that lies in all parameters.
    const fn of(
        successes: u64,
        success: Long,
        failure: Long,
        [of_p, all]: [usize; 2],
    ) -> Result<Self, Error> {
        let least = Long::of(1, 64).over(Long::of(10, 64));
        let odds = failure.over(success);
        let variance = Long::of(successes, 33).times(odds).over(success);
        if least.exceeds(success) {
            return Err(Error::TooLarge(of_p));
        }
        if variance.exceeds(Long::of(200, 64)) {
            return Err(Error::TooLarge(all));
        }
        let inverse = match failure.mantissa {
            0 => NOTHING,
            _ => Long::ONE.over(failure),
        };
        let law = Law {
            kind: Kind::Failures(successes),
            odds: failure,
            inverse,
        };
        // (r − 1)(1 − p)/p, cut to an integer.
        let mode = Long::of(successes.saturating_sub(ONE), 33)
            .times(odds)
            .whole();
        Ok(Self {
            successes,
            success,
            failure,
            inverse,
            table: Ends::of(&law, mode as u32),
        })
    }

    /// The number of successes.
    #[must_use]
    pub fn successes(&self) -> f32 {
        Long::of(self.successes, 33).value()
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

    /// The probability of a count; 0 only below the smallest `f32`, and above 0 for p = 1.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        let law = Law {
            kind: Kind::Failures(self.successes),
            odds: self.failure,
            inverse: self.inverse,
        };
        self.table.pmf(&law, count)
    }
}
