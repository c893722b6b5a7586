//! A density that is interpolated bilinearly between the corners of the unit square.

use super::linear::{Place, lifted};
use super::{Invert, Warp};
use crate::error::{Error, finite, tried};
use crate::num::{Scaled, clamp, into_unit, remainder, representable, two_sum};
use crate::uniform::{Canonical, LARGEST, SMALLEST, deep};

/// Bilinear on the unit square: density in proportion to the interpolation between four weights, one a corner.
///
/// y is linear with the sums of the rows, and x is linear with the weights interpolated at y, both by the form of
/// [`Linear`](super::Linear). 1 − y and 1 − x come with digits of their own, so that the density has its digits in a
/// corner of weight 0, too.
///
#[cfg_attr(doc, doc = include_str!("../pictures/bilinear.html"))]
///
/// With [`Composed`](super::Composed) it weighs the samples of any warp of two uniforms, such as the points of a lamp by
/// the cosines or the radiance at its corners.
///
/// # Density
/// 4 times the weight interpolated at (x, y), over the sum of the four, on [0, 1]²; else 0.
///
/// # Domain
/// - Point: [x, y] in [0, 1)². A coordinate is above 0 where the density at 0 is 0.
/// - Uniforms: two, the first for x and the second for y. Each coordinate increases with its own.
/// - Parameters: four finite weights, none negative and not all 0, of any magnitudes. The first row holds those at
///   y = 0, the first column those at x = 0.
/// - Both tiers share this code. It needs nothing but a square root.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size 1. Densities are relative, *inverse* and *round
/// trip* are absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 5.6e-7 | proven |
/// | pdf, relative | 6e-7 | found |
/// | realised density, relative | 5.2e-7 + 4.7*s | found |
/// | pdf with the sample, relative | 8e-7 | found |
/// | inverse | 4.1e-7 | found |
/// | round trip | 4.3e-7 + 4.7*r | found |
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Bilinear -->157 instructions and 616 bytes of code on an M4F, 5,381 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// // 0 at the lower left corner, and 1, 1 and 2 at the others: p = x + y.
/// let patch = mw::Bilinear::new([[0.0, 1.0], [1.0, 2.0]])?;
/// let point = patch.sample([0.5, 0.25]);
/// assert!((patch.pdf(point) - (point[0] + point[1])).abs() < 1e-6);
/// assert!((patch.invert(point)[1] - 0.25).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Linear`](super::Linear): the same on the line.
/// - [`Composed`](super::Composed): its points as the uniforms of another warp.
/// - [`PiecewiseConstant2d`](crate::discrete::PiecewiseConstant2d): any number of weights, constant in each cell.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition, 2023,
/// <https://pbr-book.org/4ed/contents>; the complements are of this crate.
#[doc(alias = "patch")]
#[doc(alias = "quad")]
#[doc(alias = "lerp")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bilinear {
    /// The weights times a power of two that takes the largest to 2¹²⁷ or more, so that all keep their digits.
    corners: [[f32; 2]; 2],
    /// In proportion to the sum of each row, as [`normal`] leaves them; 0 only where both weights are.
    rows: [f32; 2],
    /// 2⁶⁵ over the sum of all.
    scale: f32,
}

/// 2⁻⁶³: the scale is larger by its reciprocal, which keeps it normal.
const UNIT: f32 = 1.0 / (1_u64 << 63) as f32;

impl Bilinear {
    /// Density in proportion to the interpolation of `weights[y][x]`: the first row holds the weights at (0, 0) and
    /// (1, 0), the second those at (0, 1) and (1, 1).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] if any is below 0, [`Error::NotPositive`] if all
    /// are 0.
    pub const fn new(weights: [[f32; 2]; 2]) -> Result<Self, Error> {
        let [[a, b], [c, d]] = weights;
        tried!(finite(a, 0));
        tried!(finite(b, 0));
        tried!(finite(c, 0));
        tried!(finite(d, 0));
        if a < 0.0 || b < 0.0 || c < 0.0 || d < 0.0 {
            return Err(Error::Negative(0));
        }
        let largest = larger([larger([a, b]), larger([c, d])]);
        if largest == 0.0 {
            return Err(Error::NotPositive(0));
        }
        let lift = 127_i32.wrapping_sub(Scaled::of(largest).parts().1);
        let corners = [
            [lifted(a, lift), lifted(b, lift)],
            [lifted(c, lift), lifted(d, lift)],
        ];
        let ((low, low_rest), (high, high_rest)) = (half(corners[0]), half(corners[1]));
        let (mean, dropped) = half([low, high]);
        let rest = dropped + (0.5 * low_rest + 0.5 * high_rest);
        let scale = 1.0 / UNIT / mean;
        let ([first, second], _) = normal([low, high]);
        Ok(Self {
            corners,
            rows: [kept(first, low), kept(second, high)],
            scale: scale + (remainder(1.0 / UNIT, scale, mean) - scale * rest) / mean,
        })
    }

