//! The Gumbel distribution.

use super::located::{Located, Standard, decayed, located, located_inverse, located_warp};
use super::{Invert, Warp};
use crate::num::{pair, two_product, two_sum};
use crate::tier::{LOG2_E, Tier, exp2_pair, times};

/// e and the rounding error of its `f32`.
const E: (f32, f32) = pair(core::f64::consts::E);

/// Gumbel with a location and a scale: the largest of many numbers whose tail is exponential.
///
/// x = μ − β ln(−ln u), increasing with the uniform. Where the inner logarithm is near −1, and the outer one near 0, both are
/// taken of what is left of 1, so that the digits stay.
///
#[cfg_attr(doc, doc = include_str!("../pictures/gumbel.html"))]
///
/// # Density
/// e^(−(t + e^(−t)))/β with t = (x − μ)/β, at least 2⁻¹⁴⁹ for every finite x.
///
/// # Domain
/// - Point: drawn samples lie from −3.13β to 22.9β about the location. Uniforms on the 24-bit grid give −2.81β to 16.6β,
///   except u = 0: it counts as 2⁻¹⁴⁹ and gives −4.64β. If you pass uniforms of your own, take them from
///   [`uniform::open`](crate::uniform::open()), which is never 0.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the location or of the distance from it, whichever is larger. *Pdf*
/// and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, ulp of location or distance | 5 | 5 |
/// | pdf, relative | 2.2e-6 | 2.2e-6 |
/// | realised density, relative | 5e-7 + 3*s/max(0, 1 - w/1e6) | 5e-7 + 3*s/max(0, 1 - w/1e6) |
/// | inverse | 9.5e-8 | 9.5e-8 |
/// | round trip | 1e-7 + 2*r | 1e-7 + 2*r |
///
/// w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
/// a factor. s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// <!-- generated: cost Gumbel -->
/// Instructions of a draw, PCG32 included, and bytes of flash:
/// - `poly`: 119 on a Cortex-M4F (1,616 bytes), 5,124 on a Cortex-M0, 186 as WASM.
/// - `libm`: 153 on a Cortex-M4F (1,088 bytes), 6,527 on a Cortex-M0, 255 as WASM.
/// <!-- end -->
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let flood = mw::Gumbel::new(4.0, 0.5)?; // the highest water of a year
/// assert!((flood.sample(0.99) - 6.300_075).abs() < 1e-5); // once in a hundred years
/// assert!((flood.invert(4.0) - 0.367_879_4).abs() < 1e-6); // 1/e
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Weibull`](super::Weibull): the smallest of many numbers above 0. The logarithm of a Weibull number is a Gumbel number,
///   negated.
/// - [`Logistic`](super::Logistic): the difference of two of these.
/// - [`Cdf`](crate::discrete::Cdf): an index by weight at one uniform, where the largest ln(weight) plus a standard Gumbel
///   number (Gumbel-max) takes one for each weight.
///
/// # Source
/// E. J. Gumbel, "Statistics of Extremes", 1958, <https://doi.org/10.7312/gumb92958>. The form near 0 is this crate's own.
#[doc(alias = "extreme_value")]
#[doc(alias = "gev")]
#[doc(alias = "gumbel_max")]
#[doc(alias = "log_weibull")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gumbel<T>(Located<T>);

located!(Gumbel);

impl<T: Tier> Warp for Gumbel<T> {
    located_warp!();
}

impl<T: Tier> Invert for Gumbel<T> {
    located_inverse!();
}

impl<T: Tier> Standard for Gumbel<T> {
    const PEAK: f32 = 1.0;
    const REACH: f32 = 23.0;

    #[inline]
    fn deviate(tail: f32, upper: bool) -> f32 {
        // Between the quantiles of e^-2 and e^-1/2 the logarithm of u is within a factor of 2 of -1.
        if tail > if upper { 0.393_469_3 } else { 0.135_335_3 } {
            // e·u - 1, with e·(1 - tail) - 1 as (e - 1) - e·tail.
            let (product, dropped) = two_product(tail, E.0);
            let dropped = dropped + tail * E.1;
            let rise = if upper {
                ((E.0 - 1.0) - product) - (dropped - E.1)
            } else {
                (product - 1.0) + dropped
            };
            // -ln u = 1 - ln(e·u).
            -T::ln_1p(-T::ln_1p(rise))
        } else if upper {
            -T::ln(T::neg_ln_1m(tail))
        } else {
            -T::ln(-T::ln(tail))
        }
    }

    #[inline]
    fn density(peak: f32, (t, rest): (f32, f32)) -> f32 {
        // Beyond these the density is 0, or e^-t nothing beside t.
        let power = if t < -7.0 {
            return 0.0;
        } else if t < 40.0 {
            // An error of e^-t is one of the exponent, and so relative in the density.
            let (exact, small) = times(LOG2_E, -t);
            exp2_pair(exact, small - rest * LOG2_E.0)
        } else {
            (0.0, 0.0)
        };
        let (sum, dropped) = two_sum(-t, -power.0);
        decayed::<T>(peak, (sum, dropped - power.1 - rest))
    }

    #[inline]
    fn cdf(t: f32) -> f32 {
        T::exp(-T::exp(-t))
    }
}
