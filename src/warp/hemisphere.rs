//! The upper hemisphere: uniform, and in proportion to the cosine by inversion and by Malley's method.

use super::direction::{around, azimuth, is_direction};
use super::disk::{concentric, concentric_inverse};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::num::{above_zero, into_unit, representable};
use crate::tier::Tier;
use crate::uniform::open_from_word;
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;

/// Uniform over the hemisphere about +z.
///
/// z = u₁, sin θ = √(2d − d²) with d = 1 − u₁, φ = u₂ turns.
///
#[cfg_attr(doc, doc = include_str!("../pictures/hemisphere.html"))]
///
/// # Density
/// 1/(2π) per steradian where z ≥ 0, else 0.
///
/// # Domain
/// - Point: unit vectors with z ≥ 0.
/// - Uniforms: two, for height and azimuth. The horizon is at u₁ = 0.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 1.7e-7 | 2.0e-7 | proven |
/// | sin θ, ulp | 1.3 | 1.3 | proven |
/// | unit length | 1.4e-7 | 1.9e-7 | proven |
/// | pdf, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | realised density, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | inverse | 2e-7 | 2.6e-7 | found |
/// | round trip | 7.8e-8 | 8e-8 | found |
///
/// The errors of the sample, of sin θ and of the length are proven for every pair of uniforms: see
/// `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Hemisphere -->81 instructions and 360 bytes of code on an M4F, 3,734 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let hemisphere = mw::Hemisphere::new();
/// assert_eq!(hemisphere.sample([0.0, 0.5]), [-1.0, 0.0, 0.0]);
/// assert_eq!(hemisphere.pdf([0.0, 0.0, -1.0]), 0.0);
/// ```
///
/// # See also
/// - [`CosineHemisphere`](super::CosineHemisphere): in proportion to the cosine, which suits diffuse surfaces.
/// - [`Oriented`](super::Oriented) turns it onto a normal.
/// - [`Sphere`](super::Sphere), [`Cone`](super::Cone): other domains.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>.
#[doc(alias = "uniform")]
#[doc(alias = "ambient_occlusion")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hemisphere<T>(PhantomData<T>);

impl<T: Tier> Hemisphere<T> {
    /// The directions with z ≥ 0.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// 1/(2π).
const UNIFORM: f32 = 0.5 * FRAC_1_PI;

impl<T: Tier> PlanarMap<3> for Hemisphere<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        // sin² = 1 - u² in terms of 1 - u, which is exact where it is small.
        let rest = 1.0 - u1;
        around::<T>(T::sqrt((rest + rest) - rest * rest), u1, u2, to);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        UNIFORM
    }
}

impl<T: Tier> Warp for Hemisphere<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let [_, _, z] = direction;
        if z >= 0.0 && is_direction(direction) {
            UNIFORM
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Hemisphere<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, z] = direction;
        [into_unit(z), azimuth::<T>(x, y)]
    }
}

/// In proportion to the cosine over the hemisphere about +z (Lambert's law), by inversion.
///
/// sin θ = √u₁, cos θ = √(1 − u₁), φ = u₂ turns.
///
#[cfg_attr(doc, doc = include_str!("../pictures/cosine_hemisphere.html"))]
///
/// # Density
/// cos θ/π per steradian where z > 0, else 0. Never 0 at a sample, whose z is at least 2⁻¹².
///
/// # Domain
/// - Point: unit vectors with z > 0.
/// - Uniforms: two, for the polar angle and the azimuth. The pole is at u₁ = 0.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 1.4e-7 | 1.7e-7 | proven |
/// | sin θ, ulp | 0.51 | 0.51 | proven |
/// | cos θ, ulp | 0.86 | 0.86 | proven |
/// | unit length | 1.2e-7 | 1.7e-7 | proven |
/// | pdf, relative | 4.7e-7 | 5.7e-7 | found |
/// | realised density, relative | 2.1e-7 | 2.1e-7 | found |
/// | inverse | 2.4e-7 | 3e-7 | found |
/// | round trip | 2.0e-7 | 2.4e-7 | found |
///
/// The errors of the sample, of sin θ, of cos θ and of the length are proven for every pair of uniforms: see
/// `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost CosineHemisphere -->83 instructions and 364 bytes of code on an M4F, 3,813 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let lambert = mw::CosineHemisphere::new();
/// assert_eq!(lambert.sample([0.0, 0.0]), [0.0, 0.0, 1.0]);
/// assert_eq!(lambert.invert([0.0, 0.0, 1.0]), [0.0, 0.0]);
/// ```
///
/// # See also
/// - [`MalleyHemisphere`](super::MalleyHemisphere) has the same density and keeps strata compact: take it with
///   stratified or low-discrepancy uniforms.
/// - [`PhongLobe`](super::PhongLobe): any power of the cosine.
/// - [`Oriented`](super::Oriented) turns it onto a normal.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>.
#[doc(alias = "lambertian")]
#[doc(alias = "lambert")]
#[doc(alias = "diffuse")]
#[doc(alias = "cosine_weighted")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CosineHemisphere<T>(PhantomData<T>);

