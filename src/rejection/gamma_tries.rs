//! How gamma numbers of scale 1 are proposed and accepted: the cube of a shifted normal number. Gamma, beta and Dirichlet
//! distributions share it.

use crate::error::{Error, positive, tried};
use crate::num::double_word::{by_64, reciprocal};
use crate::num::{SMALLEST, Scaled, happens, inverse_square_root};
use crate::tier::{Tier, neg_log2_1m_of_word, normal_quantile_of_word, times_exp2};
use core::f32::consts::LN_2;

/// The smallest and the largest shape.
pub(super) const SHAPES: (f32, f32) = (1e-30, 1e6);

/// Whether this is an accepted shape.
pub(super) const fn is_shape(shape: f32) -> bool {
    shape >= SHAPES.0 && shape <= SHAPES.1
}

/// The largest |Φ⁻¹| of a word, and what rounding may add.
const REACH: f32 = 6.35;

/// The tries of one shape.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Tries {
    shape: f32,
    /// The shape less 1/3; below 1 it is that of the shape and 1.
    depth: f32,
    /// 1/√(9 depth): a proposal is depth·(1 + slope·z)³.
    slope: f32,
    /// Of 2³² decisions, this times z⁴ or fewer reject z.
    squeeze: f32,
    /// 64 over the shape: a head of 12 bits and the rest.
    root: (f32, f32),
}

/// A gamma number of scale 1: `number`·2^(−(exact + small)/64). From shape 1 up the power is 0.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub(super) number: f32,
    exact: f32,
    small: f32,
}

impl Part {
    /// From shape 1 up.
    #[inline]
    pub(super) const fn of(number: f32) -> Self {
        Self {
            number,
            exact: 0.0,
            small: 0.0,
        }
    }

    /// The number times a scale: at least the smallest `f32`.
    #[inline]
    pub(super) fn times(self, scale: f32) -> f32 {
        let down = self.exact + self.small;
        let x = if down > 0.0 {
            let (significand, exponent) = Scaled::of(scale).parts();
            let number = Scaled::of(self.number * significand).raised(exponent);
            // Below the smallest number, and perhaps beyond what the power takes.
            if (down as i32) >> 6 > number.parts().1.wrapping_add(151) {
                return SMALLEST;
            }
            times_exp2(number, -self.exact, -self.small)
        } else {
            self.number * scale
        };
        f32::from_bits(x.to_bits().max(1))
    }

    /// The natural logarithm.
    #[inline]
    pub(super) fn ln<T: Tier>(self) -> f32 {
        T::ln(self.number) - (self.exact + self.small) * (LN_2 / 64.0)
    }
}

impl Tries {
    /// Tries of no use, to be replaced.
    pub(super) const NONE: Self = Self {
        shape: 0.0,
        depth: 0.0,
        slope: 0.0,
        squeeze: 0.0,
        root: (0.0, 0.0),
    };

    /// Refuses what is not a shape from 1e-30 to 1e6.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    pub(super) const fn new(shape: f32) -> Result<Self, Error> {
        const THIRD: f32 = (1.0 / 3.0_f64) as f32;
        tried!(positive(shape, 0));
        if !is_shape(shape) {
            return Err(Error::OutOfRange(0));
        }
        let depth = if shape < 1.0 {
            shape + 2.0 * THIRD
        } else {
            shape - THIRD
        };
        let slope = inverse_square_root(Scaled::of(9.0 * depth));
        // Of proposals, 1 − e^(−g) are rejected: that is least slope²/12·z⁴ near the mode, and this bounds it for every z. The
        // nearest it comes is a factor of 1.004, for the smallest depth.
        let rejected = slope * slope * (1.0 / 12.0) * (1.07 + 3.24 * slope);
        Ok(Self {
            shape,
            depth,
            slope,
            squeeze: rejected * 4_294_967_296.0,
            root: by_64(reciprocal(shape)),
        })
    }

    pub(super) const fn shape(&self) -> f32 {
        self.shape
    }

    /// No number is larger than this.
    pub(super) const fn largest(&self) -> f32 {
        let t = 1.0 + REACH * self.slope;
        self.depth * t * t * t
    }

    /// One try with words in the order in which it takes them: one at shape 1, otherwise a place and a decision, then one more
    /// below shape 1 for an accepted number. Numbers increase with the first and the last.
    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    pub(super) fn attempt<T: Tier, E>(
        &self,
        mut word: impl FnMut() -> Result<u32, E>,
    ) -> Result<Option<Part>, E> {
        let place = word()?;
        if self.shape.to_bits() == 1.0_f32.to_bits() {
            let (whole, rest) = neg_log2_1m_of_word(place);
            return Ok(Some(Part::of((whole + rest) * LN_2)));
        }
        let Some(number) = self.proposed::<T>(place, word()?) else {
            return Ok(None);
        };
        if self.shape > 1.0 {
            return Ok(Some(Part::of(number)));
        }
        let (whole, rest) = neg_log2_1m_of_word(!word()?);
        let (root, root_rest) = self.root;
        Ok(Some(Part {
            number,
            exact: whole * root,
            small: rest * (root + root_rest) + whole * root_rest,
        }))
    }

    /// A number of this shape, or of this and 1.
    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn proposed<T: Tier>(&self, place: u32, decision: u32) -> Option<f32> {
        let z = normal_quantile_of_word::<T>(1.0, place);
        let w = self.slope * z;
        let t = 1.0 + w;
        if t <= 0.0 {
            return None;
        }
        let fourth = (z * z) * (z * z);
        let accepted =
            (!decision) as f32 > self.squeeze * fourth || self.decide::<T>(w, fourth, decision);
        accepted.then_some(self.depth * (t * t * t))
    }

    /// Whether a decision accepts, where the squeeze does not say.
    // Of a copy, so that the compiler keeps apart what an accepted try needs.
    #[inline(never)]
    fn decide<T: Tier>(self, w: f32, fourth: f32, decision: u32) -> bool {
        happens(T::exp(-self.exponent::<T>(w, fourth)), decision)
    }

    /// −3 depth·(ln(1 + w) − w + w²/2 − w³/3), of which e to its negative is accepted.
    #[inline]
    fn exponent<T: Tier>(&self, w: f32, fourth: f32) -> f32 {
        if self.depth > 4.0 && w.abs() < 0.5 {
            // Where the sum below would cancel. The first term is w⁴/4; the last one is below 1e-8 of it.
            let mut series = 1.0 / 26.0;
            for n in [
                25.0, 24.0, 23.0, 22.0, 21.0, 20.0, 19.0, 18.0, 17.0, 16.0, 15.0, 14.0, 13.0, 12.0,
                11.0, 10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0,
            ] {
                series = 1.0 / n - w * series;
            }
            fourth * (self.slope * self.slope) * (1.0 / 3.0) * series
        } else {
            // The depth is below 18 here, since |z| is at most 6.34.
            let powers = w * (1.0 - w * (0.5 - w * (1.0 / 3.0)));
            3.0 * self.depth * (powers - T::ln_1p(w))
        }
    }
}
