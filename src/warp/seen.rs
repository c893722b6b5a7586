//! A triangle seen from a point: what the warps over spherical triangles and rectangles share.
//!
//! A corner is 0 (the apex, at the first uniform 0), 1 (where the second uniform is 0) or 2. Side i and normal i belong to
//! the edge opposite to corner i. Everything is said in terms of weights: a direction is the sum of the directions of the
//! corners times their weights, and no weight is ever a difference.

mod exact;
mod side;

pub(super) use self::exact::{difference, negative, sum};

use self::exact::{Exact, binade, cross, exact_dot, largest, scale};
use self::side::{NEAR, Side, combined, dot, rounded_unit, unit};
use super::direction::is_direction;
use super::spherical::normalised;
use crate::error::Error;
use crate::tier::{Tier, sqrt};

/// 2⁶⁰ and its reciprocal: the largest and the smallest length.
const LONG: f32 = 1_152_921_504_606_846_976.0;
const SHORT: f32 = 1.0 / LONG;

/// 2⁻³⁰, the shortest length beside the longest one.
const LEAST: f32 = 9.313_226e-10;

/// 2⁻²⁸, the smallest volume of a point and a triangle beside the product of the lengths.
const FLATTEST: f32 = 3.725_290_3e-9;

/// The distance of the point from the plane triangle whose corners are the directions of the vertices, below which it is
/// close to the triangle, and below which it lies on it: 2⁻⁶ and 2⁻¹⁰.
const CLOSE: f32 = 0.015_625;
const ON: f32 = 9.765_625e-4;

/// 2⁻⁶: the distance of the nearest corner beside that of the farthest, above which area may be sampled.
const EVEN: f32 = 0.015_625;

/// The angle by which rounding can carry a sample over a side of a small triangle.
const RIM: f32 = 4.0e-7;

/// A triangle seen from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Seen {
    /// The directions of the corners, and their distances in a unit of length.
    corners: [[f32; 3]; 3],
    distances: [f32; 3],
    /// Of each side the unit normal, inwards, and its sine.
    normals: [[f32; 3]; 3],
    sines: [f32; 3],
    /// How far beyond a side rounding can carry a sample.
    rim: f32,
    /// The sum of the ends of the longest side: directions opposite to a thin triangle are beyond its sides by no more
    /// than rounding.
    middle: [f32; 3],
    /// H, half the solid angle as an angle in turns, what it lacks of half a turn, its sine and its cosine.
    half: f32,
    lack: f32,
    sin: f32,
    cos: f32,
    /// 1 + cos of side 2, and twice that over R.
    rise: f32,
    slope: f32,
    /// (1 + cos)/2 of side 0.
    near: f32,
    /// The volume of the point and the triangle, six times, over the three distances.
    volume: f32,
    /// Whether the corners are about as far away as each other.
    even: bool,
    /// Whether the point is so near that area is sampled.
    close: bool,
}

fn least_of([a, b, c]: [f32; 3]) -> f32 {
    let least = if a < b { a } else { b };
    if least < c { least } else { c }
}

/// Refuses coordinates that are not finite, or beyond 2⁶⁰.
pub(super) fn checked(vectors: &[[f32; 3]]) -> Result<(), Error> {
    for x in vectors.as_flattened() {
        if !x.is_finite() {
            return Err(Error::NotFinite);
        }
    }
    for x in vectors.as_flattened() {
        if x.abs() > LONG {
            return Err(Error::TooLarge);
        }
    }
    Ok(())
}

