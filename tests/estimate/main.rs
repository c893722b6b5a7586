//! Estimators: the figures they state, the identities they must keep, and that their errors are what they say.
//!
//! Here live what the parts share: `f64` truths. Every statistical
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
mod roulette;
mod short;
mod techniques;
mod weighted_mean;

/// Standard errors that a correct estimator may be off.
const Z: f64 = 7.0;

/// Whether an error is at most so much; one that is NaN is not.
fn at_most(error: f64, most: f64) -> bool {
    error <= most
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
    host::errors::relative(got.unwrap().into(), exact)
}
