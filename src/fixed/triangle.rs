//! The uniform distribution on a triangle: in barycentric coordinates, and on three given vertices.

use super::direction::ONE;
use super::grade::{Fine, Grade};
use super::kernel::product::near;
use super::kernel::quotient::quotient;
use super::{Coordinate, Density, Uniform};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use core::marker::PhantomData;

/// Uniform barycentric coordinates of a triangle.
///
/// [1 − √u₁, √u₁ u₂, √u₁ (1 − u₂)].
///
/// # Density
/// 2 with respect to the last two coordinates, where no coordinate is negative and their sum is 1 to within 2⁻²³; 0
/// elsewhere.
///
/// # Domain
/// - Point: three coordinates, none negative, whose sum is exactly 1.
/// - Uniforms: two words.
///
/// # Accuracy
/// *Sample* is the largest error of a coordinate. *Round trip* is the error of the uniforms after `sample` and `invert`:
/// of u₁, and of u₂ times √u₁.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 2.5e-7 | 2.2e-5 | 7.6e-8 | found |
/// | sample, rms | 3.5e-8 | 7.4e-6 | 1.7e-8 | found |
/// | sample, mean | 0 | 2.0e-6 | 4.0e-9 | found |
/// | round trip | 4.7e-7 | 4.1e-5 | 1.5e-7 | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Triangle -->162 instructions and 284 bytes of code on an M0, 64 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let point = mw::Triangle::new().sample([0.25_f32, 0.5].map(U0F32::from_num));
/// assert_eq!(point, [0.5, 0.25, 0.25]);
/// ```
///
/// # See also
/// - [`TriangleOn`](super::TriangleOn) places the points between three vertices.
/// - [`warp::Triangle`](crate::warp::Triangle) is the one of the float tiers.
///
/// # Source
/// G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
#[doc(alias = "barycentric")]
#[doc(alias = "simplex")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Triangle<G = Fine>(PhantomData<G>);

impl<G: Grade> Triangle<G> {
    /// The triangle of all barycentric coordinates.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// The allowed error of the sum of the coordinates, in steps: 2⁻²³, as for three numbers cut to the digits of an `f32`.
pub(super) const SLACK: u32 = 1 << 7;

impl<G: Grade> Warp for Triangle<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 3];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 3] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        let root = G::root(u1);
        let (both, first) = ((root >> 2) as i32, (near(root, u2) >> 2) as i32);
        [ONE - both, first, both - first].map(Coordinate::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [Coordinate; 3]) -> Density {
        let [a, b, c] = point.map(Coordinate::to_bits);
        // Three numbers below 2³¹ sum up to less than 2³³.
        let sum = i64::from(a) + i64::from(b) + i64::from(c);
        let whole = sum.abs_diff(i64::from(ONE)) <= u64::from(SLACK);
        if a >= 0 && b >= 0 && c >= 0 && whole {
            Density::from_bits(2 << 32)
        } else {
            Density::ZERO
        }
    }
}

impl<G: Grade> Invert for Triangle<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 3]) -> [Uniform; 2] {
        let [_, b, c] = point.map(|c| c.to_bits().clamp(0, ONE) as u32);
        let both = b + c;
        // Q60 to Q32, the nearest; 1 as the last word.
        let square = (u64::from(both) * u64::from(both) + (1 << 27)) >> 28;
        let u1 = u32::try_from(square).unwrap_or(u32::MAX);
        let u2 = if b < both {
            quotient(b, both)
        } else if b > 0 {
            u32::MAX
        } else {
            0
        };
        [u1, u2].map(Uniform::from_bits)
    }
}
