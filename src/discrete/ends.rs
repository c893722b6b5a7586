//! Counts by a table of words, for distributions of which neighbouring probabilities have a simple ratio.

use super::poisson::exp_neg;
use crate::error::{Error, finite, tried};
use crate::num::Long;
use core::ops::RangeInclusive;

/// A distribution on counts: the ratio of the probability of a count and of the one before is `odds` times a ratio of integers.
#[derive(Clone, Copy)]
pub(super) struct Law {
    pub(super) kind: Kind,
    pub(super) odds: Long,
    /// Its inverse; both may be 0.
    pub(super) inverse: Long,
}

/// The ratio of integers, for k + 1 and k.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    /// (n − k)/(k + 1) of n trials.
    Trials(u32),
    /// (k + r)/(k + 1) of r successes, in units of 2⁻³¹.
    Failures(u64),
    /// (K − k)(n − k)/((k + 1)(N − K − n + k + 1)).
    Urn {
        population: u32,
        marked: u32,
        drawn: u32,
    },
    /// No ratio of integers, but a power of e.
    Squares(Squares),
}

/// Of e^(−(j + d)²h) for the j-th count from the one with the number `mode`: d in units of 2⁻⁶³, at most half of one either
/// way, and h.
#[derive(Clone, Copy)]
pub(super) struct Squares {
    pub(super) mode: u32,
    pub(super) off: i64,
    pub(super) rate: Long,
}

impl Squares {
    /// The probability of the next count from that of this one, or the other way round.
    const fn step(self, count: u32, probability: Long, down: bool) -> Long {
        // (j + 1 + d)² − (j + d)², in units of 2⁻⁶².
        let j = (count as i128).wrapping_sub(self.mode as i128);
        let difference = ((j << 1 | 1) << 62).wrapping_add(self.off as i128);
        let size = difference.unsigned_abs();
        if size == 0 {
            return probability;
        }
        let zeros = size.leading_zeros();
        let size = Long::of(
            (size.wrapping_shl(zeros) >> 64) as u64,
            66_i32.wrapping_sub_unsigned(zeros),
        );
        let ratio = exp_neg(size.times(self.rate));
        if (difference < 0) == down {
            probability.times(ratio)
        } else {
            probability.over(ratio)
        }
    }
}

/// A number of which products are 0.
pub(super) const NOTHING: Long = Long::of(0, 0);

/// How many words have their middle below a probability in units of 2⁻⁶⁴; without a carry.
pub(super) const fn rounded(below: u64) -> u64 {
    (below >> 31).wrapping_add(1) >> 1
}

/// The probabilities of a success, the parameter of that place, and of a failure.
pub(super) const fn chances(p: f32, place: usize) -> Result<[Long; 2], Error> {
    let p = tried!(finite(p, place));
    if p < 0.0 || p > 1.0 {
        return Err(Error::OutOfRange(place));
    }
    if p == 0.0 {
        return Ok([NOTHING, Long::ONE]);
    }
    let success = Long::of_f32(p);
    if p >= 1.0 {
        return Ok([success, NOTHING]);
    }
    // Below 2⁻⁶⁴ the other probability is 1.
    Ok(match success.fraction() {
        0 => [success, Long::ONE],
        part => [success, Long::of(part.wrapping_neg(), 0)],
    })
}

/// The same of a ratio of integers, of which the whole is the parameter of that place.
pub(super) const fn chances_of(part: u32, whole: u32, place: usize) -> Result<[Long; 2], Error> {
    if whole == 0 {
        return Err(Error::NotPositive(place));
    }
    let Some(other) = whole.checked_sub(part) else {
        return Err(Error::OutOfRange(place));
    };
    // As of a probability of 0 and of 1.
    if part == 0 {
        return Ok([NOTHING, Long::ONE]);
    }
    if other == 0 {
        return Ok([Long::of_f32(1.0), NOTHING]);
    }
    let whole = Long::of(whole as u64, 64);
    Ok([
        Long::of(part as u64, 64).over(whole),
        Long::of(other as u64, 64).over(whole),
    ])
}

impl Law {
    /// The smallest and the largest count.
    pub(super) const fn range(&self) -> [u32; 2] {
        match self.kind {
            Kind::Trials(trials) => [0, trials],
            Kind::Failures(_) | Kind::Squares(_) => [0, u32::MAX],
            Kind::Urn {
                population,
                marked,
                drawn,
            } => [
                // More than the others are drawn.
                drawn.saturating_sub(population.saturating_sub(marked)),
                if drawn < marked { drawn } else { marked },
            ],
        }
    }

