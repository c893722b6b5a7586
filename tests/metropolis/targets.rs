//! Continuous targets: every chain has the distribution that it should, in plain states and in weighted ones. The counts of
//! correlated states are judged without assuming that they are independent.
//!
//! # The statistic
//! Many batches are run that share nothing: each has its own chain, its own generator and its own start. The
//! shares of a batch in the cells are a vector, and the vectors of the batches are independent and alike,
//! whatever the correlation along a chain and whether plain states or weights were recorded. If the chain is
//! right, and the start forgotten or drawn from the target itself, their expectation is the vector of the
//! exact probabilities. Hotelling's T² asks just this, with the covariance that the batches themselves
//! show; for normal vectors its law is that of F, exactly, and the mean of hundreds of vectors is normal
//! enough. (`p_values_of_right_chains_are_uniform` calibrates it.) It is the chi-square test at the effective sample
//! size, with the effective sample size of every contrast between cells measured instead of assumed.

use crate::runs::{Outcome, Plan, plan};
use crate::subjects;
use host::speed;
use host::stats::{Family, p_value_of_uniforms};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

/// What is judged of chains.
pub static FAMILY: Family = Family::of(80);

/// The p-value of Hotelling's T² of the batches' shares in the cells against the exact probabilities.
///
/// The last cell is left out, since the shares sum to 1. Cells that do not vary, or only as others do, make
/// a p-value of 0: a right chain has none.
pub fn hotelling(batches: &[Vec<f64>], exact: &[f64]) -> f64 {
    let (k, d) = (batches.len(), exact.len() - 1);
    assert!(k > 4 * d, "{k} batches for {d} cells");
    let mean: Vec<f64> = (0..d)
        .map(|c| batches.iter().map(|b| b[c]).sum::<f64>() / k as f64)
        .collect();
    let covariance = |a: usize, b: usize| {
        let products = batches.iter().map(|x| (x[a] - mean[a]) * (x[b] - mean[b]));
        products.sum::<f64>() / (k - 1) as f64
    };
    // By Cholesky: T² = k |y|², where L y is the deviation and L Lᵀ the covariance.
    let mut lower = vec![vec![0.0; d]; d];
    let mut squares = 0.0;
    let mut y = vec![0.0; d];
    for row in 0..d {
        for column in 0..row {
            let inner: f64 = (0..column).map(|i| lower[row][i] * lower[column][i]).sum();
            lower[row][column] = (covariance(row, column) - inner) / lower[column][column];
        }
        let variance = covariance(row, row);
        let pivot = variance - lower[row].iter().map(|x| x * x).sum::<f64>();
        // Written so that NaN returns as well.
        let some = pivot > 1e-12 * variance;
        if !some {
            return 0.0;
        }
        lower[row][row] = pivot.sqrt();
        let inner: f64 = (0..row).map(|i| lower[row][i] * y[i]).sum();
        y[row] = (mean[row] - exact[row] - inner) / lower[row][row];
        squares += y[row] * y[row];
    }
    let (k, d) = (k as f64, d as f64);
    let f = k * squares * (k - d) / (d * (k - 1.0));
    FisherSnedecor::new(d, k - d).unwrap().sf(f)
}

#[test]
fn chains_have_the_distribution_of_their_target() {
    for (subject, seed) in subjects::all().into_iter().zip(500..) {
        let (Plan { batches, steps, .. }, outcome) = (subject.plan, subject.run(seed));
        let accepted = outcome.accepted;
        println!(
            "{}: {batches} batches of {steps} steps, accepted {accepted:.3}",
            subject.name
        );
        FAMILY.assert_passes(subject.name, &outcome.p_values);
    }
}

/// The p-values of many seeds are uniform, for batches shorter than those that are judged.
#[test]
fn p_values_of_right_chains_are_uniform() {
    let short = Plan {
        steps: 600,
        burn_in: 200,
        ..plan()
    };
    let all = subjects::all();
    let subject = all.iter().find(|s| s.name == "parabola, nine to one");
    let subject = subject.unwrap();
    let seeds = speed::of("seeds", 50, 150);
    let runs: Vec<Outcome> = (0..seeds)
        .map(|i| subject.run_by(&short, 9000 + i))
        .collect();
    let of = |way: usize| -> Vec<f64> { runs.iter().map(|o| o.p_values[way]).collect() };
    for (way, name) in ["plain", "weighted"].into_iter().enumerate() {
        let p_values = of(way);
        let below = |bound: f64| p_values.iter().filter(|p| **p < bound).count();
        println!(
            "{name}: {} below 0.5, {} below 0.05",
            below(0.5),
            below(0.05)
        );
        FAMILY.assert_passes(name, &[p_value_of_uniforms(&mut p_values.clone())]);
    }
    // The control: as if every state were independent of the one before.
    let mut naive: Vec<f64> = runs.iter().map(|outcome| outcome.naive).collect();
    FAMILY.assert_rejected("correlated states", &[p_value_of_uniforms(&mut naive)]);
}
