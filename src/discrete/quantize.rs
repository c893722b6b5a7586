//! From weights to whole numbers of steps: the exact arithmetic behind every table, all of it `const`.
//!
//! Weights become integers in one common unit, their prefix sums are exact, and each prefix sum becomes
//! the number of words below it. What is done with these numbers is not said here.

use super::MAX_ENTRIES;
use super::division::scaled;
use crate::error::Error;

/// Bits of the sum of all weights: what leaves room for a shift by 32 in 128 bits.
const SUM_BITS: u32 = 95;

/// Where weights come from, one after the other, as integers in one unit.
#[derive(Clone, Copy)]
pub(crate) enum Source<'a> {
    Floats {
        weights: &'a [f32],
        unit: Unit,
    },
    Integers(&'a [u32]),
    /// The sums of rows of so many columns.
    Rows {
        weights: &'a [f32],
        columns: usize,
        unit: Unit,
    },
    /// Sums of one unit.
    Sums(&'a [u128]),
}

/// The unit in which weights are integers: how far the mantissa of the largest is shifted up.
#[derive(Clone, Copy)]
pub(crate) struct Unit {
    /// The exponent field of the largest weight.
    largest: u32,
    shift: u32,
}

/// The exponent field and the significand of a weight, whose value is significand · 2^(field - 150).
const fn decode(weight: f32) -> (u32, u32) {
    let bits = weight.to_bits() & 0x7fff_ffff;
    let (field, fraction) = (bits >> 23, bits & 0x007f_ffff);
    if field == 0 {
        (1, fraction)
    } else {
        (field, fraction | 0x0080_0000)
    }
}

/// What a first look over weights finds: whether all of them are weights, and the largest.
pub(crate) struct Scan {
    largest: u32,
    positive: bool,
    entries: usize,
}

impl Scan {
    pub(crate) const fn new() -> Self {
        Self {
            largest: 0,
            positive: false,
            entries: 0,
        }
    }

    /// Looks over more weights.
    pub(crate) const fn over(mut self, weights: &[f32]) -> Result<Self, Error> {
        let mut rest = weights;
        while let Some((&weight, others)) = rest.split_first() {
            if !weight.is_finite() {
                return Err(Error::NotFiniteWeight(self.entries));
            }
            if weight < 0.0 {
                return Err(Error::NegativeWeight(self.entries));
            }
            let (field, significand) = decode(weight);
            if field > self.largest {
                self.largest = field;
            }
            self.positive = self.positive || significand > 0;
            rest = others;
            self.entries = self.entries.wrapping_add(1);
        }
        Ok(self)
    }

    /// The unit of the weights: as fine as their number allows.
    ///
    /// The largest is kept with all its bits, and so is every other that is not smaller by more than
    /// 2^(47..71), by number; below that bits are dropped, but never the last.
    pub(crate) const fn unit(&self) -> Result<Unit, Error> {
        if let Err(error) = check_number(self.entries) {
            return Err(error);
        }
        if !self.positive {
            return Err(Error::AllZero);
        }
        let crowd = usize::BITS.wrapping_sub(self.entries.wrapping_sub(1).leading_zeros());
        Ok(Unit {
            largest: self.largest,
            shift: SUM_BITS.wrapping_sub(24).wrapping_sub(crowd),
        })
    }
}

impl Unit {
    const fn of(weights: &[f32]) -> Result<Self, Error> {
        // First, so that no more is looked at than a table may hold.
        if let Err(error) = check_number(weights.len()) {
            return Err(error);
        }
        match Scan::new().over(weights) {
            Ok(scan) => scan.unit(),
            Err(error) => Err(error),
        }
    }

    /// The sum of some weights in this unit.
    pub(crate) const fn sum(self, weights: &[f32]) -> u128 {
        let mut sum = 0_u128;
        let mut rest = weights;
        while let Some((&weight, others)) = rest.split_first() {
            sum = sum.wrapping_add(self.units(weight));
            rest = others;
        }
        sum
    }

    /// A weight in this unit; a positive one is at least 1.
    const fn units(self, weight: f32) -> u128 {
        let (field, significand) = decode(weight);
        if significand == 0 {
            return 0;
        }
        let below = self.largest.wrapping_sub(field);
        if below <= self.shift {
            return (significand as u128).wrapping_shl(self.shift.wrapping_sub(below));
        }
        let kept = match significand.checked_shr(below.wrapping_sub(self.shift)) {
            Some(kept) => kept,
            None => 0,
        };
        if kept > 0 { kept as u128 } else { 1 }
    }
}

/// Refuses a table without entries and one with too many.
const fn check_number(entries: usize) -> Result<(), Error> {
    if entries == 0 {
        Err(Error::NoWeights)
    } else if entries > MAX_ENTRIES {
        Err(Error::TooManyWeights)
    } else {
        Ok(())
    }
}

impl<'a> Source<'a> {
    pub(crate) const fn floats(weights: &'a [f32]) -> Result<Self, Error> {
        match Unit::of(weights) {
            Ok(unit) => Ok(Self::Floats { weights, unit }),
            Err(error) => Err(error),
        }
    }

    pub(crate) const fn integers(weights: &'a [u32]) -> Result<Self, Error> {
        match check_number(weights.len()) {
            Ok(()) => Ok(Self::Integers(weights)),
            Err(error) => Err(error),
        }
    }

    /// The sums of the rows of a table of so many columns.
    pub(crate) const fn rows(weights: &'a [f32], columns: usize) -> Result<Self, Error> {
        if columns == 0 {
            return Err(Error::NoWeights);
        }
        match Unit::of(weights) {
            Ok(unit) => Ok(Self::Rows {
                weights,
                columns,
                unit,
            }),
            Err(error) => Err(error),
        }
    }

    /// The next weight; nothing after the last.
    const fn next(&mut self) -> Option<u128> {
        match self {
            Self::Floats { weights, unit } => match weights.split_first() {
                Some((&weight, rest)) => {
                    *weights = rest;
                    Some(unit.units(weight))
                }
                None => None,
            },
            Self::Integers(weights) => match weights.split_first() {
                Some((&weight, rest)) => {
                    *weights = rest;
                    Some(weight as u128)
                }
                None => None,
            },
            Self::Rows {
                weights,
                columns,
                unit,
            } => {
                if weights.is_empty() {
                    return None;
                }
                // A last row that is too short ends with the weights.
                let (row, rest) = match weights.split_at_checked(*columns) {
                    Some(halves) => halves,
                    None => (*weights, [].as_slice()),
                };
                *weights = rest;
                Some(unit.sum(row))
            }
            Self::Sums(sums) => match sums.split_first() {
                Some((&sum, rest)) => {
                    *sums = rest;
                    Some(sum)
                }
                None => None,
            },
        }
    }
}

/// Turns weights one by one into the number of words below the end of each.
///
/// The rule. Where no positive weight is below a step, the end of entry i is the smallest word that is
/// not below 2^bits · (w₀ + … + wᵢ)/(w₀ + w₁ + …): the words of an entry are those that the real-valued
/// selection gives it, at 24, 32 and 64 bits alike. Where one is, it is given a step, and the others make
/// room: with 32 bits none of them by more than a step from its share, or the table is refused; with 64
/// bits by what it takes, which is below 2⁻⁴⁰ altogether.
#[derive(Clone, Copy)]
pub(crate) struct Ladder {
    bits: u32,
    total: u128,
    /// The entries so far, as a sum of weights.
    sum: u128,
    /// The end of the last entry.
    end: u128,
    /// How many steps all the entries to come need at least.
    needed: u128,
    /// Whether some positive weight is below a step.
    crowded: bool,
    /// The last entry of positive weight.
    pub(crate) last: usize,
}

impl Ladder {
    pub(crate) const fn new(source: Source<'_>, bits: u32) -> Result<Self, Error> {
        let mut ladder = Self {
            bits,
            total: 0,
            sum: 0,
            end: 0,
            needed: 0,
            crowded: false,
            last: 0,
        };
        let (mut smallest, mut least, mut index) = (u128::MAX, 0, 0_usize);
        let mut scan = source;
        while let Some(weight) = scan.next() {
            if weight > 0 {
                ladder.last = index;
                if weight < smallest {
                    (smallest, least) = (weight, index);
                }
            }
            ladder.total = ladder.total.wrapping_add(weight);
            index = index.wrapping_add(1);
        }
        if ladder.total == 0 {
            return Err(Error::AllZero);
        }
        ladder.crowded = scaled(smallest, ladder.total, bits).0 == 0;
        let mut scan = source;
        while let Some(weight) = scan.next() {
            ladder.needed = ladder.needed.wrapping_add(ladder.bounds(weight).0);
        }
        if ladder.needed > ladder.words() {
            return Err(Error::Unreachable(least));
        }
        Ok(ladder)
    }

    /// How many words there are.
    const fn words(&self) -> u128 {
        1_u128.wrapping_shl(self.bits)
    }

    /// The fewest and the most steps an entry may be given.
    const fn bounds(&self, weight: u128) -> (u128, u128) {
        if weight == 0 {
            return (0, 0);
        }
        if !self.crowded || self.bits > 32 {
            return (1, self.words());
        }
        let (whole, inexact) = scaled(weight, self.total, self.bits);
        let fewest = if inexact {
            whole
        } else {
            whole.saturating_sub(1)
        };
        (if fewest > 0 { fewest } else { 1 }, whole.wrapping_add(1))
    }

    /// The end of the next entry, whose weight this is.
    const fn climb(&mut self, weight: u128) -> u128 {
        if weight == 0 {
            return self.end;
        }
        self.sum = self.sum.wrapping_add(weight);
        let (whole, inexact) = scaled(self.sum, self.total, self.bits);
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
}

/// The ends of all entries in turn.
pub(crate) struct Ends<'a> {
    source: Source<'a>,
    ladder: Ladder,
}

impl<'a> Ends<'a> {
    pub(crate) const fn new(source: Source<'a>, bits: u32) -> Result<Self, Error> {
        match Ladder::new(source, bits) {
            Ok(ladder) => Ok(Self { source, ladder }),
            Err(error) => Err(error),
        }
    }

    /// The last entry of positive weight.
    pub(crate) const fn last(&self) -> usize {
        self.ladder.last
    }

    /// How many words lie below the end of the next entry.
    pub(crate) const fn next(&mut self) -> Option<u128> {
        match self.source.next() {
            Some(weight) => Some(self.ladder.climb(weight)),
            None => None,
        }
    }
}
