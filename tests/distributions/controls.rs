//! Negative controls: what is wrong by a little is rejected, by the same examination, with the threshold and
//! the number of samples of the real run. A 25th of the samples rejects an error five times as large.

use crate::SAMPLES;
use crate::examination::Examination;
use crate::moments::tests;
use crate::report::Report;
use host::{
    registry::{Domain, Entry, Erased, Point, Uniforms},
    speed, stats,
    truth::{normal_cdf, normal_quantile_lower},
};
use microwarp::uniform::grid;
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};
use std::sync::{Arc, LazyLock};

type Map = fn([f64; 3]) -> [f64; 3];
type Density = fn(&dyn Erased, Point) -> f32;

/// How wrong most controls are: 1 % where all samples are drawn.
static SLIGHT: LazyLock<f64> =
    LazyLock::new(|| speed::of("part by which the controls are wrong", 0.105, 0.018));

/// An entry's warp with its map or its density replaced by a wrong one.
struct Wrong {
    right: Arc<dyn Erased>,
    map: Option<Map>,
    pdf: Density,
    /// Whether the map takes all three uniforms.
    three: bool,
}

impl Erased for Wrong {
    fn sample(&self, u: Uniforms) -> Point {
        match self.map {
            Some(map) => map([u[0], u[1], u[2]].map(f64::from)).map(|c| c as f32),
            None => self.right.sample(u),
        }
    }
    fn pdf(&self, x: Point) -> f32 {
        (self.pdf)(self.right.as_ref(), x)
    }
    fn invert(&self, x: Point) -> Uniforms {
        self.right.invert(x)
    }
    fn block(&self, _: bool) -> Box<dyn FnMut()> {
        unreachable!("it is not timed")
    }
    fn fill(&self, rng: &mut Pcg32, n: usize) -> Vec<Point> {
        match self.map {
            Some(_) => (0..n)
                .map(|_| {
                    let [u, v] = [grid(rng), grid(rng)];
                    let w = if self.three { grid(rng) } else { 0.0 };
                    self.sample([u, v, w, 0.0])
                })
                .collect(),
            None => self.right.fill(rng, n),
        }
    }
}

pub fn entry(label: &str) -> Entry {
    let found = host::registry::entries()
        .into_iter()
        .find(|e| e.label() == label);
    found.unwrap_or_else(|| panic!("no entry {label}"))
}

fn true_density(warp: &dyn Erased, x: Point) -> f32 {
    warp.pdf(x)
}

/// Examines a wrong warp with a seed no other run has.
fn report(label: &str, map: Option<Map>, pdf: Density) -> (Domain, Report) {
    let mut entry = entry(label);
    entry.warp = Arc::new(Wrong {
        right: Arc::clone(&entry.warp),
        map,
        pdf,
        three: entry.uniforms == 3,
    });
    let seed = label
        .bytes()
        .fold(1, |seed: u64, b| seed.wrapping_mul(31) + u64::from(b));
    (entry.domain, Examination::new(&entry, *SAMPLES).run(seed))
}

/// The threshold of the real run.
fn threshold() -> f64 {
    let entries = host::registry::entries();
    let resolved = entries.iter().filter(|e| e.resolved);
    stats::threshold(resolved.map(|e| tests(e.domain)).sum())
}

/// Asserts that each of the named tests, or faults, is among the objections.
fn assert_rejected(what: &str, report: &Report, by: &[&str]) {
    let objections = report.objections(threshold());
    println!("{what}: {}", objections.join("; "));
    for name in by {
        let found = objections.iter().any(|o| o.contains(name));
        assert!(found, "{what} passes the {name}: {objections:?}");
    }
}

