//! Polygons seen from a point: what the warps over spherical triangles and rectangles share.
//!
//! A corner is a direction. Half a light is a triangle of corners a (the apex, at the first uniform 0), b (where the second
//! one is 0) and c. Everything is said in terms of weights: a direction is the sum of the corners times their weights.

use super::direction::{is_direction, normalised};
use crate::error::{Error, finite};
use crate::num::double_word::{self, DoubleWord, determinant};
use crate::num::two_sum;
use crate::num::vector::{cross, dot, minus, plus, span, times};
use crate::tier::{Tier, sqrt};

/// 2⁶³ and 2⁻⁶⁰: the largest and the smallest size of a light and its distance together, as the sum of the magnitudes of all
/// coordinates. Edges and distances of 2⁶⁰ have less.
const LONG: f32 = 9_223_372_036_854_775_808.0;
const SHORT: f32 = 8.0 / LONG;

/// 2⁴⁰ and 2⁻¹⁶: between these products of three lengths neither overflow nor lose their digits.
const LARGE: f32 = 1_099_511_627_776.0;
const SMALL: f32 = 1.525_878_9e-5;

/// 2²⁰ and 2⁻¹⁰: where the size of a light and its distance together lie between these, products of three lengths neither
/// overflow, nor do those of two such products.
const FAR: f32 = 1_048_576.0;
const NEAR: f32 = 1.0 / 1024.0;

/// 2⁻⁶⁰: where a volume or the product of two halves is as large, no part of it that counts has lost its digits.
const FULL: f32 = 8.673_617_4e-19;

/// How many times the volume of a way and two edges may be smaller than their cross product, and that smaller than the product
/// of the edges, before lost digits show; and how many times as far as another the first corner may be.
pub(super) const EDGE_ON: f32 = 4.0;
pub(super) const SHARP: f32 = 4.0;
pub(super) const UNEVEN: f32 = 8.0;

/// 2⁻²⁸, the smallest volume of a point and a flat light beside the product of the lengths.
const FLATTEST: f32 = 3.725_290_3e-9;

/// 2⁻⁶², the smallest volume of unit vectors: about 1e-19 sr.
const LEAST: f32 = 2.168_404_3e-19;

/// 2⁻³⁰, the smallest distance of a corner beside the size of a light and its distance together: nearer to it, the point lies
/// on the light.
const ON_CORNER: f32 = 9.313_226e-10;

/// 2⁻²¹, the smallest 1 + cos of a side: nearer to it, the point lies on the light.
const ON_SIDE: f32 = 4.0 * f32::EPSILON;

/// 2⁻¹⁰, what half the solid angle lacks of half a turn at least, in radians: nearer to it, the point lies on the light.
const ON: f32 = 9.765_625e-4;

/// 2⁻¹²: a light is thin where the volume of its unit corners is smaller, and its solid angle below that of an eighth of all
/// directions.
const THIN: f32 = 2.441_406_2e-4;

/// 2⁻⁷⁴: the square of a shorter edge is 0.
const SHORTEST: f32 = 5.293_956e-23;

/// How far rounding can carry a sample over a side, as an angle, beside half of the longest side. A proof, in units of 2⁻²⁴:
/// the corners of a rectangle are off by 10 where they are four times as near as its first one, and by 1 for their own
/// rounding; so is the side's other end, from which the plane of the side is taken, 22 together. Three more are of the sum
/// of the corners times their weights. The weights at a side sum up to 1 over the cosine of half of it. Differences, products
/// and sums of the test add 14.
const RIM: f32 = 39.0 * 0.5 * f32::EPSILON;

/// The smaller number; comparisons joined by `or` would draw all they depend on into vectors of two, which are slower here.
#[inline]
pub(super) fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Whether lengths of this sum need no other unit.
#[inline]
pub(super) fn is_plain(size: f32) -> bool {
    (SMALL..=LARGE).contains(&size)
}

