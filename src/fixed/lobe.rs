//! The cosine-power (Phong) lobe.

use super::direction::{PER_ANGLE, Scaled, UNIT, azimuth, direction, one_minus_cos};
use super::grade::{Fine, Grade, Kernels};
use super::kernel::exp::one_minus_small;
use super::kernel::log;
use super::kernel::product::{near, square};
use super::{Coordinate, Density, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::types::U32F32;
use core::marker::PhantomData;

/// In proportion to cosⁿθ over the hemisphere about +z (the Phong lobe), for any n ≥ 0.
///
/// cos θ = (1 − u₁)^(1/(n+1)). The warp computes 1 − cos θ with an exponent of its own, so that a lobe of n = 1e8 does
/// not collapse onto its axis. n = 0 is the uniform hemisphere, n = 1 the cosine one.
///
/// # Density
/// (n + 1)/(2π) cosⁿθ per steradian where z > 0, at least 2⁻³² there; 0 elsewhere.
///
/// # Domain
/// - Point: unit vectors with z ≥ 2⁻³⁰. In narrow lobes x and y hold all the information, in steps of 2⁻³⁰.
/// - Uniforms: two words, polar angle then azimuth. The axis is at u₁ = 0.
/// - Parameter: the exponent n from 0 to 2³² − 2. The warp keeps its first 32 binary digits.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate, *unit length* the largest error of the length. *Round trip* is the
/// error of the uniforms after `sample` and `invert`: of u₁, and of u₂ times sin θ.
/// *Pdf* is relative to the density on the axis. Rms and mean hold for n = 50. w is the size of the lobe, the smaller of
/// √(2/(n + 1)) and 1; the farthest sample lies at 4.7 w.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | min(2.3e-6, 1.8e-5*w) + 1.3e-9 | min(2.2e-4, 1.2e-3*w) + 1.2e-9 | min(1.2e-6, 9.1e-6*w) + 1.1e-9 | found |
/// | sample, rms | 5.0e-8 | 1.8e-5 | 6.1e-8 | found |
/// | sample, mean | -8.1e-10 | -1.1e-6 | 0 | found |
/// | unit length | 7.1e-7 | 1.9e-4 | 7.5e-7 | found |
/// | round trip | 3.7e-6 + 2.6e-9/w | 5e-4 + 2.5e-9/w | 2.6e-6 + 2.7e-9/w | found |
/// | pdf, of that on the axis | 2e-6 | 2.6e-4 | 1.2e-6 | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed PhongLobe -->359 instructions and 1,260 bytes of code on an M0, 182 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{U0F32, U32F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let gloss = mw::PhongLobe::new(U32F32::from_num(100_000_000))?;
/// let [x, y, z] = gloss.sample([0.5_f32, 0.1].map(U0F32::from_num)).map(|c| c.to_num::<f64>());
/// assert!(1.0 - z < 1e-8);         // next to the axis,
/// assert!(x * x + y * y > 1.3e-8); // but not on it
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`CosineHemisphere`](super::CosineHemisphere) is the lobe of n = 1, at lower cost.
/// - [`Cone`](super::Cone) is uniform and has a rim.
/// - [`warp::PhongLobe`](crate::warp::PhongLobe) is the lobe of the float tiers.
///
/// # Source
/// E. P. Lafortune and Y. D. Willems, "Using the Modified Phong Reflectance Model for Physically Based Rendering",
/// Report CW 197, K. U. Leuven, 1994, <http://graphics.cs.kuleuven.be/publications/Phong/>.
#[doc(alias = "cosine_power")]
#[doc(alias = "specular")]
#[doc(alias = "glossy")]
#[doc(alias = "phong")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PhongLobe<G = Fine> {
    exponent: Scaled,
    /// n + 1.
    power: Scaled,
    /// 1/(n + 1).
    inverse: Scaled,
    grade: PhantomData<G>,
}

