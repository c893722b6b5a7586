//! The phase function of Henyey and Greenstein.

use super::direction::{around, azimuth, is_direction, one_minus_cos};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, finite, positive};
use crate::num::{into_unit, remainder, two_product, two_sum};
use crate::tier::Tier;
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;

/// 2¹²⁴, its reciprocal and the root of that. Sums that a uniform is multiplied by are kept lifted by it, so that no product
/// underflows.
const LIFT: f32 = 2.126_764_8e37;
const UNLIFT: f32 = 1.0 / LIFT;
const UNLIFT_ROOT: f32 = 2.168_404_3e-19;

/// The phase function of Henyey and Greenstein: where fog, clouds, skin or dust scatter light.
///
/// Directions are local, about +z, the direction in which the light travels. The asymmetry g is the mean of cos θ:
/// g > 0 favours +z, g < 0 sends the light back, and g = 0 is the uniform sphere. With h = |g|, w = 1 − u₁ for g ≥
/// 0 and w = u₁ below, c = (1 − h) + 2hw, 1 − cos θ is 2u₁((1 − g)/c)²(1 + hw) and 1 + cos θ is 2(1 − u₁)((1 +
/// g)/c)²((1 − h) + hw); for g < 0 the two sums change places. Nothing is divided by g and both poles keep their
/// digits, so that neither g = 1e-30 nor g = 1 − 2⁻²⁴ is a special case.
///
#[cfg_attr(doc, doc = include_str!("../pictures/henyey_greenstein.html"))]
///
/// # Density
/// (1 − g²)/(4πS³) per steradian for any finite direction, where S = √(1 + g² − 2g cos θ) is the distance from the
/// direction to the point g of the axis. The code works with S² = (1 − h)² + 2h(1 ∓ cos θ).
///
/// # Domain
/// - Point: unit vectors. For |g| near 1 most of them have z = ±1, and x and y hold all the information, which
///   `pdf` and `invert` use.
/// - Uniforms: two, for the polar angle and the azimuth. +z is at u₁ = 0.
/// - Parameters: g in (−1, 1), or 1 − |g| from 2⁻³² to 1 and a side.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 6.1e-7 | 6.2e-7 | proven |
/// | sin θ, ulp | 7.7 | 7.7 | proven |
/// | unit length | 1.8e-7 | 2.3e-7 | proven |
/// | pdf, relative | 7.6e-7 | 7.6e-7 | found |
/// | realised density, relative | 2.1e-6 | 2.1e-6 | found |
/// | pdf with the sample, relative | 1.1e-6 | 1.1e-6 | found |
/// | inverse | 4.9e-7 | 4.9e-7 | found |
/// | round trip | 4.9e-7 | 4.9e-7 | found |
///
/// These hold for every g and every constructor. They count from the number that it is given: near 1 the rounding of g
/// to an `f32`, up to 3e-8, changes the width of the peak, 1 − |g|, which
/// [`from_one_minus_g`](HenyeyGreenstein::from_one_minus_g) and
/// [`from_one_plus_g`](HenyeyGreenstein::from_one_plus_g) take as it is.
///
/// The errors of the sample, of sin θ and of the length are proven for every g and every pair of uniforms: see
/// `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost HenyeyGreenstein -->108 instructions and 516 bytes of code on an M4F, 5,457 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let fog = mw::HenyeyGreenstein::new(0.9)?;
/// let [_, _, z] = fog.sample([0.5, 0.25]);
/// assert!(z > 0.985); // half of the light turns by less than ten degrees
/// assert!(fog.pdf([0.0, 0.0, 1.0]) > 6000.0 * fog.pdf([0.0, 0.0, -1.0]));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Sphere`](super::Sphere): isotropic scattering, g = 0, at a lower cost.
/// - [`Oriented`](super::Oriented) turns it onto the direction of travel.
/// - [`TruncatedExponential`](super::TruncatedExponential), [`Exponential`](super::Exponential): how far the light
///   goes.
///
/// # Source
/// L. G. Henyey and J. L. Greenstein, "Diffuse Radiation in the Galaxy", 1941, <https://doi.org/10.1086/144246>.
/// The inverse CDF is that of M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition,
/// 2023, <https://pbr-book.org/4ed/Volume_Scattering/Phase_Functions>, rearranged here.
#[doc(alias = "phase_function")]
#[doc(alias = "scattering")]
#[doc(alias = "anisotropy")]
#[doc(alias = "hg")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HenyeyGreenstein<T> {
    g: f32,
    /// 1 − h.
    least: f32,
    /// (1 − g)², lifted.
    ahead: f32,
    /// (1 + g)², lifted.
    behind: f32,
    /// (1 − h)²/2h.
    width: f32,
    /// What keeps cubes in the range of `f32`.
    unit: f32,
    /// ((1 − g²)/4π)²/(2h)³, times the cube of the unit.
    norm: f32,
    /// 1/(4π(1 − g²)²).
    scale: f32,
    tier: PhantomData<T>,
}