/// A power of two by which lengths of this sum become plain. The vectors are parameters in their order, and from the one of the
/// last place on parts of that.
#[cold]
#[inline(never)]
pub(super) fn unit(size: f32, vectors: [[f32; 3]; 4], last: usize) -> Result<f32, Error> {
    for (vector, place) in vectors.into_iter().zip(0_usize..) {
        for x in vector {
            finite(x, place.min(last))?;
        }
    }
    let all = if last > 1 { Error::NO_PLACE } else { last };
    if size < SHORT {
        Err(Error::Empty(all))
    } else if size < SMALL {
        Ok(17_592_186_044_416.0)
    } else if size <= LONG {
        Ok(LARGE / LONG)
    } else {
        Err(Error::TooLarge(all))
    }
}

/// The same for a rectangle, of which an edge may have no length.
#[cold]
#[inline(never)]
pub(super) fn rectangle_unit(
    size: f32,
    point: [f32; 3],
    corner: [f32; 3],
    [first, second]: [[f32; 3]; 2],
) -> Result<f32, Error> {
    match unit(size, [point, corner, first, second], 2) {
        Err(Error::Empty(_)) if span(first) == 0.0 || span(second) == 0.0 => {
            Err(Error::ZeroLength(2))
        }
        unit => unit,
    }
}

/// The way from a point to another in twice the digits, in units of a power of two.
fn way(from: [f32; 3], to: [f32; 3], unit: f32) -> [DoubleWord; 3] {
    let ([a, b, c], [d, e, f]) = (to, from);
    [two_sum(a, -d), two_sum(b, -e), two_sum(c, -f)].map(|(x, rest)| (x * unit, rest * unit))
}

/// The volume of a way and two edges in twice the digits, and its sign; 0 where even those are lost.
fn spanned(way: [DoubleWord; 3], first: [DoubleWord; 3], second: [DoubleWord; 3]) -> f32 {
    let ([a, b, c], [d, e, f]) = (first, second);
    let [x, y, z] = way;
    let parts = [
        double_word::times(x, determinant(b, f, c, e)),
        double_word::times(y, determinant(c, d, a, f)),
        double_word::times(z, determinant(a, e, b, d)),
    ];
    let [p, q, r] = parts;
    let (volume, rest) = double_word::plus(double_word::plus(p, q), r);
    let volume = volume + rest;
    let rounded = |v: [DoubleWord; 3]| v.map(|(x, _)| x);
    let [way, first, second] = [way, first, second].map(rounded);
    let [far, long, wide] = [way, first, second].map(|v| sqrt(dot(v, v)));
    let long = if long > wide { long } else { wide };
    if volume.abs() < FLATTEST * far * long * long {
        0.0
    } else {
        volume
    }
}

/// The volume of a point and a triangle in twice the digits, in units of a cube.
#[cold]
#[inline(never)]
pub(super) fn triangle_volume(point: [f32; 3], [a, b, c]: [[f32; 3]; 3], unit: f32) -> f32 {
    spanned(way(point, a, unit), way(a, b, unit), way(a, c, unit))
}

/// The same of a parallelogram.
#[cold]
#[inline(never)]
pub(super) fn rectangle_volume(
    point: [f32; 3],
    corner: [f32; 3],
    [first, second]: [[f32; 3]; 2],
    unit: f32,
) -> f32 {
    let way = way(point, corner, unit);
    spanned(way, first.map(|x| (x, 0.0)), second.map(|x| (x, 0.0)))
}

/// The ways to the other corners of a parallelogram, for a point far nearer to one of those than to the first one.
#[cold]
#[inline(never)]
pub(super) fn other_corners(
    point: [f32; 3],
    corner: [f32; 3],
    [first, second]: [[f32; 3]; 2],
    unit: f32,
) -> [[f32; 3]; 3] {
    let way = way(point, corner, unit);
    let [first, second] = [first, second].map(|edge| edge.map(|x| (x, 0.0)));
    let add = |p: [DoubleWord; 3], q: [DoubleWord; 3]| {
        let ([a, b, c], [d, e, f]) = (p, q);
        [
            double_word::plus(a, d),
            double_word::plus(b, e),
            double_word::plus(c, f),
        ]
    };
    let (x, y) = (add(way, first), add(way, second));
    [x, add(x, second), y].map(|way| way.map(|(x, rest)| x + rest))
}

/// Whether a light of this volume and half solid angle is not thin.
#[inline]
pub(super) fn is_wide(volume: f32, half: f32) -> bool {
    volume > THIN || half > 0.125
}

