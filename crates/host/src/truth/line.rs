//! Exact counterparts of the warps of the line.

use super::{
    FRAC_1_PI, FRAC_1_SQRT_2, PI, Point, Real, TAU, Truth, Uniforms, erf, erfc, ln_gamma, real,
    student_radius,
};

/// A one-dimensional truth from its quantile function, density and CDF.
pub struct Line<Q, P, C> {
    pub quantile: Q,
    pub pdf: P,
    pub cdf: C,
}

impl<Q, P, C> Truth for Line<Q, P, C>
where
    Q: Fn(Real) -> Real + Send + Sync,
    P: Fn(Real) -> Real + Send + Sync,
    C: Fn(Real) -> Real + Send + Sync,
{
    fn sample(&self, u: Uniforms) -> Point {
        [(self.quantile)(u[0]), real(0.0), real(0.0)]
    }
    fn pdf(&self, x: Point) -> Real {
        (self.pdf)(x[0])
    }
    fn invert(&self, x: Point) -> Uniforms {
        [(self.cdf)(x[0]), real(0.0), real(0.0), real(0.0)]
    }
}

/// A law whose density is known of a uniform, too: the `Real` of a point may have lost all digits of it.
struct OfUniform<L, D> {
    law: L,
    density: D,
}

impl<L: Truth, D: Fn(Real) -> Real + Send + Sync> Truth for OfUniform<L, D> {
    fn sample(&self, u: Uniforms) -> Point {
        self.law.sample(u)
    }
    fn pdf(&self, x: Point) -> Real {
        self.law.pdf(x)
    }
    fn density(&self, u: Uniforms) -> Real {
        (self.density)(u[0])
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.law.invert(x)
    }
}

pub fn interval(a: f32, b: f32, increasing: bool) -> Box<dyn Truth> {
    let (a, b) = (Real::from(a), Real::from(b));
    let (s, e) = if increasing { (a, b) } else { (b, a) };
    Box::new(Line {
        quantile: move |u| s + u * (e - s),
        pdf: move |_| 1.0 / (b - a),
        cdf: move |x| (x - s) / (e - s),
    })
}

/// ln(x/r), to a few units of Real however close or far apart the two are; infinite for an r of 0.
fn log_ratio(x: Real, r: Real) -> Real {
    if r == 0.0 {
        Real::INFINITY
    } else if x > 0.5 * r && x < 2.0 * r {
        ((x - r) / r).ln_1p()
    } else {
        (x / r).ln()
    }
}

/// The power law, through logarithms relative to the end R where x^m is larger.
pub fn power(n: f32, a: f32, b: f32, increasing: bool) -> Box<dyn Truth> {
    let (n, a, b) = (Real::from(n), Real::from(a), Real::from(b));
    let m = n + 1.0;
    let (r, other) = if m < 0.0 { (a, b) } else { (b, a) };
    // |m| and |ln(x/R)|; infinite where the other end is 0, and for m = 0 the law is that of the logarithm.
    let (steep, span) = (m.abs(), log_ratio(b, a));
    let drop = -(-steep * span).exp_m1();
    let from_anchor = increasing == (m < 0.0);
    // What is smaller stands for it, as the documentation says.
    let least = if a == 0.0 && n != 0.0 {
        2f64.powi(-149)
    } else {
        0.0
    };
    // The share of the mass that is no farther from R than x, and the share that is.
    let shares = move |x: Real| {
        let (part, left) = (log_ratio(x, r).abs(), log_ratio(x, other).abs());
        if m == 0.0 {
            (part / span, left / span)
        } else {
            let power = (-steep * part).exp();
            (
                -(-steep * part).exp_m1() / drop,
                power * -(-steep * left).exp_m1() / drop,
            )
        }
    };
    Box::new(Line {
        quantile: move |u: Real| {
            let (near, away) = if from_anchor {
                (1.0 - u, u)
            } else {
                (u, 1.0 - u)
            };
            if m == 0.0 {
                // From the nearer end.
                return if away < 0.5 {
                    r * (-away * span).exp()
                } else {
                    other * (near * span).exp()
                };
            }
            let log = if near == 0.0 {
                // Where e^-z may be 0 and its logarithm is not.
                -steep * span / m
            } else if away * drop < 0.5 {
                (-away * drop).ln_1p() / m
            } else {
                (near + away * (-steep * span).exp()).ln() / m
            };
            let x = r * log.exp();
            if u > 0.0 { x.max(least) } else { x }
        },
        pdf: move |x: Real| {
            let peak = if m == 0.0 { 1.0 / span } else { steep / drop };
            let power = if n == 0.0 {
                real(1.0)
            } else {
                (n * log_ratio(x, r)).exp()
            };
            peak / r * power
        },
        cdf: move |x: Real| {
            let (away, near) = shares(x);
            if from_anchor { away } else { near }
        },
    })
}

