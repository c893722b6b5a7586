//! Distributions of steps that are symmetric about 0. `random_walk.rs` makes mutations of them.

use super::coordinates::Coordinates;
use crate::error::{Error, finite, positive};
use crate::num::{clamp, two_product};
use crate::tier::{Tier, ln_ratio, scaled_exp};
use core::marker::PhantomData;

/// The distribution of a random walk's step along each coordinate: symmetric about 0, to the last bit.
///
/// It is a pure function of one word. Inverting all bits of the word must negate the step. [`BoxStep`],
/// [`NormalStep`] and [`LogUniformStep`] are mutations of points of ℝᴰ as they are. [`RandomWalk`](super::RandomWalk) makes a
/// mutation of a `StepLaw` of your own, and [`WrappedWalk`](super::WrappedWalk) turns any `StepLaw` into a mutation of the
/// unit cube.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a distribution of steps between points of type `{X}`",
    label = "not a distribution of steps of `{X}`",
    note = "`BoxStep` and `NormalStep` take as many parameters as the points have coordinates"
)]
pub trait StepLaw<X> {
    /// The step along coordinate `axis`, counted from 0, that this word gives.
    #[must_use]
    fn displacement(&self, axis: usize, word: u32) -> f32;
}

/// A sign and one of 2²³ equally likely numbers of (0, 1), odd multiples of 2⁻²⁴. The inverted word gives the same
/// number with the other sign.
#[inline]
fn signed(word: u32) -> (f32, f32) {
    let (sign, word) = if word >> 31 == 0 {
        (1.0, word)
    } else {
        (-1.0, !word)
    };
    let odd = ((word >> 8) << 1) | 1;
    (sign, odd as f32 * (f32::EPSILON / 2.0))
}

/// Accepts widths that are finite and not negative, at least one of them positive.
fn checked<X: Coordinates>(widths: X) -> Result<X, Error> {
    let mut some = false;
    for &width in widths.as_slice() {
        if finite(width, 0)? < 0.0 {
            return Err(Error::Negative(0));
        }
        some |= width > 0.0;
    }
    if some {
        Ok(widths)
    } else {
        Err(Error::NotPositive(0))
    }
}

#[inline]
fn along<X: Coordinates>(widths: &X, axis: usize) -> f32 {
    widths.as_slice().get(axis).copied().unwrap_or(0.0)
}

/// Proposes x plus a uniform step in a box centred at 0.
///
/// # Density
///
/// T(x→x′) = 1/width where |x′ − x| < width/2, for each coordinate. It is symmetric, up to the rounding of x + step.
///
/// # Domain
///
/// - States: ℝᴰ, as `f32` or `[f32; D]`; within [`WrappedWalk`](super::WrappedWalk), the unit cube. A step that would leave
///   the range of `f32` proposes x itself.
/// - Words: one per coordinate. There are 2²⁴ steps per coordinate, odd multiples of the width times 2⁻²⁵, rounded.
///   Below 2⁻¹²⁶ numbers are 2⁻¹⁴⁹ apart: of such a width a step may round to half the width, and all steps of a width of
///   2⁻¹⁴⁹ are 0.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{BoxStep, StepLaw};
/// let step = BoxStep::new([0.1, 0.0])?; // moves along the first coordinate only
/// let word = 0x1234_5678;
/// assert!(step.displacement(0, word) > 0.0 && step.displacement(0, word) < 0.05);
/// assert_eq!(step.displacement(0, !word), -step.displacement(0, word));
/// assert_eq!(step.displacement(1, word), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`NormalStep`], whose steps have no sharp bound.
/// - [`LogUniformStep`], which needs no tuned width.
///
/// # Source
///
/// N. Metropolis, A. W. Rosenbluth, M. N. Rosenbluth, A. H. Teller, E. Teller, "Equation of State Calculations by Fast
/// Computing Machines", 1953, [doi:10.1063/1.1699114](https://doi.org/10.1063/1.1699114).
#[doc(alias = "uniform_proposal")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoxStep<X> {
    widths: X,
}

impl<X: Coordinates> BoxStep<X> {
    /// Steps from −width/2 to width/2 along each coordinate. A width of 0 keeps its coordinate fixed.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::NotPositive`] if all widths are 0.
    pub fn new(widths: X) -> Result<Self, Error> {
        Ok(Self {
            widths: checked(widths)?,
        })
    }

    /// The widths along the coordinates.
    #[must_use]
    #[inline]
    pub const fn widths(&self) -> X {
        self.widths
    }
}

impl<X: Coordinates> StepLaw<X> for BoxStep<X> {
    #[inline]
    fn displacement(&self, axis: usize, word: u32) -> f32 {
        let (sign, u) = signed(word);
        // Halving u is exact; halving a subnormal width would not be.
        sign * (0.5 * u) * along(&self.widths, axis)
    }
}

