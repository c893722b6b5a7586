//! Numbers of 64 bits with a separate exponent, by integer operations alone.

use super::division::scaled;
use super::exact_sum::parts;
use super::scaled::Scaled;
use crate::error::Error;

/// A positive number: mantissa · 2^(exponent − 64).
///
/// Products and quotients are cut, by less than 2⁻⁶² of themselves.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Long {
    /// The leading bit is set.
    pub(crate) mantissa: u64,
    pub(crate) exponent: i32,
}

/// ⌊a·b/2⁶⁴⌋.
#[inline]
pub(crate) const fn high(a: u64, b: u64) -> u64 {
    ((a as u128).wrapping_mul(b as u128) >> 64) as u64
}

impl Long {
    pub(crate) const ONE: Self = Self::of(1, 64);

    /// `mantissa`·2^(exponent − 64) of a mantissa above 0.
    pub(crate) const fn of(mantissa: u64, exponent: i32) -> Self {
        let zeros = mantissa.leading_zeros();
        Self {
            mantissa: mantissa.wrapping_shl(zeros),
            exponent: exponent.saturating_sub_unsigned(zeros),
        }
    }

    /// The quotient of two integers above 0, the first and the second parameter of a constructor.
    pub(crate) const fn of_ratio(part: u32, whole: u32) -> Result<Self, Error> {
        if part == 0 {
            return Err(Error::NotPositive(0));
        }
        if whole == 0 {
            return Err(Error::NotPositive(1));
        }
        Ok(Self::of(part as u64, 64).over(Self::of(whole as u64, 64)))
    }

    /// A positive finite `f32`, exactly.
    pub(crate) const fn of_f32(x: f32) -> Self {
        let (significand, up) = parts(x);
        Self::of(significand, 64 - 149).raised(up)
    }

    const fn raised(self, by: u32) -> Self {
        Self::of(self.mantissa, self.exponent.saturating_add_unsigned(by))
    }

    pub(crate) const fn times(self, other: Self) -> Self {
        let exponent = self.exponent.saturating_add(other.exponent);
        Self::of(high(self.mantissa, other.mantissa), exponent)
    }

    pub(crate) const fn over(self, other: Self) -> Self {
        let divisor = (other.mantissa as u128) << 1;
        let (quotient, _) = scaled(self.mantissa as u128, divisor, 64);
        let exponent = self.exponent.saturating_sub(other.exponent);
        Self::of(quotient as u64, exponent.saturating_add(1))
    }

    /// Whether this number is the larger one.
    pub(crate) const fn exceeds(self, other: Self) -> bool {
        self.exponent > other.exponent
            || (self.exponent == other.exponent && self.mantissa > other.mantissa)
    }

    /// `x` times this number, cut; the product has to fit.
    #[inline]
    pub(crate) const fn of_this(self, x: u64) -> u64 {
        let (product, shift) = (high(x, self.mantissa), self.exponent.unsigned_abs());
        if self.exponent >= 0 {
            product.wrapping_shl(shift)
        } else if shift < 64 {
            product.wrapping_shr(shift)
        } else {
            0
        }
    }

    /// ⌊2⁶⁴ times this number⌋, and the largest word from 1 up.
    pub(crate) const fn fraction(self) -> u64 {
        let shift = self.exponent.unsigned_abs();
        if self.exponent > 0 {
            u64::MAX
        } else if shift < 64 {
            self.mantissa.wrapping_shr(shift)
        } else {
            0
        }
    }

    /// The number, cut to an integer; it is below 2⁶⁴.
    pub(crate) const fn whole(self) -> u64 {
        match self.exponent {
            digits @ 1..=64 => self.mantissa >> 64_u32.wrapping_sub(digits.unsigned_abs()),
            _ => 0,
        }
    }

    /// The number as an `f32`: rounded, and 0 or infinite where it is out of range.
    pub(crate) fn value(self) -> f32 {
        let exponent = self.exponent.clamp(-1000, 1000);
        Scaled::of(self.mantissa as f32)
            .raised(exponent.wrapping_sub(64))
            .value()
    }
}
