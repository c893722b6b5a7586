//! Target densities in floating point, and their logarithms.

use super::HastingsCorrection;
use super::acceptance::Acceptance;
use super::standing::Standing;
use super::target_value::{TargetValue, Weighing};
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
        /// The quotient of this density and a larger one.
        fn over(self, larger: Self) -> f32;
        /// The quotient of this density and any other.
        fn quotient(self, other: Self) -> Scaled;
        /// The product with a number.
        fn scaled(self, by: Scaled) -> Self;
    }
}
pub(super) use sealed::Arithmetic;

/// A density in floating point: an `f32`, known up to a constant factor, or a [`LogDensity`], also
/// [`WithPayload`](super::WithPayload). The trait is sealed.
///
/// A chain never enters a state of density 0 (of logarithm −∞). A density that is NaN, infinite or negative (a logarithm
/// that is NaN or +∞) is refused and counted.
#[diagnostic::on_unimplemented(
    message = "the density of a target is `f32` or `LogDensity`, not `{Self}`",
    label = "not a density of a target"
)]
pub trait TargetDensity: TargetValue<Acceptance = f32> + Arithmetic {}

impl Weighing for f32 {
    #[inline]
    fn standing(self) -> Standing {
        Standing::of_density(self)
    }

    #[inline]
    fn fault(self, place: usize) -> Error {
        if self.is_finite() {
            Error::Negative(place)
        } else {
            Error::NotFinite(place)
        }
    }
}

impl TargetValue for f32 {
    type Acceptance = f32;
}

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

impl Acceptance<Self> for f32 {
    #[inline]
    fn between(f: Self, f_new: Self, ratio: impl HastingsCorrection) -> Self {
        of_densities(f, f_new, ratio)
    }
}

/// The natural logarithm of a density, known up to a constant summand; −∞ stands for a density of 0.
///
/// Take it for targets that are products of many factors, or whose density overflows or underflows `f32`.
///
/// # Accuracy
///
/// The acceptance is the exponential of a difference d. Where d is not an `f32`, rounding it adds a relative error of
/// 6e-8 |d| to those below. If the logarithms l are rounded themselves, the acceptance is uncertain by some 6e-8 |l|.
/// An ulp is a unit in the last place.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | acceptance at a symmetric mutation, ulp | 1 | found |
/// | acceptance at one with a [`HastingsRatio`](super::HastingsRatio), ulp | 2.6 | found |
///
/// # Examples
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
#[doc(alias = "log_prob")]
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

/// Beyond this, a logarithm has no fractional digits; up to this, its binary exponent fits an `i32`.
const MOST: f32 = 1e9;

/// The rounding error of `LN_2`.
const LN_2_LOW: f32 = (core::f64::consts::LN_2 - LN_2 as f64) as f32;

/// e^x, with the exponent kept apart.
#[inline]
fn exp_scaled<T: Tier>(x: f32) -> Scaled {
    let x = x.clamp(-MOST, MOST);
    let scaled = x * LOG2_E;
    let exponent = (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }) as i32;
    // Exact up to 2²⁴; beyond, x is an integer and the rest has no correct digits.
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
    fn fault(self, place: usize) -> Error {
        Error::NotFinite(place)
    }
}

impl<T: Tier> TargetValue for LogDensity<T> {
    type Acceptance = f32;
}

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

impl<T: Tier> Acceptance<LogDensity<T>> for f32 {
    #[inline]
    fn between(f: LogDensity<T>, f_new: LogDensity<T>, ratio: impl HastingsCorrection) -> Self {
        of_densities(f, f_new, ratio)
    }
}

/// The acceptance of either kind of density.
#[inline]
fn of_densities<D: Arithmetic>(f: D, f_new: D, ratio: impl HastingsCorrection) -> f32 {
    let product = match ratio.value() {
        // T′ = T. The quotient of a smaller number by a larger one cannot overflow.
        None if f.exceeds(f_new) => return f_new.over(f),
        None => return 1.0,
        Some(ratio) => f_new.quotient(f).times(ratio).value(),
    };
    if product < 1.0 { product } else { 1.0 }
}
