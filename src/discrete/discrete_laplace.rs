//! The discrete Laplace distribution: a geometric tail on both sides of 0.

use super::geometric::{Geometric, neg_log2_in_full};
use super::poisson::{RECIPROCALS, exp_neg};
use super::word::drawn_by_word;
use crate::error::{Error, positive, tried};
use crate::num::{Long, high};
use core::ops::RangeInclusive;

/// An integer whose probability falls as a power on both sides of 0: noise of whole numbers, differences of two geometric counts.
///
/// The integer of a word takes a logarithm in integers, as that of [`Geometric`](super::Geometric). Where that leaves it in doubt, and
/// for a large scale, it takes one product of 64 bits for each binary digit of the largest integer instead.
/// Integers increase with the word, and words as far from either end give opposite ones.
///
/// No claim of privacy is made: a word has 32 bits, the tails end where a part of 2⁻³³ is left, and the generator decides what an
/// observer may guess.
///
/// # Density
/// e^(−|k|/s)(1 − r)/(1 + r) for the integer k, where r = e^(−1/s).
///
/// # Domain
/// - Point: an `i32` up to 22.9 s either way, where the tails of a single word end.
/// - Uniforms: one word.
/// - Parameters: a scale s above 0 and up to 9e7, as an `f32` or as a ratio of integers.
///
/// # Accuracy
/// - Of the 2³² words, the cumulated probability times 2³² give k or less, rounded to the nearest integer.
///   [`words_of`](Self::words_of) says which give k. Before it is rounded, the number is off by less than 2⁻¹⁶.
/// - The pmf is that of the formula for every integer, to a relative error of 6.2e-8, or to the spacing of subnormals.
/// - A ratio of integers is cut by less than 2⁻⁶² of it.
///
/// # Cost
/// 352 bytes of memory, or flash where [`constant!`](crate::constant) makes it. A draw takes five products. A share of about 1.7e-7 s of
/// the draws takes ⌈log₂(22.9 s)⌉ + 1 more, and so do all draws for s above 6e6. From a ratio of integers to the integer there is no
/// floating-point operation.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::DiscreteLaplace};
/// use rand_pcg::Pcg32;
/// const NOISE: DiscreteLaplace = constant!(DiscreteLaplace::from_ratio(5, 2)); // a scale of 5/2
/// let noise = NOISE.draw(&mut Pcg32::new(1, 1));
/// assert!(NOISE.words_of(noise).is_some());
/// assert_eq!((NOISE.integer(0), NOISE.integer(1 << 31), NOISE.integer(u32::MAX)), (-55, 0, 55));
/// assert!((NOISE.pmf(0) - 0.197_375_3).abs() < 1e-7); // tanh(1/5)
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`DiscreteGaussian`](super::DiscreteGaussian): light tails.
/// - [`Geometric`](super::Geometric): one side.
/// - [`warp::Laplace`](crate::warp::Laplace): real numbers.
///
/// # Source
/// S. Inusah and T. J. Kozubowski, "A Discrete Analogue of the Laplace Distribution", 2006,
/// <https://doi.org/10.1016/j.jspi.2004.08.014>.
#[doc(alias = "two_sided_geometric")]
#[doc(alias = "integer_noise")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiscreteLaplace {
    /// 1/s.
    rate: Long,
    /// 1 − r.
    short: Long,
    side: Geometric,
    /// 1 + r in units of 2⁻⁶³, and its logarithm to base 2 in units of 2⁻³².
    both: u64,
    log: u64,
}

/// 1 − e⁻ˣ of x up to 1/2.
const fn short_of(x: Long) -> Long {
    let (part, mut series) = (x.fraction(), u64::MAX);
    // 1 − x/2(1 − x/3(…)).
    let (terms, _) = RECIPROCALS.split_at(20);
    let [_, terms @ ..] = terms else {
        return x;
    };
    let mut terms = terms;
    while let [others @ .., reciprocal] = terms {
        series = u64::MAX.wrapping_sub(high(high(part, series), *reciprocal));
        terms = others;
    }
    x.times(Long::of(series, 0))
}

