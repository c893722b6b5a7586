//! Exact counterparts of the warps of the plane and of triangles in space.

use super::{Point, Truth, Uniforms, turn};
use std::f64::consts::{FRAC_1_PI, PI, TAU};

pub struct NormalPair {
    pub mean: [f64; 2],
    pub deviation: f64,
}

/// The largest coordinate of a normal pair, which lies up to 5.77 deviations from its mean.
pub fn normal_pair_size([x, y]: [f32; 2], deviation: f32) -> f64 {
    f64::from(x.abs().max(y.abs())) + 5.77 * f64::from(deviation)
}

impl Truth for NormalPair {
    fn sample(&self, u: Uniforms) -> Point {
        let r = self.deviation * (-2.0 * (-u[0]).ln_1p()).sqrt();
        let (s, c) = (TAU * u[1]).sin_cos();
        [self.mean[0] + r * c, self.mean[1] + r * s, 0.0]
    }
    fn pdf(&self, x: Point) -> f64 {
        let d2 = self.deviation * self.deviation;
        let r2 = (x[0] - self.mean[0]).powi(2) + (x[1] - self.mean[1]).powi(2);
        (-0.5 * r2 / d2).exp() / (TAU * d2)
    }
    fn invert(&self, x: Point) -> Uniforms {
        let d2 = self.deviation * self.deviation;
        let (x, y) = (x[0] - self.mean[0], x[1] - self.mean[1]);
        let u = -(-0.5 * (x * x + y * y) / d2).exp_m1();
        [u, turn(x, y), 0.0, 0.0]
    }
}

pub struct Disk;

impl Truth for Disk {
    fn sample(&self, u: Uniforms) -> Point {
        let (s, c) = (TAU * u[1]).sin_cos();
        [u[0].sqrt() * c, u[0].sqrt() * s, 0.0]
    }
    fn pdf(&self, _: Point) -> f64 {
        FRAC_1_PI
    }
    fn invert(&self, x: Point) -> Uniforms {
        [x[0] * x[0] + x[1] * x[1], turn(x[0], x[1]), 0.0, 0.0]
    }
}

pub struct DiskConcentric;

impl Truth for DiskConcentric {
    fn sample(&self, u: Uniforms) -> Point {
        let (a, b) = (2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0);
        let (r, angle) = if a == 0.0 && b == 0.0 {
            (0.0, 0.0)
        } else if a.abs() > b.abs() {
            (a, PI / 4.0 * b / a)
        } else {
            (b, PI / 2.0 - PI / 4.0 * a / b)
        };
        [r * angle.cos(), r * angle.sin(), 0.0]
    }
    fn pdf(&self, _: Point) -> f64 {
        FRAC_1_PI
    }
    fn invert(&self, x: Point) -> Uniforms {
        let (x, y) = (x[0], x[1]);
        let r = x.hypot(y);
        let (a, b) = if x.abs() > y.abs() {
            (r.copysign(x), r * 4.0 / PI * (y / x.abs()).atan())
        } else if y != 0.0 {
            (r * 4.0 / PI * (x / y.abs()).atan(), r.copysign(y))
        } else {
            (0.0, 0.0)
        };
        [0.5 + 0.5 * a, 0.5 + 0.5 * b, 0.0, 0.0]
    }
}

/// Barycentric coordinates [u, v, w].
pub struct Barycentric;

impl Truth for Barycentric {
    fn sample(&self, u: Uniforms) -> Point {
        let s = u[0].sqrt();
        [1.0 - s, s * u[1], s * (1.0 - u[1])]
    }
    fn pdf(&self, _: Point) -> f64 {
        2.0
    }
    fn invert(&self, x: Point) -> Uniforms {
        let s = x[1] + x[2];
        [s * s, if s > 0.0 { x[1] / s } else { 0.0 }, 0.0, 0.0]
    }
}

/// A triangle on three vertices; in the plane the third coordinates are 0.
///
/// Its area and barycentric coordinates are determinants that cancel as far as the triangle is flat, so
/// they are worked out in sums of two doubles.
pub struct OnTriangle(pub [Point; 3]);

impl OnTriangle {
    fn sides(&self) -> [[Double; 3]; 2] {
        let [a, b, c] = self.0;
        [b, c].map(|to| differences(to, a))
    }

    fn twice_area(&self) -> f64 {
        let [p, q] = self.sides();
        let normal = double_cross(p, q);
        double_dot(normal, normal).0.sqrt()
    }

