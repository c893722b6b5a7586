//! What a renderer writes by hand: the published maps of lamps, lobes and laws in plain `f32`, each with its density, as
//! pbrt-v4 has them.
//!
//! They are written anew from the formulas. Products are not fused, which favours them: fused ones without the
//! instruction are calls.
//!
//! Source: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition, 2023,
//! <https://pbr-book.org/4ed/contents>; the sources of single maps are beside them.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2, TAU};

pub type Vector = [f32; 3];

/// A direction, or a point of the plane or of the line, and its density.
pub type Weighed<P> = (P, f32);

const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

#[inline]
fn zip(a: Vector, b: Vector, f: impl Fn(f32, f32) -> f32) -> Vector {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}

#[inline]
fn plus(a: Vector, b: Vector) -> Vector {
    zip(a, b, |a, b| a + b)
}

#[inline]
fn minus(a: Vector, b: Vector) -> Vector {
    zip(a, b, |a, b| a - b)
}

#[inline]
fn times(s: f32, a: Vector) -> Vector {
    a.map(|x| s * x)
}

#[inline]
pub(super) fn dot(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline]
fn normalised(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

/// The root of what rounding may have taken below 0.
#[inline]
fn root(x: f32) -> f32 {
    x.max(0.0).sqrt()
}

#[inline]
pub(super) fn between(t: f32, a: f32, b: f32) -> f32 {
    (1.0 - t) * a + t * b
}

/// The angle between directions, by half angles.
#[inline]
fn angle(a: Vector, b: Vector) -> f32 {
    let half = |v: Vector| 2.0 * (0.5 * dot(v, v).sqrt()).min(1.0).asin();
    if dot(a, b) < 0.0 {
        PI - half(plus(a, b))
    } else {
        half(minus(b, a))
    }
}

/// Two directions that make a frame with this one.
///
/// Source: T. Duff et al., "Building an Orthonormal Basis, Revisited", Journal of Computer Graphics Techniques, 2017.
#[inline]
fn beside(n: Vector) -> [Vector; 2] {
    let [x, y, z] = n;
    let sign = 1.0_f32.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [
        [1.0 + sign * x * x * a, sign * b, -sign * x],
        [b, sign + y * y * a, -y],
    ]
}

#[inline]
fn in_frame(normal: Vector, [x, y, z]: Vector) -> Vector {
    let [s, t] = beside(normal);
    plus(plus(times(x, s), times(y, t)), times(z, normal))
}

#[inline]
fn around(sin: f32, cos: f32, u: f32) -> Vector {
    let (s, c) = (TAU * u).sin_cos();
    [sin * c, sin * s, cos]
}

/// A sphere seen from outside.
///
/// Source: P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", 1996.
#[inline]
pub fn sphere_lamp(
    point: Vector,
    centre: Vector,
    radius: f32,
    [u1, u2]: [f32; 2],
) -> Weighed<Vector> {
    let to_centre = minus(centre, point);
    let distance = dot(to_centre, to_centre).sqrt();
    let sin_most = radius / distance;
    let sin2_most = sin_most * sin_most;
    let cos_most = root(1.0 - sin2_most);
    let mut one_minus_cos = 1.0 - cos_most;
    let mut cos = (cos_most - 1.0) * u1 + 1.0;
    let mut sin2 = 1.0 - cos * cos;
    // Below 1.5 degrees.
    if sin2_most < 0.000_685_23 {
        sin2 = sin2_most * u1;
        cos = (1.0 - sin2).sqrt();
        one_minus_cos = sin2_most / 2.0;
    }
    let cos_alpha = sin2 / sin_most + cos * root(1.0 - sin2 / sin2_most);
    let local = around(root(1.0 - cos_alpha * cos_alpha), cos_alpha, u2);
    let normal = in_frame(normalised(to_centre), local.map(|x| -x));
    let place = plus(centre, times(radius, normal));
    (normalised(minus(place, point)), 1.0 / (TAU * one_minus_cos))
}

/// A triangle seen from a point.
///
/// Source: J. Arvo, "Stratified Sampling of Spherical Triangles", 1995, <https://doi.org/10.1145/218380.218500>.
#[inline]
pub fn triangle_lamp(point: Vector, vertices: [Vector; 3], [u1, u2]: [f32; 2]) -> Weighed<Vector> {
    let [a, b, c] = vertices.map(|v| normalised(minus(v, point)));
    let (ab, bc, ca) = (cross(a, b), cross(b, c), cross(c, a));
    if dot(ab, ab) == 0.0 || dot(bc, bc) == 0.0 || dot(ca, ca) == 0.0 {
        return (a, 0.0);
    }
    let [ab, bc, ca] = [ab, bc, ca].map(normalised);
    let negative = |v: Vector| v.map(|x| -x);
    let alpha = angle(ab, negative(ca));
    let sum = alpha + angle(bc, negative(ab)) + angle(ca, negative(bc));
    let part = between(u1, PI, sum);
    let area = sum - PI;
    let density = if area <= 0.0 { 0.0 } else { 1.0 / area };
    let (sin_alpha, cos_alpha) = alpha.sin_cos();
    let (sin_part, cos_part) = part.sin_cos();
    let sin_phi = sin_part * cos_alpha - cos_part * sin_alpha;
    let cos_phi = cos_part * cos_alpha + sin_part * sin_alpha;
    let k1 = cos_phi + cos_alpha;
    let k2 = sin_phi - sin_alpha * dot(a, b);
    let cos_b = (k2 + (k2 * cos_phi - k1 * sin_phi) * cos_alpha)
        / ((k2 * sin_phi + k1 * cos_phi) * sin_alpha);
    let cos_b = cos_b.clamp(-1.0, 1.0);
    let across = |v: Vector, w: Vector| normalised(minus(v, times(dot(v, w), w)));
    let c2 = plus(
        times(cos_b, a),
        times(root(1.0 - cos_b * cos_b), across(c, a)),
    );
    let cos = 1.0 - u2 * (1.0 - dot(c2, b));
    let direction = plus(times(cos, b), times(root(1.0 - cos * cos), across(c2, b)));
    (direction, density)
}

/// A rectangle seen from a point.
///
/// Source: C. Ureña, M. Fajardo and A. King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013,
/// <https://doi.org/10.1111/cgf.12151>.
#[inline]
pub fn rectangle_lamp(
    point: Vector,
    corner: Vector,
    [ex, ey]: [Vector; 2],
    [u1, u2]: [f32; 2],
) -> Weighed<Vector> {
    let (width, height) = (dot(ex, ex).sqrt(), dot(ey, ey).sqrt());
    let (x, y) = (times(1.0 / width, ex), times(1.0 / height, ey));
    let mut z = cross(x, y);
    let d = minus(corner, point);
    let (x0, y0, mut z0) = (dot(d, x), dot(d, y), dot(d, z));
    if z0 > 0.0 {
        z = z.map(|x| -x);
        z0 = -z0;
    }
    let (x1, y1) = (x0 + width, y0 + height);
    let corners = [[x0, y0, z0], [x1, y0, z0], [x1, y1, z0], [x0, y1, z0]];
    let side = |i: usize| normalised(cross(corners[i], corners[(i + 1) % 4]));
    let sides = [side(0), side(1), side(2), side(3)];
    let inner = |i: usize| angle(sides[i].map(|x| -x), sides[(i + 1) % 4]);
    let (g0, g1, g2, g3) = (inner(0), inner(1), inner(2), inner(3));
    let solid_angle = g0 + g1 + g2 + g3 - TAU;
    let place = if solid_angle < 1.0e-3 {
        plus(corner, plus(times(u1, ex), times(u2, ey)))
    } else {
        let (b0, b1) = (sides[0][2], sides[2][2]);
        let turn = u1 * (g0 + g1 - TAU) + (u1 - 1.0) * (g2 + g3);
        let (sin, cos) = turn.sin_cos();
        let f = (cos * b0 - b1) / sin;
        let c = (1.0 / (f * f + b0 * b0).sqrt()).copysign(f);
        let c = c.clamp(-BELOW_ONE, BELOW_ONE);
        let across = (-(c * z0) / root(1.0 - c * c)).clamp(x0, x1);
        let away = (across * across + z0 * z0).sqrt();
        let at = |y: f32| y / (away * away + y * y).sqrt();
        let (h0, h1) = (at(y0), at(y1));
        let h = h0 + u2 * (h1 - h0);
        let along = if h * h < 1.0 - 1.0e-6 {
            h * away / (1.0 - h * h).sqrt()
        } else {
            y1
        };
        plus(
            point,
            plus(plus(times(across, x), times(along, y)), times(z0, z)),
        )
    };
    (normalised(minus(place, point)), 1.0 / solid_angle)
}

/// A cone about the z axis.
#[inline]
pub fn cone(cos_most: f32, [u1, u2]: [f32; 2]) -> Weighed<Vector> {
    let cos = (1.0 - u1) + u1 * cos_most;
    let density = 1.0 / (TAU * (1.0 - cos_most));
    (around(root(1.0 - cos * cos), cos, u2), density)
}

/// Henyey and Greenstein's lobe about the z axis.
#[inline]
pub fn henyey_greenstein(g: f32, [u1, u2]: [f32; 2]) -> Weighed<Vector> {
    let cos = if g.abs() < 1.0e-3 {
        1.0 - 2.0 * u1
    } else {
        let part = (1.0 - g * g) / (1.0 + g - 2.0 * g * u1);
        (1.0 + g * g - part * part) / (2.0 * g)
    };
    let denominator = 1.0 + g * g - 2.0 * g * cos;
    let density = (1.0 - g * g) / (2.0 * TAU * denominator * root(denominator));
    (around(root(1.0 - cos * cos), cos, u2), density)
}

/// The normals of Trowbridge and Reitz that a view meets.
///
/// Source: E. Heitz, "Sampling the GGX Distribution of Visible Normals", 2018, <http://jcgt.org/published/0007/04/01>.
#[inline]
pub fn ggx_visible(view: Vector, alpha: [f32; 2], [u1, u2]: [f32; 2]) -> Weighed<Vector> {
    let [ax, ay] = alpha;
    let [wx, wy, wz] = view;
    let mut h = normalised([ax * wx, ay * wy, wz]);
    if h[2] < 0.0 {
        h = h.map(|x| -x);
    }
    let s = if h[2] < 0.999_99 {
        normalised(cross([0.0, 0.0, 1.0], h))
    } else {
        [1.0, 0.0, 0.0]
    };
    let t = cross(h, s);
    let (r, (sin, cos)) = (u1.sqrt(), (TAU * u2).sin_cos());
    let x = r * cos;
    let y = between((1.0 + h[2]) / 2.0, (1.0 - x * x).sqrt(), r * sin);
    let z = root(1.0 - x * x - y * y);
    let [nx, ny, nz] = plus(plus(times(x, s), times(y, t)), times(z, h));
    let m = normalised([ax * nx, ay * ny, nz.max(1.0e-6)]);
    // G1/cos times D times the cosine between.
    let cos2 = m[2] * m[2];
    let (ex, ey) = (m[0] / ax, m[1] / ay);
    let e = (ex * ex + ey * ey) / cos2;
    let d = 1.0 / (PI * ax * ay * cos2 * cos2 * (1.0 + e) * (1.0 + e));
    let tan2 = ((ax * wx) * (ax * wx) + (ay * wy) * (ay * wy)) / (wz * wz);
    let g1 = 1.0 / (1.0 + ((1.0 + tan2).sqrt() - 1.0) / 2.0);
    (m, g1 / wz.abs() * d * dot(view, m).abs())
}

/// Linear between two densities at the ends of [0, 1).
#[inline]
pub(super) fn linear(u: f32, a: f32, b: f32) -> f32 {
    if u == 0.0 && a == 0.0 {
        return 0.0;
    }
    (u * (a + b) / (a + between(u, a * a, b * b).sqrt())).min(BELOW_ONE)
}

/// Bilinear on the unit square.
#[inline]
pub fn bilinear(weights: [[f32; 2]; 2], [u1, u2]: [f32; 2]) -> Weighed<[f32; 2]> {
    let [[a, b], [c, d]] = weights;
    let y = linear(u2, a + b, c + d);
    let x = linear(u1, between(y, a, c), between(y, b, d));
    let value = between(y, between(x, a, b), between(x, c, d));
    ([x, y], 4.0 * value / (a + b + c + d))
}

/// The unit disk by concentric squares.
///
/// Source: P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", 1997.
#[inline]
pub fn concentric_disk([u1, u2]: [f32; 2]) -> Weighed<[f32; 2]> {
    let (x, y) = (2.0 * u1 - 1.0, 2.0 * u2 - 1.0);
    if x == 0.0 && y == 0.0 {
        return ([0.0, 0.0], 1.0 / PI);
    }
    let (r, theta) = if x.abs() > y.abs() {
        (x, FRAC_PI_4 * (y / x))
    } else {
        (y, FRAC_PI_2 - FRAC_PI_4 * (x / y))
    };
    let (s, c) = theta.sin_cos();
    ([r * c, r * s], 1.0 / PI)
}

/// In proportion to the cosine, by concentric squares.
#[inline]
pub fn cosine_hemisphere(u: [f32; 2]) -> Weighed<Vector> {
    let ([x, y], _) = concentric_disk(u);
    let z = root(1.0 - x * x - y * y);
    ([x, y, z], z / PI)
}

#[inline]
pub fn exponential(rate: f32, [u]: [f32; 1]) -> Weighed<f32> {
    let x = -(1.0 - u).ln() / rate;
    (x, rate * (-rate * x).exp())
}

#[inline]
pub fn logistic(scale: f32, [u]: [f32; 1]) -> Weighed<f32> {
    let x = -scale * (1.0 / u - 1.0).ln();
    let e = (-x.abs() / scale).exp();
    (x, e / (scale * (1.0 + e) * (1.0 + e)))
}

/// The normal distribution by the inverse of the error function.
///
/// Source of its coefficients: M. Giles, "Approximating the erfinv Function", GPU Computing Gems, 2012.
#[inline]
pub fn normal(mean: f32, deviation: f32, [u]: [f32; 1]) -> Weighed<f32> {
    const BULK: [f32; 9] = [
        2.810_226_4e-8,
        3.432_739_4e-7,
        -3.523_387_7e-6,
        -4.391_506_5e-6,
        0.000_218_580_87,
        -0.001_253_725,
        -0.004_177_681_6,
        0.246_640_73,
        1.501_409_4,
    ];
    const TAIL: [f32; 9] = [
        -0.000_200_214_26,
        0.000_100_950_56,
        0.001_349_343_2,
        -0.003_673_428_4,
        0.005_739_507_7,
        -0.007_622_461_3,
        0.009_438_870_5,
        1.001_674,
        2.832_976_8,
    ];
    let a = (2.0 * u - 1.0).clamp(-0.999_99, 0.999_99);
    let w = -((1.0 - a) * (1.0 + a)).ln();
    let (t, coefficients) = if w < 5.0 {
        (w - 2.5, BULK)
    } else {
        (w.sqrt() - 3.0, TAIL)
    };
    let inverse = a * coefficients.into_iter().fold(0.0, |sum, c| sum * t + c);
    let x = mean + SQRT_2 * deviation * inverse;
    let z = (x - mean) / deviation;
    let density = (-0.5 * z * z).exp() / (TAU.sqrt() * deviation);
    (x, density)
}
