//! Logarithms.

use super::product::{by_half, near};
pub(in crate::fixed) use super::tables::LN_2;
use super::tables::{LOG, entry};

/// A number in Q32, shifted left to at least 1/2, and the shift. 0 stays, with a shift of at most 32.
#[inline]
fn normal(x: u32) -> (u32, u32) {
    on_this_core!(normal_on(x))
}

#[inline]
fn normal_on<const NARROW: bool>(x: u32) -> (u32, u32) {
    if NARROW {
        let (mut m, mut shift) = (x, 0);
        while m >> 31 == 0 && shift < 32 {
            m <<= 1;
            shift += 1;
        }
        (m, shift)
    } else {
        let shift = (x | 1).leading_zeros();
        (x << shift, shift)
    }
}

/// −ln(1 − u), Q32 to Q27, on a straight line between the points of the table; the fall of its cell; and the part of the
/// cell passed. Not for 0.
#[inline]
fn line(u: u32) -> (u32, u32, u32) {
    let (m, shift) = normal(u.wrapping_neg());
    // The leading bit is always set, since the table begins at 1/2.
    let cell = m << 1 >> 26;
    let (from, to) = (entry(&LOG, cell), entry(&LOG, cell + 1));
    let fall = (from - to) >> 5;
    let part = m << 7 >> 16;
    (from + shift * LN_2 - ((fall * part) >> 11), fall, part)
}

/// −ln(1 − u), Q32 to Q27, on a straight line between the points of a table.
#[inline]
pub(in crate::fixed) fn coarse(u: u32) -> u32 {
    if u == 0 { 0 } else { line(u).0 }
}

/// −ln(1 − u), Q32 to Q27.
#[inline]
pub(in crate::fixed) fn fine(u: u32) -> u32 {
    if u == 0 {
        return 0;
    }
    let (straight, fall, part) = line(u);
    // The curve hangs below its chord by half the squared fall of the cell, times the parts of the cell on either side.
    let sides = (part * (0xffff - part)) >> 16;
    straight - ((((fall * fall) >> 16) * sides) >> 18)
}

/// √2 − 1, in Q32.
const ROOT_2: u32 = 1_779_033_704;
/// The polynomial of −ln(1 − v)/v for 0 < v ≤ 1 − 1/√2, in Q31.
const LOG_QUOTIENT: [u32; 5] = [
    2_147_532_449,
    1_071_494_029,
    749_036_532,
    328_956_451,
    975_209_819,
];

/// −ln(1 − u), Q32 to Q27, without a table.
#[inline]
pub(in crate::fixed) fn compact(u: u32) -> u32 {
    if u == 0 {
        return 0;
    }
    let (mut m, shift) = normal(u.wrapping_neg());
    let mut whole = shift * LN_2;
    let widened = m.wrapping_add(near(m, ROOT_2));
    // Without a carry it stays below 1.
    if widened > m {
        m = widened;
        whole += LN_2 >> 1;
    }
    let rest = m.wrapping_neg();
    // The upper half by the polynomial, the lower one by the derivative, 1/(1 − v).
    let (head, tail) = (rest >> 16, rest & 0xffff);
    let [c0, c1, c2, c3, c4] = LOG_QUOTIENT;
    let next = |sum, c| c + by_half(sum, head);
    let sum = next(next(next(next(c4, c3), c2), c1), c0);
    let square = (head * head) >> 16;
    let steeper = (tail * (head + square + (square >> 2))) >> 16;
    whole + (by_half(sum, head) >> 4) + ((tail + steeper) >> 5)
}

/// 2⁻⁸ in Q32. Below, take [`small`] for relative precision.
pub(in crate::fixed) const SMALL: u32 = 1 << 24;

/// −ln(1 − u) of u below 2⁻⁸, Q32 to Q39, to the relative precision of u.
#[inline]
pub(in crate::fixed) fn small(u: u32) -> u32 {
    (u << 7) + (by_half(u << 7, excess(u >> 8)) >> 8)
}

/// The relative excess of −ln(1 − u) over u below 2⁻⁸, u/2 + u²/3. Argument and result are in Q24.
#[inline]
pub(in crate::fixed) fn excess(head: u32) -> u32 {
    (head >> 1) + ((((head * head) >> 16) * 85) >> 16)
}

/// The relative excess of −ln(1 − a) over a below 1/8, a/2 + a²/3 + …. Argument and result are in Q32.
#[inline]
pub(in crate::fixed) fn excess_of_eighth(a: u32) -> u32 {
    /// 1/3, 1/4, …, in Q16.
    const TERMS: [u32; 5] = [21_845, 16_384, 13_107, 10_923, 9_362];
    // In Q19, 16 bits.
    let head = a >> 13;
    let [c0, c1, c2, c3, c4] = TERMS;
    let next = |sum, c| c + ((head * sum) >> 19);
    let sum = next(next(next(next(c4, c3), c2), c1), c0);
    near(a, (1 << 31) + ((head * sum) >> 3))
}

/// −ln(1 − u) of u from [`SMALL`] to 1/8, Q32 to Q34, to the relative precision of u.
#[inline]
pub(in crate::fixed) fn eighth(u: u32) -> u32 {
    (u << 2) + near(u << 2, excess_of_eighth(u))
}
