//! Functions of a product whose rounding would be amplified: the product's own error is carried along.

use super::Tier;
use core::f32::consts::{FRAC_1_PI, TAU};

/// The upper half of the significand and the rest; both have at most 12 bits and their sum is `x`.
#[inline]
fn split(x: f32) -> (f32, f32) {
    let high = f32::from_bits(x.to_bits() & 0xffff_f000);
    (high, x - high)
}

/// `a * b` rounded, and what the rounding dropped: exact unless the product over- or underflows.
#[inline]
pub(crate) fn two_product(a: f32, b: f32) -> (f32, f32) {
    let product = a * b;
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    let dropped = ((a1 * b1 - product) + a1 * b0 + a0 * b1) + a0 * b0;
    (product, dropped)
}

/// `e^(ab)` for `ab <= 0`, without the error that rounding the product would bring.
#[inline]
pub(crate) fn exp_of_product<T: Tier>(a: f32, b: f32) -> f32 {
    let (product, dropped) = two_product(a, b);
    let power = T::exp(product);
    // Far out the power is 0 or subnormal and the product may have overflowed: nothing to correct.
    if product > -87.0 {
        power + power * dropped
    } else {
        power
    }
}

/// `1 - cos(x)` of an angle in `[0, π]` radians, to a few ulp however small the angle.
pub(crate) fn one_minus_cos_radians<T: Tier>(x: f32) -> f32 {
    const QUARTER: f32 = 0.25 * FRAC_1_PI;
    // What QUARTER lacks of 1/(4π); worked out by the compiler, no double reaches the target.
    const REST: f32 = (0.25 * core::f64::consts::FRAC_1_PI - QUARTER as f64) as f32;
    let (turn, dropped) = two_product(x, QUARTER);
    let (s, c) = T::sincos_turns(turn);
    let sine = s + c * TAU * (dropped + x * REST);
    2.0 * sine * sine
}

/// `(x/r)^n` for positive x and r, without the error that rounding the quotient would bring.
#[inline]
pub(crate) fn pow_of_quotient<T: Tier>(x: f32, r: f32, n: f32) -> f32 {
    let quotient = x / r;
    if !(f32::MIN_POSITIVE..=f32::MAX).contains(&quotient) {
        // Fourth roots bring any quotient of two floats into range; only a small |n| leaves the power
        // there, so the fourfold exponent costs no accuracy that shows.
        let (x, r) = (T::sqrt(T::sqrt(x)), T::sqrt(T::sqrt(r)));
        return T::pow(x / r, 4.0 * n);
    }
    let (back, dropped) = two_product(quotient, r);
    let short = ((x - back) - dropped) / x;
    let power = T::pow(quotient, n);
    // Where n times the shortfall is not small the power itself is 0 or infinite.
    let correction = n * short;
    if correction.abs() < 0.125 {
        power + power * correction
    } else {
        power
    }
}
