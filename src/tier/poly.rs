//! The polynomial tier: `f32` arithmetic only, in a fixed order of exactly rounded operations.
//!
//! Here stand the tier and what it states; the functions are in the modules below, and every
//! coefficient in them is derived by `tests/derivation.rs`.

mod exp;
mod log;
mod pow;
mod trig;

use super::{Tier, normal};
pub(crate) use trig::{reduce_turns, swap_quadrant};

/// The polynomial tier: `f32` arithmetic only, no `f64`, no tables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Poly;

impl Tier for Poly {
    const NAME: &'static str = "poly";

    #[inline]
    fn sincos_turns(t: f32) -> (f32, f32) {
        trig::sincos_turns(t)
    }

    #[inline]
    fn atan2_turns(y: f32, x: f32) -> f32 {
        trig::atan2_turns(y, x)
    }

    #[inline]
    fn ln(x: f32) -> f32 {
        log::ln(x)
    }

    #[inline]
    fn ln_1p(x: f32) -> f32 {
        log::ln_1p(x)
    }

    #[inline]
    fn exp(x: f32) -> f32 {
        exp::exp(x)
    }

    #[inline]
    fn exp_m1(x: f32) -> f32 {
        exp::exp_m1(x)
    }

    #[inline]
    fn pow(x: f32, y: f32) -> f32 {
        pow::pow(x, y)
    }

    #[inline]
    fn normal_cdf_lower(x: f32) -> f32 {
        normal::cdf_lower::<Self>(x)
    }

    #[inline]
    fn normal_quantile_lower(p: f32) -> f32 {
        normal::quantile_lower::<Self>(p)
    }
}
