//! The one table that lists every warp, in both tiers, with its exact counterpart.
//!
//! Every law runs over the whole table, so a new warp is one line here (and a truth in `truth.rs`).
//! What the laws are is not said here: see the files in `tests/`.

#![allow(dead_code, reason = "each test and example uses a part of the table")]

pub mod stats;
pub mod truth;

use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{self, *};
use microwarp::{Frame, Warp};
use rand_pcg::Pcg32;
use std::sync::Arc;
use truth::Truth;

/// Up to four uniforms; those a warp does not take are 0.
pub type Uniforms = [f32; 4];
/// Up to three coordinates; those a point does not have are 0.
pub type Point = [f32; 3];

/// What kind of space a warp's points lie in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// The real line.
    Line,
    /// The plane.
    Plane,
    /// Unit vectors, in local coordinates about +z.
    Directions,
    /// Unit vectors in world coordinates.
    World,
    /// Points of space, or barycentric coordinates.
    Space,
}

/// In what unit the error of a sample is stated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// Units in the last place of the exact value: relative accuracy everywhere.
    Ulp,
    /// Units in the last place of a fixed magnitude, for maps through 0 or to a far mean.
    UlpOf(f64),
    /// Euclidean distance in units of a length.
    Length(f64),
}

/// A warp whose types have been erased.
pub trait Erased: Send + Sync {
    fn sample(&self, u: Uniforms) -> Point;
    fn pdf(&self, x: Point) -> f32;
    fn invert(&self, x: Point) -> Uniforms;
    /// Draws through `Warp::fill`; `n` points.
    fn fill(&self, rng: &mut Pcg32, n: usize) -> Vec<Point>;
}

/// One warp with its parameters in one tier.
pub struct Entry {
    pub name: &'static str,
    pub parameters: &'static str,
    pub tier: &'static str,
    pub domain: Domain,
    /// How many uniforms a sample takes.
    pub uniforms: usize,
    pub measure: Measure,
    /// Whether `f32` resolves the distribution well enough for a test of its shape.
    pub resolved: bool,
    /// Whether the figures count for the table in the documentation of the warp.
    pub stated: bool,
    /// Whether u is recovered by the round trip, which parameters that `f32` barely resolves prevent.
    pub round_trip: bool,
    /// Whether u = 0 counts as 2^-149, as the documentation of the warp says.
    pub open: bool,
    pub warp: Arc<dyn Erased>,
    pub truth: Arc<dyn Truth>,
    /// Coordinates in the unit square in which cells for a test of shape are laid out: the inverse of
    /// some map onto the domain, not always that of the warp itself.
    pub chart: Arc<dyn Truth>,
}

impl Entry {
    /// `"Disk poly"`, `"PhongLobe n=50 libm"`.
    pub fn label(&self) -> String {
        let space = if self.parameters.is_empty() { "" } else { " " };
        format!("{}{space}{} {}", self.name, self.parameters, self.tier)
    }

    fn with(mut self, change: impl FnOnce(&mut Self)) -> Self {
        change(&mut self);
        self
    }

    fn chart(self, chart: impl Into<Arc<dyn Truth>>) -> Self {
        let chart = chart.into();
        self.with(|e| e.chart = chart)
    }

    /// Marks parameters whose spread `f32` barely resolves.
    fn unresolved(self) -> Self {
        self.with(|e| {
            e.resolved = false;
            e.round_trip = false;
        })
    }

    fn no_round_trip(self) -> Self {
        self.with(|e| e.round_trip = false)
    }
}

/// Arrays of up to N numbers, as the erased table holds them.
pub trait Flat<const N: usize>: Copy + Default2 {
    fn flat(self) -> [f32; N];
    fn unflat(flat: [f32; N]) -> Self;
}

/// `Default` for arrays of any length.
pub trait Default2 {
    fn zero() -> Self;
}

impl Default2 for f32 {
    fn zero() -> Self {
        0.0
    }
}

impl<const M: usize> Default2 for [f32; M] {
    fn zero() -> Self {
        [0.0; M]
    }
}

impl<const N: usize> Flat<N> for f32 {
    fn flat(self) -> [f32; N] {
        std::array::from_fn(|i| if i == 0 { self } else { 0.0 })
    }
    fn unflat(flat: [f32; N]) -> Self {
        flat[0]
    }
}

