//! A triangle in bits: the same in every format.

use super::super::direction::ONE;
use super::super::grade::Grade;
use super::super::kernel::product::wide;
use super::super::minors::{largest, minor, next, sorted, squares};
use super::super::triangle::Triangle;
use super::super::{Coordinate, Uniform};
use crate::error::Error;
use crate::num::division::scaled;
use crate::warp::{Invert, Warp};

/// The vertices of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Corners<const D: usize> {
    pub vertices: [[i32; D]; 3],
    /// The smallest value of each coordinate.
    low: [i32; D],
    /// The two coordinates on whose plane the triangle has its largest projection.
    axes: [usize; 2],
}

impl<const D: usize> Corners<D> {
    /// A triangle of these vertices, and twice its area: a number above 0, and how many of its bits are a fraction.
    pub(super) const fn new([a, b, c]: [[i32; D]; 3]) -> Result<(Self, u64, i32), Error> {
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
        let (twice, fraction) = if D > 2 {
            let left = largest.leading_zeros() as i32 - 16;
            let sum = squares(vertices, left);
            let zeros = sum.leading_zeros() & !1;
            let root = ((sum << zeros >> 64) as u64).isqrt();
            (root, left - 32 + (zeros >> 1) as i32)
        } else {
            (largest, 0)
        };
        let corners = Self {
            vertices: [a, b, c],
            low,
            axes,
        };
        Ok((corners, twice, fraction))
    }

    /// The projection on the plane of the two coordinates where the triangle is largest.
    #[inline]
    fn projection(&self, point: &[i32; D]) -> [i64; 2] {
        let [i, j] = self.axes;
        [coordinate(point, i), coordinate(point, j)]
    }

    /// The projections of the vertices.
    #[inline]
    fn projections(&self) -> [[i64; 2]; 3] {
        let [a, b, c] = &self.vertices;
        [self.projection(a), self.projection(b), self.projection(c)]
    }

    /// The three vertices' value of a coordinate.
    #[inline]
    fn row(&self, axis: usize) -> [i64; 3] {
        let [a, b, c] = &self.vertices;
        [
            coordinate(a, axis),
            coordinate(b, axis),
            coordinate(c, axis),
        ]
    }

    /// For a point of the bounding box, in projection: twice the area of the part opposite to each vertex, positive
    /// inside, and by how much a step in each coordinate changes it.
    #[inline]
    fn parts(&self, point: &[i32; D]) -> [(i64, i64); 3] {
        let [a, b, c] = self.projections();
        let x = self.projection(point);
        let turned = minor([a[0], b[0], c[0]], [a[1], b[1], c[1]]) < 0;
        let part = |p: [i64; 2], q: [i64; 2]| {
            let (side, way) = (difference(p, q), difference(p, x));
            let part = side[0] * way[1] - side[1] * way[0];
            let step = side[0].abs() + side[1].abs();
            (if turned { -part } else { part }, step)
        };
        [part(b, c), part(c, a), part(a, b)]
    }

