//! The uniform distribution over all directions.

use super::direction::{around, azimuth, is_direction, one_minus_cos};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::num::into_unit;
use crate::tier::Tier;
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;

/// Uniform over the unit sphere: all directions alike.
///
/// z = 1 − 2u₁, sin θ = 2√(u₁(1 − u₁)), φ = u₂ turns.
///
#[cfg_attr(doc, doc = include_str!("../pictures/sphere.html"))]
///
/// # Density
/// 1/(4π) per steradian, for any finite direction.
///
/// # Domain
/// - Point: unit vectors.
/// - Uniforms: two, for height and azimuth. The pole +z is at u₁ = 0.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 1.7e-7 | 2.1e-7 | proven |
/// | sin θ, ulp | 1.26 | 1.26 | proven |
/// | unit length | 1.6e-7 | 2.1e-7 | proven |
/// | pdf, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | realised density, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | inverse | 1.2e-7 | 1.2e-7 | found |
/// | round trip | 1.0e-7 | 1.2e-7 | found |
///
/// The errors of the sample, of sin θ and of the length are proven for every pair of uniforms: see
/// `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Sphere -->86 instructions and 380 bytes of code on an M4F, 3,839 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let sphere = mw::Sphere::new();
/// assert_eq!(sphere.sample([0.5, 0.25]), [0.0, 1.0, 0.0]);
/// assert_eq!(sphere.invert([0.0, 1.0, 0.0]), [0.5, 0.25]);
/// ```
///
/// # See also
/// - [`Hemisphere`](super::Hemisphere), [`Cone`](super::Cone), [`SphericalPatch`](super::SphericalPatch): parts of
///   it.
/// - [`HenyeyGreenstein`](super::HenyeyGreenstein): scattering that favours a direction.
/// - [`rejection::BallRejection`](crate::rejection::BallRejection): the ball inside.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>.
#[doc(alias = "direction")]
#[doc(alias = "isotropic")]
#[doc(alias = "uniform")]
#[doc(alias = "unit_vector")]
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

/// 1/(4π).
const DENSITY: f32 = 0.25 * FRAC_1_PI;

impl<T: Tier> PlanarMap<3> for Sphere<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let sin = 2.0 * T::sqrt(u1 * (1.0 - u1));
        around::<T>(sin, 1.0 - 2.0 * u1, u2, to);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        DENSITY
    }
}

impl<T: Tier> Warp for Sphere<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        if is_direction(direction) {
            DENSITY
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
