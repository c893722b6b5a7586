//! Exact counterparts of the warps of the plane and of triangles in space.

use super::{Point, Truth, Uniforms, cross, dot, turn};
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
pub struct OnTriangle(pub [Point; 3]);

impl OnTriangle {
    fn sides(&self) -> [Point; 2] {
        let [a, b, c] = self.0;
        [0, 1].map(|i| std::array::from_fn(|k| [b, c][i][k] - a[k]))
    }
}

impl Truth for OnTriangle {
    fn sample(&self, u: Uniforms) -> Point {
        let b = Barycentric.sample(u);
        std::array::from_fn(|k| (0..3).map(|i| b[i] * self.0[i][k]).sum())
    }
    fn pdf(&self, _: Point) -> f64 {
        let [p, q] = self.sides();
        let c = cross(p, q);
        2.0 / dot(c, c).sqrt()
    }
    fn invert(&self, x: Point) -> Uniforms {
        let [p, q] = self.sides();
        let c = cross(p, q);
        let to: Point = std::array::from_fn(|k| x[k] - self.0[0][k]);
        let v = dot(cross(to, q), c) / dot(c, c);
        let w = dot(cross(p, to), c) / dot(c, c);
        Barycentric.invert([1.0 - v - w, v, w])
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
