//! The exponential distribution truncated to an interval from 0, with a rate of either sign.

use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, finite, positive, tried};
use crate::num::{Scaled, clamp, into_unit, quick_two_sum, representable, two_product, two_sum};
use crate::tier::{LOG2_E, Tier, coin_series, exp_m1_of_product, exp_of_product, exp2_m1, times};
use crate::uniform::{Canonical, deep};
use core::marker::PhantomData;

/// Below this product of rate and length the map is a series, which does not cancel.
const SERIES: f32 = 0.5;

/// Above this product of a negative rate and length, e^|z| would overflow.
const STEEP: f32 = 80.0;

/// 2¹⁰⁰, which keeps the product of a small uniform and a small or large power in range.
const LIFT: f32 = 1_267_650_600_228_229_401_496_703_205_376.0;

/// Exponential on [0, X], with a rate of either sign: density ∝ e^(−cx).
///
/// With z = cX: x = −ln(1 + u(e^(−z) − 1))/c, in a form chosen by z so that neither a small nor a large product
/// cancels or overflows. A rate of 0 is the uniform distribution, a negative rate a rising density.
///
#[cfg_attr(doc, doc = include_str!("../pictures/truncated_exponential.html"))]
///
/// # Density
/// c e^(−cx)/(1 − e^(−z)) on [0, X], else 0.
///
/// # Domain
/// - Point: [0, X].
/// - Uniforms: one.
/// - Parameters: any finite rate c, or a mean 1/c above 0 (that of the distribution before it is truncated), and a
///   length X above 0.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp | 4.9 | 5 | proven |
/// | pdf, relative | 2.4e-7 | 2.4e-7 | found |
/// | realised density, relative | 2.4e-7 + 3.5*s | 2.4e-7 + 3.5*s | found |
/// | pdf with the sample, relative | 4.4e-7 | 4.4e-7 | found |
/// | inverse | 3.4e-7 | 3.4e-7 | found |
/// | round trip | 3e-7 + 2*r | 3e-7 + 2*r | found |
///
/// s and r are the relative change of the exact density and the change of the exact inverse over one ulp of x.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost TruncatedExponential -->107 instructions and 1,744 bytes of code on an M4F, 2,963 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let segment = mw::TruncatedExponential::from_rate(0.0, 4.0)?;
/// assert_eq!(segment.sample(0.25), 1.0);
/// assert_eq!(segment.pdf(1.0), 0.25);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Exponential`](super::Exponential): without an end.
/// - [`Interval`](super::Interval): rate 0 at a lower cost.
///
/// # Source
/// C. Kulla and M. Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media", 2012,
/// <https://doi.org/10.1111/j.1467-8659.2012.03148.x>.
#[doc(alias = "free_path")]
#[doc(alias = "distance_sampling")]
#[doc(alias = "transmittance")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TruncatedExponential<T> {
    rate: f32,
    length: f32,
    /// z = rate · length, which may be infinite.
    z: f32,
    /// e^(−z) − 1; unused when steep.
    decay: f32,
    /// e^(−z); when steep 2⁻¹⁰⁰e^(−z), which may be infinite.
    power: f32,
    /// The densities at 0 and at X.
    ends: [f32; 2],
    tier: PhantomData<T>,
}

impl<T: Tier> TruncatedExponential<T> {
    /// Density ∝ e^(−rate·x) on [0, length].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a length of 0 or less,
    /// [`Error::Empty`] for a length whose reciprocal overflows.
    pub const fn from_rate(rate: f32, length: f32) -> Result<Self, Error> {
        tried!(finite(rate, 0));
        tried!(positive(length, 1));
        let (z, z_rest) = two_product(rate, length);
        let (decay, decay_rest, power, fall) = if z > 190.0 {
            (-1.0, 0.0, 0.0, Scaled::ONE.raised(-480))
        } else if z < -190.0 {
            (f32::INFINITY, 0.0, f32::INFINITY, Scaled::ONE.raised(480))
        } else {
            let (exact, small) = times(LOG2_E, -z);
            let (k, rise) = exp2_m1(quick_two_sum(exact, small - z_rest * LOG2_E.0));
            let rest = Scaled::of(1.0 + rise.0);
            let fall = rest.raised(k);
            if z > -STEEP {
                let scale = Scaled::ONE.raised(k).value();
                let (decay, dropped) = two_sum(scale - 1.0, scale * rise.0);
                (decay, dropped + scale * rise.1, fall.value(), fall)
            } else {
                (f32::INFINITY, 0.0, fall.raised(-100).value(), fall)
            }
        };
        // c/(1 - e^-z), also as |c| + |c|/(e^|z| - 1).
        let share = Scaled::of_quotient((rate, 0.0), (decay, decay_rest), Scaled::ONE).value();
        let peak = if z.abs() < 1e-12 {
            1.0 / length
        } else if z > 0.0 {
            share
        } else if z > -STEEP {
            -rate + share
        } else {
            -rate
        };
        if !peak.is_finite() {
            return Err(Error::Empty(1));
        }
        let ends = if z > 0.0 {
            [peak, Scaled::of(peak).times(fall).value()]
        } else {
            [Scaled::of(peak).over(fall).value(), peak]
        };
        Ok(Self {
            rate,
            length,
            z,
            decay,
            power,
            ends,
            tier: PhantomData,
        })
    }

