//! What a row of a picture weighs: the same as every other, or the solid angle of its zone of the sphere. In integers
//! and `const`, so that the words of an environment map are the same in every tier and may lie in flash.

use crate::num::division::scaled;
use crate::num::{high, power_of_two_times};

/// The rows of a picture.
#[derive(Clone, Copy)]
pub(crate) enum Zones {
    /// All weigh the same.
    Flat,
    /// So many zones between equally spaced parallels, from pole to pole.
    Sphere(usize),
}

/// Half the divisors of Taylor's series of the sine, the last first: what follows them is below 2⁻⁶⁷ of the sine.
const HALF_DIVISORS: [u64; 12] = [
    12 * 25,
    11 * 23,
    10 * 21,
    9 * 19,
    8 * 17,
    7 * 15,
    6 * 13,
    5 * 11,
    4 * 9,
    3 * 7,
    2 * 5,
    3,
];

/// π/2 and its square, in steps of 2⁻⁶³ and 2⁻⁶², cut.
const QUARTER: u64 = 14_488_038_916_154_245_684;
const QUARTER_SQUARED: u64 = 11_378_879_155_978_302_162;

/// The sine of k/n quarters of a turn, as m and s of m 2⁻ˢ: k from 1 to n, n below 2²⁶. It is right to 2⁻⁶⁰ of itself,
/// m has 62 to 64 bits, and s is from 62 to 88.
const fn sine(k: u64, n: u64) -> (u64, u32) {
    const ONE: u64 = 1 << 63;
    // The argument as quarters, with 63 or 64 bits; its square as radians, in steps of 2⁻⁶²; and sin(x)/x, in steps of
    // 2⁻⁶³.
    let zeros = k.leading_zeros().wrapping_sub(n.leading_zeros());
    let (quarters, _) = scaled(k as u128, n as u128, zeros.wrapping_add(63));
    let quarters = quarters as u64;
    let plain = quarters.wrapping_shr(zeros);
    let square = high(high(plain, plain), QUARTER_SQUARED) << 2;
    let mut ratio = ONE;
    let mut divisors: &[u64] = &HALF_DIVISORS;
    while let Some((&divisor, rest)) = divisors.split_first() {
        ratio = ONE.wrapping_sub(quotient(high(square, ratio) << 1, divisor));
        divisors = rest;
    }
    let chord = high(quarters, ratio) << 1;
    (high(chord, QUARTER), zeros.wrapping_add(62))
}

const fn quotient(a: u64, b: u64) -> u64 {
    match a.checked_div(b) {
        Some(quotient) => quotient,
        None => 0,
    }
}

/// The sine of k/n quarters of a turn; 0 for k = 0.
pub(crate) const fn sine_of_quarters(k: usize, n: usize) -> f32 {
    if k == 0 {
        return 0.0;
    }
    let (m, shift) = sine(k as u64, n as u64);
    power_of_two_times(m as f32, 0_i32.wrapping_sub_unsigned(shift))
}

impl Zones {
    /// The sum of a row's weights, of up to 95 bits, times what the row weighs, which is 2³¹ at most. A sum above 0 stays
    /// above 0.
    pub(crate) const fn weigh(self, sum: u128, row: usize) -> u128 {
        let rows = match self {
            Self::Flat => return sum,
            Self::Sphere(rows) => rows,
        };
        // cos θ₀ − cos θ₁ = 2 sin((θ₀ + θ₁)/2) sin((θ₁ − θ₀)/2), of which the second sine is that of every zone.
        let middle = row.wrapping_mul(2).wrapping_add(1);
        let other = rows.wrapping_mul(2).saturating_sub(middle);
        let (m, shift) = sine(
            if middle < other { middle } else { other } as u64,
            rows as u64,
        );
        // ⌊sum·m/2⁶⁴⌋, then 31 − (s − 64) bits up.
        let upper = (sum >> 64).wrapping_mul(m as u128);
        let weighed = upper
            .wrapping_add(high(sum as u64, m) as u128)
            .wrapping_shl(95_u32.wrapping_sub(shift));
        if weighed == 0 && sum > 0 { 1 } else { weighed }
    }
}
