//! Angles in turns: the exact reduction of a phase to a quadrant, and the way back. Both tiers share this file.

const SIGN: u32 = 0x8000_0000;

/// Splits a phase in turns into quarter turns: their count, of which the last two bits are valid, and the remainder `r` in
/// turns with `|r| <= 1/8`. Exact.
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
    // Adding 1.5·2^21 rounds to quarters, and leaves their count in the last bits.
    const ROUND: f32 = 3_145_728.0;
    let shifted = t + ROUND;
    // ROUND - shifted needs no second constant. It is exact, and so is the sum.
    (shifted.to_bits(), t + (ROUND - shifted))
}

/// A large phase less its whole turns. From 2^23 on all phases are whole; infinity and NaN count as whole.
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

/// `(b, a)` where `when` holds, else `(a, b)`; by bits, because no processor predicts a branch on a random number.
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

/// The same on cores without branch prediction, where a branch costs less than a way through the core registers.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub(crate) fn exchanged(when: bool, a: f32, b: f32) -> (f32, f32) {
    if when { (b, a) } else { (a, b) }
}

/// `radius · (cos, sin)` of a reduced phase whose sine and cosine within its quadrant are given.
#[inline]
pub(crate) fn polar(radius: f32, quadrant: u32, s: f32, c: f32) -> (f32, f32) {
    // The signs of sine and cosine differ where the quadrant is odd.
    let odd = quadrant & 1 == 1;
    let of_sine = quadrant.wrapping_shl(30) & SIGN;
    let of_cosine = of_sine ^ quadrant.wrapping_shl(31);
    let signed = |x: f32, sign: u32| f32::from_bits(x.to_bits() ^ sign);
    if cfg!(all(target_arch = "arm", target_abi = "eabihf")) {
        // A hardware root leaves the radius in a core register anyway, and signs are there.
        let (s, c) = exchanged(odd, s, c);
        (signed(radius, of_cosine) * c, signed(radius, of_sine) * s)
    } else {
        // What is done by bits comes last, so that it is done on the way to memory.
        let (y, x) = exchanged(odd, radius * s, radius * c);
        (signed(x, of_cosine), signed(y, of_sine))
    }
}
