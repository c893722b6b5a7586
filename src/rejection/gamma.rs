//! The gamma distribution.

use super::gamma_density::{of_number, peak};
use super::gamma_tries::{Part, Tries};
use super::{Accepted, Failure, Rejection, draw_first_alone, with_budget};
use crate::error::{Error, positive, tried};
use crate::num::{Scaled, above_zero};
use crate::tier::Tier;
use core::convert::Infallible;
use core::marker::PhantomData;
use rand_core::{Rng, TryRng};

/// Gamma with a shape a and a scale θ: the waiting time for a events, a sum of a exponentials; [chi-squared](Self::chi_squared);
/// the precision of a normal distribution that is learnt.
///
/// A normal number, scaled, shifted and cubed, is accepted or not. Below shape 1 a number of shape a + 1 is multiplied by
/// the a-th root of a uniform; at shape 1 it is the exponential distribution.
///
/// Small shapes have most of their numbers below the smallest `f32`: nine in ten of shape 10⁻³. Such a number is drawn as
/// 2⁻¹⁴⁹, and [`Self::draw_ln`] draws the logarithm instead, which is never out of range.
///
/// # Density
/// xᵃ⁻¹e^(−x/θ)/(Γ(a)θᵃ) for x ≥ 0, of which 0 counts as 2⁻¹⁴⁹; else 0. What `f32` does not hold becomes 2⁻¹⁴⁹ or the
/// largest finite number.
///
/// The reciprocal 1/x is inverse-gamma, of shape a and scale 1/θ: the variance of a normal distribution that is learnt. Its density is
/// that of x times x². From x = 2⁻¹²⁸ down 1/x is infinite in `f32`; its logarithm, minus that of x, is not.
///
/// # Domain
/// - Point: above 0.
/// - Words a try: two. The first proposes, and numbers increase with it; the second decides. Below shape 1 an accepted number
///   takes a third. At shape 1 there is one word, and no try is rejected.
/// - Parameters: a shape from 1e-30 to 1e6, and a scale from 2⁻¹²⁵ up for which no number overflows.
/// - No inverse, as of all [rejection](crate::rejection#no-inverse).
///
/// # Accuracy
/// The words of a point give x = θd(1 + w)³/eᵉ: d is a − 1/3, w is z/√(9d) with the normal quantile z of the first word, and e is
/// 0. Below shape 1, d is a + 2/3, and e is −ln u/a with the uniform u of the third word; at shape 1, x is −θ ln(1 − u).
/// A number has a
/// relative error of 6e-7 (1 + 3|w/(1 + w)|) + 3e-7 e, plus an absolute one of 2⁻¹⁴⁹, against that of its words at the middle of
/// their cells; its logarithm has an
/// absolute error of 6e-7 (1 + 3|w/(1 + w)|) + 5.5e-7 (1 + |ln x| + |ln θ|). It is accepted with its probability to a
/// relative error of 2.8e-6 (1 + 3|w/(1 + w)|), plus an absolute one of 2⁻³³.
///
/// The pdf has a
/// relative error of 3.5e-7 + 2e-10 a|ln(x/aθ)|, or an absolute one of 2⁻¹⁴⁸.
///
/// All of these bounds are found, not proven, over hundreds of shapes of every size.
///
/// # Cost
/// Efficiency: 0.952 just above shape 1 and where shapes are small, never less; 0.982 for shape 2, 0.997 for shape 10.
///
/// The default budget of 16 tries is spent with a probability below 2⁻⁶⁴.
///
/// Where one is made for a single draw, the compiler leaves out what its density takes, two thirds of the time, but not as WASM.
///
/// # Examples
/// ```
/// use microwarp::{constant, poly as mw, rejection::Rejection};
/// use rand_pcg::Pcg32;
/// const SERVICE: mw::Gamma = constant!(mw::Gamma::new(2.5, 4.0)); // of mean 10
/// let mut rng = Pcg32::new(1, 1);
/// let time = SERVICE.draw(&mut rng)?.point;
/// assert!(time > 0.0 && SERVICE.pdf(time) > 0.0);
/// let rare = mw::Gamma::new(1e-3, 1.0)?;
/// assert!(rare.draw_ln(&mut rng)?.point < 3.0); // often below −1000
///
/// // Inverse-gamma, of shape 3 and scale 4: e⁻⁴·4³/Γ(3) at 1, where the density of x is the same.
/// let precision = mw::Gamma::new(3.0, 1.0 / 4.0)?;
/// let x = precision.draw(&mut rng)?.point;
/// let (variance, density) = (1.0 / x, precision.pdf(x) * x * x);
/// assert!(variance > 0.0 && density > 0.0);
/// assert!((precision.pdf(1.0) - 0.586_100_4).abs() < 1e-6);
/// let ln_variance = -precision.draw_ln(&mut rng)?.point;
/// assert!(ln_variance.is_finite());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # See also
/// - [`Beta`](super::Beta), [`Dirichlet`](super::Dirichlet): shares of a sum of gamma numbers.
/// - [`warp::Exponential`](crate::warp::Exponential): shape 1, with an inverse. [`warp::Weibull`](crate::warp::Weibull): life
///   times by one uniform.
/// - [`discrete::Poisson`](crate::discrete::Poisson): how many events there are in a time.
///
/// # Source
/// G. Marsaglia and W. W. Tsang, "A Simple Method for Generating Gamma Variables", 2000,
/// <https://doi.org/10.1145/358407.358414>. The squeeze, which tightens as the shape grows, and the forms of the exponent and of
/// the density, in which nothing cancels, are this crate's own.
#[doc(alias = "chi_squared")]
#[doc(alias = "ChiSquared")]
#[doc(alias = "erlang")]
#[doc(alias = "inverse_gamma")]
#[doc(alias = "InverseGamma")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gamma<T> {
    tries: Tries,
    scale: f32,
    ln_scale: f32,
    peak: Scaled,
    budget: u32,
    tier: PhantomData<T>,
}

