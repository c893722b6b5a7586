//! The samplers of the path tracer by the formulas of textbooks: the same maps as those of the crate, from the same uniforms.

use crate::truth::{Point, cross, dot};
use std::f64::consts::{PI, TAU};

pub(super) fn mix(p: Point, s: f64, q: Point, t: f64) -> Point {
    std::array::from_fn(|k| s * p[k] + t * q[k])
}

pub(super) fn plus(p: Point, q: Point) -> Point {
    mix(p, 1.0, q, 1.0)
}

pub(super) fn minus(p: Point, q: Point) -> Point {
    mix(p, 1.0, q, -1.0)
}

pub(super) fn scaled(p: Point, by: f64) -> Point {
    p.map(|x| x * by)
}

pub(super) fn length(p: Point) -> f64 {
    dot(p, p).sqrt()
}

pub(super) fn unit(p: Point) -> Point {
    scaled(p, 1.0 / length(p))
}

/// The uniform of a word: one of 24 bits.
pub(super) fn grid(word: u32) -> f64 {
    f64::from(word >> 8) / f64::from(1 << 24)
}

/// The uniform of a word where the domain is open: the middle of its cell.
pub(super) fn middle(word: u32) -> f64 {
    if word < 1 << 23 {
        (f64::from(word) + 0.5) / f64::from(1 << 16).powi(2)
    } else {
        (f64::from(word >> 9) + 0.5) / f64::from(1 << 23)
    }
}

/// Axes whose third one is a unit vector: those of Duff and others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes([Point; 3]);

impl Axes {
    pub fn about(normal: Point) -> Self {
        let [x, y, z] = unit(normal);
        let sign = 1.0_f64.copysign(z);
        let a = -1.0 / (sign + z);
        let tangent = [1.0 + sign * x * x * a, sign * x * y * a, -sign * x];
        let bitangent = [x * y * a, sign + y * y * a, -y];
        Self([tangent, bitangent, [x, y, z]])
    }

    pub fn to_world(self, [x, y, z]: Point) -> Point {
        let [t, b, n] = self.0;
        plus(mix(t, x, b, y), scaled(n, z))
    }

    pub fn to_local(self, p: Point) -> Point {
        self.0.map(|axis| dot(axis, p))
    }
}

/// A direction by the cosine to +z and the azimuth in turns.
fn around(cosine: f64, turns: f64) -> Point {
    let flat = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (sin, cos) = (TAU * turns).sin_cos();
    [flat * cos, flat * sin, cosine]
}

/// A place in a pixel.
pub(super) fn tent(u: f64) -> f64 {
    if u < 0.5 {
        (2.0 * u).sqrt() - 1.0
    } else {
        1.0 - (2.0 * (1.0 - u)).sqrt()
    }
}

/// A place on a polygon: a triangle about the middle, whose side the second uniform goes along.
pub(super) fn polygon(corners: u16, [u, v]: [f64; 2]) -> [f64; 2] {
    let place = v * f64::from(corners);
    let corner = |k: f64| (TAU * k / f64::from(corners)).sin_cos();
    let ((y, x), (far_y, far_x)) = (corner(place.floor()), corner(place.floor() + 1.0));
    let (out, along) = (u.sqrt(), place.fract());
    [x + along * (far_x - x), y + along * (far_y - y)].map(|c| out * c)
}

pub(super) fn lambert([u, v]: [f64; 2]) -> Point {
    around((1.0 - u).sqrt(), v)
}

/// A power of the cosine.
pub(super) fn phong(exponent: f64, [u, v]: [f64; 2]) -> Point {
    around((1.0 - u).powf(1.0 / (exponent + 1.0)), v)
}

pub(super) fn phong_pdf(exponent: f64, cosine: f64) -> f64 {
    (exponent + 1.0) / TAU * cosine.max(0.0).powf(exponent)
}

/// Henyey and Greenstein's law, as in textbooks but that it begins ahead.
pub(super) fn scatter(g: f64, [u, v]: [f64; 2]) -> Point {
    let s = (1.0 - g * g) / (1.0 + g - 2.0 * g * u);
    around((1.0 + g * g - s * s) / (2.0 * g), v)
}

pub(super) fn scatter_pdf(g: f64, cosine: f64) -> f64 {
    (1.0 - g * g) / (2.0 * TAU * (1.0 + g * g - 2.0 * g * cosine).powf(1.5))
}

/// A distance in fog up to an end, and the density of one.
pub(super) fn free(rate: f64, end: f64, u: f64) -> f64 {
    -(-u * (1.0 - (-rate * end).exp())).ln_1p() / rate
}

pub(super) fn free_pdf(rate: f64, end: f64, way: f64) -> f64 {
    rate * (-rate * way).exp() / (1.0 - (-rate * end).exp())
}

/// Distances by the angle in which a light beside the ray sees them.
pub(super) struct EquiAngular {
    foot: f64,
    beside: f64,
    angles: [f64; 2],
}

