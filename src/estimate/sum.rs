//! What keeps long sums true: two floats for a sum, and one power of two for its range.

use crate::num::{saturated, two_product, two_sum};

/// A sum in two floats: some 48 bits, so that each of 10⁸ terms still counts.
///
/// `high` is the sum rounded, `low` what the rounding dropped.
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

    /// Adds one term. What is left out is below 2⁻⁴⁷ of the sum.
    ///
    /// The low part is brought back under the high one at once: left to itself it would stop growing
    /// where the terms fall below its own last place, as a plain sum does.
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

    /// Whether two sums have sign and exponent in common.
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

/// A power of two that brings the largest number met to between 1 and 4.
///
/// Numbers so scaled have squares, and 2⁶⁴ of these have a sum, well inside the range of `f32`. Scaling
/// rounds only what is 2⁻¹²⁶ of the largest number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Scale {
    factor: f32,
}

impl Scale {
    /// The scale before anything is met. Subnormal numbers stay on it: they come out below 1.
    pub(crate) const FINEST: Self = Self {
        factor: f32::from_bits(253 << 23),
    };

    /// The scale on which x lies between 1 and 4, or below if the finest does not lift it there.
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

    /// The number that was scaled, or the nearest finite one.
    #[inline]
    pub(crate) fn undo(self, x: f32) -> f32 {
        saturated(x / self.factor)
    }

    /// Likewise of the product of two numbers so scaled.
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

    /// By what a number on this scale is to be multiplied for a coarser one; 0 if nothing is left there.
    #[inline]
    pub(crate) fn shrinking_to(self, coarser: Self) -> f32 {
        coarser.factor / self.factor
    }
}
