//! The exponential distribution, in both orientations.

use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, positive, tried};
use crate::num::{above_zero, into_unit, representable};
use crate::tier::{Tier, exp_of_product, scaled_exp_of_product};
use crate::uniform::{Canonical, deep, open_full};
use core::marker::PhantomData;
use rand_core::TryRng;

/// The smallest accepted rate: −ln 2⁻¹⁴⁹ divided by it is finite.
const MIN_RATE: f32 = 104.0 / f32::MAX;

const fn checked_rate(rate: f32) -> Result<f32, Error> {
    match positive(rate, 0) {
        Ok(rate) if rate < MIN_RATE => Err(Error::TooLarge(0)),
        other => other,
    }
}

const fn rate_of_mean(mean: f32) -> Result<f32, Error> {
    match positive(mean, 0) {
        Ok(mean) if (1.0 / mean).is_finite() => Ok(1.0 / mean),
        Ok(_) => Err(Error::Empty(0)),
        Err(e) => Err(e),
    }
}

/// Exponential with rate a, increasing with the uniform: free paths, waiting times.
///
/// x = −ln(1 − u)/a.
///
#[cfg_attr(doc, doc = include_str!("../pictures/exponential.html"))]
///
/// # Density
/// a e^(−ax) for x ≥ 0, else 0.
///
/// # Domain
/// - Point: [0, 16.64/a]. The largest uniform sets the largest sample.
/// - Uniforms: one.
/// - Parameters: a rate, or a mean, above 0.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp | 2.4 | 3.2 | proven |
/// | pdf, relative | 2.8e-7 | 2.8e-7 | found |
/// | realised density, relative | 3e-7 + 2*s | 3.4e-7 + 2.9*s | found |
/// | pdf with the sample, relative | 1.2e-7 | 1.2e-7 | proven |
/// | inverse | 8.5e-8 | 8.5e-8 | found |
/// | round trip | 4.3e-8 + 2.2*r | 4.3e-8 + 2.2*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Exponential -->52 instructions and 220 bytes of code on an M4F, 1,780 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let free_path = mw::Exponential::from_rate(2.0)?;
/// assert_eq!(free_path.sample(0.0), 0.0);
/// assert!((free_path.sample(0.5) - 0.346_573_6).abs() < 1e-7);
/// assert_eq!(free_path.pdf(0.0), 2.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`ExponentialTail`](super::ExponentialTail) reaches far beyond 16.64/a.
/// - [`TruncatedExponential`](super::TruncatedExponential): on [0, X].
/// - [`rejection::ZigguratExponential`](crate::rejection::ZigguratExponential) is the fastest one number at a time, from
///   a generator and without an inverse. Into a slice on a PC, [`fill`](crate::Warp::fill) of this type is the fastest.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
#[doc(alias = "exp")]
#[doc(alias = "poisson_process")]
#[doc(alias = "free_path")]
#[doc(alias = "waiting_time")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Exponential<T> {
    rate: f32,
    tier: PhantomData<T>,
}

