//! Compensated functions of products: they carry the rounding error of the product, which they would amplify.

use super::Tier;
use crate::num::{
    head, nearest_integer, pair, product, quick_two_sum, remainder, two_product, two_sum,
};
use core::f32::consts::{FRAC_1_PI, TAU};

/// `e^(ab)` for `ab <= 0`, without the error that rounding the product would bring.
#[inline]
pub(crate) fn exp_of_product<T: Tier>(a: f32, b: f32) -> f32 {
    let (product, dropped) = two_product(a, b);
    let power = T::exp(product);
    // Beyond this the power is 0 or subnormal, and the product may have overflowed.
    if product > -87.0 {
        power + power * dropped
    } else {
        power
    }
}

/// `scale · e^(ab)` for `ab <= 0`, without that error, even where the exponential alone would be subnormal.
#[inline]
pub(crate) fn scaled_exp_of_product<T: Tier>(scale: f32, a: f32, b: f32) -> f32 {
    let (product, dropped) = two_product(a, b);
    // Beyond this the result underflows for the largest scale, and the product may have overflowed.
    if product > -250.0 {
        scaled_exp::<T>(scale, product, dropped)
    } else {
        0.0
    }
}

/// `e^(ab) - 1`, without the error that rounding the product would bring.
#[inline]
pub(crate) fn exp_m1_of_product<T: Tier>(a: f32, b: f32) -> f32 {
    let (product, dropped) = two_product(a, b);
    let power = T::exp_m1(product);
    if product.abs() < 87.0 {
        power + (power + 1.0) * dropped
    } else {
        power
    }
}

/// 1/(2π) and the rounding error of its `f32`. The compiler computes them: no double reaches the target.
const TURN: f32 = 0.5 * FRAC_1_PI;
const REST: f32 = (0.5 * core::f64::consts::FRAC_1_PI - TURN as f64) as f32;

/// `1 - cos(x)` of an angle in `[0, π]` radians, to a few ulp however small the angle.
pub(crate) fn one_minus_cos_radians<T: Tier>(x: f32) -> f32 {
    if x < 1.0 {
        // Taylor's series. The first omitted term is below 2e-9.
        let (y, dropped) = two_product(x, x);
        let tail = 1.0 - y / 90.0 * (1.0 - y / 132.0);
        let bend = y / 12.0 * (1.0 - y / 30.0 * (1.0 - y / 56.0 * tail));
        let half = 0.5 * y;
        return half - (half * bend - 0.5 * dropped);
    }
    // Nothing cancels here, and the square of a sine would double its error.
    let (turn, dropped) = two_product(x, TURN);
    let (s, c) = T::sincos_turns(turn);
    1.0 - (c - s * TAU * (dropped + x * REST))
}

/// `scale · e^(exponent + rest)` where the exponential alone may leave the range of `f32`.
#[inline]
pub(crate) fn scaled_exp<T: Tier>(scale: f32, exponent: f32, rest: f32) -> f32 {
    let x = if exponent.abs() < 80.0 {
        scale * T::exp(exponent)
    } else {
        // A quarter of the exponent of any quotient of two floats is in range.
        let quarter = T::exp(0.25 * exponent);
        scale * quarter * quarter * quarter * quarter
    };
    x + x * rest
}

/// The rounding error of a logarithm `log` of `x`, to the accuracy of the tier's exponential: one step of Newton's method
/// on `e^log = x`.
fn log_residual<T: Tier>(x: f32, log: f32) -> f32 {
    // In two halves, since e^(-log) alone may overflow.
    let half = T::exp(-0.5 * log);
    let (product, dropped) = two_product(x * half, half);
    (product - 1.0) + dropped
}

