//! The uniform distribution over a cone of directions (a spherical cap).

use super::direction::{PER_ANGLE, Scaled, azimuth, one_minus_cos};
use super::grade::{Fine, Grade};
use super::kernel::product::{by_half, near, wide};
use super::truncated::alternating;
use super::{Coordinate, Density, Uniform};
use crate::error::Error;
use crate::num::division::{fraction, quotient};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedU32;
use ::fixed::types::U2F62;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Uniform over the directions within an angle of +z: a cone, also called a spherical cap.
///
/// With k = 1 − cos θmax and h = u₁k/2: cos θ = 1 − 2h, sin θ = 2√(h(1 − h)). The warp stores k with an exponent of its
/// own, so that narrow cones keep their digits.
///
/// # Density
/// 1/(2πk) per steradian inside the cone and slightly beyond its rim, where samples may be rounded to: by 2⁻¹⁹ of k (in
/// grade [`Coarse`](super::Coarse) 2⁻¹⁴), and by three steps of x and y. 0 elsewhere.
///
/// # Domain
/// - Point: unit vectors with 1 − cos θ ≤ k, up to rounding. In a narrow cone z is 1, and x and y hold all the
///   information, which `pdf` and `invert` use. Their steps are 2⁻³⁰; the narrowest cone is 16,000 steps wide.
/// - Uniforms: two words, polar angle then azimuth. The axis is at u₁ = 0.
/// - Parameter: k, the half angle in turns, or a sphere by its radius and distance. The warp keeps at least 31 binary digits of k.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate, *unit length* the largest error of the length. *Round trip* is the
/// error of the uniforms after `sample` and `invert`: of u₁, and of u₂ times sin θ.
/// *Pdf* is the relative error of the density, beyond a step of 2⁻³². Rms and mean hold for k = 0.3. w is the largest
/// sine in the cone: √(k(2 − k)) for k below 1, else 1.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 1.2e-6*w + 1.2e-9 | 2.4e-4*w + 1.2e-9 | 8.6e-7*w + 1.3e-9 | found |
/// | sample, rms | 8.8e-8 | 3.2e-5 | 1.4e-7 | found |
/// | sample, mean | 0 | -2.8e-6 | 0 | found |
/// | unit length | 7.1e-7 | 1.9e-4 | 7.5e-7 | found |
/// | pdf | 3.8e-9 | 3.8e-9 | 3.8e-9 | found |
/// | round trip | 1.6e-6 + 2.4e-9/w | 5e-4 + 2.5e-9/w | 1.6e-6 + 2.4e-9/w | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Cone -->256 instructions and 552 bytes of code on an M0, 126 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I2F30, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let sun = mw::Cone::from_turns(U0F32::from_num(0.000_74))?; // half the angle the sun subtends, in turns
/// let direction = sun.sample([0.9_f32, 0.3].map(U0F32::from_num));
/// assert!(sun.pdf(direction) > 0);
/// assert_eq!(sun.pdf([1, 0, 0].map(I2F30::from_num)), 0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Hemisphere`](super::Hemisphere) and [`Sphere`](super::Sphere) are the cones of a quarter and half a turn, at lower
///   cost.
/// - [`PhongLobe`](super::PhongLobe) falls off smoothly instead of ending at a rim.
/// - [`warp::Cone`](crate::warp::Cone) is the cone of the float tiers, and [`VisibleSphere`](crate::warp::VisibleSphere) a sphere
///   seen from a point, turned and with distances, in their coordinates.
///
/// # Source
/// P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM Transactions on
/// Graphics, 1996, <https://doi.org/10.1145/226150.226151>.
#[doc(alias = "spherical_cap")]
#[doc(alias = "solid_angle")]
#[doc(alias = "sphere_light")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cone<G = Fine> {
    /// k/2.
    half: Scaled,
    /// 1/(2πk) in Q32.
    density: u64,
    grade: PhantomData<G>,
}

impl<G: Grade> Cone<G> {
    /// The cone of 1 − cos θmax = `k`, in (0, 2]; 2 is the whole sphere.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0, [`Error::OutOfRange`] above 2, [`Error::Empty`] below 2⁻³³, where the
    /// density overflows.
    pub const fn from_one_minus_cos(k: U2F62) -> Result<Self, Error> {
        match k.to_bits() {
            0 => Err(Error::NotPositive(0)),
            bits if bits > 1 << 63 => Err(Error::OutOfRange(0)),
            bits if bits < 1 << 29 => Err(Error::Empty(0)),
            bits => Ok(Self::of(Scaled::of(bits, 63))),
        }
    }

    /// The cone of the given half angle in turns, in (0, 1/2].
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0, [`Error::OutOfRange`] above 1/2, [`Error::Empty`] below 2.43e-6 turns,
    /// where the density overflows.
    pub const fn from_turns(half_angle: Uniform) -> Result<Self, Error> {
        /// Half a turn.
        const HALF: u32 = 1 << 31;
        let bits = half_angle.to_bits();
        if bits == 0 {
            return Err(Error::NotPositive(0));
        }
        if bits > HALF {
            return Err(Error::OutOfRange(0));
        }
        // k/2 is sin² of half the angle; beyond a quarter of a turn, 1 − sin² of half the supplement.
        let half = if bits <= HALF >> 1 {
            let (square, fraction) = sine_squared(bits);
            Scaled::of(square, fraction)
        } else {
            let (square, fraction) = sine_squared(HALF - bits);
            Scaled::of((1 << 63) - (square >> (fraction - 63)), 63)
        };
        if half.exponent > 33 {
            return Err(Error::Empty(0));
        }
        Ok(Self::of(half))
    }

