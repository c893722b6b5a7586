//! The exponential distribution, of mean 1 and of any mean.

use super::direction::{Scaled, UNIT};
use super::grade::{Fine, Grade};
use super::kernel::product::high;
use super::kernel::quotient::{ratio, reciprocal};
use super::{Density, Length, Uniform};
use crate::error::{Error, tried};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedU32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Exponential with mean 1, increasing with the uniform: −ln(1 − u).
///
/// # Density
/// e⁻ˣ for every length, at least 2⁻³².
///
/// # Domain
/// - Point: [0, 22.19].
/// - Uniforms: one word.
///
/// # Accuracy
/// *Sample* is the absolute error, over all words, and *pdf* that of the density, over all lengths. *Round trip* is the
/// error of the uniform after `sample` and `invert`.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 5.2e-7 | 3.4e-5 | 4.2e-7 | exhaustive |
/// | sample, rms | 1.9e-7 | 1.4e-5 | 1.3e-7 | found |
/// | sample, mean | 1.7e-7 | 1.2e-5 | -8.6e-9 | found |
/// | pdf | 9.7e-7 | 8.4e-5 | 1.2e-7 | found |
/// | round trip | 1.2e-6 | 8.4e-5 | 4.6e-7 | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed StandardExponential -->96 instructions and 248 bytes of code on an M0, 47 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let waiting = mw::StandardExponential::new();
/// assert_eq!(waiting.sample(U0F32::ZERO), 0);
/// assert!((waiting.sample(U0F32::from_num(0.5)).to_num::<f64>() - 0.693_147).abs() < 1e-6);
/// ```
///
/// # See also
/// - [`Exponential`] has any mean.
/// - [`warp::Exponential`](crate::warp::Exponential) is the one of the float tiers, and
///   [`rejection::ZigguratStandardExponential`](crate::rejection::ZigguratStandardExponential) draws it in `f32` at a
///   lower cost.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "poisson_process")]
#[doc(alias = "waiting_time")]
#[doc(alias = "decay")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StandardExponential<G = Fine>(PhantomData<G>);

impl<G: Grade> StandardExponential<G> {
    /// The exponential distribution of mean 1.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<G: Grade> Warp for StandardExponential<G> {
    type Uniforms = Uniform;
    type Point = Length;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> Length {
        G::neg_ln_1m(u.get())
    }

    #[inline]
    fn pdf(&self, x: Length) -> Density {
        let density = G::exp(x.to_bits());
        Density::from_bits(u64::from(density.max(1)))
    }
}

impl<G: Grade> Invert for StandardExponential<G> {
    #[inline]
    fn invert(&self, x: Length) -> Uniform {
        G::exp_m1_neg(x)
    }
}

/// Exponential with a given mean or rate, increasing with the uniform: −ln(1 − u) times the mean.
///
/// The warp stores the mean, since here a product is cheap and a quotient is not.
///
/// # Density
/// e^(−x/mean)/mean for every length, at least 2⁻³².
///
/// # Domain
/// - Point: [0, 22.19 means], in the format of the mean, cut to its step below.
/// - Uniforms: one word.
/// - Parameter: the mean in any unsigned format of 32 bits, or the rate in `U32F32`.
///
/// # Accuracy
/// *Sample* is relative to the mean, beyond a step of the format. *Pdf* is relative to the largest density, beyond a
/// step of 2⁻³². *Round trip* is the error of the uniform after `sample` and `invert`. The mean is n steps of the format.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 6.3e-7 | 4.1e-5 | 5.1e-7 | found |
/// | pdf | 9.8e-7 | 8.4e-5 | 1.3e-7 | found |
/// | round trip | 1.2e-6 + 1.4/n | 9.1e-5 + 1.4/n | 5.2e-7 + 1.4/n | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Exponential -->127 instructions and 304 bytes of code on an M0, 53 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{U0F32, U16F16};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let waiting = mw::Exponential::from_mean(U16F16::from_num(20))?;
/// assert_eq!(waiting.sample(U0F32::ZERO), 0);
/// assert!((waiting.sample(U0F32::from_num(0.5)).to_num::<f64>() - 13.862_94).abs() < 1e-4);
/// assert!((waiting.pdf(U16F16::ZERO).to_num::<f64>() - 0.05).abs() < 1e-9);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`StandardExponential`] has mean 1, at lower cost.
/// - [`TruncatedExponential`](super::TruncatedExponential) ends at a length.
/// - [`warp::Exponential`](crate::warp::Exponential) is the one of the float tiers.
///
/// # Source
/// J. von Neumann, "Various Techniques Used in Connection with Random Digits", National Bureau of Standards Applied
/// Mathematics Series 12, 1951.
#[doc(alias = "poisson_process")]
#[doc(alias = "waiting_time")]
#[doc(alias = "free_path")]
#[doc(alias = "decay")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exponential<Frac, G = Fine> {
    mean: u32,
    /// 1/mean.
    height: Scaled,
    format: PhantomData<(Frac, G)>,
}

