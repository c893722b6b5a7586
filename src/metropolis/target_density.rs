//! Weights in floating point: a density, or the logarithm of it.

use super::target_value::{Standing, TargetValue, Weighing};
use crate::error::Error;
use crate::num::{Scaled, representable, saturated, two_product};
use crate::tier::Tier;
use core::f32::consts::{LN_2, LOG2_E};
use core::marker::PhantomData;

mod sealed {
    use super::Scaled;

    /// Arithmetic of positive densities.
    pub trait Arithmetic: Copy {
        /// Whether this density is the larger one.
        fn exceeds(self, other: Self) -> bool;
        /// The quotient by a larger density.
        fn over(self, larger: Self) -> f32;
        /// The quotient by any density.
        fn quotient(self, other: Self) -> Scaled;
        /// The product with a number.
        fn scaled(self, by: Scaled) -> Self;
    }
}
pub(super) use sealed::Arithmetic;

/// A density in floating point: an `f32`, which is the density itself up to a constant factor, or a
/// [`LogDensity`]. The trait is sealed.
///
/// A density of 0 (a logarithm of −∞) is a state the chain never enters. One that is NaN, infinite or
/// negative (a logarithm of NaN or +∞) is refused, and counted.
pub trait TargetDensity: TargetValue + Arithmetic {}

impl Weighing for f32 {
    #[inline]
    fn standing(self) -> Standing {
        Standing::of_density(self)
    }

    #[inline]
    fn fault(self) -> Error {
        if self.is_finite() {
            Error::Negative
        } else {
            Error::NotFinite
        }
    }
}

impl TargetValue for f32 {}

impl Arithmetic for f32 {
    #[inline]
    fn exceeds(self, other: Self) -> bool {
        self > other
    }

    #[inline]
    fn over(self, larger: Self) -> f32 {
        self / larger
    }

    #[inline]
    fn quotient(self, other: Self) -> Scaled {
        Scaled::of(self).over(Scaled::of(other))
    }

    #[inline]
    fn scaled(self, by: Scaled) -> Self {
        representable(Scaled::of(self).times(by).value())
    }
}

impl TargetDensity for f32 {}

/// The natural logarithm of a density, up to a constant summand; −∞ for a density of 0.
///
/// For targets that are products of many factors, or whose density over- or underflows `f32`. The acceptance
/// is the exponential of a difference d: where d is no `f32`, rounding it adds a part of 6e-8 |d| to the errors
/// below. Logarithms l that are rounded themselves make it uncertain by some 6e-8 |l|.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | acceptance at a symmetric mutation, ulp | 1 | 1 |
/// | acceptance at one with a [`HastingsRatio`](super::HastingsRatio), ulp | 2.6 | 2.6 |
///
/// ```
/// use microwarp::metropolis::Chain;
/// use microwarp::poly as mw;
/// use rand_pcg::Pcg32;
/// // Twenty deviations out, where the density itself is 1e-87.
/// let normal = |x: f32| mw::LogDensity::new(-0.5 * x * x);
/// let mut chain = Chain::new(20.0, normal)?;
/// let step = mw::NormalStep::new(2.0)?;
/// chain.burn_in(normal, &step, 1000, &mut Pcg32::new(1, 1));
/// assert!(chain.state().abs() < 6.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LogDensity<T> {
    log: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> LogDensity<T> {
    /// The density e^`log`.
    #[must_use]
    #[inline]
    pub const fn new(log: f32) -> Self {
        Self {
            log,
            tier: PhantomData,
        }
    }

    /// The logarithm.
    #[must_use]
    #[inline]
    pub const fn get(self) -> f32 {
        self.log
    }
}

/// Beyond this a logarithm has no digits left that could matter, and its binary exponent fits an `i32`.
const MOST: f32 = 1e9;

/// What `LN_2` leaves of ln 2.
const LN_2_LOW: f32 = (core::f64::consts::LN_2 - LN_2 as f64) as f32;

/// e^x, its exponent set aside.
#[inline]
fn exp_scaled<T: Tier>(x: f32) -> Scaled {
    let x = x.clamp(-MOST, MOST);
    let scaled = x * LOG2_E;
    let exponent = (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }) as i32;
    // Exact up to 2²⁴; beyond, x itself is an integer only, and what is left of it is no digit.
    let turns = exponent as f32;
    let (product, dropped) = two_product(turns, LN_2);
    let rest = ((x - product) - dropped) - turns * LN_2_LOW;
    Scaled::of(T::exp(rest)).raised(exponent)
}

impl<T: Tier> Weighing for LogDensity<T> {
    #[inline]
    fn standing(self) -> Standing {
        if self.log.is_finite() {
            Standing::Positive
        } else if self.log == f32::NEG_INFINITY {
            Standing::Zero
        } else {
            Standing::Unsound
        }
    }

    #[inline]
    fn fault(self) -> Error {
        Error::NotFinite
    }
}

impl<T: Tier> TargetValue for LogDensity<T> {}

impl<T: Tier> Arithmetic for LogDensity<T> {
    #[inline]
    fn exceeds(self, other: Self) -> bool {
        self.log > other.log
    }

    #[inline]
    fn over(self, larger: Self) -> f32 {
        T::exp(self.log - larger.log)
    }

    #[inline]
    fn quotient(self, other: Self) -> Scaled {
        exp_scaled::<T>(self.log - other.log)
    }

    #[inline]
    fn scaled(self, by: Scaled) -> Self {
        let (significand, exponent) = by.parts();
        Self::new(saturated(
            self.log + (T::ln(significand) + exponent as f32 * LN_2),
        ))
    }
}

impl<T: Tier> TargetDensity for LogDensity<T> {}
