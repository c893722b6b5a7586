//! Sine, cosine and arctangent of angles in turns, of the polynomial tier. The exact reduction of a
//! phase is used by the reference tier too.

/// `sin(2πr)/r` in powers of r²; see `SINE` in `tests/derivation`.
#[allow(
    clippy::approx_constant,
    reason = "fitted: the first is near 2π and need not be it"
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

/// tan(π/8), half way between the axis and the diagonal; see the name in `tests/derivation`.
const TAN_SIXTEENTH_TURN: [f32; 1] = [0.414_213_57];

const SIGN: u32 = 0x8000_0000;

/// Splits a phase in turns into quarter turns: their count, of which the last two bits hold, and the
/// remainder `r` in turns with `|r| <= 1/8`. Nothing is rounded.
#[inline]
pub(crate) fn reduce_turns(t: f32) -> (u32, f32) {
    reduce_few_turns(if t.abs() < 1_048_576.0 {
        t
    } else {
        fraction(t)
    })
}

/// The same for fewer than 2^20 turns either way.
#[inline]
pub(crate) fn reduce_few_turns(t: f32) -> (u32, f32) {
    // Adding 1.5·2^21 leaves no bits below a quarter, and the count stands in the last bits.
    const ROUND: f32 = 3_145_728.0;
    let shifted = t + ROUND;
    // One constant, not its negative too: ROUND - shifted is exact, and so is the sum.
    (shifted.to_bits(), t + (ROUND - shifted))
}

/// A large phase less its whole turns; from 2^23 on all are whole, and so is what is not finite.
fn fraction(t: f32) -> f32 {
    const WHOLE: f32 = 8_388_608.0;
    let size = t.abs();
    if size < WHOLE {
        let rest = size - ((size + WHOLE) - WHOLE);
        if t < 0.0 { -rest } else { rest }
    } else {
        0.0
    }
}

/// Carries the sine and cosine of a remainder into its quadrant.
#[inline]
pub(crate) fn swap_quadrant(quadrant: u32, s: f32, c: f32) -> (f32, f32) {
    let (s, c) = exchanged(quadrant & 1 == 1, s, c);
    let negative_sine = quadrant.wrapping_shl(30) & SIGN;
    let negative_cosine = quadrant.wrapping_add(1).wrapping_shl(30) & SIGN;
    (
        f32::from_bits(s.to_bits() ^ negative_sine),
        f32::from_bits(c.to_bits() ^ negative_cosine),
    )
}

/// `(b, a)` where `when` holds, else `(a, b)`; by bits, since what depends on a random number is not to be
/// predicted by a branch.
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
#[inline]
pub(crate) fn exchanged(when: bool, a: f32, b: f32) -> (f32, f32) {
    let (a, b) = (a.to_bits(), b.to_bits());
    let difference = (a ^ b) & u32::from(when).wrapping_neg();
    (
        f32::from_bits(a ^ difference),
        f32::from_bits(b ^ difference),
    )
}

/// The same on cores that do not predict, where moving both to the core registers and back costs more than a
/// branch.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub(crate) fn exchanged(when: bool, a: f32, b: f32) -> (f32, f32) {
    if when { (b, a) } else { (a, b) }
}

/// `radius · (cos, sin)` of a reduced phase whose sine and cosine within its quadrant are given.
#[inline]
pub(crate) fn polar(radius: f32, quadrant: u32, s: f32, c: f32) -> (f32, f32) {
    // The signs go to the radius, which a hardware root leaves in a core register anyway. Sine and cosine
    // differ in sign where the quadrant is odd.
    let (s, c) = exchanged(quadrant & 1 == 1, s, c);
    let of_sine = quadrant.wrapping_shl(30) & SIGN;
    let of_cosine = of_sine ^ quadrant.wrapping_shl(31);
    let signed = |x: f32, sign: u32| f32::from_bits(x.to_bits() ^ sign);
    let y = signed(radius, of_sine) * s;
    // On x86-64 the other goes to the product: two products alike would be paired into one of two-part vectors,
    // whose shuffling takes longer than the rest.
    let x = if cfg!(target_arch = "x86_64") {
        signed(radius * c, of_cosine)
    } else {
        signed(radius, of_cosine) * c
    };
    (x, y)
}

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
    // The leading 1 of the cosine is exact, so only the smaller part carries rounding errors. The sine has none
    // like it: this saves two instructions, and keeps the compiler from pairing both sums into one of
    // two-part vectors, whose shuffling took longer than the sums.
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

/// Coordinates brought to where their sum is finite and their quotients are not coarse; `None` at the
/// origin and where one is not a number. Infinity counts as the largest finite value.
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
