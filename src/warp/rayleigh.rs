//! The Rayleigh distribution.

use super::location_scale::{decayed, density_by_tails, standardised, uniforms_by_tails};
use super::normal::exponent;
use super::{Invert, Warp};
use crate::error::{Error, positive};
use crate::num::{above_zero, folded, into_unit, representable};
use crate::tier::Tier;
use core::marker::PhantomData;

/// Rayleigh with a scale σ: the length of a vector of two normal numbers of deviation σ.
///
/// x = σ√(−2 ln(1 − u)), increasing with the uniform.
///
#[cfg_attr(doc, doc = include_str!("../pictures/rayleigh.html"))]
///
/// # Density
/// x e^(−x²/2σ²)/σ² for x ≥ 0, else 0.
///
/// # Domain
/// - Point: drawn samples lie from 1.5e-5σ to 6.76σ. Uniforms on the 24-bit grid reach 5.77σ; u = 0 counts as 2⁻¹⁴⁹, and
///   gives 5.3e-23σ.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a scale above 0 for which neither samples nor the density overflow.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 2.7 | proven |
/// | pdf, relative | 1.2e-6 | found |
/// | realised density, relative | 5.5e-7 + 2.5*s | found |
/// | pdf with the sample, relative | 4e-7 | proven |
/// | inverse | 1.3e-7 | found |
/// | round trip | 1e-7 + 1.5*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Rayleigh -->65 instructions and 632 bytes of code on an M4F, 2,739 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let wave = mw::Rayleigh::new(2.0)?; // heights of waves, envelopes of noise
/// assert!((wave.sample(0.5) - 2.354_820_1).abs() < 1e-6); // σ√(2 ln 2)
/// assert!((wave.invert(2.0) - 0.393_469_3).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`NormalPair`](super::NormalPair): the vector itself.
/// - [`Weibull`](super::Weibull): of shape 2 and scale σ√2 it is this distribution.
///
/// # Source
/// Lord Rayleigh, "On the Resultant of a Large Number of Vibrations of the Same Pitch and of Arbitrary Phase", 1880,
/// <https://doi.org/10.1080/14786448008626893>.
#[doc(alias = "envelope")]
#[doc(alias = "fading")]
#[doc(alias = "wind_speed")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rayleigh<T> {
    scale: f32,
    /// 1/scale.
    peak: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> Rayleigh<T> {
    /// Rayleigh with this scale, the deviation of each coordinate of the vector.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::TooLarge`] if a sample
    /// could overflow, [`Error::Empty`] if the density could.
    pub const fn new(scale: f32) -> Result<Self, Error> {
        match positive(scale, 0) {
            Ok(scale) if !(7.0 * scale).is_finite() => Err(Error::TooLarge(0)),
            Ok(scale) if !(1.0 / scale).is_finite() => Err(Error::Empty(0)),
            Ok(scale) => Ok(Self {
                scale,
                peak: 1.0 / scale,
                tier: PhantomData,
            }),
            Err(e) => Err(e),
        }
    }

    /// The scale.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    #[inline]
    fn beyond(self, tail: f32, upper: bool) -> f32 {
        self.placed(tail, upper).0
    }

    /// The point with this probability beyond it, and its density: its distance times the probability above it.
    #[inline]
    fn placed(self, tail: f32, upper: bool) -> (f32, f32) {
        let (log, above) = if upper {
            (-T::ln(tail), tail)
        } else {
            (T::neg_ln_1m(tail), 1.0 - tail)
        };
        let root = T::sqrt(2.0 * log);
        let density = above_zero(self.peak * (root * above));
        (self.scale * root, density)
    }
}

impl<T: Tier> Warp for Rayleigh<T> {
    uniforms_by_tails!();

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        let (tail, upper) = folded(word);
        self.beyond(tail, upper)
    }

    density_by_tails!();

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if (0.0..=f32::MAX).contains(&x) {
            let t = standardised(x, 0.0, self.scale);
            representable(decayed::<T>(self.peak, exponent(t)) * t.0)
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Rayleigh<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let t = x / self.scale;
        into_unit(if t > 0.0 {
            -T::exp_m1(-0.5 * t * t)
        } else {
            0.0
        })
    }
}
