//! The power law on an interval, in both orientations, and the largest of several uniforms.

use super::{Warp, above_zero, clamp, into_unit, representable};
use crate::error::{Error, finite};
use crate::tier::{
    Tier, coin_series, ln_ratio, log_residual, pow_of_quotient, remainder, scaled_exp, two_product,
    two_sum,
};
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
/// - Where 0 < |n + 1| < ¼ and |n + 1| ln(b/a) exceeds ½, as over many decades, the error of a sample grows
///   in inverse proportion to |n + 1|; it is under 10 ulp everywhere else.
/// - With a = 0 and n < 0 the density is infinite at 0: the largest `f32` stands for what exceeds it, and
///   samples that would be smaller than 2⁻¹⁴⁹ are 2⁻¹⁴⁹, as most are for n within 1e-3 of −1.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, ulp | 37 | 37 |
/// | pdf, relative | 2.9e-7 | 2.9e-7 |
/// | realised density, relative | 2.2e-4 | 2.2e-4 |
/// | inverse | 2.1e-7 | 2.1e-7 |
/// | round trip | 6.6e-5 | 6.6e-5 |
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
    /// n + 1, and what rounding it dropped.
    m: f32,
    m_rest: f32,
    /// 1/m likewise; unused where z is small.
    root: f32,
    root_rest: f32,
    low: f32,
    high: f32,
    /// R, the end where xᵐ is larger.
    anchor: f32,
    /// Whether u = 0 is at the anchor.
    from_anchor: bool,
    /// ln(b/a), and what rounding it dropped.
    span: f32,
    span_rest: f32,
    /// |m| ln(b/a), and what rounding it dropped; infinite where the other end vanishes beside the anchor.
    z: f32,
    z_rest: f32,
    /// (O/R)ᵐ = e^(−z), O being the other end.
    rest: f32,
    /// e^(−z) − 1.
    decay: f32,
    /// The density is this times (x/R)ᵐ/x.
    shape: f32,
    tier: PhantomData<T>,
}

/// Up to this z the exponent is a series about the logarithmic law n = −1.
const SERIES: f32 = 0.5;

impl<T: Tier> Power<T> {
    /// Density ∝ xⁿ on [a, b], increasing with the uniform.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a < 0, [`Error::Reversed`] for
    /// a > b, [`Error::Empty`] for a = b or an a > 0 or width so small that the density overflows,
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
        if a >= b {
            return Err(Error::Empty);
        }
        let (m, m_rest) = two_sum(n, 1.0);
        if a == 0.0 && m <= 0.0 {
            return Err(Error::NotNormalizable);
        }
        let (span, span_rest) = ln_ratio::<T>(a, b);
        let (z, z_dropped) = two_product(m.abs(), span);
        let z_rest = or_zero(z_dropped + m.abs() * span_rest + m_rest.copysign(m * m_rest) * span);
        let anchor = if m < 0.0 { a } else { b };
        let decay = T::exp_m1(-z);
        let shape = if z < f32::EPSILON {
            // |m|/(1 - e^-z) is (1 + z/2)/ln(b/a), which rounds to its limit.
            1.0 / span
        } else {
            m.abs() / -decay
        };
        if !(shape / anchor).is_finite() {
            return Err(Error::Empty);
        }
        let root = 1.0 / m;
        let power = Self {
            m,
            m_rest,
            root,
            root_rest: or_zero((remainder(1.0, root, m) - root * m_rest) / m),
            // x = 0 is left out where the density there is 0 or infinite.
            low: if a > 0.0 || n == 0.0 { a } else { SMALLEST },
            high: b,
            anchor,
            from_anchor: increasing == (m < 0.0),
            span,
            span_rest,
            z,
            z_rest,
            rest: T::exp(-z) * (1.0 - z_rest),
            decay,
            shape,
            tier: PhantomData,
        };
        // With a > 0 the density is finite on the whole interval; from 0 an integrable singularity is
        // accepted.
        if a > 0.0 && !(power.pdf(a) < f32::MAX && power.pdf(b) < f32::MAX) {
            return Err(Error::Empty);
        }
        Ok(power)
    }

    /// The end at u = 0 times e^(±span·g), where g runs from 0 to 1 with u, bent by z:
    /// g = u − z u(1 − u)(½ − z S). Over many decades the exponent is large, so its main parts are carried
    /// with what rounding drops of them.
    #[inline]
    fn along_span(&self, u: f32) -> f32 {
        let (z, z_rest) = if self.from_anchor {
            (self.z, self.z_rest)
        } else {
            (-self.z, -self.z_rest)
        };
        let (p, p_rest) = two_product(u, 1.0 - u);
        let (bend, bend_rest) = two_product(0.5 * z, p);
        let bend_rest = bend_rest + 0.5 * (z * p_rest + z_rest * p);
        let unbend = z * z * p * coin_series(z, 1.0 - u, u);
        let (straight, rest_1) = two_product(self.span, u);
        let (bent, rest_2) = two_product(self.span, bend);
        let (exponent, rest_3) = two_sum(straight, -bent);
        let (exponent, rest_4) = two_sum(exponent, self.span * unbend);
        let rest = (rest_1 - rest_2)
            + (rest_3 + rest_4)
            + ((u - bend) * self.span_rest - self.span * bend_rest);
        if self.from_anchor == (self.m < 0.0) {
            scaled_exp::<T>(self.low, exponent, rest)
        } else {
            scaled_exp::<T>(self.high, -exponent, -rest)
        }
    }
}

