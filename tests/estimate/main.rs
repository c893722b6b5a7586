//! Estimators: the figures they state, the identities they must keep, and that their errors are what they say.
//!
//! Every statistical assertion allows seven standard errors, a false alarm in 4e11, and stands beside a wrong estimator that
//! it rejects.

mod extremes;
mod heuristics;
mod identities;
mod integrals;
mod limits;
mod long;
mod short;
mod techniques;
mod weighted_mean;

use host::docs::{Doc, assert_stated};
use microwarp::estimate::{Moments, WeightedMean};

/// Standard errors that a correct estimator may be off.
const Z: f64 = 7.0;

/// Whether an error is at most so much; one that is NaN is not.
fn at_most(error: f64, most: f64) -> bool {
    error <= most
}

fn relative(got: Option<f32>, exact: f64) -> f64 {
    host::errors::relative(got.unwrap().into(), exact)
}

// How a long run is measured: against exact sums, at checkpoints.

/// Exact sums in integers: between 512 and 2048 every f32 is a multiple of 2⁻¹⁴.
#[derive(Default)]
pub struct Exact {
    count: i128,
    sum: i64,
    squares: i128,
}

impl Exact {
    const UNIT: f32 = 16_384.0;

    pub fn push(&mut self, x: f32) {
        assert!((512.0..2048.0).contains(&x), "{x}");
        let steps = (x * Self::UNIT) as i64 - 1000 * Self::UNIT as i64;
        self.count += 1;
        self.sum += steps;
        self.squares += i128::from(steps * steps);
    }

    fn mean_and_variance(&self) -> (f64, f64) {
        let unit = f64::from(Self::UNIT);
        let sum = i128::from(self.sum);
        let squares = (self.squares * self.count - sum * sum) as f64;
        let pairs = (self.count * (self.count - 1)) as f64;
        let mean = 1000.0 + self.sum as f64 / self.count as f64 / unit;
        (mean, squares / pairs / (unit * unit))
    }
}

/// Relative errors of a mean and a variance.
pub fn errors(mean: Option<f32>, variance: Option<f32>, exact: &Exact) -> [f64; 2] {
    let (exact_mean, exact_variance) = exact.mean_and_variance();
    [
        relative(mean, exact_mean),
        relative(variance, exact_variance),
    ]
}

/// The largest errors at the checkpoints of a run, from a hundredth of it on: a single one may be lucky.
#[derive(Clone, Copy, Default)]
pub struct Largest([f64; 2]);

impl Largest {
    fn take(&mut self, errors: [f64; 2]) {
        for (largest, error) in self.0.iter_mut().zip(errors) {
            assert!(!error.is_nan());
            *largest = largest.max(error);
        }
    }

    pub fn moments(&mut self, moments: &Moments, exact: &Exact) {
        assert_eq!(i128::from(moments.count()), exact.count);
        self.take(errors(moments.mean(), moments.variance(), exact));
    }

    pub fn ratio(&mut self, ratio: &WeightedMean, exact: [f64; 2]) {
        let [estimate, error] = exact;
        self.take([
            relative(ratio.mean(), estimate),
            relative(ratio.standard_error(), error),
        ]);
    }

    /// Holds the errors to those that an estimator states in a column of two rows.
    pub fn assert_stated(&self, estimator: &str, rows: [&str; 2], column: usize) {
        let doc = Doc::of("estimate", estimator);
        for (row, measured) in rows.into_iter().zip(self.0) {
            assert_stated(row, measured, doc.figure(row, column));
        }
    }
}