impl<T: Tier> CosineHemisphere<T> {
    /// The directions with z > 0, weighted by z.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

#[inline]
fn cosine_density(direction: [f32; 3]) -> f32 {
    let [_, _, z] = direction;
    if z > 0.0 && is_direction(direction) {
        representable(z * FRAC_1_PI)
    } else {
        0.0
    }
}

/// The same of a sample, whose height is far above the smallest number.
#[inline]
fn sample_density([_, _, z]: [f32; 3]) -> f32 {
    z * FRAC_1_PI
}

impl<T: Tier> PlanarMap<3> for CosineHemisphere<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        around::<T>(T::sqrt(u1), T::sqrt(1.0 - u1), u2, to);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        sample_density(*to)
    }
}

impl<T: Tier> Warp for CosineHemisphere<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        cosine_density(direction)
    }
}

impl<T: Tier> Invert for CosineHemisphere<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, z] = direction;
        // The smaller of sin² and cos² holds the digits.
        let sin2 = x * x + y * y;
        let u1 = if sin2 < 0.5 { sin2 } else { 1.0 - z * z };
        [into_unit(u1), azimuth::<T>(x, y)]
    }
}

/// In proportion to the cosine over the hemisphere about +z (Lambert's law), by Malley's method.
///
/// A point of the concentric disk, lifted onto the hemisphere. Strata stay compact, as with
/// [`DiskConcentric`](super::DiskConcentric). 1 − r² is formed from the uniforms, where it does not cancel.
///
#[cfg_attr(doc, doc = include_str!("../pictures/malley_hemisphere.html"))]
///
/// # Density
/// cos θ/π per steradian where z > 0, else 0. Never 0 at a sample.
///
/// # Domain
/// - Point: unit vectors with z > 0.
/// - Uniforms: two. (½, ½) gives the pole. Drawing takes them from the grid without 0,
///   so that no draw lies nearer to the horizon than its share. [`uniform::open`](crate::uniform::open) is that grid.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 2.2e-7 | 2.1e-7 | proven |
/// | unit length | 1.3e-7 | 1.8e-7 | proven |
/// | pdf, relative | 1.3e-7 | 1.3e-7 | found |
/// | realised density, relative | 2.5e-7 | 2.5e-7 | found |
/// | inverse | 2.1e-7 | 2.1e-7 | found |
/// | round trip | 1.8e-7 | 1.8e-7 | found |
///
/// The errors of the sample and of the length are proven for every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost MalleyHemisphere -->119 instructions and 544 bytes of code on an M4F, 4,579 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let lambert = mw::MalleyHemisphere::new();
/// assert_eq!(lambert.sample([0.5, 0.5]), [0.0, 0.0, 1.0]);
/// ```
///
/// # See also
/// - [`CosineHemisphere`](super::CosineHemisphere) has the same density at a lower cost: take it with independent
///   random uniforms.
/// - [`Oriented`](super::Oriented) turns it onto a normal.
///
/// # Source
/// T. J. V. Malley, "A Shading Method for Computer Generated Images", master's thesis, University of Utah, 1988. P.
/// Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools, 1997,
/// <https://doi.org/10.1080/10867651.1997.10487479>.
#[doc(alias = "lambertian")]
#[doc(alias = "lambert")]
#[doc(alias = "diffuse")]
#[doc(alias = "cosine_weighted")]
#[doc(alias = "malley")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MalleyHemisphere<T>(PhantomData<T>);

impl<T: Tier> MalleyHemisphere<T> {
    /// The directions with z > 0, weighted by z.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T: Tier> PlanarMap<3> for MalleyHemisphere<T> {
    #[inline]
    fn uniform_of_word(word: u32) -> f32 {
        open_from_word(word)
    }

    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let [x, y] = concentric::<T>([u1, u2]);
        // The radius is 1 - 2m, so 1 - r² = 4m(1 - m).
        let least = |a: f32, b: f32| if a < b { a } else { b };
        let m = above_zero(least(least(u1, 1.0 - u1), least(u2, 1.0 - u2)));
        *to = [x, y, 2.0 * T::sqrt(m * (1.0 - m))];
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        sample_density(*to)
    }
}

impl<T: Tier> Warp for MalleyHemisphere<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        cosine_density(direction)
    }
}

impl<T: Tier> Invert for MalleyHemisphere<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, z] = direction;
        let r = into_unit(T::sqrt(x * x + y * y));
        // Near the rim 1 - r comes from the height.
        let to_rim = if r > 0.5 { z * z / (1.0 + r) } else { 1.0 - r };
        concentric_inverse::<T>([x, y], to_rim)
    }
}
