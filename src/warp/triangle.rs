//! The uniform distribution on a triangle: in barycentric coordinates, and on three given vertices.

use super::{Warp, clamp, into_unit};
use crate::error::Error;
use crate::tier::{sqrt, two_product};
use crate::uniform::Canonical;

/// Uniform barycentric coordinates.
///
/// u = 1 − √U₁, v = √U₁ U₂, w = √U₁ (1 − U₂); u in the form (1 − U₁)/(1 + √U₁), which keeps its digits
/// near 0.
///
/// - Uniforms: two.
/// - Range: [u, v, w], none negative, with sum 1 to rounding.
/// - Density: 2 with respect to (u, v), where none is negative and their sum is 1 to rounding.
/// - Both tiers share this code: it needs nothing but a square root.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, of the size | 8.6e-8 | 8.6e-8 |
/// | pdf, relative | 0 | 0 |
/// | realised density, relative | 0 | 0 |
/// | inverse | 2.0e-7 | 2.0e-7 |
/// | round trip | 6.6e-8 | 6.6e-8 |
///
/// Source: G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
///
/// ```
/// use microwarp::{Triangle, Warp};
/// assert_eq!(Triangle::new().sample([0.25, 0.5]), [0.5, 0.25, 0.25]);
/// assert_eq!(Triangle::new().invert([0.5, 0.25, 0.25]), [0.25, 0.5]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Triangle(());

impl Triangle {
    /// The triangle of all barycentric coordinates.
    #[must_use]
    pub const fn new() -> Self {
        Self(())
    }
}

impl Warp for Triangle {
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        let [u1, u2] = u.get();
        let s = sqrt(u1);
        [(1.0 - u1) / (1.0 + s), s * u2, s * (1.0 - u2)]
    }

    #[inline]
    fn pdf(&self, point: [f32; 3]) -> f32 {
        let [u, v, w] = point;
        let whole = (u + v + w - 1.0).abs() <= 4.0 * f32::EPSILON;
        if u >= 0.0 && v >= 0.0 && w >= 0.0 && whole {
            2.0
        } else {
            0.0
        }
    }

    #[inline]
    fn invert(&self, point: [f32; 3]) -> [f32; 2] {
        let [u, v, w] = point.map(|c| clamp(c, 0.0, 1.0));
        let s = v + w;
        // Of √U₁ and 1 − √U₁ the smaller holds the digits.
        let u1 = if s < 0.5 { s * s } else { 1.0 - u * (2.0 - u) };
        [into_unit(u1), into_unit(if s > 0.0 { v / s } else { 0.0 })]
    }

    super::filled_in_blocks!();
}

/// Uniform on the triangle of three vertices in D dimensions (2 or 3, or more).
///
/// The barycentric combination of the vertices, clamped coordinate by coordinate to their bounding box.
///
/// - Uniforms: two.
/// - Range: the triangle, to the rounding of its coordinates.
/// - Density: 1/area per unit area on the triangle, and 0 farther outside it than that rounding.
/// - Both tiers share this code.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, of the size | 1.2e-7 | 1.2e-7 |
/// | pdf, relative | 7.9e-8 | 7.9e-8 |
/// | realised density, relative | 7.9e-8 | 7.9e-8 |
/// | inverse | 1.1 | 1.1 |
/// | round trip | 5.3e-7 | 5.3e-7 |
///
/// Source: G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
///
/// ```
/// use microwarp::{TriangleOn, Warp};
/// let facet = TriangleOn::new([[0.0, 0.0], [4.0, 0.0], [0.0, 2.0]])?;
/// assert_eq!(facet.sample([0.25, 0.5]), [1.0, 0.5]);
/// assert_eq!(facet.pdf([1.0, 0.5]), 0.25);
/// assert_eq!(facet.pdf([4.0, 2.0]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TriangleOn<const D: usize> {
    vertices: [[f32; D]; 3],
    /// Twice the sides b − a and c − a, divided by `scale`.
    sides: [[f32; D]; 2],
    /// The power of two by which lengths were divided.
    scale: f32,
    /// The squared length of the cross product of `sides`.
    cross2: f32,
    density: f32,
    /// How far outside [0, 1] the rounding of a point's coordinates can carry its barycentrics.
    slack: f32,
    /// How far from the plane of the triangle it can carry a coordinate.
    lift: f32,
}