/// Why a light is none, the cosine of half the solid angle being of any length: a flat or a small one, or one on which
/// the point lies. With the place of a reason that lies in all parameters.
#[cold]
#[inline(never)]
pub(super) fn refusal(cosine: f32, nearest: f32, size: f32, all: usize) -> Error {
    // Beside a side there is no cosine.
    if cosine > 0.0 && nearest >= ON_CORNER * size {
        Error::Empty(all)
    } else {
        Error::NotNormalizable(all)
    }
}

/// Whether a half solid angle, as sine and cosine of any length, can be sampled, and the nearest corner beside the size is no
/// point of the light. Not a number cannot.
#[inline]
pub(super) fn is_seen(sine: f32, cosine: f32, nearest: f32, size: f32) -> bool {
    sine >= LEAST && sine > -cosine * ON && nearest >= ON_CORNER * size
}

/// Whether the ways to the corners give the density without their directions: those of a light that [`is_seen`] without doubt, in
/// plain units. The half solid angle is a sine and a cosine times `whole`, a product of distances; not a number cannot.
#[inline]
pub(super) fn is_simple([sine, cosine, whole]: [f32; 3], nearest: f32, size: f32) -> bool {
    (NEAR..=FAR).contains(&size)
        && sine >= FULL
        && sine >= 4.0 * LEAST * whole
        && sine > -cosine * (2.0 * ON)
        && nearest >= 2.0 * ON_CORNER * size
}

/// What [`sums`] gives first, times the distances of the corners, from the ways to those; and the least 1/2 + cosine of a side, times
/// the distances of its ends: below 0 where a side is longer than a third of a turn.
#[inline]
pub(super) fn long_sum([a, b, c]: [[f32; 3]; 3], [p, q, r]: [f32; 3]) -> [f32; 2] {
    let (pq, qr, rp) = (dot(a, b), dot(b, c), dot(c, a));
    let (x, y, z) = (p * q, q * r, r * p);
    let sum = (x + pq) * r + (qr * p + rp * q);
    let rise = least(pq + 0.5 * x, least(qr + 0.5 * y, rp + 0.5 * z));
    [sum, rise]
}

/// 1 + the cosines of the sides of a triangle of corners a, b and c, whose angle with the volume is half the solid angle;
/// 1 + cos of the side a-b, and half of that of the side b-c.
#[inline]
pub(super) fn sums(a: [f32; 3], b: [f32; 3], c: [f32; 3], [ab, bc, ca]: [f32; 3]) -> [f32; 3] {
    if least(ab, least(bc, ca)) < -0.5 {
        careful([a, b, c], [ab, bc, ca])
    } else {
        [(1.0 + ca) + (ab + bc), 1.0 + ab, 0.5 + 0.5 * bc]
    }
}

/// The same where a side is longer than a third of a turn: by the sines of long sides and the chord of the shortest.
#[cold]
#[inline(never)]
fn careful([a, b, c]: [[f32; 3]; 3], [ab, bc, ca]: [f32; 3]) -> [f32; 3] {
    let rise = |p: [f32; 3], q: [f32; 3], cos: f32| {
        if cos < -0.5 {
            let sine = cross(p, q);
            dot(sine, sine) / (1.0 - cos)
        } else {
            1.0 + cos
        }
    };
    let drop = |p: [f32; 3], q: [f32; 3], cos: f32| {
        if cos > 0.5 {
            let chord = minus(p, q);
            0.5 * dot(chord, chord)
        } else {
            1.0 - cos
        }
    };
    let (p, q, r) = (rise(a, b, ab), rise(b, c, bc), rise(c, a, ca));
    let sum = if ab >= bc && ab >= ca {
        (q + r) - drop(a, b, ab)
    } else if bc >= ca {
        (r + p) - drop(b, c, bc)
    } else {
        (p + q) - drop(c, a, ca)
    };
    let apart = p >= ON_SIDE && q >= ON_SIDE && r >= ON_SIDE;
    [if apart { sum } else { f32::NAN }, p, 0.5 * q]
}