/// What both orientations are made by, and what they tell.
macro_rules! of_a_rate {
    ($($name:ident)*) => {$(
        impl<T: Tier> $name<T> {
            /// Exponential with the given rate (the reciprocal of the mean).
            ///
            /// # Errors
            /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less,
            /// [`Error::TooLarge`] for a rate so small that the tail overflows (below 3.1e-37).
            pub const fn from_rate(rate: f32) -> Result<Self, Error> {
                let rate = tried!(checked_rate(rate));
                Ok(Self {
                    rate,
                    tier: PhantomData,
                })
            }

            /// Exponential with the given mean. Its rate is 1/mean, rounded to `f32`.
            ///
            /// # Errors
            /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::Empty`] for a mean so
            /// small that the density overflows (below 2.9e-39), [`Error::TooLarge`] for one so large that the tail does (above
            /// 3.2e36).
            pub const fn from_mean(mean: f32) -> Result<Self, Error> {
                let rate = tried!(rate_of_mean(mean));
                Self::from_rate(rate)
            }

            /// The rate.
            #[must_use]
            pub const fn rate(&self) -> f32 {
                self.rate
            }

            /// The mean, 1/rate rounded to `f32`.
            #[must_use]
            pub const fn mean(&self) -> f32 {
                1.0 / self.rate
            }
        }
    )*};
}
of_a_rate!(Exponential ExponentialTail);

fn density<T: Tier>(rate: f32, x: f32) -> f32 {
    if (0.0..=f32::MAX).contains(&x) {
        representable(scaled_exp_of_product::<T>(rate, -rate, x))
    } else {
        0.0
    }
}

impl<T: Tier> Warp for Exponential<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        T::neg_ln_1m(u.get()) / self.rate
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        density::<T>(self.rate, x)
    }

    /// Blocks do not take this way: they compute with vectors.
    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Self::Point, R::Error>
    where
        Self: Sized,
    {
        Ok(T::neg_ln_1m_of_word(rng.try_next_u32()?) / self.rate)
    }

    super::filled_in_blocks!(where T::VECTORS);

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        (self.sample_canonical(u), self.rate * (1.0 - u.get()))
    }

    drawn_with_pdf!();
}

impl<T: Tier> Invert for Exponential<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        into_unit(-T::exp_m1(-self.rate * x))
    }
}

/// Exponential with rate a, decreasing with the uniform, so that samples reach far into the tail.
///
/// x = −ln(u)/a. Small uniforms keep their precision in `f32`, so this orientation reaches 44.36/a from
/// full-resolution uniforms, which is what [`Warp::draw`] takes here (45.06/a where all 64 bits are 0). An explicit
/// u = 0 counts as 2⁻¹⁴⁹ and gives 103.28/a.
///
#[cfg_attr(doc, doc = include_str!("../pictures/exponential_tail.html"))]
///
/// # Density
/// a e^(−ax) for x ≥ 0, else 0.
///
/// # Domain
/// - Point: [5.9e-8/a, 103.28/a].
/// - Uniforms: one. Drawing takes **two** words of the generator for it.
/// - Parameters: a rate, or a mean, above 0.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp | 2.6 | 3 | proven |
/// | pdf, relative | 7.4e-7 | 7.4e-7 | found |
/// | realised density, relative | 3e-7 + 2*s | 3e-7 + 2*s | found |
/// | pdf with the sample, relative | 6e-8 | 6e-8 | proven |
/// | inverse | 8.4e-8 | 8.4e-8 | found |
/// | round trip | 5.3e-8 + 2.6*r | 5.3e-8 + 2.6*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost ExponentialTail -->85 instructions and 592 bytes of code on an M4F, 2,149 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let decay = mw::ExponentialTail::from_rate(1.0)?;
/// assert!(decay.sample(2.0_f32.powi(-60)) > 41.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Exponential`](super::Exponential) takes one word, and is enough where the tail beyond 16.64/a (a part of
///   6e-8) does not matter.
/// - [`rejection::ZigguratExponential`](crate::rejection::ZigguratExponential): the fastest one number at a time, without
///   an inverse.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", 1951.
#[doc(alias = "exp")]
#[doc(alias = "tail")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExponentialTail<T> {
    rate: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> Warp for ExponentialTail<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        -T::ln(above_zero(u.get())) / self.rate
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        density::<T>(self.rate, x)
    }

    /// The point of a single word. The tail ends at 22.87/a then.
    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.sample_canonical(deep(word))
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<f32, R::Error> {
        Ok(self.sample_canonical(try_open_full(rng)?))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let density = above_zero(self.rate * above_zero(u.get()));
        (self.sample_canonical(u), density)
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<(f32, f32), R::Error> {
        Ok(self.sample_canonical_with_pdf(try_open_full(rng)?))
    }
}

/// A uniform of full resolution that is never 0, from two words.
#[inline]
fn try_open_full<R: TryRng + ?Sized>(rng: &mut R) -> Result<Canonical<f32>, R::Error> {
    let high = rng.try_next_u32()?;
    let low = rng.try_next_u32()?;
    Ok(open_full(high, low))
}

impl<T: Tier> Invert for ExponentialTail<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        into_unit(exp_of_product::<T>(-self.rate, x))
    }
}