pub fn power_max(count: u32) -> Box<dyn Truth> {
    struct Max(u32);
    impl Truth for Max {
        fn sample(&self, u: Uniforms) -> Point {
            let all = u.len().min(self.0 as usize);
            let largest = u[..all].iter().copied().fold(real(0.0), Real::max);
            [largest, real(0.0), real(0.0)]
        }
        fn pdf(&self, x: Point) -> Real {
            let n = Real::from(self.0 - 1);
            let power = if n == 0.0 {
                real(1.0)
            } else {
                (n * log_ratio(x[0], real(1.0))).exp()
            };
            (n + 1.0) * power
        }
        fn invert(&self, x: Point) -> Uniforms {
            [x[0]; 4]
        }
    }
    Box::new(Max(count))
}

pub fn exponential(rate: f32) -> Box<dyn Truth> {
    let a = Real::from(rate);
    Box::new(Line {
        quantile: move |u: Real| -(-u).ln_1p() / a,
        pdf: move |x: Real| a * (-a * x).exp(),
        cdf: move |x: Real| -(-a * x).exp_m1(),
    })
}

pub fn exponential_tail(rate: f32) -> Box<dyn Truth> {
    let a = Real::from(rate);
    Box::new(Line {
        quantile: move |u: Real| -u.max(2f64.powi(-149)).ln() / a,
        pdf: move |x: Real| a * (-a * x).exp(),
        cdf: move |x: Real| (-a * x).exp(),
    })
}

pub fn truncated_exponential(rate: f32, length: f32) -> Box<dyn Truth> {
    let (c, len) = (Real::from(rate), Real::from(length));
    // Exact: both have 24 bits.
    let z = c * len;
    // (1 - e^-t)/t, which is 1 at t = 0.
    let mean = |t: Real| {
        if t == 0.0 {
            real(1.0)
        } else {
            -(-t).exp_m1() / t
        }
    };
    let law = Line {
        quantile: move |u: Real| {
            // -ln(1 - u + u e^-z)/c.
            if z.abs() < 1e-7 {
                // Two terms of the series in z; the next is below 1e-15.
                u * len * (1.0 - (1.0 - u) * z / 2.0 * (1.0 - (1.0 - 2.0 * u) * z / 3.0))
            } else if z > 0.0 && u * -(-z).exp_m1() > 0.5 {
                -((1.0 - u) + u * (-z).exp()).ln() / c
            } else if z > 0.0 {
                -(u * (-z).exp_m1()).ln_1p() / c
            } else if z > -40.0 {
                (u * (-z).exp_m1()).ln_1p() / -c
            } else if -z + u.ln() > 40.0 {
                // The 1 beside u e^|z| is lost even here, and that power may overflow.
                len - (u.ln() + (1.0 - u) / u * z.exp()) / c
            } else {
                ((-z + u.ln()).exp() - u).ln_1p() / -c
            }
        },
        pdf: move |x: Real| {
            let from_peak = if c > 0.0 { x } else { len - x };
            (-c.abs() * from_peak).exp() / (mean(z.abs()) * len)
        },
        cdf: move |x: Real| {
            // From the end where the density is larger, shares are relative to the whole.
            let share = |x: Real| x * mean(c.abs() * x) / (len * mean(z.abs()));
            if c > 0.0 {
                share(x)
            } else {
                (-c.abs() * (len - x)).exp() * share(x)
            }
        },
    };
    let density = move |u: Real| {
        let (peak, fall) = (1.0 / (mean(z.abs()) * len), (-z.abs()).exp());
        let (near, away) = if c > 0.0 { (1.0 - u, u) } else { (u, 1.0 - u) };
        peak * (near + away * fall)
    };
    Box::new(OfUniform { law, density })
}

