//! Sides of spherical triangles, and sums of vectors.

use super::exact::Exact;
use crate::tier::sqrt;

/// 1 + cos of a side, below which the point is near to it.
pub(super) const NEAR: f32 = 0.125;

#[inline]
pub(super) fn dot(p: [f32; 3], q: [f32; 3]) -> f32 {
    let ([a, b, c], [d, e, f]) = (p, q);
    a * d + b * e + c * f
}

/// The sum of three vectors times their weights.
#[inline]
pub(super) fn combined(
    [[a, b, c], [d, e, f], [g, h, i]]: [[f32; 3]; 3],
    [p, q, r]: [f32; 3],
) -> [f32; 3] {
    [
        p * a + (q * d + r * g),
        p * b + (q * e + r * h),
        p * c + (q * f + r * i),
    ]
}

/// The unit vector and the length of a vector, rounded, times 1 or −1.
pub(super) fn rounded_unit(&[(x, _), (y, _), (z, _)]: &Exact, sign: f32) -> ([f32; 3], f32) {
    unit([x * sign, y * sign, z * sign])
}

/// The unit vector and the length.
pub(super) fn unit(p: [f32; 3]) -> ([f32; 3], f32) {
    let length = sqrt(dot(p, p));
    (p.map(|x| x / length), length)
}

/// A side of the spherical triangle.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub(super) from: [f32; 3],
    pub(super) to: [f32; 3],
    pub(super) edge: [f32; 3],
    /// The sines of the angles between the edge and the ways to its ends.
    pub(super) ends: [f32; 2],
    pub(super) sine: f32,
    /// 1 + cos and 1 − cos, the smaller one by the sine.
    pub(super) rise: f32,
    pub(super) drop: f32,
}

impl Side {
    /// The side between two directions of known distances, of an edge in units of `scale`; and the length of the product
    /// of edge and way.
    pub(super) fn new(
        [from, to]: [[f32; 3]; 2],
        [d, e]: [f32; 2],
        product: f32,
        edge: &Exact,
        scale: f32,
    ) -> Self {
        let (edge, length) = rounded_unit(edge, 1.0);
        let (sine, cos) = (scale * (product / (d * e)), dot(from, to));
        let square = sine * sine;
        let (rise, drop) = if cos < 0.0 {
            (square / (1.0 - cos), 1.0 - cos)
        } else {
            (1.0 + cos, square / (1.0 + cos))
        };
        Self {
            from,
            to,
            edge,
            ends: [product / (d * length), product / (e * length)],
            sine,
            rise,
            drop,
        }
    }

    /// The sum of the directions of both ends, which cancel where the point is near: by the way to the foot, at right
    /// angles to the edge.
    pub(super) fn middle(&self, normal: [f32; 3]) -> [f32; 3] {
        if self.rise < NEAR {
            let ([a, b, c], [d, e, f]) = (self.edge, normal);
            let foot = [b * f - c * e, c * d - a * f, a * e - b * d];
            let [p, q] = self.ends;
            let cos = |sine: f32| sqrt((1.0 - sine) * (1.0 + sine));
            let along = (p - q) * (p + q) / (cos(p) + cos(q));
            combined([foot, self.edge, [0.0; 3]], [p + q, along, 0.0])
        } else {
            combined([self.from, self.to, [0.0; 3]], [1.0, 1.0, 0.0])
        }
    }
}
