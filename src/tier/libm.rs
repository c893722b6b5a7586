//! The reference tier: `f32` in, `f32` out, the `libm` crate inside.
//!
//! This file adds what `libm` would lose before or after its own work; the functions are those of `libm`.

use super::{Tier, normal, power, turns};
use crate::uniform::grid_from_word;

/// The reference tier: the elementary functions of the `libm` crate.
///
/// Phases in turns are reduced exactly before `libm` sees them. Its sine, cosine and power compute in `f64`, which is slow
/// where doubles are emulated.
///
/// # Accuracy
/// | function | domain | max ulp | max absolute | max relative |
/// |---|---|--:|--:|--:|
/// | `sqrt` | x ≥ 0 | 0.5 | - | - |
/// | `sincos_turns` | 0 ≤ t ≤ 1 | 2 | 6.9e-8 | - |
/// | `sincos_turns` | finite t | 2 | 6.9e-8 | - |
/// | `polar, r = 1` | 0 ≤ t ≤ 1 | 2 | 6.9e-8 | - |
/// | `sin² + cos²` | 0 ≤ t ≤ 1 | - | 8.4e-8 | - |
/// | `atan2_turns` | finite x, y | 2.5 | 6.6e-8 | - |
/// | `ln` | 2⁻²⁴ ≤ x ≤ 1 | 0.83 | 5e-7 | - |
/// | `ln` | x > 0 | 0.83 | 3.9e-6 | - |
/// | `ln_1p` | -1 < x ≤ 0 | 0.83 | 5e-7 | - |
/// | `ln_1p` | x > -1 | 0.83 | 3.9e-6 | - |
/// | `neg_ln_1m` | grid of [0, 1) | 0.83 | 5e-7 | - |
/// | `neg_ln_1m` | 0 ≤ u < 1 | 0.83 | 5e-7 | - |
/// | `exp_neg_pair` | 0 ≤ x ≤ 1 | 0.83 | 4.6e-8 | - |
/// | `exp_neg_pair` | 0 ≤ x ≤ 87 | 0.91 | 4.6e-8 | - |
/// | `exp` | -1 ≤ x ≤ 0 | 0.84 | 5e-8 | - |
/// | `exp` | finite x | 0.92 | - | - |
/// | `exp_m1` | -1 ≤ x ≤ 0 | 0.78 | 4e-8 | - |
/// | `exp_m1` | finite x | 0.82 | - | - |
/// | `pow` | 0 ≤ x ≤ 1, y = 1/51 | 0.67 | 4e-8 | - |
/// | `pow` | x ≥ 0, finite y | 0.86 | - | - |
/// | `normal_cdf_lower` | x ≤ 0 | 4.8 | 1.5e-7 | 3e-7 |
/// | `normal_quantile_lower` | 2⁻²⁴ ≤ p ≤ 1/2 | 2.4 | 5.3e-7 | 2.4e-7 |
/// | `normal_quantile_lower` | 0 < p ≤ 1/2 | 2.5 | 1.8e-6 | 2.4e-7 |
///
/// These are the largest errors that `tests/tier` finds: over every input of the 2⁻²⁴ grid where the domain lies in the
/// unit interval, over a dense sample of every binade elsewhere. An ulp is a unit in the last place of the exact result,
/// or the spacing of the subnormals where the result is subnormal. A dash stands where a figure would say nothing.
///
/// # See also
/// - [`Poly`](super::Poly): about as accurate, and the tier for microcontrollers and WASM.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Libm;

/// `(sin(2πr), cos(2πr))`.
#[inline]
fn sincos_quarter(r: f32) -> (f32, f32) {
    // Rounding this product turns the angle by up to 4e-8 but leaves the point on the circle;
    // correcting sine and cosine for it would round both again and move the point off the circle.
    ::libm::sincosf(r * core::f32::consts::TAU)
}

impl super::sealed::Sealed for Libm {
    const VECTORS: bool = false;
    const TABLES: bool = false;

    #[inline]
    fn sincos_quarter(r: f32) -> (f32, f32) {
        sincos_quarter(r)
    }

    #[inline]
    fn neg_ln_1m_of_word(word: u32) -> f32 {
        // On the grid 1 - u is exact.
        0.0 - ::libm::logf(1.0 - grid_from_word(word))
    }
}

impl Tier for Libm {
    const NAME: &'static str = "libm";

    #[inline]
    fn sincos_turns(t: f32) -> (f32, f32) {
        let (quadrant, r) = turns::reduce_turns(t);
        let (s, c) = sincos_quarter(r);
        turns::swap_quadrant(quadrant, s, c)
    }

    #[inline]
    fn polar(radius: f32, turn: f32) -> (f32, f32) {
        let (quadrant, r) = turns::reduce_few_turns(turn);
        let (s, c) = sincos_quarter(r);
        turns::polar(radius, quadrant, s, c)
    }

    #[inline]
    fn atan2_turns(y: f32, x: f32) -> f32 {
        // `libm` distinguishes the signs of zeros, and gives infinity angles of its own.
        if x == 0.0 && y == 0.0 || x.is_nan() || y.is_nan() {
            return 0.0;
        }
        let finite = |a: f32| {
            if a.abs() > f32::MAX {
                f32::MAX.copysign(a)
            } else {
                a
            }
        };
        ::libm::atan2f(finite(y), finite(x)) * (0.5 * core::f32::consts::FRAC_1_PI)
    }

    #[inline]
    fn ln(x: f32) -> f32 {
        ::libm::logf(x)
    }

    #[inline]
    fn ln_1p(x: f32) -> f32 {
        ::libm::log1pf(x)
    }

    #[inline]
    #[allow(
        clippy::float_cmp,
        reason = "tests exactly whether anything was rounded"
    )]
    fn neg_ln_1m(u: f32) -> f32 {
        // On the grid 1 - u is exact, and the plain logarithm is quicker.
        let rest = 1.0 - u;
        if 1.0 - rest == u {
            0.0 - ::libm::logf(rest)
        } else {
            -::libm::log1pf(-u)
        }
    }

    #[inline]
    fn exp_neg_pair(x: f32) -> (f32, f32) {
        let rest = -::libm::expm1f(-x);
        if rest < 0.5 {
            (1.0 - rest, rest)
        } else {
            (::libm::expf(-x), rest)
        }
    }

    #[inline]
    fn exp(x: f32) -> f32 {
        ::libm::expf(x)
    }

    #[inline]
    fn exp_m1(x: f32) -> f32 {
        ::libm::expm1f(x)
    }

    #[inline]
    fn pow(x: f32, y: f32) -> f32 {
        // For |y| from 2^27 on, `libm` 0.2.16 returns 0 or infinity for any x below 1 - 2^-21, which is wrong for some.
        if y.abs() >= 134_217_728.0 {
            return power::pow(x, y);
        }
        // -0 counts as 0.
        ::libm::powf(x + 0.0, y)
    }

    #[inline]
    fn normal_cdf_lower(x: f32) -> f32 {
        normal::cdf_lower::<Self>(x)
    }

    #[inline]
    fn normal_quantile_lower(p: f32) -> f32 {
        normal::quantile_lower::<Self>(p)
    }
}
