//! Weights as integers in one common unit, so that their sums are exact. All of it is `const`.
//!
//! `apportionment` divides the words of a table by these sums.

use super::zones::Zones;
use super::{MAX_ENTRIES, WEIGHT_BITS};
use crate::error::Error;

/// Bits of the sum of all weights: 128 bits then have room for a shift by 32.
const SUM_BITS: u32 = 95;

const _: () = assert!(
    WEIGHT_BITS + MAX_ENTRIES.trailing_zeros() <= SUM_BITS,
    "as many weights of so many bits overflow the sum"
);

/// Weights, one after the other, as integers in one unit.
#[derive(Clone, Copy)]
pub(crate) enum Weights<'a> {
    Floats {
        weights: &'a [f32],
        unit: Unit,
    },
    Integers(&'a [u32]),
    /// The sums of neighbours, one less in number than the weights, and then 0.
    Neighbours {
        weights: &'a [f32],
        unit: Unit,
    },
    /// The sums of rows of so many columns, times what a row weighs; and the row that is next.
    Rows {
        weights: &'a [f32],
        columns: usize,
        unit: Unit,
        zones: Zones,
        row: usize,
    },
    /// Sums of one unit.
    Sums(&'a [u128]),
}

/// The unit in which weights are integers: how far the significand of the largest is shifted up.
#[derive(Clone, Copy)]
pub(crate) struct Unit {
    /// The exponent field of the largest weight.
    largest: u32,
    shift: u32,
    /// How many bits the significand of the largest weight is short of 24: 0 unless it is subnormal.
    short: u32,
}

/// The exponent field and the significand of a weight, whose value is significand · 2^(field - 150).
pub(crate) const fn decode(weight: f32) -> (u32, u32) {
    let bits = weight.to_bits() & 0x7fff_ffff;
    let (field, fraction) = (bits >> 23, bits & 0x007f_ffff);
    if field == 0 {
        (1, fraction)
    } else {
        (field, fraction | 0x0080_0000)
    }
}

/// What a first pass over weights finds: whether all of them are valid, and the largest.
pub(crate) struct Scan {
    /// The bits of the largest weight; those of positive numbers are in their order.
    largest: u32,
    entries: usize,
}

impl Scan {
    pub(crate) const fn new() -> Self {
        Self {
            largest: 0,
            entries: 0,
        }
    }

    /// Goes over more weights.
    pub(crate) const fn over(mut self, weights: &[f32]) -> Result<Self, Error> {
        let mut rest = weights;
        while let Some((&weight, others)) = rest.split_first() {
            if !weight.is_finite() {
                return Err(Error::NotFiniteWeight(self.entries));
            }
            if weight < 0.0 {
                return Err(Error::NegativeWeight(self.entries));
            }
            // A zero may have a sign.
            let bits = weight.to_bits() & 0x7fff_ffff;
            if bits > self.largest {
                self.largest = bits;
            }
            rest = others;
            self.entries = self.entries.wrapping_add(1);
        }
        Ok(self)
    }

    /// The unit of the weights: as fine as their number allows.
    ///
    /// The largest keeps all its bits, and so does every other unless it is smaller by more than 2^47 (among
    /// 2²⁴ weights) to 2^71 (a single one). Smaller weights lose bits, but never their last.
    pub(crate) const fn unit(&self) -> Result<Unit, Error> {
        if let Err(error) = check_number(self.entries) {
            return Err(error);
        }
        if self.largest == 0 {
            return Err(Error::AllZero);
        }
        let crowd = usize::BITS.wrapping_sub(self.entries.wrapping_sub(1).leading_zeros());
        let (field, significand) = decode(f32::from_bits(self.largest));
        Ok(Unit {
            largest: field,
            shift: SUM_BITS.wrapping_sub(24).wrapping_sub(crowd),
            short: significand.leading_zeros().wrapping_sub(8),
        })
    }
}

impl Unit {
    const fn of(weights: &[f32]) -> Result<Self, Error> {
        // First, so that no pass is longer than the largest table.
        if let Err(error) = check_number(weights.len()) {
            return Err(error);
        }
        match Scan::new().over(weights) {
            Ok(scan) => scan.unit(),
            Err(error) => Err(error),
        }
    }

    /// Twice the unit.
    const fn coarser(self) -> Self {
        Self {
            largest: self.largest,
            shift: self.shift.wrapping_sub(1),
            short: self.short,
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

    /// A weight in a unit of which the largest has from 2³¹ to 2³², rounded down.
    pub(crate) const fn word(self, weight: f32) -> u32 {
        let down = self.shift.wrapping_sub(8).wrapping_sub(self.short);
        self.units(weight).wrapping_shr(down) as u32
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
pub(crate) const fn check_number(entries: usize) -> Result<(), Error> {
    if entries == 0 {
        Err(Error::NoWeights)
    } else if entries > MAX_ENTRIES {
        Err(Error::TooManyWeights)
    } else {
        Ok(())
    }
}

impl<'a> Weights<'a> {
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

    /// The sums of neighbours: as many numbers as there are weights, of which the last is 0.
    pub(crate) const fn neighbours(weights: &'a [f32]) -> Result<Self, Error> {
        if weights.len() < 2 {
            return Err(Error::NoWeights);
        }
        match Unit::of(weights) {
            Ok(unit) => Ok(Self::Neighbours {
                weights,
                // A bit of room, because nearly every weight is in two sums.
                unit: unit.coarser(),
            }),
            Err(error) => Err(error),
        }
    }

    /// The sums of the rows of a table of so many columns, times what a row weighs.
    pub(crate) const fn rows(
        weights: &'a [f32],
        columns: usize,
        zones: Zones,
    ) -> Result<Self, Error> {
        if columns == 0 {
            return Err(Error::NoWeights);
        }
        match Unit::of(weights) {
            Ok(unit) => Ok(Self::Rows {
                weights,
                columns,
                unit,
                zones,
                row: 0,
            }),
            Err(error) => Err(error),
        }
    }

    /// The next weight; nothing after the last.
    #[allow(
        clippy::inline_always,
        reason = "half of what building a table takes goes to this choice; small cores lack the room"
    )]
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    pub(crate) const fn next(&mut self) -> Option<u128> {
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
            Self::Neighbours { weights, unit } => match weights.split_first() {
                Some((&weight, rest)) => {
                    *weights = rest;
                    Some(match rest.first() {
                        Some(&next) => unit.units(weight).wrapping_add(unit.units(next)),
                        None => 0,
                    })
                }
                None => None,
            },
            Self::Rows {
                weights,
                columns,
                unit,
                zones,
                row: index,
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
                let sum = zones.weigh(unit.sum(row), *index);
                *index = index.wrapping_add(1);
                Some(sum)
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
