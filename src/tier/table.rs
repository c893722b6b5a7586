//! Logarithms and powers of 2 by small tables, for warps on the line: short chains of operations, and the digits of a whole
//! word. Both tiers share this file.
//!
//! A logarithm is a whole number and a rest, whose relative error is below 2e-7 also where their sum is small: the whole
//! number is 0 on both sides of 1.

use crate::num::doubles::{exp, ln};
use crate::num::{Scaled, float, nearest_integer, power_of_two, power_of_two_times};
use core::f64::consts::{LN_2, LOG2_E};

/// The cells of a table from 1 to 2.
const CELLS: usize = 64;

/// A fraction of 32 bits from which on a number counts as one below the next power of 2: 26.5/64.
const CARRY: u32 = 0x6a00_0000;

/// For each c from 1 to 2: log₂e/c in units of the last of 32 fractional bits, and -log₂c, or 1 - log₂c from [`CARRY`] on.
#[allow(
    clippy::indexing_slicing,
    reason = "the compiler evaluates it, and a panic would stop the build"
)]
static LOG: [(f32, f32); CELLS + 1] = {
    let mut table = [(0.0, 0.0); CELLS + 1];
    let mut i = 0;
    while i <= CELLS {
        let c = 1.0 + i as f64 / CELLS as f64;
        // What ln takes is at most 1.
        let log = if i < 27 { ln(1.0 / c) } else { -ln(0.5 * c) };
        table[i] = ((LOG2_E / c / 4_294_967_296.0) as f32, (log * LOG2_E) as f32);
        i += 1;
    }
    table
};

/// 2^(i/64).
#[allow(
    clippy::indexing_slicing,
    reason = "the compiler evaluates it, and a panic would stop the build"
)]
static EXP: [f32; CELLS] = {
    let mut table = [0.0; CELLS];
    let mut i = 0;
    while i < CELLS {
        table[i] = exp(LN_2 * i as f64 / CELLS as f64) as f32;
        i += 1;
    }
    table
};

/// The cell that a fraction of 32 bits is nearest to.
#[inline]
const fn cell(fraction: u32) -> u32 {
    (fraction >> 25).wrapping_add(1) >> 1
}

/// What [`LOG`] has for a cell.
#[inline]
fn of_cell(cell: u32) -> (f32, f32) {
    LOG.get(cell as usize).copied().unwrap_or_default()
}

/// What is left of -log₂ of a number h·ln 2 away from its cell, relatively, whose own is `log`.
#[inline]
fn beside(log: f32, h: f32) -> f32 {
    const SQUARE: f32 = (-0.5 * LN_2) as f32;
    const CUBE: f32 = (LN_2 * LN_2 / 3.0) as f32;
    (log - h) - h * h * (SQUARE + CUBE * h)
}

/// -log₂ of 1 and this fraction of 32 bits, less 1 from [`CARRY`] on, with a conversion to floats.
#[inline]
#[expect(clippy::cast_possible_wrap, reason = "a distance with its sign")]
fn neg_log2_of(fraction: u32, float: impl Fn(i32) -> f32) -> f32 {
    let cell = cell(fraction);
    let (slope, log) = of_cell(cell);
    let distance = fraction.wrapping_sub(cell << 26) as i32;
    beside(log, float(distance) * slope)
}

/// -log₂(1 - u) of the middle u of a word's cell, of all its digits: a whole number and a rest.
#[inline]
pub(crate) fn neg_log2_1m_of_word(word: u32) -> (f32, f32) {
    neg_log2_1m_by(word, |n| n as f32)
}

/// The same for what is followed by a long chain of operations.
#[inline]
pub(crate) fn neg_log2_1m_of_word_ahead(word: u32) -> (f32, f32) {
    neg_log2_1m_by(word, float)
}

#[inline]
#[expect(clippy::cast_possible_wrap, reason = "at most 33")]
fn neg_log2_1m_by(word: u32, float: impl Fn(i32) -> f32 + Copy) -> (f32, f32) {
    // 1 - u is 2·left + 1 in units of 2⁻³³.
    let left = !word;
    let zeros = left.leading_zeros();
    // Of the number without its leading 1. Where only that is left, masking the shift makes a fraction of 2⁻³² of 0.
    let fraction = (left << 1 | 1).wrapping_shl(zeros);
    let whole = zeros.wrapping_add(u32::from(fraction < CARRY));
    (float(whole as i32), neg_log2_of(fraction, float))
}

/// -log₂(1 - u) of a uniform in [0, 1): a whole number and a rest.
#[inline]
pub(crate) fn neg_log2_1m(u: f32) -> (f32, f32) {
    let bits = (1.0 - u).to_bits();
    let fraction = bits << 9;
    // From 1 to 25: the leading 1 of 1 - u is below this power of 2.
    let exponent = 127_u32.wrapping_sub(bits >> 23);
    let cell = cell(fraction);
    let (slope, log) = of_cell(cell);
    // The cell itself and the distance from there are exact, where 1 - u may not be.
    let scale = power_of_two(0_i32.wrapping_sub_unsigned(exponent));
    let distance = (1.0 - scale * (1.0 + cell as f32 / CELLS as f32)) - u;
    let h = distance * (slope * power_of_two(32_i32.wrapping_add_unsigned(exponent)));
    let whole = exponent.wrapping_sub(u32::from(fraction >= CARRY));
    (whole as f32, beside(log, h))
}

/// log₂ of a positive normal number: a whole number and a rest.
#[inline]
#[expect(clippy::cast_possible_wrap, reason = "an exponent has a sign")]
pub(crate) fn log2(x: f32) -> (f32, f32) {
    let bits = x.to_bits();
    let whole = (bits.wrapping_sub(0x3f00_0000 | CARRY >> 9) as i32) >> 23;
    (whole as f32, -neg_log2_of(bits << 9, |n| n as f32))
}

/// 2^((exact + small)/64) times a number, for sums up to 2²²: what overflows is the largest number.
#[inline]
pub(crate) fn times_exp2(number: Scaled, exact: f32, small: f32) -> f32 {
    const STEP: f64 = LN_2 / CELLS as f64;
    // The series of the exponential. A part of the cube, r/8 for r³, is in the first term: half of its error for r up to 1/2.
    const FIRST: f32 = (STEP + STEP * STEP * STEP / 48.0) as f32;
    const SECOND: f32 = (0.5 * STEP * STEP) as f32;
    let (nearest, n) = nearest_integer(exact + small);
    let r = (exact - nearest) + small;
    let root = EXP.get((n & 63) as usize).copied().unwrap_or_default();
    let power = root + root * (r * (FIRST + r * SECOND));
    let (significand, exponent) = number.parts();
    // From below 1 to 4.
    let product = power * significand;
    let exponent = exponent.wrapping_add(n >> 6);
    if (-125..=125).contains(&exponent) {
        power_of_two_times(product, exponent)
    } else {
        far(product, exponent)
    }
}

#[cold]
fn far(product: f32, exponent: i32) -> f32 {
    let x = Scaled::of(product).raised(exponent).value();
    if x < f32::MAX { x } else { f32::MAX }
}
