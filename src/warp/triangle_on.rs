//! The uniform distribution on a triangle given by its vertices.

use super::{Invert, Triangle, Warp};
use crate::error::Error;
use crate::num::double_word::{DoubleWord, TripleWord, quotient};
use crate::num::{clamp, two_sum};
use crate::tier::sqrt;
use crate::uniform::Canonical;

/// Uniform on a triangle given by its vertices, in two, three or more dimensions.
///
/// The barycentric combination of the vertices, coordinate by coordinate. Where the vertices lie close together
/// beside their distance from 0, their differences from the one nearest to 0 are combined, which are exact. So every
/// representable point of a small triangle far off is hit with the right probability, up to rounding.
///
#[cfg_attr(doc, doc = include_str!("../pictures/triangle_on.html"))]
///
/// # Density
/// 1/area per unit area on the triangle and within rounding of it, so that it is 0 at no sample. In two and three
/// dimensions it is 0 where a point lies more than 2⁻¹⁶ of the longest side and 2⁻¹⁹ of the size beyond the line of a
/// side, or off the plane.
///
/// # Domain
/// - Point: the triangle, to the rounding of its coordinates, and its bounding box exactly.
/// - Uniforms: two.
/// - Parameters: finite vertices of a triangle whose height over its longest side is at least 2⁻⁴⁰ of that side,
///   with a density that `f32` can hold.
/// - Both tiers share this code.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size, which is the largest magnitude of a
/// vertex's coordinate. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors
/// of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 5.6e-7 | proven |
/// | pdf, relative | 3.1e-7 | found |
/// | realised density, relative | 3.1e-7 | found |
/// | inverse | min(1, 8.3e-7 + 8.6e-7/h + 1.4·r) | found |
/// | round trip | min(1, 5e-7 + 6e-7/h + 6*r) | found |
///
/// These hold for every triangle accepted in two or three dimensions. The error of a sample is proven for all of them and every
/// pair of uniforms, in D dimensions as √(D/3) of what is stated: see `docs/proofs.md`. h is the height over the longest side in terms of the size, and r the
/// change of a point's uniforms when each coordinate moves by 2⁻²⁴ of the size. The second uniform of a point
/// within rounding of the first vertex, nearer than 2⁻²⁰ of the size over h, is lost.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost TriangleOn -->115 instructions and 384 bytes of code on an M4F, 3,266 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, warp::TriangleOn};
/// let facet = TriangleOn::new([[0.0, 0.0], [4.0, 0.0], [0.0, 2.0]])?;
/// assert_eq!(facet.sample([0.25, 0.5]), [1.0, 0.5]);
/// assert_eq!(facet.pdf([1.0, 0.5]), 0.25);
/// assert_eq!(facet.pdf([4.0, 2.0]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Triangle`](super::Triangle): the barycentric coordinates alone, at a lower cost.
/// - [`discrete::Alias`](crate::discrete::Alias) chooses a triangle of a mesh by its area.
///
/// # Source
/// G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
#[doc(alias = "mesh")]
#[doc(alias = "facet")]
#[doc(alias = "polygon")]
#[doc(alias = "area_light")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TriangleOn<const D: usize> {
    /// In each coordinate 0, or that of the vertex nearest to 0; and the exact offsets of the vertices from there.
    anchor: [f32; D],
    offsets: [[f32; D]; 3],
    /// The vertex where the longest side begins; the others follow in cyclic order.
    first: u8,
    /// The unit vectors along the longest side and across it, the reciprocals of its length and of the height over it,
    /// and the foot of the height, as a part of the side.
    along: [f32; D],
    across: [f32; D],
    per_length: f32,
    per_height: f32,
    foot: f32,
    /// How far below 0 rounding can carry the barycentric coordinates of a point, in cyclic order from the vertex `first`,
    /// and how far it can carry a coordinate off the plane.
    slack: [f32; 3],
    lift: f32,
    density: f32,
}

/// 2⁻⁴⁰, the smallest height over the longest side: lower triangles are lines in `f32`.
const LOWEST: f32 = 9.094_947e-13;

