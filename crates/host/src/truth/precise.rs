//! The truths in 237 bits, where what doubles cancel is still there.

mod real;

use ::f256::consts;
pub use real::{Real, erf, erfc, ln_gamma, real, to_f64};

pub const PI: Real = Real::of(consts::PI);
pub const TAU: Real = Real::of(consts::TAU);
pub const FRAC_1_PI: Real = Real::of(consts::FRAC_1_PI);
pub const FRAC_1_SQRT_2: Real = Real::of(consts::FRAC_1_SQRT_2);

#[path = "all.rs"]
mod all;
pub use all::*;
