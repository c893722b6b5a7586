//! The quantile of the normal distribution for warps on the line: about the median by a small table, in a short chain of
//! operations and from all digits of a word; beyond, in one draw of 256, by a logarithm. Both tiers share this file.

use super::Tier;
use super::normal::outer;
use crate::num::doubles::{exp, ln};
use crate::num::tail;
use core::f64::consts::LN_2;

/// The octaves of the tail below 1/2 that have rows, four each. Each of them takes 80 bytes and halves how many draws take a
/// logarithm.
const OCTAVES: usize = 8;

/// Chebyshev's nodes on [-1/2, 1/2].
const NODES: [f64; 5] = [
    0.475_528_258_147_576_8,
    0.293_892_626_146_236_6,
    0.0,
    -0.293_892_626_146_236_6,
    -0.475_528_258_147_576_8,
];

/// Φ(-z)/φ(z) for 0 ≤ z ≤ 4: √(π/2) e^(z²/2) less the series of (Φ(z) - 1/2)/φ(z).
const fn mills(z: f64) -> f64 {
    const SQRT_FRAC_PI_2: f64 = 1.253_314_137_315_500_3;
    let (mut term, mut sum, mut n) = (z, 0.0, 1.0);
    while n < 160.0 {
        sum += term;
        n += 2.0;
        term *= z * z / n;
    }
    SQRT_FRAC_PI_2 * exp(0.5 * z * z) - sum
}

/// -Φ⁻¹ of a tail down to 1/512, by Newton's method on the logarithm of the tail, from a quantile nearby.
const fn upper_quantile(tail: f64, nearby: f64) -> f64 {
    const LN_SQRT_TAU: f64 = 0.918_938_533_204_672_8;
    let (mut z, mut steps) = (nearby, 0.0);
    while steps < 6.0 {
        let mills = mills(z);
        // What ln takes is at most 1.
        let log = ln(0.5 * mills) + LN_2 - (0.5 * z * z + LN_SQRT_TAU);
        z += mills * (log - ln(tail));
        steps += 1.0;
    }
    z
}

/// -Φ⁻¹(t)/(1/2 - t) over each quarter of each octave of the tail t, from 1/2 down: the powers of the place in
/// the quarter, from -1/2 to 1/2. The polynomials meet the function at Chebyshev's nodes.
#[allow(
    clippy::indexing_slicing,
    reason = "the compiler evaluates it, and a panic would stop the build"
)]
static ROWS: [[f32; 5]; 4 * OCTAVES] = {
    let mut rows = [[0.0; 5]; 4 * OCTAVES];
    let (mut quantile, mut lowest, mut i) = (0.0, 0.25, 0);
    while i < rows.len() {
        let middle = lowest * (1.0 + (3.5 - (i & 3) as f64) / 4.0);
        let (mut over, mut k) = ([0.0; 5], 0);
        while k < 5 {
            let tail = middle + 0.25 * lowest * NODES[k];
            quantile = upper_quantile(tail, quantile);
            over[k] = quantile / (0.5 - tail);
            k += 1;
        }
        // Newton's divided differences, then their polynomial in powers.
        let mut order = 1;
        while order < 5 {
            k = 4;
            while k >= order {
                over[k] = (over[k] - over[k - 1]) / (NODES[k] - NODES[k - order]);
                k -= 1;
            }
            order += 1;
        }
        let mut powers = [0.0; 5];
        k = 0;
        while k < 5 {
            let from = 4 - k;
            let mut j = 4;
            while j > 0 {
                powers[j] = powers[j - 1] - NODES[from] * powers[j];
                j -= 1;
            }
            powers[0] = over[from] - NODES[from] * powers[0];
            k += 1;
        }
        k = 0;
        while k < 5 {
            rows[i][k] = powers[k] as f32;
            k += 1;
        }
        i += 1;
        if i & 3 < 1 {
            lowest *= 0.5;
        }
    }
    rows
};

/// The value of a row at a place in its quarter: the last 23 bits.
#[inline]
fn by_row(&[c0, c1, c2, c3, c4]: &[f32; 5], place: u32) -> f32 {
    // These bits of a number from 1 to 2: on x86-64 a conversion would have a false dependency.
    let place = f32::from_bits(0x3f80_0000 | place & 0x7f_ffff) - 1.5;
    (c0 + c1 * place) + place * place * (c2 + place * (c3 + place * c4))
}

/// -Φ⁻¹ of a tail without a row.
#[cold]
fn far<T: Tier>(tail: f32) -> f32 {
    -outer::<T>(T::ln(tail))
}

/// A length times Φ⁻¹ of the middle of a word's cell. Words that are as far from either end have opposite results, to the
/// last bit.
#[inline]
pub(crate) fn normal_quantile_of_word<T: Tier>(length: f32, word: u32) -> f32 {
    let [quantile] = normal_quantiles_of_word::<T, 1>([length], word);
    quantile
}

/// The same of several lengths and one word.
#[inline]
#[expect(clippy::cast_possible_wrap, reason = "its sign alone is wanted")]
pub(crate) fn normal_quantiles_of_word<T: Tier, const N: usize>(
    lengths: [f32; N],
    word: u32,
) -> [f32; N] {
    let signed = |x: f32| f32::from_bits(x.to_bits() ^ !word & 0x8000_0000);
    // In units of 2⁻³³: an odd number.
    let tail = word << 1 ^ (word as i32 >> 31) as u32 | 1;
    let zeros = tail.leading_zeros();
    let digits = tail.wrapping_shl(zeros);
    let row = zeros << 2 | !digits >> 29 & 3;
    if let Some(row) = ROWS.get(row as usize) {
        // Exactly as far from the median, rounded once.
        let distance = signed(0_u32.wrapping_sub(tail) as f32) * (f32::EPSILON / 1024.0);
        let slope = by_row(row, digits >> 6);
        lengths.map(|length| length * distance * slope)
    } else {
        let quantile = signed(far::<T>(tail as f32 * (f32::EPSILON / 1024.0)));
        lengths.map(|length| length * quantile)
    }
}

/// -Φ⁻¹ of a tail in (0, 1/2], given with its distance from 1/2.
#[inline]
fn normal_quantile_upper<T: Tier>(tail: f32, distance: f32) -> f32 {
    // From the last number below 1/2 down; 1/2 itself, whose distance is 0, counts as that.
    let down = 0x3eff_ffff_u32.saturating_sub(tail.to_bits());
    if let Some(row) = ROWS.get((down >> 21) as usize) {
        distance * by_row(row, !down << 2)
    } else {
        far::<T>(tail)
    }
}

/// Φ⁻¹ of a uniform in [0, 1), of which 0 counts as the smallest number.
#[inline]
pub(crate) fn normal_quantile<T: Tier>(u: f32) -> f32 {
    let quantile = normal_quantile_upper::<T>(tail(u), (u - 0.5).abs());
    if u < 0.5 { -quantile } else { quantile }
}
