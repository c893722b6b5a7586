//! The uniform distribution on a capsule: a cylinder between two hemispheres.

use super::direction::azimuth;
use super::surface_point::{NEAR, SurfacePoint, area, parts, scaled, unit_of};
use super::{Invert, Warp};
use crate::error::{Error, finite, positive};
use crate::num::{clamp, into_unit};
use crate::tier::{Tier, sqrt};
use crate::uniform::Canonical;
use core::f32::consts::TAU;
use core::marker::PhantomData;

/// Uniform on the surface of a capsule, by area: all points at one distance from a segment of the z axis.
///
/// A zone of a sphere has the area of the cylinder around it, so the height z is uniform over the whole capsule (Archimedes).
/// The second uniform is the azimuth. Of height 0 the capsule is a sphere.
///
#[cfg_attr(doc, doc = include_str!("../pictures/capsule_surface.html"))]
///
/// # Density
/// 1/(2πr(h + 2r)) per unit area on the surface, and 0 farther from it than 2⁻²⁰ of the size.
///
/// # Domain
/// - Point: a [`SurfacePoint`]. The segment runs from the origin to (0, 0, h), the surface from z = −r to z = h + r. Density
///   and inverse do not read the normal.
/// - Uniforms: two. The lower pole is at u₁ = 0.
/// - Parameters: a height from 0 up and a radius above 0 with a density that `f32` can hold.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size, h + r. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 3.6e-7 | found |
/// | pdf, relative | 3.1e-7 | found |
/// | realised density, relative | 3.1e-7 | found |
/// | inverse | 2e-7 | found |
/// | round trip | 2.5e-7 | found |
///
/// The azimuth of a point nearer to the axis than 2⁻¹²⁵ is lost. The normal is right to 2.6e-7, absolutely.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost CapsuleSurface -->121 instructions and 732 bytes of code on an M4F, 4,623 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let pill = mw::CapsuleSurface::new(2.0, 1.0)?;
/// let point = pill.sample([0.5, 0.25]);
/// assert!((point.position[2] - 1.0).abs() < 1e-6 && point.normal[1] > 0.999);
/// assert!((pill.pdf(point) * pill.area() - 1.0).abs() < 1e-6);
/// assert_eq!(pill.sample([0.0, 0.0]).position, [0.0, 0.0, -1.0]);
/// assert_eq!(pill.invert(point), [0.5, 0.25]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`FrustumSurface`](super::FrustumSurface): a cylinder with disks, or a cone.
/// - [`Sphere`](super::Sphere): the unit sphere, at a lower cost.
///
/// # Source
/// E. W. Weisstein, "Archimedes' Hat-Box Theorem",
/// <https://mathworld.wolfram.com/ArchimedesHat-BoxTheorem.html>.
#[doc(alias = "pill")]
#[doc(alias = "spherocylinder")]
#[doc(alias = "area_light")]
#[doc(alias = "emitter")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CapsuleSurface<T> {
    height: f32,
    radius: f32,
    /// h + 2r.
    whole: f32,
    density: f32,
    tier: PhantomData<T>,
}

/// Below this radius, 2⁻⁸⁶, heights near a pole may be subnormal, whose rounding would turn the normal.
const SMALL: f32 = f32::MIN_POSITIVE * 1_099_511_627_776.0;

impl<T: Tier> CapsuleSurface<T> {
    /// 1 - cos of the angle from the nearer pole, at a part of the height from it, for a small radius: in lengths 2⁶⁴ times
    /// as large. One beyond the largest number counts as that: then what is within a radius of the pole is the pole alone.
    #[cold]
    fn enlarged(&self, part: f32) -> f32 {
        const BY: f32 = 18_446_744_073_709_551_616.0;
        let near = part * clamp(self.whole * BY, 0.0, f32::MAX);
        let radius = self.radius * BY;
        if near < radius { near / radius } else { 1.0 }
    }

    /// The capsule around a segment of the given height, at the given radius.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a height below 0, [`Error::NotPositive`] for a radius
    /// of 0 or less. [`Error::Empty`] where the density overflows, [`Error::TooLarge`] where it is below the smallest normal
    /// number, or where h + 2r overflows.
    pub fn new(height: f32, radius: f32) -> Result<Self, Error> {
        if finite(height, 0)? < 0.0 {
            return Err(Error::Negative(0));
        }
        positive(radius, 1)?;
        let whole = height + 2.0 * radius;
        if !whole.is_finite() {
            return Err(Error::TooLarge(1));
        }
        let (_, _, density) = parts([area(scaled(radius), scaled(whole)), None, None], TAU)?;
        Ok(Self {
            height,
            radius,
            whole,
            density,
            tier: PhantomData,
        })
    }

    /// The height of the segment.
    #[must_use]
    pub const fn height(&self) -> f32 {
        self.height
    }

    /// The radius.
    #[must_use]
    pub const fn radius(&self) -> f32 {
        self.radius
    }

    /// The area of the surface.
    #[must_use]
    pub fn area(&self) -> f32 {
        1.0 / self.density
    }
}

impl<T: Tier> Warp for CapsuleSurface<T> {
    type Uniforms = [f32; 2];
    type Point = SurfacePoint;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> SurfacePoint {
        let [u1, u2] = u.get();
        // The heights above the lower pole and below the upper one.
        let [up, down] = [u1, 1.0 - u1].map(|part| part * self.whole);
        let near = if up < down { up } else { down };
        // 1 - cos of the angle from the pole, and at most 1 along the cylinder.
        let q = if self.radius < SMALL {
            self.enlarged(if up < down { u1 } else { 1.0 - u1 })
        } else if near < self.radius {
            near / self.radius
        } else {
            1.0
        };
        let (sine, cosine) = (sqrt(q * (2.0 - q)), 1.0 - q);
        let (z, upwards) = if q < 1.0 && up < down {
            (-self.radius * cosine, -cosine)
        } else if q < 1.0 {
            (self.height + self.radius * cosine, cosine)
        } else {
            (clamp(up - self.radius, 0.0, self.height), 0.0)
        };
        let (c, s) = T::polar(1.0, u2);
        let normal = [sine * c, sine * s];
        let [x, y] = normal;
        SurfacePoint {
            position: [self.radius * x, self.radius * y, z],
            normal: [x, y, upwards],
        }
    }

    #[inline]
    fn pdf(&self, point: SurfacePoint) -> f32 {
        let [x, y, z] = point.position;
        let unit = unit_of(self.radius);
        let above = z - clamp(z, 0.0, self.height);
        let [x, y, z] = [x / unit, y / unit, above / unit];
        let distance = sqrt(x * x + y * y + z * z) * unit;
        if (distance - self.radius).abs() <= NEAR * (self.height + self.radius) {
            self.density
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for CapsuleSurface<T> {
    #[inline]
    fn invert(&self, point: SurfacePoint) -> [f32; 2] {
        let [x, y, z] = point.position;
        [
            into_unit((z + self.radius) / self.whole),
            azimuth::<T>(x, y),
        ]
    }
}