impl<const M: usize, const N: usize> Flat<N> for [f32; M] {
    fn flat(self) -> [f32; N] {
        std::array::from_fn(|i| if i < M { self[i] } else { 0.0 })
    }
    fn unflat(flat: [f32; N]) -> Self {
        std::array::from_fn(|i| flat[i])
    }
}

struct Wrapped<W>(W);

impl<W> Erased for Wrapped<W>
where
    W: Warp<Density = f32> + Send + Sync,
    W::Uniforms: Flat<4>,
    W::Point: Flat<3>,
{
    fn sample(&self, u: Uniforms) -> Point {
        self.0.sample(W::Uniforms::unflat(u)).flat()
    }
    fn pdf(&self, x: Point) -> f32 {
        self.0.pdf(W::Point::unflat(x))
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.0.invert(W::Point::unflat(x)).flat()
    }
    fn fill(&self, rng: &mut Pcg32, n: usize) -> Vec<Point> {
        let mut points = vec![W::Point::zero(); n];
        self.0.fill(rng, &mut points);
        points.into_iter().map(Flat::flat).collect()
    }
}

fn entry<T: Tier, W>(
    name: &'static str,
    parameters: &'static str,
    domain: Domain,
    measure: Measure,
    warp: W,
    truth: impl Into<Arc<dyn Truth>>,
) -> Entry
where
    W: Warp<Density = f32> + Send + Sync + 'static,
    W::Uniforms: Flat<4>,
    W::Point: Flat<3>,
{
    let truth = truth.into();
    let first = truth.sample([0.0; 4]);
    let density = truth.pdf(first);
    let usable = density > 0.0 && density < f64::INFINITY;
    Entry {
        name,
        parameters,
        tier: T::NAME,
        domain,
        uniforms: <W::Uniforms as microwarp::uniform::Uniforms>::COUNT,
        measure,
        resolved: true,
        stated: true,
        round_trip: true,
        open: !usable
            && (first[0] <= 0.0 || domain != Domain::Line)
            && name != "TruncatedExponential",
        warp: Arc::new(Wrapped(warp)),
        chart: Arc::clone(&truth),
        truth,
    }
}

/// Every warp at comfortable and at extreme parameters, in both tiers.
pub fn entries() -> Vec<Entry> {
    let mut all = of_tier::<Libm>();
    all.extend(of_tier::<Poly>());
    all
}

fn of_tier<T: Tier>() -> Vec<Entry> {
    let mut table = line::<T>();
    table.extend(plane::<T>());
    table.extend(directions::<T>());
    table
}

