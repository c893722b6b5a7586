//! The uniform distribution over all directions.

use super::direction::{around, azimuth, is_direction, one_minus_cos};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::num::into_unit;
use crate::tier::Tier;
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;

/// Uniform over the unit sphere.
///
/// z = 1 − 2u₁, sin θ = 2√(u₁(1 − u₁)), φ = u₂ turns: the pole +z is at u₁ = 0.
///
/// - Uniforms: two, polar then azimuth.
/// - Range: unit vectors.
/// - Density: 1/(4π) per steradian, for any finite direction.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, of the size | 1.7e-7 | 2.1e-7 |
/// | sin θ, ulp | 1.26 | 1.26 |
/// | unit length | 1.6e-7 | 2.1e-7 |
/// | pdf, relative | 4.5e-8 | 4.5e-8 |
/// | realised density, relative | 4.5e-8 | 4.5e-8 |
/// | inverse | 9e-8 | 9e-8 |
/// | round trip | 1.0e-7 | 1.0e-7 |
///
/// The errors of the sample, of sin θ and of the length are proven for every pair of uniforms: see
/// `docs/proofs.md`.
///
/// Source: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 2016.
///
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let sphere = mw::Sphere::new();
/// assert_eq!(sphere.sample([0.5, 0.25]), [0.0, 1.0, 0.0]);
/// assert_eq!(sphere.invert([0.0, 1.0, 0.0]), [0.5, 0.25]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sphere<T>(PhantomData<T>);

impl<T: Tier> Sphere<T> {
    /// All directions.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T: Tier> PlanarMap<3> for Sphere<T> {
    #[inline]
    fn map(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let sin = 2.0 * T::sqrt(u1 * (1.0 - u1));
        around::<T>(sin, 1.0 - 2.0 * u1, u2, to);
    }
}

impl<T: Tier> Warp for Sphere<T> {
    planar!(3, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        if is_direction(direction) {
            0.25 * FRAC_1_PI
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Sphere<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, _] = direction;
        [
            into_unit(0.5 * one_minus_cos(direction)),
            azimuth::<T>(x, y),
        ]
    }
}