    /// The densities at the corners, laid out as the weights.
    #[must_use]
    pub fn corners(&self) -> [[f32; 2]; 2] {
        self.corners.map(|row| row.map(|w| w * UNIT * self.scale))
    }

    /// The point and its density, by coordinates that each carry their complement.
    // As `try_draw`, on x86-64: after a call the conversion of a word would wait for the point before.
    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn place(&self, [u1, u2]: [f32; 2]) -> ([f32; 2], f32) {
        let y = place(self.rows, u2);
        let (ends, unit) = normal(self.between(y.at, y.rest));
        let x = place(ends, u1);
        let point = [x.at, y.at].map(|c| if c < 1.0 { c } else { LARGEST });
        (point, representable(x.density * unit * self.scale))
    }

    /// The weights at both ends of the line through y, which has the complement `rest`.
    #[inline]
    fn between(&self, y: f32, rest: f32) -> [f32; 2] {
        let [[a, b], [c, d]] = self.corners;
        // Rounding may take the largest weights past the largest number.
        [rest * a + y * c, rest * b + y * d].map(|w| w.min(f32::MAX))
    }
}

const fn larger([a, b]: [f32; 2]) -> f32 {
    if a > b { a } else { b }
}

/// Half the sum, above 0 where the sum is, and its rounding error.
const fn half([a, b]: [f32; 2]) -> (f32, f32) {
    let (half, rest) = two_sum(0.5 * a, 0.5 * b);
    (kept(half, larger([a, b])), rest)
}

/// A number in proportion to another, above 0 where that is.
const fn kept(x: f32, of: f32) -> f32 {
    if x == 0.0 && of > 0.0 { SMALLEST } else { x }
}

/// Weights times a power of two that takes the larger into [2⁶⁰, 2⁶¹), or times 2¹²⁷, and the reciprocal of that power times
/// 2⁻⁶³.
#[inline]
const fn normal([a, b]: [f32; 2]) -> ([f32; 2], f32) {
    // The bits of positive numbers are in their order.
    let (first, second) = (a.to_bits(), b.to_bits());
    let exponent = if first > second { first } else { second } >> 23;
    let biased = 314_u32.wrapping_sub(exponent);
    let by = f32::from_bits(if biased < 254 { biased } else { 254 } << 23);
    // Below 2⁻¹²⁶ a density is no number that f32 keeps to its digits.
    let unit = f32::from_bits(
        if biased < 190 {
            191_u32.wrapping_sub(biased)
        } else {
            1
        } << 23,
    );
    ([a * by, b * by], unit)
}

/// What smaller uniforms count as where the density is 0 at 0, 2⁻¹⁰⁴. Its product with the smallest square of a weight is above
/// 0, and its point, at 2⁻⁵², is as good as 0 on the unit square.
const LEAST: f32 = 1.0 / (1_u128 << 104) as f32;

/// The place of a uniform under a linear density.
#[inline]
fn place([a, b]: [f32; 2], u: f32) -> Place {
    let u = if a > 0.0 || u > LEAST { u } else { LEAST };
    Place::of([a, b], a + b, u)
}

/// The share of a linear density below x.
#[inline]
fn share([a, b]: [f32; 2], x: f32) -> f32 {
    into_unit(x * ((a * (2.0 - x) + b * x) / (a + b)))
}

impl Warp for Bilinear {
    type Uniforms = [f32; 2];
    type Point = [f32; 2];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 2] {
        self.place(u.get()).0
    }

    #[inline]
    fn pdf(&self, [x, y]: [f32; 2]) -> f32 {
        let square = 0.0..=1.0;
        if square.contains(&x) && square.contains(&y) {
            let [a, b] = self.between(y, 1.0 - y);
            let weight = (1.0 - x) * (a * UNIT) + x * (b * UNIT);
            representable(weight * self.scale)
        } else {
            0.0
        }
    }

    super::filled_in_blocks!();

    #[inline]
    fn sample_words(&self, words: [u32; 2]) -> [f32; 2] {
        let [u1, u2] = words.map(deep);
        self.place([u1.get(), u2.get()]).0
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 2], f32) {
        self.place(u.get())
    }

    #[inline]
    fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<([f32; 2], f32), R::Error> {
        let words = <[f32; 2] as crate::uniform::Uniforms>::try_words(rng)?;
        let [u1, u2] = words.map(deep);
        Ok(self.place([u1.get(), u2.get()]))
    }
}

impl Invert for Bilinear {
    #[inline]
    fn invert(&self, point: [f32; 2]) -> [f32; 2] {
        let [x, y] = point.map(|c| clamp(c, 0.0, 1.0));
        let (ends, _) = normal(self.between(y, 1.0 - y));
        [share(ends, x), share(self.rows, y)]
    }
}
