//! Sine and cosine of a phase in turns.

use super::product::{by_half, near, near_signed, square};
use super::tables::{SINE, entry};

/// The entries of the table in a quarter of a turn. The cosine is the sine so many entries later.
const QUARTER: u32 = 64;

/// (sin, cos) of a phase in Q32 turns, in Q30; on straight lines between the points of the table, so that
/// sin² + cos² is at most 1.
#[inline]
pub(in crate::fixed) fn coarse(phase: u32) -> (i32, i32) {
    let cell = phase >> 24;
    let part = (phase << 8 >> 17) as i32;
    let between = |cell| {
        let (from, to) = (entry(&SINE, cell), entry(&SINE, cell + 1));
        from + ((((to - from) >> 9) * part) >> 6)
    };
    (between(cell), between(cell + QUARTER))
}

/// (sin, cos) of a phase in Q32 turns, in Q30: the nearest point of the table, turned by the remaining angle.
#[inline]
pub(in crate::fixed) fn fine(phase: u32) -> (i32, i32) {
    /// Half a cell.
    const HALF: u32 = 1 << 23;
    /// From 2¹⁷ parts of a cell to radians in Q37. It is shortened by h²/8, where h is half a cell, which minimises the
    /// omitted cubic term.
    const RADIANS: i32 = 25_735;
    let cell = phase.wrapping_add(HALF) >> 24;
    let (sine, cosine) = (entry(&SINE, cell), entry(&SINE, cell + QUARTER));
    let angle = (((phase << 8) as i32 >> 15) * RADIANS + (1 << 15)) >> 16;
    // Half a step along the old direction, then the whole step along the new one: this includes the quadratic term.
    let (s, c) = (sine >> 14, cosine >> 14);
    let halfway_sine = s + ((c * angle) >> 22);
    let halfway_cosine = c - ((s * angle) >> 22);
    (
        sine + ((halfway_cosine * angle) >> 7),
        cosine - ((halfway_sine * angle) >> 7),
    )
}

/// The polynomial of sin(πx/4)/x in x², in Q32, with alternating signs.
const SINE_QUOTIENT: [u32; 3] = [3_373_242_552, 346_663_986, 10_424_342];
/// The polynomial of (1 − cos(πx/4))/x² in x², in Q32, with alternating signs.
const COSINE_QUOTIENT: [u32; 3] = [1_324_673_091, 68_076_938, 1_370_781];

/// (sin, cos) of a phase in Q32 turns, in Q30, without a table.
#[inline]
pub(in crate::fixed) fn compact(phase: u32) -> (i32, i32) {
    // The nearest quarter, and the rest, at most an eighth of a turn either way, in Q31 of an eighth.
    let quarter = phase.wrapping_add(1 << 29) >> 30;
    let part = (phase << 2) as i32;
    // In Q30, and its upper half, which is enough for all but the largest terms.
    let z = square(part.unsigned_abs());
    let head = z >> 14;
    let [s0, s1, s2] = SINE_QUOTIENT;
    let quotient = s0 - (near(s1 - by_half(s2, head), z) << 2);
    let sine = near_signed(quotient, part) >> 1;
    let [c1, c2, c3] = COSINE_QUOTIENT;
    let cosine = (1 << 30) - near(c1 - by_half(c2 - by_half(c3, head), head), z) as i32;
    match quarter {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}