/// 1/(4π) and the rounding error of its `f32`. The compiler computes them: no double reaches the target.
const QUARTER: f32 = 0.25 * FRAC_1_PI;
const QUARTER_REST: f32 = (0.25 * core::f64::consts::FRAC_1_PI - QUARTER as f64) as f32;

/// A sum of two over a divisor, and the rounding error of the quotient.
const fn quotient((a, rest): (f32, f32), divisor: f32) -> (f32, f32) {
    let quotient = a / divisor;
    let lost = (remainder(a, quotient, divisor) + rest) / divisor;
    (quotient, lost)
}

/// The same, with the error added.
const fn over(sum: (f32, f32), divisor: f32) -> f32 {
    let (quotient, lost) = quotient(sum, divisor);
    quotient + lost
}

/// 2h, or 2⁻²⁹ where h is so small that it changes no digit of a density.
const fn twice(g: f32) -> f32 {
    const FLAT: f32 = 9.313_226e-10;
    let h = g.abs();
    2.0 * if h > FLAT { h } else { FLAT }
}

/// The square of a sum of two, and its rounding error.
const fn square((sum, rest): (f32, f32)) -> (f32, f32) {
    let (square, dropped) = two_product(sum, sum);
    (square, dropped + 2.0 * sum * rest)
}

/// (left/4π)²/scale³ times unit³, of left = 1 − g².
const fn norm_squared((left, rest): (f32, f32), scale: f32, unit: f32) -> f32 {
    let (norm, lost) = two_product(left, QUARTER);
    let lost = lost + (left * QUARTER_REST + rest * QUARTER);
    let (n, short) = quotient((norm, lost), scale);
    let (square, dropped) = two_product(n, n);
    over((square, dropped + 2.0 * n * short), scale) * (unit * unit * unit)
}

/// 1/(4π left²).
const fn inverse_square((left, rest): (f32, f32)) -> f32 {
    let (square, lost) = two_product(left, left);
    let lack = (lost + 2.0 * left * rest) / square;
    let (scale, short) = quotient((QUARTER, QUARTER_REST), square);
    scale + (short - scale * lack)
}

/// The unit, 2¹², and that of the peaks that `f32` cannot tell by g, 2²⁴.
const UNIT: f32 = 4096.0;
const FINE_UNIT: f32 = 16_777_216.0;

/// The narrowest peak, 2⁻³² in 1 − h: the square of its density is just below the largest `f32`.
const NARROWEST: f32 = 1.0 / 4_294_967_296.0;

impl<T: Tier> HenyeyGreenstein<T> {
    /// The phase function of asymmetry `g`, in (−1, 1).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::OutOfRange`] for 1 or more and for −1 or less, where all the
    /// light goes one way and there is no density.
    pub const fn new(g: f32) -> Result<Self, Error> {
        match finite(g, 0) {
            Ok(g) if g.abs() >= 1.0 => Err(Error::OutOfRange(0)),
            Ok(g) => {
                let (product, dropped) = two_product(g, g);
                let (left, rest) = two_sum(1.0, -product);
                let h = g.abs();
                let (near, far) = (square(two_sum(1.0, -h)), square(two_sum(1.0, h)));
                let least = 1.0 - h;
                Ok(Self::of(g, least, [near, far], (left, rest - dropped)))
            }
            Err(e) => Err(e),
        }
    }

    /// Of asymmetry 0 or more, by 1 − g from 2⁻³² (2.3e-10) to 1, the width of a narrow peak, which a rounded g does not
    /// tell.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::OutOfRange`] below 2⁻³²
    /// and above 1.
    pub const fn from_one_minus_g(one_minus_g: f32) -> Result<Self, Error> {
        Self::peaked(one_minus_g, 1.0)
    }

    /// Of asymmetry 0 or less, by 1 + g: the mirror image of [`from_one_minus_g`](Self::from_one_minus_g), whose light
    /// turns back.
    ///
    /// # Errors
    /// Those of [`from_one_minus_g`](Self::from_one_minus_g).
    pub const fn from_one_plus_g(one_plus_g: f32) -> Result<Self, Error> {
        Self::peaked(one_plus_g, -1.0)
    }

