//! The reference tier: `f32` in, `f32` out, the `libm` crate inside.

use super::{Tier, normal, poly};

/// The reference tier: the elementary functions of the `libm` crate.
///
/// Phases in turns are reduced exactly before `libm` sees them. Its sine, cosine and power run on
/// `f64` inside, which is slow where doubles are software; [`Poly`](super::Poly) is the tier for
/// microcontrollers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Libm;

impl Tier for Libm {
    const NAME: &'static str = "libm";

    #[inline]
    fn sincos_turns(t: f32) -> (f32, f32) {
        let (quadrant, r) = poly::reduce_turns(t);
        let x = r * core::f32::consts::FRAC_PI_2;
        let (s, c) = ::libm::sincosf(x);
        poly::swap_quadrant(quadrant, s, c)
    }

    #[inline]
    fn atan2_turns(y: f32, x: f32) -> f32 {
        let turns = ::libm::atan2f(y, x) * (0.5 * core::f32::consts::FRAC_1_PI);
        if turns.is_nan() { 0.0 } else { turns }
    }

    #[inline]
    fn ln(x: f32) -> f32 {
        ::libm::logf(x)
    }

    #[inline]
    fn ln_1p(x: f32) -> f32 {
        ::libm::log1pf(x)
    }

    #[inline]
    fn exp(x: f32) -> f32 {
        ::libm::expf(x)
    }

    #[inline]
    fn exp_m1(x: f32) -> f32 {
        ::libm::expm1f(x)
    }

    #[inline]
    fn pow(x: f32, y: f32) -> f32 {
        ::libm::powf(x, y)
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
