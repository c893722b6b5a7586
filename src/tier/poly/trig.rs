//! Sine, cosine and arctangent of angles in turns, of the polynomial tier.

use crate::tier::turns::{reduce_turns, swap_quadrant};

/// `sin(2πr)/r` in powers of r²; see `SINE` in `tests/derivation`.
#[allow(
    clippy::approx_constant,
    reason = "fitted: the first is near 2π, not equal to it"
)]
const SINE: [f32; 4] = [6.283_185, -41.341_51, 81.572_04, -74.629_94];

/// `(cos(2πr) - 1)/r²` in powers of r²; see `COSINE` in `tests/derivation`.
const COSINE: [f32; 4] = [-19.739_208, 64.939_12, -85.422_57, 58.533_207];

/// `atan(z)/(2πz) - 1/8` in powers of z²; see `ANGLE` in `tests/derivation`.
const ANGLE: [f32; 5] = [
    0.034_154_94,
    -0.053_050_812,
    0.031_790_677,
    -0.022_048_812,
    0.012_717_884,
];

/// tan(π/8), half way between the axis and the diagonal; see `TAN_SIXTEENTH_TURN` in `tests/derivation`.
const TAN_SIXTEENTH_TURN: [f32; 1] = [0.414_213_57];

/// `(sin(2πt), cos(2πt))`.
#[inline]
pub(super) fn sincos_turns(t: f32) -> (f32, f32) {
    let (quadrant, r) = reduce_turns(t);
    let (s, c) = sincos_quarter(r);
    swap_quadrant(quadrant, s, c)
}

/// `(sin(2πr), cos(2πr))` for `|r| <= 1/8`.
#[inline]
pub(super) fn sincos_quarter(r: f32) -> (f32, f32) {
    let z = r * r;
    let [s0, s1, s2, s3] = SINE;
    let [c0, c1, c2, c3] = COSINE;
    // The leading 1 of the cosine is exact, so only the smaller part carries rounding errors. The sine has no such term:
    // this saves two instructions, and keeps the compiler from pairing both sums in vectors of two, whose shuffling took
    // longer than the sums.
    let s = r * (s0 + z * (s1 + z * (s2 + z * s3)));
    let c = 1.0 + z * (c0 + z * (c1 + z * (c2 + z * c3)));
    (s, c)
}

/// The angle of `(x, y)` in turns.
#[inline]
pub(super) fn atan2_turns(y: f32, x: f32) -> f32 {
    let (mut ax, mut ay) = (x.abs(), y.abs());
    let sum = ax + ay;
    if !(1.0e-30..=f32::MAX).contains(&sum) {
        if let Some(scaled) = rescaled(ax, ay) {
            (ax, ay) = scaled;
        } else {
            return 0.0;
        }
    }
    // The angle is measured from the nearest of axis, diagonal and axis, over one quotient.
    let [tangent] = TAN_SIXTEENTH_TURN;
    let (from, rise, run) = if ay < ax * tangent {
        (0.0, ay, ax)
    } else if ax < ay * tangent {
        (0.25, -ax, ay)
    } else {
        (0.125, ay - ax, ay + ax)
    };
    let z = rise / run;
    let w = z * z;
    let [a0, a1, a2, a3, a4] = ANGLE;
    let turned = 0.125 * z + z * (a0 + w * (a1 + w * (a2 + w * (a3 + w * a4))));
    let first_half = from + turned;
    let angle = if x < 0.0 {
        0.5 - first_half
    } else {
        first_half
    };
    angle.copysign(y)
}

/// Coordinates scaled so that their sum is finite and their quotient keeps its digits; `None` at the origin and for NaN.
/// Infinity counts as the largest finite value.
#[cold]
fn rescaled(ax: f32, ay: f32) -> Option<(f32, f32)> {
    const UP: f32 = 1.267_650_6e30;
    let quarter = |a: f32| 0.25 * if a > f32::MAX { f32::MAX } else { a };
    let sum = ax + ay;
    if sum > f32::MAX {
        Some((quarter(ax), quarter(ay)))
    } else if sum > 0.0 {
        Some((ax * UP, ay * UP))
    } else {
        None
    }
}
