//! A running sum of weights of any size, in fixed memory, for selection without a table.

use super::weights::decode;
use crate::error::Error;
use crate::num::division::quotient;
use crate::num::{Long, Scaled, high, representable};

/// A positive number as 64 leading bits and an exponent: mantissa · 2^(exponent − 214), or 0.
///
/// Adding drops what lies below the 64 bits: less than 2⁻⁶³ of the sum each time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Total {
    /// The leading bit is set, unless the number is 0.
    mantissa: u64,
    exponent: i32,
}

/// The exponents of products stay within this, so that they can be added.
const FARTHEST: i32 = 1 << 24;

impl Total {
    pub(crate) const ZERO: Self = Self {
        mantissa: 0,
        exponent: 0,
    };

    /// A weight, exactly. It is the parameter of that place.
    pub(crate) const fn of(weight: f32, place: usize) -> Result<Self, Error> {
        if !weight.is_finite() {
            return Err(Error::NotFinite(place));
        }
        if weight < 0.0 {
            return Err(Error::Negative(place));
        }
        let (field, significand) = decode(weight);
        if significand == 0 {
            return Ok(Self::ZERO);
        }
        let significand = significand as u64;
        let up = significand.leading_zeros();
        Ok(Self {
            mantissa: significand.wrapping_shl(up),
            exponent: 64_i32
                .wrapping_add_unsigned(field)
                .wrapping_sub_unsigned(up),
        })
    }

    pub(crate) const ONE: Self = Self::of_count(1);

    /// The quotient with all its digits, whatever its size; 0 of nothing. The other is not 0.
    pub(crate) const fn part(self, whole: Self) -> Self {
        if self.is_zero() {
            return Self::ZERO;
        }
        let [of, whole] = [self.long(), whole.long()];
        Self::of_long(of.over(whole))
    }

    const fn long(self) -> Long {
        Long {
            mantissa: self.mantissa,
            exponent: self.exponent.wrapping_sub(150),
        }
    }

    pub(crate) const fn of_long(number: Long) -> Self {
        Self {
            mantissa: number.mantissa,
            exponent: number.exponent.saturating_add(150),
        }
    }

    /// The number of some things, exactly.
    pub(crate) const fn of_count(count: u32) -> Self {
        match count {
            0 => Self::ZERO,
            count => Self::of_long(Long::of(count as u64, 64)),
        }
    }

    pub(crate) const fn of_scaled(number: Scaled) -> Self {
        let (significand, exponent) = number.parts();
        let digits = significand.to_bits() & 0x007f_ffff | 0x0080_0000;
        Self {
            mantissa: (digits as u64) << 40,
            exponent: exponent.saturating_add(151),
        }
    }

    pub(crate) const fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// How far the mantissa of `self` must be shifted down to the exponent of a larger number.
    const fn below(self, larger: Self) -> u32 {
        larger.exponent.wrapping_sub(self.exponent) as u32
    }

    pub(crate) const fn plus(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        let (large, small) = if self.exponent >= other.exponent {
            (self, other)
        } else {
            (other, self)
        };
        let aligned = match small.mantissa.checked_shr(small.below(large)) {
            Some(aligned) => aligned,
            None => 0,
        };
        let (sum, carried) = large.mantissa.overflowing_add(aligned);
        Self {
            mantissa: if carried { sum >> 1 | 1 << 63 } else { sum },
            exponent: large.exponent.wrapping_add(carried as i32),
        }
    }

    /// Adds a part, and says whether a word of 2⁶⁴ falls on it. A part of 0 takes none.
    pub(crate) const fn grow(&mut self, part: Self, word: u64) -> bool {
        if part.is_zero() {
            return false;
        }
        *self = self.plus(part);
        part.contains(word, *self)
    }

    /// The product, cut: less than 2⁻⁶² of it is lost, and nothing where both have 32 bits.
    pub(crate) const fn times(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        let product = high(self.mantissa, other.mantissa);
        let up = product.leading_zeros();
        let exponent = self.exponent.saturating_add(other.exponent);
        let exponent = exponent.saturating_sub_unsigned(up).saturating_sub(150);
        Self {
            mantissa: product.wrapping_shl(up),
            exponent: if exponent > FARTHEST {
                FARTHEST
            } else if exponent < -FARTHEST {
                -FARTHEST
            } else {
                exponent
            },
        }
    }

