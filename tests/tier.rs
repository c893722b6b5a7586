//! Each elementary function keeps the error that the documentation of its tier states.
//!
//! The figures are read out of the tables in the doc comments of `Poly` and `Libm`; measured errors must
//! not exceed them, and a figure more than a quarter above what is measured fails too.
//! `MICROWARP_WRITE=1 cargo test --test tier` measures and writes them anew.

#[path = "tier/cases.rs"]
mod cases;
#[path = "tier/figures.rs"]
mod figures;
#[path = "tier/sweep.rs"]
mod sweep;

use cases::{Case, Function, cases};
use figures::{Figures, Row, agrees, rounded_up, rows, source};
use microwarp::tier::{Libm, Poly, Tier};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use sweep::{EDGES, Sweep};

const TIERS: [&str; 2] = ["libm", "poly"];

/// Runs jobs 0..count on as many threads as there are cores.
fn in_parallel(count: usize, job: impl Fn(usize) + Sync) {
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(2, usize::from) {
            scope.spawn(|| {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    if i >= count {
                        break;
                    }
                    job(i);
                }
            });
        }
    });
}

/// The figures of both tiers over one chunk of a sweep.
fn measure(case: &Case, sweep: Sweep, chunk: u32) -> [Figures; 2] {
    let mut figures = [Figures::default(); 2];
    sweep.for_each(chunk, |input| {
        if !(case.within)(input) {
            return;
        }
        for output in &case.outputs {
            let truth = (output.truth)(f64::from(input.0), f64::from(input.1));
            for (figures, function) in figures.iter_mut().zip(&output.tiers) {
                figures.observe(input, function(input.0, input.1), truth);
            }
        }
    });
    figures
}

fn measure_all(cases: &[Case]) -> Vec<[Figures; 2]> {
    let jobs: Vec<(usize, Sweep, u32)> = cases
        .iter()
        .enumerate()
        .flat_map(|(i, case)| case.sweeps.iter().map(move |&sweep| (i, sweep)))
        .flat_map(|(i, sweep)| (0..sweep.chunks()).map(move |chunk| (i, sweep, chunk)))
        .collect();
    let measured = Mutex::new(vec![[Figures::default(); 2]; cases.len()]);
    in_parallel(jobs.len(), |job| {
        let (i, sweep, chunk) = jobs[job];
        let figures = measure(&cases[i], sweep, chunk);
        let mut measured = measured.lock().unwrap();
        for (sum, figures) in measured[i].iter_mut().zip(figures) {
            sum.join(figures);
        }
    });
    measured.into_inner().unwrap()
}

/// Ulp say nothing of a difference from 1, and absolute errors nothing of unbounded results.
fn worth_stating(case: &Case, figures: Figures) -> (Option<f64>, Option<f64>) {
    let ulp = (!case.function.contains('²')).then_some(figures.ulp);
    (ulp, (figures.absolute < 1.0e-4).then_some(figures.absolute))
}

fn table(cases: &[Case], measured: &[[Figures; 2]], tier: usize) -> Vec<String> {
    let mut lines = vec![
        "/// | function | domain | max ulp | max absolute |".to_owned(),
        "/// |---|---|--:|--:|".to_owned(),
    ];
    lines.extend(cases.iter().zip(measured).map(|(case, figures)| {
        let (ulp, absolute) = worth_stating(case, figures[tier]);
        let ulp = ulp.map_or("-".to_owned(), |x| format!("{}", rounded_up(x)));
        let absolute = absolute.map_or("-".to_owned(), |x| format!("{:e}", rounded_up(x)));
        format!(
            "/// | `{}` | {} | {ulp} | {absolute} |",
            case.function, case.domain
        )
    }));
    lines
}

/// Replaces the table in a tier's documentation.
fn write(tier: usize, lines: &[String]) {
    let path = source(TIERS[tier]);
    let text = std::fs::read_to_string(&path).unwrap();
    let mut kept: Vec<&str> = text.lines().collect();
    let is_table = |line: &&str| line.starts_with("/// |");
    let start = kept.iter().position(is_table).unwrap();
    kept.retain(|line| !line.starts_with("/// |"));
    for (i, line) in lines.iter().enumerate() {
        kept.insert(start + i, line);
    }
    std::fs::write(path, kept.join("\n") + "\n").unwrap();
}

#[test]
fn every_function_keeps_its_stated_error() {
    let cases = cases();
    let measured = measure_all(&cases);
    for (tier, name) in TIERS.iter().enumerate() {
        let lines = table(&cases, &measured, tier);
        println!("{name}");
        for (line, figures) in lines[2..].iter().zip(&measured) {
            println!("{line} at {:?}", figures[tier].worst);
        }
        if std::env::var_os("MICROWARP_WRITE").is_some() {
            write(tier, &lines);
        }
        let stated = rows(&std::fs::read_to_string(source(name)).unwrap());
        assert_eq!(stated.len(), cases.len(), "{name}: rows in the table");
        for ((case, figures), row) in cases.iter().zip(&measured).zip(&stated) {
            assert_eq!((&*row.function, &*row.domain), (case.function, case.domain));
            let (ulp, absolute) = worth_stating(case, figures[tier]);
            assert!(
                holds(row, ulp, absolute),
                "{name}: {row:?} against {:?}",
                figures[tier]
            );
        }
    }
}

fn holds(row: &Row, ulp: Option<f64>, absolute: Option<f64>) -> bool {
    let same = |stated: Option<f64>, measured: Option<f64>, slack| {
        stated.is_some() == measured.is_some()
            && agrees(stated, measured.unwrap_or(f64::NAN), slack)
    };
    same(row.ulp, ulp, 0.05) && same(row.absolute, absolute, 1.0e-9)
}

/// The figures that the crate owes, whatever the tables say.
#[test]
fn the_owed_figures_are_stated() {
    let owed = [
        ("libm", "sincos_turns", None, Some(1.0e-7)),
        ("poly", "sincos_turns", None, Some(1.1e-7)),
        ("libm", "ln", Some(2.0), None),
        ("poly", "ln", Some(2.0), None),
        ("poly", "ln_1p", Some(2.0), None),
        ("poly", "exp", Some(1.5), None),
        ("poly", "exp_m1", Some(2.0), None),
        ("poly", "pow", Some(2.0), None),
        ("libm", "sqrt", Some(0.5), None),
        ("poly", "sqrt", Some(0.5), None),
        ("libm", "normal_quantile_lower", Some(5.5), None),
        ("poly", "normal_quantile_lower", Some(5.5), None),
    ];
    for (tier, function, ulp, absolute) in owed {
        let stated = rows(&std::fs::read_to_string(source(tier)).unwrap());
        let mut found = 0;
        for row in stated.iter().filter(|row| row.function == function) {
            let within = |owed: Option<f64>, stated: Option<f64>| {
                owed.is_none_or(|owed| stated.is_some_and(|stated| stated <= owed))
            };
            assert!(
                within(ulp, row.ulp) && within(absolute, row.absolute),
                "{tier}: {row:?}"
            );
            found += 1;
        }
        assert!(found > 0, "{tier}: no row for {function}");
    }
    for tier in TIERS {
        let stated = rows(&std::fs::read_to_string(source(tier)).unwrap());
        let ln = stated
            .iter()
            .find(|row| row.function == "ln" && row.domain.contains('≤'));
        let absolute = ln.and_then(|row| row.absolute);
        assert!(
            absolute.is_some_and(|stated| stated <= 1.0e-6),
            "{tier}: ln on the grid"
        );
    }
}
