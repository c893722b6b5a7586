//! The logistic distribution.

use super::located::{Located, Standard, decayed, located, located_inverse, located_warp};
use super::{Invert, Warp};
use crate::tier::Tier;

/// Logistic with a location and a scale, whose CDF is the logistic function (sigmoid).
///
/// x = μ + s ln(u/(1 − u)), increasing with the uniform, by ln(1 + (1 − 2p)/p) of the probability p of the tail, which does
/// not cancel at the median.
///
#[cfg_attr(doc, doc = include_str!("../pictures/logistic.html"))]
///
/// # Density
/// e^(−t)/(s(1 + e^(−t))²) with t = |x − μ|/s, at least 2⁻¹⁴⁹ for every finite x.
///
/// # Domain
/// - Point: drawn samples end at 22.9s on both sides. Uniforms on the 24-bit grid give −16.6s to 16.6s, except u = 0: it
///   counts as 2⁻¹⁴⁹ and gives −103.3s. If you pass uniforms of your own, take them from
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
/// | sample, ulp of location or distance | 3.7 | 4 |
/// | pdf, relative | 5.8e-7 | 5.8e-7 |
/// | realised density, relative | 5e-7 + 2.5*s/max(0, 1 - w/1e6) | 5e-7 + 2.5*s/max(0, 1 - w/1e6) |
/// | inverse | 1.1e-7 | 1.1e-7 |
/// | round trip | 1.1e-7 + 1.7*r | 1.1e-7 + 1.7*r |
///
/// w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
/// a factor. s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// <!-- generated: cost Logistic -->
/// Instructions of a draw, PCG32 included, and bytes of flash:
/// - `poly`: 91 on a Cortex-M4F (960 bytes), 3,450 on a Cortex-M0, 142 as WASM.
/// - `libm`: 101 on a Cortex-M4F (764 bytes), 3,859 on a Cortex-M0, 162 as WASM.
/// <!-- end -->
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let logit = mw::Logistic::new(0.0, 1.0)?;
/// assert_eq!(logit.sample(0.5), 0.0);
/// assert!((logit.sample(0.75) - 1.098_612_3).abs() < 1e-6); // ln 3
/// assert_eq!(logit.pdf(0.0), 0.25);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Laplace`](super::Laplace): the same tails, with a corner at the median.
/// - [`Gumbel`](super::Gumbel): the difference of two Gumbel numbers of one scale is logistic.
/// - [`Normal`](super::Normal): lighter tails.
///
/// # Source
/// N. Balakrishnan (editor), "Handbook of the Logistic Distribution", 1992.
#[doc(alias = "sigmoid")]
#[doc(alias = "logit")]
#[doc(alias = "sech_squared")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Logistic<T>(Located<T>);

located!(Logistic);

impl<T: Tier> Warp for Logistic<T> {
    located_warp!();
}

impl<T: Tier> Invert for Logistic<T> {
    located_inverse!();
}

impl<T: Tier> Standard for Logistic<T> {
    const PEAK: f32 = 1.0;
    const REACH: f32 = 104.0;

    #[inline]
    fn deviate(tail: f32, upper: bool) -> f32 {
        // Of smaller tails the quotient may overflow, and 1 is the rest to 24 digits.
        let size = if tail < 1.0e-9 {
            -T::ln(tail)
        } else {
            T::ln_1p((1.0 - 2.0 * tail) / tail)
        };
        if upper { size } else { -size }
    }

    #[inline]
    fn density(peak: f32, (t, rest): (f32, f32)) -> f32 {
        let exponent = if t > 0.0 { (-t, -rest) } else { (t, rest) };
        let both = 1.0 + T::exp(exponent.0);
        decayed::<T>(peak, exponent) / (both * both)
    }

    #[inline]
    fn cdf(t: f32) -> f32 {
        let power = T::exp(-t.abs());
        if t > 0.0 {
            1.0 / (1.0 + power)
        } else {
            power / (1.0 + power)
        }
    }
}