#[test]
fn wrong_maps_are_rejected() {
    let maps: [(&str, &str, Map, &[&str]); 33] = [
        (
            "an interval bent by a power of xi near 1",
            "Interval [0, 1] poly",
            |[u, ..]| [u.powf(1.0 + *SLIGHT), 0.0, 0.0],
            &["chi-square", "distance", "mean x", "mean x²"],
        ),
        (
            "an exponential whose rate is off",
            "Exponential a=1 poly",
            |[u, ..]| [-(-u).ln_1p() / (1.0 + *SLIGHT), 0.0, 0.0],
            &["chi-square", "distance", "mean x", "mean x²"],
        ),
        (
            "a normal of a deviation slightly too large",
            "Normal 0, 1 libm",
            |[u, v, _]| [(1.0 + *SLIGHT) * normal(u, v), 0.0, 0.0],
            &["chi-square", "distance", "mean x²"],
        ),
        (
            "a Cauchy number of a scale slightly too large",
            "Cauchy 0, 1 poly",
            |[u, _, _]| [-(1.0 + *SLIGHT) / (PI * (u + 1e-9)).tan(), 0.0, 0.0],
            &["chi-square", "distance"],
        ),
        (
            "a Laplace number that is positive slightly too often",
            "Laplace 0, 1 poly",
            |[u, v, _]| {
                let size = -(-u).ln_1p();
                let up = v < 0.5 + 0.5 * *SLIGHT;
                [if up { size } else { -size }, 0.0, 0.0]
            },
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a logistic number of a scale slightly too large",
            "Logistic 0, 1 libm",
            |[u, _, _]| {
                let odds = (u + 1e-9) / (1.0 - u);
                [(1.0 + *SLIGHT) * odds.ln(), 0.0, 0.0]
            },
            &["chi-square", "distance"],
        ),
        (
            "a Gumbel number of minima",
            "Gumbel 0, 1 poly",
            |[u, _, _]| [(-(-u).ln_1p() + 1e-9).ln(), 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a Rayleigh number without its factor of 2",
            "Rayleigh 1 poly",
            |[u, _, _]| [(-(-u).ln_1p()).sqrt(), 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a Weibull number of a shape slightly off",
            "Weibull 1, 1.5 libm",
            |[u, _, _]| [(-(-u).ln_1p()).powf((1.0 + *SLIGHT) / 1.5), 0.0, 0.0],
            &["chi-square", "distance"],
        ),
        (
            "a Pareto number of a shape slightly off",
            "Pareto 1, 2 poly",
            |[u, _, _]| [(1.0 - u).powf(-0.5 * (1.0 + *SLIGHT)), 0.0, 0.0],
            &["chi-square", "distance"],
        ),
        (
            "a log-normal number of a deviation slightly too large",
            "LogNormal 0, 0.5 poly",
            |[u, v, _]| [(0.5 * (1.0 + *SLIGHT) * normal(u, v)).exp(), 0.0, 0.0],
            &["chi-square", "distance"],
        ),
        (
            "a normal number clipped to the interval",
            "TruncatedNormal 0, 1 [-1, 2] libm",
            |[u, v, _]| [normal(u, v).clamp(-1.0, 2.0), 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a tail by a difference of probabilities that cancels in f32",
            "TruncatedNormal 0, 1 [-11, -10] poly",
            |[u, _, _]| {
                let below = [-11.0, -10.0].map(|t| (1.0 - normal_cdf(-t)) as f32);
                let p = f64::from(below[0] + u as f32 * (below[1] - below[0]));
                [
                    normal_quantile_lower(p.max(1e-45)).clamp(-11.0, -10.0),
                    0.0,
                    0.0,
                ]
            },
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a disk with r = xi",
            "Disk poly",
            |[u, v, _]| [u * (TAU * v).cos(), u * (TAU * v).sin(), 0.0],
            &["chi-square", "distance", "mean x²", "mean y²"],
        ),
        (
            "a disk turned slightly unevenly",
            "DiskConcentric libm",
            |[u, v, _]| disk(u, v.powf(1.0 + *SLIGHT)),
            &["chi-square", "distance", "mean y"],
        ),
        (
            "a normal pair without the square root",
            "NormalPair 0, 1 libm",
            |[u, v, _]| normal_pair(u, v),
            &["chi-square", "distance", "mean x²"],
        ),
        (
            "a hemisphere with theta linear in xi",
            "Hemisphere poly",
            |[u, v, _]| direction(0.5 * PI * u, v),
            &["chi-square", "distance", "mean z", "mean z²"],
        ),
        (
            "a sphere with theta linear in xi",
            "Sphere libm",
            |[u, v, _]| direction(PI * u, v),
            &["chi-square", "distance", "mean z²"],
        ),
        (
            "a cosine hemisphere left at +z",
            "Oriented cosine about (1, 2, 3) poly",
            |[u, v, _]| direction(u.sqrt().asin(), v),
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a triangle with v = xi (1 - u)",
            "Triangle poly",
            |[u, v, _]| [u, v * (1.0 - u), (1.0 - u) * (1.0 - v)],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a cell with slightly too much",
            "PiecewiseConstant1d 2:0:4:1 on [0, 8] poly",
            |[u, ..]| [cells(u, 2.0 * (1.0 + *SLIGHT) / 7.0), 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a cell that leaks into one of weight zero",
            "PiecewiseConstant1d 2:0:4:1 on [0, 8] poly",
            |[u, ..]| {
                [
                    cells(u, 2.0 / 7.0) + 0.001 * f64::from(u8::from(u < 2.0 / 7.0)),
                    0.0,
                    0.0,
                ]
            },
            &["has density 0"],
        ),
        (
            "a slope taken for a step",
            "PiecewiseLinear1d 1:3 on [0, 1] poly",
            |[u, ..]| [u, 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a slope slightly off",
            "PiecewiseLinear1d 1:3 on [0, 1] poly",
            |[u, ..]| [ramp(u, 1.0 + 4.0 * *SLIGHT, 3.0), 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a grey sky without sin theta in the weights of its rows",
            "LatLongMap 6 x 7 grey poly",
            |[u, v, _]| grey(u, 7.0 * v, false),
            &["chi-square", "distance", "mean z²"],
        ),
        (
            "a grey sky with theta linear within a row",
            "LatLongMap 6 x 7 grey poly",
            |[u, v, _]| {
                // Rows of the right weight.
                let cos = 1.0 - 2.0 * v;
                let row = (7.0 * cos.acos() / PI).min(6.999_999).floor();
                let [top, bottom] = [row, row + 1.0].map(|j| (PI * j / 7.0).cos());
                grey(u, row + (top - cos) / (top - bottom), true)
            },
            &["chi-square", "distance"],
        ),
        (
            "a ring with r linear in xi",
            "Annulus 1 to 2 poly",
            |[u, v, _]| {
                [
                    (1.0 + u) * (TAU * v).cos(),
                    (1.0 + u) * (TAU * v).sin(),
                    0.0,
                ]
            },
            &["chi-square", "distance", "mean x²", "mean y²"],
        ),
        (
            "a ball with r = the square root of xi",
            "Ball libm",
            |[u, v, w]| direction((1.0 - 2.0 * v).acos(), w).map(|c| u.sqrt() * c),
            &["chi-square", "distance", "mean x²", "mean z²"],
        ),
        (
            "rotations about a uniform axis by a uniform angle",
            "Rotation poly",
            |[u, v, w]| direction((1.0 - 2.0 * v).acos(), w).map(|c| (0.5 * PI * u).sin() * c),
            &["chi-square", "distance", "mean x²", "mean z²"],
        ),
        (
            "a tetrahedron of uniforms, each of what is left",
            "Simplex tetrahedron poly",
            |[u, v, w]| [u, (1.0 - u) * v, (1.0 - u) * (1.0 - v) * w],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a cone whose side is uniform in its height",
            "FrustumSurface cone poly",
            |[u, v, _]| {
                // The disk has 3/8 of the area.
                let (r, z) = if u < 0.375 {
                    (3.0 * (u / 0.375).sqrt(), 0.0)
                } else {
                    let up = (u - 0.375) / 0.625;
                    (3.0 * (1.0 - up), 4.0 * up)
                };
                [r * (TAU * v).cos(), r * (TAU * v).sin(), z]
            },
            &["chi-square", "distance", "mean z"],
        ),
        (
            "a capsule with slightly too many points on its ends",
            "CapsuleSurface 1 high, radius 0.5 poly",
            |[u, v, _]| capsule(u, v, 0.25 * (1.0 + *SLIGHT)),
            &["chi-square", "distance", "mean z²"],
        ),
        (
            "a box with as many points on each of its faces",
            "BoxSurface 2 x 1 x 0.5 poly",
            |[u, v, _]| {
                let (k, s) = ((3.0 * u).min(2.999_999) as usize, (3.0 * u).fract());
                let (low, side) = ([-1.0, 0.0, 0.25], [2.0, 1.0, 0.5]);
                let mut point = [0.0; 3];
                point[k] = if v < 0.5 { -4.0 } else { 4.0 };
                for (k, part) in [((k + 1) % 3, s), ((k + 2) % 3, (2.0 * v).fract())] {
                    point[k] = low[k] + part * side[k];
                }
                point
            },
            &["chi-square", "distance"],
        ),
    ];
    for (what, label, map, by) in maps {
        let (_, report) = report(label, Some(map), true_density);
        assert_rejected(what, &report, by);
    }
}

/// Cells of 2, 0, 4, 1 on [0, 8), the first with a share of its own.
fn cells(u: f64, first: f64) -> f64 {
    if u < first {
        2.0 * u / first
    } else if u < 6.0 / 7.0 {
        4.0 + 2.0 * (u - first) / (6.0 / 7.0 - first)
    } else {
        6.0 + 14.0 * (u - 6.0 / 7.0)
    }
}

/// A density that runs linearly from one number to another on [0, 1).
fn ramp(u: f64, a: f64, b: f64) -> f64 {
    u * (a + b) / (a + ((1.0 - u) * a * a + u * b * b).sqrt())
}

/// A direction of a grey sky in seven rows, at a place that counts rows: uniform within its row, or with equal steps of
/// θ, which crowd towards the poles.
fn grey(u: f64, place: f64, linear: bool) -> [f64; 3] {
    let row = place.min(6.999_999).floor();
    let [top, bottom] = [row, row + 1.0].map(|j| (PI * j / 7.0).cos());
    let part = place - row;
    let theta = if linear {
        PI * place / 7.0
    } else {
        (top + part * (bottom - top)).acos()
    };
    direction(theta, u)
}

/// A capsule of height 1 and radius ½, each of whose ends has a given part of the points.
fn capsule(u: f64, v: f64, end: f64) -> [f64; 3] {
    let (ring, z) = if u < end || 1.0 - u < end {
        let q = u.min(1.0 - u) / end;
        let z = 0.5 * (1.0 - q);
        let z = if u < 0.5 { -z } else { 1.0 + z };
        (0.5 * (q * (2.0 - q)).sqrt(), z)
    } else {
        (0.5, (u - end) / (1.0 - 2.0 * end))
    };
    [ring * (TAU * v).cos(), ring * (TAU * v).sin(), z]
}

fn disk(u: f64, v: f64) -> [f64; 3] {
    [u.sqrt() * (TAU * v).cos(), u.sqrt() * (TAU * v).sin(), 0.0]
}

fn normal(u: f64, v: f64) -> f64 {
    (-2.0 * (-u).ln_1p()).sqrt() * (TAU * v).cos()
}

fn normal_pair(u: f64, v: f64) -> [f64; 3] {
    let r = -2.0 * (-u).ln_1p();
    [r * (TAU * v).cos(), r * (TAU * v).sin(), 0.0]
}

fn direction(theta: f64, v: f64) -> [f64; 3] {
    [
        theta.sin() * (TAU * v).cos(),
        theta.sin() * (TAU * v).sin(),
        theta.cos(),
    ]
}

/// One warp of each domain kind, with a density that is neither constant nor comfortable where there is one.
const KINDS: [&str; 7] = [
    "Power n=2.5 [0, 1] poly",
    "NormalPair 0, 1 poly",
    "PhongLobe n=50 poly",
    "Oriented cosine about -z poly",
    "TriangleOn space poly",
    "Ball poly",
    "Rotation libm",
];

#[test]
fn densities_slightly_off_are_rejected() {
    let mut kinds = Vec::new();
    for label in KINDS {
        let (kind, too_large) = report(label, None, |warp, x| (1.0 + *SLIGHT as f32) * warp.pdf(x));
        assert_rejected(
            &format!("{label}, density slightly too large"),
            &too_large,
            &["chi-square", "integrates"],
        );
        kinds.push(kind);
    }
    // Of the right integral: too small on one side of a symmetry, too large on the other.
    for label in [
        "Normal 0, 1 poly",
        "Disk poly",
        "Sphere libm",
        "Oriented cosine about -z libm",
    ] {
        let (_, tilted) = report(label, None, |warp, x| {
            let tilt = *SLIGHT as f32;
            warp.pdf(x) * if x[0] < 0.0 { 1.0 - tilt } else { 1.0 + tilt }
        });
        assert_rejected(
            &format!("{label}, density slightly tilted"),
            &tilted,
            // With few samples the moments are those of the uniforms.
            &["chi-square", "mean"],
        );
    }
    for kind in [
        Domain::Line,
        Domain::Plane,
        Domain::Directions,
        Domain::World,
        Domain::Space,
        Domain::Solid,
        Domain::Rotations,
    ] {
        assert!(kinds.contains(&kind), "no control over {kind:?}");
    }
}

#[test]
fn what_is_not_a_number_or_not_possible_is_rejected() {
    for label in KINDS {
        let (_, nowhere) = report(label, None, |_, _| f32::NAN);
        assert_rejected(
            &format!("{label}, density NaN"),
            &nowhere,
            &["has density NaN", "integrates", "chi-square"],
        );
        let (_, once) = report(label, Some(|_| [f64::NAN; 3]), true_density);
        assert_rejected(
            &format!("{label}, samples NaN"),
            &once,
            &["outside the domain"],
        );
    }
    let (_, half) = report("Disk poly", None, |warp, x| {
        if x[1] < 0.0 { 0.0 } else { 2.0 * warp.pdf(x) }
    });
    assert_rejected(
        "a density of half a disk",
        &half,
        &["has density 0", "zero density"],
    );
    let (_, wide) = report(
        "Disk poly",
        Some(|[u, v, _]| disk(1.000_01 * u, v)),
        true_density,
    );
    assert_rejected("a disk too wide by 5e-6", &wide, &["outside the domain"]);
    let (_, wide) = report(
        "Interval [0, 1] poly",
        Some(|[u, ..]| [1.000_01 * u, 0.0, 0.0]),
        true_density,
    );
    assert_rejected(
        "an interval too wide by 1e-5",
        &wide,
        &["outside the domain"],
    );
}