fn line<T: Tier>() -> Vec<Entry> {
    use Domain::Line;
    use Measure::{Ulp, UlpOf};
    let mut t = Vec::new();

    for (label, a, b, resolved) in [
        ("[0, 1]", 0.0, 1.0, true),
        ("[-3, 5]", -3.0, 5.0, true),
        ("[-3e38, 3e38]", -3e38, 3e38, true),
        ("[1e6, 1e6+1/16]", 1e6, 1e6 + 0.0625, false),
        ("[0, 1e-35]", 0.0, 1e-35, true),
    ] {
        let scale = f64::from(f32::max(f32::abs(a), f32::abs(b)));
        for increasing in [true, false] {
            let (name, warp) = if increasing {
                ("Interval", Interval::new(a, b))
            } else {
                ("Interval decreasing", Interval::decreasing(a, b))
            };
            let e = entry::<T, _>(
                name,
                label,
                Line,
                UlpOf(scale),
                warp.unwrap(),
                truth::interval(a, b, increasing),
            );
            t.push(if resolved { e } else { e.unresolved() });
        }
    }

    for (label, n, a, b, resolved) in [
        ("n=0 [1, 3]", 0.0, 1.0, 3.0, true),
        ("n=1 [0, 2]", 1.0, 0.0, 2.0, true),
        ("n=2.5 [0, 1]", 2.5, 0.0, 1.0, true),
        ("n=-0.5 [0, 4]", -0.5, 0.0, 4.0, true),
        ("n=-1 [1, 100]", -1.0, 1.0, 100.0, true),
        ("n=-0.9999999 [1, 100]", -0.999_999_9, 1.0, 100.0, true),
        ("n=-1.000001 [1, 100]", -1.000_001, 1.0, 100.0, true),
        ("n=-2.5 [1, 1e20]", -2.5, 1.0, 1e20, true),
        ("n=-0.99 [1e-10, 1e10]", -0.99, 1e-10, 1e10, true),
        ("n=-0.95 [1e-10, 1e10]", -0.95, 1e-10, 1e10, true),
        ("n=1 [1e20, 1e21]", 1.0, 1e20, 1e21, true),
        ("n=2 [1e-30, 1e-29]", 2.0, 1e-30, 1e-29, true),
        ("n=-1 [1e-37, 1e37]", -1.0, 1e-37, 1e37, true),
        ("n=1000 [1, 2]", 1000.0, 1.0, 2.0, true),
        ("n=-1000 [1, 2]", -1000.0, 1.0, 2.0, true),
        ("n=1e8 [1, 2]", 1e8, 1.0, 2.0, false),
        ("n=3 [1, 1.0001]", 3.0, 1.0, 1.0001, true),
    ] {
        for increasing in [true, false] {
            let (name, warp) = if increasing {
                ("Power", Power::<T>::new(n, a, b))
            } else {
                ("Power decreasing", Power::<T>::decreasing(n, a, b))
            };
            let e = entry::<T, _>(
                name,
                label,
                Line,
                Ulp,
                warp.unwrap(),
                truth::power(n, a, b, increasing),
            );
            t.push(if resolved { e } else { e.unresolved() });
        }
    }

    t.push(entry::<T, _>(
        "PowerMax",
        "N=1",
        Line,
        Ulp,
        PowerMax::<1>::new(),
        truth::power_max(1),
    ));
    t.push(
        entry::<T, _>(
            "PowerMax",
            "N=2",
            Line,
            Ulp,
            PowerMax::<2>::new(),
            truth::power_max(2),
        )
        .no_round_trip()
        .chart(truth::power(1.0, 0.0, 1.0, true)),
    );
    t.push(
        entry::<T, _>(
            "PowerMax",
            "N=4",
            Line,
            Ulp,
            PowerMax::<4>::new(),
            truth::power_max(4),
        )
        .no_round_trip()
        .chart(truth::power(3.0, 0.0, 1.0, true)),
    );

    for (label, rate) in [("a=1", 1.0), ("a=1e30", 1e30), ("a=3.1e-37", 3.1e-37)] {
        t.push(entry::<T, _>(
            "Exponential",
            label,
            Line,
            Ulp,
            Exponential::<T>::new(rate).unwrap(),
            truth::exponential(rate),
        ));
        t.push(entry::<T, _>(
            "ExponentialTail",
            label,
            Line,
            Ulp,
            ExponentialTail::<T>::new(rate).unwrap(),
            truth::exponential_tail(rate),
        ));
    }

    for (label, rate, length) in [
        ("c=2 X=3", 2.0, 3.0),
        ("c=-2 X=3", -2.0, 3.0),
        ("c=0 X=2", 0.0, 2.0),
        ("c=1e-3 X=1", 1e-3, 1.0),
        ("c=-7e-3 X=1", -7e-3, 1.0),
        ("c=9e-3 X=1", 9e-3, 1.0),
        ("c=30 X=1", 30.0, 1.0),
        ("c=-60 X=1", -60.0, 1.0),
        ("c=1e4 X=1", 1e4, 1.0),
        ("c=-1e4 X=1", -1e4, 1.0),
        ("c=1e30 X=1e-30", 1e30, 1e-30),
        ("c=1e30 X=1e30", 1e30, 1e30),
    ] {
        // Far from the peak of a steep rise towards X, f32 near X resolves 1 part in 1e4 of it.
        let steep = rate * length < -1e3;
        let e = entry::<T, _>(
            "TruncatedExponential",
            label,
            Line,
            Ulp,
            TruncatedExponential::<T>::new(rate, length).unwrap(),
            truth::truncated_exponential(rate, length),
        );
        t.push(if steep { e.unresolved() } else { e });
    }

    for (label, r) in [("r=1", 1.0), ("r=3e38", 3e38), ("r=1e-30", 1e-30)] {
        t.push(entry::<T, _>(
            "Tent",
            label,
            Line,
            Ulp,
            Tent::new(r).unwrap(),
            truth::tent(r),
        ));
    }
    for (label, a, b) in [
        ("1 to 3", 1.0, 3.0),
        ("1 to 0", 1.0, 0.0),
        ("0 to 1", 0.0, 1.0),
        ("1 to 1", 1.0, 1.0),
        ("1 to 1.000001", 1.0, 1.000_001),
        ("1e-20 to 1e20", 1e-20, 1e20),
        ("3e38 to 1e38", 3e38, 1e38),
    ] {
        t.push(entry::<T, _>(
            "Linear",
            label,
            Line,
            Ulp,
            Linear::new(a, b).unwrap(),
            truth::linear(a, b),
        ));
    }
    t.push(entry::<T, _>(
        "Normal",
        "0, 1",
        Line,
        Ulp,
        Normal::<T>::new(0.0, 1.0).unwrap(),
        truth::normal(0.0, 1.0),
    ));
    t.push(
        entry::<T, _>(
            "Normal",
            "100, 1",
            Line,
            UlpOf(100.0),
            Normal::<T>::new(100.0, 1.0).unwrap(),
            truth::normal(100.0, 1.0),
        )
        .no_round_trip(),
    );
    t.push(entry::<T, _>(
        "Normal",
        "0, 1e-30",
        Line,
        Ulp,
        Normal::<T>::new(0.0, 1e-30).unwrap(),
        truth::normal(0.0, 1e-30),
    ));
    t.push(entry::<T, _>(
        "Normal",
        "0, 1e36",
        Line,
        Ulp,
        Normal::<T>::new(0.0, 1e36).unwrap(),
        truth::normal(0.0, 1e36),
    ));
    t.push(entry::<T, _>(
        "Inversion",
        "p=1/2+x",
        Line,
        Ulp,
        Inversion::new(
            |u: f32| 4.0 * u / (1.0 + T::sqrt(1.0 + 8.0 * u)),
            |x: f32| 0.5 + x,
            |x: f32| 0.5 * x * (1.0 + x),
        ),
        Box::new(truth::Line {
            quantile: |u: f64| 4.0 * u / (1.0 + (1.0 + 8.0 * u).sqrt()),
            pdf: |x: f64| 0.5 + x,
            cdf: |x: f64| 0.5 * x * (1.0 + x),
        }) as Box<dyn Truth>,
    ));
    // Y = sin X with p(x) = 2x on [0, 1]: p(y) = 2 asin(y)/sqrt(1 - y²) on [0, sin 1].
    let sine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).0;
    let cosine = |x: f32| T::sincos_turns(x * (1.0 / core::f32::consts::TAU)).1;
    let arcsine =
        |y: f32| T::atan2_turns(y, T::sqrt((1.0 - y) * (1.0 + y))) * core::f32::consts::TAU;
    t.push(entry::<T, _>(
        "Transform",
        "y=sin x",
        Line,
        Ulp,
        Transform::new(Linear::new(0.0, 1.0).unwrap(), sine, arcsine, cosine),
        Box::new(truth::Line {
            quantile: |u: f64| u.sqrt().sin(),
            pdf: |y: f64| 2.0 * y.asin() / (1.0 - y * y).sqrt(),
            cdf: |y: f64| y.asin().powi(2),
        }) as Box<dyn Truth>,
    ));
    // p(x) = x on [sqrt 2, 2] becomes p(y) = e^y on [0, ln 2] under y = 2 ln x - ln 2.
    t.push(entry::<T, _>(
        "Transform",
        "y=2 ln x - ln 2",
        Line,
        UlpOf(0.7),
        Transform::new(
            Power::<T>::new(1.0, core::f32::consts::SQRT_2, 2.0).unwrap(),
            |x: f32| 2.0 * T::ln(x) - core::f32::consts::LN_2,
            |y: f32| T::exp(0.5 * (y + core::f32::consts::LN_2)),
            |x: f32| 2.0 / x,
        ),
        Box::new(truth::Line {
            // Exact for the interval whose lower end is the f32 nearest to the root of 2.
            quantile: |u: f64| {
                let low = f64::from(core::f32::consts::SQRT_2).powi(2);
                ((1.0 - u) * low + u * 4.0).ln() - f64::from(core::f32::consts::LN_2)
            },
            pdf: |y: f64| {
                let low = f64::from(core::f32::consts::SQRT_2).powi(2);
                (y + f64::from(core::f32::consts::LN_2)).exp() / (4.0 - low)
            },
            cdf: |y: f64| {
                let low = f64::from(core::f32::consts::SQRT_2).powi(2);
                ((y + f64::from(core::f32::consts::LN_2)).exp() - low) / (4.0 - low)
            },
        }) as Box<dyn Truth>,
    ));
    t
}

