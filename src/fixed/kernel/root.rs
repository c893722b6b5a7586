//! Square roots.

use super::product::by_half;
use super::tables::{ROOT, entry};

/// A positive number in Q32, shifted left to at least 1/4, and half the shift; `None` for 0.
#[inline]
fn normal(x: u32) -> Option<(u32, u32)> {
    on_this_core!(normal_on(x))
}

#[inline]
fn normal_on<const NARROW: bool>(x: u32) -> Option<(u32, u32)> {
    if NARROW {
        let (mut m, mut shift) = (x, 0);
        loop {
            // The test of the result itself shows the compiler that it is inside the table.
            if m >> 30 != 0 {
                return Some((m, shift));
            }
            if shift == 15 {
                return None;
            }
            m <<= 2;
            shift += 1;
        }
    } else {
        let shift = (x | 1).leading_zeros() >> 1;
        let m = x << (2 * shift);
        (m >> 30 != 0).then_some((m, shift))
    }
}

/// For 1/4 ≤ m < 1: the entry of the table below (Q16), the rise to the next entry, and the part of the way from one to
/// the other (Q16).
#[inline]
fn cell(m: u32) -> (u32, u32, u32) {
    let cell = m >> 24;
    let (from, to) = (
        u32::from(entry(&ROOT, cell)),
        u32::from(entry(&ROOT, cell + 1)),
    );
    (from, to - from, m << 8 >> 16)
}

/// The square root, Q32 to Q32, on straight lines between the points of a table.
#[inline]
pub(in crate::fixed) fn coarse(x: u32) -> u32 {
    let Some((m, shift)) = normal(x) else {
        return 0;
    };
    let (from, rise, part) = cell(m);
    ((from << 16) + rise * part) >> shift
}

/// The square root, Q32 to Q32.
#[inline]
pub(in crate::fixed) fn fine(x: u32) -> u32 {
    let Some((m, shift)) = normal(x) else {
        return 0;
    };
    let (from, rise, part) = cell(m);
    let root = from + ((rise * part) >> 16);
    // A Newton step: the table rises by 1/(2√m) a cell, to 8 bits.
    let rest = m - root * root;
    ((root << 16) + ((rest * rise) >> 8)) >> shift
}

/// The polynomial of 1/√m for 1/4 ≤ m < 1, in Q14, with alternating signs.
const INVERSE_ROOT: [u32; 3] = [43_759, 53_827, 26_846];

/// The square root, Q32 to Q32, without a table.
#[inline]
pub(in crate::fixed) fn compact(x: u32) -> u32 {
    let Some((m, shift)) = normal(x) else {
        return 0;
    };
    let head = m >> 16;
    let [r0, r1, r2] = INVERSE_ROOT;
    // 1/√m in Q14, to 2.4 %. A Newton step makes it Q15, to 0.09 %.
    let inverse = r0 - ((head * (r1 - ((head * r2) >> 16))) >> 16);
    let excess = 3 * (1 << 15) - ((((inverse * inverse) >> 14) * head) >> 15);
    let inverse = (inverse * excess) >> 15;
    // √m in Q31, the shortfall of its square in Q30, and two terms of the series for the correction.
    let root = by_half(m, inverse);
    let rest = (1 << 30) - by_half(root, inverse) as i32;
    let short = rest >> 10;
    let correction = (rest >> 5) + ((3 * short * short) >> 17);
    let root = root.wrapping_add_signed(((root >> 16) as i32 * correction) >> 10);
    (if root >> 31 == 0 { root << 1 } else { u32::MAX }) >> shift
}
