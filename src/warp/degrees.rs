//! Degrees of freedom: what the distributions of Student's t in one and in two dimensions share.

use super::location_scale::decayed;
use super::normal::FRAC_1_SQRT_TAU;
use crate::error::{Error, positive, tried};
use crate::num::double_word::{self, DoubleWord, quotient, reciprocal};
use crate::num::{
    Scaled, head, into_unit, nearest_integer, power_of_two, remainder, representable, square_root,
    two_product, two_sum,
};
use crate::tier::{
    Tier, exp2_neg_pair, log2_1p, log2_of_sum, neg_log2_1m, neg_log2_1m_of_word_ahead, sqrt, times,
};
use core::f32::consts::LN_2;

/// 2⁴⁰: degrees of freedom from which on the law is normal to all digits.
const NORMAL: f32 = 1_099_511_627_776.0;

/// Degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Degrees {
    pub(super) count: f32,
    /// 1/ν: a head of 12 bits and the rest.
    inverse: (f32, f32),
    /// √ν.
    root: f32,
}

/// 2^y of a y from 0 up, or less by up to 0.2 %, or more by up to 0.4 %; infinite from 2¹²⁸ on.
const fn about_exp2(y: f32) -> f32 {
    if y < 128.0 {
        let (whole, k) = nearest_integer(y - 0.5);
        let part = y - whole;
        power_of_two(k) * (1.0 + part * (2.0 + part) * (1.0 / 3.0))
    } else {
        f32::INFINITY
    }
}

impl Degrees {
    /// With a bound on how far a sample lies from its location in units of the scale.
    pub(super) const fn new(count: f32) -> Result<(Self, f32), Error> {
        let inverse = reciprocal(tried!(positive(count, 0)));
        // ν(4^y − 1) is at most 2 ln 2 νy 4^y, where y = 33.01/ν: (6.77·2^y)². Beyond the largest float the sample's own power
        // could leave the range.
        let reach = 6.8 * about_exp2(33.01 * inverse.0);
        if !reach.is_finite() {
            return Err(Error::TooLarge(0));
        }
        let high = head(inverse.0);
        let made = Self {
            count,
            inverse: (high, (inverse.0 - high) + inverse.1),
            root: square_root(Scaled::of(count)),
        };
        Ok((made, reach))
    }

    /// The distance of a uniform in [0, 1), in units of the scale.
    #[inline]
    pub(super) fn radius(&self, u: f32) -> f32 {
        // Below 2⁻⁶⁰ the quotient of its logarithm and ν may be below the range of `f32`.
        if u < 8.673_617e-19 {
            sqrt(2.0 * u)
        } else {
            self.beyond(neg_log2_1m(u))
        }
    }

    /// The distance of the middle of a word's cell, likewise.
    #[inline]
    pub(super) fn radius_of_word(&self, word: u32) -> f32 {
        self.beyond(neg_log2_1m_of_word_ahead(word))
    }

    /// The distance beyond which a probability lies that is given by its negative log₂.
    #[inline]
    fn beyond(&self, (whole, rest): (f32, f32)) -> f32 {
        if self.count >= NORMAL {
            return sqrt((whole + rest) * (2.0 * LN_2));
        }
        let (high, low) = self.inverse;
        // The tangent of an angle with this cosine.
        let (cos, q) = exp2_neg_pair(whole * high, rest * (high + low) + whole * low);
        self.root * (sqrt(q * (1.0 + cos)) / cos)
    }

    /// log₂(1 + r²/ν), a head of 12 bits and the rest, of a number r² that is given with its exponent.
    pub(super) const fn log2_rise(&self, square: Square) -> (f32, f32) {
        let (count, up) = Scaled::of(self.count).parts();
        let (x, rest) = square.part;
        let exponent = square.exponent.saturating_sub(up);
        let w = x / count;
        let lack = (remainder(x, w, count) + rest) / count;
        if exponent < -80 {
            return (0.0, 0.0);
        }
        if exponent > 30 {
            return log2_of_sum(w, lack, 0_i32.saturating_sub(exponent) as f32);
        }
        let (w, lack) = (w * power_of_two(exponent), lack * power_of_two(exponent));
        if w < 0.4 {
            return log2_1p(0.0, w, lack);
        }
        let (sum, dropped) = two_sum(1.0, w);
        log2_of_sum(sum, dropped + lack, 0.0)
    }

