//! Exponentials of the polynomial tier. Their series is in `tier/power.rs`.

use crate::num::{ldexp, nearest_integer, power_of_two_times};
use crate::tier::power::{LN_2, beyond_linear};
use core::f32::consts::LOG2_E;

/// `(k, a, b)` with `e^x = 2^k (1 + a + b)`, where a is exact and b small.
#[inline]
fn reduced(x: f32) -> (i32, f32, f32) {
    let (n, k) = nearest_integer(x * LOG2_E);
    let [high, low] = LN_2;
    let a = x - n * high;
    let rest = n * low;
    (k, a, beyond_linear(a - rest) - rest)
}

/// `e^x`.
#[inline]
pub(super) fn exp(x: f32) -> f32 {
    if x.abs() < 87.0 {
        let (k, a, b) = reduced(x);
        power_of_two_times(1.0 + (a + b), k)
    } else {
        exp_edge(x)
    }
}

#[cold]
fn exp_edge(x: f32) -> f32 {
    if x > 89.0 {
        f32::INFINITY
    } else if x < -104.0 {
        0.0
    } else if x.is_nan() {
        x
    } else {
        let (k, a, b) = reduced(x);
        ldexp(1.0 + (a + b), k)
    }
}

/// `e^x - 1`.
#[inline]
pub(super) fn exp_m1(x: f32) -> f32 {
    if x > -18.0 && x < 88.0 {
        let (k, a, b) = reduced(x);
        let power = power_of_two_times(1.0, k);
        // The product with the power is exact, so that the result increases where a + b does.
        power * (a + b) + (power - 1.0)
    } else if x < 0.0 {
        // e^-18 is less than half of the spacing below 1.
        -1.0
    } else {
        exp(x)
    }
}

/// `(e^-x, 1 - e^-x)` for `0 <= x <= 87`, from one series, without a branch.
#[inline]
pub(super) fn exp_neg_pair(x: f32) -> (f32, f32) {
    let (k, a, b) = reduced(-x);
    let power = power_of_two_times(1.0, k);
    // Exact, as in the functions above.
    let part = power * (a + b);
    (power + part, (1.0 - power) - part)
}
