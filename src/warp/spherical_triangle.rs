//! The uniform distribution over the directions of a triangle, seen from a point.

use super::seen::{self, Seen};
use super::{Invert, Triangle, Warp, drawn_with_pdf};
use crate::error::Error;
use crate::num::{into_unit, representable};
use crate::tier::Tier;
use crate::uniform::{Canonical, Uniforms};
use core::f32::consts::PI;
use core::marker::PhantomData;

/// Uniform over the directions from a point to a triangle: an area light, sampled by its solid angle.
///
#[cfg_attr(doc, doc = include_str!("../pictures/spherical_triangle.html"))]
///
/// The second uniform divides the solid angle by an arc from the first vertex, as in Arvo's map, and the first one goes
/// along the arc. With H half of the solid angle, the side b-c across from the first vertex a is divided in the ratio
/// of sin(u₂H)·√(2(1 + ab)) to sin((1 − u₂)H)·√((1 + bc)(1 + ca)). A direction is the sum of the directions of the
/// vertices times weights, which are products and sums of positive numbers. Nothing cancels, however small, thin or
/// near the triangle, and the barycentric coordinates are the weights over the distances.
///
/// # Density
/// 1/Ω per steradian inside and 0 outside, farther than the rounding of samples: 4e-7·q rad from a side, and farther beyond
/// a sharp corner. A world direction is rounded to 6e-8 rad, so that it cannot tell inside
/// from outside in a triangle a few times wider than that. [`Oriented`](super::Oriented) says more. Hence:
///
/// - `pdf(w) > 0` is no hit test. Take the density of directions that meet the triangle, or the one that comes with the
///   sample. The density of a triangle of 1e-3 rad integrates over all directions to 1.003, that of 1e-6 rad
///   (4e-13 sr) to about 9.
/// - [`locate`](SphericalTriangle::locate) gives the place on the triangle in barycentric coordinates, which keep their
///   digits at any size: trace a ray to it rather than along the direction where the triangle is narrower than about
///   1e-4 rad.
///
/// Where q is above 64 before the inside, the point is so close to the triangle that area is sampled instead, unless a
/// vertex is 64 times as near as another. [`samples_area`](SphericalTriangle::samples_area) says so. Densities and the
/// inverse are then those of area, distance²/(cos θ · area) per steradian.
///
/// # Domain
/// - Point: unit vectors in world space. The triangle is seen from both sides.
/// - Uniforms: two. The first vertex is at u₁ = 0; from the second to the third, u₂ grows.
/// - Parameters: coordinates up to 2⁶⁰ (1e18), a longest edge of at least 2⁻⁶⁰. With L the distance of the farthest
///   vertex and E the longest edge, E and each vertex's distance are at least 2⁻³⁰ L (E = 2⁻³⁰ L is 1e-18 sr), and the
///   determinant of the three vertices, taken from the point, at least 2⁻²⁸ L E².
/// - q, the nearness, is 1 over the distance of the point from the plane triangle of three unit vectors, those to the
///   vertices. It is 1 for small triangles, 2 for an octant, and about half the size over the height close to a
///   triangle. Above 1024 the point counts as one on the triangle.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length, *place on it* that of the
/// barycentric coordinates. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of
/// the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, of the size | 4.7e-7*q | 4.7e-7*q |
/// | unit length | 1.9e-7 | 1.9e-7 |
/// | place on it | 1.02e-6 | 1.02e-6 |
/// | pdf, relative | 1.4e-6 + 6e-15/g + 4.2e-7·a + 4·s | 1.4e-6 + 6e-15/g + 4.2e-7·a + 4·s |
/// | realised density, relative | 1.4e-6 + 6e-15/g + 4.2e-7·a + (2 + a)·s | 1.4e-6 + 6e-15/g + 4.2e-7·a + (2 + a)·s |
/// | pdf with the sample, relative | 1.4e-6 + 6e-15/g + 4.2e-7*a | 1.4e-6 + 6e-15/g + 4.2e-7*a |
/// | inverse | min(1, 5e-7 + 5e-7·q + (13 + 0.8·q)·r + 3e-8/h) | min(1, 5e-7 + 5e-7·q + (13 + 0.8·q)·r + 3e-8/h) |
/// | round trip | min(1, 5e-7 + 5e-7·q + (14 + q)·r + 3e-8/h) | min(1, 5e-7 + 5e-7·q + (14 + q)·r + 3e-8/h) |
///
/// These hold for every triangle accepted. a is q where area is sampled and 0 elsewhere, g the determinant over L E²; s
/// and r are the relative change of the density and the change of the uniforms when each coordinate of the direction
/// moves by 2⁻²⁴. h is the sine of the smallest height: the second uniform of a direction within rounding of the first
/// vertex, where √u₁ h is below 2⁻²⁰, is lost.
///
/// # Cost
/// <!-- generated: cost SphericalTriangle -->
/// Instructions of a draw, PCG32 included, and bytes of flash:
/// - `poly`: 200 on a Cortex-M4F (1,204 bytes), 13,230 on a Cortex-M0, 405 as WASM.
/// - `libm`: 4,411 on a Cortex-M4F (7,488 bytes), 21,835 on a Cortex-M0, 528 as WASM.
/// <!-- end -->
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let (lamp, spot) = ([[-1.0, -1.0, 3.0], [1.0, -1.0, 3.0], [0.0, 1.0, 3.0]], [0.0, 0.0, 0.0]);
/// let light = mw::SphericalTriangle::new(spot, lamp)?;
/// let there = light.locate([0.3, 0.8]);
/// assert!((there.pdf * light.solid_angle() - 1.0).abs() < 1e-6);
/// assert!((there.barycentric.iter().sum::<f32>() - 1.0).abs() < 1e-6);
/// assert_eq!(there.direction, light.sample([0.3, 0.8]));
/// assert_eq!(light.pdf([0.0, 0.0, -1.0]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// In a renderer, no refusal is worth ending a picture: edge-on, or next to the lamp, `new` returns an error. Take `.ok()`.
/// A lamp that is refused gives no light by this technique; what else hits it counts with density 0, so with weight 1.
///
/// # See also
/// - [`SphericalRectangle`](super::SphericalRectangle): four corners.
/// - [`TriangleOn`](super::TriangleOn): uniform on the triangle itself, whatever sees it.
/// - [`Cone`](super::Cone): the directions to a sphere.
///
/// # Source
/// J. Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995, <https://doi.org/10.1145/218380.218500>, and
/// A. Van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", 1983,
/// <https://doi.org/10.1109/TBME.1983.325207>, rearranged here.
#[doc(alias = "solid_angle")]
#[doc(alias = "area_light")]
#[doc(alias = "arvo")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphericalTriangle<T> {
    seen: Seen,
    density: f32,
    tier: PhantomData<T>,
}

