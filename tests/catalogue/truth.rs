//! What each warp should do, in `f64`, written from the definitions and not from the crate's code.
//!
//! Formulas here are the textbook ones wherever doubles bear them; where even doubles would cancel
//! (cones of 1e-7 rad), they are written in the complementary quantity. `tests/laws.rs` checks every
//! truth against itself: that its density is the derivative of its map, and its inverse the inverse.

use std::f64::consts::{FRAC_1_PI, PI, TAU};

pub type Uniforms = [f64; 4];
pub type Point = [f64; 3];

/// The exact counterpart of one warp with its parameters.
pub trait Truth: Send + Sync {
    /// The exact point of the uniforms.
    fn sample(&self, u: Uniforms) -> Point;
    /// The exact density at a point of the domain.
    fn pdf(&self, x: Point) -> f64;
    /// The exact uniforms of a point of the domain.
    fn invert(&self, x: Point) -> Uniforms;
}

/// A one-dimensional truth from its quantile function, density and CDF.
pub struct Line<Q, P, C> {
    pub quantile: Q,
    pub pdf: P,
    pub cdf: C,
}

impl<Q, P, C> Truth for Line<Q, P, C>
where
    Q: Fn(f64) -> f64 + Send + Sync,
    P: Fn(f64) -> f64 + Send + Sync,
    C: Fn(f64) -> f64 + Send + Sync,
{
    fn sample(&self, u: Uniforms) -> Point {
        [(self.quantile)(u[0]), 0.0, 0.0]
    }
    fn pdf(&self, x: Point) -> f64 {
        (self.pdf)(x[0])
    }
    fn invert(&self, x: Point) -> Uniforms {
        [(self.cdf)(x[0]), 0.0, 0.0, 0.0]
    }
}

pub fn interval(a: f32, b: f32, increasing: bool) -> Box<dyn Truth> {
    let (a, b) = (f64::from(a), f64::from(b));
    let (s, e) = if increasing { (a, b) } else { (b, a) };
    Box::new(Line {
        quantile: move |u| s + u * (e - s),
        pdf: move |_| 1.0 / (b - a),
        cdf: move |x| (x - s) / (e - s),
    })
}

/// The power law, through logarithms relative to the end where x^m is larger.
pub fn power(n: f32, a: f32, b: f32, increasing: bool) -> Box<dyn Truth> {
    let (n, a, b) = (f64::from(n), f64::from(a), f64::from(b));
    let m = n + 1.0;
    let octaves = ((b - a) / a).ln_1p();
    let r = if m < 0.0 { a } else { b };
    // The mass between a and x as a share of the whole.
    let below = move |x: f64| {
        let part = ((x - a) / a).ln_1p();
        if m == 0.0 {
            part / octaves
        } else if a == 0.0 {
            (x / b).powf(m)
        } else if m > 0.0 {
            // Relative to b: (1 - (a/x)^m) (x/b)^m / (1 - (a/b)^m)
            (m * (part - octaves)).exp() * (-m * part).exp_m1() / (-m * octaves).exp_m1()
        } else {
            (m * part).exp_m1() / (m * octaves).exp_m1()
        }
    };
    Box::new(Line {
        quantile: move |u: f64| {
            let (t, rest) = if increasing {
                (u, 1.0 - u)
            } else {
                (1.0 - u, u)
            };
            if m == 0.0 {
                a * (t * octaves).exp()
            } else if a == 0.0 {
                b * t.powf(1.0 / m)
            } else {
                // (x/r)^m = near + away e^-z, written relative to r where away is small.
                let (near, away) = if m > 0.0 { (t, rest) } else { (rest, t) };
                if near == 0.0 {
                    return if m > 0.0 { a } else { b };
                }
                let z = m.abs() * octaves;
                let argument = away * (-z).exp_m1();
                let log = if argument < -0.5 {
                    (near + away * (-z).exp()).ln()
                } else {
                    argument.ln_1p()
                };
                r * (log / m).exp()
            }
        },
        pdf: move |x: f64| {
            let peak = if m == 0.0 {
                1.0 / (octaves * r)
            } else if a == 0.0 {
                m / r
            } else {
                m.abs() / (-(-(m.abs()) * octaves).exp_m1() * r)
            };
            peak * (n * (x / r).ln()).exp()
        },
        cdf: move |x: f64| if increasing { below(x) } else { 1.0 - below(x) },
    })
}

