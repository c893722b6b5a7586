//! Numbers with a separate exponent, for products whose intermediate results leave the range of `f32`. Their logarithms
//! and powers are in `tier/power.rs`.

use super::error_free::{remainder, two_product};
use super::exponent::power_of_two;

/// A positive number as significand · 2^exponent.
///
/// Each product and quotient is rounded once, and nothing overflows or underflows before [`Scaled::value`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scaled {
    /// In [1, 2).
    significand: f32,
    exponent: i32,
}

impl Scaled {
    pub(crate) const ONE: Self = Self {
        significand: 1.0,
        exponent: 0,
    };

    /// A positive finite number, exactly.
    #[inline]
    #[expect(
        clippy::cast_possible_wrap,
        reason = "an exponent field has 8 bits: x has no sign"
    )]
    pub(crate) const fn of(x: f32) -> Self {
        let (x, lifted) = if x < f32::MIN_POSITIVE {
            (x * 16_777_216.0, 151)
        } else {
            (x, 127)
        };
        let bits = x.to_bits();
        Self {
            significand: f32::from_bits((bits & 0x007f_ffff) | 0x3f80_0000),
            exponent: ((bits >> 23) as i32).wrapping_sub(lifted),
        }
    }

    /// The magnitude of a/(b·c), rounded once, where a and b are numbers with their rounding errors.
    pub(crate) const fn of_quotient(a: (f32, f32), b: (f32, f32), c: Self) -> Self {
        let (top, bottom) = (Self::of(a.0.abs()), Self::of(b.0.abs()));
        let (divisor, dropped) = two_product(bottom.significand, c.significand);
        let first = top.significand / divisor;
        let short = remainder(top.significand, first, divisor) / top.significand + a.1 / a.0
            - dropped / divisor
            - b.1 / b.0;
        let exponent = bottom.exponent.wrapping_add(c.exponent);
        Self::of(first + first * short).raised(top.exponent.wrapping_sub(exponent))
    }

    #[inline]
    pub(crate) const fn times(self, other: Self) -> Self {
        Self::of(self.significand * other.significand)
            .raised(self.exponent.wrapping_add(other.exponent))
    }

    #[inline]
    pub(crate) const fn over(self, other: Self) -> Self {
        Self::of(self.significand / other.significand)
            .raised(self.exponent.wrapping_sub(other.exponent))
    }

    /// The number times 2^by.
    #[inline]
    pub(crate) const fn raised(self, by: i32) -> Self {
        Self {
            significand: self.significand,
            exponent: self.exponent.wrapping_add(by),
        }
    }

    /// The significand, in [1, 2), and the exponent.
    #[inline]
    pub(crate) const fn parts(self) -> (f32, i32) {
        (self.significand, self.exponent)
    }

    /// The number; infinite where it overflows, subnormal or 0 where it is too small.
    #[inline]
    pub(crate) const fn value(self) -> f32 {
        // In four factors, of which only the last can leave the range. Beyond these bounds the value is 0 or infinite.
        let exponent = if self.exponent > 480 {
            480
        } else if self.exponent < -480 {
            -480
        } else {
            self.exponent
        };
        let quarter = exponent >> 2;
        let part = power_of_two(quarter);
        let last = power_of_two(exponent.wrapping_sub(quarter.wrapping_mul(3)));
        self.significand * part * part * part * last
    }
}
