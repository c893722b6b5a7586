//! Estimators: the figures they state, the identities they must keep, and that their errors are what they say.
//!
//! Here live what the parts share: figures read from the documentation, and f64 truths. Every statistical
//! assertion allows seven standard errors, a false alarm in 4e11, and stands beside a wrong estimator that it
//! rejects.

mod checkpoints;
mod coverage;
mod extremes;
mod heuristics;
mod identities;
mod importance;
mod integrals;
mod limits;
mod long;
mod ratio;
mod short;

/// The sources whose documentation states figures.
const MOMENTS: &str = include_str!("../../src/estimate/moments.rs");
const RATIO: &str = include_str!("../../src/estimate/ratio.rs");

/// Standard errors that a correct estimator may be off.
const Z: f64 = 7.0;

/// Whether an error is at most so much; one that is NaN is not.
fn at_most(error: f64, most: f64) -> bool {
    error <= most
}

/// A figure from the table of a source's documentation, by the head of its row and its column.
fn stated(source: &str, row: &str, column: usize) -> f64 {
    let mut rows = source
        .lines()
        .filter_map(|line| line.strip_prefix("/// | "))
        .filter(|line| line.starts_with(row));
    let figures = rows.next().unwrap();
    assert!(rows.next().is_none(), "two rows {row}");
    let figure = figures.split('|').nth(column).unwrap();
    figure.trim().parse().unwrap()
}

/// Holds a measured error to the one stated, and the statement to being no more than twice what is measured.
fn assert_stated(what: &str, measured: f64, stated: f64) {
    println!("{what}: {measured:.2e} measured, {stated:.2e} stated");
    assert!(
        measured <= stated,
        "{what}: {measured:e} against {stated:e}"
    );
    // Of fewer samples the largest errors are smaller.
    let fresh = !support::speed::full() || stated <= 2.0 * measured;
    assert!(fresh, "{what}: {measured:e}, {stated:e} is stale");
}

/// Mean and unbiased variance of numbers, in two passes.
fn truth(samples: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let n = samples.clone().count() as f64;
    let mean = samples.clone().sum::<f64>() / n;
    // The mean's own rounding leaves a residue, which is taken off.
    let (squares, residue) = samples.fold((0.0, 0.0), |(squares, residue), x| {
        (squares + (x - mean) * (x - mean), residue + (x - mean))
    });
    (
        mean + residue / n,
        (squares - residue * residue / n) / (n - 1.0),
    )
}

fn relative(got: Option<f32>, exact: f64) -> f64 {
    let got = f64::from(got.unwrap());
    if got == exact {
        0.0
    } else {
        (got - exact).abs() / exact.abs()
    }
}
