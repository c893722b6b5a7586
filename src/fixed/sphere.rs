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
/// z = 1 − 2u₁, sin θ = 2√(u₁(1 − u₁)), φ = u₂ turns: the pole +z is at u₁ = 0.
///
/// - Uniforms: two words, polar then azimuth.
/// - Range: unit vectors.
/// - Density: 1/(4π) per steradian, to 2⁻³³.
///
/// In *sample* the error of a coordinate; in *round trip* of u₁, and of u₂ times sin θ:
///
/// | error | fine | coarse | compact |
/// |---|--:|--:|--:|
/// | sample, max | 9.5e-7 | 1.4e-4 | 6.5e-7 |
/// | sample, rms | 1.4e-7 | 4.4e-5 | 2.1e-7 |
/// | sample, mean | 0 | -4.5e-6 | 0 |
/// | unit length | 5.9e-7 | 1.6e-4 | 6.0e-7 |
/// | round trip | 2.7e-7 | 8.1e-5 | 3.1e-7 |
///
/// The largest error of a sample is a bound for all pairs of words: see `docs/proofs.md`.
///
/// Source: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 2016.
///
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let [_, _, z] = mw::Sphere::new().sample([0.125_f32, 0.5].map(U0F32::from_num));
/// assert_eq!(z, 0.75);
/// ```
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
        // From the nearer pole, at most 1/2.
        let from_pole = if u1 >> 31 == 0 { u1 } else { u1.wrapping_neg() };
        // A quarter of sin² θ; cut by up to 2⁻³⁰ at the equator, where it would reach 1/4 and the shift overflow.
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