/// The number itself, or 0 in place of what the parameters leave undefined.
const fn or_zero(x: f32) -> f32 {
    if x.is_finite() { x } else { 0.0 }
}

impl<T: Tier> Warp for Power<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let u = u.get();
        let x = if self.z < SERIES {
            self.along_span(u)
        } else {
            // How much of the mixture is the anchor's and how much the other end's.
            let (near, away) = if self.from_anchor {
                (1.0 - u, u)
            } else {
                (u, 1.0 - u)
            };
            let mixed = near + away * self.rest;
            if mixed < 0.5 {
                let mixed = if self.rest > 0.0 || self.low > SMALLEST {
                    mixed
                } else {
                    above_zero(mixed)
                };
                let power = T::pow(mixed, self.root);
                let log = T::ln(above_zero(mixed));
                if (f32::MIN_POSITIVE..=f32::MAX).contains(&power) || mixed == 0.0 {
                    let x = self.anchor * power;
                    x + x * (log * self.root_rest)
                } else {
                    // The power alone leaves the range of f32 where the sample does not.
                    let (exponent, dropped) = two_product(log, self.root);
                    let rest = log_residual::<T>(mixed, log) * self.root + log * self.root_rest;
                    scaled_exp::<T>(self.anchor, exponent, dropped + rest)
                }
            } else {
                let log = T::ln_1p(away * self.decay);
                self.anchor * T::exp(log * self.root)
            }
        };
        clamp(x, self.low, self.high)
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if x >= self.low && x <= self.high {
            let power = pow_of_quotient::<T>(x, self.anchor, self.m, self.m_rest);
            // In this order a power that has nearly vanished is not divided into nothing.
            representable(self.shape * (power / x))
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
        let part = if low < high {
            ln_ratio::<T>(low, high).0
        } else {
            0.0
        };
        let away = if self.z < f32::EPSILON {
            part / self.span
        } else {
            T::exp_m1(-self.m.abs() * part) / self.decay
        };
        into_unit(if self.from_anchor { away } else { 1.0 - away })
    }

    /// The end where the density may be 0 or infinite is the one that u = 0 gives, from either side.
    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        let from_other_end = Self {
            from_anchor: false,
            ..*self
        };
        let word = if self.from_anchor { !word } else { word };
        from_other_end.sample_canonical(crate::uniform::deep(word))
    }
}

/// Density N x^(N−1) on [0, 1): the largest of N uniforms.
///
/// The power law of exponent n = N − 1 without a logarithm or a root; the loop is bounded by N.
///
/// - Uniforms: N, all alike; N = 0 does not compile.
/// - Range: (0, 1).
/// - Density: N x^(N−1) on [0, 1], to N·6e-8 relative.
/// - Inverse: many sets of uniforms share their largest; `invert` gives N times the point itself, whose
///   sample is the point exactly.
/// - Both tiers share this code.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, ulp | 1.1 | 1.1 |
/// | pdf, relative | 1.3e-7 | 1.3e-7 |
/// | realised density, relative | 1.3e-7 | 1.3e-7 |
/// | inverse | 0 | 0 |
/// | round trip | 1.6e-45 | 1.6e-45 |
///
/// Source: L. Devroye, "Non-Uniform Random Variate Generation", 1986.
///
/// ```
/// use microwarp::{PowerMax, Warp};
/// let quadratic = PowerMax::<3>::new();
/// assert_eq!(quadratic.sample([0.5, 0.75, 0.25]), 0.75);
/// assert_eq!(quadratic.pdf(0.5), 0.75);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

impl<const N: usize> Default for PowerMax<N> {
    fn default() -> Self {
        Self::new()
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
        if !(0.0..=1.0).contains(&x) {
            return 0.0;
        }
        let (mut power, mut square, mut left) = (1.0_f32, x, N.wrapping_sub(1));
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

    #[inline]
    fn sample_words(&self, words: [u32; N]) -> f32 {
        let largest = words.into_iter().fold(0, u32::max);
        crate::uniform::deep_from_word(largest)
    }
}
