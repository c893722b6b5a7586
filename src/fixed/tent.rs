//! The tent (triangle) filter.

use super::direction::{Scaled, UNIT};
use super::grade::{Fine, Grade};
use super::kernel::product::{high, square};
use super::kernel::quotient::quotient;
use super::{Density, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedI32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// The tent (triangle) filter on (−r, r).
///
/// With t = 2u below the middle and 2(1 − u) above, x = ∓r(1 − √t).
///
/// # Density
/// (1 − |x|/r)/r inside, at least 2⁻³²; 0 elsewhere. It falls linearly from the centre to 0 at ±r.
///
/// # Domain
/// - Point: (−r, r) in the format of r, cut towards 0. Samples never reach the ends, where the density is 0.
/// - Uniforms: one word. A drawn word counts as the middle of its step, so that draws do not come too near the ends.
/// - Parameter: the radius r > 0, in any signed format of 32 bits.
///
/// # Accuracy
/// *Sample* is relative to the radius, beyond a step of the format. *Pdf* is relative to the largest density, beyond a
/// step of 2⁻³². *Round trip* is the error of the uniform after `sample` and `invert`. The radius is n steps of the
/// format.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 2.5e-7 | 2.2e-5 | 7.4e-8 | found |
/// | sample, rms | 4.2e-8 | 9.0e-6 | 2.0e-8 | found |
/// | sample, mean | 0 | 0 | 0 | found |
/// | pdf | 9.3e-10 | 9.3e-10 | 9.3e-10 | found |
/// | round trip | 2.7e-7 + 1.4/n | 2.3e-5 + 1.4/n | 8.2e-8 + 1.4/n | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Tent -->104 instructions and 376 bytes of code on an M0, 49 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I16F16, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let filter = mw::Tent::new(I16F16::from_num(2))?;
/// assert!((filter.sample(U0F32::from_num(0.125)).to_num::<f64>() + 1.0).abs() < 2e-5);
/// assert_eq!(filter.pdf(I16F16::from_num(-1)), 0.25);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Interval`](super::Interval) is uniform.
/// - [`NormalPair`](super::NormalPair) is the smoother filter, in the plane.
/// - [`warp::Tent`](crate::warp::Tent) is the tent of the float tiers.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://www.pbr-book.org/3ed-2018/Monte_Carlo_Integration>.
#[doc(alias = "triangular")]
#[doc(alias = "triangle_filter")]
#[doc(alias = "dither")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tent<Frac, G = Fine> {
    radius: u32,
    /// The density at the centre.
    height: Scaled,
    format: PhantomData<(Frac, G)>,
}

impl<Frac: LeEqU32, G: Grade> Tent<Frac, G> {
    /// The tent of the given radius about 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0 or less.
    pub const fn new(radius: FixedI32<Frac>) -> Result<Self, Error> {
        let radius = radius.to_bits();
        if radius <= 0 {
            return Err(Error::NotPositive(0));
        }
        let radius = radius as u32;
        Ok(Self {
            radius,
            height: UNIT.over(Scaled::of(radius as u64, Frac::I32)),
            format: PhantomData,
        })
    }

    /// The radius.
    #[must_use]
    pub const fn radius(&self) -> FixedI32<Frac> {
        FixedI32::from_bits(self.radius as i32)
    }
}

impl<Frac: LeEqU32, G: Grade> Warp for Tent<Frac, G> {
    type Uniforms = Uniform;
    type Point = FixedI32<Frac>;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> FixedI32<Frac> {
        let u = u.get().to_bits();
        // In the middle t is 1, which counts as the word below.
        let double = u << 1;
        let upper = u >> 31 == 1;
        self.beyond(
            if upper {
                double.max(1).wrapping_neg()
            } else {
                double
            },
            upper,
        )
    }

    #[inline]
    fn pdf(&self, x: FixedI32<Frac>) -> Density {
        match self.rest(x) {
            0 => Density::ZERO,
            rest => self.height.density(rest),
        }
    }

    #[inline]
    fn sample_words(&self, word: u32) -> FixedI32<Frac> {
        // The middle of the word, because the ends have density 0.
        let double = word << 1 | 1;
        let upper = word >> 31 == 1;
        self.beyond(if upper { double.wrapping_neg() } else { double }, upper)
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for Tent<Frac, G> {
    #[inline]
    fn invert(&self, x: FixedI32<Frac>) -> Uniform {
        let half = square(self.rest(x)) >> 1;
        Uniform::from_bits(if x.is_negative() {
            half
        } else {
            // The upper end is the last word, not 0.
            half.max(1).wrapping_neg()
        })
    }
}

impl<Frac: LeEqU32, G> Tent<Frac, G> {
    /// The point beyond which its half of the tent has the share t.
    #[inline]
    fn beyond(&self, t: u32, upper: bool) -> FixedI32<Frac>
    where
        G: Grade,
    {
        let x = high(self.radius, !G::root(t)) as i32;
        FixedI32::from_bits(if upper { x } else { -x })
    }

    /// 1 − |x|/r in Q32, where 1 counts as the word below. It is 0 only outside.
    #[inline]
    fn rest(&self, x: FixedI32<Frac>) -> u32 {
        let rest = self.radius.saturating_sub(x.to_bits().unsigned_abs());
        if rest == self.radius {
            u32::MAX
        } else {
            quotient(rest, self.radius)
        }
    }
}

#[cfg(feature = "defmt")]
impl<Frac, G> defmt::Format for Tent<Frac, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "Tent {{ radius: {=u32} }}", self.radius);
    }
}
