//! The Weibull distribution. Both tiers share its density; samples have nine digits inside in `libm`, and come by tables in
//! `poly`.

use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, positive, tried};
use crate::num::double_word::{by_64, reciprocal};
use crate::num::{
    Scaled, above_zero, doubles, folded_exactly, head, into_unit, middle, product, quick_two_sum,
    representable,
};
use crate::tier::{
    LN_2, LOG2_E, Tier, exp2_pair, log2, log2_1p, log2_of_sum, neg_log2_1m, neg_log2_1m_of_word,
    times, times_exp2,
};
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// Weibull with a scale λ and a shape κ: life times, wind speeds, the weakest of many links.
///
/// x = λ(−ln(1 − u))^(1/κ), increasing with the uniform. In [`libm`](crate::libm) both logarithms and 1/κ have nine digits, so that a small
/// shape, whose power is large, costs none of a sample's. In `poly` the logarithms come by a table and have seven, in a sixth of
/// the time.
///
#[cfg_attr(doc, doc = include_str!("../pictures/weibull.html"))]
///
/// # Density
/// (κ/λ)(x/λ)^(κ−1) e^(−(x/λ)^κ) for x ≥ 0, else 0. With κ < 1 it is infinite at 0, and the largest `f32` stands for it.
/// [`sample_with_pdf`](Warp::sample_with_pdf) takes it from the uniform, as κ(1 − u)(−ln(1 − u))/x.
///
/// # Domain
/// - Point: drawn samples lie from (1.16e-10)^(1/κ)·λ to 22.9^(1/κ)·λ. Uniforms on the 24-bit grid reach 16.6^(1/κ)·λ; u = 0
///   counts as 2⁻¹⁴⁹. Samples below 2⁻¹⁵⁰ are 0, as many are for κ below 0.1.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a scale and a shape above 0 for which neither samples nor the density at the scale overflow. A scale of 1
///   takes shapes from 0.036.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp | 1.3 | 4.5 + 4.7/k | found |
/// | pdf, relative | 3.6e-6 | 3.6e-6 | found |
/// | realised density, relative | 4e-7 + s/max(0, 1 - k/1e6) | 4e-7 + (4.6 + 3.8/k)*s/max(0, 1 - k/1e6) | found |
/// | pdf with the sample, relative | 4.2e-7 | 6.8e-7 + 2.9e-7/k | found |
/// | inverse | 9.2e-8 | 9.2e-8 | found |
/// | round trip | 1e-7 + 1.5*r | 1e-7 + (4.4 + 3.6/k)*r | found |
///
/// A draw keeps the bound of a sample at the exact middle of its word. k is κ. No realised density is stated from 1e6 on, where
/// the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and the change of the
/// inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Weibull -->108 instructions and 612 bytes of code on an M4F, 3,763 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let life = mw::Weibull::new(1000.0, 1.5)?; // hours, wearing out
/// assert!((life.invert(1000.0) - 0.632_120_6).abs() < 1e-6);
/// assert!((life.sample(0.5) - 783.219_2).abs() < 1e-3); // the median
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Exponential`](super::Exponential): shape 1, at a lower cost.
/// - [`Rayleigh`](super::Rayleigh): shape 2, at a lower cost.
/// - [`Gumbel`](super::Gumbel): minus the logarithm of such a number.
///
/// # Source
/// W. Weibull, "A Statistical Distribution Function of Wide Applicability", 1951, <https://doi.org/10.1115/1.4010337>. Both
/// forms are this crate's own.
#[doc(alias = "reliability")]
#[doc(alias = "life_time")]
#[doc(alias = "wind_speed")]
#[doc(alias = "stretched_exponential")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Weibull<T> {
    scale: f32,
    shape: f32,
    /// 1/κ and its rounding error; by tables 64/κ, a head of 12 bits and the rest.
    root: (f32, f32),
    /// By tables, the point where −log₂(1 − u) is 1: the median.
    median: Scaled,
    tier: PhantomData<T>,
}

/// log₂(ln 2): a head of 12 bits and the rest.
const LOG2_OF_LN_2: (f32, f32) = {
    let log = doubles::ln(core::f64::consts::LN_2) * core::f64::consts::LOG2_E;
    let high = head(log as f32);
    (high, (log - high as f64) as f32)
};

/// log₂ of the probability above the point with this tail and its rounding error beyond it, which is the tail or the rest of
/// 1: a head of 12 bits and the rest.
#[inline]
fn log2_above((tail, rest): (f32, f32), upper: bool) -> (f32, f32) {
    if upper {
        log2_of_sum(tail, rest, 0.0)
    } else if tail < 0.29 {
        log2_1p(0.0, -tail, -rest)
    } else {
        let above = 1.0 - tail;
        log2_of_sum(above, ((1.0 - above) - tail) - rest, 0.0)
    }
}

impl<T: Tier> Weibull<T> {
    /// Weibull with this scale and this shape.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::TooLarge`] if a sample
    /// could overflow, [`Error::Empty`] if the density at the scale could.
    pub const fn new(scale: f32, shape: f32) -> Result<Self, Error> {
        tried!(positive(scale, 0));
        let root = reciprocal(tried!(positive(shape, 1)));
        // log₂ of 22.88, beyond what the deepest word gives.
        let last = Scaled::of(scale).times_power((4.516, 0.0), root);
        if !last.value().is_finite() {
            Err(Error::TooLarge(1))
        } else if !(shape / scale).is_finite() {
            Err(Error::Empty(1))
        } else {
            Ok(Self {
                scale,
                shape,
                root: if T::TABLES { by_64(root) } else { root },
                median: Scaled::of(scale).times_power(LOG2_OF_LN_2, root),
                tier: PhantomData,
            })
        }
    }

    /// The scale.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.scale
    }

    /// The shape.
    #[must_use]
    pub const fn shape(&self) -> f32 {
        self.shape
    }

    /// -ln(1 - u), and the point by nine digits of both logarithms, from the tail beyond it and the tail's rounding error.
    #[inline]
    fn beyond(&self, (tail, rest): (f32, f32), upper: bool) -> (f32, Scaled) {
        let (hazard, log) = if !upper && tail < 1.0e-6 {
            // -ln(1 - u) = u(1 + u/2 + ...), without a subnormal number.
            let (log, small) = Scaled::of(tail).log2();
            let more = core::f32::consts::LOG2_E * (0.5 * tail + rest / tail);
            (tail + 0.5 * tail * tail, (log, small + more))
        } else {
            let (log, rest) = log2_above((tail, rest), upper);
            let (log, rest) = product(quick_two_sum(-log, -rest), LN_2);
            (log, log2_of_sum(log, rest, 0.0))
        };
        (hazard, Scaled::of(self.scale).times_power(log, self.root))
    }

    /// The point by nine digits and its density.
    #[inline]
    fn beyond_with_pdf(&self, tail: (f32, f32), upper: bool) -> (f32, f32) {
        let (hazard, point) = self.beyond(tail, upper);
        let share = if upper { tail.0 } else { 1.0 - tail.0 };
        let rate = Scaled::of(self.shape).times(Scaled::of(share * hazard));
        (point.value(), representable(rate.over(point).value()))
    }

    /// The point by tables, from -log₂(1 - u)·2^lifted.
    #[inline]
    fn above(&self, (whole, rest): (f32, f32), lifted: f32) -> f32 {
        let (whole, rest) = log2(whole + rest);
        let whole = whole - lifted;
        let (root, root_rest) = self.root;
        let small = rest * (root + root_rest) + whole * root_rest;
        times_exp2(self.median, whole * root, small)
    }

    /// The point by tables and its density, from -log₂(1 - u)·2^lifted and 1 - u.
    #[inline]
    fn above_with_pdf(&self, log: (f32, f32), lifted: f32, share: f32) -> (f32, f32) {
        let x = self.above(log, lifted);
        let hazard = (log.0 + log.1) * core::f32::consts::LN_2;
        let density = if lifted == 0.0 && x >= f32::MIN_POSITIVE {
            self.shape * (share * hazard) / x
        } else {
            self.density_in_depth(log, lifted, share * hazard)
        };
        (x, representable(density))
    }

    /// The density where the point or the hazard times the share, of 2^lifted, would lose digits.
    #[cold]
    fn density_in_depth(&self, (whole, rest): (f32, f32), lifted: f32, hazard: f32) -> f32 {
        let root = quick_two_sum(self.root.0 / 64.0, self.root.1 / 64.0);
        let (whole, rest) = log2(whole + rest);
        let point = self.median.times_power((whole - lifted, rest), root);
        let rate = Scaled::of(self.shape).times(Scaled::of(hazard));
        rate.raised(0_i32.wrapping_sub(lifted as i32))
            .over(point)
            .value()
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        if T::TABLES {
            self.above_with_pdf(neg_log2_1m_of_word(word), 0.0, middle(!word))
        } else {
            let (tail, upper) = folded_exactly(word);
            self.beyond_with_pdf(tail, upper)
        }
    }

    /// log₂ of x/λ, for an x above 0.
    #[inline]
    fn log2_of_ratio(&self, x: f32) -> (f32, f32) {
        Scaled::of(x).log2_over(Scaled::of(self.scale))
    }
}

