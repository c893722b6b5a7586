//! The uniform distribution on cylinders, cones and what is between them.

use super::direction::azimuth;
use super::surface_point::{NEAR, SurfacePoint, area, hypotenuse, parts, scaled, unit_of};
use super::{Invert, Warp};
use crate::error::{Error, finite};
use crate::num::{Scaled, clamp, into_unit};
use crate::tier::{Tier, sqrt};
use crate::uniform::Canonical;
use core::f32::consts::PI;
use core::marker::PhantomData;

/// Uniform on the surface of a frustum, by area: a cylinder, a cone, or a cone whose top is cut off; with its disks, or as a
/// tube without.
///
/// The first uniform runs along the profile: from the centre of the lower disk to its rim, up the side, and over the upper disk
/// to its centre. The second one is the azimuth. The map is continuous over the rims.
///
#[cfg_attr(doc, doc = include_str!("../pictures/frustum_surface.html"))]
///
/// # Density
/// 1/area per unit area on the surface, and 0 farther from it than 2⁻²⁰ of the size. The area is
/// π(r₀² + (r₀ + r₁)ℓ + r₁²) with ℓ² = h² + (r₀ − r₁)², or π(r₀ + r₁)ℓ of a tube.
///
/// # Domain
/// - Point: a [`SurfacePoint`]. The axis is +z, the lower disk at z = 0 and the upper one at z = h, exactly. Density and
///   inverse take from the normal whether a point is on the side.
/// - Uniforms: two. Two zeros give the centre of the lower disk, or the rim of a tube.
/// - Parameters: radii and height from 0 up with an area whose density `f32` can hold. A part without area is never met:
///   a cone has one disk, and of height 0 there are two disks and the ring between them.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size, which is the largest of both radii and the height.
/// *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 5.6e-7 | found |
/// | pdf, relative | 6e-7 | found |
/// | realised density, relative | 6e-7 | found |
/// | inverse | min(1, 5.7e-7 + 9.4e-7*g) | found |
/// | round trip | min(1, 6.6e-7 + 1.4e-6*g) | found |
///
/// g is the share of the side in the area, times the size over the length ℓ of the side: above 2 for a narrow ring alone.
/// The azimuth of a point nearer to the axis than 2⁻¹²⁵ is lost. The normal is right to 3.4e-7, absolutely.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost FrustumSurface -->141 instructions and 764 bytes of code on an M4F, 5,551 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let can = mw::FrustumSurface::new([1.0, 1.0], 2.0)?;
/// assert!((can.area() - 6.0 * core::f32::consts::PI).abs() < 1e-5);
/// let point = can.sample([0.5, 0.25]);
/// assert!((point.position[2] - 1.0).abs() < 1e-6 && point.normal[1] > 0.999);
/// assert_eq!(can.sample([0.99, 0.0]).normal, [0.0, 0.0, 1.0]);
///
/// let cone = mw::FrustumSurface::new([3.0, 0.0], 4.0)?;
/// assert!((cone.area() - 24.0 * core::f32::consts::PI).abs() < 1e-4);
/// let tube = mw::FrustumSurface::tube([1.0, 1.0], 2.0)?;
/// assert!(tube.sample([0.0, 0.5]).normal[0] == -1.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`CapsuleSurface`](super::CapsuleSurface): a cylinder between two hemispheres.
/// - [`Disk`](super::Disk): the disk alone.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, *Physically Based Rendering*, 4th edition, 2023, section 6.3:
/// <https://pbr-book.org/4ed/Shapes/Cylinders>, for the cylinder; the profile of all here.
#[doc(alias = "cylinder")]
#[doc(alias = "cone")]
#[doc(alias = "tube")]
#[doc(alias = "ring")]
#[doc(alias = "area_light")]
#[doc(alias = "emitter")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrustumSurface<T> {
    /// The lower and the upper radius as given. Over the unit one may underflow.
    radii: [f32; 2],
    /// Both over `unit`, a power of two.
    rims: [f32; 2],
    unit: f32,
    height: f32,
    /// The parts of the area that the lower disk, the side and the upper disk have.
    shares: [f32; 3],
    /// The normal of the side, outwards and upwards.
    slope: [f32; 2],
    /// The length of the side over its unit, a power of two.
    side: [f32; 2],
    density: f32,
    near: f32,
    tier: PhantomData<T>,
}

/// The parts of the surface.
#[derive(Clone, Copy)]
enum Part {
    Lower,
    Side,
    Upper,
}

impl<T: Tier> FrustumSurface<T> {
    /// A frustum of the given lower and upper radius and height, with its disks. Equal radii make a cylinder, and a radius of
    /// 0 a cone.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a number below 0. [`Error::Empty`] for a surface
    /// without area, or so small that the density overflows, [`Error::TooLarge`] for one whose density is below the smallest
    /// normal number, or whose diameter overflows.
    pub fn new(radii: [f32; 2], height: f32) -> Result<Self, Error> {
        Self::with(radii, height, true)
    }

    /// The side of a frustum alone, without its disks.
    ///
    /// # Errors
    /// Those of [`FrustumSurface::new`].
    pub fn tube(radii: [f32; 2], height: f32) -> Result<Self, Error> {
        Self::with(radii, height, false)
    }

