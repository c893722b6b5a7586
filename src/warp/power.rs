//! The power law on an interval, in both orientations, and the largest of several uniforms.

use super::{Warp, above_zero, clamp, into_unit, representable};
use crate::error::{Error, finite};
use crate::tier::{Tier, pow_of_quotient};
use crate::uniform::{Canonical, SMALLEST};
use core::marker::PhantomData;

/// Density ∝ xⁿ on [a, b], for any n: −1, near −1, 0, and up to ±1e8 and beyond.
///
/// With m = n + 1, xᵐ is uniform between aᵐ and bᵐ. Everything is carried relative to the end R where
/// xᵐ is larger, as t = 1 − (x/R)ᵐ, so that nothing overflows and m near 0 does not cancel.
/// [`Power::new`] runs from a at u = 0 to b, [`Power::decreasing`] from b to a.
///
/// - Uniforms: one.
/// - Range: [a, b]; above 0 where the density is 0 or infinite at a = 0.
/// - Density: m xⁿ/(bᵐ − aᵐ), or 1/(x ln(b/a)) for n = −1, on [a, b].
///
/// Source: M. E. J. Newman, "Power Laws, Pareto Distributions and Zipf's Law", 2005; stable form derived
/// here.
///
/// ```
/// use microwarp::{Warp, poly as mw};
/// let spectrum = mw::Power::new(-1.0, 1.0, 100.0)?; // equal weight to every octave
/// assert!((spectrum.sample(0.5) - 10.0).abs() < 1e-5);
/// let area = mw::Power::new(1.0, 0.0, 2.0)?;
/// assert_eq!(area.sample(0.25), 1.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Power<T> {
    n: f32,
    /// n + 1.
    m: f32,
    low: f32,
    high: f32,
    /// R, the end where xᵐ is larger.
    anchor: f32,
    /// Whether u = 0 is at the anchor.
    from_anchor: bool,
    /// |ln(bᵐ/aᵐ)|; infinite where one of the two vanishes beside the other.
    z: f32,
    /// (O/R)ᵐ = e^(−z), O being the other end.
    rest: f32,
    /// The density at the anchor.
    peak: f32,
    tier: PhantomData<T>,
}

/// Below this z the map is within rounding of its limit n = −1.
const LOGARITHMIC: f32 = f32::MIN_POSITIVE;

impl<T: Tier> Power<T> {
    /// Density ∝ xⁿ on [a, b], increasing with the uniform.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a < 0, [`Error::Reversed`] for
    /// a > b, [`Error::Empty`] for a = b or an interval so narrow that the density overflows,
    /// [`Error::NotNormalizable`] for a = 0 with n ≤ −1.
    pub fn new(n: f32, a: f32, b: f32) -> Result<Self, Error> {
        Self::build(n, a, b, true)
    }

    /// Density ∝ xⁿ on [a, b], decreasing with the uniform: b at u = 0.
    ///
    /// # Errors
    /// As [`Power::new`].
    pub fn decreasing(n: f32, a: f32, b: f32) -> Result<Self, Error> {
        Self::build(n, a, b, false)
    }

    fn build(n: f32, a: f32, b: f32, increasing: bool) -> Result<Self, Error> {
        let (n, a, b) = (finite(n)?, finite(a)?, finite(b)?);
        if a < 0.0 {
            return Err(Error::Negative);
        }
        if a > b {
            return Err(Error::Reversed);
        }
        if a == b {
            return Err(Error::Empty);
        }
        let m = n + 1.0;
        if a == 0.0 && m <= 0.0 {
            return Err(Error::NotNormalizable);
        }
        let octaves = ln_ratio::<T>(a, b);
        let z = m.abs() * octaves;
        let anchor = if m < 0.0 { a } else { b };
        let peak = if z < LOGARITHMIC {
            1.0 / octaves / anchor
        } else {
            m.abs() / -T::exp_m1(-z) / anchor
        };
        if !peak.is_finite() {
            return Err(Error::Empty);
        }
        Ok(Self {
            n,
            m,
            // x = 0 is left out where the density there is 0 or infinite.
            low: if a > 0.0 || n == 0.0 { a } else { SMALLEST },
            high: b,
            anchor,
            from_anchor: increasing == (m < 0.0),
            z,
            rest: T::exp(-z),
            peak,
            tier: PhantomData,
        })
    }
}