impl<const D: usize> TriangleOn<D> {
    /// Uniform on the triangle with these vertices.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Empty`] for a triangle that has no area, is lower than 2⁻⁴⁰ of
    /// its longest side, or has a density that overflows, [`Error::TooLarge`] for one whose area overflows.
    pub fn new(vertices: [[f32; D]; 3]) -> Result<Self, Error> {
        let mut largest = 0.0_f32;
        for x in vertices.as_flattened() {
            if !x.is_finite() {
                return Err(Error::NotFinite(0));
            }
            largest = clamp(x.abs(), largest, f32::MAX);
        }
        // Powers of two scale exactly. After `unit` no difference overflows, after `scale` the longest side is near 1.
        let unit = if largest > 0.25 * f32::MAX { 4.0 } else { 1.0 };
        let mut sides = [[(0.0, 0.0); D]; 3];
        let longest = differences(&vertices, 1.0 / unit, &mut sides);
        if longest < f32::MIN_POSITIVE {
            return Err(Error::Empty(0));
        }
        let scale = binade(longest);
        scaled(sides.as_flattened_mut(), scale);
        let [ab, bc, ca] = &sides;
        let [ab2, bc2, ca2] = [ab, bc, ca].map(|s| dot(s, s));
        let (first, base, next, last, base2) = if ab2 >= bc2 && ab2 >= ca2 {
            (0, ab, bc, ca, ab2)
        } else if bc2 >= ca2 {
            (1, bc, ca, ab, bc2)
        } else {
            (2, ca, ab, bc, ca2)
        };
        let mut part = [(0.0, 0.0); D];
        let cross = contraction(base, next, &mut part);
        let length = sqrt(base2);
        let height = cross / length;
        if height < LOWEST * length {
            return Err(Error::Empty(0));
        }
        let density = 2.0 / cross / unit / scale / unit / scale;
        if !density.is_finite() {
            return Err(Error::Empty(0));
        }
        if density < f32::MIN_POSITIVE {
            return Err(Error::TooLarge(0));
        }
        let along = base.map(|x| quotient(x, length));
        let across = part.map(|x| quotient(x, cross * length));
        let foot = -dot(base, last) / base2;
        let (anchor, offsets, reach) = anchored(vertices);
        // The change of a barycentric coordinate along the two axes.
        let (run, rise) = (1.0 / length, 1.0 / height);
        let changes = [(-run, foot * rise - rise), (run, -foot * rise), (0.0, rise)];
        // A proof, in steps of 2⁻²⁴. No point leaves the box, so its offset from a vertex has 3/2 of the longest side at
        // most; its dot products with the axes add D roundings, the axes and the reciprocals their own, and the height
        // half a rounding for each coordinate plane. In the second term: weights whose sum is off by 3, and 3 more of
        // the products and sums of a point.
        let d = D as f32;
        let error = (8.5 + (0.75 + 0.25 * d) * d) * f32::EPSILON;
        let mut slack = [0.0; 3];
        for (sum, (run, rise)) in slack.iter_mut().zip(&changes) {
            *sum = error * length * (run.abs() + rise.abs());
            for ((t, g), m) in along.iter().zip(&across).zip(&reach) {
                *sum += (run * t + rise * g).abs() * (3.0 * f32::EPSILON * (m / unit / scale));
            }
        }
        Ok(Self {
            anchor,
            offsets,
            first,
            along,
            across,
            per_length: run / unit / scale,
            per_height: rise / unit / scale,
            foot,
            slack,
            lift: (d + 2.0) * f32::EPSILON * largest + 2.0 * error * (length * unit * scale),
            density,
        })
    }

    /// The vertices.
    #[must_use]
    pub fn vertices(&self) -> [[f32; D]; 3] {
        // Exact: the offsets are.
        self.offsets.map(|mut vertex| {
            for (x, anchor) in vertex.iter_mut().zip(self.anchor) {
                *x += anchor;
            }
            vertex
        })
    }