    fn with([lower, upper]: [f32; 2], height: f32, closed: bool) -> Result<Self, Error> {
        for (x, place) in [(lower, 0), (upper, 0), (height, 1)] {
            if finite(x, place)? < 0.0 {
                return Err(Error::Negative(place));
            }
        }
        let sum = lower + upper;
        if !sum.is_finite() {
            return Err(Error::TooLarge(0));
        }
        let (length, long) = hypotenuse(lower - upper, height);
        let side = scaled(length).map(|length| length.times(Scaled::of(long)));
        let disk = |radius| {
            let radius = scaled(radius).filter(|_| closed);
            area(radius, radius)
        };
        let (areas, whole, density) =
            parts([disk(lower), area(scaled(sum), side), disk(upper)], PI)?;
        let largest = if lower > upper { lower } else { upper };
        let unit = unit_of(largest);
        let slope = if length > 0.0 {
            [height / long / length, (lower - upper) / long / length]
        } else {
            [1.0, 0.0]
        };
        Ok(Self {
            radii: [lower, upper],
            rims: [lower / unit, upper / unit],
            unit,
            height,
            shares: areas.map(|area| area / whole),
            slope,
            side: [length, long],
            density,
            near: NEAR * if largest > height { largest } else { height },
            tier: PhantomData,
        })
    }

    /// The lower and the upper radius.
    #[must_use]
    pub const fn radii(&self) -> [f32; 2] {
        self.radii
    }

    /// The height.
    #[must_use]
    pub const fn height(&self) -> f32 {
        self.height
    }

    /// The area of the surface.
    #[must_use]
    pub fn area(&self) -> f32 {
        1.0 / self.density
    }

    /// The part to which a point with this normal belongs, its radius over `unit`, and how far up the side it is, from 0 to 1.
    #[inline]
    fn place(&self, point: SurfacePoint) -> (Part, f32, f32) {
        let ([x, y, z], [_, _, up]) = (point.position, point.normal);
        let ([lower, upper], [_, slope]) = (self.rims, self.slope);
        let (x, y) = (x / self.unit, y / self.unit);
        let radius = sqrt(x * x + y * y);
        // A side that faces the same way as a disk lies around it.
        let [disk, _, lid] = self.shares;
        let part = if up < -0.5 && disk > 0.0 && (slope >= 0.0 || radius < lower) {
            Part::Lower
        } else if up > 0.5 && lid > 0.0 && (slope <= 0.0 || radius < upper) {
            Part::Upper
        } else {
            Part::Side
        };
        let ([length, long], [steep, flat]) = (self.side, self.slope);
        let along = (z / long) * steep + (lower - radius) * (self.unit / long) * flat;
        (part, radius, clamp(along / length, 0.0, 1.0))
    }
}

impl<T: Tier> Warp for FrustumSurface<T> {
    type Uniforms = [f32; 2];
    type Point = SurfacePoint;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> SurfacePoint {
        let ([u1, u2], [p, side, q]) = (u.get(), self.shares);
        let ([lower, upper], down) = (self.rims, 1.0 - u1);
        let (radius, z, [outwards, upwards]) = if u1 < p {
            (lower * sqrt(u1 / p), 0.0, [0.0, -1.0])
        } else if down <= q {
            (upper * sqrt(down / q), self.height, [0.0, 1.0])
        } else {
            // The parts of the side below and above, the smaller one with its own digits. Radius² is linear in them.
            let [v, w] = [u1 - p, down - q].map(|part| clamp(part / side, 0.0, 1.0));
            let (v, w) = if v < w { (v, 1.0 - v) } else { (1.0 - w, w) };
            let radius = sqrt(w * (lower * lower) + v * (upper * upper));
            let both = lower + radius;
            let up = if v > 0.0 && both > 0.0 {
                v * ((lower + upper) / both)
            } else {
                0.0
            };
            let up = if up < 1.0 { up } else { 1.0 };
            (radius, up * self.height, self.slope)
        };
        let (c, s) = T::polar(1.0, u2);
        let radius = radius * self.unit;
        SurfacePoint {
            position: [radius * c, radius * s, z],
            normal: [outwards * c, outwards * s, upwards],
        }
    }

    #[inline]
    fn pdf(&self, point: SurfacePoint) -> f32 {
        let (part, radius, up) = self.place(point);
        let ([_, _, z], [lower, upper]) = (point.position, self.rims);
        let (rim, level) = match part {
            Part::Lower => (lower, 0.0),
            Part::Upper => (upper, self.height),
            Part::Side => (lower + up * (upper - lower), up * self.height),
        };
        let off = (radius - rim) * self.unit;
        let within = off <= self.near && (off >= -self.near || !matches!(part, Part::Side));
        if within && (z - level).abs() <= self.near {
            self.density
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for FrustumSurface<T> {
    #[inline]
    fn invert(&self, point: SurfacePoint) -> [f32; 2] {
        let (part, radius, up) = self.place(point);
        let ([lower, upper], [p, side, q]) = (self.rims, self.shares);
        let [x, y, _] = point.position;
        // The squares of parts of a rim; 0 of a disk that is a point.
        let square = |rim: f32| {
            let part = clamp(radius / rim, 0.0, 1.0);
            part * part
        };
        let first = match part {
            Part::Lower => p * square(lower),
            Part::Upper => 1.0 - q * square(upper),
            Part::Side => {
                let there = lower + up * (upper - lower);
                p + side * clamp(up * ((lower + there) / (lower + upper)), 0.0, 1.0)
            }
        };
        [into_unit(first), azimuth::<T>(x, y)]
    }
}
