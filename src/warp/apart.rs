//! Numbers whose exponents are set aside, for products that leave the range of `f32` on the way only.

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
