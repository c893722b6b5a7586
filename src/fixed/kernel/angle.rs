//! The angle of a point.

use super::tables::ROTATION;

/// The angle of the point (x, y) in Q32 turns, by so many CORDIC rotations, each of which halves the remaining angle. 0 at
/// the origin, exact on the axes.
#[inline]
pub(in crate::fixed) fn vectoring(y: i32, x: i32, rotations: usize) -> u32 {
    let (along, across) = (x.unsigned_abs(), y.unsigned_abs());
    let (wide, narrow) = if across > along {
        (across, along)
    } else {
        (along, across)
    };
    let (wide, narrow) = scaled(wide, narrow);
    let first = rotated(wide, narrow, rotations);
    // From the first eighth of the turn to the others, by mirrors.
    let quarter = if across > along {
        (1_u32 << 30).wrapping_sub(first)
    } else {
        first
    };
    let half = if x < 0 {
        (1_u32 << 31).wrapping_sub(quarter)
    } else {
        quarter
    };
    if y < 0 { half.wrapping_neg() } else { half }
}

/// Both numbers times a power of two that brings the larger one into [2²⁶, 2³⁰); 0 stays.
#[inline]
fn scaled(wide: u32, narrow: u32) -> (i32, i32) {
    let (mut wide, mut narrow) = (wide, narrow);
    for _ in 0..7 {
        if wide >> 28 == 0 {
            wide <<= 4;
            narrow <<= 4;
        }
    }
    ((wide >> 2) as i32, (narrow >> 2) as i32)
}

/// The angle of a point of the first eighth.
#[inline]
fn rotated(wide: i32, narrow: i32, rotations: usize) -> u32 {
    let (mut x, mut y, mut angle, mut shift) = (wide, narrow, 0_u32, 0);
    for turn in ROTATION.iter().take(rotations) {
        shift += 1;
        let (dx, dy) = (y >> shift, x >> shift);
        if y == 0 {
            break;
        }
        if y > 0 {
            (x, y, angle) = (x + dx, y - dy, angle.wrapping_add(*turn));
        } else {
            (x, y, angle) = (x - dx, y + dy, angle.wrapping_sub(*turn));
        }
    }
    angle
}
