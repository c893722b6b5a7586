//! The uniform distribution on the triangle of three given vertices.

use super::direction::{ONE, Scaled, UNIT};
use super::grade::{Fine, Grade};
use super::kernel::product::wide;
use super::minors::{largest, minor, next, sorted, squares};
use super::triangle::Triangle;
use super::{Coordinate, Density, Uniform};
use crate::error::Error;
use crate::num::division::scaled;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedI32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Uniform on the triangle of three given vertices, in D dimensions (2, 3 or more).
///
/// A point is the barycentric combination of the vertices; each coordinate is rounded once to the step of the format.
///
/// # Density
/// 1/area per unit area on the triangle and up to a step outside it, at least 2⁻³²; 0 elsewhere.
///
/// # Domain
/// - Point: inside the bounding box of the vertices, always, and on the triangle up to rounding.
/// - Uniforms: two words, those of [`Triangle`].
/// - Parameters: three vertices in any signed format of 32 bits, no two farther apart than the format's largest number.
/// - `invert` returns words whose sample is the point, give or take four steps and twice the error of a sample, of the largest
///   extent, in any sliver. In a triangle of few steps many words have the same sample.
///
/// # Accuracy
/// *Sample* is relative to the extent of a coordinate, beyond half a step of the format. *Pdf* is the relative error of
/// the density, beyond a step of 2⁻³².
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 2.5e-7 | 2.2e-5 | 7.6e-8 | found |
/// | pdf | 1.2e-9 | 1.2e-9 | 1.2e-9 | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed TriangleOn -->263 instructions and 596 bytes of code on an M0, 87 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I16F16, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let facet = mw::TriangleOn::new([[0, 0], [4, 0], [0, 2]].map(|v| v.map(I16F16::from_num)))?;
/// assert_eq!(facet.sample([0.25_f32, 0.5].map(U0F32::from_num)), [1.0, 0.5]);
/// assert_eq!(facet.pdf([1.0, 0.5].map(I16F16::from_num)), 0.25);
/// assert_eq!(facet.pdf([4, 2].map(I16F16::from_num)), 0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Triangle`] gives the barycentric coordinates alone, to interpolate with.
/// - [`warp::TriangleOn`](crate::warp::TriangleOn) is the one of the float tiers.
///
/// # Source
/// G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
#[doc(alias = "mesh")]
#[doc(alias = "facet")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleOn<Frac, const D: usize, G = Fine> {
    vertices: [[i32; D]; 3],
    /// The smallest value of each coordinate.
    low: [i32; D],
    /// The two coordinates on whose plane the triangle has its largest projection.
    axes: [usize; 2],
    density: Density,
    format: PhantomData<(Frac, G)>,
}

impl<Frac: LeEqU32, const D: usize, G: Grade> TriangleOn<Frac, D, G> {
    /// Uniform on the triangle with these vertices.
    ///
    /// # Errors
    /// [`Error::TooLarge`] where the difference of two vertices overflows the format in a coordinate, [`Error::Empty`]
    /// for a triangle with no area, or so little that its density overflows.
    pub const fn new(vertices: [[FixedI32<Frac>; D]; 3]) -> Result<Self, Error> {
        let [a, b, c] = vertices;
        let [a, b, c] = [bits(a), bits(b), bits(c)];
        let (vertices, mut low) = ([a.as_slice(), &b, &c], a);
        let (mut rest, mut slots): (_, &mut [i32]) = (vertices, &mut low);
        while let (Some((row, others)), Some((slot, later))) = (next(rest), slots.split_first_mut())
        {
            let [least, _, most] = sorted(row);
            if most - least > i32::MAX as i64 {
                return Err(Error::TooLarge(0));
            }
            *slot = least as i32;
            (rest, slots) = (others, later);
        }
        let (axes, largest) = largest(vertices);
        if largest == 0 {
            return Err(Error::Empty(0));
        }
        // Twice the area is the root of the sum of the squares of all minors. Of 48 bits each, 2³¹ of them fit.
        let (root, fraction) = if D > 2 {
            let left = largest.leading_zeros() as i32 - 16;
            let sum = squares(vertices, left);
            let zeros = sum.leading_zeros() & !1;
            let root = ((sum << zeros >> 64) as u64).isqrt();
            (root, left - 32 + (zeros >> 1) as i32)
        } else {
            (largest, 0)
        };
        let height = UNIT.over(Scaled::of(root, 2 * Frac::I32 + 1 + fraction));
        // 2³² or more.
        if height.exponent < -32 {
            return Err(Error::Empty(0));
        }
        Ok(Self {
            vertices: [a, b, c],
            low,
            axes,
            density: height.density(u32::MAX),
            format: PhantomData,
        })
    }

