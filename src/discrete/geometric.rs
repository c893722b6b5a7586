//! The geometric distribution: how many failures come before the first success.

use super::word::drawn_by_word;
use crate::error::{Error, positive, tried};
use crate::num::doubles::ln;
use crate::num::{Long, high};
use core::f64::consts::{LN_2, LOG2_E};
use core::ops::RangeInclusive;

/// The number of failures before the first success, where each trial succeeds with the same probability.
///
/// Counts increase with the word. A draw takes a logarithm of the word in integers and multiplies it. Where that leaves the count
/// in doubt, and for a small p, it takes one product of integers for each binary digit of the largest count instead. It is exact
/// however small the probability is, where ⌊ln u/ln(1 − p)⌋ in `f32` is not.
///
/// # Density
/// p(1 − p)ᵏ for the count k.
///
/// # Domain
/// - Point: a `u32` up to 22.9/p, where the tail of a single word ends; (1 − p)ᵏ is at least 2⁻³³ there.
/// - Uniforms: one word.
/// - Parameters: p from 5.4e-9 to 1 as an `f32`, or as a ratio of integers.
///
/// # Accuracy
/// - Of the 2³² words, 2³²(1 − p)ᵏ give k or more, rounded to the nearest integer. [`words_of`](Self::words_of) says
///   which give k. Before it is rounded, the number is off by less than 2⁻²⁰.
/// - The pmf is that of the formula for every count, to a relative error of 6.2e-8, or to the spacing of subnormals.
/// - A ratio of integers is cut by less than 2⁻⁶² of it.
///
/// # Cost
/// 304 bytes of memory, or flash where [`constant!`](crate::constant) makes it. A draw takes five products, and none for p = ½. A
/// share of about 1.7e-7/p of the draws takes ⌈log₂(22.9/p)⌉ more, and so do all draws for p below 1.7e-7. From a ratio of
/// integers to the count there is no floating-point operation.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::Geometric};
/// use rand_pcg::Pcg32;
/// const UNTIL_SIX: Geometric = constant!(Geometric::from_ratio(1, 6)); // rolls of a die before a 6
/// let rolls = UNTIL_SIX.draw(&mut Pcg32::new(1, 1));
/// assert!(UNTIL_SIX.words_of(rolls).is_some());
/// assert_eq!(UNTIL_SIX.count(0), 0);
/// assert_eq!(UNTIL_SIX.count(u32::MAX), 125);
/// assert!((UNTIL_SIX.pmf(1) - 5.0 / 36.0).abs() < 1e-8);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Poisson`](super::Poisson): how many events an interval holds.
/// - [`warp::Exponential`](crate::warp::Exponential): waiting in continuous time.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapter X.2:
/// <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "bernoulli")]
#[doc(alias = "trials")]
#[doc(alias = "waiting_time")]
#[doc(alias = "run_length")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Geometric {
    success: Long,
    /// 1 − (1 − p)^(2ⁱ), with 64 bits, and `shift − i` more while i is below the shift: all are below 2^(i − shift).
    steps: [u64; 32],
    shift: u32,
    /// How many of them a word can reach.
    levels: usize,
    /// −1/log₂(1 − p).
    reciprocal: Long,
    /// By how much the product of that and a logarithm may be off, in units of 2⁻³²; 0 for p = ½, where leading zeros count.
    doubt: u32,
}

/// 1 in units of 2⁻⁶³.
const ONE: u64 = 1 << 63;
/// Half a word in units of 2⁻⁶³.
const HALF: u64 = 1 << 30;
/// The smallest probability, for which the last word still counts below 2³².
const LEAST: Long = Long::of_f32(5.4e-9);

/// The last words, whose logarithms have too few digits for the exactness of `steps`.
const LAST: u32 = 1 << 8;

/// The cells of a table from 1 to 2.
const CELLS: usize = 16;

/// The largest distance from the middle of a cell, as a distance of the logarithm.
const FARTHEST: f64 = LOG2_E / (2.0 * CELLS as f64 + 1.0);

/// The series of the logarithm to its cube. The fourth power is spread over the square and what is constant.
const FOURTH: f64 = LN_2 * LN_2 * LN_2 / 4.0;
const SQUARE: i64 = ((0.5 * LN_2 + FOURTH * FARTHEST * FARTHEST) * 4_294_967_296.0) as i64;
const CUBE: i64 = (LN_2 * LN_2 / 3.0 * 4_294_967_296.0) as i64;

