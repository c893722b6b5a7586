//! The logarithm and the power of 2 by tables of `src/tier/table.rs`, operation by operation; the tables themselves are made by
//! the functions of the host.

use std::f64::consts::LN_2;
use std::sync::LazyLock;

static EXP: LazyLock<[f32; 64]> =
    LazyLock::new(|| std::array::from_fn(|i| (i as f64 / 64.0).exp2() as f32));
static LOG: LazyLock<[(f32, f32); 65]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let c = 1.0 + i as f64 / 64.0;
        let slope = 1.0 / (c * LN_2) / 4_294_967_296.0;
        let log = if i < 27 { -c.log2() } else { 1.0 - c.log2() };
        (slope as f32, log as f32)
    })
});

/// 2^((64k + i + r)/64)/2ᵏ.
pub fn power(i: usize, r: f32) -> f32 {
    const STEP: f64 = LN_2 / 64.0;
    const FIRST: f32 = (STEP + STEP * STEP * STEP / 48.0) as f32;
    const SECOND: f32 = (0.5 * STEP * STEP) as f32;
    let root = EXP[i];
    root + root * (r * (FIRST + r * SECOND))
}

/// A number from 1 to 2 times 2^((exact + small)/64), without the whole power of 2.
pub fn times_exp2(significand: f32, exact: f32, small: f32) -> (f32, i32) {
    let nearest = (exact + small).round_ties_even();
    let r = (exact - nearest) + small;
    let n = nearest as i32;
    (power((n & 63) as usize, r) * significand, n >> 6)
}

/// -log₂ of a number near a cell of the table: h·ln 2 beside it, relatively.
fn beside(log: f32, h: f32) -> f32 {
    const SQUARE: f32 = (-0.5 * LN_2) as f32;
    const CUBE: f32 = (LN_2 * LN_2 / 3.0) as f32;
    (log - h) - h * h * (SQUARE + CUBE * h)
}

/// -log₂(1 - u) of a uniform: a whole number and a rest.
pub fn log_of_uniform(u: f32) -> (f32, f32) {
    let bits = (1.0 - u).to_bits();
    let (fraction, exponent) = (bits << 9, 127 - (bits >> 23) as i32);
    let cell = ((fraction >> 25) + 1) >> 1;
    let (slope, log) = LOG[cell as usize];
    let scale = 0.5_f32.powi(exponent);
    let distance = (1.0 - scale * (1.0 + cell as f32 / 64.0)) - u;
    let h = distance * (slope * 2.0_f32.powi(32 + exponent));
    let whole = exponent - i32::from(fraction >= 0x6a00_0000);
    (whole as f32, beside(log, h))
}

/// The same of the middle of a word.
pub fn log_of_word(word: u32) -> (f32, f32) {
    let left = !word;
    let zeros = left.leading_zeros();
    let fraction = (left << 1 | 1).wrapping_shl(zeros);
    let cell = ((fraction >> 25) + 1) >> 1;
    let (slope, log) = LOG[cell as usize];
    let distance = fraction.wrapping_sub(cell << 26) as i32;
    let whole = zeros + u32::from(fraction < 0x6a00_0000);
    (whole as f32, beside(log, distance as f32 * slope))
}
