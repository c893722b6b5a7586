//! Apportionment: from exact sums of weights to whole numbers of words, the arithmetic behind every table. All of
//! it is `const`.

use super::weights::Weights;
use crate::error::Error;
use crate::num::division::Divisor;

/// Turns weights, one by one, into the number of words below the end of each.
///
/// The rule. Where no positive weight is below a step, the end of entry i is the smallest word that is not below
/// 2^bits · (w₀ + … + wᵢ)/(w₀ + w₁ + …). An entry then has the words that real-valued selection gives it, at 24,
/// 32 and 64 bits alike. Where a positive weight is below a step, it is given one step, and the others make room.
/// With 32 bits no other may move by more than a step from its share, or the table is refused. With 64 bits the
/// others lose what it takes, which is below 2⁻⁴⁰ altogether.
pub(crate) struct Apportionment<'a> {
    weights: Weights<'a>,
    bits: u32,
    total: Divisor,
    /// The sum of the weights so far.
    sum: u128,
    /// The end of the last entry.
    end: u128,
    /// Whether some positive weight is below a step.
    crowded: bool,
    /// How many steps all entries to come need at least, where the table is crowded.
    needed: u128,
    /// The last entry of positive weight.
    last: usize,
}

impl<'a> Apportionment<'a> {
    /// The same of weights that may have been refused.
    pub(crate) const fn of(weights: Result<Weights<'a>, Error>, bits: u32) -> Result<Self, Error> {
        match weights {
            Ok(weights) => Self::new(weights, bits),
            Err(error) => Err(error),
        }
    }

    pub(crate) const fn new(weights: Weights<'a>, bits: u32) -> Result<Self, Error> {
        let (mut total, mut smallest) = (0_u128, u128::MAX);
        let (mut index, mut least, mut last) = (0_usize, 0, 0);
        let mut scan = weights;
        while let Some(weight) = scan.next() {
            if weight > 0 {
                last = index;
                if weight < smallest {
                    (smallest, least) = (weight, index);
                }
            }
            total = total.wrapping_add(weight);
            index = index.wrapping_add(1);
        }
        if total == 0 {
            return Err(Error::AllZero);
        }
        let total = Divisor::of(total);
        let mut ends = Self {
            weights,
            bits,
            total,
            sum: 0,
            end: 0,
            crowded: total.scaled(smallest, bits).0 == 0,
            needed: 0,
            last,
        };
        if ends.crowded {
            let mut scan = weights;
            while let Some(weight) = scan.next() {
                ends.needed = ends.needed.wrapping_add(ends.bounds(weight).0);
            }
            if ends.needed > ends.words() {
                return Err(Error::Unreachable(least));
            }
        }
        Ok(ends)
    }

    /// How many words there are.
    const fn words(&self) -> u128 {
        1_u128.wrapping_shl(self.bits)
    }

    /// The fewest and the most steps an entry of a crowded table may be given.
    const fn bounds(&self, weight: u128) -> (u128, u128) {
        if weight == 0 {
            return (0, 0);
        }
        if self.bits > 32 {
            return (1, self.words());
        }
        let (whole, inexact) = self.total.scaled(weight, self.bits);
        let fewest = if inexact {
            whole
        } else {
            whole.saturating_sub(1)
        };
        (if fewest > 0 { fewest } else { 1 }, whole.wrapping_add(1))
    }

    /// The end of the next entry, which has this weight.
    #[allow(
        clippy::inline_always,
        reason = "otherwise all it keeps lies in memory; small cores lack the room"
    )]
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    const fn climb(&mut self, weight: u128) -> u128 {
        if weight == 0 {
            return self.end;
        }
        self.sum = self.sum.wrapping_add(weight);
        let (whole, inexact) = self.total.scaled(self.sum, self.bits);
        let mut end = whole.wrapping_add(inexact as u128);
        if self.crowded {
            let (fewest, most) = self.bounds(weight);
            self.needed = self.needed.wrapping_sub(fewest);
            let room = self.words().wrapping_sub(self.needed);
            let (low, high) = (self.end.wrapping_add(fewest), self.end.wrapping_add(most));
            let high = if high < room { high } else { room };
            if end > high {
                end = high;
            }
            if end < low {
                end = low;
            }
        }
        self.end = end;
        end
    }

    /// The last entry of positive weight.
    pub(crate) const fn last(&self) -> usize {
        self.last
    }

    /// How many words lie below the end of the next entry.
    #[allow(
        clippy::inline_always,
        reason = "otherwise all it keeps lies in memory; small cores lack the room"
    )]
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    pub(crate) const fn next(&mut self) -> Option<u128> {
        match self.weights.next() {
            Some(weight) => Some(self.climb(weight)),
            None => None,
        }
    }
}
