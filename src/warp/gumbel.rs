//! The Gumbel distribution.

use super::location_scale::{
    LocationScale, Standard, decayed, invert, location_scale, location_scale_warp,
};
use super::{Invert, Warp, drawn_with_pdf};
use crate::num::{Scaled, above_zero, doubles, middle, representable, tail, two_sum};
use crate::tier::{LOG2_E, Tier, exp2_pair, log2, neg_log2_1m, neg_log2_1m_of_word, times};
use crate::uniform::Canonical;

/// Gumbel with a location and a scale: the largest of many numbers whose tail is exponential.
///
/// x = μ − β ln(−ln u), increasing with the uniform, by a table of logarithms that takes all digits of a word.
///
#[cfg_attr(doc, doc = include_str!("../pictures/gumbel.html"))]
///
/// # Density
/// e^(−(t + e^(−t)))/β with t = (x − μ)/β, at least 2⁻¹⁴⁹ for every finite x. [`sample_with_pdf`](Warp::sample_with_pdf)
/// takes it from the uniform, as −u ln(u)/β.
///
/// # Domain
/// - Point: drawn samples lie from −3.13β to 22.9β about the location. Uniforms on the 24-bit grid give −2.81β to 16.6β,
///   except u = 0: it counts as 2⁻¹⁴⁹ and gives −4.64β. If you pass uniforms of your own, take them from
///   [`uniform::open`](crate::uniform::open()), which is never 0.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the location, of the distance from it or of the scale, whichever is
/// largest. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What
/// each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of location or distance | 5.9 | proven |
/// | pdf, relative | 3.7e-6 | found |
/// | realised density, relative | 5e-7 + 6*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 5e-7 | proven |
/// | inverse | 1.3e-7 | found |
/// | round trip | 1.4e-7 + 2.2*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// A draw keeps the bound of a sample at the exact middle of its word. w is |location|/scale. No realised density is stated from
/// 1e6 on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and the
/// change of the inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Gumbel -->73 instructions and 296 bytes of code on an M4F, 2,340 instructions on an M0<!-- -->.
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
/// E. J. Gumbel, "Statistics of Extremes", 1958, <https://doi.org/10.7312/gumb92958>. The form by tables is this crate's own.
#[doc(alias = "extreme_value")]
#[doc(alias = "gev")]
#[doc(alias = "gumbel_max")]
#[doc(alias = "log_weibull")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gumbel<T>(LocationScale<T>);

location_scale!(Gumbel);

/// −ln(−ln u) of −log₂u, a whole number and a rest.
#[inline]
fn from_neg_log2((whole, rest): (f32, f32)) -> f32 {
    /// −ln ln 2.
    const AT_ONE: f32 = -doubles::ln(core::f64::consts::LN_2) as f32;
    let (whole, rest) = log2(whole + rest);
    AT_ONE - (whole + rest) * core::f32::consts::LN_2
}

/// −log₂u of the tail on one side, a whole number and a rest.
#[inline]
fn neg_log2(tail: f32, upper: bool) -> (f32, f32) {
    if upper {
        neg_log2_1m(tail)
    } else if tail < f32::MIN_POSITIVE {
        let (whole, rest) = log2(tail * 8_388_608.0);
        (23.0 - whole, -rest)
    } else {
        let (whole, rest) = log2(tail);
        (-whole, -rest)
    }
}

impl<T: Tier> Gumbel<T> {
    /// The point of −log₂u and its density.
    #[inline]
    fn with_pdf(&self, log: (f32, f32), u: f32) -> (f32, f32) {
        let (peak, hazard) = (self.0.peak, (log.0 + log.1) * core::f32::consts::LN_2);
        let density = if u > 1.0e-30 {
            peak * (hazard * u)
        } else {
            // Their product would lose digits that the density may have.
            let share = Scaled::of(hazard).times(Scaled::of(u));
            Scaled::of(peak).times(share).value()
        };
        (self.at(from_neg_log2(log)), representable(density))
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        self.with_pdf(neg_log2_1m_of_word(!word), middle(word))
    }
}

impl<T: Tier> Warp for Gumbel<T> {
    location_scale_warp!();

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let u = above_zero(u.get());
        self.with_pdf(neg_log2(tail(u), u >= 0.5), u)
    }

    drawn_with_pdf!(from of_word_with_pdf);
}

impl<T: Tier> Invert for Gumbel<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        invert::<T, Self>(&self.0, x)
    }
}

impl<T: Tier> Standard for Gumbel<T> {
    const PEAK: f32 = 1.0;
    const REACH: f32 = 23.0;

    #[inline]
    fn deviate(tail: f32, upper: bool) -> f32 {
        from_neg_log2(neg_log2(tail, upper))
    }

    #[inline]
    fn of_word(word: u32) -> f32 {
        from_neg_log2(neg_log2_1m_of_word(!word))
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
