//! The truths in doubles, which the tests use.

pub use libm::{erf, erfc};
pub use statrs::function::gamma::ln_gamma;
pub use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2, PI, TAU};

pub type Real = f64;

/// A number that is written in the text.
pub const fn real(x: f64) -> Real {
    x
}

/// The double of a number.
pub const fn to_f64(x: Real) -> f64 {
    x
}

#[path = "all.rs"]
mod all;
#[path = "charts.rs"]
mod charts;
pub use all::*;
pub use charts::*;