    /// The vertices.
    #[must_use]
    pub const fn vertices(&self) -> [[FixedI32<Frac>; D]; 3] {
        let [a, b, c] = self.vertices;
        [numbers(a), numbers(b), numbers(c)]
    }
}

/// The bits of a vertex.
const fn bits<Frac, const D: usize>(vertex: [FixedI32<Frac>; D]) -> [i32; D] {
    let mut bits = [0; D];
    let (mut rest, mut slots): (_, &mut [i32]) = (vertex.as_slice(), &mut bits);
    while let ([x, others @ ..], [slot, later @ ..]) = (rest, slots) {
        *slot = x.to_bits();
        (rest, slots) = (others, later);
    }
    bits
}

/// The vertex of these bits.
const fn numbers<Frac, const D: usize>(bits: [i32; D]) -> [FixedI32<Frac>; D] {
    let mut vertex = [FixedI32::ZERO; D];
    let (mut rest, mut slots): (_, &mut [FixedI32<Frac>]) = (bits.as_slice(), &mut vertex);
    while let ([x, others @ ..], [slot, later @ ..]) = (rest, slots) {
        *slot = FixedI32::from_bits(*x);
        (rest, slots) = (others, later);
    }
    vertex
}

impl<Frac: LeEqU32, const D: usize, G: Grade> TriangleOn<Frac, D, G> {
    /// The projection on the plane of the two coordinates where the triangle is largest.
    #[inline]
    fn projection(&self, point: &[i32; D]) -> [i64; 2] {
        self.axes.map(|axis| coordinate(point, axis))
    }

    /// For a point of the bounding box, in projection: twice the area of the part opposite to each vertex, positive
    /// inside, and by how much a step in each coordinate changes it.
    #[inline]
    fn parts(&self, point: &[i32; D]) -> [(i64, i64); 3] {
        let [a, b, c] = self.vertices.each_ref().map(|v| self.projection(v));
        let x = self.projection(point);
        let part = |p: [i64; 2], q: [i64; 2]| {
            let [side, way] = [q, x].map(|[x, y]| [x - p[0], y - p[1]]);
            let part = side[0] * way[1] - side[1] * way[0];
            (part, side[0].abs() + side[1].abs())
        };
        let parts = [part(b, c), part(c, a), part(a, b)];
        if minor([a[0], b[0], c[0]], [a[1], b[1], c[1]]) < 0 {
            parts.map(|(part, step)| (-part, step))
        } else {
            parts
        }
    }

    /// Whether a point of the bounding box lies in the plane of the triangle, give or take two steps in each coordinate.
    #[inline]
    fn is_in_plane(&self, point: &[i32; D]) -> bool {
        let row = |k| self.vertices.each_ref().map(|v| coordinate(v, k));
        let way = |k| coordinate(point, k) - row(k)[0];
        let [i, j] = self.axes;
        let main = minor(row(i), row(j));
        let right = 34_u32.saturating_sub(main.unsigned_abs().leading_zeros());
        (0..D).all(|k| {
            // This coordinate follows from the other two.
            let minors = [main, minor(row(k), row(j)), minor(row(i), row(k))];
            let [main, first, second] = minors.map(|m| m >> right);
            let [x, along, across] = [way(k), way(i), way(j)];
            let off = main * x - first * along - second * across;
            let step = main.abs() + first.abs() + second.abs();
            // A minor that was shifted is off by up to 1.
            let cut = if right > 0 {
                x.abs() + along.abs() + across.abs()
            } else {
                0
            };
            off.abs() <= 2 * step + cut
        })
    }

