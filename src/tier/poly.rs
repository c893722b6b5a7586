//! The polynomial tier: `f32` arithmetic only. (Being written.)

use super::{Tier, normal};

/// The polynomial tier: `f32` arithmetic only, no `f64`, no tables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Poly;

/// Quadrant and remainder `r` in quarter turns, `|r| <= 1/2`, exact.
#[inline]
pub(crate) fn reduce_turns(t: f32) -> (u32, f32) {
    const ROUND: f32 = 12_582_912.0; // 1.5 * 2^23: adding it rounds to an integer
    let t = if t.abs() < 1_048_576.0 { t } else { 0.0 };
    let x = 4.0 * t;
    let shifted = x + ROUND;
    (shifted.to_bits(), x - (shifted - ROUND))
}

/// Carries sine and cosine of the remainder into the quadrant.
#[inline]
pub(crate) fn swap_quadrant(quadrant: u32, s: f32, c: f32) -> (f32, f32) {
    match quadrant & 3 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

impl Tier for Poly {
    const NAME: &'static str = "poly";

    fn sincos_turns(t: f32) -> (f32, f32) {
        super::Libm::sincos_turns(t)
    }
    fn atan2_turns(y: f32, x: f32) -> f32 {
        super::Libm::atan2_turns(y, x)
    }
    fn ln(x: f32) -> f32 {
        ::libm::logf(x)
    }
    fn ln_1p(x: f32) -> f32 {
        ::libm::log1pf(x)
    }
    fn exp(x: f32) -> f32 {
        ::libm::expf(x)
    }
    fn exp_m1(x: f32) -> f32 {
        ::libm::expm1f(x)
    }
    fn pow(x: f32, y: f32) -> f32 {
        ::libm::powf(x, y)
    }
    fn normal_cdf_lower(x: f32) -> f32 {
        normal::cdf_lower::<Self>(x)
    }
    fn normal_quantile_lower(p: f32) -> f32 {
        normal::quantile_lower::<Self>(p)
    }
}
