//! Steps as likely as their negatives. The walks that they make are in two files of their own.

use super::coordinates::Coordinates;
use crate::error::{Error, finite, positive};
use crate::num::two_product;
use crate::tier::{Tier, ln_ratio, scaled_exp};
use core::marker::PhantomData;

/// The law of a step along each coordinate, as likely as its negative to the last bit.
///
/// A pure function of one word: the word with all bits inverted gives the negative step. The three of this crate
/// are mutations of points of ℝᴰ; one of your own becomes one by [`RandomWalk`](super::RandomWalk), and each becomes one of the unit cube
/// by [`WrappedWalk`](super::WrappedWalk).
pub trait StepLaw<X> {
    /// The step along coordinate `axis`, counted from 0, of one word.
    #[must_use]
    fn displacement(&self, axis: usize, word: u32) -> f32;
}

/// A sign and one of 2²³ numbers of (0, 1): odd multiples of 2⁻²⁴, equally likely, whose product with the
/// sign is the negative one of the inverted word.
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

/// Refuses widths that are no lengths, and those that are all 0.
fn checked<X: Coordinates>(widths: X) -> Result<X, Error> {
    let mut some = false;
    for &width in widths.as_slice() {
        if finite(width)? < 0.0 {
            return Err(Error::Negative);
        }
        some |= width > 0.0;
    }
    if some {
        Ok(widths)
    } else {
        Err(Error::NotPositive)
    }
}

#[inline]
fn along<X: Coordinates>(widths: &X, axis: usize) -> f32 {
    widths.as_slice().get(axis).copied().unwrap_or(0.0)
}

/// Proposes x plus a step, uniform in a box about 0.
///
/// - States: ℝᴰ, as `f32` or `[f32; D]`; [`WrappedWalk`](super::WrappedWalk), the unit cube.
/// - Words: one a coordinate. 2²⁴ steps a coordinate, odd multiples of the width times 2⁻²⁵, rounded.
/// - T(x→x′) = T(x′→x), but for the rounding of x + step: 1/width for |x′ − x| < width/2.
/// - A proposal beyond the range of `f32` stays at x instead.
///
/// Source: N. Metropolis et al., "Equation of State Calculations by Fast Computing Machines", 1953.
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
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoxStep<X> {
    widths: X,
}

impl<X: Coordinates> BoxStep<X> {
    /// Steps from −width/2 to width/2 along each coordinate. A width of 0 leaves a coordinate where it is.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::NotPositive`] if all are 0.
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
/// - States: ℝᴰ, as `f32` or `[f32; D]`; [`WrappedWalk`](super::WrappedWalk), the unit cube.
/// - Words: one a coordinate. 2²⁴ steps a coordinate, up to 5.42 standard deviations.
/// - T(x→x′) = T(x′→x), but for the rounding of x + step: normal, truncated at 5.42 standard deviations.
/// - A proposal beyond the range of `f32` stays at x instead.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | step, ulp | 4.7 | 4.7 |
///
/// Source: M. J. Wichura, "Algorithm AS 241: The Percentage Points of the Normal Distribution", 1988.
///
/// ```
/// use microwarp::metropolis::StepLaw;
/// use microwarp::poly as mw;
/// let step = mw::NormalStep::new(2.0_f32)?;
/// assert!((step.displacement(0, u32::MAX / 4) + 2.0 * 0.674_489_7).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NormalStep<X, T> {
    std_devs: X,
    tier: PhantomData<T>,
}

impl<X: Coordinates, T: Tier> NormalStep<X, T> {
    /// Steps with these standard std_devs along the coordinates. One of 0 leaves a coordinate where it is.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::NotPositive`] if all are 0; [`Error::TooLarge`]
    /// above 6e37, where steps would overflow.
    pub fn new(std_devs: X) -> Result<Self, Error> {
        let std_devs = checked(std_devs)?;
        if std_devs.as_slice().iter().any(|&x| x > 6e37) {
            return Err(Error::TooLarge);
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

/// Proposes x plus a step whose size is any within bounds, each order of magnitude as likely as the next.
///
/// Along each coordinate the step is ±b·(a/b)^ξ for sizes from a to b: density 1/(2|s| ln(b/a)) for
/// a < |s| < b. Small steps refine, larger ones explore, and no width need be tuned.
///
/// - States: ℝᴰ, as `f32` or `[f32; D]`; [`WrappedWalk`](super::WrappedWalk), the unit cube, where 1/1024 and 1/64 are
///   the sizes of the source.
/// - Words: one a coordinate. 2²⁴ steps a coordinate.
/// - T(x→x′) = T(x′→x), but for the rounding of x + step.
/// - A proposal beyond the range of `f32` stays at x instead.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | step, relative | 6.3e-7 | 6.3e-7 |
///
/// Source: C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the
/// Metropolis Light Transport Algorithm", 2002.
///
/// ```
/// use microwarp::metropolis::StepLaw;
/// use microwarp::poly as mw;
/// let step = mw::LogUniformStep::new(0.001, 0.1)?;
/// let size = StepLaw::<f32>::displacement(&step, 0, u32::MAX / 4).abs();
/// assert!((size - 0.01).abs() < 1e-7);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LogUniformStep<T> {
    smallest: f32,
    largest: f32,
    /// ln(largest/smallest), and what it lacks: a long way down multiplies the rounding of a logarithm.
    span: f32,
    span_rest: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> LogUniformStep<T> {
    /// Steps of the sizes from `smallest` to `largest`, along every coordinate.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`]; [`Error::Reversed`] if the smallest is above the largest.
    pub fn new(smallest: f32, largest: f32) -> Result<Self, Error> {
        if positive(smallest)? > positive(largest)? {
            return Err(Error::Reversed);
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
        sign * scaled_exp::<T>(self.largest, -way, -dropped - self.span_rest * u)
    }
}
