//! The phase function of Henyey and Greenstein.

use super::direction::{PER_ANGLE, Scaled, azimuth, one_minus_cos};
use super::grade::{Fine, Grade};
use super::kernel::product::wide;
use super::{Coordinate, Density, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::types::U2F62;
use core::marker::PhantomData;

/// The phase function of Henyey and Greenstein: where fog, clouds, skin or dust scatter light.
///
/// Directions are local, about +z, the direction in which the light travels. The asymmetry g is the mean of cos θ:
/// g > 0 favours +z, g < 0 sends the light back, and g = 0 is the uniform sphere. With h = |g| and D = (1 − h) + 2h(1 −
/// u₁), 1 − cos θ is 2u₁((1 − h)/D)²(1 + h(1 − u₁)), and 1 + cos θ is 2(1 − u₁)((1 + h)/D)²(1 − h + h(1 − u₁)); the
/// smaller of the two is computed. For g < 0 all is seen from −z.
///
/// # Density
/// (1 − g²)/(4πS³) per steradian, where S = √((1 − h)² + 2h(1 ∓ cos θ)), at least 2⁻³².
///
/// # Domain
/// - Point: unit vectors. For |g| near 1 most of them have z = ±1, and x and y hold all the information, which `pdf` and
///   `invert` use.
/// - Uniforms: two words, polar angle then azimuth. +z is at u₁ = 0.
/// - Parameter: g, or 1 − g, which keeps its digits near g = 1 and g = −1. 1 − |g| is at least 2⁻¹⁷.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate, *unit length* the largest error of the length. *Round trip* is the
/// error of the uniforms after `sample` and `invert`: of u₁, and of u₂ times sin θ. *Pdf* is the relative error of the
/// density, beyond a step of 2⁻³². Rms and mean hold for g = 0.8. a is 1 − |g|.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 1.3e-6 | 1.9e-4 | 8.4e-7 | found |
/// | sample, rms | 8.3e-8 | 2.7e-5 | 1.3e-7 | found |
/// | sample, mean | 0 | -2.4e-6 | 0 | found |
/// | unit length | 7.1e-7 | 1.9e-4 | 7.5e-7 | found |
/// | round trip | 4.5e-7 + 3.4e-10/a | 1.3e-4 + 3.8e-10/a | 4.8e-7 + 3.6e-10/a | found |
/// | pdf | 3.8e-7 | 4e-5 | 1.8e-7 | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed HenyeyGreenstein -->1,408 instructions and 1,432 bytes of code on an M0, 740 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I2F30, U0F32};
/// use microwarp::{Warp, fixed as mw};
/// let fog = mw::HenyeyGreenstein::new(I2F30::from_num(0.9))?;
/// let [_, _, z] = fog.sample([0.5_f32, 0.25].map(U0F32::from_num));
/// assert!(z > 0.985); // half of the light turns by less than ten degrees
/// let ahead = fog.pdf([0, 0, 1].map(I2F30::from_num));
/// assert!(ahead > 6000 * fog.pdf([0, 0, -1].map(I2F30::from_num)));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Sphere`](super::Sphere) is isotropic scattering, g = 0, at a lower cost.
/// - [`Exponential`](super::Exponential) is how far the light goes.
/// - [`warp::HenyeyGreenstein`](crate::warp::HenyeyGreenstein) is the one of the float tiers.
///
/// # Source
/// L. G. Henyey and J. L. Greenstein, "Diffuse Radiation in the Galaxy", 1941, <https://doi.org/10.1086/144246>.
#[doc(alias = "phase_function")]
#[doc(alias = "scattering")]
#[doc(alias = "hg")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HenyeyGreenstein<G = Fine> {
    /// 1 − h in Q63.
    least: u64,
    /// h in Q32.
    h: u32,
    /// Whether g < 0.
    back: bool,
    grade: PhantomData<G>,
}

/// 1 in Q63.
const ONE: u64 = 1 << 63;

impl<G: Grade> HenyeyGreenstein<G> {
    /// The phase function of asymmetry `g`, with 1 − |g| from 2⁻¹⁷ to 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where 1 − |g| is 0 or less, [`Error::Empty`] where it is below 2⁻¹⁷ and the density
    /// overflows.
    pub const fn new(g: Coordinate) -> Result<Self, Error> {
        let h = g.to_bits().unsigned_abs();
        if h >= 1 << 30 {
            return Err(Error::OutOfRange(0));
        }
        Self::of(ONE - ((h as u64) << 33), g.to_bits() < 0)
    }

