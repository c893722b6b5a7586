//! The Poisson distribution of small means: how many events an interval holds.

use super::ends::rounded;
use super::word::drawn_by_word;
use crate::error::{Error, positive, tried};
use crate::num::{Long, high};
use core::ops::RangeInclusive;

/// The number of events in an interval, of a mean up to 80, by inversion: photons, decays, arrivals.
///
/// Counts increase with the word. A draw walks from the mean towards the count, so a constructor is the larger part of
/// the work where each draw has another mean.
///
/// # Density
/// mᵏe⁻ᵐ/k! for the count k and the mean m.
///
/// # Domain
/// - Point: a `u32`, at most 143. The tail of a single word ends where a part of 2⁻³³ is left.
/// - Uniforms: one word.
/// - Parameters: a mean above 0 and up to 80, as an `f32` or as a ratio of integers.
///
/// # Accuracy
/// - Of the 2³² words, the cumulated probability times 2³² give k or less, rounded to the nearest integer.
///   [`words_of`](Self::words_of) says which give k. Before it is rounded, the number is off by less than 2⁻¹⁶.
/// - The pmf is that of the formula, to a relative error of 6.2e-8, or to the spacing of subnormals. Above a count of
///   256 it is 0, where the formula is below the smallest `f32`.
/// - A ratio of integers is cut by less than 2⁻⁶² of it.
///
/// # Cost
/// A table of 2 KiB. A constructor takes at most 80 steps of two products of 64 bits, a draw at most 80 steps of two; a
/// draw of mean m takes about 0.8√m on average. From a ratio of integers to the count there is no floating-point operation.
///
/// # Examples
/// ```
/// use microwarp::discrete::Poisson;
/// use rand_pcg::Pcg32;
/// let clicks = Poisson::new(3.5)?; // of a Geiger counter in a second
/// let count = clicks.draw(&mut Pcg32::new(1, 1));
/// assert!(clicks.words_of(count).is_some());
/// assert_eq!((clicks.count(0), clicks.count(1 << 31)), (0, 3));
/// assert!((clicks.pmf(0) - 0.030_197_38).abs() < 1e-8);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`rejection::PoissonRejection`](crate::rejection::PoissonRejection): means from 10 up.
/// - [`Cdf`](super::Cdf), [`Alias`](super::Alias): where the mean stays, a table of [`pmf`](Self::pmf) has a fixed cost.
/// - [`Binomial`](super::Binomial): successes of a number of trials, which they cannot exceed.
/// - [`Geometric`](super::Geometric): how many intervals pass before the first event.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapter X.3 (inversion from the mode):
/// <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "shot_noise")]
#[doc(alias = "counting")]
#[doc(alias = "photon")]
#[doc(alias = "arrivals")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Poisson {
    mean: Long,
    /// 1/mean.
    inverse: Long,
    /// The mean, cut to an integer: a count of the largest probability.
    mode: u32,
    /// Its probability, in units of 2⁻⁶⁴.
    peak: u64,
    /// The probability of all counts below it, likewise.
    below: u64,
}

/// 1/k in units of 2⁻⁶⁴, from k = 1.
pub(super) static RECIPROCALS: [u64; 256] = {
    let mut table = [0; 256];
    let mut rest: &mut [u64] = &mut table;
    let mut k = 1;
    while let [slot, others @ ..] = rest {
        *slot = Long::ONE.over(Long::of(k, 64)).fraction();
        k = k.wrapping_add(1);
        rest = others;
    }
    table
};

/// e⁻ˣ of x up to 128, to an absolute error of 2⁻⁵⁷ of x; e⁻¹²⁸ beyond.
pub(super) const fn exp_neg(x: Long) -> Long {
    /// In units of 2⁻⁶⁴.
    const LN_2: u64 = 0xb172_17f7_d1cf_79ab;
    /// Half of it, likewise.
    const LOG2_E: u64 = 0xb8aa_3b29_5c17_f0bb;
    // In units of 2^-57, so that it fits.
    let units = Long::of(x.mantissa, x.exponent.saturating_sub(7)).fraction();
    let halvings = high(units, LOG2_E) >> 56;
    // Between 0 and a little above ln 2, of which a sixteenth is taken.
    let rest = ((units as u128) << 7).wrapping_sub((halvings as u128).wrapping_mul(LN_2 as u128));
    let (rest, mut power) = ((rest >> 4) as u64, u64::MAX);
    // 1 − x(1 − x/2(1 − x/3(…))), to the sixteenth power.
    let (mut terms, _) = RECIPROCALS.split_at(9);
    while let [others @ .., reciprocal] = terms {
        power = u64::MAX.wrapping_sub(high(high(rest, power), *reciprocal));
        terms = others;
    }
    let mut squarings = 4_u32;
    while squarings > 0 {
        power = high(power, power);
        squarings = squarings.wrapping_sub(1);
    }
    Long::of(power, 0_i32.wrapping_sub(halvings as i32))
}