    /// The ratio of integers for a count and the next: above 0 within the range.
    const fn ratio(&self, count: u32) -> [u64; 2] {
        let next = (count as u64).wrapping_add(1);
        match self.kind {
            Kind::Trials(trials) => [trials.wrapping_sub(count) as u64, next],
            Kind::Failures(successes) => {
                [((count as u64) << 31).wrapping_add(successes), next << 31]
            }
            Kind::Squares(_) => [1, 1],
            Kind::Urn {
                population,
                marked,
                drawn,
            } => {
                let (marked_left, undrawn) =
                    (marked.wrapping_sub(count), drawn.wrapping_sub(count));
                // Of those that are neither, one more than the next count leaves.
                let others = (population.wrapping_sub(marked) as u64)
                    .wrapping_sub(drawn as u64)
                    .wrapping_add(next);
                [
                    (marked_left as u64).wrapping_mul(undrawn as u64),
                    next.wrapping_mul(others),
                ]
            }
        }
    }

    /// The probability of the next count from that of a count below the largest.
    const fn above(&self, count: u32, probability: Long) -> Long {
        if let Kind::Squares(squares) = self.kind {
            return squares.step(count, probability, false);
        }
        let [more, less] = self.ratio(count);
        let ratio = Long::of(more, 64).over(Long::of(less, 64));
        probability.times(self.odds).times(ratio)
    }

    /// The probability of the count before from that of a count above the smallest.
    const fn below(&self, count: u32, probability: Long) -> Long {
        if let Kind::Squares(squares) = self.kind {
            return squares.step(count.wrapping_sub(1), probability, true);
        }
        let [less, more] = self.ratio(count.wrapping_sub(1));
        let ratio = Long::of(more, 64).over(Long::of(less, 64));
        probability.times(self.inverse).times(ratio)
    }
}

/// The last word of each count that has words, and the law around its mode.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Ends<const N: usize> {
    /// The count of the largest probability, but for rounding, and this probability.
    mode: u32,
    peak: Long,
    /// The smallest count that a word gives.
    first: u32,
    /// The last word of this count and of those behind it.
    last: [u32; N],
}

impl<const N: usize> Ends<N> {
    /// The table of a law, of which the counts that words give are at most `N`, and the largest probability is at least 2⁻⁶.
    pub(super) const fn of(law: &Law, mode: u32) -> Self {
        let [least, most] = law.range();
        // 1/64 in place of this probability: the sum of all stays below 1, and what is left out is below 2⁻⁵⁰ of it.
        let start = Long::of(1, 58);
        let (mut sum, mut lowest, mut count) = (start.fraction(), start, mode);
        while count > least {
            let next = law.below(count, lowest);
            if next.fraction() == 0 {
                break;
            }
            sum = sum.wrapping_add(next.fraction());
            lowest = next;
            count = count.wrapping_sub(1);
        }
        let (mut next, mut up) = (start, mode);
        while up < most {
            next = law.above(up, next);
            if next.fraction() == 0 {
                break;
            }
            sum = sum.wrapping_add(next.fraction());
            up = up.wrapping_add(1);
        }
        let whole = Long::of(sum, 0);
        let (mut probability, mut below) = (lowest.over(whole), 0_u64);
        let (mut last, mut first) = ([u32::MAX; N], count);
        let mut rest: &mut [u32] = &mut last;
        while count < most {
            below = below.saturating_add(probability.fraction());
            probability = law.above(count, probability);
            count = count.wrapping_add(1);
            match rest {
                _ if rounded(below) == 0 => first = count,
                [slot, others @ ..] => {
                    *slot = rounded(below).wrapping_sub(1) as u32;
                    rest = others;
                }
                [] => break,
            }
        }
        Self {
            mode,
            peak: start.over(whole),
            first,
            last,
        }
    }

    /// The count of the largest probability, but for rounding.
    pub(super) const fn mode(&self) -> u32 {
        self.mode
    }

    /// The count of a word.
    #[inline]
    pub(super) fn count(&self, word: u32) -> u32 {
        // The last end is the last word, so this is one of the counts.
        let passed = self.last.partition_point(|&last| last < word);
        self.first.wrapping_add(passed as u32)
    }

    /// The words that give a count.
    pub(super) fn words_of(&self, count: u32) -> Option<RangeInclusive<u32>> {
        let place = count.checked_sub(self.first)? as usize;
        let last = *self.last.get(place)?;
        let Some(before) = place.checked_sub(1) else {
            return Some(0..=last);
        };
        let before = *self.last.get(before)?;
        (before < last).then(|| before.wrapping_add(1)..=last)
    }

    /// The probability of a count.
    pub(super) fn pmf(&self, law: &Law, count: u32) -> f32 {
        /// Below this exponent numbers are far below the smallest `f32`, and become smaller with each step.
        const NONE: i32 = -200;
        let (mut at, mut probability) = (self.mode, self.peak);
        let [least, most] = law.range();
        if count < least || count > most {
            return 0.0;
        }
        while at < count && probability.exponent > NONE {
            probability = law.above(at, probability);
            at = at.wrapping_add(1);
        }
        while at > count && probability.exponent > NONE {
            probability = law.below(at, probability);
            at = at.wrapping_sub(1);
        }
        probability.value()
    }
}