impl<G: Grade> PhongLobe<G> {
    /// The lobe of this exponent n, up to 2³² − 2.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] above that.
    pub const fn new(exponent: U32F32) -> Result<Self, Error> {
        let exponent = exponent.to_bits();
        if exponent > (u32::MAX as u64 - 1) << 32 {
            return Err(Error::OutOfRange(0));
        }
        let power = Scaled::of(exponent + (1 << 32), 32);
        // 1, and whatever rounds to it, counts as the largest number below it.
        let inverse = if power.mantissa == UNIT.mantissa && power.exponent == UNIT.exponent {
            Scaled {
                mantissa: u32::MAX,
                exponent: 0,
            }
        } else {
            UNIT.over(power)
        };
        Ok(Self {
            exponent: Scaled::of(exponent, 32),
            power,
            inverse,
            grade: PhantomData,
        })
    }

    /// The exponent n. The lobe keeps its first 32 binary digits.
    #[must_use]
    pub const fn exponent(&self) -> U32F32 {
        U32F32::from_bits(self.exponent.to_long_bits(32))
    }

    /// −ln cos θ of a direction with z > 0.
    #[inline]
    fn neg_ln_cos(point: [Coordinate; 3]) -> Scaled {
        let a = one_minus_cos(point);
        if a.exponent >= 3 {
            // Below 1/8 by the series, since n multiplies the error of the logarithm.
            let more = log::excess_of_eighth(a.to_bits(32));
            let mantissa = a.mantissa >> 1;
            Scaled::normal(mantissa + near(mantissa, more), a.exponent - 1)
        } else {
            let cos = point[2].to_bits() as u32;
            // By the cosine itself, which has all its digits here.
            let log = G::log(if cos >> 30 == 0 {
                (cos << 2).wrapping_neg()
            } else {
                0
            });
            Scaled::normal(log, -5)
        }
    }
}

/// 1 − e^−x.
#[inline]
fn exp_m1_neg<G: Kernels>(x: Scaled) -> u32 {
    // The series keeps the digits below 1/8.
    if x.exponent >= 3 {
        let bits = x.to_bits(34);
        one_minus_small(bits, 34) >> 2
    } else {
        !G::exp(x.to_bits(27))
    }
}

impl<G: Grade> Warp for PhongLobe<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 3];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 3] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        // −ln(1 − u₁), with more digits nearer the axis.
        let (log, bits) = if u1 < log::SMALL {
            (log::small(u1), 39)
        } else if u1 >> 29 == 0 {
            (log::eighth(u1), 34)
        } else {
            (G::log(u1), 27)
        };
        // −ln cos θ, with so many fraction bits.
        let neg_ln_cos = near(log, self.inverse.mantissa);
        let bits = bits + self.inverse.exponent;
        if bits > 34 || neg_ln_cos >> (bits - 3) == 0 {
            let a = one_minus_small(neg_ln_cos, bits as u32);
            let half = Scaled {
                mantissa: a,
                exponent: bits - 31,
            };
            half.direction::<G>(u2)
        } else {
            let cos = G::exp(neg_ln_cos >> (bits - 27));
            // The last words would reach the horizon, where the density is 0.
            let z = (cos >> 2).max(1) as i32;
            direction::<G>(G::root(!square(cos)), z, u2)
        }
    }

    #[inline]
    fn pdf(&self, point: [Coordinate; 3]) -> Density {
        let [_, _, z] = point;
        if z <= Coordinate::ZERO {
            return Density::ZERO;
        }
        let log = Self::neg_ln_cos(point).times(self.exponent);
        let shape = G::exp(log.to_bits(27));
        let height = self.power.times(PER_ANGLE);
        let density = (u64::from(height.mantissa) * u64::from(shape)) >> (32 + height.exponent);
        Density::from_bits(density.max(1))
    }
}

impl<G: Grade> Invert for PhongLobe<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 3]) -> [Uniform; 2] {
        let [x, y, z] = point;
        let u1 = if z > Coordinate::ZERO {
            exp_m1_neg::<G>(Self::neg_ln_cos(point).times(self.power))
        } else {
            u32::MAX
        };
        [Uniform::from_bits(u1), azimuth::<G>(x, y)]
    }
}
