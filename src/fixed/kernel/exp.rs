//! Exponentials of negative numbers.

use super::product::{by_half, near};
use super::tables::{LN_2_32ND, POWER, entry};

/// The cell of x (Q27), and the rest in Q21: x = (32 k + j) ln 2/32 + rest, as (k, j, rest).
#[inline]
fn cell(x: u32) -> (u32, u32, i32) {
    /// 32/ln 2 in Q10. It only picks the cell and need not be exact.
    const CELLS: u32 = 47_274;
    let cell = ((x >> 16) * CELLS + (1 << 20)) >> 21;
    let rest = x.wrapping_sub(cell * LN_2_32ND) as i32;
    (cell >> 5, cell & 31, (rest + 32) >> 6)
}

/// A power of 2 in Q31, at most 1, shifted right and in Q32. 1 becomes the word below.
#[inline]
fn of_q31(power: u32, shift: u32) -> u32 {
    (power - (power >> 31)) >> shift << 1
}

/// e^−x, Q27 to Q32, to the linear term.
#[inline]
pub(in crate::fixed) fn coarse(x: u32) -> u32 {
    let (shift, part, rest) = cell(x);
    if shift > 31 {
        return 0;
    }
    let power = entry(&POWER, part);
    of_q31(
        power.wrapping_add_signed(-(((power >> 16) as i32 * rest) >> 5)),
        shift,
    )
}

/// e^−x, Q27 to Q32; 1 as the largest word.
#[inline]
pub(in crate::fixed) fn fine(x: u32) -> u32 {
    let (shift, part, rest) = cell(x);
    if shift > 31 {
        return 0;
    }
    let power = entry(&POWER, part);
    let top = (power >> 16) as i32;
    // Half a step by the old slope, then the whole step by the new one: this includes the quadratic term.
    let halfway = top - ((top * rest) >> 22);
    of_q31(power.wrapping_add_signed(-((halfway * rest) >> 5)), shift)
}

/// log₂ e − 1, in Q32.
const LOG2_E: u32 = 1_901_360_723;
/// The polynomial of (1 − 2^−f)/f for 0 ≤ f < 1, in Q32, with alternating signs.
const POWER_OF_2: [u32; 5] = [
    2_977_032_627,
    1_031_594_070,
    237_583_380,
    39_635_572,
    4_097_539,
];

/// e^−x, Q27 to Q32, without a table; 1 as the largest word.
#[inline]
pub(in crate::fixed) fn compact(x: u32) -> u32 {
    /// ln 2 in Q16.
    const LN_2: u32 = 45_426;
    // x log₂ e in Q26.
    let exponent = (x >> 1) + near(x >> 1, LOG2_E);
    let (shift, part) = (exponent >> 26, exponent << 6);
    if shift > 31 {
        return 0;
    }
    // The upper half of the part by the polynomial, the lower one by the derivative.
    let (head, tail) = (part >> 16, part & 0xffff);
    let [c0, c1, c2, c3, c4] = POWER_OF_2;
    let next = |sum, c| c - by_half(sum, head);
    let sum = next(next(next(next(c4, c3), c2), c1), c0);
    let power = !by_half(sum, head);
    (power - (((power >> 16) * ((tail * LN_2) >> 16)) >> 16)) >> shift
}

/// 1/8 in Q27. Below, take [`one_minus_small`].
pub(in crate::fixed) const SMALL: u32 = 1 << 24;

/// 1 − e^−x of x below 1/8 with any number of fraction bits from 22 on, to the relative precision of x.
#[inline]
pub(in crate::fixed) fn one_minus_small(x: u32, bits: u32) -> u32 {
    // x in Q19, with 16 bits, is x/2 in Q20. Then follow x/3 (1 − x/4) in Q18, and in Q20 x/2 (1 − x/3 (1 − x/4)), by
    // which (1 − e^−x)/x falls short of 1.
    let head = if bits > 50 { 0 } else { x >> (bits - 19) };
    let third = (head * 10_923) >> 16;
    let short = head - ((head * (third - ((third * head) >> 21))) >> 18);
    x - (by_half(x, short) >> 4)
}
