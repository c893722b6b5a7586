//! Laplace's and the logistic distribution, both of which fall off exponentially on either side.

use super::direction::{Scaled, UNIT};
use super::exponential::{in_means, of_means};
use super::grade::{Fine, Grade, Kernels};
use super::kernel::log::LN_2;
use super::kernel::product::high;
use super::kernel::quotient::quotient;
use super::{Density, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedI32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Laplace's distribution, also called double exponential: noise with heavy tails.
///
/// With t = 2u below the middle and 2(1 − u) above, x = location ± scale·ln t. The uniform is the middle of the word, so
/// that no point is infinite.
///
/// # Density
/// e^(−|x − location|/scale)/(2 scale), at least 2⁻³².
///
/// # Domain
/// - Point: up to 22.19 scales from the location, in the format of both, cut towards the location.
/// - Uniforms: one word.
/// - Parameters: the location and a scale > 0, in one signed format of 32 bits, in which all points fit.
///
/// # Accuracy
/// *Sample* is relative to the scale, beyond a step of the format. *Pdf* is relative to the largest density, beyond a
/// step of 2⁻³². *Round trip* is the error of the uniform after `sample` and `invert`. The scale is n steps of the format.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 6.2e-7 | 4.1e-5 | 5e-7 | found |
/// | pdf | 9.8e-7 | 8.4e-5 | 1.3e-7 | found |
/// | round trip | 6.1e-7 + 0.67/n | 4.8e-5 + 0.67/n | 2.8e-7 + 0.67/n | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Laplace -->129 instructions and 308 bytes of code on an M0, 55 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I16F16, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let noise = mw::Laplace::new(I16F16::from_num(10), I16F16::from_num(2))?;
/// let x = noise.sample(U0F32::from_num(0.75));
/// assert!((x.to_num::<f64>() - 11.386_294).abs() < 2e-5);
/// assert!((noise.pdf(I16F16::from_num(10)).to_num::<f64>() - 0.25).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Exponential`](super::Exponential) has one side.
/// - [`Logistic`](super::warp::Logistic) is round at the top.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapter II.2:
/// <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "double_exponential")]
#[doc(alias = "differential_privacy")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Laplace<Frac, G = Fine> {
    location: i32,
    scale: u32,
    /// The density of a shape of 1.
    height: Scaled,
    format: PhantomData<(Frac, G)>,
}

/// The logistic distribution, a bell with tails heavier than the normal one's.
///
/// x = location + scale·ln(u/(1 − u)). The uniform is the middle of the word, so that no point is infinite.
///
/// # Density
/// e⁻ᵐ/(scale (1 + e⁻ᵐ)²) with m = |x − location|/scale, at least 2⁻³².
///
/// # Domain
/// - Point: up to 22.88 scales from the location, in the format of both, cut towards the location.
/// - Uniforms: one word.
/// - Parameters: the location and a scale > 0, in one signed format of 32 bits, in which all points fit. The standard
///   deviation is 1.814 scales.
///
/// # Accuracy
/// *Sample* is relative to the scale, beyond a step of the format. *Pdf* is relative to the largest density, beyond a
/// step of 2⁻³². *Round trip* is the error of the uniform after `sample` and `invert`. The scale is n steps of the format.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 6.2e-7 | 4e-5 | 6.9e-7 | found |
/// | pdf | 5.3e-7 | 3.3e-5 | 7.7e-8 | found |
/// | round trip | 5.4e-7 + 0.34/n | 4e-5 + 0.34/n | 2.8e-7 + 0.34/n | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Logistic -->179 instructions and 432 bytes of code on an M0, 93 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I16F16, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let bell = mw::Logistic::new(I16F16::from_num(10), I16F16::from_num(2))?;
/// let x = bell.sample(U0F32::from_num(0.75));
/// assert!((x.to_num::<f64>() - 12.197_225).abs() < 2e-5);
/// assert!((bell.pdf(I16F16::from_num(10)).to_num::<f64>() - 0.125).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`NormalPair`](super::NormalPair) has lighter tails.
/// - [`Laplace`](super::warp::Laplace) has an edge at the top.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapter II.2:
/// <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "sigmoid")]
#[doc(alias = "logit")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Logistic<Frac, G = Fine> {
    location: i32,
    scale: u32,
    /// The density of a shape of 1.
    height: Scaled,
    format: PhantomData<(Frac, G)>,
}

/// How many words there are from the nearer end to a word, and whether it is in the upper half.
#[inline]
const fn folded(word: u32) -> (u32, bool) {
    let upper = word >> 31 == 1;
    (if upper { !word } else { word }, upper)
}

