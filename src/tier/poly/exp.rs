//! Exponentials of the polynomial tier, and the pieces of them that a power needs.

use super::log::power_of_two_times;
use core::f32::consts::LOG2_E;

/// `(e^r - 1 - r)/r²` in powers of r; see `EXPONENTIAL` in `tests/derivation`.
const EXPONENTIAL: [f32; 5] = [
    0.499_999_94,
    0.166_665_15,
    0.041_668_084,
    0.008_369_35,
    0.001_384_042_9,
];

/// ln 2 in two parts, the first of 12 bits; see `LN_2` in `tests/derivation`.
pub(super) const LN_2: [f32; 2] = [0.693_115_23, 3.194_618_3e-5];

/// The integer nearest to `x`, `|x| <= 2^22`: as `f32` and as an integer.
#[inline]
#[allow(
    clippy::cast_possible_wrap,
    reason = "the low bits are a signed integer"
)]
pub(in crate::tier) fn nearest(x: f32) -> (f32, i32) {
    // Adding 1.5·2^23 leaves no bits below the unit, and the integer stands in the last bits.
    const ROUND: f32 = 12_582_912.0;
    let shifted = x + ROUND;
    let integer = shifted.to_bits().wrapping_sub(ROUND.to_bits()) as i32;
    (shifted - ROUND, integer)
}

/// `e^r - 1 - r` for `|r| <= ln(2)/2`.
#[inline]
pub(super) fn beyond_linear(r: f32) -> f32 {
    let [e0, e1, e2, e3, e4] = EXPONENTIAL;
    r * r * (e0 + r * (e1 + r * (e2 + r * (e3 + r * e4))))
}

/// `(k, a, b)` with `e^x = 2^k (1 + a + b)`, where a is exact and b small.
#[inline]
fn reduced(x: f32) -> (i32, f32, f32) {
    let (n, k) = nearest(x * LOG2_E);
    let [high, low] = LN_2;
    let a = x - n * high;
    let rest = n * low;
    (k, a, beyond_linear(a - rest) - rest)
}

/// `x·2^k` for x near 1 and `|k| <= 252`, rounded once where it is subnormal.
#[cold]
pub(super) fn scaled(x: f32, k: i32) -> f32 {
    let half = k >> 1;
    let first = power_of_two_times(1.0, half);
    let second = power_of_two_times(1.0, k.wrapping_sub(half));
    x * first * second
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
        scaled(1.0 + (a + b), k)
    }
}

/// `e^x - 1`.
#[inline]
pub(super) fn exp_m1(x: f32) -> f32 {
    if x > -18.0 && x < 88.0 {
        let (k, a, b) = reduced(x);
        let power = power_of_two_times(1.0, k);
        // The power's product is exact, so that nothing steps back where a + b does not.
        power * (a + b) + (power - 1.0)
    } else if x < 0.0 {
        // e^-18 is less than half of the spacing below 1.
        -1.0
    } else {
        exp(x)
    }
}

/// `(e^-x, 1 - e^-x)` for `0 <= x <= 87`, from one series and without a branch.
#[inline]
pub(super) fn exp_neg_pair(x: f32) -> (f32, f32) {
    let (k, a, b) = reduced(-x);
    let power = power_of_two_times(1.0, k);
    // Exact, as in the functions above.
    let part = power * (a + b);
    (power + part, (1.0 - power) - part)
}