impl<T: Tier> Gamma<T> {
    /// The default budget. A true random generator spends it with a probability below 2⁻⁶⁴.
    pub const BUDGET: u32 = 16;

    with_budget!(const);

    /// Gamma with this shape and this scale; its mean is their product. A rate is the reciprocal of the scale.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::OutOfRange`] for a shape
    /// below 1e-30 or above 1e6, [`Error::Empty`] for a scale below 2⁻¹²⁵, [`Error::TooLarge`] if a number could overflow.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub const fn new(shape: f32, scale: f32) -> Result<Self, Error> {
        let tries = tried!(Tries::new(shape));
        if tried!(positive(scale, 1)) < 2.0 * f32::MIN_POSITIVE {
            Err(Error::Empty(1))
        } else if !(tries.largest() * scale).is_finite() {
            Err(Error::TooLarge(1))
        } else {
            let (bits, rest) = Scaled::of(scale).log2();
            Ok(Self {
                tries,
                scale,
                ln_scale: (bits + rest) * core::f32::consts::LN_2,
                peak: peak(shape),
                budget: Self::BUDGET,
                tier: PhantomData,
            })
        }
    }

    /// Chi-squared with so many degrees of freedom: the sum of the squares of as many standard normal numbers, which need not
    /// be a whole number of them. It is the gamma distribution of half the degrees and the scale 2.
    ///
    /// # Errors
    /// Those of [`Self::new`], for half the degrees.
    pub const fn chi_squared(degrees: f32) -> Result<Self, Error> {
        Self::new(0.5 * degrees, 2.0)
    }

    /// The shape.
    #[must_use]
    pub const fn shape(&self) -> f32 {
        self.tries.shape()
    }

    /// The scale.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    /// One try with given words, of which it takes what it needs, from the first on. `None` if the number is rejected: a smaller
    /// second word accepts more.
    #[must_use]
    #[inline]
    pub fn attempt(&self, words: [u32; 3]) -> Option<f32> {
        self.part(words).map(|part| part.times(self.scale))
    }

    /// The logarithm of what [`Self::attempt`] gives, also where that is too small for `f32`.
    #[must_use]
    #[inline]
    pub fn attempt_ln(&self, words: [u32; 3]) -> Option<f32> {
        self.part(words).map(|part| part.ln::<T>() + self.ln_scale)
    }

    /// Draws the natural logarithm of a number: any finite number, where the number itself may be too small for `f32`.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if none was accepted within the budget.
    #[inline]
    pub fn draw_ln<R: Rng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<f32>, Failure<Infallible>> {
        self.try_draw_ln(rng)
    }

    /// The same from a generator that may fail.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if none was accepted within the budget, [`Failure::Generator`] with the error of the generator.
    #[inline]
    pub fn try_draw_ln<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<f32>, Failure<R::Error>> {
        draw_first_alone(&Logarithms(self.numbers(), self.ln_scale), rng)
    }

    /// The density at a number. It is 0 below 0, for NaN and infinity, and never 0 at a drawn number.
    #[must_use]
    pub fn pdf(&self, x: f32) -> f32 {
        if (0.0..=f32::MAX).contains(&x) {
            of_number(above_zero(x), self.tries.shape(), self.scale, self.peak)
        } else {
            0.0
        }
    }

    #[inline]
    fn part(&self, words: [u32; 3]) -> Option<Part> {
        let mut words = words.into_iter();
        let word = || Ok::<_, Infallible>(words.next().unwrap_or_default());
        let Ok(part) = self.tries.attempt::<T, _>(word);
        part
    }

    /// What numbers take of this sampler. The compiler leaves out the rest where one is made for a single number.
    #[inline]
    fn numbers(&self) -> Numbers<T> {
        Numbers {
            tries: self.tries,
            scale: self.scale,
            budget: self.budget,
            tier: PhantomData,
        }
    }
}

impl<T: Tier> Rejection for Gamma<T> {
    type Point = f32;

    #[inline]
    fn budget(&self) -> u32 {
        self.budget
    }

    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_once<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Option<f32>, Failure<R::Error>> {
        self.numbers().try_once(rng)
    }

    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_draw<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<f32>, Failure<R::Error>> {
        draw_first_alone(&self.numbers(), rng)
    }
}

/// Draws numbers.
#[derive(Clone, Copy)]
struct Numbers<T> {
    tries: Tries,
    scale: f32,
    budget: u32,
    tier: PhantomData<T>,
}

impl<T: Tier> Numbers<T> {
    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_part<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Option<Part>, Failure<R::Error>> {
        self.tries
            .attempt::<T, _>(|| rng.try_next_u32().map_err(Failure::Generator))
    }
}

impl<T: Tier> Rejection for Numbers<T> {
    type Point = f32;

    #[inline]
    fn budget(&self) -> u32 {
        self.budget
    }

    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_once<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Option<f32>, Failure<R::Error>> {
        let part = self.try_part(rng)?;
        Ok(part.map(|part| part.times(self.scale)))
    }
}

/// Draws their logarithms, by that of the scale.
#[derive(Clone, Copy)]
struct Logarithms<T>(Numbers<T>, f32);

impl<T: Tier> Rejection for Logarithms<T> {
    type Point = f32;

    #[inline]
    fn budget(&self) -> u32 {
        self.0.budget
    }

    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_once<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Option<f32>, Failure<R::Error>> {
        let part = self.0.try_part(rng)?;
        Ok(part.map(|part| part.ln::<T>() + self.1))
    }
}
