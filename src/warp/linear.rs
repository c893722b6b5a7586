//! A density that changes linearly across the unit interval.

use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, finite, tried};
use crate::num::{
    Scaled, above_zero, clamp, into_unit, remainder, representable, two_product, two_sum,
};
use crate::tier::sqrt;
use crate::uniform::{Canonical, LARGEST, SMALLEST};

/// Linear on [0, 1): density ∝ (1 − x)a + xb.
///
/// x = u(a + b)/(a + √((1 − u)a² + ub²)), which stays accurate where a and b are nearly equal, followed by one step
/// of Newton's method in higher precision. Samples increase with the uniform, whatever the densities.
///
#[cfg_attr(doc, doc = include_str!("../pictures/linear.html"))]
///
/// # Density
/// 2((1 − x)a + xb)/(a + b) on [0, 1], else 0.
///
/// # Domain
/// - Point: [0, 1); (0, 1) where a is 0.
/// - Uniforms: one.
/// - Parameters: finite a and b, neither negative nor both 0.
/// - Both tiers share this code. It needs nothing but a square root.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 0.76 | proven |
/// | pdf, relative | 3.4e-7 | found |
/// | realised density, relative | 3.2e-7 + 0.7*s | found |
/// | pdf with the sample, relative | 3.6e-7 | found |
/// | inverse | 3.3e-7 | found |
/// | round trip | 3.2e-7 + 0.8*r | found |
///
/// s and r are the relative change of the density and the change of the inverse when x moves by one ulp. The error of a sample is
/// proven for all densities and uniforms: see `docs/proofs.md`. Only samples below 3e-38 are off by more than 0.51 ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Linear -->91 instructions and 396 bytes of code on an M4F, 5,301 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let ramp = mw::Linear::new(0.0, 3.0)?;
/// assert_eq!(ramp.sample(0.25), 0.5);
/// assert_eq!(ramp.pdf(0.5), 1.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Tent`](super::Tent): falls to both sides.
/// - [`Power`](super::Power): any power of x.
/// - [`PiecewiseLinear1d`](crate::discrete::PiecewiseLinear1d): a curve of many such pieces.
/// - [`Transform`](super::Transform) moves it to another interval.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition, 2023,
/// <https://pbr-book.org/4ed/contents>.
#[doc(alias = "ramp")]
#[doc(alias = "trapezoid")]
#[doc(alias = "lerp")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Linear {
    /// The densities at both ends times 2⁶⁰, so that no product of two tiny numbers is subnormal; and the rounding error
    /// of the first.
    a: f32,
    a_rest: f32,
    b: f32,
    /// Half of b − a, and its rounding error.
    slope: f32,
    slope_rest: f32,
}

/// Density 1, as the fields hold it.
const ONE: f32 = (1_u64 << 60) as f32;

impl Linear {
    /// Density ∝ `a` at 0 and ∝ `b` at 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] if either is below 0,
    /// [`Error::NotPositive`] if both are 0.
    pub const fn new(a: f32, b: f32) -> Result<Self, Error> {
        tried!(finite(a, 0));
        tried!(finite(b, 1));
        if a < 0.0 || b < 0.0 {
            return Err(Error::Negative(if a < 0.0 { 0 } else { 1 }));
        }
        let larger = if a > b { a } else { b };
        if larger == 0.0 {
            return Err(Error::NotPositive(1));
        }
        let lift = 60_i32.wrapping_sub(Scaled::of(larger).parts().1);
        let (a, b) = (lifted(a, lift), lifted(b, lift));
        let (sum, dropped) = two_sum(a, b);
        let (a, b) = (a * (2.0 * ONE), b * (2.0 * ONE));
        let share = a / sum;
        let a_rest = (remainder(a, share, sum) - share * dropped) / sum;
        let (slope, slope_rest) = two_sum(ONE, -share);
        Ok(Self {
            a: share,
            a_rest,
            b: b / sum,
            slope,
            slope_rest: slope_rest - a_rest,
        })
    }

    /// The densities at 0 and at 1: 2a/(a + b) and 2b/(a + b).
    #[must_use]
    pub const fn ends(&self) -> [f32; 2] {
        [self.a / ONE, self.b / ONE]
    }
}

/// Where a linear density has its share u below, before the step of Newton's method.
pub(super) struct Place {
    pub(super) at: f32,
    /// 1 − at, with digits of its own.
    pub(super) rest: f32,
    /// The density there, in the unit of those at the ends.
    pub(super) density: f32,
}

impl Place {
    /// Of the densities at 0 and at 1, and of their sum. The larger square must not overflow.
    #[inline]
    pub(super) fn of([a, b]: [f32; 2], sum: f32, u: f32) -> Self {
        let v = 1.0 - u;
        let density = sqrt(v * (a * a) + u * (b * b));
        Self {
            at: u * sum / (a + density),
            rest: v * sum / (b + density),
            density,
        }
    }
}

/// x times 2^by; 0 only where x is 0.
pub(super) const fn lifted(x: f32, by: i32) -> f32 {
    if x == 0.0 {
        return 0.0;
    }
    let lifted = Scaled::of(x).raised(by).value();
    if lifted > 0.0 { lifted } else { SMALLEST }
}

impl Warp for Linear {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.sample_canonical_with_pdf(u).0
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let Self { a, b, .. } = *self;
        let u = if a > 0.0 {
            u.get()
        } else {
            above_zero(u.get())
        };
        let aim = u * ONE;
        let Place { at: x, density, .. } = Place::of([a, b], 2.0 * ONE, u);
        // One step of Newton's method on x(a + slope x) = aim, with the rounding errors of the left side.
        let (bend, bend_rest) = two_product(self.slope, x);
        let (mean, mean_rest) = two_sum(a, bend);
        let rest = mean_rest + (bend_rest + (self.a_rest + self.slope_rest * x));
        let (mass, mass_rest) = two_product(mean, x);
        let over = (mass - aim) + (mass_rest + rest * x);
        let x = x - over / (mean + bend);
        let density = above_zero(density * (1.0 / ONE));
        (if x < 1.0 { x } else { LARGEST }, density)
    }

    drawn_with_pdf!(by crate::uniform::deep);

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if (0.0..=1.0).contains(&x) {
            representable(((1.0 - x) * self.a + x * self.b) * (1.0 / ONE))
        } else {
            0.0
        }
    }

    super::filled_in_blocks!();

    // As `try_draw`: the conversion of the word belongs into the caller's loop.
    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn sample_words(&self, word: u32) -> f32 {
        self.sample_canonical(crate::uniform::deep(word))
    }
}

impl Invert for Linear {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let x = clamp(x, 0.0, 1.0);
        into_unit(x * ((self.a * (2.0 - x) + self.b * x) * (0.5 / ONE)))
    }
}
