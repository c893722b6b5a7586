//! Powers: the exponential of a product that one `f32` is too short for. Every quantity is a head of 12 bits, whose
//! products are exact, and a rest. Both tiers share this file.

use crate::num::{
    Scaled, head, is_plain, ldexp, nearest_integer, normalised, power_of_two, power_of_two_times,
    quick_two_sum, remainder,
};

/// `(e^r - 1 - r)/r²` in powers of r; see `EXPONENTIAL` in `tests/derivation`.
const EXPONENTIAL: [f32; 5] = [
    0.499_999_94,
    0.166_665_15,
    0.041_668_084,
    0.008_369_35,
    0.001_384_042_9,
];

/// ln 2 in two parts, the first of 12 bits; see `LN_2` in `tests/derivation`.
pub(super) const LN_2: [f32; 2] = [0.693_115_23, 3.194_618_3e-5];

/// `e^r - 1 - r` for `|r| <= ln(2)/2`.
#[inline]
pub(super) const fn beyond_linear(r: f32) -> f32 {
    let [e0, e1, e2, e3, e4] = EXPONENTIAL;
    r * r * (e0 + r * (e1 + r * (e2 + r * (e3 + r * e4))))
}

/// `(3/2s ln((1+s)/(1-s)) - 3 - s²)/s⁴` in powers of s²; see `LONG_LOGARITHM` in `tests/derivation`.
const LONG_LOGARITHM: [f32; 3] = [0.600_002_3, 0.428_206_3, 0.351_297_05];

/// √½, where the significands begin.
const SQRT_HALF: u32 = 0x3f35_04f3;

/// 2/(3 ln 2) in two parts, the first of 12 bits; see `TO_LOG2` in `tests/derivation`.
const TO_LOG2: [f32; 2] = [0.961_669_9, 0.000_126_772_05];

/// The binary logarithm of a positive normal `x`, plus `offset`: see [`log2_1p`].
#[inline]
#[allow(clippy::cast_precision_loss, reason = "an exponent has 8 bits")]
fn log2(x: f32, offset: f32) -> (f32, f32) {
    let (k, f) = normalised(x, SQRT_HALF);
    log2_1p(k as f32 + offset, f, 0.0)
}

/// The binary logarithm of `x + lack` for a positive normal `x`, less `offset`: see [`log2_1p`].
#[inline]
#[allow(clippy::cast_precision_loss, reason = "an exponent has 8 bits")]
pub(crate) const fn log2_of_sum(x: f32, lack: f32, offset: f32) -> (f32, f32) {
    let (k, f) = normalised(x, SQRT_HALF);
    let scale = power_of_two_times(1.0, k.wrapping_neg());
    log2_1p(k as f32 - offset, f, lack * scale)
}

/// `k + log2(1 + f + lack)` for whole k and f from √½ - 1 to √2 - 1: a head and the rest, together good to
/// about 2^-33 of the logarithm.
#[inline]
pub(crate) const fn log2_1p(k: f32, f: f32, lack: f32) -> (f32, f32) {
    // s = f/(2+f). The rest of s comes from what its head leaves of the numerator.
    let divisor = 2.0 + f;
    let divisor_head = head(divisor);
    let divisor_rest = f - (divisor_head - 2.0);
    let reciprocal = 1.0 / divisor;
    let s_head = head(f * reciprocal);
    let s_rest = reciprocal * ((f - s_head * divisor_head) - s_head * divisor_rest);
    // ds/df = 2/(2+f)². With a constant 0 the compiler removes this.
    let s_rest = if lack == 0.0 {
        s_rest
    } else {
        s_rest + 2.0 * reciprocal * reciprocal * lack
    };
    let s = s_head + s_rest;

    // t = 3 + s² + s⁴ P(s²), so that s·t = 3/2 ln(1+f).
    let [p0, p1, p2] = LONG_LOGARITHM;
    let z = s * s;
    let z_head = s_head * s_head;
    let small = s_rest * (s_head + s) + z * z * (p0 + z * (p1 + z * p2));
    let t_head = head(3.0 + z_head + small);
    let t_rest = small - ((t_head - 3.0) - z_head);

    let exact = s_head * t_head;
    let small = s_rest * t_head + s * t_rest;
    let product_head = head(exact + small);
    let product_rest = small - (product_head - exact);

    let [c_head, c_rest] = TO_LOG2;
    let exact = product_head * c_head;
    let small = product_head * c_rest + product_rest * (c_head + c_rest);
    let log_head = head((exact + small) + k);
    (log_head, small - ((log_head - k) - exact))
}

/// The product of a logarithm, given as a head and a rest, and `y`: an exact part and a small one.
#[inline]
pub(crate) const fn times((log_head, log_rest): (f32, f32), y: f32) -> (f32, f32) {
    let y_head = head(y);
    (y_head * log_head, (y - y_head) * log_head + y * log_rest)
}

/// `(k, a, b)` with `2^(exact + small) = 2^k (1 + a + b)`, where a is exact and b small; for sums up to 2^22.
#[inline]
pub(crate) const fn exp2(exact: f32, small: f32) -> (i32, f32, f32) {
    let (n, k) = nearest_integer(exact + small);
    let r = exact - n;
    let r_head = head(r + small);
    let r_rest = (r - r_head) + small;

    // e^(r ln 2), again with an exact head.
    let [ln2_head, ln2_rest] = LN_2;
    let natural = (r_head + r_rest) * (ln2_head + ln2_rest);
    let beyond = r_head * ln2_rest + r_rest * (ln2_head + ln2_rest) + beyond_linear(natural);
    (k, r_head * ln2_head, beyond)
}

