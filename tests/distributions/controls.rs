//! Negative controls: what is wrong by a little is rejected, by the same examination, with the threshold and
//! the number of samples of the real run. A 22nd of the samples rejects an error 4.7 times as large.

use crate::SAMPLES;
use crate::examination::Examination;
use crate::moments::tests;
use crate::report::Report;
use host::parallel::{in_parallel, threads};
use host::registry::{Domain, Entry, Erased, Point, Uniforms, evidence::Map};
use host::{speed, stats};
use microwarp::uniform::grid;
use rand_pcg::Pcg32;
use std::f64::consts::TAU;
use std::sync::{Arc, LazyLock};

type Density = fn(&dyn Erased, Point) -> f32;

/// How wrong many controls are: 2.6 % where all samples are drawn.
static SLIGHT: LazyLock<f64> =
    LazyLock::new(|| speed::of("part by which the controls are wrong", 0.122, 0.026));

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
            Some(map) => map([u[0], u[1], u[2]].map(f64::from), *SLIGHT).map(|c| c as f32),
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
        .find(|e| e.to_string() == label);
    found.unwrap_or_else(|| panic!("no entry {label}"))
}

fn true_density(warp: &dyn Erased, x: Point) -> f32 {
    warp.pdf(x)
}

/// Examines a wrong warp with a seed no other run has.
fn report_of(mut entry: Entry, what: &str, map: Option<Map>, pdf: Density) -> (Domain, Report) {
    entry.warp = Arc::new(Wrong {
        right: Arc::clone(&entry.warp),
        map,
        pdf,
        three: entry.uniforms == 3,
    });
    let seed = what
        .bytes()
        .fold(1, |seed: u64, b| seed.wrapping_mul(31) + u64::from(b));
    (entry.domain, Examination::new(&entry, *SAMPLES).run(seed))
}

fn report(label: &str, map: Option<Map>, pdf: Density) -> (Domain, Report) {
    report_of(entry(label), label, map, pdf)
}

/// The threshold of the real run, or in the quick speed, which draws fewer entries, a lower one.
fn threshold() -> f64 {
    let entries = host::registry::entries();
    let resolved = entries.iter().filter(|e| e.resolved);
    stats::threshold(resolved.map(|e| tests(e.domain)).sum())
}

/// The named tests, or faults, that are not among the objections.
fn passed(what: &str, report: &Report, by: &[&str]) -> Vec<String> {
    let objections = report.objections(threshold());
    println!("{what}: {}", objections.join("; "));
    let objects = |name: &&&str| objections.iter().any(|o| o.contains(**name));
    let passed = by.iter().filter(|name| !objects(name));
    passed
        .map(|name| format!("{what} passes the {name}: {objections:?}"))
        .collect()
}

/// Asserts that each of the named tests, or faults, is among the objections.
fn assert_rejected(what: &str, report: &Report, by: &[&str]) {
    let passed = passed(what, report, by);
    assert!(passed.is_empty(), "{passed:#?}");
}

#[test]
fn wrong_maps_are_rejected() {
    let all = host::registry::of_poly();
    let wanted = all.iter().filter(|of| speed::wants(of.name));
    let controls: Vec<_> = wanted
        .flat_map(|of| of.controls.iter().map(move |control| (of, control)))
        .collect();
    let reports = in_parallel(threads(), &controls, |(of, control)| {
        let entry = of.entries().nth(control.case).expect("its case");
        report_of(entry, control.what, Some(control.map), true_density).1
    });
    let judged = controls.iter().zip(&reports);
    let passed: Vec<_> = judged
        .flat_map(|((_, control), report)| passed(control.what, report, control.by))
        .collect();
    assert!(passed.is_empty(), "{passed:#?}");
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
        let (_, once) = report(label, Some(|_, _| [f64::NAN; 3]), true_density);
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
        Some(|[u, v, _], _| {
            let (r, turn) = ((1.000_01 * u).sqrt(), TAU * v);
            [r * turn.cos(), r * turn.sin(), 0.0]
        }),
        true_density,
    );
    assert_rejected("a disk too wide by 5e-6", &wide, &["outside the domain"]);
    let (_, wide) = report(
        "Interval [0, 1] poly",
        Some(|[u, ..], _| [1.000_01 * u, 0.0, 0.0]),
        true_density,
    );
    assert_rejected(
        "an interval too wide by 1e-5",
        &wide,
        &["outside the domain"],
    );
}
