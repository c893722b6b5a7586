//! The uniform distribution over all rotations, as unit quaternions.

use super::direction::{Scaled, around, azimuth, square_of};
use super::grade::{Fine, Grade};
use super::{Coordinate, Density, Uniform};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use core::marker::PhantomData;

/// Uniform over the rotations of space, as unit quaternions [x, y, z, w] with w ≥ 0.
///
/// √(x² + y²) = √u₁ at the angle of u₃ turns, and √(z² + w²) = √(1 − u₁) at an angle within a quarter turn of +w, which
/// grows with u₂. It is uniform in the sense of Haar: a rotation before or after does not change it.
///
/// # Density
/// 1/π² per unit area of the half sphere in four dimensions, w ≥ 0, to 2⁻³³. A quaternion and its negative are one
/// rotation.
///
/// # Domain
/// - Point: unit quaternions with w ≥ 0, (x, y, z) = sin(θ/2) times the axis and w = cos(θ/2).
/// - Uniforms: three words. (0, ½, 0) gives the identity.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate, *unit length* the largest error of the length. *Round trip* is the
/// error of the uniforms after `sample` and `invert`: of u₁, of u₂ times √(1 − u₁), and of u₃ times √u₁.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 1.3e-6 | 1.9e-4 | 8.4e-7 | found |
/// | unit length | 7.4e-7 | 2.2e-4 | 7.5e-7 | found |
/// | round trip | 6.8e-7 | 1.2e-4 | 6.2e-7 | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Rotation -->366 instructions and 620 bytes of code on an M0, 175 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I2F30, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let rotations = mw::Rotation::new();
/// let [x, y, z, w] = rotations.sample([0.0_f32, 0.5, 0.0].map(U0F32::from_num));
/// assert!((x, y, z) == (I2F30::ZERO, I2F30::ZERO, I2F30::ZERO) && w > 0.999_999);
/// // A half turn about +y, and the same by its negative.
/// let [_, _, quarter] = rotations.invert([0, 1, 0, 0].map(I2F30::from_num));
/// assert_eq!(quarter, 0.25);
/// let turned = [-0.5_f32, 0.5, -0.5, -0.5].map(I2F30::from_num);
/// assert_eq!(rotations.invert(turned), rotations.invert(turned.map(|c| -c)));
/// ```
///
/// # See also
/// - [`Sphere`](super::Sphere): directions. The image of one direction under a uniform rotation is uniform.
/// - [`warp::Rotation`](crate::warp::Rotation) is the one of the float tiers.
///
/// # Source
/// K. Shoemake, "Uniform Random Rotations", Graphics Gems III, 1992,
/// <https://doi.org/10.1016/B978-0-08-050755-2.50036-1>.
#[doc(alias = "quaternion")]
#[doc(alias = "orientation")]
#[doc(alias = "haar")]
#[doc(alias = "so3")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rotation<G = Fine>(PhantomData<G>);

impl<G: Grade> Rotation<G> {
    /// All rotations.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// 1/π² in Q32.
const DENSITY: Density = Density::from_bits(435_171_170);

impl<G: Grade> Warp for Rotation<G> {
    type Uniforms = [Uniform; 3];
    type Point = [Coordinate; 4];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 3]>) -> [Coordinate; 4] {
        let [u1, u2, u3] = u.get().map(Uniform::to_bits);
        // 1 counts as the last word.
        let rest = u1.max(1).wrapping_neg();
        let [x, y] = around::<G>(G::root(u1), u3);
        let [w, z] = around::<G>(G::root(rest), (u2 >> 1).wrapping_sub(1 << 30));
        [x, y, z, w].map(Coordinate::from_bits)
    }

    #[inline]
    fn pdf(&self, _: [Coordinate; 4]) -> Density {
        DENSITY
    }
}

impl<G: Grade> Invert for Rotation<G> {
    #[inline]
    fn invert(&self, quaternion: [Coordinate; 4]) -> [Uniform; 3] {
        let [.., w] = quaternion;
        let [x, y, z, w] = if w < Coordinate::ZERO {
            quaternion.map(Coordinate::saturating_neg)
        } else {
            quaternion
        };
        let [share, rest] =
            [[x, y], [z, w]].map(|pair| square_of(pair.map(|c| c.to_bits().unsigned_abs())));
        // Squares of numbers up to 2, of which w is below 2: their sum fits.
        let share = Scaled::of(share, 60).over(Scaled::of(share + rest, 60));
        let from_least = azimuth::<G>(w, z).to_bits().wrapping_add(1 << 30);
        // Rounding may lead past either end.
        let u2 = match from_least >> 31 {
            0 => from_least << 1,
            _ if z < Coordinate::ZERO => 0,
            _ => u32::MAX,
        };
        let [u1, u2] = [share.to_bits(32), u2].map(Uniform::from_bits);
        [u1, u2, azimuth::<G>(x, y)]
    }
}
