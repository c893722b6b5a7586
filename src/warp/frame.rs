//! Turning local directions onto a given normal.

use super::direction::normalised;
use super::{Invert, Warp};
use crate::error::Error;
use crate::tier::sqrt;
use crate::uniform::{Canonical, Uniforms};
use rand_core::TryRng;

/// A right-handed orthonormal frame whose third axis is a given normal.
///
/// # Domain
/// - Parameters: a normal of any finite length but 0. No direction is singular, −z included.
/// - Both tiers share this code.
///
/// # Accuracy
/// Whatever the normal, each axis has length 1 to 1.3e-7, two axes are orthogonal to 3.8e-7 rad, and the third is
/// the direction of the normal to 1.4e-7 rad. A direction turned into the world is off by 5.1e-7, and its length by
/// 3.9e-7. Turned there and back, a direction is off by 7.4e-7. All of these are found, by a search that anneals normal and direction.
///
/// # Examples
/// ```
/// use microwarp::warp::Frame;
/// let frame = Frame::new([0.0, 2.0, 0.0])?;
/// assert_eq!(frame.to_world([0.0, 0.0, 1.0]), [0.0, 1.0, 0.0]);
/// assert_eq!(frame.to_local([0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Oriented`](super::Oriented) turns a whole warp.
///
/// # Source
/// T. Duff and others, "Building an Orthonormal Basis, Revisited", Journal of Computer Graphics Techniques, 2017,
/// <https://jcgt.org/published/0006/01/01/>.
#[doc(alias = "onb")]
#[doc(alias = "orthonormal_basis")]
#[doc(alias = "tangent_space")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frame {
    tangent: [f32; 3],
    bitangent: [f32; 3],
    normal: [f32; 3],
}

impl Frame {
    /// The frame whose z axis points along `normal`, which need not have unit length.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::ZeroLength`] for a normal of length 0.
    pub fn new(normal: [f32; 3]) -> Result<Self, Error> {
        Ok(Self::about(normalised(normal, 0)?))
    }

    /// The frame of a normal whose length is 1 but for rounding.
    #[inline]
    pub(super) fn about([x, y, z]: [f32; 3]) -> Self {
        // The axes are as orthogonal as the length of the normal is 1: one step of Newton's method corrects it.
        let excess = (z * z - 1.0) + (x * x + y * y);
        // Before the step, which loses the sign of a zero.
        let sign = 1.0_f32.copysign(z);
        let normal = [x, y, z].map(|c| c - c * (0.5 * excess));
        let [x, y, z] = normal;
        let a = -1.0 / (sign + z);
        let b = x * y * a;
        Self {
            tangent: [1.0 + sign * x * x * a, sign * b, -sign * x],
            bitangent: [b, sign + y * y * a, -y],
            normal,
        }
    }

    /// The unit normal, the third axis.
    #[must_use]
    pub const fn normal(&self) -> [f32; 3] {
        self.normal
    }

    /// The first two axes.
    #[must_use]
    pub const fn tangents(&self) -> [[f32; 3]; 2] {
        [self.tangent, self.bitangent]
    }

    /// A local direction, with z along the normal, in world coordinates.
    #[must_use]
    #[inline]
    pub fn to_world(&self, local: [f32; 3]) -> [f32; 3] {
        let ([x, y, z], [tx, ty, tz]) = (local, self.tangent);
        let ([bx, by, bz], [nx, ny, nz]) = (self.bitangent, self.normal);
        [
            x * tx + y * bx + z * nx,
            x * ty + y * by + z * ny,
            x * tz + y * bz + z * nz,
        ]
    }

    /// A world direction in local coordinates, with z along the normal.
    #[must_use]
    #[inline]
    pub fn to_local(&self, world: [f32; 3]) -> [f32; 3] {
        [self.tangent, self.bitangent, self.normal].map(|axis| {
            let ([x, y, z], [ax, ay, az]) = (world, axis);
            x * ax + y * ay + z * az
        })
    }
}