    /// The height over the longest side.
    pub fn height(&self) -> f64 {
        let [a, b, c] = self.0;
        let length = |p, q| {
            let d = differences(p, q).map(|d| d.0);
            d[0].hypot(d[1]).hypot(d[2])
        };
        self.twice_area() / length(a, b).max(length(b, c)).max(length(c, a))
    }
}

impl Truth for OnTriangle {
    fn sample(&self, u: Uniforms) -> Point {
        let b = Barycentric.sample(u);
        std::array::from_fn(|k| (0..3).map(|i| b[i] * self.0[i][k]).sum())
    }
    fn pdf(&self, _: Point) -> f64 {
        2.0 / self.twice_area()
    }
    fn invert(&self, x: Point) -> Uniforms {
        let [p, q] = self.sides();
        let normal = double_cross(p, q);
        let whole = double_dot(normal, normal);
        let to = differences(x, self.0[0]);
        let v = double_dot(double_cross(to, q), normal);
        let w = double_dot(double_cross(p, to), normal);
        let u = plus(whole, minus(plus(v, w)));
        // A point that was rounded out of the triangle has the uniforms of one inside it.
        let [u, v, w] = [u, v, w].map(|part| (part.0 / whole.0).clamp(0.0, 1.0));
        let s = v + w;
        let first = if s < 0.5 { s * s } else { 1.0 - u * (2.0 - u) };
        [first, if s > 0.0 { v / s } else { 0.0 }, 0.0, 0.0]
    }
}

/// Uniform on a box of so many sides, each from its low to its high end.
pub struct Sides(pub Vec<[f64; 2]>);

impl Truth for Sides {
    fn sample(&self, u: Uniforms) -> Point {
        let mut point = [0.0; 3];
        for ((x, [low, high]), u) in point.iter_mut().zip(&self.0).zip(u) {
            *x = low + u * (high - low);
        }
        point
    }
    fn pdf(&self, _: Point) -> f64 {
        self.0
            .iter()
            .map(|[low, high]| 1.0 / (high - low))
            .product()
    }
    fn invert(&self, x: Point) -> Uniforms {
        let mut uniforms = [0.0; 4];
        for ((u, [low, high]), x) in uniforms.iter_mut().zip(&self.0).zip(x) {
            *u = (x - low) / (high - low);
        }
        uniforms
    }
}

/// A sum of two doubles that do not overlap.
type Double = (f64, f64);

fn exact_sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

fn plus(a: Double, b: Double) -> Double {
    let ((high, low), (more, rest)) = (exact_sum(a.0, b.0), exact_sum(a.1, b.1));
    let (high, low) = exact_sum(high, low + more);
    exact_sum(high, low + rest)
}

fn minus(a: Double) -> Double {
    (-a.0, -a.1)
}

fn times(a: Double, b: Double) -> Double {
    let product = a.0 * b.0;
    let dropped = a.0.mul_add(b.0, -product);
    exact_sum(product, dropped + (a.0 * b.1 + a.1 * b.0))
}

fn differences(p: Point, q: Point) -> [Double; 3] {
    std::array::from_fn(|k| exact_sum(p[k], -q[k]))
}

fn double_cross(p: [Double; 3], q: [Double; 3]) -> [Double; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| plus(times(p[i], q[j]), minus(times(p[j], q[i]))))
}

fn double_dot(p: [Double; 3], q: [Double; 3]) -> Double {
    plus(
        plus(times(p[0], q[0]), times(p[1], q[1])),
        times(p[2], q[2]),
    )
}

/// A marginal in x and a conditional in y given x.
pub struct Product<F> {
    pub marginal: Box<dyn Truth>,
    pub conditional: F,
}

impl<F: Fn(f64) -> Box<dyn Truth> + Send + Sync> Truth for Product<F> {
    fn sample(&self, u: Uniforms) -> Point {
        let x = self.marginal.sample(u)[0];
        let y = (self.conditional)(x).sample([u[1], 0.0, 0.0, 0.0])[0];
        [x, y, 0.0]
    }
    fn pdf(&self, x: Point) -> f64 {
        self.marginal.pdf(x) * (self.conditional)(x[0]).pdf([x[1], 0.0, 0.0])
    }
    fn invert(&self, x: Point) -> Uniforms {
        let u = self.marginal.invert(x)[0];
        let v = (self.conditional)(x[0]).invert([x[1], 0.0, 0.0])[0];
        [u, v, 0.0, 0.0]
    }
}
