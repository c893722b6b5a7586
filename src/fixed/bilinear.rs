//! A density that is interpolated bilinearly between the corners of the unit square.

use super::direction::{Scaled, UNIT};
use super::grade::{Fine, Grade};
use super::kernel::product::{near, square, wide};
use super::kernel::quotient::quotient;
use super::{Density, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedU32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Bilinear on the unit square: density in proportion to the interpolation between four weights, one a corner.
///
/// y is linear with the sums of the rows, and x with the weights interpolated at y. Between densities a ≤ b the place of
/// u is u(a + b)/(a + √((1 − u)a² + ub²)); where a and u are small, both are scaled up first. The points are words, so
/// that they can be the uniforms of another warp.
///
/// # Density
/// 4 times the weight interpolated at (x, y), over the sum of the four, at least 2⁻³².
///
/// # Domain
/// - Point: [x, y], two words. y is above 0 where the weights at y = 0 are 0.
/// - Uniforms: two words, the first for x and the second for y.
/// - Parameters: four weights, not all 0, in any unsigned format of 32 bits. The first row holds those at y = 0, the first
///   column those at x = 0.
///
/// # Accuracy
/// *Sample* is the largest error of y, and of x from its exact place for the y that is returned. *Round trip* is the error
/// of the uniforms after `sample` and `invert`. *Pdf* is relative to the largest density, beyond a step of 2⁻³². Rms
/// and mean hold for weights of 1 and 3, and 2 and 0.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 3.3e-7 | 4e-5 | 1.2e-7 | found |
/// | sample, rms | 2.5e-8 | 5.3e-6 | 1.1e-8 | found |
/// | sample, mean | 0 | -1.6e-6 | -3.6e-9 | found |
/// | pdf | 1.8e-9 | 1.8e-9 | 1.8e-9 | found |
/// | round trip | 6.5e-7 | 8e-5 | 2.3e-7 | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Bilinear -->1,881 instructions and 928 bytes of code on an M0, 1,184 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{U0F32, U16F16};
/// use microwarp::{Invert, Warp, fixed as mw};
/// // 0 at the lower left corner, and 1, 1 and 2 at the others: p = x + y.
/// let patch = mw::Bilinear::new([[0, 1], [1, 2]].map(|row| row.map(U16F16::from_num)))?;
/// let point = patch.sample([0.5_f32, 0.25].map(U0F32::from_num));
/// let [x, y] = point.map(|c| c.to_num::<f64>());
/// assert!((patch.pdf(point).to_num::<f64>() - (x + y)).abs() < 1e-8);
/// assert!((patch.invert(point)[1].to_num::<f64>() - 0.25).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Tent`](super::Tent) is linear to both sides, on the line.
/// - [`warp::Bilinear`](crate::warp::Bilinear) is the one of the float tiers.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", fourth edition, 2023,
/// <https://pbr-book.org/4ed/contents>.
#[doc(alias = "patch")]
#[doc(alias = "quad")]
#[doc(alias = "linear")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bilinear<G = Fine> {
    /// The weights, shifted until the first bit of the largest is set.
    corners: [[u32; 2]; 2],
    /// The sums of the rows, as [`normal`] has them.
    rows: [u32; 2],
    /// 4 over the sum of all, as parts of 2³².
    scale: Scaled,
    grade: PhantomData<G>,
}

impl<G: Grade> Bilinear<G> {
    /// Density in proportion to the interpolation of `weights[y][x]`: the first row holds the weights at (0, 0) and
    /// (1, 0), the second those at (0, 1) and (1, 1). Only their ratios count.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if all are 0.
    pub const fn new<Frac: LeEqU32>(weights: [[FixedU32<Frac>; 2]; 2]) -> Result<Self, Error> {
        let [[a, b], [c, d]] = weights;
        let (a, b, c, d) = (a.to_bits(), b.to_bits(), c.to_bits(), d.to_bits());
        let any = a | b | c | d;
        if any == 0 {
            return Err(Error::NotPositive(0));
        }
        let zeros = any.leading_zeros();
        let corners = [[a << zeros, b << zeros], [c << zeros, d << zeros]];
        let rows = [sum(corners[0]), sum(corners[1])];
        Ok(Self {
            corners,
            rows: normal(rows),
            scale: UNIT.over(Scaled::of(rows[0] + rows[1], 34)),
            grade: PhantomData,
        })
    }

