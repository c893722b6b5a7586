//! Numbers whose exponents are set aside, for products that leave the range of `f32` on the way only.

use crate::tier::{exp2, head, log2_1p, remainder, times, two_product};

/// A positive number as significand · 2^exponent.
///
/// Each product and quotient is rounded once, and nothing over- or underflows before [`Apart::value`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Apart {
    /// In [1, 2).
    significand: f32,
    exponent: i32,
}

impl Apart {
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

    /// The magnitude of a/(b·c), rounded once, where a and b are numbers and what they lack.
    pub(crate) fn of_quotient(a: (f32, f32), b: (f32, f32), c: Self) -> Self {
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

    /// The binary logarithm of the quotient by `other`: a head of 12 bits and the rest, together good to about
    /// 2^-33 of it however close the two are.
    #[inline]
    pub(crate) fn log2_over(self, other: Self) -> (f32, f32) {
        use core::f32::consts::SQRT_2;
        let (divisor, k) = (
            other.significand,
            self.exponent.wrapping_sub(other.exponent),
        );
        // Brought within a factor of root 2 of the divisor, which the difference is exact for.
        let (dividend, k) = if self.significand > SQRT_2 * divisor {
            (0.5 * self.significand, k.wrapping_add(1))
        } else if SQRT_2 * self.significand < divisor {
            (2.0 * self.significand, k.wrapping_sub(1))
        } else {
            (self.significand, k)
        };
        let difference = dividend - divisor;
        let f = difference / divisor;
        // Exponents have 9 bits.
        log2_1p(k as f32, f, remainder(difference, f, divisor) / divisor)
    }

    /// The number times (2^log)^(y + `y_rest`), where log is a head of 12 bits and a rest; 2^-1000 or 2^1000
    /// for what is farther out.
    #[inline]
    pub(crate) fn times_power(self, log: (f32, f32), (y, y_rest): (f32, f32)) -> Self {
        if (y * (log.0 + log.1)).abs() >= 1000.0 {
            let up = (y > 0.0) == (log.0 > 0.0);
            return Self::ONE.raised(if up { 1000 } else { -1000 });
        }
        let (exact, small) = times(log, y);
        let (k, a, b) = exp2(exact, small + y_rest * log.0);
        // s(1 + a + b), its largest product exact and all the rest in one sum, so that two powers
        // that are nearly the same do not change places where k does.
        let s = self.significand;
        let (s_head, a_head) = (head(s), head(a + b));
        let exact = s_head * a_head;
        let small = (s - s_head) * a_head + s * ((a - a_head) + b);
        let sum = s + exact;
        let product = sum + ((exact - (sum - s)) + small);
        Self::of(product).raised(self.exponent.wrapping_add(k))
    }

    /// The number; infinite where it overflows, subnormal or 0 where it is too small.
    #[inline]
    pub(crate) const fn value(self) -> f32 {
        // In four factors, of which only the last can leave the range; beyond these ends all of them do.
        let exponent = if self.exponent > 480 {
            480
        } else if self.exponent < -480 {
            -480
        } else {
            self.exponent
        };
        let quarter = exponent >> 2;
        let part = power(quarter);
        let last = power(exponent.wrapping_sub(quarter.wrapping_mul(3)));
        self.significand * part * part * part * last
    }
}

/// 2^e, for an exponent from -126 to 127.
#[inline]
const fn power(e: i32) -> f32 {
    f32::from_bits((e.wrapping_add(127) as u32) << 23)
}
