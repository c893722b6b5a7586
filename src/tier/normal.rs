//! The lower tail of the standard normal distribution and its quantile, from the exponential, logarithm and square root
//! of a tier. Callers get the upper half by symmetry. Both tiers share this file.

use super::{Tier, exp_of_product};
use crate::num::{above_zero, pair};

/// √(2π), the slope of `e^(-t²/2)/Φ(-t)` far out; see `SQRT_TAU` in `tests/derivation`.
const SQRT_TAU: [f32; 1] = [2.506_628_3];

/// Numerator of `e^(-t²/2)/Φ(-t) - √(2π) t` in powers of t; see `MILLS` in `tests/derivation`.
const MILLS: [f32; 5] = [2.0, 0.918_382_7, 0.230_169_43, 0.024_202_941, 2.337_683e-6];
/// Its denominator, less the 1.
const MILLS_OVER: [f32; 4] = [0.914_620_16, 0.395_019_17, 0.090_987_86, 0.009_698_549];

/// Numerator of `-Φ⁻¹(1/2 - q)/q - 5/2` in powers of q²; see `CENTRAL` in `tests/derivation`.
const CENTRAL: [f32; 5] = [
    0.006_628_286_6,
    2.585_684_3,
    -9.713_775,
    3.230_520_5,
    2.330_104_8,
];
/// Its denominator, less the 1.
const CENTRAL_OVER: [f32; 2] = [-5.920_813_6, 8.288_465];

/// Numerator of `3r/2 - 1 + Φ⁻¹(e^(-r²))` in powers of r; see `TAIL` in `tests/derivation`.
const TAIL: [f32; 5] = [
    1.924_783_3,
    1.835_733_2,
    -2.005_687_7,
    -0.116_401_46,
    0.039_793_614,
];
/// Its denominator, less the 1.
const TAIL_OVER: [f32; 3] = [4.943_938_7, 3.917_732, 0.465_646_77];

/// Φ(x) for `x <= 0`. Arguments above 0, and NaN, count as 0.
pub(crate) fn cdf_lower<T: Tier>(x: f32) -> f32 {
    // Below -15 the probability rounds to 0, and so does the exponential.
    let t = if x < 0.0 { -x } else { 0.0 };
    let t = if t < 15.0 { t } else { 15.0 };
    let [slope] = SQRT_TAU;
    let [n0, n1, n2, n3, n4] = MILLS;
    let [d1, d2, d3, d4] = MILLS_OVER;
    // All coefficients are positive, so neither sum cancels.
    let numerator = n0 + t * (n1 + t * (n2 + t * (n3 + t * n4)));
    let denominator = 1.0 + t * (d1 + t * (d2 + t * (d3 + t * d4)));
    // The exponential over slope·t + numerator/denominator. Where the first term is the larger one, the rounding errors
    // of the denominator cancel, because it occurs above and below the line.
    let power = exp_of_product::<T>(-0.5 * t, t);
    (power * denominator) / ((slope * t) * denominator + numerator)
}

/// What e^(-t²/2)/Φ(-t) has above √(2π) t, for t from 0 to 15.
#[inline]
fn above_slope(t: f32) -> f32 {
    let [n0, n1, n2, n3, n4] = MILLS;
    let [d1, d2, d3, d4] = MILLS_OVER;
    let numerator = n0 + t * (n1 + t * (n2 + t * (n3 + t * n4)));
    let denominator = 1.0 + t * (d1 + t * (d2 + t * (d3 + t * d4)));
    numerator / denominator
}

/// e^(-z²/2), and a factor that it is still to be multiplied by, at the quantile z of a tail in (0, 1/2]: the tail times the
/// hazard, without an exponential. An error of z changes it, relatively, by less than that over z.
#[inline]
pub(crate) fn density_of_tail(tail: f32, z: f32) -> (f32, f32) {
    let z = z.abs();
    let [slope] = SQRT_TAU;
    // A subnormal tail would lose more digits.
    let (lift, factor) = if tail > 1.0e-30 {
        (1.0, 1.0)
    } else {
        (16_777_216.0, 0.5 * f32::EPSILON)
    };
    (tail * lift * (slope * z + above_slope(z)), factor)
}

/// What the hazard of the standard normal, φ(t)/Φ(-t), has above t, for `t >= 0`; so the hazard is the sum of both.
pub(crate) fn hazard_above(t: f32) -> f32 {
    const PER_SLOPE: f32 =
        pair(0.5 * core::f64::consts::FRAC_2_SQRT_PI * core::f64::consts::FRAC_1_SQRT_2).0;
    if t < 15.0 {
        PER_SLOPE * above_slope(t)
    } else {
        // Laplace's continued fraction. What is left out is below 1e-8 of the hazard.
        1.0 / (t + 2.0 / (t + 3.0 / t))
    }
}

/// From which `q = p - 1/2` on the quantile is that about the median.
const CENTRE: f32 = -0.375;

/// The quantile about the median.
#[inline]
fn central(q: f32) -> f32 {
    let w = q * q;
    let [n0, n1, n2, n3, n4] = CENTRAL;
    let [d1, d2] = CENTRAL_OVER;
    let numerator = n0 + w * (n1 + w * (n2 + w * (n3 + w * n4)));
    let denominator = 1.0 + w * (d1 + w * d2);
    // q is exact, so the relative error stays small up to the median.
    2.5 * q + q * (numerator / denominator)
}

/// The quantile in the tail, from the logarithm of p.
#[inline]
pub(super) fn outer<T: Tier>(log: f32) -> f32 {
    let r = T::sqrt(-log);
    let [n0, n1, n2, n3, n4] = TAIL;
    let [d1, d2, d3] = TAIL_OVER;
    let numerator = n0 + r * (n1 + r * (n2 + r * (n3 + r * n4)));
    let denominator = 1.0 + r * (d1 + r * (d2 + r * d3));
    // The most rounded term is the smallest, and r is added last.
    (numerator / denominator - (0.5 * r - 1.0)) - r
}

/// The quantile of `p` in `(0, 1/2]`. Lower ones count as the smallest subnormal; higher ones, and NaN, as 1/2.
pub(crate) fn quantile_lower<T: Tier>(p: f32) -> f32 {
    let q = if p < 0.5 { p - 0.5 } else { 0.0 };
    if q >= CENTRE {
        central(q)
    } else {
        outer::<T>(T::ln(above_zero(p)))
    }
}
