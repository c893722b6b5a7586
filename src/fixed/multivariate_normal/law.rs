//! The law in bits: the same in every format but for the density at its mean.

use super::super::direction::{Scaled, UNIT, square_of};
use super::super::grade::Grade;
use super::super::kernel::product::near_of_signed;
use super::super::normal::{around, bell, outside, radius};
use super::super::{Coordinate, Density, Uniform};
use super::factor::{Factors, Rows, at, entry, put};
use crate::error::{Error, tried};
use crate::num::division::{fraction, scaled};

/// A law whose numbers are the bits of a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Law<const D: usize> {
    pub means: [i32; D],
    /// σ, shifted until 31 bits are set, and by how much. 0 stays.
    pub deviations: [u32; D],
    pub shifts: [u8; D],
    /// Rows of L times these deviations. Products with numbers in Q27 are 2⁵ too small.
    pub factor: Rows<i32, D>,
    /// How many steps a coordinate that is not free may be off what the free ones say.
    slack: [u32; D],
    /// First the free coordinates, in the order in which each follows from those before it, then the others.
    order: [u8; D],
    pub rank: u8,
    /// The density at the mean.
    peak: Scaled,
}

/// 1/√2π.
const PER_ROOT_TAU: Scaled = Scaled::normal(1_713_444_047, 0);

/// How far points lie from their means, at most, of a deviation in steps.
const fn reach(deviation: i32, numbers: usize) -> i64 {
    /// 6.67², of each pair.
    const SQUARE: u64 = 2_915_625;
    // In Q32; a step for rounding.
    let squares = (((numbers as u64 + 1) >> 1) * SQUARE) << 16;
    ((deviation as i64 * (squares.isqrt() as i64 + 1)) >> 16) + 1
}

impl<const D: usize> Law<D> {
    /// Of bits that have so many after the point.
    pub(super) const fn new(
        means: [i32; D],
        deviations: [i32; D],
        correlations: &Rows<Coordinate, D>,
        fraction: i32,
    ) -> Result<Self, Error> {
        if D < 1 {
            return Err(Error::Empty(Error::NO_PLACE));
        }
        let mut law = Self {
            means,
            deviations: [0; D],
            shifts: [5; D],
            factor: [[0; D]; D],
            slack: [0; D],
            order: [0; D],
            rank: 0,
            peak: UNIT,
        };
        let (mut varies, mut i) = ([false; D], 0);
        while i < D {
            let mean = at(&means, i, 0);
            let deviation = at(&deviations, i, 0);
            if deviation < 0 {
                return Err(Error::Negative(1));
            }
            let room = i32::MAX as i64 - reach(deviation, D);
            if deviation >= 1 << 26 || (deviation > 0 && mean.unsigned_abs() as i64 > room) {
                return Err(Error::TooLarge(1));
            }
            if deviation > 0 {
                let shift = deviation.leading_zeros() - 1;
                put(&mut law.deviations, i, (deviation as u32) << shift);
                put(&mut law.shifts, i, shift as u8);
                put(&mut varies, i, true);
            }
            i += 1;
        }
        let factors = tried!(Factors::new(correlations, varies));
        law.order = factors.order;
        law.rank = factors.rank as u8;
        law.scale(&factors, fraction);
        law.allow(&factors);
        Ok(law)
    }

    /// Takes over the factor, in the units of the deviations, and the density at the mean.
    const fn scale(&mut self, factors: &Factors<D>, fraction: i32) {
        let (mut peak, mut i) = (UNIT, 0);
        while i < D {
            let (mut row, mut j) = ([0; D], 0);
            let own = at(&self.deviations, i, 0);
            while j < D {
                let part = entry(&factors.factor, i, j);
                // At most 2³¹ · 2³².
                let product = part.unsigned_abs() * own as u64;
                let nearest = (product >> 31).div_ceil(2);
                let most = i32::MAX as u64;
                let magnitude = if nearest < most { nearest } else { most } as i32;
                put(&mut row, j, if part < 0 { -magnitude } else { magnitude });
                j += 1;
            }
            put(&mut self.factor, i, row);
            let (root, digits) = at(&factors.diagonal, i, (0, 0));
            if root > 0 {
                let shift = at(&self.shifts, i, 0) as i32;
                let deviation = Scaled::of(own as u64, fraction + shift);
                let own = deviation.times(Scaled::of(root as u64, digits));
                let own = Scaled::normal(own.mantissa, own.exponent);
                peak = peak.over(own).times(PER_ROOT_TAU);
                peak = Scaled::normal(peak.mantissa, peak.exponent);
            }
            i += 1;
        }
        // Any larger one exceeds the largest density just so.
        if peak.exponent < -63 {
            peak.exponent = -63;
        }
        self.peak = peak;
    }

    /// What rounding of a point to its steps does to z, in Q32, and to what the free coordinates say of the others.
    const fn allow(&mut self, factors: &Factors<D>) {
        /// What the products of a sample cut, in each.
        const CUT: u128 = 3 << 5;
        let (mut errors, mut place) = ([0_u128; D], 0);
        while place < D {
            let i = at(&self.order, place, 0) as usize;
            let row = at(&self.factor, i, [0; D]);
            let shift = at(&self.shifts, i, 0);
            let (mut off, mut j) = (((1 << shift) + CUT * D as u128) << 32, 0);
            while j < D {
                off += at(&row, j, 0).unsigned_abs() as u128 * at(&errors, j, 0);
                j += 1;
            }
            if place < factors.rank {
                // By the order, what others add is at most three times as much for each of them, so that 2⁹⁰ is out of reach.
                let own = at(&row, i, 1) as u128;
                put(&mut errors, i, scaled(off, own << 90, 90).0 + 1);
            } else if at(&self.deviations, i, 0) > 0 {
                let steps = (off >> 32 >> shift) + 1;
                let most = u32::MAX as u128;
                put(
                    &mut self.slack,
                    i,
                    if steps < most { steps } else { most } as u32,
                );
            }
            place += 1;
        }
    }