pub fn power_max(count: u32) -> Box<dyn Truth> {
    struct Max(u32);
    impl Truth for Max {
        fn sample(&self, u: Uniforms) -> Point {
            let largest = u[..self.0 as usize].iter().copied().fold(0.0, f64::max);
            [largest, 0.0, 0.0]
        }
        fn pdf(&self, x: Point) -> f64 {
            f64::from(self.0) * x[0].powi(self.0 as i32 - 1)
        }
        fn invert(&self, x: Point) -> Uniforms {
            [x[0]; 4]
        }
    }
    Box::new(Max(count))
}

pub fn exponential(rate: f32) -> Box<dyn Truth> {
    let a = f64::from(rate);
    Box::new(Line {
        quantile: move |u: f64| -(-u).ln_1p() / a,
        pdf: move |x: f64| a * (-a * x).exp(),
        cdf: move |x: f64| -(-a * x).exp_m1(),
    })
}

pub fn exponential_tail(rate: f32) -> Box<dyn Truth> {
    let a = f64::from(rate);
    Box::new(Line {
        quantile: move |u: f64| -u.max(2f64.powi(-149)).ln() / a,
        pdf: move |x: f64| a * (-a * x).exp(),
        cdf: move |x: f64| (-a * x).exp(),
    })
}

pub fn truncated_exponential(rate: f32, length: f32) -> Box<dyn Truth> {
    let (c, len) = (f64::from(rate), f64::from(length));
    let z = c * len;
    Box::new(Line {
        quantile: move |u: f64| {
            if z.abs() < 1e-9 {
                u * len * (1.0 - (1.0 - u) * z / 2.0)
            } else if z > -700.0 {
                let argument = u * (-z).exp_m1();
                let log = if argument < -0.5 {
                    ((1.0 - u) + u * (-z).exp()).ln()
                } else {
                    argument.ln_1p()
                };
                -log / c
            } else {
                // e^-z overflows even here; measured from the far end.
                len + if u > 0.0 { u.ln().max(z) } else { z } / -c
            }
        },
        pdf: move |x: f64| {
            let from_peak = if c > 0.0 { x } else { len - x };
            let peak = if z.abs() < 1e-9 {
                1.0 / len
            } else {
                c.abs() / -(-z.abs()).exp_m1()
            };
            peak * (-c.abs() * from_peak).exp()
        },
        cdf: move |x: f64| {
            if z.abs() < 1e-9 {
                x / len
            } else if c > 0.0 {
                (-c * x).exp_m1() / (-z).exp_m1()
            } else {
                (-c.abs() * (len - x)).exp() * (c * x).exp_m1() / z.exp_m1()
            }
        },
    })
}

pub fn tent(radius: f32) -> Box<dyn Truth> {
    let r = f64::from(radius);
    Box::new(Line {
        quantile: move |u: f64| {
            if u < 0.5 {
                -r * (1.0 - (2.0 * u).sqrt())
            } else {
                r * (1.0 - (2.0 * (1.0 - u)).sqrt())
            }
        },
        pdf: move |x: f64| (r - x.abs()) / r / r,
        cdf: move |x: f64| {
            let half = 0.5 * ((r - x.abs()) / r).powi(2);
            if x < 0.0 { half } else { 1.0 - half }
        },
    })
}

pub fn linear(a: f32, b: f32) -> Box<dyn Truth> {
    let (a, b) = (f64::from(a), f64::from(b));
    Box::new(Line {
        quantile: move |u: f64| {
            let root = ((1.0 - u) * a * a + u * b * b).sqrt();
            if u == 0.0 {
                0.0
            } else {
                u * (a + b) / (a + root)
            }
        },
        pdf: move |x: f64| 2.0 * ((1.0 - x) * a + x * b) / (a + b),
        cdf: move |x: f64| x * (a * (2.0 - x) + b * x) / (a + b),
    })
}

/// The standard normal CDF in f64.
pub fn normal_cdf(x: f64) -> f64 {
    0.5 * libm::erfc(-x * std::f64::consts::FRAC_1_SQRT_2)
}

/// The standard normal quantile of a lower-tail probability, by Newton's method on the log of the CDF.
pub fn normal_quantile_lower(p: f64) -> f64 {
    let mut x = if p > 0.1 {
        (p - 0.5) * TAU.sqrt()
    } else {
        -(-2.0 * p.ln()).sqrt()
    };
    for _ in 0..60 {
        let cdf = normal_cdf(x);
        let density = (-0.5 * x * x).exp() / TAU.sqrt();
        // Newton on ln Φ converges from the left in the tail, where Newton on Φ overshoots.
        let step = (cdf / p).ln() * cdf / density;
        x -= step;
        // The convergence is quadratic: after a step this small the next would be below rounding.
        if step.abs() <= 1e-9 * x.abs() {
            break;
        }
    }
    x
}

