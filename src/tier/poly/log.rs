//! Logarithms of the polynomial tier, to one `f32`. The longer one for powers is in `tier/power.rs`.

use crate::num::{is_plain, normalised, power_of_two_times};
use crate::tier::power::LN_2;

/// `(ln((1+s)/(1-s)) - 2s)/s³` in powers of s²; see `LOGARITHM` in `tests/derivation`.
const LOGARITHM: [f32; 3] = [0.666_669_5, 0.399_576_57, 0.303_644_98];

const ONE: u32 = 0x3f80_0000;

/// 3/4, where the significands of these logarithms begin: its bits fit an immediate operand.
const THREE_QUARTERS: u32 = 0x3f40_0000;

/// `f/(2+f)`, and by how much `ln(1+f)` stays below `f`, for f between -0.29 and 1/2.
#[inline]
fn shortfall(f: f32) -> (f32, f32) {
    let s = f / (2.0 + f);
    let w = s * s;
    let [l0, l1, l2] = LOGARITHM;
    // ln(1+f) = 2s + s·R(s²), and 2s = f - s·f.
    (s, s * (f - w * (l0 + w * (l1 + w * l2))))
}

#[inline]
#[allow(clippy::cast_precision_loss, reason = "an exponent has 8 bits")]
fn ln_plain(x: f32, scaled: f32) -> f32 {
    let (k, f) = normalised(x, THREE_QUARTERS);
    let k = k as f32 - scaled;
    let [high, low] = LN_2;
    let (_, drop) = shortfall(f);
    // k·high is exact; the smaller terms are summed first.
    k * high + (f - (drop - k * low))
}

/// The natural logarithm.
#[inline]
pub(super) fn ln(x: f32) -> f32 {
    if is_plain(x) {
        ln_plain(x, 0.0)
    } else {
        ln_edge(x)
    }
}

#[cold]
fn ln_edge(x: f32) -> f32 {
    if x > f32::MAX {
        x
    } else if x > 0.0 {
        ln_plain(x * 8_388_608.0, 23.0)
    } else if x == 0.0 {
        f32::NEG_INFINITY
    } else {
        f32::NAN
    }
}

/// `ln(1 + x)`.
#[inline]
#[allow(clippy::cast_precision_loss, reason = "an exponent has 8 bits")]
pub(super) fn ln_1p(x: f32) -> f32 {
    if x > -0.29 && x < 0.5 {
        return x - shortfall(x).1;
    }
    // From 2^24 on the 1 is below half a unit in the last place.
    if !(x > -1.0 && x < 16_777_216.0) {
        return ln(1.0 + x);
    }
    let sum = 1.0 + x;
    let dropped = if x < 1.0 {
        x - (sum - 1.0)
    } else {
        1.0 - (sum - x)
    };
    let (k, f) = normalised(sum, THREE_QUARTERS);
    let (s, drop) = shortfall(f);
    // The rounding error of the sum, scaled like f, moves the logarithm by 1/(1+f) ≈ 1 - 2s of itself.
    let dropped = dropped * power_of_two_times(f32::from_bits(ONE), k.wrapping_neg());
    let k = k as f32;
    let [high, low] = LN_2;
    k * high + (f - (drop - (k * low + dropped * (1.0 - 2.0 * s))))
}

/// `-ln(1 - u)` for u in [0, 1), without a branch.
#[inline]
#[allow(
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "the exponent is signed and its bits are shifted as such"
)]
pub(super) fn neg_ln_1m(u: f32) -> f32 {
    // 1 - u = m·2^k with m from 3/4 to 3/2.
    let k = ((1.0 - u).to_bits().wrapping_sub(THREE_QUARTERS) as i32) >> 23;
    let scale = f32::from_bits(ONE.wrapping_sub((k as u32) << 23));
    // m - 1, from u itself and therefore exact, even where 1 - u is rounded.
    neg_ln(k, (scale - 1.0) - scale * u)
}

/// The same of the uniform of the grid that a word stands for.
///
/// 1 - u is a whole number of steps there. Its significand gets into place without a conversion and without a way from
/// the float registers to the others and back.
#[inline]
#[allow(clippy::cast_possible_wrap, reason = "zeros have 5 bits")]
pub(super) fn neg_ln_1m_of_word(word: u32) -> f32 {
    let rest = (1_u32 << 24).wrapping_sub(word >> 8);
    let zeros = rest.leading_zeros();
    // From 1 to 2: the leading bit adds to the exponent.
    let significand = rest.wrapping_shl(zeros) >> 8;
    let significand = f32::from_bits(significand.wrapping_add(ONE - (1 << 23)));
    let (k, f) = normalised(significand, THREE_QUARTERS);
    neg_ln(k.wrapping_add(7).wrapping_sub(zeros as i32), f)
}

/// `-ln(2^k (1 + f))`.
#[inline]
#[allow(clippy::cast_precision_loss, reason = "an exponent has 8 bits")]
fn neg_ln(k: i32, f: f32) -> f32 {
    let (_, drop) = shortfall(f);
    (drop - f) - k as f32 * core::f32::consts::LN_2
}