/// Proposes x plus a normal step, independent along each coordinate.
///
/// # Density
///
/// T(x→x′) is normal along each coordinate, truncated at 5.42 standard deviations. It is symmetric, up to the rounding of
/// x + step.
///
/// # Domain
///
/// - States: ℝᴰ, as `f32` or `[f32; D]`; within [`WrappedWalk`](super::WrappedWalk), the unit cube. A step that would leave
///   the range of `f32` proposes x itself.
/// - Words: one per coordinate. There are 2²⁴ steps per coordinate.
///
/// # Accuracy
///
/// The largest error of a step, in ulp: units in its last place.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | step, ulp | 4.7 | found |
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::StepLaw;
/// use microwarp::poly as mw;
/// let step = mw::NormalStep::new(2.0_f32)?;
/// assert!((step.displacement(0, u32::MAX / 4) + 2.0 * 0.674_489_7).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`BoxStep`], which is cheaper.
/// - [`LogUniformStep`], which needs no tuned standard deviation.
///
/// # Source
///
/// M. J. Wichura, "Algorithm AS 241: The Percentage Points of the Normal Distribution", 1988,
/// [doi:10.2307/2347330](https://doi.org/10.2307/2347330).
#[doc(alias = "gaussian_proposal")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NormalStep<X, T> {
    std_devs: X,
    tier: PhantomData<T>,
}

impl<X: Coordinates, T: Tier> NormalStep<X, T> {
    /// Steps with these standard deviations along the coordinates. A standard deviation of 0 keeps its coordinate fixed.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::NotPositive`] if all are 0; [`Error::TooLarge`] above 6e37, where
    /// steps would overflow.
    pub fn new(std_devs: X) -> Result<Self, Error> {
        let std_devs = checked(std_devs)?;
        if std_devs.as_slice().iter().any(|&x| x > 6e37) {
            return Err(Error::TooLarge(0));
        }
        Ok(Self {
            std_devs,
            tier: PhantomData,
        })
    }

    /// The standard deviations along the coordinates.
    #[must_use]
    #[inline]
    pub const fn std_devs(&self) -> X {
        self.std_devs
    }
}

impl<X: Coordinates, T: Tier> StepLaw<X> for NormalStep<X, T> {
    #[inline]
    fn displacement(&self, axis: usize, word: u32) -> f32 {
        let (sign, u) = signed(word);
        sign * T::normal_quantile_lower(0.5 * u) * along(&self.std_devs, axis)
    }
}

/// Proposes x plus a step of log-uniform size: every order of magnitude within bounds is equally likely.
///
/// Small steps refine, larger ones explore, and you tune no width.
///
/// # Density
///
/// Along each coordinate the step is ±b·(a/b)^ξ for sizes from a to b and uniform ξ. Its density is 1/(2|s| ln(b/a)) for
/// a < |s| < b. It is symmetric, up to the rounding of x + step.
///
/// # Domain
///
/// - States: ℝᴰ, as `f32` or `[f32; D]`; within [`WrappedWalk`](super::WrappedWalk), the unit cube, for which the source
///   takes sizes from 1/1024 to 1/64. A step that would leave the range of `f32` proposes x itself.
/// - Words: one per coordinate. There are 2²⁴ steps per coordinate.
///
/// # Accuracy
///
/// The largest relative error of a step. Below 2⁻¹²⁶ a step also has an absolute one of 2⁻¹⁴⁹, the spacing of numbers there.
/// No step is outside the sizes.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | step, relative | 6.3e-7 | found |
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::StepLaw;
/// use microwarp::poly as mw;
/// let step = mw::LogUniformStep::new(0.001, 0.1)?;
/// let size = StepLaw::<f32>::displacement(&step, 0, u32::MAX / 4).abs();
/// assert!((size - 0.01).abs() < 1e-7);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`BoxStep`] and [`NormalStep`], whose steps have one scale.
///
/// # Source
///
/// C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the Metropolis Light
/// Transport Algorithm", 2002, [doi:10.1111/1467-8659.t01-1-00703](https://doi.org/10.1111/1467-8659.t01-1-00703).
#[doc(alias = "kelemen")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LogUniformStep<T> {
    smallest: f32,
    largest: f32,
    /// ln(largest/smallest), and its rounding error, which a long span would multiply.
    span: f32,
    span_rest: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> LogUniformStep<T> {
    /// Steps with sizes from `smallest` to `largest`, along every coordinate.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`]; [`Error::Reversed`] if `smallest` is above `largest`.
    pub fn new(smallest: f32, largest: f32) -> Result<Self, Error> {
        if positive(smallest, 0)? > positive(largest, 1)? {
            return Err(Error::Reversed(1));
        }
        let (span, span_rest) = ln_ratio::<T>(smallest, largest);
        Ok(Self {
            smallest,
            largest,
            span,
            span_rest,
            tier: PhantomData,
        })
    }

    /// The smallest size of a step.
    #[must_use]
    #[inline]
    pub const fn smallest(self) -> f32 {
        self.smallest
    }

    /// The largest size of a step.
    #[must_use]
    #[inline]
    pub const fn largest(self) -> f32 {
        self.largest
    }
}

impl<X: Coordinates, T: Tier> StepLaw<X> for LogUniformStep<T> {
    #[inline]
    fn displacement(&self, _: usize, word: u32) -> f32 {
        let (sign, u) = signed(word);
        let (way, dropped) = two_product(self.span, u);
        let size = scaled_exp::<T>(self.largest, -way, -dropped - self.span_rest * u);
        sign * clamp(size, self.smallest, self.largest)
    }
}
