//! Distributions over the hemisphere about +z: uniform, and in proportion to the cosine.

use super::direction::{azimuth, direction, one_minus_cos};
use super::grade::{Fine, Grade};
use super::kernel::product::{near, square};
use super::{Coordinate, Density, Uniform};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use core::marker::PhantomData;

/// Uniform over the hemisphere about +z.
///
/// z = u₁, sin θ = √(1 − u₁²), and the azimuth is u₂ turns. The horizon is at u₁ = 0.
///
/// # Density
/// 1/(2π) per steradian where z ≥ 0, to 2⁻³³; 0 elsewhere.
///
/// # Domain
/// - Point: unit vectors with z ≥ 0.
/// - Uniforms: two words, polar angle then azimuth.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate, *unit length* the largest error of the length. *Round trip* is the
/// error of the uniforms after `sample` and `invert`: of u₁, and of u₂ times sin θ.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 9.5e-7 | 1.4e-4 | 6.5e-7 | proven |
/// | sample, rms | 1.4e-7 | 4.4e-5 | 2.1e-7 | found |
/// | sample, mean | 0 | -4.5e-6 | 0 | found |
/// | unit length | 7.1e-7 | 1.9e-4 | 7.5e-7 | found |
/// | round trip | 6.4e-7 | 2e-4 | 7.5e-7 | found |
///
/// The largest error of a sample is proven for all pairs of words: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Hemisphere -->214 instructions and 432 bytes of code on an M0, 103 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let [_, _, z] = mw::Hemisphere::new().sample([0.75_f32, 0.5].map(U0F32::from_num));
/// assert_eq!(z, 0.75);
/// ```
///
/// # See also
/// - [`CosineHemisphere`](super::CosineHemisphere) suits light on a matt surface better.
/// - [`Sphere`](super::Sphere), [`Cone`](super::Cone): all directions, and those near +z.
/// - [`warp::Hemisphere`](crate::warp::Hemisphere) is the hemisphere of the float tiers.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://www.pbr-book.org/3ed-2018/Monte_Carlo_Integration>.
#[doc(alias = "direction")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hemisphere<G = Fine>(PhantomData<G>);

impl<G: Grade> Hemisphere<G> {
    /// The directions with z ≥ 0.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// 1/(2π) in Q32.
const DENSITY: Density = Density::from_bits(683_565_276);

impl<G: Grade> Warp for Hemisphere<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 3];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 3] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        // sin² θ. Near the pole from 1 − u, which is exact there; the subtraction undoes the overflow of the shift.
        let square = if u1 >> 31 == 0 {
            !square(u1)
        } else {
            let rest = u1.wrapping_neg();
            (rest << 1).wrapping_sub(square(rest))
        };
        direction::<G>(G::root(square), (u1 >> 2) as i32, u2)
    }

    #[inline]
    fn pdf(&self, point: [Coordinate; 3]) -> Density {
        let [_, _, z] = point;
        if z >= Coordinate::ZERO {
            DENSITY
        } else {
            Density::ZERO
        }
    }
}

impl<G: Grade> Invert for Hemisphere<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 3]) -> [Uniform; 2] {
        let [x, y, z] = point;
        let u1 = if z > Coordinate::ZERO {
            // 1 − (1 − cos θ), which keeps what x and y tell near the pole.
            match one_minus_cos(point).to_bits(32) {
                0 => u32::MAX,
                rest => rest.wrapping_neg(),
            }
        } else {
            0
        };
        [Uniform::from_bits(u1), azimuth::<G>(x, y)]
    }
}

/// In proportion to the cosine over the hemisphere about +z (Lambert's law), by inversion.
///
/// sin θ = √u₁, cos θ = √(1 − u₁), and the azimuth is u₂ turns. The pole is at u₁ = 0.
///
/// # Density
/// cos θ/π per steradian where z > 0, to 2⁻²⁸; 0 elsewhere, never at a sample.
///
/// # Domain
/// - Point: unit vectors with z ≥ 2⁻¹⁷.
/// - Uniforms: two words, polar angle then azimuth.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate, *unit length* the largest error of the length. *Round trip* is the
/// error of the uniforms after `sample` and `invert`: of u₁, and of u₂ times sin θ.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 9.5e-7 | 1.4e-4 | 6.5e-7 | proven |
/// | sample, rms | 1.3e-7 | 4.0e-5 | 1.9e-7 | found |
/// | sample, mean | -1.2e-9 | -6.4e-6 | -6.5e-9 | found |
/// | unit length | 7.2e-7 | 1.9e-4 | 7.5e-7 | found |
/// | round trip | 7.2e-7 | 2e-4 | 7.5e-7 | found |
///
/// The largest error of a sample is proven for all pairs of words: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed CosineHemisphere -->240 instructions and 476 bytes of code on an M0, 116 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let [_, _, z] = mw::CosineHemisphere::new().sample([0.75_f32, 0.5].map(U0F32::from_num));
/// assert_eq!(z, 0.5);
/// ```
///
/// # See also
/// - [`Hemisphere`](super::Hemisphere) is uniform.
/// - [`PhongLobe`](super::PhongLobe) takes any power of the cosine; its exponent 1 is this distribution.
/// - [`warp::CosineHemisphere`](crate::warp::CosineHemisphere) is the one of the float tiers.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://www.pbr-book.org/3ed-2018/Monte_Carlo_Integration>.
#[doc(alias = "lambertian")]
#[doc(alias = "lambert")]
#[doc(alias = "diffuse")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CosineHemisphere<G = Fine>(PhantomData<G>);

impl<G: Grade> CosineHemisphere<G> {
    /// The directions with z ≥ 0.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// 1/π in Q32.
const PER_COSINE: u32 = 1_367_130_551;

impl<G: Grade> Warp for CosineHemisphere<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 3];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 3] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        let rest = if u1 == 0 { u32::MAX } else { u1.wrapping_neg() };
        let cos = G::root(rest) >> 2;
        direction::<G>(G::root(u1), cos as i32, u2)
    }

    #[inline]
    fn pdf(&self, point: [Coordinate; 3]) -> Density {
        let [_, _, z] = point;
        if z > Coordinate::ZERO {
            // Q30 times Q32, cut: up to 2³² for a z up to 2.
            Density::from_bits(u64::from(near(z.to_bits() as u32, PER_COSINE)) << 2 | 2)
        } else {
            Density::ZERO
        }
    }
}

impl<G: Grade> Invert for CosineHemisphere<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 3]) -> [Uniform; 2] {
        let [x, y, z] = point;
        let u1 = if z > Coordinate::ZERO {
            // 1 − cos² = a (2 − a), from half of a.
            let half = one_minus_cos(point).to_bits(31).min(1 << 31);
            let quarter = half - square(half).min(half);
            if quarter >> 30 == 0 {
                quarter << 2
            } else {
                u32::MAX
            }
        } else {
            u32::MAX
        };
        [Uniform::from_bits(u1), azimuth::<G>(x, y)]
    }
}
