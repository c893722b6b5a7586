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

use crate::draws::figures;
use crate::series::{autoregression, unit};
use host::{speed, stats};
use microwarp::estimate::Moments;
use microwarp::metropolis::{Autocorrelation, Halves, split_r_hat};
use rand_pcg::Pcg32;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};
use std::sync::atomic::{AtomicUsize, Ordering};

/// No fewer than the p-values of what is right, which are counted as they come.
const P_VALUES: usize = 220;
static COUNTED: AtomicUsize = AtomicUsize::new(0);

pub fn assert_passes(what: &str, p_values: &[f64]) {
    let before = COUNTED.fetch_add(p_values.len(), Ordering::Relaxed);
    assert!(before + p_values.len() <= P_VALUES);
    stats::assert_passes(what, p_values, stats::threshold(P_VALUES));
}

pub fn assert_rejected(what: &str, p_values: &[f64]) {
    stats::assert_rejected(what, p_values, stats::threshold(P_VALUES));
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

// What `Draws` sees and split R̂ does not, and whether the error of a mean that is stated is the one that is made.

/// Chains of one mean, of which one is wider, and chains without a variance, of which one is apart.
#[test]
fn ranks_see_what_the_means_of_draws_do_not() {
    let mut rng = Pcg32::new(0xf01d, 54);
    let mut hats = |wide: f64| {
        let run = |k: usize, rng: &mut Pcg32| -> Vec<f32> {
            let scale = if k == 0 { wide } else { 1.0 };
            let run = autoregression(0.5, 2000, rng);
            run.iter().map(|x| (7.0 + scale * x) as f32).collect()
        };
        let runs: Vec<_> = (0..4).map(|k| run(k, &mut rng)).collect();
        // In fixed memory: the distance from a number near the median.
        let mut folds = [Halves::new(1000); 4];
        for (fold, run) in folds.iter_mut().zip(&runs) {
            run.iter().for_each(|x| fold.push((x - 7.0).abs()));
        }
        let [split, rank, folded, ..] = figures(&runs);
        [split, rank, folded, f64::from(split_r_hat(&folds).unwrap())]
    };
    let (equal, unequal) = (hats(1.0), hats(3.0));
    println!("spreads alike {equal:.3?}, unequal {unequal:.3?}");
    assert!(equal.iter().all(|r| *r < 1.01));
    assert!(unequal[0] < 1.01 && unequal[1..].iter().all(|r| *r > 1.1));
    let cauchy = |rng: &mut Pcg32| (std::f64::consts::PI * (unit(rng) - 0.5)).tan();
    let mut apart = |by: f64| {
        let run = |k: usize, rng: &mut Pcg32| -> Vec<f32> {
            let shift = if k == 0 { by } else { 0.0 };
            (0..2000).map(|_| (shift + cauchy(rng)) as f32).collect()
        };
        figures(&(0..4).map(|k| run(k, &mut rng)).collect::<Vec<_>>())
    };
    let (equal, unequal) = (apart(0.0), apart(2.0));
    println!("heavy tails alike {equal:.3?}, apart {unequal:.3?}");
    assert!(equal[1] < 1.01 && unequal[0] < 1.01 && unequal[1] > 1.05);
}

/// The error of a mean that is stated is the one that is made, of independent draws and of dependent ones.
#[test]
fn the_standard_error_is_that_of_the_mean() {
    let mut rng = Pcg32::new(0x5e, 54);
    let (runs, n) = (speed::of("runs", 400, 2000), 500);
    for rho in [0.0, 0.8] {
        let (mut squares, mut lost) = ([0.0; 3], 0);
        for _ in 0..runs {
            let run: Vec<f32> =
                (autoregression(rho, n, &mut rng).iter().map(|&x| x as f32)).collect();
            let mean = run.iter().map(|&x| f64::from(x)).sum::<f64>() / n as f64;
            let mut health = Autocorrelation::<99>::new();
            let mut naive = Moments::new();
            for &x in &run {
                health.push(x);
                naive.push(x);
            }
            // The definition in the one run, of its own effective size.
            let Some(size) = health.effective_sample_size() else {
                lost += 1;
                continue;
            };
            let streamed = health.standard_error().unwrap();
            let product = f64::from(naive.std_dev().unwrap()) / f64::from(size).sqrt();
            assert!((f64::from(streamed) / product - 1.0).abs() < 1e-6);
            let errors = [
                figures(&[run])[6],
                f64::from(streamed),
                f64::from(naive.standard_error().unwrap()),
            ];
            for (square, error) in squares.iter_mut().zip(errors) {
                *square += (mean / error).powi(2);
            }
        }
        assert!(lost * 20 <= runs, "{lost}");
        let squares = squares.map(|square| square / f64::from(runs - lost));
        println!("ρ = {rho}: mean square of an error beside the stated {squares:.2?}");
        // A mean of squares of about normal numbers: 7 of its deviations, and some bias of the sizes.
        let limit = 7.0 * (2.0 / f64::from(runs)).sqrt() + 0.2;
        assert!(
            squares[..2]
                .iter()
                .all(|square| (square - 1.0).abs() < limit)
        );
        // What takes them for independent is found out.
        assert!(
            rho == 0.0 || (squares[2] - 1.0).abs() > limit,
            "{squares:?}"
        );
    }
}