/// For the middle c of each cell: log₂e/c in units of 2⁻³¹, and log₂c in units of 2⁻³².
#[allow(
    clippy::indexing_slicing,
    reason = "the compiler evaluates it, and a panic would stop the build"
)]
static LOG: [(u32, u32); CELLS] = {
    let mut table = [(0, 0); CELLS];
    let mut i = 0;
    while i < CELLS {
        let inverse = 2.0 * CELLS as f64 / (2.0 * (CELLS + i) as f64 + 1.0);
        let even = FOURTH * FARTHEST * FARTHEST * FARTHEST * FARTHEST / 8.0;
        let log = even - ln(inverse) * LOG2_E;
        table[i] = (
            (LOG2_E * inverse * 2_147_483_648.0) as u32,
            (log * 4_294_967_296.0) as u32,
        );
        i += 1;
    }
    table
};

/// −log₂(2·left + 1) + 33 in units of 2⁻³², off by less than 5e-8.
#[inline]
#[expect(clippy::cast_possible_wrap, reason = "a distance with its sign")]
fn neg_log2(left: u32) -> u64 {
    const MIDDLE: u32 = 1 << 27;
    let zeros = left.leading_zeros();
    // Of the number without its leading 1.
    let fraction = (left << 1 | 1).wrapping_shl(zeros);
    let (slope, log) = LOG
        .get((fraction >> 28) as usize)
        .copied()
        .unwrap_or_default();
    let distance = (fraction & (2 * MIDDLE - 1)).wrapping_sub(MIDDLE) as i32;
    let h = i64::from(distance).wrapping_mul(slope.into()) >> 31;
    let factor = SQUARE.wrapping_sub(h.wrapping_mul(CUBE) >> 32);
    let bend = h.wrapping_mul(h.wrapping_mul(factor) >> 32) >> 32;
    let whole = u64::from(zeros.wrapping_add(1)) << 32;
    whole
        .wrapping_sub(log.into())
        .wrapping_add_signed(bend.wrapping_sub(h))
}

/// −log₂ of a number above 0 in units of 2⁻⁶⁴, in units of 2⁻⁵⁸, digit by digit.
pub(super) const fn neg_log2_in_full(number: u64) -> u64 {
    let zeros = number.leading_zeros();
    let (mut log, mut power) = (zeros as u64, number.wrapping_shl(zeros));
    let mut digits = 58_u32;
    while digits > 0 {
        power = high(power, power);
        log <<= 1;
        if power < ONE {
            power <<= 1;
            log |= 1;
        }
        digits = digits.wrapping_sub(1);
    }
    log
}

impl Geometric {
    /// Trials that succeed with a probability from 5.4e-9 to 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::OutOfRange`] above 1,
    /// [`Error::TooLarge`] below 5.4e-9, where counts do not fit `u32`.
    pub const fn new(p: f32) -> Result<Self, Error> {
        let p = tried!(positive(p, 0));
        Self::of(Long::of_f32(p), 0)
    }

    /// Trials of which so many in so many succeed, by integers alone.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if one of the two is 0, [`Error::OutOfRange`] for more successes than trials,
    /// [`Error::TooLarge`] for a ratio below 5.4e-9.
    pub const fn from_ratio(successes: u32, trials: u32) -> Result<Self, Error> {
        Self::of(tried!(Long::of_ratio(successes, trials)), 1)
    }

    /// Of a probability that lies in the parameters up to that place.
    pub(super) const fn of(success: Long, place: usize) -> Result<Self, Error> {
        if success.exceeds(Long::ONE) {
            return Err(Error::OutOfRange(place));
        }
        if LEAST.exceeds(success) {
            return Err(Error::TooLarge(place));
        }
        let shift = success.exponent.unsigned_abs();
        let mut made = Self {
            success,
            steps: [0; 32],
            shift,
            levels: 0,
            reciprocal: Long::ONE,
            doubt: 1 << 31,
        };
        if success.exponent == 1 {
            return Ok(made);
        }
        if success.exponent < 0 || success.mantissa != ONE {
            let rate = neg_log2_in_full(success.fraction().wrapping_neg());
            made.reciprocal = Long::ONE.over(Long::of(rate, 6));
            // What the logarithm, `steps` and the product may be off by are half of it, 2⁻²³ of the reciprocal.
            let doubt = made.reciprocal.of_this(1 << 9).saturating_add(4);
            made.doubt = if doubt < 1 << 31 {
                doubt as u32
            } else {
                1 << 31
            };
        } else {
            made.doubt = 0;
        }
        // Rounded up, so that no step reaches further than two of half its length: powers never increase with the count.
        let (mut step, mut more) = (success.mantissa, shift);
        let mut rest: &mut [u64] = &mut made.steps;
        while let [slot, others @ ..] = rest {
            // The power is below 2^-33, which no word reaches.
            if more == 0 && step.wrapping_neg() < 1 << 31 {
                break;
            }
            *slot = step;
            made.levels = made.levels.wrapping_add(1);
            // Of the step d, twice the length has 2d − d².
            let square = high(step, step);
            step = if more > 0 {
                step.wrapping_sub(square >> 1 >> more)
            } else {
                step.wrapping_shl(1).wrapping_sub(square)
            };
            more = more.saturating_sub(1);
            rest = others;
        }
        Ok(made)
    }

