//! The logistic distribution.

use super::location_scale::{
    LocationScale, Standard, decayed, invert, location_scale, location_scale_warp,
};
use super::{Invert, Warp, drawn_with_pdf};
use crate::num::{above_zero, folded, power_of_two_times, representable};
use crate::tier::{LN_2, Tier};
use crate::uniform::Canonical;

/// Logistic with a location and a scale, whose CDF is the logistic function (sigmoid).
///
/// x = μ + s ln(u/(1 − u)), increasing with the uniform, by a power of 2 and a series in (1 − 2p) of the probability p of the
/// tail, which does not cancel at the median.
///
#[cfg_attr(doc, doc = include_str!("../pictures/logistic.html"))]
///
/// # Density
/// e^(−t)/(s(1 + e^(−t))²) with t = |x − μ|/s, at least 2⁻¹⁴⁹ for every finite x.
/// [`sample_with_pdf`](Warp::sample_with_pdf) takes it from the uniform, as u(1 − u)/s.
///
/// # Domain
/// - Point: drawn samples end at 22.9s on both sides. Uniforms on the 24-bit grid give −16.6s to 16.6s, except u = 0: it
///   counts as 2⁻¹⁴⁹ and gives −103.3s. If you pass uniforms of your own, take them from
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
/// | sample, ulp of location or distance | 5.8 | proven |
/// | pdf, relative | 8.9e-7 | found |
/// | realised density, relative | 5e-7 + 4.5*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 3e-7 | proven |
/// | inverse | 1.6e-7 | found |
/// | round trip | 1.5e-7 + 1.9*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// A draw keeps the bound of a sample at the exact middle of its word. w is |location|/scale. No realised density is stated from
/// 1e6 on, where the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and the
/// change of the inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Logistic -->61 instructions and 272 bytes of code on an M4F, 2,303 instructions on an M0<!-- -->.
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
pub struct Logistic<T>(LocationScale<T>);

location_scale!(Logistic);

/// ln(a/b) for a normal b up to a; to a few units in the last place of 1 where the two are within a factor of 1.5, which is
/// all that the difference keeps.
#[inline]
#[expect(clippy::cast_possible_wrap, reason = "an exponent with its sign")]
fn log_of_ratio(a: f32, b: f32) -> f32 {
    // The power of 2 that brings b within that factor of a.
    let twos = (a
        .to_bits()
        .wrapping_sub(b.to_bits())
        .wrapping_add(0x0040_0000) as i32)
        >> 23;
    let b = power_of_two_times(b, twos);
    let s = (a - b) / (a + b);
    let w = s * s;
    // The series of 2 artanh s. What it leaves out is below 1e-8 of it.
    let series = 2.0 / 3.0 + w * (2.0 / 5.0 + w * (2.0 / 7.0 + w * (2.0 / 9.0)));
    twos as f32 * LN_2.0 + (2.0 * s + s * w * series)
}

impl<T: Tier> Logistic<T> {
    /// The density at the point with this probability on either side.
    #[inline]
    fn density_of_tail(&self, tail: f32) -> f32 {
        representable(self.0.peak * (tail * (1.0 - tail)))
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        let (tail, _) = folded(word);
        (self.sample_words(word), self.density_of_tail(tail))
    }
}

impl<T: Tier> Warp for Logistic<T> {
    location_scale_warp!();

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let density = self.density_of_tail(above_zero(u.get()));
        (self.sample_canonical(u), density)
    }

    drawn_with_pdf!(from of_word_with_pdf);

    super::filled_in_blocks!();
}

impl<T: Tier> Invert for Logistic<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        invert::<T, Self>(&self.0, x)
    }
}

impl<T: Tier> Standard for Logistic<T> {
    const PEAK: f32 = 1.0;
    const REACH: f32 = 104.0;

    #[inline]
    fn deviate(tail: f32, upper: bool) -> f32 {
        let size = if tail < f32::MIN_POSITIVE {
            // 1 is the rest to all digits.
            log_of_ratio(1.0, tail * 8_388_608.0) + 23.0 * LN_2.0
        } else {
            log_of_ratio(1.0 - tail, tail)
        };
        if upper { size } else { -size }
    }

    #[inline]
    fn of_word(word: u32) -> f32 {
        let (tail, upper) = folded(word);
        let size = log_of_ratio(1.0 - tail, tail);
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