impl Poisson {
    /// The largest mean.
    pub const LARGEST: f32 = 80.0;

    /// Events of a mean number above 0 and up to 80.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::TooLarge`] above 80.
    pub const fn new(mean: f32) -> Result<Self, Error> {
        let mean = tried!(positive(mean, 0));
        Self::of(Long::of_f32(mean), 0)
    }

    /// So many events in so many intervals, by integers alone.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if one of the two is 0, [`Error::TooLarge`] for a ratio above 80.
    pub const fn from_ratio(events: u32, intervals: u32) -> Result<Self, Error> {
        Self::of(tried!(Long::of_ratio(events, intervals)), 1)
    }

    /// Of a mean that lies in the parameters up to that place.
    const fn of(mean: Long, place: usize) -> Result<Self, Error> {
        if mean.exceeds(Long::of(80, 64)) {
            return Err(Error::TooLarge(place));
        }
        let mode = mean.whole() as usize;
        let (mut probability, mut below) = (exp_neg(mean), 0_u64);
        let (mut reciprocals, _) = RECIPROCALS.split_at(mode);
        while let [reciprocal, others @ ..] = reciprocals {
            below = below.saturating_add(probability.fraction());
            probability = probability.times(mean).times(Long::of(*reciprocal, 0));
            reciprocals = others;
        }
        Ok(Self {
            mean,
            inverse: Long::ONE.over(mean),
            mode: mode as u32,
            peak: probability.fraction(),
            below,
        })
    }

    /// The mean.
    #[must_use]
    pub fn mean(&self) -> f32 {
        self.mean.value()
    }

    /// Walks from the mode for as long as `passes` says of the count k and the probability of all below it, or of all up
    /// to it: down while k has to be smaller, then up while it has to be larger. Returns both at the end.
    #[inline]
    fn walk(&self, down: impl Fn(u32, u64) -> bool, up: impl Fn(u32, u64) -> bool) -> (u32, u64) {
        let (mut count, mut probability) = (self.mode, self.peak);
        let mut below = self.below;
        while count > 0 && down(count, below) {
            // The product with 1/mean is at most 2⁶⁴/count.
            probability = self.inverse.of_this(probability).wrapping_mul(count.into());
            count = count.wrapping_sub(1);
            below = below.saturating_sub(probability);
        }
        if count < self.mode {
            return (count, below);
        }
        for &reciprocal in RECIPROCALS.iter().skip(self.mode as usize) {
            let with = below.saturating_add(probability);
            if !up(count, with) {
                break;
            }
            probability = self.mean.of_this(high(probability, reciprocal));
            count = count.wrapping_add(1);
            below = with;
        }
        (count, below)
    }

    /// The count of a word.
    #[must_use]
    #[inline]
    pub fn count(&self, word: u32) -> u32 {
        // The middle of the word.
        let at = u64::from(word) << 32 | 1 << 31;
        self.walk(|_, below| at < below, |_, with| at >= with).0
    }

    drawn_by_word!();

    /// How many words give less than this count.
    fn words_below(&self, count: u32) -> u64 {
        let (reached, below) = self.walk(|k, _| k > count, |k, _| k < count);
        match count {
            0 => 0,
            _ if reached < count => 1 << 32,
            _ => rounded(below.saturating_sub(1)),
        }
    }

    /// The words that give a count; none beyond the end of either tail.
    #[must_use]
    pub fn words_of(&self, count: u32) -> Option<RangeInclusive<u32>> {
        let end = self.words_below(count.saturating_add(1));
        let start = self.words_below(count);
        (start < end).then(|| start as u32..=(end as u32).wrapping_sub(1))
    }

    /// The probability of a count; 0 only below the smallest `f32`.
    #[must_use]
    pub fn pmf(&self, count: u32) -> f32 {
        let mut probability = Long::of(self.peak, 0);
        let mode = self.mode;
        if count > RECIPROCALS.len() as u32 {
            return 0.0;
        }
        for k in count..mode {
            // Of k from that of k + 1, in any order.
            let factor = Long::of(u64::from(k).wrapping_add(1), 64);
            probability = probability.times(self.inverse).times(factor);
        }
        let steps = RECIPROCALS.iter().take(count as usize);
        for &reciprocal in steps.skip(mode as usize) {
            probability = probability.times(self.mean).times(Long::of(reciprocal, 0));
        }
        probability.value()
    }
}