fn plane<T: Tier>() -> Vec<Entry> {
    use Domain::{Plane, Space};
    use Measure::Length;
    let mut t = vec![
        entry::<T, _>(
            "Disk",
            "",
            Plane,
            Length(1.0),
            Disk::<T>::new(),
            Box::new(truth::Disk) as Box<dyn Truth>,
        ),
        entry::<T, _>(
            "DiskConcentric",
            "",
            Plane,
            Length(1.0),
            DiskConcentric::<T>::new(),
            Box::new(truth::DiskConcentric) as Box<dyn Truth>,
        )
        .chart(Box::new(truth::Disk) as Box<dyn Truth>),
        entry::<T, _>(
            "Triangle",
            "",
            Space,
            Length(1.0),
            Triangle::new(),
            Box::new(truth::Barycentric) as Box<dyn Truth>,
        ),
    ];
    for (label, mean, deviation) in [
        ("0, 1", [0.0, 0.0], 1.0),
        ("(3, -2), 0.5", [3.0, -2.0], 0.5),
        ("0, 1e-18", [0.0, 0.0], 1e-18),
        ("0, 1e18", [0.0, 0.0], 1e18),
    ] {
        let far = mean[0] != 0.0;
        let e = entry::<T, _>(
            "NormalPair",
            label,
            Plane,
            Length(f64::from(deviation).max(f64::from(mean[0]))),
            NormalPair::<T>::new(mean, deviation).unwrap(),
            Box::new(truth::NormalPair {
                mean: mean.map(f64::from),
                deviation: f64::from(deviation),
            }) as Box<dyn Truth>,
        );
        t.push(if far || deviation < 1e-10 {
            e.no_round_trip()
        } else {
            e
        });
    }
    let wide = |v: [f32; 2]| [f64::from(v[0]), f64::from(v[1]), 0.0];
    for (label, vertices, size) in [
        ("plane", [[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]], 4.0),
        (
            "plane 1e18",
            [[-1e18, 0.0], [1e18, -1e18], [0.0, 1e18]],
            2e18,
        ),
        ("plane sliver", [[0.0, 0.0], [1.0, 0.0], [0.5, 1e-5]], 1.0),
    ] {
        let e = entry::<T, _>(
            "TriangleOn",
            label,
            Plane,
            Length(size),
            TriangleOn::new(vertices).unwrap(),
            Box::new(truth::OnTriangle(vertices.map(wide))) as Box<dyn Truth>,
        );
        t.push(if label != "plane" {
            e.no_round_trip()
        } else {
            e
        });
    }
    let vertices = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.5], [-1.0, 0.0, 3.0_f32]];
    t.push(
        entry::<T, _>(
            "TriangleOn",
            "space",
            Space,
            Length(4.0),
            TriangleOn::new(vertices).unwrap(),
            Box::new(truth::OnTriangle(vertices.map(|v| v.map(f64::from)))) as Box<dyn Truth>,
        )
        .no_round_trip(),
    );
    // Uniform below the diagonal: p(x) = 2x, p(y | x) = 1/x.
    let conditional = |x: f32| Interval::new(0.0, x).unwrap_or(Interval::new(0.0, 1.0).unwrap());
    t.push(entry::<T, _>(
        "MarginalConditional",
        "0<y<x<1",
        Plane,
        Length(1.0),
        MarginalConditional::new(Linear::new(0.0, 1.0).unwrap(), conditional),
        Box::new(truth::Product {
            marginal: truth::linear(0.0, 1.0),
            conditional: |x: f64| {
                Box::new(truth::Line {
                    quantile: move |u| u * x,
                    pdf: move |_| 1.0 / x,
                    cdf: move |y| y / x,
                }) as Box<dyn Truth>
            },
        }) as Box<dyn Truth>,
    ));
    t
}