    /// The area of the triangle.
    #[must_use]
    pub fn area(&self) -> f32 {
        1.0 / self.density
    }

    /// The change of the barycentric coordinates, in cyclic order from the vertex `first`, from a vertex to the projection
    /// of `point` onto the plane; and whether `point` is within rounding of the plane.
    #[inline]
    fn steps(&self, point: [f32; D], vertex: &[f32; D]) -> ([f32; 3], bool) {
        let mut from = point;
        let (mut run, mut rise) = (0.0, 0.0);
        let axes = self.along.iter().zip(&self.across);
        let rows = from.iter_mut().zip(self.anchor.iter().zip(vertex));
        for ((x, (r, o)), (t, g)) in rows.zip(axes.clone()) {
            *x = (*x - r) - o;
            run += *x * t;
            rise += *x * g;
        }
        let mut near = true;
        if D > 2 {
            for (x, (t, g)) in from.iter().zip(axes) {
                near &= ((x - run * t) - rise * g).abs() <= self.lift;
            }
        }
        let (run, rise) = (run * self.per_length, rise * self.per_height);
        let back = -run - (1.0 - self.foot) * rise;
        ([back, run - self.foot * rise, rise], near)
    }
}

/// The power of two at or below a normal number.
fn binade(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0x7f80_0000)
}

/// The exact sides of a triangle, scaled by a power of two, each from a vertex to the next; and their largest coordinate.
fn differences<const D: usize>(
    vertices: &[[f32; D]; 3],
    scale: f32,
    sides: &mut [[DoubleWord; D]; 3],
) -> f32 {
    let [a, b, c] = vertices;
    let mut longest = 0.0_f32;
    for (side, (from, to)) in sides.iter_mut().zip([(a, b), (b, c), (c, a)]) {
        for (side, (from, to)) in side.iter_mut().zip(from.iter().zip(to)) {
            *side = two_sum(to * scale, -(from * scale));
            longest = clamp(side.0.abs(), longest, f32::MAX);
        }
    }
    longest
}

fn scaled(numbers: &mut [DoubleWord], by: f32) {
    for (x, rest) in numbers {
        *x /= by;
        *rest /= by;
    }
}

fn dot(p: &[DoubleWord], q: &[DoubleWord]) -> f32 {
    let mut sum = TripleWord::ZERO;
    for (p, q) in p.iter().zip(q) {
        sum.add_product(*p, *q);
    }
    sum.rounded().0
}

/// The component of q at right angles to p, times p², and the area that the two span. Both come from the determinants
/// in the coordinate planes, which are exact to `f32` however flat the two lie.
fn contraction(p: &[DoubleWord], q: &[DoubleWord], part: &mut [DoubleWord]) -> f32 {
    let mut squares = 0.0;
    for (i, (part, (p1, q1))) in part.iter_mut().zip(p.iter().zip(q)).enumerate() {
        for (j, (p2, q2)) in p.iter().zip(q).enumerate() {
            if i == j {
                continue;
            }
            let determinant = TripleWord::determinant(*p2, *q1, *p1, *q2);
            if i < j {
                squares += determinant.0 * determinant.0;
            }
            let mut total = TripleWord::ZERO;
            total.add(part.0);
            total.add(part.1);
            total.add_product(*p2, determinant);
            *part = total.rounded();
        }
    }
    sqrt(squares)
}

/// What the area of a triangle in space comes from: the cross product of two sides, its length, and the power of two
/// whose square is the unit of both.
pub(crate) struct Spanned {
    pub(crate) cross: [f32; 3],
    pub(crate) length: f32,
    pub(crate) unit: f32,
}