/// A place on a triangle: its direction, its barycentric coordinates, and the density of the direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnTriangle {
    /// The direction from the point, a unit vector.
    pub direction: [f32; 3],
    /// The barycentric coordinates of the place, in the order of the vertices: at least 0, with the sum 1.
    pub barycentric: [f32; 3],
    /// The density of the direction, per steradian.
    pub pdf: f32,
}

impl<T: Tier> SphericalTriangle<T> {
    /// The directions from `point` to the triangle with these vertices, from either side.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::TooLarge`] for a coordinate beyond 2⁶⁰, [`Error::Empty`] for
    /// coincident vertices and for a triangle that is too small, too thin or seen too much from its edge,
    /// [`Error::NotNormalizable`] for a point on the triangle. The section on the domain says where these begin.
    pub fn new(point: [f32; 3], vertices: [[f32; 3]; 3]) -> Result<Self, Error> {
        seen::checked(&[point])?;
        seen::checked(&vertices)?;
        let [a, b, c] = vertices;
        let corners = vertices.map(|vertex| seen::difference(vertex, point));
        let edges = [
            seen::difference(c, b),
            seen::difference(a, c),
            seen::difference(b, a),
        ];
        let seen = Seen::new::<T>(corners, edges)?;
        Ok(Self {
            seen,
            density: 1.0 / (4.0 * PI * seen.half()),
            tier: PhantomData,
        })
    }

    /// The solid angle of the triangle, in steradians.
    #[must_use]
    pub const fn solid_angle(&self) -> f32 {
        4.0 * PI * self.seen.half()
    }

    /// Whether the point is so close to the triangle that its area is sampled, with the density of that.
    #[must_use]
    pub const fn samples_area(&self) -> bool {
        self.seen.close()
    }

    /// The weights that a bilinear density on the unit square takes in order to follow the cosine to `normal`, of any
    /// length: `weights[row][column]`, where u₂ is 0 and 1 in the rows and u₁ is 0 and 1 in the columns.
    ///
    /// They are the cosines of the vertices, 0 below the horizon; the first vertex is both corners of the first column.
    ///
    /// # Errors
    /// [`Error::AllZero`] for a triangle below the horizon, [`Error::NotFinite`] and [`Error::ZeroLength`] for a normal
    /// that is none.
    pub fn cosine_weights(&self, normal: [f32; 3]) -> Result<[[f32; 2]; 2], Error> {
        let [a, b, c] = seen::cosines(self.seen.corners(), normal)?;
        if a > 0.0 || b > 0.0 || c > 0.0 {
            Ok([[a, b], [a, c]])
        } else {
            Err(Error::AllZero)
        }
    }

    /// The direction, the place on the triangle and the density of two uniforms. They are brought into range as
    /// [`Warp::sample`] does.
    #[must_use]
    pub fn locate(&self, u: [f32; 2]) -> OnTriangle {
        let [u1, u2] = u.canonical().get();
        if self.seen.close() {
            // The share of the last vertex grows with u₂.
            let [p, q, r] = Triangle::new().sample([u1, u2]);
            let barycentric = [p, r, q];
            let (direction, spread) = self.seen.towards(barycentric);
            return OnTriangle {
                direction,
                barycentric,
                pdf: representable(2.0 * spread),
            };
        }
        let weights = self.seen.weights::<T>(u1, u2, 1.0 - u2);
        OnTriangle {
            direction: self.seen.direction(weights),
            barycentric: self.seen.barycentric(weights),
            pdf: self.density,
        }
    }
}

impl<T: Tier> Warp for SphericalTriangle<T> {
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        let [u1, u2] = u.get();
        if self.seen.close() {
            let [p, q, r] = Triangle::new().sample_canonical(u);
            self.seen.towards([p, r, q]).0
        } else {
            self.seen
                .direction(self.seen.weights::<T>(u1, u2, 1.0 - u2))
        }
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 3], f32) {
        let there = self.locate(u.get());
        (there.direction, there.pdf)
    }

    drawn_with_pdf!();

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        if !self.seen.holds(direction) {
            0.0
        } else if self.seen.close() {
            let (_, spread) = self.seen.place(direction);
            representable(2.0 * spread)
        } else {
            self.density
        }
    }
}

impl<T: Tier> Invert for SphericalTriangle<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        if self.seen.close() {
            let ([p, q, r], _) = self.seen.place(direction);
            return Triangle::new().invert([p, r, q]);
        }
        self.seen.uniforms::<T>(direction).map(into_unit)
    }
}