fn directions<T: Tier>() -> Vec<Entry> {
    use Domain::{Directions, World};
    use Measure::Length;
    let mut t = vec![
        entry::<T, _>(
            "Sphere",
            "",
            Directions,
            Length(1.0),
            Sphere::<T>::new(),
            truth::sphere(),
        ),
        entry::<T, _>(
            "Hemisphere",
            "",
            Directions,
            Length(1.0),
            Hemisphere::<T>::new(),
            truth::hemisphere(),
        ),
        entry::<T, _>(
            "CosineHemisphere",
            "",
            Directions,
            Length(1.0),
            CosineHemisphere::<T>::new(),
            truth::cosine_hemisphere(),
        ),
        entry::<T, _>(
            "MalleyHemisphere",
            "",
            Directions,
            Length(1.0),
            MalleyHemisphere::<T>::new(),
            Box::new(truth::Malley) as Box<dyn Truth>,
        )
        .chart(truth::cosine_hemisphere()),
    ];
    for (label, n) in [
        ("n=0", 0.0),
        ("n=1", 1.0),
        ("n=50", 50.0),
        ("n=1e4", 1e4),
        ("n=1e6", 1e6),
        ("n=1e8", 1e8),
    ] {
        t.push(entry::<T, _>(
            "PhongLobe",
            label,
            Directions,
            Length(1.0),
            PhongLobe::<T>::new(n).unwrap(),
            truth::phong(n),
        ));
    }
    for (label, angle) in [
        ("1e-7 rad", 1e-7),
        ("1e-4 rad", 1e-4),
        ("1e-2 rad", 1e-2),
        ("0.1 rad", 0.1),
        ("1.5 rad", 1.5),
        ("3 rad", 3.0),
    ] {
        t.push(entry::<T, _>(
            "Cone",
            label,
            Directions,
            Length(1.0),
            Cone::<T>::from_angle(angle).unwrap(),
            truth::cone(truth::one_minus_cos(angle), truth::one_plus_cos(angle)),
        ));
    }
    t.push(entry::<T, _>(
        "Cone",
        "sphere at 1e-3",
        Directions,
        Length(1.0),
        Cone::<T>::from_sphere(1e-3).unwrap(),
        {
            let s = f64::from(1e-3_f32);
            let k = s * s / (1.0 + (1.0 - s * s).sqrt());
            truth::cone(k, 2.0 - k)
        },
    ));
    for (label, theta, phi) in [
        ("octant", [0.0, 0.25], [0.0, 0.25]),
        ("band", [0.2, 0.3], [-0.5, 0.5]),
        ("south", [0.45, 0.5], [0.1, 0.6]),
        ("1e-3 tile", [0.125, 0.126], [0.3, 0.301]),
    ] {
        let [[t0, t1], [p0, p1]]: [[f32; 2]; 2] = [theta, phi];
        t.push(entry::<T, _>(
            "SphericalPatch",
            label,
            Directions,
            Length(1.0),
            SphericalPatch::<T>::new(t0, t1, p0, p1).unwrap(),
            Box::new(truth::Patch {
                theta: theta.map(f64::from),
                phi: phi.map(f64::from),
            }) as Box<dyn Truth>,
        ));
    }
    for (label, normal) in [
        ("cosine about (1, 2, 3)", [1.0, 2.0, 3.0]),
        ("cosine about -z", [0.0, 0.0, -1.0]),
        ("cosine about (1e-4, 0, -1)", [1e-4, 0.0, -1.0]),
    ] {
        let frame = Frame::new(normal).unwrap();
        t.push(entry::<T, _>(
            "Oriented",
            label,
            World,
            Length(1.0),
            Oriented::new(warp::CosineHemisphere::<T>::new(), frame),
            Box::new(truth::Turned {
                inner: truth::cosine_hemisphere(),
                axes: exact_frame(normal),
            }) as Box<dyn Truth>,
        ));
    }
    t
}

/// The frame of Duff and others in f64.
fn exact_frame(normal: [f32; 3]) -> [truth::Point; 3] {
    let n = normal.map(f64::from);
    let length = truth::dot(n, n).sqrt();
    let [x, y, z] = n.map(|c| c / length);
    let sign = 1f64.copysign(z);
    // The same tangent vectors without the cancellation of 1 + a x² near the equator's pole.
    let a = -1.0 / (sign + z);
    [
        [1.0 + sign * x * x * a, sign * x * y * a, -sign * x],
        [x * y * a, sign + y * y * a, -y],
        [x, y, z],
    ]
}