impl EquiAngular {
    pub fn new(origin: Point, direction: Point, light: Point, end: f64) -> Self {
        let to = minus(light, origin);
        let foot = dot(to, direction);
        let beside = length(mix(to, 1.0, direction, -foot));
        let angles = [0.0, end].map(|way| (way - foot).atan2(beside));
        Self {
            foot,
            beside,
            angles,
        }
    }

    pub fn sample(&self, u: f64) -> f64 {
        let [low, high] = self.angles;
        self.foot + self.beside * (low + u * (high - low)).tan()
    }

    pub fn pdf(&self, way: f64) -> f64 {
        let ([low, high], off) = (self.angles, way - self.foot);
        self.beside / ((high - low) * (self.beside * self.beside + off * off))
    }
}

/// A spherical triangle by Arvo's construction, with the apex from which the first uniform goes out.
/// <https://doi.org/10.1145/218380.218500>
struct Triangle {
    apex: Point,
    from: Point,
    to: Point,
    /// The angle at `from`.
    angle: f64,
    area: f64,
}

impl Triangle {
    fn new([apex, from, to]: [Point; 3]) -> Self {
        let at = |p: Point, q: Point, r: Point| {
            let (m, n) = (cross(p, q), cross(p, r));
            length(cross(m, n)).atan2(dot(m, n))
        };
        let angle = at(from, apex, to);
        let area = angle + at(apex, from, to) + at(to, apex, from) - PI;
        Self {
            apex,
            from,
            to,
            angle,
            area,
        }
    }

    fn sample(&self, out: f64, part: f64) -> Point {
        let along = |p: Point, q: Point, cosine: f64| {
            let beside = unit(mix(q, 1.0, p, -dot(p, q)));
            mix(p, cosine, beside, (1.0 - cosine * cosine).max(0.0).sqrt())
        };
        let (sin, cos) = self.angle.sin_cos();
        let (s, t) = (part * self.area - self.angle).sin_cos();
        let (u, v) = (t - cos, s + sin * dot(self.from, self.apex));
        let cosine = ((v * t - u * s) * cos - v) / ((v * s + u * t) * sin);
        let there = along(self.from, self.to, cosine.clamp(-1.0, 1.0));
        along(self.apex, there, 1.0 - out * (1.0 - dot(there, self.apex)))
    }
}

/// A parallelogram seen from a place: two triangles on both sides of the diagonal.
pub(super) struct Panel([Triangle; 2]);

impl Panel {
    /// None where it is seen from its edge.
    pub fn new(from: Point, corner: Point, [x, y]: [Point; 2]) -> Option<Self> {
        let corner = minus(corner, from);
        let corners = [
            corner,
            plus(corner, x),
            plus(corner, plus(x, y)),
            plus(corner, y),
        ];
        let [apex, right, far, left] = corners.map(unit);
        let both = [[apex, right, far], [apex, far, left]].map(Triangle::new);
        both.iter()
            .all(|half| half.area > 1e-12)
            .then_some(Self(both))
    }

    pub fn solid_angle(&self) -> f64 {
        self.0.iter().map(|half| half.area).sum()
    }

    pub fn sample(&self, [u, v]: [f64; 2]) -> Point {
        let [first, second] = &self.0;
        let due = v * self.solid_angle();
        if due < first.area {
            first.sample(u, due / first.area)
        } else {
            second.sample(u, (due - first.area) / second.area)
        }
    }
}

/// A ball seen from a place: the axis of its cone, and 1 less the cosine of half its angle.
pub(super) struct SeenBall {
    axis: Point,
    drop: f64,
}

impl SeenBall {
    pub fn new(from: Point, centre: Point, radius: f64) -> Self {
        let axis = minus(centre, from);
        let sine2 = radius * radius / dot(axis, axis);
        let drop = if sine2 > 1.0 {
            2.0
        } else {
            sine2 / (1.0 + (1.0 - sine2).sqrt())
        };
        Self { axis, drop }
    }

    pub fn solid_angle(&self) -> f64 {
        TAU * self.drop
    }

    pub fn sample(&self, [u, v]: [f64; 2]) -> Point {
        Axes::about(self.axis).to_world(around(1.0 - u * self.drop, v))
    }
}

/// A visible normal of GGX, by the spherical cap of Dupuy and Benyoub. <https://arxiv.org/abs/2306.05044>
pub(super) fn visible_normal([x, y, z]: Point, alpha: f64, [u, v]: [f64; 2]) -> Point {
    let view = unit([alpha * x, alpha * y, z]);
    let height = (1.0 - u) * (1.0 + view[2]) - view[2];
    let azimuth = view[1].atan2(view[0]) / TAU;
    let [a, b, c] = plus(around(height, v + azimuth), view);
    unit([alpha * a, alpha * b, c])
}

/// D of GGX.
pub(super) fn ggx([x, y, z]: Point, alpha: f64) -> f64 {
    let square = alpha * alpha;
    square / (PI * (x * x + y * y + square * z * z).powi(2))
}
