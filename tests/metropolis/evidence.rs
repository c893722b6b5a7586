//! The evidence for and against a chain: counts of correlated states, judged without assuming that they are
//! independent.
//!
//! # The statistic
//! Many batches are run that share nothing: each has its own chain, its own generator and its own start. The
//! shares of a batch in the cells are a vector, and the vectors of the batches are independent and alike,
//! whatever the correlation along a chain and whether plain states or weights were recorded. If the chain is
//! right, and the start forgotten or drawn from the target itself, their expectation is the vector of the
//! exact probabilities. Hotelling's T² asks just this, with the covariance that the batches themselves
//! show; for normal vectors its law is that of F, exactly, and the mean of hundreds of vectors is normal
//! enough. (`targets` calibrates it.) It is the chi-square test at the effective sample size, with the
//! effective sample size of every contrast between cells measured instead of assumed.
//!
//! Besides, states many autocorrelation times apart are all but independent: for them Pearson's chi-square
//! holds as it is, in more cells.

use crate::{flaws, long, start, targets};
use host::stats;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

/// The p-value below which a test rejects, of as many as the files judged here compute.
pub fn threshold() -> f64 {
    let computed = targets::P_VALUES + flaws::P_VALUES + long::P_VALUES + start::P_VALUES;
    stats::threshold(computed)
}

pub fn assert_passes(what: &str, p_values: &[f64]) {
    stats::assert_passes(what, p_values, threshold());
}

pub fn assert_rejected(what: &str, p_values: &[f64]) {
    stats::assert_rejected(what, p_values, threshold());
}

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

/// The p-value of a mean of independent numbers against the exact one, by their own spread.
pub fn p_value_of_mean(sum: f64, squares: f64, count: f64, exact: f64) -> f64 {
    let mean = sum / count;
    let variance = (squares / count - mean * mean) / (count - 1.0);
    stats::two_sided((mean - exact) / variance.sqrt())
}
