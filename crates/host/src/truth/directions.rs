//! Exact counterparts of the warps over directions.

use super::{
    DiskConcentric, FRAC_1_PI, PI, Point, Real, SeenSphere, TAU, Truth, Uniforms, dot, real, turn,
    width,
};

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
pub fn complements(x: Point) -> (Real, Real) {
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
    Q: Fn(Real) -> (Real, Real) + Send + Sync,
    P: Fn(Real, Real) -> Real + Send + Sync,
    C: Fn(Real, Real) -> Real + Send + Sync,
{
    fn sample(&self, u: Uniforms) -> Point {
        let (down, up) = (self.q)(u[0]);
        let (s, c) = (TAU * u[1]).sin_cos();
        let sin = (down * up).sqrt();
        let cos = if down < up { 1.0 - down } else { up - 1.0 };
        [sin * c, sin * s, cos]
    }
    fn pdf(&self, x: Point) -> Real {
        let (down, up) = complements(x);
        (self.pdf)(down, up)
    }
    fn invert(&self, x: Point) -> Uniforms {
        let (down, up) = complements(x);
        [(self.cdf)(down, up), turn(x[0], x[1]), real(0.0), real(0.0)]
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
fn cosine(down: Real, up: Real) -> Real {
    if down < 0.5 { 1.0 - down } else { up - 1.0 }
}

pub fn cosine_hemisphere() -> Box<dyn Truth> {
    Box::new(Polar {
        q: |u: Real| {
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
    fn pdf(&self, x: Point) -> Real {
        x[2] * FRAC_1_PI
    }
    fn invert(&self, x: Point) -> Uniforms {
        DiskConcentric.invert(x)
    }
}

pub fn phong(n: f32) -> Box<dyn Truth> {
    let n = Real::from(n);
    let ln_cos = |down: Real, up: Real| {
        if down < 0.5 {
            (-down).ln_1p()
        } else {
            (up - 1.0).ln()
        }
    };
    Box::new(Polar {
        q: move |u: Real| {
            let log = (-u).ln_1p() / (n + 1.0);
            (-log.exp_m1(), 1.0 + log.exp())
        },
        pdf: move |down, up| (n + 1.0) / TAU * (n * ln_cos(down, up)).exp(),
        cdf: move |down, up| -((n + 1.0) * ln_cos(down, up)).exp_m1(),
    })
}

/// A cone of 1 − cos θmax = `k` and 1 + cos θmax = `rest`.
pub fn cone(k: Real, rest: Real) -> Box<dyn Truth> {
    Box::new(Polar {
        q: move |u| (u * k, rest + (1.0 - u) * k),
        pdf: move |_, _| 1.0 / (TAU * k),
        cdf: move |down, _| down / k,
    })
}

/// A cone by the sine of its half angle.
pub fn cone_of_sine(sine: f32) -> Box<dyn Truth> {
    let s = Real::from(sine);
    let k = s * s / (1.0 + ((1.0 - s) * (1.0 + s)).sqrt());
    cone(k, 2.0 - k)
}

/// 1 − cos of a half angle in radians.
pub fn one_minus_cos(radians: f32) -> Real {
    2.0 * (0.5 * Real::from(radians)).sin().powi(2)
}

/// 1 + cos of a half angle in radians.
pub fn one_plus_cos(radians: f32) -> Real {
    2.0 * (0.5 * Real::from(radians)).cos().powi(2)
}

pub struct Patch {
    pub theta: [Real; 2],
    pub phi: [Real; 2],
}

impl Patch {
    /// cos θ₀ − cos θ₁.
    pub fn drop(&self) -> Real {
        let [t0, t1] = self.theta;
        let mean = if t0 + t1 <= 0.5 {
            t0 + t1
        } else {
            (0.5 - t0) + (0.5 - t1)
        };
        2.0 * (PI * mean).sin() * (PI * (t1 - t0)).sin()
    }
    /// The width in turns, at most a whole one.
    pub fn width(&self) -> Real {
        width(self.phi)
    }
    /// 1 − cos θ of the first side and 1 + cos θ of the second.
    fn ends(&self) -> (Real, Real) {
        let down = (PI * self.theta[0]).sin();
        let up = (PI * (0.5 - self.theta[1])).sin();
        (2.0 * down * down, 2.0 * up * up)
    }
    /// The smaller of 1 − cos θ₁ and 1 + cos θ₀.
    pub fn reach(&self) -> Real {
        let (down, up) = self.ends();
        (down + self.drop()).min(up + self.drop())
    }
}

impl Truth for Patch {
    fn sample(&self, u: Uniforms) -> Point {
        let (first, last) = self.ends();
        let (down, up) = (
            first + u[0] * self.drop(),
            last + (1.0 - u[0]) * self.drop(),
        );
        let (s, c) = (TAU * (self.phi[0] + u[1] * self.width())).sin_cos();
        let small = down.min(up);
        let sin = (small * (2.0 - small)).sqrt();
        let cos = if down < up { 1.0 - down } else { up - 1.0 };
        [sin * c, sin * s, cos]
    }
    fn pdf(&self, _: Point) -> Real {
        1.0 / (self.drop() * TAU * self.width())
    }
    fn invert(&self, x: Point) -> Uniforms {
        let ((down, up), (first, last)) = (complements(x), self.ends());
        let u = if down < up {
            (down - first) / self.drop()
        } else {
            1.0 - (up - last) / self.drop()
        };
        let width = self.width();
        let off = x[1].atan2(x[0]) / TAU - self.phi[0] - 0.5 * width;
        [u, (off - off.round()) / width + 0.5, real(0.0), real(0.0)]
    }
}

/// A truth over directions turned onto a normal by an exact frame.
pub struct Turned {
    inner: Box<dyn Truth>,
    /// The rows are the frame's axes.
    axes: [Point; 3],
}

impl Turned {
    pub fn new(inner: Box<dyn Truth>, normal: Point) -> Self {
        let axes = frame(normal);
        Self { inner, axes }
    }

    /// The cone that a sphere fills.
    pub fn seen(sphere: &SeenSphere) -> Self {
        let centred = [real(0.0), real(0.0), real(1.0)];
        let axis = if sphere.distance > 0.0 {
            sphere.axis
        } else {
            centred
        };
        Self::new(cone(sphere.k(), 2.0 - sphere.k()), axis)
    }

    fn local(&self, x: Point) -> Point {
        self.axes.map(|axis| dot(axis, x))
    }
}

impl Truth for Turned {
    fn sample(&self, u: Uniforms) -> Point {
        let local = self.inner.sample(u);
        std::array::from_fn(|k| (0..3).map(|i| local[i] * self.axes[i][k]).sum())
    }
    fn pdf(&self, x: Point) -> Real {
        self.inner.pdf(self.local(x))
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.inner.invert(self.local(x))
    }
}

/// The vector that the first three parameters are.
pub fn about(p: &[f32]) -> Point {
    [p[0], p[1], p[2]].map(Real::from)
}

/// The frame of Duff and others.
fn frame(n: Point) -> [Point; 3] {
    let length = dot(n, n).sqrt();
    let [x, y, z] = n.map(|c| c / length);
    let sign = real(1.0).copysign(z);
    // The same tangent vectors without the cancellation of 1 + a x² near the equator's pole.
    let a = -1.0 / (sign + z);
    [
        [1.0 + sign * x * x * a, sign * x * y * a, -sign * x],
        [x * y * a, sign + y * y * a, -y],
        [x, y, z],
    ]
}

/// The phase function of Henyey and Greenstein.
///
/// The textbook inverse divides by g and cancels near both ends of g. Here everything is said by the distance S from
/// the point g of the axis to the direction: between 1 − g and 1 + g, with S² = 1 + g² − 2g cos θ, and
/// S = (1 − g²)/(u(1 − g) + (1 − u)(1 + g)). S² − (1 − g)² = 2g(1 − cos θ) gives the rest, with g divided out on paper.
/// Against the textbook formulas in 300 digits these are right to 8e-16, relatively, for |g| from 1e-45 to 1 − 2⁻²⁴.
pub fn henyey_greenstein(g: f32) -> Box<dyn Truth> {
    let g = Real::from(g);
    henyey_greenstein_between(g, 1.0 - g, 1.0 + g)
}

/// The same by 1 − |g|, which tells g beyond the digits of `f32`; backward where the light turns back.
pub fn henyey_greenstein_peak(least: f32, backward: bool) -> Box<dyn Truth> {
    let least = Real::from(least);
    if backward {
        henyey_greenstein_between(least - 1.0, 2.0 - least, least)
    } else {
        henyey_greenstein_between(1.0 - least, least, 2.0 - least)
    }
}

/// Of g, 1 − g and 1 + g.
fn henyey_greenstein_between(g: Real, near: Real, far: Real) -> Box<dyn Truth> {
    // S, from the pole whose distance is the smaller: no difference of large numbers.
    let distance = move |down: Real, up: Real| {
        if g < 0.0 {
            (far * far - 2.0 * g * up).sqrt()
        } else {
            (near * near + 2.0 * g * down).sqrt()
        }
    };
    Box::new(Polar {
        q: move |u: Real| {
            let v = 1.0 - u;
            let mean = u * near + v * far;
            let s = near * far / mean;
            (u * near * (s + near) / mean, v * far * (s + far) / mean)
        },
        pdf: move |down, up| near * far / (4.0 * PI * distance(down, up).powi(3)),
        cdf: move |down, up| {
            let s = distance(down, up);
            if down < up {
                down * far / (s * (s + near))
            } else {
                1.0 - up * near / (s * (s + far))
            }
        },
    })
}

/// The von Mises-Fisher distribution: the density of 1 − cos θ is that of an exponential truncated at 2.
///
/// The textbook takes ln(u + (1 − u)e^(−2κ)) for cos θ − 1. Here each of 1 ∓ cos θ comes of a logarithm of 1 + x whose x
/// holds its digits.
pub fn von_mises_fisher(kappa: f32) -> Box<dyn Truth> {
    let k = Real::from(kappa);
    // (1 − e^(−2κ))/κ and (e^(2κ) − 1)/κ.
    let [mass, back] = if k == 0.0 {
        [real(2.0); 2]
    } else {
        [-(-2.0 * k).exp_m1() / k, (2.0 * k).exp_m1() / k]
    };
    // ln(1 + κx)/κ.
    let log = move |x: Real| if k == 0.0 { x } else { (k * x).ln_1p() / k };
    Box::new(Polar {
        q: move |u: Real| {
            let v = 1.0 - u;
            let down = if u * k * mass < 0.5 {
                -log(-u * mass)
            } else {
                -(v + u * (-2.0 * k).exp()).ln() / k
            };
            let up = if back.is_finite() {
                log(v * back)
            } else {
                2.0 - down
            };
            (down, up)
        },
        pdf: move |down: Real, _| (-k * down).exp() / (TAU * mass),
        cdf: move |down: Real, _| {
            if k == 0.0 {
                0.5 * down
            } else {
                -(-k * down).exp_m1() / (k * mass)
            }
        },
    })
}

/// Normals of GGX: by the slopes of the surface, whose squared distance in units of the roughness is u/(1 − u).
pub struct Ggx {
    pub alpha: [Real; 2],
}

impl Ggx {
    /// D(m), by the angles as in the papers: of a unit vector.
    fn distribution(&self, m: Point) -> Real {
        let [ax, ay] = self.alpha;
        let sum = (m[0] / ax).powi(2) + (m[1] / ay).powi(2) + m[2] * m[2];
        1.0 / (PI * ax * ay * sum * sum)
    }
}

impl Truth for Ggx {
    fn sample(&self, u: Uniforms) -> Point {
        let slope = (u[0] / (1.0 - u[0])).sqrt();
        let (s, c) = (TAU * u[1]).sin_cos();
        let [x, y] = [self.alpha[0] * slope * c, self.alpha[1] * slope * s];
        let length = (x * x + y * y + 1.0).sqrt();
        [x / length, y / length, 1.0 / length]
    }
    fn pdf(&self, x: Point) -> Real {
        self.distribution(x) * x[2]
    }
    fn invert(&self, x: Point) -> Uniforms {
        let [a, b] = [x[0] / self.alpha[0], x[1] / self.alpha[1]];
        let flat = a * a + b * b;
        [
            flat / (flat + x[2] * x[2]),
            turn(a, b),
            real(0.0),
            real(0.0),
        ]
    }
}

/// Visible normals of GGX, by a spherical cap.
pub struct GgxVisible {
    all: Ggx,
    view: Point,
    stretched: Point,
    length: Real,
    /// The lowest z of the cap, negated.
    rim: Real,
}

impl GgxVisible {
    pub fn new(view: [f32; 3], alpha: [f32; 2], bounded: bool) -> Self {
        let (view, alpha) = (view.map(Real::from), alpha.map(Real::from));
        let norm = dot(view, view).sqrt();
        let view = view.map(|c| c / norm);
        let squeezed = [alpha[0] * view[0], alpha[1] * view[1], view[2]];
        let length = dot(squeezed, squeezed).sqrt();
        let stretched = squeezed.map(|c| c / length);
        let k = if bounded {
            let a2 = alpha[0].min(alpha[1]).powi(2);
            let s2 = (1.0 + view[0].hypot(view[1])).powi(2);
            (1.0 - a2) * s2 / (s2 + a2 * view[2] * view[2])
        } else {
            real(1.0)
        };
        Self {
            all: Ggx { alpha },
            view,
            stretched,
            length,
            rim: k * stretched[2],
        }
    }
    /// The sum of the view and a point of the cap.
    fn sum(&self, u: Uniforms) -> Point {
        let [sx, sy, sz] = self.stretched;
        let (off, rise) = (u[0] * (1.0 + self.rim), (1.0 - u[0]) * (1.0 + self.rim));
        let sine = sx.hypot(sy);
        let down = sine * sine / (1.0 + sz);
        // z of the cap's point plus that of the view, and its sine.
        let height = rise + (sz - self.rim);
        let sin = (off * (height + down)).sqrt();
        // The sum along the view's azimuth: of sine - sin, by the difference of their squares, and of the rest of the cosine.
        let apart = (down - off) * height / (sine + sin).max(Real::MIN_POSITIVE);
        let (s, c) = (0.5 * TAU * u[1]).sin_cos();
        let (along, side) = (apart + 2.0 * sin * c * c, 2.0 * sin * s * c);
        let (s, c) = self.azimuth().sin_cos();
        [along * c - side * s, along * s + side * c, height]
    }
    /// The azimuth from which the second uniform counts; 0 of a view along the normal, whatever the signs of its zeros.
    fn azimuth(&self) -> Real {
        let [x, y, _] = self.stretched.map(|c| c + 0.0);
        y.atan2(x)
    }
}

impl Truth for GgxVisible {
    fn sample(&self, u: Uniforms) -> Point {
        let (sum, [ax, ay]) = (self.sum(u), self.all.alpha);
        let squeezed = [ax * sum[0], ay * sum[1], sum[2]];
        let length = dot(squeezed, squeezed).sqrt();
        squeezed.map(|x| x / length)
    }
    /// By the Jacobians of the map instead of w·m, which cancels at grazing views: of a point of the cap, of its reflection
    /// into the direction half way to the view, and of the scaling of that.
    fn density(&self, u: Uniforms) -> Real {
        let (sum, [ax, ay]) = (self.sum(u), self.all.alpha);
        let length = dot(sum, sum).sqrt();
        let half = sum.map(|x| x / length);
        let squeezed = [ax * half[0], ay * half[1], half[2]];
        let cap = 1.0 / (TAU * (1.0 + self.rim));
        let reflected = 4.0 * (0.5 * length);
        cap * reflected * dot(squeezed, squeezed).powf(1.5) / (ax * ay)
    }
    fn pdf(&self, x: Point) -> Real {
        let seen = dot(self.view, x).max(0.0);
        2.0 * seen * self.all.distribution(x) / (self.length * (1.0 + self.rim))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let [ax, ay] = self.all.alpha;
        let h = [x[0] / ax, x[1] / ay, x[2]];
        let scale = 2.0 * dot(self.stretched, h) / dot(h, h);
        let [sx, sy, sz] = self.stretched;
        let cap = [scale * h[0] - sx, scale * h[1] - sy, scale * h[2] - sz];
        let turns = (cap[1].atan2(cap[0]) - self.azimuth()) / TAU;
        let u = (1.0 - cap[2]) / (1.0 + self.rim);
        [u, turns - turns.floor(), real(0.0), real(0.0)]
    }
}

/// Directions into which the visible normals of GGX reflect the view.
pub struct Reflected(pub GgxVisible);

impl Reflected {
    fn half_way(&self, x: Point) -> Point {
        let sum = [0, 1, 2].map(|i| x[i] + self.0.view[i]);
        let length = dot(sum, sum).sqrt();
        sum.map(|c| c / length)
    }
    fn of_normal(&self, m: Point) -> Real {
        self.0.all.distribution(m) / (2.0 * self.0.length * (1.0 + self.0.rim))
    }
}

impl Truth for Reflected {
    fn sample(&self, u: Uniforms) -> Point {
        let m = self.0.sample(u);
        let twice = 2.0 * dot(self.0.view, m);
        [0, 1, 2].map(|i| twice * m[i] - self.0.view[i])
    }
    fn density(&self, u: Uniforms) -> Real {
        self.of_normal(self.0.sample(u))
    }
    fn pdf(&self, x: Point) -> Real {
        self.of_normal(self.half_way(x))
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.0.invert(self.half_way(x))
    }
}
