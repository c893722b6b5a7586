//! The polynomial tier: `f32` arithmetic only, in a fixed order of correctly rounded operations.
//!
//! The functions are in the modules below and in those that both tiers share. `tests/derivation` derives every
//! coefficient.

mod exp;
mod log;
mod trig;

use super::turns::{polar, reduce_few_turns};
use super::{Tier, normal, power};

/// The polynomial tier: `f32` arithmetic only, no `f64`. Its functions have no tables; warps on the line share three, of 1,416
/// bytes together, and none takes more than two.
///
/// # Accuracy
/// | function | domain | max ulp | max absolute | max relative |
/// |---|---|--:|--:|--:|
/// | `sqrt` | x ≥ 0 | 0.5 | - | - |
/// | `sincos_turns` | 0 ≤ t ≤ 1 | 2 | 7.2e-8 | - |
/// | `sincos_turns` | finite t | 2 | 7.2e-8 | - |
/// | `polar, r = 1` | 0 ≤ t ≤ 1 | 2 | 7.2e-8 | - |
/// | `sin² + cos²` | 0 ≤ t ≤ 1 | - | 1.8e-7 | - |
/// | `atan2_turns` | finite x, y | 1.7 | 2.8e-8 | - |
/// | `ln` | 2⁻²⁴ ≤ x ≤ 1 | 1.1 | 5e-7 | - |
/// | `ln` | x > 0 | 1.1 | 3.9e-6 | - |
/// | `ln_1p` | -1 < x ≤ 0 | 0.95 | 5e-7 | - |
/// | `ln_1p` | x > -1 | 0.95 | 3.9e-6 | - |
/// | `neg_ln_1m` | grid of [0, 1) | 1.1 | 1.1e-6 | - |
/// | `neg_ln_1m` | 0 ≤ u < 1 | 1.1 | 1.1e-6 | - |
/// | `exp_neg_pair` | 0 ≤ x ≤ 1 | 0.91 | 4.9e-8 | - |
/// | `exp_neg_pair` | 0 ≤ x ≤ 87 | 0.92 | 4.9e-8 | - |
/// | `exp` | -1 ≤ x ≤ 0 | 0.85 | 4.9e-8 | - |
/// | `exp` | finite x | 0.9 | - | - |
/// | `exp_m1` | -1 ≤ x ≤ 0 | 0.91 | 4.2e-8 | - |
/// | `exp_m1` | finite x | 1.7 | - | - |
/// | `pow` | 0 ≤ x ≤ 1, y = 1/51 | 0.72 | 4.3e-8 | - |
/// | `pow` | x ≥ 0, finite y | 0.93 | - | - |
/// | `normal_cdf_lower` | x ≤ 0 | 4.8 | 1.5e-7 | 3e-7 |
/// | `normal_quantile_lower` | 2⁻²⁴ ≤ p ≤ 1/2 | 2.4 | 5.5e-7 | 2.4e-7 |
/// | `normal_quantile_lower` | 0 < p ≤ 1/2 | 2.5 | 1.8e-6 | 2.4e-7 |
///
/// These are the largest errors that `tests/tier` finds: over every input of the 2⁻²⁴ grid where the domain lies in the
/// unit interval, over a dense sample of every binade elsewhere. An ulp is a unit in the last place of the exact result,
/// or the spacing of the subnormals where the result is subnormal. A dash stands where a figure would say nothing.
///
/// Logarithms, exponentials and both functions of the normal distribution never step back from one input of the grid to
/// the next.
///
/// # See also
/// - [`Libm`](super::Libm): the reference, over the `libm` crate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Poly;

impl super::sealed::Sealed for Poly {
    const VECTORS: bool = true;
    const TABLES: bool = true;

    #[inline]
    fn sincos_quarter(r: f32) -> (f32, f32) {
        trig::sincos_quarter(r)
    }

    #[inline]
    fn neg_ln_1m_of_word(word: u32) -> f32 {
        log::neg_ln_1m_of_word(word)
    }
}

impl Tier for Poly {
    const NAME: &'static str = "poly";

    #[inline]
    fn sincos_turns(t: f32) -> (f32, f32) {
        trig::sincos_turns(t)
    }

    #[inline]
    fn polar(radius: f32, turn: f32) -> (f32, f32) {
        let (quadrant, r) = reduce_few_turns(turn);
        let (s, c) = trig::sincos_quarter(r);
        polar(radius, quadrant, s, c)
    }

    #[inline]
    fn atan2_turns(y: f32, x: f32) -> f32 {
        trig::atan2_turns(y, x)
    }

    #[inline]
    fn ln(x: f32) -> f32 {
        log::ln(x)
    }

    #[inline]
    fn ln_1p(x: f32) -> f32 {
        log::ln_1p(x)
    }

    #[inline]
    fn neg_ln_1m(u: f32) -> f32 {
        log::neg_ln_1m(u)
    }

    #[inline]
    fn exp_neg_pair(x: f32) -> (f32, f32) {
        exp::exp_neg_pair(x)
    }

    #[inline]
    fn exp(x: f32) -> f32 {
        exp::exp(x)
    }

    #[inline]
    fn exp_m1(x: f32) -> f32 {
        exp::exp_m1(x)
    }

    #[inline]
    fn pow(x: f32, y: f32) -> f32 {
        power::pow(x, y)
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
