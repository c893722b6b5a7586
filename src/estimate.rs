//! Estimators: means, variances and integrals from samples, with their errors.
//!
//! The estimators run in fixed memory and can be merged. They draw no samples themselves: you pass in values and
//! densities.
//!
//! | you have | take |
//! |---|---|
//! | plain samples | [`Moments`]: mean, variance, standard error |
//! | samples of a known density, and an integrand | [`Integral`]: estimate, standard error, bounds |
//! | weighted samples, or a density known up to a factor | [`WeightedMean`]: mean, standard error |
//! | two densities that sample one integrand | [`balance_heuristic`] or [`power_heuristic`] |
//! | three or more | [`balance_heuristic_of`] or [`power_heuristic_of`] |
//! | a path that may end, or goes on with more weight | [`roulette`] |
//! | the states of a chain | [`Autocorrelation`](crate::metropolis::Autocorrelation), since they depend on each other |
//!
//! # Promises
//!
//! - Results are as accurate after 10⁸ samples as after ten: sums are held in two floats, about a centre that follows
//!   the mean, on a scale that follows the largest sample.
//! - A sample that is NaN or infinite is refused and counted, and changes nothing else.
//! - An unknown result, such as the variance of one sample, is [`None`]. A result beyond `f32` is its largest finite
//!   value. No result is infinite or NaN.

mod heuristic;
mod integral;
mod moments;
mod roulette;
mod sum;
mod tally;
mod weighted_mean;

pub use self::heuristic::{
    balance_heuristic, balance_heuristic_of, power_heuristic, power_heuristic_of,
};
pub use self::integral::Integral;
pub use self::moments::Moments;
pub use self::roulette::roulette;
pub(crate) use self::sum::{Scale, Sum};
pub(crate) use self::tally::Tally;
pub use self::weighted_mean::WeightedMean;