impl Seen {
    /// The triangle of these corners, seen from 0. Edge i leads from corner i + 1 to corner i + 2.
    pub(super) fn new<T: Tier>(
        mut corners: [Exact; 3],
        mut edges: [Exact; 3],
    ) -> Result<Self, Error> {
        let (far, long) = (largest(&corners), largest(&edges));
        if long < SHORT || long < LEAST * far {
            return Err(Error::Empty);
        }
        scale(&mut corners, 1.0 / binade(far));
        scale(&mut edges, 1.0 / binade(long));
        let edge = binade(long) / binade(far);
        let [p0, p1, p2] = &corners;
        let [e0, e1, e2] = &edges;
        let (c0, d0) = rounded_unit(p0, 1.0);
        let (c1, d1) = rounded_unit(p1, 1.0);
        let (c2, d2) = rounded_unit(p2, 1.0);
        let away = d0 >= LEAST && d1 >= LEAST && d2 >= LEAST;
        if !away {
            return Err(Error::NotNormalizable);
        }
        let (n0, n1, n2) = (cross(p1, e0), cross(p2, e1), cross(p0, e2));
        let volume = -exact_dot(e2, &n0);
        let sign = if volume < 0.0 { -1.0 } else { 1.0 };
        let volume = volume.abs();
        let flat = volume < FLATTEST;
        let (n0, l0) = rounded_unit(&n0, sign);
        let (n1, l1) = rounded_unit(&n1, sign);
        let (n2, l2) = rounded_unit(&n2, sign);
        let a = Side::new([c1, c2], [d1, d2], l0, e0, edge);
        let b = Side::new([c2, c0], [d2, d0], l1, e1, edge);
        let c = Side::new([c0, c1], [d0, d1], l2, e2, edge);
        let sines = [a.sine, b.sine, c.sine];
        let (rise0, rise1, rise2) = (a.rise, b.rise, c.rise);
        let volume = volume * edge * edge / d0 / d1 / d2;
        let (longest, normal, apex) = if rise0 <= rise1 && rise0 <= rise2 {
            (&a, n0, c0)
        } else if rise1 <= rise2 {
            (&b, n1, c1)
        } else {
            (&c, n2, c2)
        };
        let (least, middle) = (longest.rise, longest.middle(normal.map(|x| sign * x)));
        // 1 + the three cosines, by the shortest side, or by the longest one if the point is near to that: R cos H.
        let (sum, drop) = if a.drop <= b.drop && a.drop <= c.drop {
            (rise1 + rise2, a.drop)
        } else if b.drop <= c.drop {
            (rise2 + rise0, b.drop)
        } else {
            (rise0 + rise1, c.drop)
        };
        let cos = if least < NEAR && sum + drop > sqrt(least) {
            least + dot(apex, middle)
        } else {
            sum - drop
        };
        let whole = sqrt(2.0 * rise0 * rise1 * rise2);
        let behind = cos < 0.0;
        // To a side, or, for a point before the inside, to the plane triangle.
        let across = combined([n0, n1, n2], sines);
        let height = volume / sqrt(dot(across, across));
        let aside = sqrt(0.5 * least);
        let away = if behind && height < aside {
            height
        } else {
            aside
        };
        if away < ON {
            return Err(Error::NotNormalizable);
        }
        if flat {
            return Err(Error::Empty);
        }
        let (half, lack) = if behind {
            let lack = T::atan2_turns(volume, -cos);
            (0.5 - lack, lack)
        } else {
            let half = T::atan2_turns(volume, cos);
            (half, 0.5 - half)
        };
        // Beside a side, and near to a corner, the density of area is too steep for directions to tell it. That of the
        // solid angle is constant.
        let even = least_of([d0, d1, d2]) > EVEN;
        let close = away < CLOSE && behind && height < aside && even;
        Ok(Self {
            corners: [c0, c1, c2],
            distances: [d0, d1, d2],
            normals: [n0, n1, n2],
            sines,
            rim: if close { 2.0 * RIM } else { RIM } / aside,
            middle,
            half,
            lack,
            sin: volume / whole,
            cos: cos / whole,
            rise: rise2,
            slope: 2.0 * rise2 / whole,
            near: 0.5 * rise0,
            volume,
            even,
            close,
        })
    }

    /// Whether the point is so near that the solid angle has lost its digits and area is sampled.
    pub(super) const fn close(&self) -> bool {
        self.close
    }

    /// Whether area can be sampled with a density that directions tell.
    pub(super) const fn even(&self) -> bool {
        self.even
    }

    /// Half the solid angle, as an angle in turns.
    pub(super) const fn half(&self) -> f32 {
        self.half
    }

    /// The directions of the corners.
    pub(super) const fn corners(&self) -> [[f32; 3]; 3] {
        self.corners
    }

    /// The sine of a part of H, `part` and `rest` being 1 together.
    #[inline]
    fn sine<T: Tier>(&self, part: f32, rest: f32) -> f32 {
        let angle = part * self.half;
        // Beyond a quarter of a turn by what is missing of half a turn.
        T::sincos_turns(if angle > 0.25 {
            self.lack + rest * self.half
        } else {
            angle
        })
        .0
    }

    /// The weights of the corners for uniform directions: `out` from the apex, and `turn` from side 2 to side 1, with
    /// 1 less that beside it.
    #[inline]
    pub(super) fn weights<T: Tier>(&self, out: f32, turn: f32, rest: f32) -> [f32; 3] {
        let x = self.sine::<T>(rest, turn);
        let y = self.slope * self.sine::<T>(turn, rest);
        let sum = x + y;
        let (s, t) = (x / sum, y / sum);
        // Along side 0, the point whose triangle with side 2 has the part `turn` of the area.
        let square = self.near + (1.0 - self.near) * (s * s);
        let ratio = self.sin / sum;
        // 1 + cos of the arc from the apex to it, and of the direction 1 - cos and 1 + cos.
        let up = self.rise * (ratio * ratio) / square;
        let down = out * (2.0 - up);
        let back = 2.0 * (1.0 - out) + out * up;
        let far = sqrt(out * (back / up));
        let lever = up * (far + out + f32::MIN_POSITIVE);
        let apex = (1.0 - out) / (1.0 + far) * (1.0 + down * (far + (2.0 - out)) / lever);
        let far = far / square;
        [apex, far * s, far * (t * (s + t * self.near))]
    }

    /// The sum of the corners times their weights, of length 1 but for rounding.
    #[inline]
    pub(super) fn direction(&self, weights: [f32; 3]) -> [f32; 3] {
        let sum = combined(self.corners, weights);
        let scale = 1.5 - 0.5 * dot(sum, sum);
        sum.map(|x| x * scale)
    }