/// `2^(exact + small)` and its rounding error, together good to 2^-28 of it; for sums from -100 to 100.
#[inline]
pub(crate) const fn exp2_pair(exact: f32, small: f32) -> (f32, f32) {
    let (k, a, b) = exp2(exact, small);
    let scale = power_of_two_times(1.0, k);
    let (sum, dropped) = quick_two_sum(1.0, a);
    let (power, rest) = quick_two_sum(sum, dropped + b);
    (scale * power, scale * rest)
}

/// `(2^-y, 1 - 2^-y)` of y = exact + small from 0 to 125.5, both accurate where they are small.
#[inline]
pub(crate) fn exp2_neg_pair(exact: f32, small: f32) -> (f32, f32) {
    let (n, k) = nearest_integer(-(exact + small));
    let natural = ((-exact - n) - small) * core::f32::consts::LN_2;
    let power = power_of_two(k);
    // Exact, but for the sum.
    let part = power * (natural + beyond_linear(natural));
    (power + part, (1.0 - power) - part)
}

impl Scaled {
    /// The binary logarithm: a head of 12 bits and the rest, together good to about 2^-33 of it.
    #[inline]
    pub(crate) const fn log2(self) -> (f32, f32) {
        let (s, exponent) = self.parts();
        // √2 itself is not halved, as in a quotient by 1.
        let (k, f) = normalised(s, SQRT_HALF + 1);
        log2_1p(exponent.wrapping_add(k) as f32, f, 0.0)
    }

    /// The binary logarithm of the quotient by `other`: a head of 12 bits and the rest, together good to about
    /// 2^-33 of it however close the two are.
    #[inline]
    pub(crate) const fn log2_over(self, other: Self) -> (f32, f32) {
        use core::f32::consts::SQRT_2;
        let ((s, exponent), (divisor, other_exponent)) = (self.parts(), other.parts());
        let k = exponent.wrapping_sub(other_exponent);
        // Within a factor of root 2 of the divisor, so that the difference is exact.
        let (dividend, k) = if s > SQRT_2 * divisor {
            (0.5 * s, k.wrapping_add(1))
        } else if SQRT_2 * s < divisor {
            (2.0 * s, k.wrapping_sub(1))
        } else {
            (s, k)
        };
        let difference = dividend - divisor;
        let f = difference / divisor;
        // Exponents have 9 bits.
        log2_1p(k as f32, f, remainder(difference, f, divisor) / divisor)
    }

    /// The number times (2^log)^(y + `y_rest`), where log is a head of 12 bits and a rest. Results beyond 2^-1000 and
    /// 2^1000 are these.
    #[inline]
    pub(crate) const fn times_power(self, log: (f32, f32), (y, y_rest): (f32, f32)) -> Self {
        if (y * (log.0 + log.1)).abs() >= 1000.0 {
            let up = (y > 0.0) == (log.0 > 0.0);
            return Self::ONE.raised(if up { 1000 } else { -1000 });
        }
        let (exact, small) = times(log, y);
        self.times_exp2(exact, small + y_rest * log.0)
    }

    /// The number times 2^(exact + small), for sums up to 2^22.
    #[inline]
    pub(crate) const fn times_exp2(self, exact: f32, small: f32) -> Self {
        let (k, a, b) = exp2(exact, small);
        // s(1 + a + b), with its largest product exact and all the rest in one sum, so that the result is monotone where k
        // changes.
        let (s, exponent) = self.parts();
        let (s_head, a_head) = (head(s), head(a + b));
        let exact = s_head * a_head;
        let small = (s - s_head) * a_head + s * ((a - a_head) + b);
        let sum = s + exact;
        let product = sum + ((exact - (sum - s)) + small);
        Self::of(product).raised(exponent.wrapping_add(k))
    }
}

/// `x^y` for `x >= 0`.
pub(super) fn pow(x: f32, y: f32) -> f32 {
    if y == 0.0 || x.to_bits() == 1.0_f32.to_bits() {
        return 1.0;
    }
    let (log_head, log_rest) = if is_plain(x) {
        log2(x, 0.0)
    } else if x > 0.0 && x < 1.0 {
        log2(x * 8_388_608.0, -23.0)
    } else {
        return pow_edge(x, y);
    };
    // The exponent of 2. Beyond these bounds the power is 0 or infinite, also for an infinite y.
    let whole = y * (log_head + log_rest);
    if whole > 129.0 {
        return f32::INFINITY;
    }
    if whole < -151.0 {
        return 0.0;
    }
    let (exact, small) = times((log_head, log_rest), y);
    let (k, a, b) = exp2(exact, small);
    let power = 1.0 + (a + b);
    if whole > -125.0 && whole < 127.0 {
        power_of_two_times(power, k)
    } else if whole.is_nan() {
        whole
    } else {
        ldexp(power, k)
    }
}

/// Powers of 0 and infinity; NaN for an x below 0, and for NaN.
#[cold]
fn pow_edge(x: f32, y: f32) -> f32 {
    if x < 0.0 || x.is_nan() || y.is_nan() {
        f32::NAN
    } else if (x == 0.0) == (y > 0.0) {
        0.0
    } else {
        f32::INFINITY
    }
}