    /// The densities at the corners, laid out as the weights.
    #[must_use]
    pub fn corners(&self) -> [[Density; 2]; 2] {
        self.corners.map(|row| {
            row.map(|weight| match weight {
                0 => Density::ZERO,
                weight => self.scale.density(weight),
            })
        })
    }

    /// The weights at both ends of the line through y, with 32 more bits.
    #[inline]
    fn between(&self, y: u32) -> [u64; 2] {
        let [[a, b], [c, d]] = self.corners;
        [blend([a, c], y), blend([b, d], y)]
    }
}

const fn sum([a, b]: [u32; 2]) -> u64 {
    a as u64 + b as u64
}

/// (2³² − t)a + tb.
#[inline]
fn blend([a, b]: [u32; 2], t: u32) -> u64 {
    let start = u64::from(a) << 32;
    if a <= b {
        start + wide(t, b - a)
    } else {
        start - wide(t, a - b)
    }
}

/// Two numbers shifted until the first bit of the larger is set, then cut to 32 bits; 0 and 0 stay so.
#[inline]
const fn normal([a, b]: [u64; 2]) -> [u32; 2] {
    let zeros = (a | b | 1).leading_zeros();
    [(a << zeros >> 32) as u32, (b << zeros >> 32) as u32]
}

/// The complement of a word, where the complement of 0 counts as the last word.
#[inline]
fn complement(word: u32) -> u32 {
    word.max(1).wrapping_neg()
}

/// The lower end, the higher one, and whether the density falls: then all is seen from the other end.
#[inline]
fn rising([a, b]: [u32; 2], at: u32) -> (u32, u32, u32, bool) {
    if a > b {
        (b, a, complement(at), true)
    } else {
        (a, b, at, false)
    }
}

/// ⌊a·2³²/b⌋; the last word from 1 up, and 0 for no part of nothing.
#[inline]
fn part(a: u32, b: u32) -> u32 {
    if a < b {
        quotient(a, b)
    } else if a > 0 {
        u32::MAX
    } else {
        0
    }
}

/// The place of a word under a linear density with these ends, one of which has its first bit set.
#[inline]
fn place<G: Grade>(ends: [u32; 2], u: u32) -> u32 {
    let (low, high, u, falls) = rising(ends, u);
    // Lengths are 2ᵏ times as long, and what has their square, so that none of a few digits is left alone.
    let k = ((u | 1).leading_zeros().saturating_sub(1) >> 1)
        .min((low | 1).leading_zeros().saturating_sub(1));
    let (near_low, near_u) = (low << k, u << (2 * k));
    let root = G::root(near(!u, square(near_low)) + near(near_u, square(high)));
    let share = near(near_u, (low >> 1) + (high >> 1));
    let x = part(share, (near_low >> 1) + (root >> 1)) >> k;
    if falls { complement(x) } else { x }
}

/// The share of a linear density with these ends below x.
#[inline]
fn share(ends: [u32; 2], x: u32) -> u32 {
    let (low, high, x, falls) = rising(ends, x);
    let below = (low >> 1) + (near(high - low, x) >> 2);
    let u = near(part(below, (low >> 2) + (high >> 2)), x);
    if falls { complement(u) } else { u }
}

impl<G: Grade> Warp for Bilinear<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Uniform; 2];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Uniform; 2] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        let y = place::<G>(self.rows, u2);
        // A line without weights has none to divide.
        let y = if self.rows[0] == 0 { y.max(1) } else { y };
        let x = place::<G>(normal(self.between(y)), u1);
        [x, y].map(Uniform::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [Uniform; 2]) -> Density {
        let [x, y] = point.map(Uniform::to_bits);
        let ends = self.between(y).map(|weight| (weight >> 32) as u32);
        self.scale.density((blend(ends, x) >> 32) as u32)
    }
}

impl<G: Grade> Invert for Bilinear<G> {
    #[inline]
    fn invert(&self, point: [Uniform; 2]) -> [Uniform; 2] {
        let [x, y] = point.map(Uniform::to_bits);
        let ends = normal(self.between(y));
        [share(ends, x), share(self.rows, y)].map(Uniform::from_bits)
    }
}