    /// The barycentric coordinates of the place that a direction of these weights meets.
    #[inline]
    pub(super) fn barycentric(&self, [p, q, r]: [f32; 3]) -> [f32; 3] {
        let [d, e, f] = self.distances;
        let (p, q, r) = (p / d, q / e, r / f);
        let sum = p + q + r;
        [p / sum, q / sum, r / sum]
    }

    /// The direction of a place on the triangle, and `distance³/volume`, which is its density per steradian for a
    /// density of 1 per twice the area.
    #[inline]
    pub(super) fn towards(&self, [p, q, r]: [f32; 3]) -> ([f32; 3], f32) {
        let [d, e, f] = self.distances;
        let (place, distance) = unit(combined(self.corners, [p * d, q * e, r * f]));
        (place, self.spread(distance))
    }

    #[inline]
    fn spread(&self, distance: f32) -> f32 {
        let [d, e, f] = self.distances;
        (distance / d) * (distance / e) * (distance / f) / self.volume
    }

    /// The weights of a direction, up to a common factor; one that is outside has some of 0.
    #[inline]
    fn weights_of(&self, direction: [f32; 3]) -> [f32; 3] {
        let ([a, b, c], [s, t, u]) = (self.normals, self.sines);
        let off = self.off(direction);
        let positive = |x: f32| if x > 0.0 { x } else { 0.0 };
        let (p, q, r) = (
            positive(dot(direction, a) * s),
            positive(dot(off, b) * t),
            positive(dot(off, c) * u),
        );
        if p > 0.0 || q > 0.0 || r > 0.0 {
            [p, q, r]
        } else {
            [1.0; 3]
        }
    }

    /// A direction from that of the apex: on sides 1 and 2 both, so that the heights over them do not cancel beside it.
    #[inline]
    fn off(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let [[a, b, c], ..] = self.corners;
        [x - a, y - b, z - c]
    }

    /// The barycentric coordinates of where a direction meets the plane, and `distance³/volume`.
    #[inline]
    pub(super) fn place(&self, direction: [f32; 3]) -> ([f32; 3], f32) {
        let [p, q, r] = self.weights_of(direction);
        let [d, e, f] = self.distances;
        let distance = self.volume / (p / d + q / e + r / f);
        (self.barycentric([p, q, r]), self.spread(distance))
    }

    /// The height of a direction over side 1, which leads from corner 2 to the apex.
    #[inline]
    pub(super) fn over_side_1(&self, direction: [f32; 3]) -> f32 {
        let [_, normal, _] = self.normals;
        dot(self.off(direction), normal)
    }

    /// Whether a direction is inside, but for the rounding of samples.
    #[inline]
    pub(super) fn holds(&self, direction: [f32; 3]) -> bool {
        let [x, y, z] = self.normals.map(|normal| dot(direction, normal));
        let rim = self.rim;
        let ahead = x > rim || y > rim || z > rim || dot(direction, self.middle) > -RIM;
        let ahead = ahead || self.half > 0.25;
        is_direction(direction) && x >= -rim && y >= -rim && z >= -rim && ahead
    }

    /// The uniforms of a direction: `out` and `turn`.
    #[inline]
    pub(super) fn uniforms<T: Tier>(&self, direction: [f32; 3]) -> [f32; 2] {
        let [p, q, r] = self.weights_of(direction);
        let sum = p + q + r;
        let [p, q, r] = [p / sum, q / sum, r / sum];
        let apart = q - r;
        let cross = 4.0 * q * r * self.near;
        let far = sqrt(apart * apart + cross);
        // The smaller of q - r ± far by the product of both.
        let (s, t) = if apart < 0.0 {
            (cross / (far - apart), 2.0 * r)
        } else {
            (apart + far, 2.0 * r)
        };
        let whole = s + t;
        let (s, t) = (s / whole, t / whole);
        let (y, x) = (t * self.sin, self.slope * s + t * self.cos);
        let turn = T::atan2_turns(y, x) / self.half;
        let square = self.near + (1.0 - self.near) * (s * s);
        let up = self.rise * (y * y + x * x) / (self.slope * self.slope * square);
        let down = 2.0 - up;
        let length = sqrt((far - p) * (far - p) + 2.0 * (far * p) * up);
        let (far, cos) = (far / length, (p + far * (up - 1.0)) / length);
        let out = if cos > 0.0 {
            far * far * up / (1.0 + cos)
        } else {
            (1.0 - cos) / down
        };
        [out, turn]
    }
}

/// The cosines of three directions to a normal of any length, 0 below the horizon.
pub(super) fn cosines(directions: [[f32; 3]; 3], normal: [f32; 3]) -> Result<[f32; 3], Error> {
    let normal = normalised(normal)?;
    Ok(directions.map(|direction| {
        let cos = dot(direction, normal);
        if cos > 0.0 { cos } else { 0.0 }
    }))
}