    /// The probability that a trial succeeds.
    #[must_use]
    pub fn success(&self) -> f32 {
        self.success.value()
    }

    /// The steps by falling length, each with the bit of its count, and by how much it is shifted.
    #[inline]
    fn falling(&self) -> impl Iterator<Item = (u32, u64, u32)> {
        let steps = self.steps.iter().zip(0_u32..32).take(self.levels).rev();
        steps.map(|(&step, level)| {
            let shift = self.shift.saturating_sub(level);
            (1_u32.wrapping_shl(level), step, shift)
        })
    }

    /// The count of a word.
    #[must_use]
    #[inline]
    pub fn count(&self, word: u32) -> u32 {
        let left = !word;
        if left >= LAST && self.doubt == 0 {
            return left.leading_zeros();
        }
        match self.quick(left, 0) {
            Some(count) => count,
            None => self.walked(word),
        }
    }

    /// The largest count that is reached with a probability of (left + ½)·2^(more·2⁻³² − 32) or more, where the logarithm leaves no
    /// doubt.
    #[inline]
    pub(super) fn quick(&self, left: u32, more: u64) -> Option<u32> {
        if left < LAST {
            return None;
        }
        let log = neg_log2(left).saturating_sub(more);
        let count = self.reciprocal.of_this(log);
        // Far enough from the whole numbers on both sides.
        let beyond = (count as u32).wrapping_sub(self.doubt);
        (beyond < self.doubt.wrapping_mul(2).wrapping_neg()).then_some((count >> 32) as u32)
    }

    /// The count of a word by its binary digits.
    #[cold]
    fn walked(&self, word: u32) -> u32 {
        // The way from the middle of the word to 1.
        self.reached(ONE.wrapping_sub(u64::from(word) << 31 | HALF))
    }

    /// The largest count that is reached with this probability or more, in units of 2⁻⁶³.
    pub(super) fn reached(&self, bound: u64) -> u32 {
        let (mut count, mut power) = (0, ONE);
        for (bit, step, shift) in self.falling() {
            let next = power.wrapping_sub(high(power, step) >> shift);
            if next >= bound {
                (count, power) = (count | bit, next);
            }
        }
        count
    }

    drawn_by_word!();

    /// How many words give this count or more.
    fn reaching(&self, count: u32) -> u64 {
        let mut left = count;
        let mut power = ONE;
        for (bit, step, shift) in self.falling() {
            if left & bit != 0 {
                power = power.wrapping_sub(high(power, step) >> shift);
                left ^= bit;
            }
        }
        if left > 0 {
            return 0;
        }
        power.wrapping_add(HALF) >> 31
    }

    /// The words that give a count; none beyond the end of the tail, and where the count has less than a word.
    #[must_use]
    pub fn words_of(&self, count: u32) -> Option<RangeInclusive<u32>> {
        let end = count.checked_add(1).map_or(0, |next| self.reaching(next));
        let words = self.reaching(count);
        // Words count from the other end.
        (words > end).then(|| (words as u32).wrapping_neg()..=!(end as u32))
    }

    /// The probability of a count, p(1 − p)ᵏ; 0 only below the smallest `f32`.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        let failure = self.success.fraction().wrapping_neg();
        if self.success.exponent == 1 {
            return if count == 0 { 1.0 } else { 0.0 };
        }
        let (mut power, mut product) = (Long::of(failure, 0), self.success);
        let mut left = count;
        while left > 0 {
            if left & 1 == 1 {
                product = product.times(power);
            }
            power = power.times(power);
            left >>= 1;
        }
        product.value()
    }
}