/// Equi-angular sampling: the angle in which a point at a distance sees the way is uniform.
///
/// The textbook takes D tan φ of an angle between those of the ends, whose difference is lost for short ways and near
/// right angles. Here a triangle is divided: its apex is the light, and its base runs from the foot or from the nearer
/// end to the farther one. Angles from both sides and the law of sines divide the base without a difference.
pub fn equi_angular(distance: f32, low: f32, high: f32) -> Box<dyn Truth> {
    let [d, a, b] = [distance, low, high].map(Real::from);
    let passed = a < 0.0 && b > 0.0;
    let [to_a, to_b] = [a, b].map(|t| t.abs().atan2(d));
    let angle = if passed {
        to_a + to_b
    } else {
        (d * (b - a)).atan2(d * d + a * b)
    };
    // Where the light is in line with the way, all angles are 0 and sines are as their angles.
    let sine = move |part: Real| {
        if angle < 1e-12 {
            part
        } else {
            (part * angle).sin()
        }
    };
    // sin(Δ)/Δ, which is 1 at 0.
    let sinc = if angle < 1e-12 {
        real(1.0)
    } else {
        angle.sin() / angle
    };
    let scale = if passed {
        d / angle
    } else {
        sinc * d.hypot(a) * d.hypot(b) / (b - a)
    };
    Box::new(Line {
        quantile: move |u: Real| {
            let v = 1.0 - u;
            // (the nearer end, the share of the angle from there), and the same of the farther end.
            let ((near, from_near), (far, from_far)) = if !passed && a >= 0.0 {
                ((a, u), (b, v))
            } else if !passed {
                ((b, v), (a, u))
            } else if u * angle < to_a {
                ((real(0.0), to_a / angle - u), (a, u))
            } else {
                ((real(0.0), to_b / angle - v), (b, v))
            };
            let (x, y) = (
                d.hypot(far) * sine(from_far),
                d.hypot(near) * sine(from_near),
            );
            if y < x {
                near + (far - near) * (y / (x + y))
            } else {
                far - (far - near) * (x / (x + y))
            }
        },
        pdf: move |t: Real| scale / (d * d + t * t),
        cdf: move |t: Real| {
            if passed {
                let from_foot = t.abs().atan2(d);
                if t < 0.0 {
                    (to_a - from_foot) / angle
                } else {
                    1.0 - (to_b - from_foot) / angle
                }
            } else if angle < 1e-12 {
                (t - a) / (b - a) * (d.hypot(b) / d.hypot(t))
            } else {
                (d * (t - a)).atan2(d * d + a * t) / angle
            }
        },
    })
}

pub fn tent(radius: f32) -> Box<dyn Truth> {
    let r = Real::from(radius);
    let law = Line {
        // 1 - sqrt(t), about the centre through the logarithm of t = 1 - rest, so that nothing cancels there.
        quantile: move |u: Real| {
            let (t, rest) = (2.0 * u.min(1.0 - u), (1.0 - 2.0 * u).abs());
            let x = if t < 0.5 {
                r * (1.0 - t.sqrt())
            } else {
                -r * (0.5 * (-rest).ln_1p()).exp_m1()
            };
            if u < 0.5 { -x } else { x }
        },
        pdf: move |x: Real| (r - x.abs()) / r / r,
        cdf: move |x: Real| {
            let half = 0.5 * ((r - x.abs()) / r).powi(2);
            if x < 0.0 { half } else { 1.0 - half }
        },
    };
    let density = move |u: Real| (2.0 * u.min(1.0 - u)).sqrt() / r;
    Box::new(OfUniform { law, density })
}

pub fn linear(a: f32, b: f32) -> Box<dyn Truth> {
    let (a, b) = (Real::from(a), Real::from(b));
    Box::new(Line {
        quantile: move |u: Real| {
            let root = ((1.0 - u) * a * a + u * b * b).sqrt();
            if u == 0.0 {
                real(0.0)
            } else {
                u * (a + b) / (a + root)
            }
        },
        pdf: move |x: Real| 2.0 * ((1.0 - x) * a + x * b) / (a + b),
        cdf: move |x: Real| x * (a * (2.0 - x) + b * x) / (a + b),
    })
}

