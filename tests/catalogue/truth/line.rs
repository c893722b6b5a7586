//! Exact counterparts of the warps of the line.

use super::{Point, Truth, Uniforms};
use std::f64::consts::TAU;

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

/// The standard normal quantile of a lower-tail probability up to 1/2, by Newton's method: about the middle on the
/// probability between there and x, whose digits do not cancel, in the tail on the logarithm of the CDF, which
/// converges from either side.
pub fn normal_quantile_lower(p: f64) -> f64 {
    let middle = p > 0.1;
    let mut x = if middle {
        (p - 0.5) * TAU.sqrt()
    } else {
        -(-2.0 * p.ln()).sqrt()
    };
    for _ in 0..60 {
        let density = (-0.5 * x * x).exp() / TAU.sqrt();
        let step = if middle {
            (0.5 * libm::erf(x * std::f64::consts::FRAC_1_SQRT_2) - (p - 0.5)) / density
        } else {
            let cdf = normal_cdf(x);
            (cdf / p).ln() * cdf / density
        };
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