impl<T: Tier> Warp for Weibull<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let u = above_zero(u.get());
        if T::TABLES {
            // Below the logarithm is as u, and subnormal numbers would have lost digits.
            if u < 1.0e-30 {
                self.above(neg_log2_1m(u * 18_446_744_073_709_551_616.0), 64.0)
            } else {
                self.above(neg_log2_1m(u), 0.0)
            }
        } else if u < 0.5 {
            self.beyond((u, 0.0), false).1.value()
        } else {
            self.beyond((1.0 - u, 0.0), true).1.value()
        }
    }

    // As `try_draw` is, so that a loop which draws breaks the false dependency of the conversions.
    #[allow(clippy::inline_always, reason = "see there")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn sample_words(&self, word: u32) -> f32 {
        if T::TABLES {
            self.above(neg_log2_1m_of_word(word), 0.0)
        } else {
            let (tail, upper) = folded_exactly(word);
            self.beyond(tail, upper).1.value()
        }
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let u = above_zero(u.get());
        if T::TABLES && u < 1.0e-30 {
            let log = neg_log2_1m(u * 18_446_744_073_709_551_616.0);
            self.above_with_pdf(log, 64.0, 1.0)
        } else if T::TABLES {
            self.above_with_pdf(neg_log2_1m(u), 0.0, 1.0 - u)
        } else if u < 0.5 {
            self.beyond_with_pdf((u, 0.0), false)
        } else {
            self.beyond_with_pdf((1.0 - u, 0.0), true)
        }
    }

    drawn_with_pdf!(from of_word_with_pdf);

    #[inline]
    #[expect(
        clippy::float_cmp,
        reason = "the exponential distribution alone has a density at 0"
    )]
    fn pdf(&self, x: f32) -> f32 {
        if !(0.0..=f32::MAX).contains(&x) {
            return 0.0;
        }
        if x == 0.0 {
            return representable(if self.shape < 1.0 {
                f32::MAX
            } else if self.shape == 1.0 {
                1.0 / self.scale
            } else {
                0.0
            });
        }
        // κ z e^(-z)/x with z = (x/λ)^κ.
        let log = self.log2_of_ratio(x);
        let whole = self.shape * (log.0 + log.1);
        let z = if whole > 8.0 {
            return representable(0.0);
        } else if whole > -40.0 {
            let (exact, small) = times(log, self.shape);
            exp2_pair(exact, small)
        } else {
            (0.0, 0.0)
        };
        let start = Scaled::of(self.shape).over(Scaled::of(x));
        let rising = start.times_power(log, (self.shape, 0.0));
        representable(rising.times_power(LOG2_E, (-z.0, -z.1)).value())
    }
}

impl<T: Tier> Invert for Weibull<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        if x > 0.0 {
            let log = self.log2_of_ratio(if x < f32::MAX { x } else { f32::MAX });
            let z = Scaled::ONE.times_power(log, (self.shape, 0.0)).value();
            into_unit(-T::exp_m1(-z))
        } else {
            0.0
        }
    }
}
