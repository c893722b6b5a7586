//! Each elementary function keeps the error that the documentation of its tier states.
//!
//! This file holds the errors; what is exact, and what happens at the ends of a domain and beyond, is in
//! modules of their own. The figures are read out of the tables in the doc comments of `Poly` and
//! `Libm`; measured errors must not exceed them, and in the full speed a figure more than a quarter above what is
//! measured fails too.
//! `MICROWARP_WRITE=1 cargo test --test tier` measures and writes them anew.

mod cases;
mod ends;
mod exact;
mod figures;
mod sweep;

use cases::{Case, Function, cases};
use figures::{Figures, Row, stated};
use host::parallel::{in_parallel, threads};
use host::speed;
use microwarp::tier::{Poly, Tier};
use sweep::Sweep;

const TIERS: [&str; 2] = ["libm", "poly"];

/// The figures of both tiers over one chunk of a sweep.
fn measure(case: &Case, sweep: Sweep, chunk: u32, stride: usize) -> [Figures; 2] {
    let mut figures = [Figures::default(); 2];
    sweep.for_each(chunk, stride, |input| {
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
    let chunks = in_parallel(threads(), &jobs, |&(i, sweep, chunk)| {
        measure(&cases[i], sweep, chunk, sweep.stride())
    });
    let mut measured = vec![[Figures::default(); 2]; cases.len()];
    for (&(i, ..), figures) in jobs.iter().zip(chunks) {
        for (sum, figures) in measured[i].iter_mut().zip(figures) {
            sum.join(figures);
        }
    }
    // A function's narrower domain stands before the wider one that it is part of.
    for i in 1..cases.len() {
        if cases[i].function == cases[i - 1].function {
            let narrower = measured[i - 1];
            for (sum, figures) in measured[i].iter_mut().zip(narrower) {
                sum.join(figures);
            }
        }
    }
    measured
}

#[test]
fn every_function_keeps_its_stated_error() {
    let cases = cases();
    let measured = measure_all(&cases);
    for (tier, name) in TIERS.iter().enumerate() {
        println!("{name}");
        let rows: Vec<Row> = cases
            .iter()
            .zip(&measured)
            .map(|(case, figures)| Row::stating(case.function, case.domain, figures[tier]))
            .collect();
        for (row, figures) in rows.iter().zip(&measured) {
            println!("{} {:?}", row.written().line(), figures[tier].worst);
        }
        if std::env::var_os("MICROWARP_WRITE").is_some() {
            figures::write(name, &rows);
        }
        let stated = stated(name);
        assert_eq!(stated.len(), cases.len(), "{name}: rows in the table");
        for ((case, figures), row) in cases.iter().zip(&measured).zip(&stated) {
            assert_eq!((&*row.function, &*row.domain), (case.function, case.domain));
            let figures = figures[tier];
            assert!(
                row.holds(figures) && (!speed::full() || row.agrees_with(figures)),
                "{name}: {row:?} against {figures:?}"
            );
        }
    }
}

/// What the project owes, whatever the tables say: ulp, absolute and relative error on every domain.
#[test]
fn the_owed_figures_are_stated() {
    const NONE: f64 = f64::INFINITY;
    let owed = [
        ("sqrt", "", [0.5, NONE, NONE]),
        ("sincos_turns", "", [NONE, 1.0e-7, NONE]),
        ("ln", "", [2.0, NONE, NONE]),
        ("ln", "2⁻²⁴ ≤ x ≤ 1", [2.0, 1.0e-6, NONE]),
        ("ln_1p", "", [2.0, NONE, NONE]),
        ("exp", "", [1.5, NONE, NONE]),
        ("exp_m1", "", [2.0, NONE, NONE]),
        ("pow", "", [2.0, NONE, NONE]),
        ("normal_cdf_lower", "", [NONE, NONE, 5.0e-7]),
        ("normal_quantile_lower", "", [5.5, NONE, 4.0e-7]),
    ];
    for tier in TIERS {
        let stated = stated(tier);
        for (function, domain, [ulp, absolute, relative]) in owed {
            let mut rows = stated
                .iter()
                .filter(|row| row.function == function && row.domain.contains(domain))
                .peekable();
            assert!(
                rows.peek().is_some(),
                "{tier}: no row for {function} {domain}"
            );
            for row in rows {
                let figures = [
                    (row.ulp, ulp),
                    (row.absolute, absolute),
                    (row.relative, relative),
                ];
                for (stated, owed) in figures {
                    let kept = owed == NONE || stated.is_some_and(|stated| stated <= owed);
                    assert!(kept, "{tier}: {row:?}");
                }
            }
        }
    }
}

/// A function's largest error over a case's sweeps, taken in place of the polynomial tier's.
fn error_of(function: &'static str, domain: &'static str, wrong: Function) -> (Row, Figures) {
    let mut case = cases()
        .into_iter()
        .find(|case| case.function == function && case.domain == domain)
        .unwrap();
    case.outputs.truncate(1);
    case.outputs[0].tiers[1] = wrong;
    let row = stated("poly")
        .into_iter()
        .find(|row| row.function == function && row.domain == domain);
    (row.unwrap(), measure(&case, case.sweeps[0], 7, 1)[1])
}

/// The measurement notices errors of the size it is there to find, and figures that hold but are stale.
#[test]
fn wrong_functions_and_stale_figures_are_noticed() {
    let turns = "0 ≤ t ≤ 1";
    let (row, figures) = error_of("sincos_turns", turns, |t, _| {
        // Sine, and with it 3e-6 of its cube.
        let s = Poly::sincos_turns(t).0;
        s + 3.0e-6 * s * s * s
    });
    assert!(
        !row.agrees_with(figures),
        "a coefficient off passes: {figures:?}"
    );
    let (row, figures) = error_of("ln", "x > 0", |x, _| {
        // The logarithm's leading bits read off the exponent and significand as they stand.
        (x.to_bits() as f32 / 8_388_608.0 - 127.0) * std::f32::consts::LN_2
    });
    assert!(!row.agrees_with(figures), "a bit trick passes: {figures:?}");
    let (row, figures) = error_of("ln", "x > 0", |x, _| {
        let y = Poly::ln(x);
        if x.to_bits() & 0xffff == 77 {
            f32::NAN
        } else {
            y
        }
    });
    assert!(
        figures.ulp == f64::INFINITY && !row.agrees_with(figures),
        "NaN passes"
    );
    let (row, figures) = error_of("ln", "x > 0", |x, _| Poly::ln(x).next_up().next_up());
    assert!(!row.agrees_with(figures), "two steps off pass: {figures:?}");
    let honest = Figures {
        ulp: 1.0,
        absolute: 1.0,
        ..Figures::default()
    };
    let mut row = Row::stating("ln", "x > 0", honest);
    assert!(row.agrees_with(honest));
    row.ulp = Some(0.99);
    assert!(
        !row.agrees_with(honest) && !row.holds(honest),
        "a broken figure passes"
    );
    row.ulp = Some(1.4);
    assert!(
        row.holds(honest) && !row.agrees_with(honest),
        "a stale figure passes"
    );
    row.ulp = None;
    assert!(!row.agrees_with(honest), "a missing figure passes");
}