    /// The smallest and the largest value of each coordinate.
    #[inline]
    fn ends(&self) -> impl Iterator<Item = (i32, i32)> {
        let [a, b, c] = self.vertices;
        let high = a
            .into_iter()
            .zip(b)
            .zip(c)
            .map(|((a, b), c)| a.max(b).max(c));
        self.low.into_iter().zip(high)
    }
}

#[inline]
fn coordinate<const D: usize>(point: &[i32; D], axis: usize) -> i64 {
    point.get(axis).map_or(0, |x| i64::from(*x))
}

impl<Frac: LeEqU32, const D: usize, G: Grade> Warp for TriangleOn<Frac, D, G> {
    type Uniforms = [Uniform; 2];
    type Point = [FixedI32<Frac>; D];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [FixedI32<Frac>; D] {
        let weights = Triangle::<G>::new().sample_canonical(u);
        let [u, v, w] = weights.map(|c| c.to_bits() as u32);
        let ([a, b, c], mut point) = (self.vertices, self.low);
        for (((x, a), b), c) in point.iter_mut().zip(a).zip(b).zip(c) {
            let low = *x;
            let share = |vertex: i32, weight| wide((vertex - low) as u32, weight);
            // The weights sum up to 1, so the sum of shares is at most the largest of them.
            let sum = share(a, u) + share(b, v) + share(c, w);
            *x = low + ((sum + (1 << 29)) >> 30) as i32;
        }
        point.map(FixedI32::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [FixedI32<Frac>; D]) -> Density {
        let point = point.map(FixedI32::to_bits);
        let mut ends = self.ends().zip(&point);
        let in_box = ends.all(|((low, high), x)| low <= *x && *x <= high);
        let inside = in_box && self.parts(&point).iter().all(|(part, step)| *part >= -step);
        if inside && (D == 2 || self.is_in_plane(&point)) {
            self.density
        } else {
            Density::ZERO
        }
    }
}

impl<Frac: LeEqU32, const D: usize, G: Grade> Invert for TriangleOn<Frac, D, G> {
    #[inline]
    fn invert(&self, point: [FixedI32<Frac>; D]) -> [Uniform; 2] {
        let mut nearest = point.map(FixedI32::to_bits);
        for (x, (low, high)) in nearest.iter_mut().zip(self.ends()) {
            // `clamp` would panic if its bounds were reversed, and the compiler cannot see that they are not.
            *x = (*x).max(low).min(high);
        }
        let due = self.level(&nearest);
        let triangle = Triangle::<G>::new();
        let [u1, _] = triangle.invert([ONE - due, 0, due].map(Coordinate::from_bits));
        // Twice Newton's, against the error that the grade's root has.
        let mut u1 = i64::from(u1.to_bits());
        for _ in 0..2 {
            let off = i64::from(due) - reached::<G>(u1);
            u1 = (u1 + ((i64::from(due) * off + (1 << 26)) >> 27)).clamp(0, u32::MAX.into());
        }
        // The two first uniforms on either side. The levels whose segment passes by the point lie side by side, and one
        // of them is that of the uniform which the point may be a sample of: of these two, one is among them.
        let other = if reached::<G>(u1) < i64::from(due) {
            u1 + 1
        } else {
            u1 - 1
        };
        let other = other.clamp(0, u32::MAX.into());
        let [first, second] = [u1, other].map(|u1| {
            let u = [u1 as u32, self.second(&nearest, reached::<G>(u1))].map(Uniform::from_bits);
            let again = self.sample(u).map(FixedI32::to_bits);
            let pairs = again.iter().zip(&nearest);
            (
                pairs.fold(0, |sum, (x, y)| sum + u64::from(x.abs_diff(*y))),
                u,
            )
        });
        if second.0 < first.0 {
            second.1
        } else {
            first.1
        }
    }
}

/// How far a first uniform leads from the first vertex towards the opposite side, in Q30.
#[inline]
fn reached<G: Grade>(u1: i64) -> i64 {
    let u = [Uniform::from_bits(u1 as u32), Uniform::ZERO];
    let [_, _, level] = Triangle::<G>::new().sample(u);
    level.to_bits().into()
}

impl<Frac: LeEqU32, const D: usize, G: Grade> TriangleOn<Frac, D, G> {
    /// How far the point of the triangle that is nearest to a point of the box lies from the first vertex towards the
    /// opposite side, in Q30.
    #[inline]
    fn level(&self, point: &[i32; D]) -> i32 {
        let x = self.projection(point);
        let [a, b, c] = self.vertices.each_ref().map(|v| self.projection(v));
        let [p, q, r] = self.parts(point).map(|(part, _)| part);
        if p >= 0 && q >= 0 && r >= 0 {
            share(q + r, p + q + r)
        } else if foot(b, c, x, p).is_some() {
            ONE
        } else if let Some(part) = foot(c, a, x, q) {
            ONE - part
        } else if let Some(part) = foot(a, b, x, r) {
            part
        } else {
            let distance = |vertex| {
                let way = difference(vertex, x);
                dot(way, way)
            };
            if distance(a) < distance(b).min(distance(c)) {
                0
            } else {
                ONE
            }
        }
    }