/// A triangle of corners a, b and c, in what its map needs.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Half {
    /// The volume of the three corners, and 1 + the cosines of its sides: R sin H and R cos H, H being half its solid angle.
    pub(super) volume: f32,
    pub(super) sum: f32,
    /// 1 + cos of the side a-b, and (1 + cos)/2 of b-c.
    pub(super) rise: f32,
    pub(super) near: f32,
}

impl Half {
    /// The weights of the corners for uniform directions: `out` from the apex, and the sine and the cosine of half the solid
    /// angle from the side a-b, both times a number of this square.
    #[inline]
    pub(super) fn weights(&self, out: f32, sine: f32, cosine: f32, square: f32) -> [f32; 3] {
        let Self {
            volume,
            sum,
            rise,
            near,
        } = *self;
        let sine = if sine > 0.0 { sine } else { 0.0 } / volume;
        // Along the side b-c, the point whose triangle with a and b has that angle is at x b + y c over their sum.
        let x = cosine - sum * sine;
        let x = if x > 1.0e-18 { x } else { 1.0e-18 };
        let y = 2.0 * rise * sine;
        let whole = x + y;
        let part = near * (whole * whole) + (1.0 - near) * (x * x);
        // 1 + cos of the arc from the apex to it.
        let inverse = 1.0 / part;
        let up = rise * square * inverse;
        let up = if up < 2.0 { up } else { 2.0 };
        let down = out * (2.0 - up);
        let far = sqrt(out * (2.0 - down) / up);
        let apex = (1.0 - down) + far * (1.0 - up);
        let apex = if apex > 0.0 { apex } else { 0.0 };
        let far = far * inverse;
        [apex, far * x * whole, far * y * (x + y * near)]
    }

    /// The uniforms of the direction of these weights: `out`, and half the solid angle from the side a-b in turns.
    #[inline]
    pub(super) fn uniforms<T: Tier>(&self, weights: [f32; 3]) -> [f32; 2] {
        let Self {
            volume,
            sum,
            rise,
            near,
        } = *self;
        let [p, q, r] = weights.map(|x| if x > 0.0 { x } else { 0.0 });
        let total = p + q + r;
        let [p, q, r] = if total > 0.0 {
            [p / total, q / total, r / total]
        } else {
            [1.0 / 3.0; 3]
        };
        let apart = q - r;
        let product = 4.0 * q * r * near;
        let far = sqrt(apart * apart + product);
        // The smaller of q - r ± far by the product of both.
        let (s, t) = if apart < 0.0 {
            (product / (far - apart), 2.0 * r)
        } else {
            (apart + far, 2.0 * r)
        };
        let whole = s + t;
        // At the apex itself the arc along a-b is as good as any.
        let (s, t) = if whole > 0.0 {
            (s / whole, t / whole)
        } else {
            (1.0, 0.0)
        };
        let (y, x) = (t * volume, 2.0 * rise * s + t * sum);
        let angle = T::atan2_turns(y, x);
        let part = near + (1.0 - near) * (s * s);
        let up = (x * x + y * y) / (4.0 * rise * part);
        let up = if up < 2.0 { up } else { 2.0 };
        let down = 2.0 - up;
        let length = sqrt((far - p) * (far - p) + 2.0 * (far * p) * up);
        let (far, cos) = (far / length, (p + far * (up - 1.0)) / length);
        let out = if cos > 0.0 {
            far * far * up / (1.0 + cos)
        } else {
            (1.0 - cos) / down
        };
        [out, angle]
    }
}

/// The direction of the sum of three corners times their weights.
#[inline]
pub(super) fn direction(corners: [[f32; 3]; 3], weights: [f32; 3]) -> [f32; 3] {
    direction_and_length(corners, weights).0
}

/// The same, and the length of the sum.
#[inline]
pub(super) fn direction_and_length(
    [[a, b, c], [d, e, f], [g, h, i]]: [[f32; 3]; 3],
    [p, q, r]: [f32; 3],
) -> ([f32; 3], f32) {
    let sum = [
        p * a + (q * d + r * g),
        p * b + (q * e + r * h),
        p * c + (q * f + r * i),
    ];
    let square = dot(sum, sum);
    // The weights give the length 1, but for a point close to the light.
    let scale = if (square - 1.0).abs() < 2.0e-4 {
        1.5 - 0.5 * square
    } else {
        1.0 / sqrt(square)
    };
    (times(sum, scale), square * scale)
}

