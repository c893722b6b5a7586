//! What the disk and the directions share: a radius turned about the centre, the angle of a point, and 1 − cos θ as a
//! number with an exponent.

use super::grade::Kernels;
use super::kernel::product::near;
use super::kernel::quotient::quotient;
use super::{Coordinate, Density, Uniform};

/// 1.
pub(super) const UNIT: Scaled = Scaled::normal(1 << 31, -1);
/// 1/(2π).
pub(super) const PER_ANGLE: Scaled = Scaled::normal(683_565_276, 0);
/// 1 in Q30.
pub(super) const ONE: i32 = 1 << 30;

/// The point at this distance from the centre (Q32), in the direction of a phase (Q32 turns); in Q30.
#[inline]
pub(super) fn around<G: Kernels>(radius: u32, phase: u32) -> [i32; 2] {
    let (sin, cos) = G::sincos(phase);
    [G::scaled(radius, cos), G::scaled(radius, sin)]
}

/// The direction with this sine (Q32) and cosine (Q30) of the polar angle, at a phase (Q32 turns).
#[inline]
pub(super) fn direction<G: Kernels>(sin: u32, cos: i32, phase: u32) -> [Coordinate; 3] {
    let [x, y] = around::<G>(sin, phase);
    [x, y, cos].map(Coordinate::from_bits)
}

/// x² + y² of magnitudes up to 2³¹, with twice their fraction bits.
#[inline]
pub(super) fn square_of(point: [u32; 2]) -> u64 {
    let [x, y] = point.map(u64::from);
    x * x + y * y
}

/// The angle of a point in turns, 0 at the origin.
#[inline]
pub(super) fn azimuth<G: Kernels>(x: Coordinate, y: Coordinate) -> Uniform {
    Uniform::from_bits(G::angle(y.to_bits(), x.to_bits()))
}

/// A number of any magnitude below 2³²: mantissa·2^(−32 − exponent).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Scaled {
    pub(super) mantissa: u32,
    pub(super) exponent: i32,
}

impl Scaled {
    /// The mantissa is shifted until its first bit is set, unless it is 0.
    #[inline]
    pub(super) const fn normal(mantissa: u32, exponent: i32) -> Self {
        let zeros = (mantissa | 1).leading_zeros();
        Self {
            mantissa: mantissa << zeros,
            exponent: exponent + zeros as i32,
        }
    }

    /// A number with so many fraction bits.
    #[inline]
    pub(super) const fn of(bits: u64, fraction: i32) -> Self {
        let zeros = (bits | 1).leading_zeros() as i32;
        Self {
            mantissa: ((bits << zeros) >> 32) as u32,
            exponent: zeros + fraction - 64,
        }
    }

    /// The number with so many fraction bits, cut; the largest word if it does not fit.
    #[inline]
    pub(super) const fn to_bits(self, fraction: i32) -> u32 {
        let left = fraction - 32 - self.exponent;
        if left > 0 && (left > 31 || self.mantissa >> (32 - left) != 0) && self.mantissa != 0 {
            u32::MAX
        } else {
            shifted(self.mantissa, -left)
        }
    }

    /// The number with so many fraction bits in 64 bits, cut. It has to fit.
    #[inline]
    pub(super) const fn to_long_bits(self, fraction: i32) -> u64 {
        let left = fraction - 32 - self.exponent;
        if left >= 0 {
            (self.mantissa as u64) << left
        } else {
            (self.mantissa as u64) >> -left
        }
    }

    /// a/b, at most 2⁻³⁰ of it too large, of mantissas whose first bit is set.
    #[inline]
    pub(super) const fn over(self, b: Self) -> Self {
        let exponent = self.exponent - b.exponent;
        if self.mantissa < b.mantissa {
            Self::normal(quotient(self.mantissa, b.mantissa), exponent)
        } else {
            Self::normal(quotient(self.mantissa >> 1, b.mantissa), exponent - 1)
        }
    }

    /// Twice the number.
    #[inline]
    pub(super) const fn doubled(self) -> Self {
        Self {
            mantissa: self.mantissa,
            exponent: self.exponent - 1,
        }
    }

    /// a·b, cut.
    #[inline]
    pub(super) const fn times(self, b: Self) -> Self {
        Self {
            mantissa: near(self.mantissa, b.mantissa),
            exponent: self.exponent + b.exponent,
        }
    }

    /// The density of this height times a shape in Q32, between the smallest and the largest positive density.
    #[inline]
    pub(super) const fn density(self, shape: u32) -> Density {
        let density = self.mantissa as u64 * shape as u64;
        let right = 32 + self.exponent;
        let density = match right {
            64.. => 0,
            1.. => (density >> (right - 1)).div_ceil(2),
            _ if density.leading_zeros() as i32 >= -right => density << -right,
            _ => u64::MAX,
        };
        Density::from_bits(if density == 0 { 1 } else { density })
    }

    /// The direction for which this number, at most 1, is (1 − cos θ)/2.
    #[inline]
    pub(super) fn direction<G: Kernels>(self, phase: u32) -> [Coordinate; 3] {
        let half = shifted(self.mantissa, self.exponent);
        // sin² = 4 h (1 − h).
        let square = self.mantissa - near(self.mantissa, half);
        let exponent = self.exponent - 2;
        let (sin, halvings) = if exponent <= 0 {
            // At the equator, rounding may carry the product past 1.
            let most = u32::MAX >> (-exponent & 31);
            (G::root(square.min(most) << (-exponent & 31)), 0)
        } else {
            // Halving once makes an odd exponent even; the root halves the rest.
            (G::root(square >> (exponent & 1)), (exponent >> 1).min(31))
        };
        // Halved after it is turned, so that the cut of the product is small beside the step of the point.
        let rounding = ((1_u32 << halvings) >> 1) as i32;
        let [x, y] = around::<G>(sin, phase);
        // One by one: where code is to be small, `map` is a loop over memory.
        let halved = |c: i32| (c + rounding) >> halvings;
        [halved(x), halved(y), ONE - (half >> 1) as i32].map(Coordinate::from_bits)
    }
}

/// A number shifted right, or left where the distance is negative.
#[inline]
const fn shifted(x: u32, right: i32) -> u32 {
    if right > 31 {
        0
    } else if right >= 0 {
        x >> right
    } else {
        x << -right
    }
}

/// 1 − cos θ of a direction: from x and y near the pole, where z has lost its digits.
#[inline]
pub(super) fn one_minus_cos([x, y, z]: [Coordinate; 3]) -> Scaled {
    let (x, y, z) = (x.to_bits(), y.to_bits(), z.to_bits());
    if z < ONE >> 1 {
        return Scaled::normal(ONE.abs_diff(z), -2);
    }
    // (x² + y²)/(1 + z), in Q60 and Q30.
    let square = square_of([x, y].map(i32::unsigned_abs));
    Scaled::of(square, 60).over(Scaled::normal((ONE as u32) + z as u32, -2))
}