    /// This times 2³², in units of the last bit of `larger`, and whether bits were dropped.
    const fn aligned(self, larger: Self) -> (u128, bool) {
        let up = (self.mantissa as u128) << 32;
        let below = self.below(larger);
        match up.checked_shr(below) {
            Some(kept) => (kept, kept.wrapping_shl(below) != up),
            None => (0, up > 0),
        }
    }

    /// Whether the point at `word` of 2³² parts of `self` is at or beyond `sum`, which is not above
    /// `self`.
    #[inline]
    pub(crate) const fn reaches(self, word: u32, sum: Self) -> bool {
        let (point, up) = (self.point(word), (sum.mantissa as u128) << 32);
        let below = sum.below(self);
        if below < 32 {
            // A point has 96 bits, so that it can be brought to the units of the sum.
            return point.wrapping_shl(below) >= up;
        }
        let (aligned, dropped) = sum.aligned(self);
        point > aligned || (point == aligned && !dropped)
    }

    /// The point at `word` of 2³² parts of `self`, in units of its last bit over 2³².
    const fn point(self, word: u32) -> u128 {
        (self.mantissa as u128).wrapping_mul(word as u128)
    }

    /// Where the point at `word` and a fraction, of 2³² parts of `self`, lies between `below` and
    /// `below + width`.
    pub(crate) fn place(self, word: u32, fraction: f32, below: Self, width: Self) -> f32 {
        let offset = self.point(word).saturating_sub(below.aligned(self).0);
        let width = width.aligned(self).0;
        // Narrower than one part: then no bits of the uniform are left either.
        if width == 0 {
            return 0.0;
        }
        (offset as f32 + fraction * self.mantissa as f32) / width as f32
    }

    /// Whether a word of 2⁶⁴ falls on this part of `whole`, which is not below it. The first
    /// floor(2⁶⁴ · self/whole) words do, and word 0 does if this is positive.
    pub(crate) const fn contains(self, word: u64, whole: Self) -> bool {
        if self.is_zero() {
            return false;
        }
        let share = match ((self.mantissa as u128) << 64).checked_shr(self.below(whole)) {
            Some(share) => share,
            None => 0,
        };
        // At most 2⁶⁴ times less than 2⁶⁴.
        let next = (word as u128).wrapping_add(1);
        word == 0 || next.wrapping_mul(whole.mantissa as u128) <= share
    }

    /// How often `whole`, which is not below this, is halved before it is at most this: −log₂ of the quotient, rounded up,
    /// also where the quotient as an `f32` rounds to a power of two.
    pub(crate) const fn halvings(self, whole: Self) -> u32 {
        self.below(whole)
            .saturating_add((self.mantissa < whole.mantissa) as u32)
    }

    /// The quotient of this and `whole`, which is not below it, as an `f32`; never 0.
    pub(crate) fn ratio(self, whole: Self) -> f32 {
        // The exponents differ by at most 277 and the growth of a stream, which two powers of two can express.
        let down = self.below(whole).wrapping_add(31);
        let half = down >> 1;
        representable(self.digits(whole) * power(half) * power(down.wrapping_sub(half)))
    }

    /// The quotient of two positive numbers as an `f32`, correctly rounded unless subnormal; positive and finite.
    pub(crate) fn over(self, other: Self) -> f32 {
        let up = self.exponent.saturating_sub(other.exponent);
        let digits = Scaled::of(self.digits(other));
        representable(digits.raised(up.saturating_sub(31)).value())
    }

    /// The quotient of the mantissas times 2³¹.
    fn digits(self, other: Self) -> f32 {
        // It lies between 1/2 and 2. We take 31 or 32 bits of it, and let the last stand for all that follow, so the
        // conversion rounds as that of the exact quotient would.
        let (digits, inexact) = quotient(self.mantissa, other.mantissa);
        (digits | u32::from(inexact)) as f32
    }
}

/// 2^-n for n up to 126, and 0 beyond.
fn power(n: u32) -> f32 {
    f32::from_bits(127_u32.saturating_sub(n) << 23)
}