/// What both have: a location and a scale, of which so many 128ths lie between the location and the last point.
macro_rules! symmetric {
    ($name:ident, $text:literal, $reach:literal, |$least:ident| $height:expr) => {
        impl<Frac: LeEqU32, G: Grade> $name<Frac, G> {
            /// About the location, with the given scale.
            ///
            /// # Errors
            /// [`Error::NotPositive`] for a scale of 0 or less; [`Error::TooLarge`] if points overflow the format.
            pub const fn new(
                location: FixedI32<Frac>,
                scale: FixedI32<Frac>,
            ) -> Result<Self, Error> {
                let (location, scale) = (location.to_bits(), scale.to_bits());
                if scale <= 0 {
                    return Err(Error::NotPositive(1));
                }
                let reach = (scale as u64 * $reach).div_ceil(128);
                if location.unsigned_abs() as u64 + reach > i32::MAX as u64 {
                    return Err(Error::TooLarge(1));
                }
                let $least = Scaled::of(scale as u64, Frac::I32);
                Ok(Self {
                    location,
                    scale: scale as u32,
                    height: UNIT.over($height),
                    format: PhantomData,
                })
            }

            /// The location, which is mean, median and mode.
            #[must_use]
            pub const fn location(&self) -> FixedI32<Frac> {
                FixedI32::from_bits(self.location)
            }

            /// The scale.
            #[must_use]
            pub const fn scale(&self) -> FixedI32<Frac> {
                FixedI32::from_bits(self.scale as i32)
            }

            /// e⁻ᵐ at m scales from the location.
            #[inline]
            fn power(&self, x: FixedI32<Frac>) -> u32 {
                let away = x.to_bits().abs_diff(self.location);
                G::exp(in_means(away, self.scale).to_bits())
            }

            /// The point so far out (Q27 scales), cut.
            #[inline]
            fn point(&self, away: u32, upper: bool) -> FixedI32<Frac> {
                let away = of_means(away, self.scale) as i32;
                FixedI32::from_bits(self.location + if upper { away } else { -away })
            }

            /// The word of a point beyond which there are so many.
            #[inline]
            fn word(&self, x: FixedI32<Frac>, beyond: u32) -> Uniform {
                let upper = x.to_bits() > self.location;
                Uniform::from_bits(if upper { !beyond } else { beyond })
            }
        }

        #[cfg(feature = "defmt")]
        impl<Frac, G> defmt::Format for $name<Frac, G> {
            fn format(&self, f: defmt::Formatter<'_>) {
                defmt::write!(f, $text, self.location, self.scale);
            }
        }
    };
}

symmetric!(
    Laplace,
    "Laplace {{ location: {=i32}, scale: {=u32} }}",
    2841,
    |scale| scale.doubled()
);
symmetric!(
    Logistic,
    "Logistic {{ location: {=i32}, scale: {=u32} }}",
    2929,
    |scale| scale
);

impl<Frac: LeEqU32, G: Grade> Warp for Laplace<Frac, G> {
    type Uniforms = Uniform;
    type Point = FixedI32<Frac>;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> FixedI32<Frac> {
        let (rank, upper) = folded(u.get().to_bits());
        self.point(twice::<G>(rank), upper)
    }

    #[inline]
    fn pdf(&self, x: FixedI32<Frac>) -> Density {
        self.height.density(self.power(x))
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for Laplace<Frac, G> {
    #[inline]
    fn invert(&self, x: FixedI32<Frac>) -> Uniform {
        self.word(x, self.power(x) >> 1)
    }
}

impl<Frac: LeEqU32, G: Grade> Warp for Logistic<Frac, G> {
    type Uniforms = Uniform;
    type Point = FixedI32<Frac>;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> FixedI32<Frac> {
        let (rank, upper) = folded(u.get().to_bits());
        // ln((1 − t)/t) of a part t beyond. In the middle both logarithms are ln 2.
        let away = (twice::<G>(rank) + LN_2).saturating_sub(G::log(rank));
        self.point(away, upper)
    }

    #[inline]
    fn pdf(&self, x: FixedI32<Frac>) -> Density {
        let beyond = sigmoid(self.power(x));
        self.height.density(high(beyond, !beyond))
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for Logistic<Frac, G> {
    #[inline]
    fn invert(&self, x: FixedI32<Frac>) -> Uniform {
        self.word(x, sigmoid(self.power(x)).min(u32::MAX >> 1))
    }
}

/// −ln 2t of the part t beyond the middle of a word.
#[inline]
fn twice<G: Kernels>(rank: u32) -> u32 {
    G::log(!(rank << 1))
}

/// x/(1 + x).
#[inline]
const fn sigmoid(x: u32) -> u32 {
    quotient(x >> 1, (x >> 1) | 1 << 31)
}
