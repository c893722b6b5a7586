//! What a target says of a state: its density, or the logarithm of it.

use crate::error::Error;
use crate::estimate::saturated;
use crate::tier::{Tier, two_product};
use crate::warp::{Apart, Warp, representable};
use core::f32::consts::{LN_2, LOG2_E};
use core::marker::PhantomData;

/// What a density says of its state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// A chain may be there.
    Positive,
    /// A chain is never there.
    Zero,
    /// Not a density at all.
    Unsound,
}

mod sealed {
    use super::{Apart, Error, Standing};

    /// What acceptance needs of a density.
    pub trait Arithmetic: Copy {
        fn standing(self) -> Standing;
        /// Refuses every density where a chain cannot be, and says why.
        #[inline]
        fn positive(self) -> Result<(), Error> {
            match self.standing() {
                Standing::Positive => Ok(()),
                Standing::Zero => Err(Error::NotPositive),
                Standing::Unsound => Err(self.fault()),
            }
        }
        /// Why it is unsound.
        fn fault(self) -> Error;
        /// min(1, to/from), of two positive densities.
        fn quotient(from: Self, to: Self) -> f32;
        /// to/from, of two positive densities.
        fn quotient_apart(from: Self, to: Self) -> Apart;
        /// Whether this density is the larger one, of two positive ones.
        fn exceeds(self, other: Self) -> bool;
        /// A positive density times a number.
        fn scaled(self, by: Apart) -> Self;
    }
}
pub(super) use sealed::Arithmetic;

/// What a target says of a state: an `f32`, which is the density itself up to a constant factor, or a
/// [`LogDensity`]. The trait is sealed.
///
/// A density of 0 (a logarithm of −∞) is a state the chain never enters. One that is NaN, infinite or
/// negative (a logarithm of NaN or +∞) is refused, and counted.
pub trait Density: Arithmetic {}

impl Arithmetic for f32 {
    #[inline]
    fn standing(self) -> Standing {
        if self > 0.0 && self <= f32::MAX {
            Standing::Positive
        } else if self == 0.0 {
            Standing::Zero
        } else {
            Standing::Unsound
        }
    }

    #[inline]
    fn fault(self) -> Error {
        if self.is_finite() {
            Error::Negative
        } else {
            Error::NotFinite
        }
    }

    #[inline]
    fn quotient(from: Self, to: Self) -> f32 {
        // The quotient of a smaller number by a larger one cannot overflow.
        if to < from { to / from } else { 1.0 }
    }

    #[inline]
    fn quotient_apart(from: Self, to: Self) -> Apart {
        Apart::of(to).over(Apart::of(from))
    }

    #[inline]
    fn exceeds(self, other: Self) -> bool {
        self > other
    }

    #[inline]
    fn scaled(self, by: Apart) -> Self {
        representable(Apart::of(self).times(by).value())
    }
}

impl Density for f32 {}

/// The natural logarithm of a density, up to a constant summand; −∞ for a density of 0.
///
/// For targets that are products of many factors, or whose density over- or underflows `f32`. The acceptance
/// is the exponential of a difference d: where d is no `f32`, rounding it adds a part of 6e-8 |d| to the errors
/// below. Logarithms l that are rounded themselves make it uncertain by some 6e-8 |l|.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | acceptance at a symmetric mutation, ulp | 1 | 1 |
/// | acceptance at one with a [`Ratio`](super::Ratio), ulp | 2.6 | 2.6 |
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
fn exp_apart<T: Tier>(x: f32) -> Apart {
    let x = x.clamp(-MOST, MOST);
    let scaled = x * LOG2_E;
    let exponent = (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }) as i32;
    // Exact up to 2²⁴; beyond, x itself is an integer only, and what is left of it is no digit.
    let turns = exponent as f32;
    let (product, dropped) = two_product(turns, LN_2);
    let rest = ((x - product) - dropped) - turns * LN_2_LOW;
    Apart::of(T::exp(rest)).raised(exponent)
}

impl<T: Tier> Arithmetic for LogDensity<T> {
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

    #[inline]
    fn quotient(from: Self, to: Self) -> f32 {
        if to.log < from.log {
            T::exp(to.log - from.log)
        } else {
            1.0
        }
    }

    #[inline]
    fn quotient_apart(from: Self, to: Self) -> Apart {
        exp_apart::<T>(to.log - from.log)
    }

    #[inline]
    fn exceeds(self, other: Self) -> bool {
        self.log > other.log
    }

    #[inline]
    fn scaled(self, by: Apart) -> Self {
        let (significand, exponent) = by.parts();
        Self::new(saturated(
            self.log + (T::ln(significand) + exponent as f32 * LN_2),
        ))
    }
}

impl<T: Tier> Density for LogDensity<T> {}

/// The density of a warp's uniforms under which its points have the density `f`: f/p, at the point.
///
/// This is how a chain in the unit cube drives a warp: the chain's state is the warp's uniforms, and the better
/// the warp, the flatter what is left for the chain. Where f/p overflows `f32`, the state is refused.
///
/// Of several warps, one after the other, each takes its uniforms, and their densities multiply: a closure does
/// it, as the second example shows.
///
/// Source: C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the
/// Metropolis Light Transport Algorithm", 2002.
///
/// ```
/// use microwarp::metropolis::{Chain, ExponentialStep, Mixture, Wrapped, primary_density};
/// use microwarp::{Warp, poly as mw};
/// use rand_pcg::Pcg32;
///
/// // A lobe, and before it a bar that lets nothing pass.
/// let lobe = mw::PhongLobe::new(20.0)?;
/// let seen = move |w: [f32; 3]| if w[0].abs() < 0.02 { 0.0 } else { lobe.pdf(w) };
/// let target = primary_density(lobe, seen);
///
/// let small = Wrapped::new(mw::ExponentialStep::new(1.0 / 1024.0, 1.0 / 64.0)?);
/// let mutation = Mixture::large_small(0.1, small)?;
/// let mut rng = Pcg32::new(1, 1);
/// let mut chain = Chain::new([0.5, 0.3], target)?;
/// for _ in 0..1000 {
///     let uniforms = chain.step(target, &mutation, &mut rng).state();
///     assert!(lobe.sample(uniforms)[0].abs() >= 0.02);
/// }
///
/// // A path: a point of a lens, then a direction.
/// let lens = mw::Disk::new();
/// let f = |p: [f32; 2], w: [f32; 3]| p[0] * p[0] * w[2];
/// let path = |[a, b, c, d]: [f32; 4]| {
///     let (p, w) = (lens.sample([a, b]), lobe.sample([c, d]));
///     f(p, w) / (lens.pdf(p) * lobe.pdf(w))
/// };
/// let mut chain = Chain::new([0.5, 0.3, 0.5, 0.3], path)?;
/// chain.step(path, &mutation, &mut rng);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[inline]
pub fn primary_density<W, F>(warp: W, f: F) -> impl Fn(W::Uniforms) -> f32 + Copy
where
    W: Warp<Density = f32> + Copy,
    F: Fn(W::Point) -> f32 + Copy,
{
    move |uniforms| {
        let point = warp.sample(uniforms);
        f(point) / warp.pdf(point)
    }
}