    /// The density at a point of this squared distance in units of the scale, in so many dimensions.
    #[inline]
    pub(super) fn density<T: Tier>(&self, peak: f32, square: Square, dimensions: f32) -> f32 {
        let density = if self.count >= NORMAL {
            decayed::<T>(peak, square.halved())
        } else {
            let (sum, dropped) = two_sum(self.count, dimensions);
            let power = (-0.5 * sum, -0.5 * dropped);
            let log = self.log2_rise(square);
            Scaled::of(peak).times_power(log, power).value()
        };
        representable(density)
    }

    /// The uniform of this squared radius in units of the scale.
    #[inline]
    pub(super) fn uniform<T: Tier>(&self, square: Square) -> f32 {
        let log = if self.count >= NORMAL {
            square.halved().0
        } else {
            let (exact, small) = times(self.log2_rise(square), -0.5 * self.count);
            (exact + small) * LN_2
        };
        into_unit(-T::exp_m1(log))
    }

    /// The density of one dimension at its location, of a scale below all usual ones.
    #[cold]
    #[inline(never)]
    pub(super) const fn steepest(self, scale: f32) -> f32 {
        self.peak() / scale
    }

    /// Γ((ν+1)/2)/(√(νπ) Γ(ν/2)), the density of one dimension at its location.
    // With a loop that counts, so that the compiler sees that it ends, and leaves it out where no density is asked for.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) const fn peak(&self) -> f32 {
        const FRAC_1_SQRT_PI: f32 = 0.5 * core::f32::consts::FRAC_2_SQRT_PI;
        if self.count >= NORMAL {
            return FRAC_1_SQRT_TAU;
        }
        // Up to where Stirling's series ends after a few terms, by Γ(x + 1) = xΓ(x).
        let (mut above, mut below): (DoubleWord, DoubleWord) = ((1.0, 0.0), (1.0, 0.0));
        let (mut steps, mut left) = (0.0, 8_u32);
        while left > 0 && self.count + 2.0 * steps < 16.0 {
            left = left.wrapping_sub(1);
            above = double_word::times(above, two_sum(self.count, 2.0 * steps));
            below = double_word::times(below, two_sum(self.count, 2.0 * steps + 1.0));
            steps += 1.0;
        }
        // Γ(w + ¾)/Γ(w + ¼) = √w(1 + 1/(64w²) − …).
        let w = 0.5 * self.count + (steps - 0.25);
        let s = 1.0 / (w * w);
        let series = s * (1.0 / 64.0 - s * (19.0 / 8192.0 - s * (631.0 / 524_288.0)));
        let root = Scaled::ONE
            .times_power(Scaled::of(w).log2_over(Scaled::of(self.count)), (0.5, 0.0))
            .value();
        let part = quotient(above, below.0);
        let part = part - part * (below.1 / below.0);
        let peak = root * part * FRAC_1_SQRT_PI;
        peak + peak * series
    }
}

/// A square, from 1/4 to 8 with its rounding error, times a power of 2.
#[derive(Clone, Copy)]
pub(super) struct Square {
    part: (f32, f32),
    exponent: i32,
}

impl Square {
    /// The square of the distance of a finite x from a location in units of a scale.
    pub(super) const fn of(x: f32, location: f32, scale: f32) -> Self {
        let (distance, dropped) = two_sum(x, -location);
        // What overflows is the largest number.
        let (distance, dropped) = if distance.is_finite() {
            (distance.abs(), dropped / distance)
        } else {
            (f32::MAX, 0.0)
        };
        if distance == 0.0 {
            return Self {
                part: (1.0, 0.0),
                exponent: -1000,
            };
        }
        let (a, up) = Scaled::of(distance).parts();
        let (b, down) = Scaled::of(scale).parts();
        let t = a / b;
        let rest = (remainder(a, t, b) + a * dropped) / b;
        let (square, lost) = two_product(t, t);
        Self {
            part: (square, lost + 2.0 * t * rest),
            exponent: up.wrapping_sub(down).wrapping_mul(2),
        }
    }

    /// The sum of two.
    pub(super) const fn plus(self, other: Self) -> Self {
        let (large, small) = if self.exponent < other.exponent {
            (other, self)
        } else {
            (self, other)
        };
        let down = small.exponent.wrapping_sub(large.exponent);
        if down < -60 {
            return large;
        }
        let scale = power_of_two(down);
        let (sum, dropped) = two_sum(large.part.0, scale * small.part.0);
        Self {
            part: (sum, dropped + (large.part.1 + scale * small.part.1)),
            exponent: large.exponent,
        }
    }

    /// Minus one half of it, and its rounding error.
    fn halved(self) -> (f32, f32) {
        let exponent = self.exponent.clamp(-100, 100);
        let scale = -0.5 * power_of_two(exponent);
        (scale * self.part.0, scale * self.part.1)
    }
}
