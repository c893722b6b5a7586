//! The tables that [`Fine`](crate::fixed::Fine) and [`Coarse`](crate::fixed::Coarse) share, computed by the
//! compiler from series over integers.
#![allow(
    clippy::indexing_slicing,
    clippy::integer_division_remainder_used,
    reason = "the compiler evaluates all of this, and a panic would stop the build"
)]

/// The fraction bits of the series.
const BITS: u32 = 96;
const ONE: i128 = 1 << BITS;

/// The product of two numbers below 4 in magnitude, in Q96, with an error below 2⁻⁴⁵.
const fn product(a: i128, b: i128) -> i128 {
    (a >> 48) * (b >> 48)
}

/// atan(1/n), by Gregory's series.
const fn atan_of_inverse(n: i128) -> i128 {
    let (mut power, mut sum, mut j) = (ONE / n, 0, 0);
    while power != 0 {
        let term = power / (2 * j + 1);
        sum += if j % 2 == 0 { term } else { -term };
        power /= n * n;
        j += 1;
    }
    sum
}

/// π, by Machin's formula.
const PI: i128 = 16 * atan_of_inverse(5) - 4 * atan_of_inverse(239);

/// sin or cos of an angle from 0 to π/4, by its series.
const fn circular(angle: i128, cosine: bool) -> i128 {
    let (mut term, mut sum, mut j) = (if cosine { ONE } else { angle }, 0, 0);
    let first = if cosine { 0 } else { 1 };
    while j < 16 {
        sum += term;
        let n = first + 2 * j;
        term = -product(product(term, angle), angle) / ((n + 1) * (n + 2));
        j += 1;
    }
    sum
}

/// A number in Q96 rounded to the nearest with fewer fraction bits.
const fn rounded(x: i128, bits: u32) -> i128 {
    (x + (1 << (BITS - bits - 1))) >> (BITS - bits)
}

/// The cells of a turn.
pub(super) const SINE_CELLS: usize = 256;

/// sin over a turn and a quarter in Q30, cut towards 0 so that no point of the table lies outside the unit circle.
pub(super) static SINE: [i32; SINE_CELLS / 4 * 5 + 1] = {
    let mut table = [0; SINE_CELLS / 4 * 5 + 1];
    let mut i = 0;
    while i < table.len() {
        let within = (i % 64) as i128;
        let near = if within <= 32 { within } else { 64 - within };
        let angle = PI * near / 128;
        // The second half of a quarter is the cosine of the rest of it. Every other quarter falls.
        let falls = (i / 64) % 2 == 1;
        let sine = circular(angle, (within > 32) != falls);
        let sine = if sine > ONE { ONE } else { sine } >> (BITS - 30);
        table[i] = if (i / 128) % 2 == 1 { -sine } else { sine } as i32;
        i += 1;
    }
    table
};

/// The cells of [0, 1) that [`ROOT`] has.
pub(super) const ROOT_CELLS: usize = 256;

/// √(i/256) in Q16, cut, from 1/4 on; the last entry is just below 1. The first quarter is unused, but without it each
/// look-up would cost three more instructions on a Cortex-M0.
pub(super) static ROOT: [u16; ROOT_CELLS + 1] = {
    let mut table = [0; ROOT_CELLS + 1];
    let mut i = 64;
    while i < table.len() {
        let root = ((i as u64) << 24).isqrt();
        table[i] = if root > 0xffff { 0xffff } else { root as u16 };
        i += 1;
    }
    table
};

/// ln(a/b) for 0 < b ≤ a ≤ 2b, as twice artanh of (a − b)/(a + b).
const fn ln_of_quotient(a: i128, b: i128) -> i128 {
    let z = (a - b) * ONE / (a + b);
    let (mut power, mut sum, mut j) = (z, 0, 0);
    while j < 40 {
        sum += power / (2 * j + 1);
        power = product(product(power, z), z);
        j += 1;
    }
    2 * sum
}

/// The cells of [1/2, 1) that [`LOG`] has.
pub(super) const LOG_CELLS: usize = 64;

/// −ln((64 + i)/128) in Q27.
pub(super) static LOG: [u32; LOG_CELLS + 1] = {
    let mut table = [0; LOG_CELLS + 1];
    let mut i = 0;
    while i < table.len() {
        table[i] = rounded(ln_of_quotient(128, 64 + i as i128), 27) as u32;
        i += 1;
    }
    table
};

/// ln 2 in Q27.
pub(in crate::fixed) const LN_2: u32 = rounded(ln_of_quotient(2, 1), 27) as u32;

/// ln 2/32 in Q27.
pub(super) const LN_2_32ND: u32 = rounded(ln_of_quotient(2, 1) >> 5, 27) as u32;

/// 2^(−j/32) in Q31.
pub(super) static POWER: [u32; 32] = {
    let step = exp_neg(ln_of_quotient(2, 1) >> 5);
    let (mut table, mut power, mut j) = ([0; 32], ONE, 0);
    while j < 32 {
        table[j] = rounded(power, 31) as u32;
        power = product(power, step);
        j += 1;
    }
    table
};

/// e^−x of a small x.
const fn exp_neg(x: i128) -> i128 {
    let (mut term, mut sum, mut j) = (ONE, 0, 1);
    while j < 20 {
        sum += term;
        term = -product(term, x) / j;
        j += 1;
    }
    sum
}

/// The number of rotations in [`ROTATION`].
pub(super) const ROTATIONS: usize = 23;
/// atan(2⁻ⁱ) in Q32 turns, for i from 1. Their sum is more than an eighth of a turn.
pub(super) static ROTATION: [u32; ROTATIONS] = {
    let mut table = [0; ROTATIONS];
    let mut i = 0;
    while i < ROTATIONS {
        let angle = atan_of_inverse(2 << i);
        table[i] = (((angle << 29) / ((2 * PI) >> 4) + 1) >> 1) as u32;
        i += 1;
    }
    table
};

/// An entry of a table; the default beyond its end, where no kernel goes.
#[inline]
pub(super) fn entry<T: Copy + Default, const N: usize>(table: &[T; N], index: u32) -> T {
    table.get(index as usize).copied().unwrap_or_default()
}