impl Spanned {
    /// That of finite vertices; nothing for a triangle without area, or lower than 2⁻⁴⁰ of its longest side.
    pub(crate) fn of(vertices: [[f32; 3]; 3]) -> Option<Self> {
        // Scaled by 1/4 so that differences cannot overflow. Exact but for coordinates near the
        // subnormal numbers, whose lost bits show in no area that is accepted.
        let mut sides = [[(0.0, 0.0); 3]; 3];
        let longest = differences(&vertices, 0.25, &mut sides);
        if longest < f32::MIN_POSITIVE {
            return None;
        }
        let scale = binade(longest);
        scaled(sides.as_flattened_mut(), scale);
        let squares = sides.each_ref().map(|side| dot(side, side));
        let [[x, y, z], _, back] = sides;
        let [f, g, h] = back.map(|(x, rest)| (-x, -rest));
        let cross = [(y, h, z, g), (z, f, x, h), (x, g, y, f)]
            .map(|(a, b, c, d)| TripleWord::determinant(a, b, c, d).0);
        let [i, j, k] = cross;
        let length = sqrt(i * i + j * j + k * k);
        let (_, base2) = {
            let [p2, q2, r2] = squares;
            ends(p2, q2, r2)
        };
        (length >= LOWEST * base2).then_some(Self {
            cross,
            length,
            unit: 4.0 * scale,
        })
    }
}

/// The barycentric combination of offsets from an anchor, within their range.
#[inline]
pub(crate) fn combined<const D: usize>(
    anchor: [f32; D],
    [mut point, b, c]: [[f32; D]; 3],
    [u, v, w]: [f32; 3],
) -> [f32; D] {
    for (((x, b), c), anchor) in point.iter_mut().zip(b).zip(c).zip(anchor) {
        let a = *x;
        let (low, high) = ends(a, b, c);
        *x = anchor + clamp(u * a + v * b + w * c, low, high);
    }
    point
}

/// The anchor, the offsets from it, and the largest magnitude of each coordinate.
#[inline]
pub(crate) fn anchored<const D: usize>(
    vertices: [[f32; D]; 3],
) -> ([f32; D], [[f32; D]; 3], [f32; D]) {
    let ([mut anchor, mut reach], [mut a, mut b, mut c]) = ([[0.0; D]; 2], vertices);
    let rows = anchor.iter_mut().zip(&mut reach);
    for ((anchor, reach), ((a, b), c)) in rows.zip(a.iter_mut().zip(&mut b).zip(&mut c)) {
        let (low, high) = ends(*a, *b, *c);
        let (near, far) = if low.abs() < high.abs() {
            (low, high)
        } else {
            (high, low)
        };
        *reach = far.abs();
        // Within a factor of two, so that the differences are exact.
        if high - low <= 0.5 * *reach {
            *anchor = near;
            *a -= near;
            *b -= near;
            *c -= near;
        }
    }
    (anchor, [a, b, c], reach)
}

/// The least and the greatest of three numbers.
#[inline]
fn ends(a: f32, b: f32, c: f32) -> (f32, f32) {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    (
        if c < low { c } else { low },
        if c > high { c } else { high },
    )
}

impl<const D: usize> Warp for TriangleOn<D> {
    type Uniforms = [f32; 2];
    type Point = [f32; D];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; D] {
        combined(
            self.anchor,
            self.offsets,
            Triangle::new().sample_canonical(u),
        )
    }

    #[inline]
    fn pdf(&self, point: [f32; D]) -> f32 {
        let [a, b, c] = &self.offsets;
        let begin = match self.first {
            0 => a,
            1 => b,
            _ => c,
        };
        let ([p, q, r], near) = self.steps(point, begin);
        let [least_p, least_q, least_r] = self.slack;
        if near && 1.0 + p >= -least_p && q >= -least_q && r >= -least_r {
            self.density
        } else {
            0.0
        }
    }

    super::filled_in_blocks!();
}

impl<const D: usize> Invert for TriangleOn<D> {
    #[inline]
    fn invert(&self, point: [f32; D]) -> [f32; 2] {
        // Measured from the first vertex, where the second uniform is a quotient of small numbers.
        let [a, ..] = &self.offsets;
        let ([p, q, r], _) = self.steps(point, a);
        let [u, v, w] = match self.first {
            0 => [p, q, r],
            1 => [r, p, q],
            _ => [q, r, p],
        };
        Triangle::new().invert([1.0 + u, v, w])
    }
}
