//! The uniform distribution over the sphere of directions.

use super::direction::{ONE, azimuth, direction, one_minus_cos};
use super::grade::{Fine, Grade};
use super::kernel::product::square;
use super::{Coordinate, Density, Uniform};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use core::marker::PhantomData;

/// Uniform over the unit sphere.
///
/// z = 1 − 2u₁, sin θ = 2√(u₁(1 − u₁)), and the azimuth is u₂ turns. The pole +z is at u₁ = 0.
///
/// # Density
/// 1/(4π) per steradian, to 2⁻³³.
///
/// # Domain
/// - Point: unit vectors.
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
/// | round trip | 3.2e-7 | 9.9e-5 | 3.8e-7 | found |
///
/// The largest error of a sample is proven for all pairs of words: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Sphere -->222 instructions and 416 bytes of code on an M0, 107 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let [_, _, z] = mw::Sphere::new().sample([0.125_f32, 0.5].map(U0F32::from_num));
/// assert_eq!(z, 0.75);
/// ```
///
/// # See also
/// - [`Hemisphere`](super::Hemisphere) and [`Cone`](super::Cone) are parts of the sphere.
/// - [`warp::Sphere`](crate::warp::Sphere) is the sphere of the float tiers.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://www.pbr-book.org/3ed-2018/Monte_Carlo_Integration>.
#[doc(alias = "direction")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sphere<G = Fine>(PhantomData<G>);

impl<G: Grade> Sphere<G> {
    /// All directions.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// 1/(4π) in Q32.
const DENSITY: Density = Density::from_bits(341_782_638);

impl<G: Grade> Warp for Sphere<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 3];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 3] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        // The distance from the nearer pole, at most 1/2.
        let from_pole = if u1 >> 31 == 0 { u1 } else { u1.wrapping_neg() };
        // A quarter of sin² θ. It is cut by up to 2⁻³⁰ at the equator, where 1/4 would overflow the shift.
        let quarter = from_pole - square(from_pole) - (from_pole >> 29);
        direction::<G>(G::root(quarter << 2), ONE - (u1 >> 1) as i32, u2)
    }

    #[inline]
    fn pdf(&self, _: [Coordinate; 3]) -> Density {
        DENSITY
    }
}

impl<G: Grade> Invert for Sphere<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 3]) -> [Uniform; 2] {
        let [x, y, _] = point;
        let u1 = one_minus_cos(point).to_bits(31);
        [Uniform::from_bits(u1), azimuth::<G>(x, y)]
    }
}
