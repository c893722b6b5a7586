//! Negative controls: what is wrong by a little is rejected, by the same examination, with the threshold and
//! the number of samples of the real run. A 25th of the samples rejects an error five times as large.

use crate::SAMPLES;
use crate::examination::Examination;
use crate::moments::tests;
use crate::report::Report;
use microwarp::uniform::grid;
use rand_pcg::Pcg32;
use std::f64::consts::{PI, TAU};
use std::sync::{Arc, LazyLock};
use support::{
    registry::{Domain, Entry, Erased, Point, Uniforms},
    speed, stats,
};

type Map = fn([f64; 2]) -> [f64; 3];
type Density = fn(&dyn Erased, Point) -> f32;

/// How wrong most controls are: 1 % where all samples are drawn.
static SLIGHT: LazyLock<f64> =
    LazyLock::new(|| speed::of("part by which the controls are wrong", 0.065, 0.01));

/// An entry's warp with its map or its density replaced by a wrong one.
struct Wrong {
    right: Arc<dyn Erased>,
    map: Option<Map>,
    pdf: Density,
}

impl Erased for Wrong {
    fn sample(&self, u: Uniforms) -> Point {
        match self.map {
            Some(map) => map([u[0], u[1]].map(f64::from)).map(|c| c as f32),
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
                .map(|_| self.sample([grid(rng), grid(rng), 0.0, 0.0]))
                .collect(),
            None => self.right.fill(rng, n),
        }
    }
}

pub fn entry(label: &str) -> Entry {
    let found = support::registry::entries()
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
    });
    let seed = label
        .bytes()
        .fold(1, |seed: u64, b| seed.wrapping_mul(31) + u64::from(b));
    (entry.domain, Examination::new(&entry, *SAMPLES).run(seed))
}

/// The threshold of the real run.
fn threshold() -> f64 {
    let entries = support::registry::entries();
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
    let maps: [(&str, &str, Map, &[&str]); 12] = [
        (
            "an interval bent by a power of xi near 1",
            "Interval [0, 1] poly",
            |[u, _]| [u.powf(1.0 + *SLIGHT), 0.0, 0.0],
            &["chi-square", "distance", "mean x", "mean x²"],
        ),
        (
            "an exponential whose rate is off",
            "Exponential a=1 poly",
            |[u, _]| [-(-u).ln_1p() / (1.0 + *SLIGHT), 0.0, 0.0],
            &["chi-square", "distance", "mean x", "mean x²"],
        ),
        (
            "a normal of a deviation slightly too large",
            "Normal 0, 1 libm",
            |[u, v]| [(1.0 + *SLIGHT) * normal(u, v), 0.0, 0.0],
            &["chi-square", "distance", "mean x²"],
        ),
        (
            "a disk with r = xi",
            "Disk poly",
            |[u, v]| [u * (TAU * v).cos(), u * (TAU * v).sin(), 0.0],
            &["chi-square", "distance", "mean x²", "mean y²"],
        ),
        (
            "a disk turned slightly unevenly",
            "DiskConcentric libm",
            |[u, v]| disk(u, v.powf(1.0 + *SLIGHT)),
            &["chi-square", "distance", "mean y"],
        ),
        (
            "a normal pair without the square root",
            "NormalPair 0, 1 libm",
            |[u, v]| normal_pair(u, v),
            &["chi-square", "distance", "mean x²"],
        ),
        (
            "a hemisphere with theta linear in xi",
            "Hemisphere poly",
            |[u, v]| direction(0.5 * PI * u, v),
            &["chi-square", "distance", "mean z", "mean z²"],
        ),
        (
            "a sphere with theta linear in xi",
            "Sphere libm",
            |[u, v]| direction(PI * u, v),
            &["chi-square", "distance", "mean z²"],
        ),
        (
            "a cosine hemisphere left at +z",
            "Oriented cosine about (1, 2, 3) poly",
            |[u, v]| direction(u.sqrt().asin(), v),
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a triangle with v = xi (1 - u)",
            "Triangle poly",
            |[u, v]| [u, v * (1.0 - u), (1.0 - u) * (1.0 - v)],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a cell with slightly too much",
            "PiecewiseConstant1d 2:0:4:1 on [0, 8] poly",
            |[u, _]| [cells(u, 2.0 * (1.0 + *SLIGHT) / 7.0), 0.0, 0.0],
            &["chi-square", "distance", "mean x"],
        ),
        (
            "a cell that leaks into one of weight zero",
            "PiecewiseConstant1d 2:0:4:1 on [0, 8] poly",
            |[u, _]| {
                [
                    cells(u, 2.0 / 7.0) + 0.001 * f64::from(u8::from(u < 2.0 / 7.0)),
                    0.0,
                    0.0,
                ]
            },
            &["has density 0"],
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
const KINDS: [&str; 5] = [
    "Power n=2.5 [0, 1] poly",
    "NormalPair 0, 1 poly",
    "PhongLobe n=50 poly",
    "Oriented cosine about -z poly",
    "TriangleOn space poly",
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
            &["chi-square", "mean x"],
        );
    }
    for kind in [
        Domain::Line,
        Domain::Plane,
        Domain::Directions,
        Domain::World,
        Domain::Space,
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
        Some(|[u, v]| disk(1.000_01 * u, v)),
        true_density,
    );
    assert_rejected("a disk too wide by 5e-6", &wide, &["outside the domain"]);
    let (_, wide) = report(
        "Interval [0, 1] poly",
        Some(|[u, _]| [1.000_01 * u, 0.0, 0.0]),
        true_density,
    );
    assert_rejected(
        "an interval too wide by 1e-5",
        &wide,
        &["outside the domain"],
    );
}
