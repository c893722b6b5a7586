//! The standard normal distribution's lower tail and its quantile, over the functions of a tier.

use super::Tier;

/// Placeholder until the derived fits arrive.
pub(crate) fn cdf_lower<T: Tier>(x: f32) -> f32 {
    0.5 * ::libm::erfcf(-x * core::f32::consts::FRAC_1_SQRT_2)
}

/// Placeholder until the derived fits arrive.
pub(crate) fn quantile_lower<T: Tier>(p: f32) -> f32 {
    -T::sqrt(-2.0 * T::ln(p))
}