pub fn normal(mean: f32, deviation: f32) -> Box<dyn Truth> {
    let (m, d) = (f64::from(mean), f64::from(deviation));
    Box::new(Line {
        quantile: move |u: f64| {
            m + d * if u < 0.5 {
                normal_quantile_lower(u.max(2f64.powi(-149)))
            } else {
                -normal_quantile_lower(1.0 - u)
            }
        },
        pdf: move |x: f64| (-0.5 * ((x - m) / d).powi(2)).exp() / (d * TAU.sqrt()),
        cdf: move |x: f64| normal_cdf((x - m) / d),
    })
}

fn turn(x: f64, y: f64) -> f64 {
    let t = y.atan2(x) / TAU;
    if t < 0.0 { t + 1.0 } else { t }
}

pub struct NormalPair {
    pub mean: [f64; 2],
    pub deviation: f64,
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

/// A distribution over directions that depends on the polar angle alone, in terms of q = 1 − cos θ.
pub struct Polar<Q, P, C> {
    /// (1 − cos θ, 1 + cos θ) of the first uniform.
    pub q: Q,
    /// The density per steradian at (1 − cos θ, 1 + cos θ).
    pub pdf: P,
    /// The first uniform of (1 − cos θ, 1 + cos θ).
    pub cdf: C,
}

/// 1 − cos θ and 1 + cos θ of a direction that may have been rounded, each from what holds it.
pub fn complements(x: Point) -> (f64, f64) {
    let sin2 = x[0] * x[0] + x[1] * x[1];
    if x[2] > 0.5 {
        let up = 1.0 + x[2];
        (sin2 / up, 2.0 - sin2 / up)
    } else if x[2] < -0.5 {
        let down = 1.0 - x[2];
        (2.0 - sin2 / down, sin2 / down)
    } else {
        (1.0 - x[2], 1.0 + x[2])
    }
}

impl<Q, P, C> Truth for Polar<Q, P, C>
where
    Q: Fn(f64) -> (f64, f64) + Send + Sync,
    P: Fn(f64, f64) -> f64 + Send + Sync,
    C: Fn(f64, f64) -> f64 + Send + Sync,
{
    fn sample(&self, u: Uniforms) -> Point {
        let (down, up) = (self.q)(u[0]);
        let (s, c) = (TAU * u[1]).sin_cos();
        let sin = (down * up).sqrt();
        let cos = if down < up { 1.0 - down } else { up - 1.0 };
        [sin * c, sin * s, cos]
    }
    fn pdf(&self, x: Point) -> f64 {
        let (down, up) = complements(x);
        (self.pdf)(down, up)
    }
    fn invert(&self, x: Point) -> Uniforms {
        let (down, up) = complements(x);
        [(self.cdf)(down, up), turn(x[0], x[1]), 0.0, 0.0]
    }
}

pub fn sphere() -> Box<dyn Truth> {
    Box::new(Polar {
        q: |u| (2.0 * u, 2.0 * (1.0 - u)),
        pdf: |_, _| 0.25 * FRAC_1_PI,
        cdf: |down, _| 0.5 * down,
    })
}

pub fn hemisphere() -> Box<dyn Truth> {
    Box::new(Polar {
        q: |u| (1.0 - u, 1.0 + u),
        pdf: |_, _| 0.5 * FRAC_1_PI,
        cdf: |down, _| 1.0 - down,
    })
}

/// cos θ of its two complements.
fn cosine(down: f64, up: f64) -> f64 {
    if down < 0.5 { 1.0 - down } else { up - 1.0 }
}

pub fn cosine_hemisphere() -> Box<dyn Truth> {
    Box::new(Polar {
        q: |u: f64| {
            let cos = (1.0 - u).sqrt();
            (u / (1.0 + cos), 1.0 + cos)
        },
        pdf: |down, up| cosine(down, up) * FRAC_1_PI,
        cdf: |down, up| down * up,
    })
}

/// Malley's method: the concentric disk lifted onto the hemisphere.
pub struct Malley;

impl Truth for Malley {
    fn sample(&self, u: Uniforms) -> Point {
        let [x, y, _] = DiskConcentric.sample(u);
        let m = u[0].min(1.0 - u[0]).min(u[1]).min(1.0 - u[1]);
        [x, y, 2.0 * (m * (1.0 - m)).sqrt()]
    }
    fn pdf(&self, x: Point) -> f64 {
        x[2] * FRAC_1_PI
    }
    fn invert(&self, x: Point) -> Uniforms {
        DiskConcentric.invert(x)
    }
}

pub fn phong(n: f32) -> Box<dyn Truth> {
    let n = f64::from(n);
    let ln_cos = |down: f64, up: f64| {
        if down < 0.5 {
            (-down).ln_1p()
        } else {
            (up - 1.0).ln()
        }
    };
    Box::new(Polar {
        q: move |u: f64| {
            let log = (-u).ln_1p() / (n + 1.0);
            (-log.exp_m1(), 1.0 + log.exp())
        },
        pdf: move |down, up| (n + 1.0) / TAU * (n * ln_cos(down, up)).exp(),
        cdf: move |down, up| -((n + 1.0) * ln_cos(down, up)).exp_m1(),
    })
}

/// A cone of 1 − cos θmax = `k` and 1 + cos θmax = `rest`.
pub fn cone(k: f64, rest: f64) -> Box<dyn Truth> {
    Box::new(Polar {
        q: move |u| (u * k, rest + (1.0 - u) * k),
        pdf: move |_, _| 1.0 / (TAU * k),
        cdf: move |down, _| down / k,
    })
}

/// 1 − cos of a half angle in radians.
pub fn one_minus_cos(radians: f32) -> f64 {
    2.0 * (0.5 * f64::from(radians)).sin().powi(2)
}

/// 1 + cos of a half angle in radians.
pub fn one_plus_cos(radians: f32) -> f64 {
    2.0 * (0.5 * f64::from(radians)).cos().powi(2)
}

pub struct Patch {
    pub theta: [f64; 2],
    pub phi: [f64; 2],
}

impl Patch {
    fn drop(&self) -> f64 {
        let [t0, t1] = self.theta;
        2.0 * (PI * (t0 + t1)).sin() * (PI * (t1 - t0)).sin()
    }
    fn first(&self) -> (f64, f64) {
        let (s, c) = (PI * self.theta[0]).sin_cos();
        (2.0 * s * s, 2.0 * c * c)
    }
}

impl Truth for Patch {
    fn sample(&self, u: Uniforms) -> Point {
        let (down, _) = self.first();
        let last = 2.0 * (PI * self.theta[1]).cos().powi(2);
        let (down, up) = (down + u[0] * self.drop(), last + (1.0 - u[0]) * self.drop());
        let phi = self.phi[0] + u[1] * (self.phi[1] - self.phi[0]);
        let (s, c) = (TAU * phi).sin_cos();
        let sin = (down * up).sqrt();
        let cos = if down < up { 1.0 - down } else { up - 1.0 };
        [sin * c, sin * s, cos]
    }
    fn pdf(&self, _: Point) -> f64 {
        1.0 / (self.drop() * TAU * (self.phi[1] - self.phi[0]))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let (down, up) = complements(x);
        let (first_down, first_up) = self.first();
        let u = if down < up {
            down - first_down
        } else {
            first_up - up
        } / self.drop();
        let width = self.phi[1] - self.phi[0];
        let off = x[1].atan2(x[0]) / TAU - self.phi[0] - 0.5 * width;
        [u, (off - off.round()) / width + 0.5, 0.0, 0.0]
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

pub fn cross(p: Point, q: Point) -> Point {
    [
        p[1] * q[2] - p[2] * q[1],
        p[2] * q[0] - p[0] * q[2],
        p[0] * q[1] - p[1] * q[0],
    ]
}

pub fn dot(p: Point, q: Point) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
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

/// A truth over directions turned onto a normal by an exact frame.
pub struct Turned {
    pub inner: Box<dyn Truth>,
    /// The rows are the frame's axes.
    pub axes: [Point; 3],
}

impl Turned {
    fn local(&self, x: Point) -> Point {
        self.axes.map(|axis| dot(axis, x))
    }
}

impl Truth for Turned {
    fn sample(&self, u: Uniforms) -> Point {
        let local = self.inner.sample(u);
        std::array::from_fn(|k| (0..3).map(|i| local[i] * self.axes[i][k]).sum())
    }
    fn pdf(&self, x: Point) -> f64 {
        self.inner.pdf(self.local(x))
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.inner.invert(self.local(x))
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
