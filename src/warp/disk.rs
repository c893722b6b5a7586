//! The uniform distribution on the unit disk: by polar inversion, and by Shirley's concentric map.

use super::planar::{PlanarMap, planar};
use super::{Invert, Warp, direction::azimuth};
use crate::num::into_unit;
use crate::tier::{Tier, exchanged};
use crate::uniform::LARGEST;
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;

/// The largest radius of either map, one step below 1. Rounding of sine, cosine and the products carries no point over
/// the rim (`tests/laws` tries all of it).
const RIM: f32 = LARGEST;

/// Uniform on the unit disk, by polar coordinates.
///
/// r = √u₁, θ = u₂ turns.
///
#[cfg_attr(doc, doc = include_str!("../pictures/disk.html"))]
///
/// # Density
/// 1/π per unit area where x² + y² ≤ 1, else 0.
///
/// # Domain
/// - Point: x² + y² ≤ 1, always.
/// - Uniforms: two, radius and angle. Two zeros give the centre.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 1.4e-7 | 1.7e-7 | proven |
/// | pdf, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | realised density, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | inverse | 1.1e-7 | 9.7e-8 | found |
/// | round trip | 3.1e-7 | 4.8e-7 | found |
///
/// The error of a sample is proven for every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Disk -->78 instructions and 344 bytes of code on an M4F, 3,246 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let disk = mw::Disk::new();
/// assert_eq!(disk.sample([0.25, 0.5]), [-0.5, 0.0]);
/// assert_eq!(disk.invert([-0.5, 0.0]), [0.25, 0.5]);
/// ```
///
/// # See also
/// - [`DiskConcentric`](super::DiskConcentric) keeps strata compact: take it with stratified or low-discrepancy
///   uniforms.
/// - [`rejection::DiskRejection`](crate::rejection::DiskRejection) needs no sine and no root, but no fixed number
///   of uniforms either.
///
/// # Source
/// P. Shirley, "Nonuniform Random Point Sets via Warping", Graphics Gems III, 1992.
#[doc(alias = "circle")]
#[doc(alias = "lens")]
#[doc(alias = "polar")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Disk<T>(PhantomData<T>);

impl<T: Tier> Disk<T> {
    /// The unit disk.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T: Tier> PlanarMap<2> for Disk<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 2]) {
        // The root of the largest uniform is again the largest f32 below 1.
        let r = T::sqrt(u1);
        let (x, y) = T::polar(r, u2);
        *to = [x, y];
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 2]) -> f32 {
        self.map_to(u1, u2, to);
        FRAC_1_PI
    }
}

impl<T: Tier> Warp for Disk<T> {
    planar!(2, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, point: [f32; 2]) -> f32 {
        uniform_density(point)
    }
}

impl<T: Tier> Invert for Disk<T> {
    #[inline]
    fn invert(&self, point: [f32; 2]) -> [f32; 2] {
        let [x, y] = point;
        [into_unit(x * x + y * y), azimuth::<T>(x, y)]
    }
}

#[inline]
fn uniform_density([x, y]: [f32; 2]) -> f32 {
    if x * x + y * y <= 1.0 { FRAC_1_PI } else { 0.0 }
}

/// Uniform on the unit disk, by Shirley and Chiu's concentric map.
///
/// Squares about the centre of the unit square become circles about the centre of the disk. Neighbours stay
/// neighbours and strata stay compact, unlike with the polar map. With a = 2u₁ − 1 and b = 2u₂ − 1, the larger in
/// magnitude is the radius, and their quotient is the angle within its wedge.
///
#[cfg_attr(doc, doc = include_str!("../pictures/disk_concentric.html"))]
///
/// # Density
/// 1/π per unit area where x² + y² ≤ 1, else 0.
///
/// # Domain
/// - Point: x² + y² ≤ 1, always.
/// - Uniforms: two. (½, ½) gives the centre.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 2.1e-7 | 2.1e-7 | proven |
/// | pdf, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | realised density, relative | 4.5e-8 | 4.5e-8 | exhaustive |
/// | inverse | 1.8e-7 | 1.4e-7 | found |
/// | round trip | 2.4e-7 | 2.4e-7 | found |
///
/// The error of a sample is proven for every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost DiskConcentric -->92 instructions and 424 bytes of code on an M4F, 3,399 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let disk = mw::DiskConcentric::new();
/// assert_eq!(disk.sample([0.5, 0.5]), [0.0, 0.0]);
/// assert_eq!(disk.sample([0.75, 0.5]), [0.5, 0.0]);
/// ```
///
/// # See also
/// - [`Disk`](super::Disk) costs less: take it with independent random uniforms.
/// - [`MalleyHemisphere`](super::MalleyHemisphere) lifts this disk onto the hemisphere.
///
/// # Source
/// P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools, 1997,
/// <https://doi.org/10.1080/10867651.1997.10487479>.
#[doc(alias = "concentric")]
#[doc(alias = "shirley")]
#[doc(alias = "circle")]
#[doc(alias = "lens")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DiskConcentric<T>(PhantomData<T>);

impl<T: Tier> DiskConcentric<T> {
    /// The unit disk.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// The concentric map, which Malley's hemisphere uses too.
#[inline]
pub(crate) fn concentric<T: Tier>(u: [f32; 2]) -> [f32; 2] {
    let [a, b] = u.map(|u| 2.0 * u - 1.0);
    let wide = a.abs() > b.abs();
    let (radius, across) = exchanged(!wide, a, b);
    // The angle is at most an eighth of a turn from the axis of its wedge, so that it keeps its digits and needs no
    // reduction. Exchanging sine and cosine reaches the other axis. A sum with 0 is never −0, whatever the sign of the radius.
    let turn = 0.125 * (across / if radius == 0.0 { 1.0 } else { radius }) + 0.0;
    let (sin, cos) = T::sincos_quarter(turn);
    // 2u − 1 is at least −1, and on the other side a step of the grid away from 1.
    let radius = if radius > -RIM { radius } else { -RIM };
    let (x, y) = exchanged(!wide, radius * cos, radius * sin);
    [x, y]
}

/// The inverse of the concentric map for a point whose distance from the rim, 1 − r, is known.
#[inline]
pub(crate) fn concentric_inverse<T: Tier>(point: [f32; 2], to_rim: f32) -> [f32; 2] {
    let [x, y] = point;
    // Half the distance to the rim is the dominant uniform or its complement, exactly as small.
    let m = 0.5 * to_rim;
    let r = 1.0 - to_rim;
    let near = |coordinate: f32| into_unit(if coordinate < 0.0 { m } else { 1.0 - m });
    if x.abs() > y.abs() {
        let across = r * 8.0 * T::atan2_turns(y, x.abs());
        [near(x), into_unit(0.5 + 0.5 * across)]
    } else {
        let across = r * 8.0 * T::atan2_turns(x, y.abs());
        [into_unit(0.5 + 0.5 * across), near(y)]
    }
}

impl<T: Tier> PlanarMap<2> for DiskConcentric<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 2]) {
        *to = concentric::<T>([u1, u2]);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 2]) -> f32 {
        self.map_to(u1, u2, to);
        FRAC_1_PI
    }
}

impl<T: Tier> Warp for DiskConcentric<T> {
    planar!(2, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, point: [f32; 2]) -> f32 {
        uniform_density(point)
    }
}

impl<T: Tier> Invert for DiskConcentric<T> {
    #[inline]
    fn invert(&self, point: [f32; 2]) -> [f32; 2] {
        let [x, y] = point;
        let r = into_unit(T::sqrt(x * x + y * y));
        concentric_inverse::<T>(point, 1.0 - r)
    }
}
