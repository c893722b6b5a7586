//! Every kernel keeps the errors that the documentation of the grades states.
//!
//! The figures are read out of the table in the doc comment of `Grade`; what is measured must not exceed them, and
//! a figure a quarter above what is measured fails too, a largest error in the full speed only.
//! `MICROWARP_WRITE=1 MICROWARP_FULL=all cargo test --test fixed stated` measures over all words and writes them anew.

use super::cases::{Case, GRADES, cases};
use super::figures::{Errors, Figures, Row, figures, stated, write};
use super::inputs::edges;
use host::speed;

/// The errors of a case in each grade.
pub fn measure(case: &Case, edges: &[u32]) -> [Errors; 3] {
    let step = |errors: &mut [Errors; 3], word: u32| {
        if !(case.within)(word) {
            return;
        }
        let truth = (case.truth)(word);
        for (errors, function) in errors.iter_mut().zip(case.grades) {
            for (got, truth) in function(word).into_iter().zip(truth) {
                // The second of two numbers where there is only one.
                if got.is_nan() && truth.is_nan() {
                    continue;
                }
                let error = got - truth;
                let turned = if case.turns {
                    error - error.round()
                } else {
                    error
                };
                errors.observe(word, turned);
            }
        }
    };
    let mut parts = case.words.fold(case.name, edges, Default::default, step);
    let at_edges = parts.pop().unwrap();
    let mut sum = [Errors::default(); 3];
    for part in &parts {
        sum.iter_mut()
            .zip(part)
            .for_each(|(sum, part)| sum.join(part));
    }
    sum.iter_mut()
        .zip(&at_edges)
        .for_each(|(sum, part)| sum.join_extreme(part));
    sum
}

#[test]
fn every_kernel_keeps_its_stated_errors() {
    let edges = edges();
    let mut rows: Vec<Row> = Vec::new();
    for case in cases() {
        let errors = measure(&case, &edges);
        for (errors, grade) in errors.iter().zip(GRADES) {
            let Figures { max, rms, mean } = figures(errors);
            let worst = errors.at;
            println!(
                "{:24} {grade:8} {max:.3e} (at {worst:#010x}), {rms:.3e}, {mean:+.2e}",
                case.name
            );
        }
        rows.push((case.name.to_owned(), errors.each_ref().map(figures)));
    }
    if std::env::var_os("MICROWARP_WRITE").is_some() {
        write(&rows);
    }
    let stated = stated();
    let names = |rows: &[Row]| rows.iter().map(|row| row.0.clone()).collect::<Vec<_>>();
    assert_eq!(names(&stated), names(&rows));
    for ((name, stated), (_, measured)) in stated.iter().zip(&rows) {
        for ((stated, measured), grade) in stated.iter().zip(measured).zip(GRADES) {
            assert!(
                stated.agree_with(*measured, speed::full()),
                "{name} {grade}: stated {stated:?}, measured {measured:?}"
            );
        }
    }
}

/// What the grades promise, whatever the table says: 1e-6 of `Fine` and `Compact`, 1e-4 of `Coarse`.
#[test]
fn the_owed_figures_are_stated() {
    let owed = |name: &str| !name.contains("y = 2") && !name.contains("y = 50");
    let mut seen = 0;
    for (name, figures) in stated().iter().filter(|row| owed(&row.0)) {
        for (figures, owed) in figures.iter().zip([1.0e-6, 1.0e-4, 1.0e-6]) {
            assert!(figures.max <= owed, "{name}: {figures:?}");
        }
        seen += 1;
    }
    assert_eq!(seen, 9);
}

/// The proof that nothing overflows stands on this.
#[test]
fn overflow_panics_in_this_build() {
    let largest = std::hint::black_box(u32::MAX);
    let sum = std::panic::catch_unwind(|| largest + 1);
    assert!(sum.is_err(), "overflow checks are off");
    // The same for the crate, since no profile and no exception for a package has a switch of its own.
    let manifest = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"));
    let manifest = manifest.unwrap();
    for switch in ["overflow-checks", "debug-assertions"] {
        assert!(!manifest.contains(switch), "{switch}");
    }
}