/// The largest accepted mean in steps: the largest sample, below 22.19 means, still fits.
const LARGEST: u32 = 193_554_181;

impl<Frac: LeEqU32, G: Grade> Exponential<Frac, G> {
    /// Exponential with the given mean.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0, [`Error::TooLarge`] if 22.19 means overflow the format.
    pub const fn from_mean(mean: FixedU32<Frac>) -> Result<Self, Error> {
        match mean.to_bits() {
            0 => Err(Error::NotPositive(0)),
            bits if bits > LARGEST => Err(Error::TooLarge(0)),
            bits => Ok(Self {
                mean: bits,
                height: UNIT.over(Scaled::of(bits as u64, Frac::I32)),
                format: PhantomData,
            }),
        }
    }

    /// Exponential with the given rate, the reciprocal of the mean.
    ///
    /// The mean is 1/`rate`, rounded to the nearest step of the format of the points.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0, [`Error::Empty`] for a mean that rounds to 0 and for any rate above 2³¹,
    /// [`Error::TooLarge`] if 22.19 means overflow the format.
    pub const fn from_rate(rate: Density) -> Result<Self, Error> {
        let mean = tried!(mean_of(rate));
        Self::from_mean(mean)
    }

    /// The mean.
    #[must_use]
    pub const fn mean(&self) -> FixedU32<Frac> {
        FixedU32::from_bits(self.mean)
    }

    /// The rate: 1/mean, rounded to the nearest step of 2⁻³², or the largest [`Density`] if it does not fit.
    #[must_use]
    pub const fn rate(&self) -> Density {
        rate_of(self.mean())
    }
}

/// 1/rate, rounded to the nearest step.
pub(super) const fn mean_of<Frac: LeEqU32>(rate: Density) -> Result<FixedU32<Frac>, Error> {
    match rate.to_bits() {
        0 => Err(Error::NotPositive(0)),
        bits if bits > 1 << 63 => Err(Error::Empty(0)),
        bits => match reciprocal(32 + Frac::U32, bits) {
            0 => Err(Error::Empty(0)),
            steps if steps > u32::MAX as u64 => Err(Error::TooLarge(0)),
            steps => Ok(FixedU32::from_bits(steps as u32)),
        },
    }
}

/// 1/mean, rounded to the nearest step.
pub(super) const fn rate_of<Frac: LeEqU32>(mean: FixedU32<Frac>) -> Density {
    Density::from_bits(reciprocal(32 + Frac::U32, mean.to_bits() as u64))
}

impl<Frac: LeEqU32, G: Grade> Warp for Exponential<Frac, G> {
    type Uniforms = Uniform;
    type Point = FixedU32<Frac>;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> FixedU32<Frac> {
        let log = G::log(u.get().to_bits());
        FixedU32::from_bits(of_means(log, self.mean))
    }

    #[inline]
    fn pdf(&self, x: FixedU32<Frac>) -> Density {
        let means = in_means(x.to_bits(), self.mean);
        self.height.density(G::exp(means.to_bits()))
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for Exponential<Frac, G> {
    #[inline]
    fn invert(&self, x: FixedU32<Frac>) -> Uniform {
        G::exp_m1_neg(in_means(x.to_bits(), self.mean))
    }
}

#[cfg(feature = "defmt")]
impl<Frac, G> defmt::Format for Exponential<Frac, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "Exponential {{ mean: {=u32} }}", self.mean);
    }
}

/// ⌊a·mean⌋ for a in Q27; the product has to fit.
#[inline]
pub(super) fn of_means(a: u32, mean: u32) -> u32 {
    high(a, mean) << 5 | a.wrapping_mul(mean) >> 27
}

/// x/mean, cut, and at most just below 32.
#[inline]
pub(super) fn in_means(x: u32, mean: u32) -> Length {
    Length::from_bits(u32::try_from(ratio(x, mean) >> 5).unwrap_or(u32::MAX))
}
