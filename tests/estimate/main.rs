//! Estimators: the figures they state, the identities they must keep, and that their errors are what they say.
//!
//! Every statistical assertion allows seven standard errors, a false alarm in 4e11, and stands beside a wrong estimator that
//! it rejects.

mod checkpoints;
mod extremes;
mod heuristics;
mod identities;
mod integrals;
mod limits;
mod long;
mod short;
mod techniques;
mod weighted_mean;

/// Standard errors that a correct estimator may be off.
const Z: f64 = 7.0;

/// Whether an error is at most so much; one that is NaN is not.
fn at_most(error: f64, most: f64) -> bool {
    error <= most
}

fn relative(got: Option<f32>, exact: f64) -> f64 {
    host::errors::relative(got.unwrap().into(), exact)
}