    /// The phase function of the asymmetry g for which 1 − g is `complement`, in (0, 2).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for 0, and for 2 and more; [`Error::Empty`] where 1 − |g| is below 2⁻¹⁷ and the density
    /// overflows.
    pub const fn from_one_minus(complement: U2F62) -> Result<Self, Error> {
        match complement.to_bits() {
            0 | ONE.. => Err(Error::OutOfRange(0)),
            bits if bits <= ONE >> 1 => Self::of(bits << 1, false),
            bits => Self::of((ONE - bits) << 1, true),
        }
    }

    const fn of(least: u64, back: bool) -> Result<Self, Error> {
        if least < ONE >> 17 {
            return Err(Error::Empty(0));
        }
        Ok(Self {
            least,
            h: ((ONE - least) >> 31) as u32,
            back,
            grade: PhantomData,
        })
    }

    /// 1 − g.
    #[must_use]
    pub const fn one_minus_asymmetry(&self) -> U2F62 {
        let bits = self.least >> 1;
        U2F62::from_bits(if self.back { ONE - bits } else { bits })
    }

    /// 1 + h.
    #[inline]
    const fn most(&self) -> Scaled {
        Scaled::of(ONE + (ONE - self.least), 63)
    }

    /// (1 − cos)/2 or (1 + cos)/2 of the angle to the peak, the smaller, and whether it is the latter.
    #[inline]
    fn nearer_pole(&self, u1: u32) -> (Scaled, bool) {
        let (u, rest) = (u64::from(u1), (1 << 32) - u64::from(u1));
        // v is the share of directions farther from the peak, and the rise hv in Q64.
        let (u, v, rise) = if self.back {
            (rest, u, wide(self.h, u1))
        } else {
            (u, rest, wide(self.h, !u1) + u64::from(self.h))
        };
        // 2hv is the same in Q63.
        let divisor = Scaled::of(self.least + rise, 63);
        let pole = |share: u64, end: Scaled, by: u64| {
            let ratio = end.over(divisor);
            let half = ratio.times(ratio).times(Scaled::of(by, 63));
            let half = half.times(Scaled::of(share, 32));
            Scaled::normal(half.mantissa, half.exponent)
        };
        let down = pole(u, Scaled::of(self.least, 63), ONE + (rise >> 1));
        if down.to_bits(32) >> 31 == 0 {
            (down, false)
        } else {
            (pole(v, self.most(), self.least + (rise >> 1)), true)
        }
    }

    /// 1 − cos of the angle to the peak, and S² in Q60.
    #[inline]
    fn off_peak(&self, [x, y, z]: [Coordinate; 3]) -> (Scaled, u64) {
        let z = if self.back { z.saturating_neg() } else { z };
        let off = one_minus_cos([x, y, z]);
        let least = Scaled::of(self.least, 63);
        let more = long(Scaled::normal(self.h, -1).times(off));
        (off, long(least.times(least)) + more)
    }
}

/// In Q60, cut.
#[inline]
const fn long(x: Scaled) -> u64 {
    if x.exponent > 91 {
        0
    } else {
        x.to_long_bits(60)
    }
}

/// The square root of a number with a mantissa that has its first bit set.
#[inline]
fn root<G: Grade>(x: Scaled) -> Scaled {
    let odd = x.exponent & 1;
    Scaled::normal(G::root(x.mantissa >> odd), (x.exponent - odd) >> 1)
}

impl<G: Grade> Warp for HenyeyGreenstein<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 3];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 3] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        let (half, below) = self.nearer_pole(u1);
        let [x, y, z] = half.direction::<G>(u2);
        [x, y, if below == self.back { z } else { -z }]
    }

    #[inline]
    fn pdf(&self, point: [Coordinate; 3]) -> Density {
        let (_, square) = self.off_peak(point);
        let square = Scaled::of(square, 60);
        let cube = square.times(root::<G>(square));
        let cube = Scaled::normal(cube.mantissa, cube.exponent);
        // 1/(4π) is half of 1/(2π).
        let top = Scaled::of(self.least, 63).times(self.most());
        let top = top.times(PER_ANGLE);
        let density = Scaled::normal(top.mantissa, top.exponent + 1).over(cube);
        Density::from_bits(density.to_long_bits(32).max(1))
    }
}

impl<G: Grade> Invert for HenyeyGreenstein<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 3]) -> [Uniform; 2] {
        let [x, y, _] = point;
        let (off, square) = self.off_peak(point);
        let least = Scaled::of(self.least, 63);
        let both = square + long(least.times(root::<G>(Scaled::of(square, 60))));
        let top = self.most().times(off);
        let part = Scaled::normal(top.mantissa, top.exponent)
            .over(Scaled::of(both, 60))
            .to_bits(32);
        let u1 = if self.back {
            part.max(1).wrapping_neg()
        } else {
            part
        };
        [Uniform::from_bits(u1), azimuth::<G>(x, y)]
    }
}