    const fn peaked(least: f32, side: f32) -> Result<Self, Error> {
        match positive(least, 0) {
            Ok(least) if least < NARROWEST || least > 1.0 => Err(Error::OutOfRange(0)),
            Ok(least) => {
                let (sum, rest) = two_sum(2.0, -least);
                let (near, far) = (square((least, 0.0)), square((sum, rest)));
                let (left, dropped) = two_product(least, sum);
                let left = (left, dropped + least * rest);
                Ok(Self::of(side * (1.0 - least), least, [near, far], left))
            }
            Err(e) => Err(e),
        }
    }

    /// Of g, 1 − h, the squares of 1 − h and 1 + h, and 1 − g².
    const fn of(g: f32, least: f32, [near, far]: [(f32, f32); 2], left: (f32, f32)) -> Self {
        let (scale, sum) = (twice(g), (near.0 + near.1, far.0 + far.1));
        let (ahead, behind) = if g < 0.0 { (sum.1, sum.0) } else { sum };
        let unit = if g.abs() < 1.0 { UNIT } else { FINE_UNIT };
        Self {
            g,
            least,
            ahead: ahead * LIFT,
            behind: behind * LIFT,
            width: over(near, scale),
            unit,
            norm: norm_squared(left, scale, unit),
            scale: inverse_square(left),
            tier: PhantomData,
        }
    }

    /// The asymmetry g, the mean of cos θ.
    #[must_use]
    pub const fn asymmetry(&self) -> f32 {
        self.g
    }

    /// 1 − |g|, which keeps its digits where g has rounded.
    #[must_use]
    pub const fn one_minus_abs_g(&self) -> f32 {
        self.least
    }

    /// hw and c of the first uniform.
    #[inline]
    fn rise(&self, u1: f32) -> (f32, f32) {
        let h = self.g.abs();
        let rise = h * if self.g < 0.0 { u1 } else { 1.0 - u1 };
        (rise, self.least + 2.0 * rise)
    }

    /// 1 − cos of the angle to the peak, at most 2 for any direction.
    #[inline]
    fn off_peak(self, [x, y, z]: [f32; 3]) -> f32 {
        let off = one_minus_cos([x, y, if self.g < 0.0 { -z } else { z }]);
        if off < 2.0 { off } else { 2.0 }
    }
}

impl<T: Tier> PlanarMap<3> for HenyeyGreenstein<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let _ = self.put(u1, u2, to);
    }

    /// The density is c³/4π over (1 − g²)²: without the root and the quotient of `pdf`, and free of what rounding the
    /// direction does.
    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        let (v, least) = (1.0 - u1, self.least);
        let (from_down, from_up) = if self.g < 0.0 {
            (least, 1.0)
        } else {
            (1.0, least)
        };
        let (rise, c) = self.rise(u1);
        let square = 0.5 * (c * c);
        // 1 - cos θ and 1 + cos θ, lifted, are these over c²/2. Only the smaller is computed.
        let slope = self.ahead * (from_down + rise);
        let (down, up) = (u1 * slope, v * (self.behind * (from_up + rise)));
        let ahead = down <= up;
        let lifted = if ahead { down } else { up } / square;
        let small = lifted * UNLIFT;
        let cos = 1.0 - small;
        let cos = if ahead { cos } else { -cos };
        let sin = T::sqrt(lifted * (2.0 - small)) * UNLIFT_ROOT;
        around::<T>(sin, cos, u2, to);
        c * c * c * self.scale
    }
}

impl<T: Tier> Warp for HenyeyGreenstein<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        if is_direction(direction) {
            // The root halves relative errors.
            let part = self.unit * (self.width + self.off_peak(direction));
            T::sqrt(self.norm / (part * part * part))
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for HenyeyGreenstein<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, _] = direction;
        let (h, off) = (self.g.abs(), self.off_peak(direction));
        let least = if self.g < 0.0 {
            self.behind
        } else {
            self.ahead
        };
        let square = least * UNLIFT + 2.0 * h * off;
        // The probability of directions nearer to the peak.
        let part = (1.0 + h) * off / (square + self.least * T::sqrt(square));
        let u1 = if self.g < 0.0 { 1.0 - part } else { part };
        [into_unit(u1), azimuth::<T>(x, y)]
    }
}
