//! The Laplace distribution.

use super::location_scale::{
    LocationScale, Standard, decayed, density_by_tails, invert, location_scale, location_scale_warp,
};
use super::{Invert, Warp};
use crate::num::above_zero;
use crate::tier::Tier;

/// Laplace (double exponential) with a location and a scale: an exponential on both sides of the location.
///
/// x = μ + b ln(2u) below the median and μ − b ln(2(1 − u)) above it, increasing with the uniform.
///
#[cfg_attr(doc, doc = include_str!("../pictures/laplace.html"))]
///
/// # Density
/// e^(−|x−μ|/b)/(2b), at least 2⁻¹⁴⁹ for every finite x.
///
/// # Domain
/// - Point: drawn samples end at 22.2b on both sides. Uniforms on the 24-bit grid give −15.9b to 15.9b, except u = 0: it
///   counts as 2⁻¹⁴⁹ and gives −102.6b. If you pass uniforms of your own, take them from
///   [`uniform::open`](crate::uniform::open()), which is never 0.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the location or of the distance from it, whichever is larger. *Pdf*
/// and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of location or distance | 4 | proven |
/// | pdf, relative | 8.1e-7 | found |
/// | realised density, relative | 6e-7 + 2.6*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 1.6e-7 | proven |
/// | inverse | 8.5e-8 | found |
/// | round trip | 6e-8 + 2*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
/// a factor. s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Laplace -->68 instructions and 516 bytes of code on an M4F, 2,322 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let noise = mw::Laplace::new(10.0, 2.0)?; // a count, made private
/// assert_eq!(noise.sample(0.5), 10.0);
/// assert_eq!(noise.pdf(10.0), 0.25);
/// assert!((noise.invert(12.0) - 0.816_060_3).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Exponential`](super::Exponential): one side.
/// - [`Logistic`](super::Logistic): the same tails without the corner.
/// - [`Normal`](super::Normal): lighter tails.
///
/// # Source
/// S. Kotz, T. J. Kozubowski and K. Podgórski, "The Laplace Distribution and Generalizations", 2001,
/// <https://doi.org/10.1007/978-1-4612-0173-1>.
#[doc(alias = "double_exponential")]
#[doc(alias = "differential_privacy")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Laplace<T>(LocationScale<T>);

location_scale!(Laplace);

impl<T: Tier> Laplace<T> {
    /// The point with this probability beyond it, and its density, which is in proportion to that.
    #[inline]
    fn placed(&self, tail: f32, upper: bool) -> (f32, f32) {
        let density = above_zero(self.0.peak * (2.0 * tail));
        (self.beyond(tail, upper), density)
    }
}

impl<T: Tier> Warp for Laplace<T> {
    location_scale_warp!();
    density_by_tails!();
}

impl<T: Tier> Invert for Laplace<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        invert::<T, Self>(&self.0, x)
    }
}

impl<T: Tier> Standard for Laplace<T> {
    const PEAK: f32 = 0.5;
    const REACH: f32 = 103.0;

    #[inline]
    fn deviate(tail: f32, upper: bool) -> f32 {
        let log = T::ln(2.0 * tail);
        if upper { -log } else { log }
    }

    #[inline]
    fn density(peak: f32, (t, rest): (f32, f32)) -> f32 {
        decayed::<T>(peak, if t > 0.0 { (-t, -rest) } else { (t, rest) })
    }

    #[inline]
    fn cdf(t: f32) -> f32 {
        if t > 0.0 {
            1.0 - 0.5 * T::exp(-t)
        } else {
            0.5 * T::exp(t)
        }
    }
}
