//! What keeps long sums accurate: two floats for each sum, and a power of two for its range.

use crate::num::{saturated, two_product, two_sum};

/// A sum in two floats: about 48 bits, so that each of 10⁸ terms still counts.
///
/// `high` is the rounded sum, `low` its rounding error.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Sum {
    high: f32,
    low: f32,
}

impl Sum {
    pub(crate) const ZERO: Self = Self {
        high: 0.0,
        low: 0.0,
    };

    /// A count, exact up to 2⁴⁸ and to one part in 2²⁴ beyond.
    #[inline]
    pub(crate) fn of_count(count: u64) -> Self {
        let below = count & 0x00ff_ffff;
        Self::ZERO.plus((count ^ below) as f32).plus(below as f32)
    }

    /// The sum in one float.
    #[inline]
    pub(crate) const fn value(self) -> f32 {
        self.high
    }

    /// Adds one term. What is lost is below 2⁻⁴⁷ of the sum.
    ///
    /// The low part is renormalised at once. Otherwise it would stop growing once the terms fall below its own last place, as
    /// a plain sum does.
    #[inline]
    pub(crate) fn plus(self, term: f32) -> Self {
        let (sum, dropped) = two_sum(self.high, term);
        let low = self.low + dropped;
        let high = sum + low;
        Self {
            high,
            low: low - (high - sum),
        }
    }

    /// Whether two sums have the same sign and exponent.
    #[inline]
    pub(crate) fn in_binade_of(self, other: Self) -> bool {
        (self.high.to_bits() ^ other.high.to_bits()) >> 23 == 0
    }

    /// Adds another sum.
    #[inline]
    pub(crate) fn join(self, other: Self) -> Self {
        self.plus(other.high).plus(other.low)
    }

    /// Adds a multiple of another sum.
    #[inline]
    pub(crate) fn plus_multiple(self, other: Self, factor: f32) -> Self {
        let (product, dropped) = two_product(other.high, factor);
        self.plus(product).plus(dropped + other.low * factor)
    }

    /// The sum of all terms multiplied by a power of two.
    #[inline]
    pub(crate) fn scaled(self, power: f32) -> Self {
        Self {
            high: self.high * power,
            low: self.low * power,
        }
    }
}

/// A power of two that brings the largest number so far to between 1 and 4.
///
/// Squares of scaled numbers, and sums of 2⁶⁴ of them, are well inside the range of `f32`. Scaling rounds only numbers below
/// 2⁻¹²⁶ of the largest.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Scale {
    factor: f32,
}

impl Scale {
    /// The scale before the first number. Subnormal numbers stay on it, below 1.
    pub(crate) const FINEST: Self = Self {
        factor: f32::from_bits(253 << 23),
    };

    /// The scale on which x lies between 1 and 4, or the finest one if x lies below 1 even there.
    #[inline]
    pub(crate) fn of(x: f32) -> Self {
        let exponent = (x.to_bits() >> 23) & 0xff;
        // A factor of exponent 0 would be subnormal; without it, the top binade reaches from 2 to 4.
        let factor = 254_u32.saturating_sub(exponent).clamp(1, 253);
        Self {
            factor: f32::from_bits(factor << 23),
        }
    }

    /// Whether x is within range on this scale.
    #[inline]
    pub(crate) fn holds(self, x: f32) -> bool {
        (x * self.factor).abs() < 4.0
    }

    #[inline]
    pub(crate) fn apply(self, x: f32) -> f32 {
        x * self.factor
    }

    /// The number before scaling, or the nearest finite one.
    #[inline]
    pub(crate) fn undo(self, x: f32) -> f32 {
        saturated(x / self.factor)
    }

    /// The product of two numbers before scaling, or the nearest finite one.
    #[inline]
    pub(crate) fn undo_square(self, x: f32) -> f32 {
        saturated(x / self.factor / self.factor)
    }

    /// The coarser of two scales.
    #[inline]
    pub(crate) fn joined(self, other: Self) -> Self {
        if other.factor < self.factor {
            other
        } else {
            self
        }
    }

    /// The factor that takes a number from this scale to a coarser one; 0 if nothing would be left.
    #[inline]
    pub(crate) fn shrinking_to(self, coarser: Self) -> f32 {
        coarser.factor / self.factor
    }
}