/// The standard normal CDF in Real.
pub fn normal_cdf(x: Real) -> Real {
    0.5 * erfc(-x * FRAC_1_SQRT_2)
}

/// The standard normal quantile of a lower-tail probability up to 1/2, by Newton's method: about the middle on the
/// probability between there and x, whose digits do not cancel, in the tail on the logarithm of the CDF, which
/// converges from either side.
pub fn normal_quantile_lower(p: Real) -> Real {
    let middle = p > 0.1;
    let mut x = if middle {
        (p - 0.5) * TAU.sqrt()
    } else {
        -(-2.0 * p.ln()).sqrt()
    };
    for _ in 0..60 {
        let density = (-0.5 * x * x).exp() / TAU.sqrt();
        let step = if middle {
            (0.5 * erf(x * FRAC_1_SQRT_2) - (p - 0.5)) / density
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

/// The standard normal quantile of a uniform, of which 0 counts as 2^-149.
pub fn normal_quantile(u: Real) -> Real {
    if u < 0.5 {
        normal_quantile_lower(u.max(SMALLEST))
    } else {
        -normal_quantile_lower(1.0 - u)
    }
}

pub fn normal(mean: f32, deviation: f32) -> Box<dyn Truth> {
    let (m, d) = (Real::from(mean), Real::from(deviation));
    let line = Line {
        quantile: move |u: Real| m + d * normal_quantile(u),
        pdf: move |x: Real| (-0.5 * ((x - m) / d).powi(2)).exp() / (d * TAU.sqrt()),
        cdf: move |x: Real| normal_cdf((x - m) / d),
    };
    Box::new(OfUniform {
        law: line,
        density: move |u: Real| (-0.5 * normal_quantile(u).powi(2)).exp() / (d * TAU.sqrt()),
    })
}

/// What a uniform of 0 counts as.
const SMALLEST: f64 = 1.0 / (1_u128 << 74) as f64 / (1_u128 << 75) as f64;

/// A law of a location and a scale, from that of location 0 and scale 1.
pub fn located<Q, P, C>(location: f32, scale: f32, standard: Line<Q, P, C>) -> Box<dyn Truth>
where
    Q: Fn(Real) -> Real + Copy + Send + Sync + 'static,
    P: Fn(Real) -> Real + Copy + Send + Sync + 'static,
    C: Fn(Real) -> Real + Send + Sync + 'static,
{
    let (at, s) = (Real::from(location), Real::from(scale));
    let Line { quantile, pdf, cdf } = standard;
    let law = Line {
        quantile: move |u: Real| at + s * quantile(u.max(SMALLEST)),
        pdf: move |x: Real| pdf((x - at) / s) / s,
        cdf: move |x: Real| cdf((x - at) / s),
    };
    let density = move |u: Real| pdf(quantile(u.max(SMALLEST))) / s;
    Box::new(OfUniform { law, density })
}

pub fn cauchy(location: f32, scale: f32) -> Box<dyn Truth> {
    let standard = Line {
        // About the median by its own distance, and by that of the nearer end beyond; never nearer than 2^-64.
        quantile: |u: Real| {
            if (u - 0.5).abs() < 0.25 {
                (PI * (u - 0.5)).tan()
            } else if u < 0.5 {
                -1.0 / (PI * u.max(2f64.powi(-64))).tan()
            } else {
                1.0 / (PI * (1.0 - u)).tan()
            }
        },
        pdf: |t: Real| FRAC_1_PI / (1.0 + t * t),
        cdf: |t: Real| {
            if t < 0.0 {
                FRAC_1_PI * (-1.0 / t).atan()
            } else {
                0.5 + FRAC_1_PI * t.atan()
            }
        },
    };
    located(location, scale, standard)
}

/// Γ((ν+1)/2)/(√(νπ) Γ(ν/2)), for many degrees by the series of the quotient's logarithm.
pub fn student_peak(degrees: Real) -> Real {
    let a = 0.5 * degrees;
    let log = if a > 50.0 {
        -1.0 / (8.0 * a) + 1.0 / (192.0 * a.powi(3)) - 1.0 / (640.0 * a.powi(5))
    } else {
        ln_gamma(a + 0.5) - ln_gamma(a) - 0.5 * a.ln()
    };
    log.exp() / TAU.sqrt()
}

/// Student's t by its map of two uniforms; its inverse is the pair whose second uniform lies at an end.
pub fn student_t(degrees: f32, location: f32, scale: f32) -> Box<dyn Truth> {
    struct Polar([Real; 3], Real);
    impl Truth for Polar {
        fn sample(&self, u: Uniforms) -> Point {
            let Self([degrees, location, scale], _) = *self;
            let radius = student_radius(degrees, u[0]);
            // The cosine of half a turn, which is small about its middle.
            let x = (PI * (u[1] - 0.5)).sin();
            [location + scale * radius * x, real(0.0), real(0.0)]
        }
        fn pdf(&self, x: Point) -> Real {
            let Self([degrees, location, scale], peak) = *self;
            let t = (x[0] - location) / scale;
            let log = 0.5 * (degrees + 1.0) * (t * t / degrees).ln_1p();
            peak / scale * (-log).exp()
        }
        fn invert(&self, x: Point) -> Uniforms {
            let Self([degrees, location, scale], _) = *self;
            let t = (x[0] - location) / scale;
            let u = -(-0.5 * degrees * (t * t / degrees).ln_1p()).exp_m1();
            let end = real(if x[0] < location { 0.0 } else { 1.0 });
            [u, end, real(0.0), real(0.0)]
        }
    }
    let parameters = [degrees, location, scale].map(Real::from);
    Box::new(Polar(parameters, student_peak(Real::from(degrees))))
}

pub fn laplace(location: f32, scale: f32) -> Box<dyn Truth> {
    let standard = Line {
        quantile: |u: Real| {
            if u < 0.5 {
                (2.0 * u).ln()
            } else {
                -(2.0 * (1.0 - u)).ln()
            }
        },
        pdf: |t: Real| 0.5 * (-t.abs()).exp(),
        cdf: |t: Real| {
            let tail = 0.5 * (-t.abs()).exp();
            if t < 0.0 { tail } else { 1.0 - tail }
        },
    };
    located(location, scale, standard)
}

pub fn logistic(location: f32, scale: f32) -> Box<dyn Truth> {
    let standard = Line {
        quantile: |u: Real| {
            if (u - 0.5).abs() < 0.25 {
                2.0 * (2.0 * u - 1.0).atanh()
            } else {
                (u / (1.0 - u)).ln()
            }
        },
        pdf: |t: Real| 0.25 / (0.5 * t).cosh().powi(2),
        cdf: |t: Real| 1.0 / (1.0 + (-t).exp()),
    };
    located(location, scale, standard)
}

/// What no sample of a truncated logistic law has less of beyond it.
const LEAST: f64 = f32::MIN_POSITIVE as f64;

/// A logistic law on an interval: about the location by the logit of the probabilities below and above, else by the distance
/// from the end that is nearer to the location, as a sum of two logarithms.
pub struct TruncatedLogistic {
    location: Real,
    scale: Real,
    low: Real,
    high: Real,
    about: bool,
    upper: bool,
    /// e^(±t) of the nearer end, and the probability between the ends over that beyond it on its side.
    odds: Real,
    share: Real,
    rest: Real,
}

/// The shares of a logistic law below and above t, each with its digits.
fn sigmoid(t: Real) -> [Real; 2] {
    [1.0 / (1.0 + (-t).exp()), 1.0 / (1.0 + t.exp())]
}

impl TruncatedLogistic {
    pub fn new(location: f32, scale: f32, low: f32, high: f32) -> Self {
        // The end that the warp takes: the distance from the other one would lose digits.
        let upper = high - location < location - low;
        let [location, scale, low, high] = [location, scale, low, high].map(Real::from);
        let width = (high - low) / scale;
        let near = if upper {
            high - location
        } else {
            location - low
        } / scale;
        let odds = near.exp();
        let whole = 1.0 + odds * (-width).exp();
        Self {
            location,
            scale,
            low,
            high,
            about: low < location && location < high && width > 3.999_999,
            upper,
            odds,
            share: -(-width).exp_m1() / whole,
            rest: (-width).exp() * (1.0 + odds) / whole,
        }
    }

    fn t(&self, x: Real) -> Real {
        (x - self.location) / self.scale
    }

    /// The probability beyond an end that has less than the least number beyond it is not reached.
    pub fn is_cut(&self) -> bool {
        if self.about {
            sigmoid(self.t(self.low))[0].min(sigmoid(self.t(self.high))[1]) < LEAST
        } else {
            self.rest < LEAST
        }
    }

    /// The probability between the ends.
    fn between(&self) -> Real {
        let (a, b) = (self.t(self.low), self.t(self.high));
        -(a - b).exp_m1() * sigmoid(b)[0] * sigmoid(a)[1]
    }

    fn sides(&self, u: Real) -> [Real; 2] {
        let (low, high) = (sigmoid(self.t(self.low)), sigmoid(self.t(self.high)));
        [0, 1].map(|k: usize| ((1.0 - u) * low[k] + u * high[k]).max(LEAST))
    }

    /// The probability from the nearer end on, and what is beyond in units of that beyond the end.
    fn parts(&self, u: Real) -> (Real, Real) {
        let (before, beyond) = if self.upper {
            (1.0 - u, u)
        } else {
            (u, 1.0 - u)
        };
        (before, (beyond + self.rest * before).max(LEAST))
    }
}

impl Truth for TruncatedLogistic {
    fn sample(&self, u: Uniforms) -> Point {
        let x = if self.about {
            let [below, above] = self.sides(u[0]);
            self.location + self.scale * (below / above).ln()
        } else {
            let (before, left) = self.parts(u[0]);
            let part = self.share * before;
            let fallen = if part < 0.5 {
                -(-part).ln_1p()
            } else {
                -left.ln()
            };
            let along = self.scale * (fallen + (self.odds * part).ln_1p());
            if self.upper {
                self.high - along
            } else {
                self.low + along
            }
        };
        [x.clamp(self.low, self.high), real(0.0), real(0.0)]
    }
    fn density(&self, u: Uniforms) -> Real {
        if self.about {
            let [below, above] = self.sides(u[0]);
            return below * above / (self.scale * self.between());
        }
        let (before, left) = self.parts(u[0]);
        left * (1.0 + self.odds * self.share * before)
            / (self.scale * self.share * (1.0 + self.odds))
    }
    fn pdf(&self, x: Point) -> Real {
        if self.about {
            let [below, above] = sigmoid(self.t(x[0]));
            return below * above / (self.scale * self.between());
        }
        let along = if self.upper {
            self.high - x[0]
        } else {
            x[0] - self.low
        } / self.scale;
        let fall = (-along).exp();
        let ratio = (1.0 + self.odds) / (1.0 + self.odds * fall);
        fall * ratio * ratio / (self.scale * self.share * (1.0 + self.odds))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let u = if self.about {
            (sigmoid(self.t(x[0]))[0] - sigmoid(self.t(self.low))[0]) / self.between()
        } else {
            let along = if self.upper {
                self.high - x[0]
            } else {
                x[0] - self.low
            } / self.scale;
            let before = -(-along).exp_m1() / (1.0 + self.odds * (-along).exp()) / self.share;
            if self.upper { 1.0 - before } else { before }
        };
        [u, real(0.0), real(0.0), real(0.0)]
    }
}

pub fn gumbel(location: f32, scale: f32) -> Box<dyn Truth> {
    let standard = Line {
        // Doubles have the digits to spare that cancel about 1/e, where the result is 0.
        quantile: |u: Real| -(-u.ln()).ln(),
        pdf: |t: Real| (-t - (-t).exp()).exp(),
        cdf: |t: Real| (-(-t).exp()).exp(),
    };
    located(location, scale, standard)
}

pub fn rayleigh(scale: f32) -> Box<dyn Truth> {
    let s = Real::from(scale);
    Box::new(Line {
        quantile: move |u: Real| s * (-2.0 * (-u).ln_1p()).sqrt(),
        pdf: move |x: Real| x / s / s * (-0.5 * (x / s).powi(2)).exp(),
        cdf: move |x: Real| -(-0.5 * (x / s).powi(2)).exp_m1(),
    })
}

/// (x/s)^power, to a few units of Real times the power however near to 1 the quotient is.
fn powered(x: Real, s: Real, power: Real) -> Real {
    (power * log_ratio(x, s)).exp()
}

pub fn weibull(scale: f32, shape: f32) -> Box<dyn Truth> {
    let (s, k) = (Real::from(scale), Real::from(shape));
    let quantile = move |u: Real| s * ((-(-u).ln_1p()).ln() / k).exp();
    let law = Line {
        quantile,
        pdf: move |x: Real| {
            if x == 0.0 {
                return [real(0.0), 1.0 / s, Real::INFINITY]
                    [usize::from(k <= 1.0) + usize::from(k < 1.0)];
            }
            // In the exponent at once: the power may underflow where the density does not.
            let log = log_ratio(x, s);
            k / s * ((k - 1.0) * log - (k * log).exp()).exp()
        },
        cdf: move |x: Real| -(-powered(x, s, k)).exp_m1(),
    };
    let density = move |u: Real| k * (1.0 - u) * -(-u).ln_1p() / quantile(u);
    Box::new(OfUniform { law, density })
}

pub fn pareto(minimum: f32, shape: f32) -> Box<dyn Truth> {
    let (m, a) = (Real::from(minimum), Real::from(shape));
    let quantile = move |u: Real| m * (-(-u).ln_1p() / a).exp();
    let law = Line {
        quantile,
        pdf: move |x: Real| {
            if x < m {
                real(0.0)
            } else {
                a / x * powered(m, x, a)
            }
        },
        cdf: move |x: Real| {
            if x <= m {
                real(0.0)
            } else {
                -(a * log_ratio(m, x)).exp_m1()
            }
        },
    };
    let density = move |u: Real| a * (1.0 - u) / quantile(u);
    Box::new(OfUniform { law, density })
}

pub fn log_normal(mean_of_log: f32, std_dev_of_log: f32) -> Box<dyn Truth> {
    let (m, d) = (Real::from(mean_of_log), Real::from(std_dev_of_log));
    let deviate = move |x: Real| (x.ln() - m) / d;
    let pdf = move |x: Real, z: Real| (-0.5 * z.powi(2)).exp() / (x * d * TAU.sqrt());
    let line = Line {
        quantile: move |u: Real| (m + d * normal_quantile(u)).exp().max(SMALLEST),
        pdf: move |x: Real| pdf(x, deviate(x)),
        cdf: move |x: Real| normal_cdf(deviate(x)),
    };
    Box::new(OfUniform {
        law: line,
        density: move |u: Real| {
            let z = normal_quantile(u);
            let x = (m + d * z).exp();
            let least = real(SMALLEST);
            if x > least {
                pdf(x, z)
            } else {
                pdf(least, deviate(least))
            }
        },
    })
}

/// (1 − Φ(t))/φ(t) for t ≥ 0: of the complementary error function, or farther out by Laplace's continued fraction.
fn mills(t: Real) -> Real {
    if t < 5.0 {
        (0.5 * t * t).exp() * erfc(t * FRAC_1_SQRT_2) * (0.25 * TAU).sqrt()
    } else {
        let fraction = (1..=60).rev().fold(t, |f, k| t + Real::from(k) / f);
        1.0 / fraction
    }
}

/// A normal law on an interval, in units of the mass of the density e^(−y)/σ with y = 0 at the point nearest to the mean: as
/// differences of Mills' ratio, or where these would cancel by the series of the density.
pub struct TruncatedNormal {
    mean: Real,
    deviation: Real,
    low: Real,
    high: Real,
    nearest: Real,
    /// The distance of the nearest point from the mean, in standard deviations.
    away: Real,
    below: Real,
    above: Real,
}

impl TruncatedNormal {
    pub fn new(mean: f32, deviation: f32, low: f32, high: f32) -> Self {
        let [mean, deviation, low, high] = [mean, deviation, low, high].map(Real::from);
        let nearest = mean.clamp(low, high);
        let mut law = Self {
            mean,
            deviation,
            low,
            high,
            nearest,
            away: (nearest - mean).abs() / deviation,
            below: real(0.0),
            above: real(0.0),
        };
        law.below = law.mass((nearest - low) / deviation);
        law.above = law.mass((high - nearest) / deviation);
        law
    }

    /// The exponent at a distance from the nearest point.
    fn exponent(&self, s: Real) -> Real {
        s * (self.away + 0.5 * s)
    }

    /// The mass over a distance from the nearest point.
    fn mass(&self, s: Real) -> Real {
        let c = self.away;
        if s.is_infinite() {
            return mills(c);
        }
        if (1.0 + c) * s < 1e-4 {
            // The derivatives of the density are Hermite's polynomials.
            let (p, q) = (c * s, s * s);
            let third = p * p - q;
            let fourth = p * (p * p - 3.0 * q);
            let fifth = p.powi(4) - 6.0 * p * p * q + 3.0 * q * q;
            return s * (1.0 - p / 2.0 + third / 6.0 - fourth / 24.0 + fifth / 120.0);
        }
        mills(c) - (-self.exponent(s)).exp() * mills(c + s)
    }

    /// The logarithm of what the mass beyond a distance is of that beyond the nearest point, without its sign.
    fn log_of_rest(&self, s: Real) -> Real {
        if s.is_infinite() {
            return s;
        }
        self.exponent(s) + (mills(self.away) / mills(self.away + s)).ln()
    }

    /// What share of the tail below the nearest point is beyond the lower end.
    pub fn beyond_low(&self) -> Real {
        (-self.log_of_rest((self.nearest - self.low) / self.deviation)).exp()
    }

    /// The distance that has this mass, or beyond which there is this rest of the tail.
    fn distance(&self, mass: Real, rest: Real) -> Real {
        let c = self.away;
        if mass == 0.0 {
            return real(0.0);
        }
        // Newton's method from the side where it does not pass the solution.
        let near = mass < 0.5 * mills(c);
        let deviate = -rest.ln();
        if !near && deviate.is_infinite() {
            return deviate;
        }
        let mut s = if near {
            mass
        } else {
            2.0 * deviate / (c + (c * c + 2.0 * deviate).sqrt())
        };
        for _ in 0..60 {
            let step = if near {
                (mass - self.mass(s)) * self.exponent(s).exp()
            } else {
                (deviate - self.log_of_rest(s)) * mills(c + s)
            };
            s += step;
            if step.abs() <= 1e-9 * s {
                break;
            }
        }
        s
    }

    /// The distance of the point of a uniform from the nearest point, and whether it is above.
    fn along(&self, u: Real) -> (Real, bool) {
        let v = 1.0 - u;
        let mass = u * self.above - v * self.below;
        let ends = [self.nearest - self.low, self.high - self.nearest];
        let [below, above] = ends.map(|end| (-self.log_of_rest(end / self.deviation)).exp());
        let tail = mills(self.away);
        let (distance, end) = if mass > 0.0 {
            let rest = v * (1.0 + self.below / tail) + u * above;
            (self.distance(mass, rest), ends[1])
        } else {
            let rest = u * (1.0 + self.above / tail) + v * below;
            (self.distance(-mass, rest), ends[0])
        };
        (distance.min(end / self.deviation), mass > 0.0)
    }
}

impl Truth for TruncatedNormal {
    fn sample(&self, u: Uniforms) -> Point {
        let (distance, upper) = self.along(u[0]);
        let along = self.deviation * distance;
        let x = self.nearest + if upper { along } else { -along };
        [x.clamp(self.low, self.high), real(0.0), real(0.0)]
    }
    fn density(&self, u: Uniforms) -> Real {
        let (distance, _) = self.along(u[0]);
        (-self.exponent(distance)).exp() / (self.deviation * (self.below + self.above))
    }
    fn pdf(&self, x: Point) -> Real {
        // Before the nearest point, where only a change of x by its rounding leads, the exponent is negative.
        let along = (x[0] - self.nearest) / self.deviation;
        let along = if self.nearest < self.mean {
            -along
        } else {
            along
        };
        let along = if self.away == 0.0 { along.abs() } else { along };
        (-self.exponent(along)).exp() / (self.deviation * (self.below + self.above))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let mass = self.mass((x[0] - self.nearest).abs() / self.deviation);
        let below = if x[0] > self.nearest {
            self.below + mass
        } else {
            self.below - mass
        };
        [
            below / (self.below + self.above),
            real(0.0),
            real(0.0),
            real(0.0),
        ]
    }
}