    /// The second uniform of the point nearest to a point of the box, of the segment at a level, in Q30, from the first
    /// vertex to the opposite side.
    #[inline]
    fn second(&self, point: &[i32; D], level: i64) -> u32 {
        let [a, b, c] = self.vertices.each_ref().map(|v| self.projection(v));
        let [x, b, c] = [self.projection(point), b, c].map(|to| difference(a, to));
        let side = difference(c, b);
        // Shifted until they fill 31 bits. The segment and the point are in the box, so no difference is longer.
        let sides = [b, c, side];
        let sides = sides.as_flattened().iter().fold(0, |all, x| all | x.abs());
        let left = sides.leading_zeros().saturating_sub(33);
        let [x, c, side] = [x, c, side].map(|v| v.map(|x| x << left));
        let end = c.map(|c| (c * level + (1 << 29)) >> 30);
        let along = (dot(difference(end, x), side).max(0) as u128) << 30;
        let whole = dot(side, side) as u128 * level as u128;
        if along < whole {
            scaled(along, whole, 32).0 as u32
        } else if along > 0 {
            u32::MAX
        } else {
            0
        }
    }
}

#[inline]
fn difference(from: [i64; 2], to: [i64; 2]) -> [i64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

#[inline]
fn dot(p: [i64; 2], q: [i64; 2]) -> i64 {
    p[0] * q[0] + p[1] * q[1]
}

/// How far along a side the foot of the perpendicular from x lies, in Q30; nothing where x is not outside that side
/// (`part` is not negative), or where the foot is not on it.
#[inline]
fn foot(from: [i64; 2], to: [i64; 2], x: [i64; 2], part: i64) -> Option<i32> {
    let side = difference(from, to);
    let (along, whole) = (dot(side, difference(from, x)), dot(side, side));
    (part < 0 && 0 <= along && along <= whole).then(|| share(along, whole))
}

/// part/whole in Q30, rounded, for 0 ≤ part ≤ whole.
#[inline]
fn share(part: i64, whole: i64) -> i32 {
    let (twice, _) = scaled(part as u128, whole as u128, 31);
    (twice as u32).div_ceil(2) as i32
}

#[cfg(feature = "defmt")]
impl<Frac, const D: usize, G> defmt::Format for TriangleOn<Frac, D, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "TriangleOn {{ vertices: {} }}", self.vertices);
    }
}
