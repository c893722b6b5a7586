//! The tent (triangle) filter.

use super::{Invert, Warp};
use crate::error::{Error, positive};
use crate::num::{above_zero, clamp, folded, into_unit, representable};
use crate::tier::sqrt;
use crate::uniform::Canonical;

/// The tent (triangle) filter on (−r, r): a density that falls linearly from the centre to 0 at ±r.
///
/// With t = 2u below the middle and t = 2(1 − u) above, x = ∓r(1 − t)/(1 + √t), which is ∓r(1 − √t) without its
/// cancellation at the centre. Samples increase with the uniform, whatever the radius.
///
#[cfg_attr(doc, doc = include_str!("../pictures/tent.html"))]
///
/// # Density
/// (1 − |x|/r)/r where |x| < r, else 0.
///
/// # Domain
/// - Point: (−r, r). The ends, where the density is 0, are never returned.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell, so that no draw lies nearer
///   to an end than its share.
/// - Parameters: a finite radius from the smallest normal `f32` up.
/// - Both tiers share this code. It needs nothing but a square root.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 4 | proven |
/// | pdf, relative | 2.4e-7 | found |
/// | realised density, relative | 1.9e-7 + 3.3*s | found |
/// | pdf with the sample, relative | 2.6e-7 | found |
/// | inverse | 1.8e-7 | found |
/// | round trip | 1.8e-7 + 3.3*r | found |
///
/// The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// s and r are the relative change of the density, which falls to 0 at the ends, and the change of the inverse when
/// x moves by one ulp. On the 24-bit grid samples are within 2.4 ulp. A uniform below 2⁻⁴⁹ gives the last point before the end,
/// and with it the density of that point.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Tent -->50 instructions and 212 bytes of code on an M4F, 1,347 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let filter = mw::Tent::new(2.0)?;
/// assert_eq!(filter.sample(0.125), -1.0);
/// assert_eq!(filter.pdf(-1.0), 0.25);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Linear`](super::Linear): one slope.
/// - [`Normal`](super::Normal): a filter without ends.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://pbr-book.org/3ed-2018/contents>. The form is derived here.
#[doc(alias = "triangular")]
#[doc(alias = "triangle_filter")]
#[doc(alias = "bartlett")]
#[doc(alias = "pixel_filter")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tent {
    radius: f32,
    /// The largest magnitude of a sample, the neighbour of the radius.
    last: f32,
    /// The density at the centre, 1/radius.
    peak: f32,
}

/// The smallest distance of a sample from an end, in units of the radius.
const LEAST: f32 = f32::EPSILON / 2.0;

impl Tent {
    /// The tent of the given radius about 0.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less,
    /// [`Error::Empty`] for a radius below the smallest normal `f32`.
    pub const fn new(radius: f32) -> Result<Self, Error> {
        match positive(radius, 0) {
            Ok(radius) if radius >= f32::MIN_POSITIVE => Ok(Self {
                radius,
                last: f32::from_bits(radius.to_bits().wrapping_sub(1)),
                peak: 1.0 / radius,
            }),
            Ok(_) => Err(Error::Empty(0)),
            Err(e) => Err(e),
        }
    }

    /// The radius.
    #[must_use]
    pub const fn radius(&self) -> f32 {
        self.radius
    }

    /// The distance from the centre with this probability beyond it, on one side, and the density there.
    #[inline]
    fn placed(self, tail: f32) -> (f32, f32) {
        let t = 2.0 * tail;
        let root = sqrt(t);
        let x = clamp(self.radius * ((1.0 - t) / (1.0 + root)), 0.0, self.last);
        // Beyond the last point there is no smaller density than that there.
        let rest = if root > LEAST { root } else { LEAST };
        (x, above_zero(self.peak * rest))
    }
}

impl Tent {
    /// The point of the middle of a word's cell, and its density.
    #[inline]
    fn of_word(self, word: u32) -> (f32, f32) {
        let (tail, upper) = folded(word);
        let (x, density) = self.placed(tail);
        (if upper { x } else { -x }, density)
    }
}

impl Warp for Tent {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.sample_canonical_with_pdf(u).0
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        let rest = self.radius - x.abs();
        if rest > 0.0 {
            representable(rest / self.radius / self.radius)
        } else {
            0.0
        }
    }

    super::filled_in_blocks!();

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.of_word(word).0
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let u = u.get();
        if u < 0.5 {
            let (x, density) = self.placed(u);
            (-x, density)
        } else {
            self.placed(1.0 - u)
        }
    }

    #[inline]
    fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(f32, f32), R::Error> {
        Ok(self.of_word(rng.try_next_u32()?))
    }
}

impl Invert for Tent {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let rest = clamp((self.radius - x.abs()) / self.radius, 0.0, 1.0);
        let half = 0.5 * rest * rest;
        into_unit(if x < 0.0 { half } else { 1.0 - half })
    }
}