/// The height of a direction over the side that leads along an edge from a corner, times the length of the edge. Measured
/// from the corner, it does not cancel in small lights.
#[inline]
pub(super) fn height(direction: [f32; 3], corner: [f32; 3], edge: [f32; 3]) -> f32 {
    dot(minus(direction, corner), cross(corner, edge))
}

/// The corner of a side from which a direction is measured: where rounding shows least. The edge and the way to a far corner are
/// of about one direction where the other is near, and leave few digits of their product; beside the far corner they suffice.
#[inline]
pub(super) fn end(direction: [f32; 3], [p, q]: [[f32; 3]; 2], [i, j]: [f32; 2]) -> ([f32; 3], f32) {
    if off(direction, p) * j * j > off(direction, q) * i * i {
        (q, j)
    } else {
        (p, i)
    }
}

/// The square of the distance of two directions.
#[inline]
pub(super) fn off(direction: [f32; 3], corner: [f32; 3]) -> f32 {
    let way = minus(direction, corner);
    dot(way, way)
}

/// Whether a direction is inside of the light with these corners and the edges from each to the next, but for the rounding
/// of samples. `sign` is that of the volume; a `wide` light is one that is not thin.
pub(super) fn holds<const N: usize>(
    direction: [f32; 3],
    corners: [[f32; 3]; N],
    edges: [[f32; 3]; N],
    [first, second]: [[f32; 3]; 2],
    sign: f32,
    wide: bool,
) -> bool {
    // The sum of the corners that are farthest apart.
    let (mut middle, mut least) = ([0.0; 3], 8.0);
    for (k, p) in corners.iter().enumerate() {
        for q in corners.iter().take(k) {
            let sum = plus(*p, *q);
            let square = dot(sum, sum);
            if square < least {
                (middle, least) = (sum, square);
            }
        }
    }
    let rim = RIM / (0.5 * sqrt(least));
    let mut inside = is_direction(direction);
    for (corner, edge) in corners.iter().zip(edges) {
        let slack = rim * (sqrt(dot(edge, edge)) + SHORTEST);
        inside &= sign * height(direction, *corner, edge) >= -slack;
    }
    // Directions opposite to a thin light are beyond its sides by no more than rounding, too. Where they are in its plane, only
    // its middle tells them.
    let ahead = sign * dot(direction, cross(first, second));
    let size = span(first) * span(second);
    let before = wide || dot(direction, middle) > -RIM;
    inside && (ahead > 4.0 * f32::EPSILON * size || (ahead >= -rim * size && before))
}

/// A direction that rounding has carried over a side of the light is moved back at right angles to it. Along a thin light it
/// keeps its place so.
pub(super) fn carried_back<const N: usize>(
    direction: [f32; 3],
    corners: [[f32; 3]; N],
    inverses: [f32; N],
    edges: [[f32; 3]; N],
    sign: f32,
) -> [f32; 3] {
    let (mut back, mut most) = (direction, 0.0);
    let others = corners
        .iter()
        .cycle()
        .skip(1)
        .zip(inverses.iter().cycle().skip(1));
    let firsts = corners.iter().zip(inverses);
    for (((p, i), (q, j)), edge) in firsts.zip(others).zip(edges) {
        let (corner, _) = end(direction, [*p, *q], [i, *j]);
        let normal = cross(corner, edge);
        let height = dot(minus(direction, corner), normal);
        let part = height / dot(normal, normal);
        // The square of a side may have been too small, and the quotient infinite.
        if sign * height < 0.0 && part * height > most && part.abs() < f32::MAX {
            most = part * height;
            back = minus(direction, times(normal, part));
        }
    }
    back
}

/// The cosines of directions to a normal of any length, 0 below the horizon.
pub(super) fn cosines<const N: usize>(
    directions: [[f32; 3]; N],
    normal: [f32; 3],
) -> Result<[f32; N], Error> {
    let normal = normalised(normal, 0)?;
    Ok(directions.map(|direction| {
        let cos = dot(direction, normal);
        if cos > 0.0 { cos } else { 0.0 }
    }))
}