    /// The cone in which a sphere of this radius is seen from this distance to its centre, both in one unit. Inside the
    /// sphere it is all directions, on its surface the hemisphere. k is right to a unit of its 31st binary digit.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a radius of 0, [`Error::Empty`] below 1.53e-5 of the distance, where the density
    /// overflows.
    pub const fn towards_sphere<Frac: LeEqU32>(
        distance: FixedU32<Frac>,
        radius: FixedU32<Frac>,
    ) -> Result<Self, Error> {
        let (d, r) = (distance.to_bits() as u64, radius.to_bits() as u64);
        if r == 0 {
            return Err(Error::NotPositive(1));
        }
        if d < r {
            return Ok(Self::of(Scaled::of(1 << 63, 63)));
        }
        // Only the ratio counts. d fills its word, and so do the square of r and what it is divided by.
        let zeros = (d as u32).leading_zeros();
        let (d, r) = (d << zeros, r << zeros);
        let square = r * r;
        // d + √(d² − r²) in Q31, with the first term of the root beyond its whole part.
        let rest = d * d - square;
        let half = (rest | 1).leading_zeros() >> 1;
        let rest = rest << (2 * half);
        let root = rest.isqrt();
        let (more, _) = fraction(rest - root * root, 2 * root + 1);
        let sum = (d << 31) + ((root << 31 | more as u64 >> 1) >> half);
        // k is r²/(d(d + √(d² − r²))).
        let divisor = d * (sum >> 32) + ((d * (sum & 0xffff_ffff)) >> 32);
        let (up, down) = (square.leading_zeros(), divisor.leading_zeros());
        let (digits, _) = quotient(square << up, divisor << down);
        let half = Scaled::of(digits as u64, 33 + up as i32 - down as i32);
        if half.exponent > 33 {
            return Err(Error::Empty(1));
        }
        Ok(Self::of(half))
    }

    const fn of(half: Scaled) -> Self {
        Self {
            half,
            // Below 2³² by the bounds of k.
            density: PER_ANGLE.over(half.doubled()).to_long_bits(32),
            grade: PhantomData,
        }
    }

    /// k = 1 − cos θmax. The cone keeps at least its first 31 binary digits.
    #[must_use]
    pub const fn one_minus_cos(&self) -> U2F62 {
        U2F62::from_bits(self.half.to_long_bits(63))
    }
}

/// The terms of the series of sin², 1/3, 2/45, 1/315, …, in Q32.
const SQUARE: [u32; 7] = [
    1_431_655_765,
    190_887_435,
    13_634_817,
    605_992,
    18_363,
    404,
    7,
];

/// sin² of half an angle of at most a quarter of a turn (Q32), and the number of its fraction bits, 64 or more.
const fn sine_squared(words: u32) -> (u64, i32) {
    /// π in Q32.
    const PI: u64 = 13_493_037_705;
    // At most π/4.
    let angle = Scaled::of(words as u64 * PI, 64);
    if angle.mantissa == 0 {
        return (0, 64);
    }
    let square = (angle.mantissa as u64 * angle.mantissa as u64) >> 32;
    let fraction = 2 * angle.exponent;
    // In Q32, for the series.
    let z = if fraction > 31 { 0 } else { square >> fraction };
    (square * alternating(z, &SQUARE), 64 + fraction)
}

impl<G: Grade> Warp for Cone<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 3];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 3] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        let Scaled { mantissa, exponent } = self.half;
        if exponent <= 0 {
            // Wider than a hemisphere h comes near 1. All its bits count, from the nearer pole.
            let half = wide(mantissa, u1) << -exponent;
            let below = half >> 63 != 0;
            let from_pole = if below { half.wrapping_neg() } else { half };
            let [x, y, z] = Scaled::of(from_pole, 64).direction::<G>(u2);
            return [x, y, if below { -z } else { z }];
        }
        // 16 more bits keep the digits of a small u.
        let half = if u1 >> 16 == 0 {
            Scaled {
                mantissa: by_half(mantissa, u1),
                exponent: exponent + 16,
            }
        } else {
            Scaled {
                mantissa: near(mantissa, u1),
                exponent,
            }
        };
        half.direction::<G>(u2)
    }

    #[inline]
    fn pdf(&self, point: [Coordinate; 3]) -> Density {
        let [x, y, z] = point;
        // Products round x and y outwards by up to this many steps.
        let [x, y] = [x, y]
            .map(|c| Coordinate::from_bits(c.to_bits().unsigned_abs().saturating_sub(3) as i32));
        // In units of k, so that samples have at most 1.
        let share = one_minus_cos([x, y, z]).over(self.half.doubled());
        if share.to_bits(31) <= (1 << 31) + G::BEYOND {
            Density::from_bits(self.density)
        } else {
            Density::ZERO
        }
    }
}

impl<G: Grade> Invert for Cone<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 3]) -> [Uniform; 2] {
        let [x, y, _] = point;
        let share = one_minus_cos(point).over(self.half.doubled());
        [Uniform::from_bits(share.to_bits(32)), azimuth::<G>(x, y)]
    }
}