    /// Whether a point of the bounding box lies in the plane of the triangle, give or take two steps in each coordinate.
    #[inline]
    fn is_in_plane(&self, point: &[i32; D]) -> bool {
        let way = |k| coordinate(point, k) - self.row(k)[0];
        let [i, j] = self.axes;
        let main = minor(self.row(i), self.row(j));
        let right = 34_u32.saturating_sub(main.unsigned_abs().leading_zeros());
        (0..D).all(|k| {
            // This coordinate follows from the other two.
            let minor = |a, b| minor(self.row(a), self.row(b)) >> right;
            let (main, first, second) = (main >> right, minor(k, j), minor(i, k));
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
        let high = a.into_iter().zip(b).zip(c);
        let ends = self.low.into_iter().zip(high);
        ends.map(|(low, ((a, b), c))| (low, a.max(b).max(c)))
    }

    /// The point of two words.
    #[inline]
    pub(super) fn point<G: Grade>(&self, u: [Uniform; 2]) -> [i32; D] {
        let [u, v, w] = Triangle::<G>::new().sample(u);
        let (u, v, w) = (u.to_bits() as u32, v.to_bits() as u32, w.to_bits() as u32);
        let ([a, b, c], mut point) = (self.vertices, self.low);
        for (((x, a), b), c) in point.iter_mut().zip(a).zip(b).zip(c) {
            let low = *x;
            let share = |vertex: i32, weight| wide((vertex - low) as u32, weight);
            // The weights sum up to 1, so the sum of shares is at most the largest of them.
            let sum = share(a, u) + share(b, v) + share(c, w);
            *x = low + ((sum + (1 << 29)) >> 30) as i32;
        }
        point
    }

    /// Whether a point lies on the triangle, or up to a step outside it.
    #[inline]
    pub(super) fn has(&self, point: &[i32; D]) -> bool {
        let mut ends = self.ends().zip(point);
        let in_box = ends.all(|((low, high), x)| low <= *x && *x <= high);
        let inside = in_box && self.parts(point).iter().all(|(part, step)| *part >= -step);
        inside && (D == 2 || self.is_in_plane(point))
    }

    /// The words of the point of the triangle that is nearest to this one.
    #[inline]
    pub(super) fn words<G: Grade>(&self, point: &[i32; D]) -> [Uniform; 2] {
        let mut nearest = *point;
        for (x, (low, high)) in nearest.iter_mut().zip(self.ends()) {
            // `clamp` would panic if its bounds were reversed, and the compiler cannot see that they are not.
            *x = (*x).max(low).min(high);
        }
        let due = self.level(&nearest);
        let triangle = Triangle::<G>::new();
        let [u1, _] = triangle.invert([
            Coordinate::from_bits(ONE - due),
            Coordinate::ZERO,
            Coordinate::from_bits(due),
        ]);
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
        let by = |u1: i64| {
            let second = self.second(&nearest, reached::<G>(u1));
            let u = [Uniform::from_bits(u1 as u32), Uniform::from_bits(second)];
            let again = self.point::<G>(u);
            let pairs = again.iter().zip(&nearest);
            (
                pairs.fold(0, |sum, (x, y)| sum + u64::from(x.abs_diff(*y))),
                u,
            )
        };
        let ((near, first), (far, second)) = (by(u1), by(other));
        if far < near { second } else { first }
    }

    /// How far the point of the triangle that is nearest to a point of the box lies from the first vertex towards the
    /// opposite side, in Q30.
    #[inline]
    fn level(&self, point: &[i32; D]) -> i32 {
        let x = self.projection(point);
        let [a, b, c] = self.projections();
        let [(p, _), (q, _), (r, _)] = self.parts(point);
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
        let [a, b, c] = self.projections();
        let x = difference(a, self.projection(point));
        let (b, c) = (difference(a, b), difference(a, c));
        let side = difference(c, b);
        // Shifted until they fill 31 bits. The segment and the point are in the box, so no difference is longer.
        let sides = [b, c, side];
        let sides = sides.as_flattened().iter().fold(0, |all, x| all | x.abs());
        let left = sides.leading_zeros().saturating_sub(33);
        let lifted = |[x, y]: [i64; 2]| [x << left, y << left];
        let (x, c, side) = (lifted(x), lifted(c), lifted(side));
        let part = |c: i64| (c * level + (1 << 29)) >> 30;
        let end = [part(c[0]), part(c[1])];
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

/// How far a first uniform leads from the first vertex towards the opposite side, in Q30.
#[inline]
fn reached<G: Grade>(u1: i64) -> i64 {
    let u = [Uniform::from_bits(u1 as u32), Uniform::ZERO];
    let [_, _, level] = Triangle::<G>::new().sample(u);
    level.to_bits().into()
}

#[inline]
fn coordinate<const D: usize>(point: &[i32; D], axis: usize) -> i64 {
    point.get(axis).map_or(0, |x| i64::from(*x))
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