    /// Density ∝ e^(−x/mean) on [0, length]: the exponential distribution of this mean, truncated. Its rate is 1/mean,
    /// rounded to `f32`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a mean or a length of 0 or less,
    /// [`Error::Empty`] for a mean or a length whose reciprocal overflows.
    pub const fn from_mean(mean: f32, length: f32) -> Result<Self, Error> {
        let rate = 1.0 / tried!(positive(mean, 0));
        tried!(positive(length, 1));
        if rate.is_finite() {
            Self::from_rate(rate, length)
        } else {
            Err(Error::Empty(0))
        }
    }

    /// The rate, of either sign.
    #[must_use]
    pub const fn rate(&self) -> f32 {
        self.rate
    }

    /// The length of the interval.
    #[must_use]
    pub const fn length(&self) -> f32 {
        self.length
    }
}

impl<T: Tier> Warp for TruncatedExponential<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let (u, z) = (u.get(), self.z);
        let x = if z.abs() < SERIES {
            let bend = z * (1.0 - u) * (0.5 - z * coin_series(z, 1.0 - u, u));
            if u > f32::MIN_POSITIVE * LIFT {
                self.length * (u - u * bend)
            } else {
                let even = self.length * u;
                even - even * bend
            }
        } else if z > -STEEP {
            let drop = u * self.decay;
            let log = if drop < -0.5 {
                // 1 - u is exact on the grid, and 1 + drop would lose its digits.
                T::ln((1.0 - u) + u * self.power)
            } else if drop.abs() >= f32::MIN_POSITIVE {
                T::ln_1p(drop)
            } else {
                // ln(1 + drop) is drop, which may be subnormal where x is not.
                let lifted = u * LIFT * self.decay / -self.rate;
                return clamp(lifted / LIFT, 0.0, self.length);
            };
            -log / self.rate
        } else {
            let rise = u * LIFT * self.power;
            if rise <= LIFT {
                T::ln_1p(rise) / -self.rate
            } else {
                // Measured from the far end, where the mass is. No digits of x are lost from here on, where neighbours of
                // the grid are many steps apart.
                self.length + T::ln(u) / -self.rate
            }
        };
        clamp(x, 0.0, self.length)
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if !(x >= 0.0 && x <= self.length) {
            return 0.0;
        }
        let [first, last] = self.ends;
        let (peak, (from_peak, dropped)) = if self.rate > 0.0 {
            (first, (x, 0.0))
        } else {
            (last, two_sum(self.length, -x))
        };
        let rate = -self.rate.abs();
        let (exponent, rest) = two_product(rate, from_peak);
        let exponent = (exponent, rest + rate * dropped);
        representable(Scaled::of(peak).times_power(LOG2_E, exponent).value())
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.sample_canonical(deep(word))
    }

    /// The density is linear in the uniform.
    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let ([first, last], part) = (self.ends, u.get());
        let density = representable((1.0 - part) * first + part * last);
        (self.sample_canonical(u), density)
    }

    drawn_with_pdf!(by deep);
}

impl<T: Tier> Invert for TruncatedExponential<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let x = clamp(x, 0.0, self.length);
        let z = self.z;
        into_unit(if z.abs() < f32::EPSILON {
            x / self.length
        } else if z > -STEEP {
            exp_m1_of_product::<T>(-self.rate, x) / self.decay
        } else {
            let rest = exp_of_product::<T>(self.rate, self.length - x);
            rest * -exp_m1_of_product::<T>(self.rate, x)
        })
    }
}