impl<const D: usize> TriangleOn<D> {
    /// Uniform on the triangle with these vertices.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Empty`] for a triangle with no area or one whose
    /// density overflows, [`Error::TooLarge`] for one whose area does.
    pub fn new(vertices: [[f32; D]; 3]) -> Result<Self, Error> {
        let [a, b, c] = vertices;
        let mut largest = 0.0_f32;
        for x in vertices.as_flattened() {
            if !x.is_finite() {
                return Err(Error::NotFinite);
            }
            largest = clamp(x.abs(), largest, f32::MAX);
        }
        // Halved before they are subtracted, so that the sides cannot overflow.
        let sides = [difference(b, a), difference(c, a)];
        let mut longest = 0.0_f32;
        for x in sides.as_flattened() {
            longest = clamp(x.abs(), longest, f32::MAX);
        }
        if longest < f32::MIN_POSITIVE {
            return Err(Error::Empty);
        }
        // A power of two, so that scaling is exact.
        let scale = f32::from_bits(longest.to_bits() & 0x7f80_0000);
        let sides = sides.map(|side| side.map(|x| x / scale));
        let [p, q] = sides;
        let cross2 = wedge_dot(p, q, p, q);
        let cross = sqrt(cross2);
        // The sides were halved, so the cross product is a quarter of theirs, half of it the area.
        let area = 2.0 * cross * scale * scale;
        let density = 0.5 / cross / scale / scale;
        if cross2 < f32::MIN_POSITIVE || !density.is_finite() {
            return Err(Error::Empty);
        }
        if !area.is_finite() || density < f32::MIN_POSITIVE {
            return Err(Error::TooLarge);
        }
        let reach = norm(p) + norm(q);
        let rounding = 2.0 * f32::EPSILON * (0.5 * largest / scale + reach);
        Ok(Self {
            vertices,
            sides,
            scale,
            cross2,
            density,
            slack: rounding * reach / cross,
            lift: 8.0 * f32::EPSILON * largest,
        })
    }

    /// The area of the triangle.
    #[must_use]
    pub fn area(&self) -> f32 {
        1.0 / self.density
    }

    /// The barycentric coordinates of the point of the plane nearest to `point`.
    #[inline]
    fn barycentric(&self, point: [f32; D]) -> [f32; 3] {
        let ([a, _, _], [p, q]) = (self.vertices, self.sides);
        let to_point = difference(point, a).map(|x| x / self.scale);
        let v = wedge_dot(to_point, q, p, q) / self.cross2;
        let w = wedge_dot(p, to_point, p, q) / self.cross2;
        [(1.0 - v) - w, v, w]
    }
}

/// Half of p − q, which cannot overflow.
#[inline]
fn difference<const D: usize>(p: [f32; D], q: [f32; D]) -> [f32; D] {
    let mut d = p;
    for (d, q) in d.iter_mut().zip(q) {
        *d = 0.5 * *d - 0.5 * q;
    }
    d
}

#[inline]
fn norm<const D: usize>(p: [f32; D]) -> f32 {
    let mut sum = 0.0;
    for x in p {
        sum += x * x;
    }
    sqrt(sum)
}

/// ps − qr, with the rounding of the first product carried along so that a sliver's does not cancel.
#[inline]
fn determinant(p: f32, q: f32, r: f32, s: f32) -> f32 {
    let (first, dropped_first) = two_product(p, s);
    let (second, dropped_second) = two_product(q, r);
    (first - second) + (dropped_first - dropped_second)
}

/// (p ∧ q) · (r ∧ s), by Lagrange's identity over the coordinate planes: good in any dimension.
#[inline]
fn wedge_dot<const D: usize>(p: [f32; D], q: [f32; D], r: [f32; D], s: [f32; D]) -> f32 {
    let mut sum = 0.0;
    let mut rows = p.into_iter().zip(q).zip(r.into_iter().zip(s));
    while let Some(((p1, q1), (r1, s1))) = rows.next() {
        for ((p2, q2), (r2, s2)) in rows.clone() {
            sum += determinant(p1, q1, p2, q2) * determinant(r1, s1, r2, s2);
        }
    }
    sum
}

impl<const D: usize> Warp for TriangleOn<D> {
    type Uniforms = [f32; 2];
    type Point = [f32; D];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; D] {
        let [u, v, w] = Triangle::new().sample_canonical(u);
        let [mut point, b, c] = self.vertices;
        for ((x, b), c) in point.iter_mut().zip(b).zip(c) {
            let a = *x;
            let (low, high) = if a < b { (a, b) } else { (b, a) };
            let low = if c < low { c } else { low };
            let high = if c > high { c } else { high };
            *x = clamp(u * a + v * b + w * c, low, high);
        }
        point
    }

    #[inline]
    fn pdf(&self, point: [f32; D]) -> f32 {
        let [u, v, w] = self.barycentric(point);
        let least = -self.slack;
        let mut in_plane = true;
        let [a, b, c] = self.vertices;
        for (((x, a), b), c) in point.into_iter().zip(a).zip(b).zip(c) {
            in_plane &= (x - (u * a + v * b + w * c)).abs() <= self.lift;
        }
        if in_plane && u >= least && v >= least && w >= least {
            self.density
        } else {
            0.0
        }
    }

    #[inline]
    fn invert(&self, point: [f32; D]) -> [f32; 2] {
        Triangle::new().invert(self.barycentric(point))
    }

    super::filled_in_blocks!();
}