/// A warp over directions, turned from +z onto a given normal.
///
#[cfg_attr(doc, doc = include_str!("../pictures/oriented.html"))]
///
/// # Density
/// That of the warp inside: a rotation changes no solid angle. It reaches 5e-7 rad beyond the rim of the domain, so
/// that no sample has density 0 because of its rounding. Hence:
///
/// - `pdf(w) > 0` is no hit test. Whether a direction meets the lamp is a question to the geometry; take the density
///   of directions that do.
/// - Over all directions the density of a [`Cone`](super::Cone) of half angle θ integrates to (1 + 5e-7/θ)²: 1.001
///   at 1e-3 rad, 1.1 at 1e-5 rad, 2.3 at 1e-6 rad. Take a lamp narrower than about 1e-5 rad as a point.
///
/// # Domain
/// - Point: the directions of the warp inside, turned.
/// - Uniforms: those of the warp inside.
///
/// A world direction holds a lobe narrower than about 3e-4 rad only to the rounding of its coordinates (6e-8 rad).
/// Sample such lobes in their own frame where you need more. At the sides of a turned
/// [`SphericalPatch`](super::SphericalPatch) next to its pole the 5e-7 rad may be too little, and a sample may have
/// density 0 there.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 5.8e-7 | 5.8e-7 | found |
/// | unit length | 5.2e-7 | 5.2e-7 | found |
/// | pdf, relative | 6.4e-7 + 15*s | 6.4e-7 + 15*s | found |
/// | realised density, relative | 5.8e-7 + 9.3*s | 5.8e-7 + 9.3*s | found |
/// | pdf with the sample, relative | 5.2e-7 + 2*s | 4.2e-7 + 1.6*s | found |
/// | inverse | min(1, 6.2e-7 + 15*r) | min(1, 6.2e-7 + 15*r) | found |
/// | round trip | min(1, 6.2e-7 + 15*r) | min(1, 6.2e-7 + 15*r) | found |
///
/// These hold for every normal, over the hemispheres, over cones of any width and over lobes of n from 1 to 1e8.
/// They do not hold for lobes above that, whose density in world coordinates may be wrong altogether, nor for lobes
/// of n < 1 next to the horizon. s and r are the relative change of the density and the change of the uniforms when
/// each coordinate of the direction moves by 2⁻²⁴.
///
/// For a [`PhongLobe`](super::PhongLobe) of n = 50, 1e3 and 1e6, whatever the normal, 5.8e-7 + 9.3 s is at most 8.6e-6,
/// 3.6e-5 and 1.2e-3 at u₁ = ½, and 5.5e-5, 1.8e-4 and 5.6e-3 at the last u₁ of the 24-bit grid.
///
/// # Cost
/// That of the warp inside, and of a product of a matrix and a vector.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw, warp::{Frame, Oriented}};
/// let wall = Oriented::new(mw::CosineHemisphere::new(), Frame::new([-1.0, 0.0, 0.0])?);
/// let [x, _, _] = wall.sample([0.3, 0.8]);
/// assert!(x < 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Frame`](super::Frame): the rotation alone.
/// - [`Transform`](super::Transform): any one-to-one map.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://pbr-book.org/3ed-2018/contents>.
#[doc(alias = "to_world")]
#[doc(alias = "local_to_world")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Oriented<W> {
    warp: W,
    frame: Frame,
}

impl<W> Oriented<W> {
    /// `warp` in the given frame.
    #[must_use]
    pub const fn new(warp: W, frame: Frame) -> Self {
        Self { warp, frame }
    }

    /// The warp inside.
    #[must_use]
    pub const fn warp(&self) -> &W {
        &self.warp
    }

    /// The frame.
    #[must_use]
    pub const fn frame(&self) -> Frame {
        self.frame
    }
}

impl<W> Oriented<W> {
    /// Turns local directions into the world, in place.
    #[inline]
    fn turn<'a>(&self, directions: impl Iterator<Item = &'a mut [f32; 3]>) {
        for direction in directions {
            *direction = self.frame.to_world(*direction);
        }
    }
}

/// The angle by which turning into the world and back can carry a direction over its rim. The worst known is 3.7e-7.
const RIM: f32 = 5.0e-7;

/// The direction tilted by the angle `RIM` towards the axis (1) or away from it (−1).
#[inline]
fn tilted(direction: [f32; 3], towards: f32) -> [f32; 3] {
    let [x, y, z] = direction;
    let sin = sqrt(x * x + y * y);
    let (tilt, scale) = (
        towards * RIM,
        1.0 - towards * RIM * z / (sin + f32::MIN_POSITIVE),
    );
    let scale = if scale > 0.0 { scale } else { 0.0 };
    [x * scale, y * scale, z + tilt * sin]
}

impl<W: Warp<Point = [f32; 3], Density = f32>> Warp for Oriented<W> {
    type Uniforms = W::Uniforms;
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<W::Uniforms>) -> [f32; 3] {
        self.frame.to_world(self.warp.sample_canonical(u))
    }

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let local = self.frame.to_local(direction);
        let mut density = self.warp.pdf(local);
        for towards in [1.0, -1.0] {
            if density > 0.0 {
                break;
            }
            density = self.warp.pdf(tilted(local, towards));
        }
        density
    }

    #[inline]
    fn sample_words(&self, words: <W::Uniforms as Uniforms>::Words) -> [f32; 3] {
        self.frame.to_world(self.warp.sample_words(words))
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[f32; 3], R::Error> {
        let local = self.warp.try_draw(rng)?;
        Ok(self.frame.to_world(local))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<W::Uniforms>) -> ([f32; 3], f32) {
        let (local, density) = self.warp.sample_canonical_with_pdf(u);
        (self.frame.to_world(local), density)
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<([f32; 3], f32), R::Error> {
        let (local, density) = self.warp.try_draw_with_pdf(rng)?;
        Ok((self.frame.to_world(local), density))
    }

    #[inline]
    fn map(&self, uniforms: &[W::Uniforms], points: &mut [[f32; 3]]) {
        self.warp.map(uniforms, points);
        self.turn(points.iter_mut().take(uniforms.len()));
    }

    #[inline]
    fn map_with_pdf(
        &self,
        uniforms: &[W::Uniforms],
        points: &mut [[f32; 3]],
        densities: &mut [f32],
    ) {
        self.warp.map_with_pdf(uniforms, points, densities);
        let count = uniforms.len().min(densities.len());
        self.turn(points.iter_mut().take(count));
    }
}

impl<W: Invert<Point = [f32; 3], Density = f32>> Invert for Oriented<W> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> W::Uniforms {
        self.warp.invert(self.frame.to_local(direction))
    }
}