/// ln(b/a) for 0 ≤ a < b, accurate however close the two are and without overflow.
fn ln_ratio<T: Tier>(a: f32, b: f32) -> f32 {
    if b < 2.0 * a {
        T::ln_1p((b - a) / a)
    } else if a > 0.0 {
        T::ln(b) - T::ln(a)
    } else {
        f32::INFINITY
    }
}

impl<T: Tier> Warp for Power<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let u = u.get();
        // `near` of the way is the anchor's share of the mixture, `away` the other end's.
        let (near, away) = if self.from_anchor {
            (1.0 - u, u)
        } else {
            (u, 1.0 - u)
        };
        let x = if self.z < LOGARITHMIC {
            self.anchor * T::exp(-away * ln_ratio::<T>(self.low, self.high))
        } else {
            let ratio = near + away * self.rest;
            if ratio < 0.5 {
                self.anchor * T::pow(above_zero(ratio), 1.0 / self.m)
            } else {
                self.anchor * T::exp(T::ln_1p(away * T::exp_m1(-self.z)) / self.m)
            }
        };
        clamp(x, self.low, self.high)
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if x >= self.low && x <= self.high {
            representable(self.peak * pow_of_quotient::<T>(x, self.anchor, self.n))
        } else {
            0.0
        }
    }

    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let x = clamp(x, self.low, self.high);
        let (low, high) = if self.m < 0.0 {
            (self.anchor, x)
        } else {
            (x, self.anchor)
        };
        let octaves = ln_ratio::<T>(low, high);
        let away = if self.z < LOGARITHMIC {
            octaves / ln_ratio::<T>(self.low, self.high)
        } else {
            T::exp_m1(-self.m.abs() * octaves) / T::exp_m1(-self.z)
        };
        into_unit(if self.from_anchor { away } else { 1.0 - away })
    }
}

/// Density N x^(N−1) on [0, 1): the largest of N uniforms.
///
/// The power law of exponent n = N − 1 without a logarithm or a root; the loop is bounded by N.
///
/// - Uniforms: N, all alike; N = 0 does not compile.
/// - Range: (0, 1).
/// - Density: N x^(N−1) on [0, 1].
/// - Inverse: many sets of uniforms share their largest; `invert` gives N times the point itself, whose
///   sample is the point exactly.
/// - Both tiers share this code.
///
/// Source: M. Pharr and G. Humphreys, "Physically Based Rendering", 2004.
///
/// ```
/// use microwarp::{PowerMax, Warp};
/// let quadratic = PowerMax::<3>::new();
/// assert_eq!(quadratic.sample([0.5, 0.75, 0.25]), 0.75);
/// assert_eq!(quadratic.pdf(0.5), 0.75);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PowerMax<const N: usize>(());

impl<const N: usize> PowerMax<N> {
    /// The largest of N uniforms.
    #[must_use]
    pub const fn new() -> Self {
        const { assert!(N > 0, "the largest of no uniforms does not exist") };
        Self(())
    }
}

impl<const N: usize> Warp for PowerMax<N> {
    type Uniforms = [f32; N];
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; N]>) -> f32 {
        let mut largest = SMALLEST;
        for u in u.get() {
            if u > largest {
                largest = u;
            }
        }
        largest
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if !(x >= 0.0 && x <= 1.0) {
            return 0.0;
        }
        let (mut power, mut square, mut left) = (1.0_f32, x, N - 1);
        while left > 0 {
            if left & 1 == 1 {
                power *= square;
            }
            square *= square;
            left >>= 1;
        }
        representable(N as f32 * power)
    }

    #[inline]
    fn invert(&self, x: f32) -> [f32; N] {
        [into_unit(x); N]
    }
}