    /// The standard deviations.
    pub(super) const fn steps(&self) -> [i32; D] {
        let (mut steps, mut i) = ([0; D], 0);
        while i < D {
            let deviation = at(&self.deviations, i, 0) >> at(&self.shifts, i, 0);
            put(&mut steps, i, deviation as i32);
            i += 1;
        }
        steps
    }

    /// L, as the law hands it over.
    pub(super) const fn factor(&self) -> Rows<Coordinate, D> {
        let (mut factor, mut i) = ([[Coordinate::ZERO; D]; D], 0);
        while i < D {
            let (mut parts, mut j) = ([Coordinate::ZERO; D], 0);
            let (row, own) = (at(&self.factor, i, [0; D]), at(&self.deviations, i, 0));
            while j < D && own > 0 {
                let part = at(&row, j, 0);
                let twice = scaled(part.unsigned_abs() as u128, own as u128, 31).0 as u64;
                let magnitude = twice.div_ceil(2) as i32;
                let part = if part < 0 { -magnitude } else { magnitude };
                put(&mut parts, j, Coordinate::from_bits(part));
                j += 1;
            }
            put(&mut factor, i, parts);
            i += 1;
        }
        factor
    }

    /// Which coordinates are free.
    pub(super) const fn free(&self) -> [bool; D] {
        let (mut free, mut place) = ([false; D], 0);
        while place < self.rank as usize {
            put(&mut free, at(&self.order, place, 0) as usize, true);
            place += 1;
        }
        free
    }

    /// The point of an even number of words.
    #[inline]
    pub(super) fn point<G: Grade>(&self, words: &[Uniform]) -> [i32; D] {
        let mut z = [0; D];
        let mut numbers = z.iter_mut();
        // Chunks divide by their length where the code is to be small, and may panic.
        let mut words = words.iter();
        while let (Some(u1), Some(u2)) = (words.next(), words.next()) {
            for x in around::<G>(radius::<G>(u1.to_bits()), u2.to_bits()) {
                if let Some(z) = numbers.next() {
                    *z = x;
                }
            }
        }
        let mut point = self.means;
        for ((x, row), shift) in point.iter_mut().zip(&self.factor).zip(&self.shifts) {
            // No sum of the first of them exceeds their lengths' product, either.
            let off = row
                .iter()
                .zip(&z)
                .fold(0, |sum, (a, z)| sum + near_of_signed(*z, *a));
            let shift = shift - 5;
            *x += (off + ((1 << shift) >> 1)) >> shift;
        }
        point
    }

    #[inline]
    pub(super) fn pdf<G: Grade>(&self, point: &[i32; D]) -> Density {
        let (z, holds) = self.standardised(point);
        if holds {
            let square = z.iter().fold(0_u64, |sum, z| {
                sum.saturating_add(square_of([z.unsigned_abs(), 0]))
            });
            self.peak.density(bell::<G>(square))
        } else {
            Density::ZERO
        }
    }

    /// Writes the words of a point, of which there is an even number.
    #[inline]
    pub(super) fn words<G: Grade>(&self, point: &[i32; D], words: &mut [Uniform]) {
        let (z, _) = self.standardised(point);
        let (mut numbers, mut places) = (z.into_iter(), words.iter_mut());
        while let (Some(u1), Some(u2)) = (places.next(), places.next()) {
            let (x, y) = (
                numbers.next().unwrap_or_default(),
                numbers.next().unwrap_or_default(),
            );
            let square = square_of([x.unsigned_abs(), y.unsigned_abs()]);
            *u1 = Uniform::from_bits(outside::<G>(square));
            *u2 = Uniform::from_bits(G::angle(y, x));
        }
    }

    /// z, and whether the coordinates that are not free are what the free ones say.
    #[inline]
    pub(super) fn standardised(&self, point: &[i32; D]) -> ([i32; D], bool) {
        let (mut z, mut holds) = ([0; D], true);
        for (place, i) in self.order.iter().enumerate() {
            let i = usize::from(*i);
            let (x, mean) = (at(point, i, 0), at(&self.means, i, 0));
            let shift = at(&self.shifts, i, 0);
            let (Some(row), Some(slack)) = (self.factor.get(i), self.slack.get(i)) else {
                continue;
            };
            let said = row.iter().zip(&z).fold(0, |sum, (a, z)| {
                sum + ((i64::from(*a) * i64::from(*z)) >> 27)
            });
            let off = ((i64::from(x) - i64::from(mean)) << shift) - said;
            if place < usize::from(self.rank) {
                put(&mut z, i, quotient(off, at(row, i, 0)));
            } else {
                holds &= off.unsigned_abs() >> shift <= u64::from(*slack);
            }
        }
        (z, holds)
    }
}

/// a/b in Q27 and to the nearest, at most 16, of a positive b.
#[inline]
fn quotient(a: i64, b: i32) -> i32 {
    let (magnitude, most) = (a.unsigned_abs(), u64::from(b.unsigned_abs()) << 4);
    let word = if magnitude < most {
        fraction(magnitude, most).0.div_ceil(2)
    } else {
        1 << 31
    };
    if a < 0 {
        word.wrapping_neg() as i32
    } else {
        word.min(i32::MAX as u32) as i32
    }
}