impl DiscreteLaplace {
    /// The largest scale.
    pub const LARGEST: f32 = 9.0e7;

    /// Of a scale above 0 and up to 9e7.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::TooLarge`] above 9e7.
    pub const fn new(scale: f32) -> Result<Self, Error> {
        let scale = tried!(positive(scale, 0));
        Self::of(Long::of_f32(scale), 0)
    }

    /// Of a scale that is a ratio, by integers alone.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if one of the two is 0, [`Error::TooLarge`] for a ratio above 9e7.
    pub const fn from_ratio(part: u32, whole: u32) -> Result<Self, Error> {
        Self::of(tried!(Long::of_ratio(part, whole)), 1)
    }

    /// Of a scale that lies in the parameters up to that place.
    const fn of(scale: Long, place: usize) -> Result<Self, Error> {
        if scale.exceeds(Long::of_f32(Self::LARGEST)) {
            return Err(Error::TooLarge(place));
        }
        let rate = Long::ONE.over(scale);
        let short = if rate.exceeds(Long::of(1, 63)) {
            match exp_neg(rate).fraction() {
                0 => Long::ONE,
                ratio => Long::of(ratio.wrapping_neg(), 0),
            }
        } else {
            short_of(rate)
        };
        let both = 1 << 63 | short.fraction().wrapping_neg() >> 1;
        Ok(Self {
            rate,
            short,
            side: tried!(Geometric::of(short, place)),
            both,
            log: (1_u64 << 58).wrapping_sub(neg_log2_in_full(both)) >> 26,
        })
    }

    /// The scale.
    #[must_use]
    pub fn scale(&self) -> f32 {
        Long::ONE.over(self.rate).value()
    }

    /// How far from 0 a word is, of which so many are farther out on its side: |k| or more on one side have the probability
    /// r^|k|/(1 + r).
    #[inline]
    fn size(&self, rank: u32) -> u32 {
        match self.side.quick(rank, self.log) {
            Some(size) => size,
            None => self.walked(rank),
        }
    }

    /// The same by binary digits.
    #[cold]
    fn walked(&self, rank: u32) -> u32 {
        // The middle of the word times 1 + r.
        let middle = u128::from(rank << 1 | 1);
        self.side
            .reached((middle.wrapping_mul(self.both.into()) >> 33) as u64)
    }

    /// The integer of a word.
    #[must_use]
    #[inline]
    #[expect(clippy::cast_possible_wrap, reason = "sizes are below 2³¹")]
    pub fn integer(&self, word: u32) -> i32 {
        if word >> 31 == 0 {
            (self.size(word) as i32).wrapping_neg()
        } else {
            self.size(!word) as i32
        }
    }

    drawn_by_word!(i32 by integer);

    /// How many words on one side give this size or more.
    fn reaching(&self, size: u32) -> u32 {
        let mut words = 0_u32;
        for bit in (0..31).rev() {
            let more = words | 1_u32.wrapping_shl(bit);
            if self.size(more.wrapping_sub(1)) >= size {
                words = more;
            }
        }
        words
    }

    /// The words that give an integer; none beyond the end of either tail, and where the integer has less than a word.
    #[must_use]
    pub fn words_of(&self, integer: i32) -> Option<RangeInclusive<u32>> {
        let size = integer.unsigned_abs();
        let beyond = self.reaching(size.wrapping_add(1));
        if size == 0 {
            return Some(beyond..=!beyond);
        }
        let words = self.reaching(size);
        let last = words.wrapping_sub(1);
        (beyond < words).then_some(if integer < 0 {
            beyond..=last
        } else {
            !last..=!beyond
        })
    }

    /// The probability of an integer; 0 only below the smallest `f32`.
    #[must_use]
    pub fn pmf(&self, integer: i32) -> f32 {
        let peak = self.short.over(Long::of(self.both, 1));
        match integer.unsigned_abs() {
            0 => peak.value(),
            size => {
                let exponent = self.rate.times(Long::of(size.into(), 64));
                peak.times(exp_neg(exponent)).value()
            }
        }
    }
}
