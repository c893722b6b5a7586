//! Samples of the integer tier follow their distributions: mapped back by the exact inverse they are uniform, by
//! chi-square over cells of the unit interval or square and by Kolmogorov and Smirnov's distance along each axis.
//!
//! Negative controls are in `wrong_maps`.

use super::shapes::{Shape, shapes};
use host::parallel::{in_parallel, threads};
use host::{docs, speed, stats};
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use rand_pcg::Pcg32;
use std::collections::BTreeSet;

/// What the samples of a shape gave.
pub struct Report {
    /// Chi-square's p-value, then those of the distances.
    pub p: Vec<f64>,
    /// What no chance excuses.
    pub fault: Option<String>,
}

impl Report {
    pub fn passes(&self, threshold: f64) -> bool {
        self.fault.is_none() && stats::passes(&self.p, threshold)
    }
}

/// Places along an axis where the distance is read.
const PLACES: usize = 1 << 15;
const CHUNK: usize = 1 << 12;

/// The place of a uniform among so many cells of the unit interval, which may be a little outside.
fn cell(u: f64, cells: usize) -> usize {
    ((u * cells as f64) as usize).min(cells - 1)
}

pub fn examine(shape: &Shape, seed: u64) -> Report {
    let mut rng = Pcg32::new(seed, seed);
    let rows = if shape.axes == 1 { 1 } else { shape.cells + 2 };
    let mut cells = vec![0_u64; shape.cells * rows];
    let mut places = vec![vec![0_u64; PLACES]; shape.axes];
    let mut uniforms = [[0.0; 2]; CHUNK];
    let mut fault = None;
    for _ in 0..shape.samples / CHUNK {
        if let Some(point) = (shape.fill)(&mut rng, &mut uniforms) {
            fault = Some(format!("{point:?} has density 0"));
        }
        for uniform in &uniforms {
            for (u, places) in uniform.iter().zip(&mut places) {
                let inside = *u >= -shape.slack && *u <= 1.0 + shape.slack;
                if !inside {
                    fault = Some(format!("{u} is no uniform"));
                }
                places[cell(*u, PLACES)] += 1;
            }
            let [column, row] = [cell(uniform[0], shape.cells), cell(uniform[1], rows)];
            cells[column * rows + row] += 1;
        }
    }
    let n = shape.samples as f64;
    let expected = vec![n / cells.len() as f64; cells.len()];
    let mut p = vec![stats::chi_square(&cells, &expected).unwrap().2];
    for places in places {
        let (mut below, mut distance) = (0, 0.0_f64);
        for (i, count) in places.iter().enumerate() {
            below += count;
            distance = distance.max((below as f64 / n - (i + 1) as f64 / PLACES as f64).abs());
        }
        p.push(stats::kolmogorov(distance, n));
    }
    Report { p, fault }
}

/// The p-value below which any of all the tests rejects.
pub fn threshold(shapes: &[Shape]) -> f64 {
    stats::threshold(shapes.iter().map(|shape| 1 + shape.axes).sum())
}

#[test]
fn samples_follow_their_distributions() {
    let shapes = shapes();
    let threshold = threshold(&shapes);
    let seeded: Vec<(u64, &Shape)> = (0xd15c..).zip(&shapes).collect();
    let judged = in_parallel(threads(), &seeded, |(seed, shape)| {
        let report = examine(shape, *seed);
        let fault = report.fault.as_deref().unwrap_or("");
        println!("{:40} {:.3?} {fault}", shape.name, report.p);
        (shape.name.clone(), report.passes(threshold))
    });
    let rejected: Vec<_> = judged.iter().filter(|(_, passes)| !passes).collect();
    assert!(
        rejected.is_empty(),
        "{rejected:?}, threshold {threshold:.1e}"
    );
}

/// Of right warps the p-values are uniform themselves: neither chi-square nor the distance is too lenient.
#[test]
fn p_values_of_right_warps_are_uniform() {
    for (first, name) in (1000..).step_by(1000).zip([
        "Disk fine",
        "StandardExponential fine",
        "PhongLobe 50 compact",
    ]) {
        let mut shape = shapes()
            .into_iter()
            .find(|shape| shape.name == name)
            .unwrap();
        shape.samples = speed::of("samples of each run of right warps", 1 << 15, 1 << 16);
        let count = speed::of("runs of right warps", 50, 200);
        // The same words would give the same uniforms again, whatever the warp.
        let seeds = first..first + count;
        let many = count as f64;
        let runs: Vec<Report> = seeds.map(|seed| examine(&shape, seed)).collect();
        for test in 0..=shape.axes {
            let mut p: Vec<f64> = runs.iter().map(|run| run.p[test]).collect();
            p.sort_by(f64::total_cmp);
            let off = p
                .iter()
                .enumerate()
                .map(|(i, p)| (p - (i as f64 + 0.5) / many).abs());
            let distance = off.fold(0.0, f64::max) + 0.5 / many;
            let chance = stats::kolmogorov(distance, many);
            println!("{name}, test {test}: {distance:.3} from uniform, p = {chance:.3}");
            assert!(chance >= 1e-6, "{name}, test {test}: {chance}");
        }
    }
}

/// The warps that the sources of the integer tier implement; `Float` hands over those of others.
fn implemented() -> BTreeSet<String> {
    let texts = docs::sources("fixed");
    let lines = texts
        .iter()
        .flat_map(|(_, text)| text.lines())
        .filter(|line| line.starts_with("impl"));
    let names = lines.filter_map(|line| line.split_once(" Warp for ")?.1.split(['<', ' ']).next());
    names
        .filter(|name| *name != "Float")
        .map(str::to_owned)
        .collect()
}

#[test]
fn no_warp_is_missing_from_the_shapes_and_the_golden_bits() {
    let implemented = implemented();
    assert!(implemented.len() >= 13, "{implemented:?}");
    let shapes: Vec<String> = shapes().into_iter().map(|shape| shape.name).collect();
    let golden: Vec<(&str, &str)> = (0..microwarp_list::cases())
        .map(microwarp_list::describe)
        .map(|(name, _, tier)| (name, tier))
        .collect();
    for name in &implemented {
        let is = |label: &str| label.split(' ').next() == Some(name);
        // An interval has no grade.
        let grades = if name == "Interval" {
            &["fixed"][..]
        } else {
            &[Fine::NAME, Coarse::NAME, Compact::NAME]
        };
        for grade in grades {
            let shaped =
                |label: &String| is(label) && (*grade == "fixed" || label.ends_with(grade));
            assert!(shapes.iter().any(shaped), "no shape of {name} {grade}");
            let listed = golden
                .iter()
                .any(|(label, tier)| is(label) && tier == grade);
            assert!(listed, "no golden bits of {name} {grade}");
        }
    }
}
