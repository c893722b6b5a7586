//! Estimators: what a run of samples says about a mean, a variance or an integral, and how surely.
//!
//! Here live the running estimators, in fixed memory and mergeable, and the weights that combine sampling
//! techniques. Nothing here draws a sample or knows a warp: values and densities are handed in.
//!
//! # Promises
//! - After 10⁸ samples the figures are as good as after ten: sums are carried in two floats, about a centre
//!   that follows the mean, on a scale that follows the largest sample.
//! - A sample that is no number is refused and counted, and leaves no trace otherwise.
//! - What is not known is [`None`] (a mean of nothing, a variance of one sample); what does not fit `f32`
//!   is its largest finite value. No result is infinite or NaN.

mod heuristic;
mod integral;
mod moments;
mod sum;
mod tally;
mod weighted_mean;

pub use self::heuristic::{balance_heuristic, power_heuristic};
pub use self::integral::Integral;
pub use self::moments::Moments;
pub(crate) use self::sum::{Scale, Sum};
pub(crate) use self::tally::Tally;
pub use self::weighted_mean::WeightedMean;