/// ln(b/a) for 0 ≤ a < b, accurate however close or far apart the two are, and its rounding error.
pub(crate) fn ln_ratio<T: Tier>(a: f32, b: f32) -> (f32, f32) {
    /// 2⁶⁴.
    const POWER: f32 = 18_446_744_073_709_551_616.0;
    if a == 0.0 {
        return (f32::INFINITY, 0.0);
    }
    // The rounding errors of subnormal numbers have no digits of their own.
    let (a, b) = if a < f32::MIN_POSITIVE && b < 1.0 {
        (a * POWER, b * POWER)
    } else {
        (a, b)
    };
    if b < 2.0 * a {
        let (difference, base) = (b - a, a);
        let quotient = difference / base;
        let short = remainder(difference, quotient, base) / base;
        return (T::ln_1p(quotient), short / (1.0 + quotient));
    }
    let quotient = b / a;
    if (f32::MIN_POSITIVE..=f32::MAX).contains(&quotient) && a >= f32::MIN_POSITIVE {
        // Halved where the product of the quotient and a could overflow, which rounding may take above b.
        let half = if b > 1.0 { 0.5 } else { 1.0 };
        let short = remainder(half * b, quotient, half * a) / (half * b);
        let log = T::ln(quotient);
        return two_sum(log, log_residual::<T>(quotient, log) + short);
    }
    let (log_b, log_a) = (T::ln(b), T::ln(a));
    let (span, dropped) = two_sum(log_b, -log_a);
    let residuals = log_residual::<T>(b, log_b) - log_residual::<T>(a, log_a);
    two_sum(span, dropped + residuals)
}

/// S in −ln(near + away·e^(−z))/z = away·(1 − z·near·(½ − z·S)), near + away = 1, for |z| up to ½.
///
/// The left side is the cumulant generating function of a coin that shows 1 with probability `away`; S is
/// its series, whose coefficients are the cumulants in terms of p = near·away and d = near − away. The
/// terms left out, from the tenth cumulant's on, are below 1.2e-8 of the whole.
#[inline]
pub(crate) fn coin_series(z: f32, near: f32, away: f32) -> f32 {
    let (p, d) = (near * away, near - away);
    let ninth = d * (1.0 - p * (252.0 - p * (5040.0 - 20160.0 * p))) * (1.0 / 362_880.0);
    let eighth = (1.0 - p * (126.0 - p * (1680.0 - 5040.0 * p))) * (1.0 / 40_320.0) - z * ninth;
    let seventh = d * (1.0 - p * (60.0 - 360.0 * p)) * (1.0 / 5040.0) - z * eighth;
    let sixth = (1.0 - p * (30.0 - 120.0 * p)) * (1.0 / 720.0) - z * seventh;
    let fifth = d * (1.0 - 12.0 * p) * (1.0 / 120.0) - z * sixth;
    let fourth = (1.0 - 6.0 * p) * (1.0 / 24.0) - z * fifth;
    d * (1.0 / 6.0) - z * fourth
}

pub(crate) const LN_2: (f32, f32) = pair(core::f64::consts::LN_2);

/// log₂e as a head of 12 bits and the rest.
pub(crate) const LOG2_E: (f32, f32) = {
    let high = head(core::f32::consts::LOG2_E);
    (high, (core::f64::consts::LOG2_E - high as f64) as f32)
};

/// 1/8!, 1/7!, 1/6! and 1/5!.
const LAST_TERMS: [f32; 4] = [1.0 / 40_320.0, 1.0 / 5_040.0, 1.0 / 720.0, 1.0 / 120.0];

/// 1/24, 1/6, 1/2 and 1.
const FIRST_TERMS: [(f32, f32); 4] = [pair(1.0 / 24.0), pair(1.0 / 6.0), (0.5, 0.0), (1.0, 0.0)];

/// `(k, rise)` with `2^(x + rest) = 2^k (1 + rise)` and `rise` good to 2^-40 of itself; for x up to 2^22.
pub(crate) const fn exp2_m1((x, rest): (f32, f32)) -> (i32, (f32, f32)) {
    let (n, k) = nearest_integer(x);
    let y = product(two_sum(x - n, rest), LN_2);
    // Taylor's series of (e^y - 1)/y, whose first terms count for more than one float holds.
    let mut tail = 1.0 / 362_880.0;
    let mut terms: &[f32] = &LAST_TERMS;
    while let [term, more @ ..] = terms {
        tail = *term + y.0 * tail;
        terms = more;
    }
    let mut series = (tail, 0.0);
    let mut terms: &[(f32, f32)] = &FIRST_TERMS;
    while let [(term, term_rest), more @ ..] = terms {
        let (product, product_rest) = product(y, series);
        let (sum, dropped) = quick_two_sum(*term, product);
        series = (sum, dropped + (product_rest + *term_rest));
        terms = more;
    }
    (k, product(y, series))
}
