//! The uniform distribution over all rotations, as unit quaternions.

use super::direction::azimuth;
use super::{Invert, Warp};
use crate::num::into_unit;
use crate::tier::Tier;
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// Uniform over the rotations of space, as unit quaternions [x, y, z, w] with w ≥ 0.
///
/// √(x² + y²) = √u₁ at the angle of u₃ turns, and √(z² + w²) = √(1 − u₁) at an angle within a quarter turn of +w, which
/// grows with u₂. It is uniform in the sense of Haar: a rotation before or after does not change it. The angle θ of
/// the rotation has density (1 − cos θ)/π; an axis and an angle that are uniform each favour small angles.
///
#[cfg_attr(doc, doc = include_str!("../pictures/rotation.html"))]
///
/// # Density
/// 1/π² per unit area of the half sphere in four dimensions, w ≥ 0, for any finite quaternion. A quaternion and its
/// negative are one rotation. For the measure in which the rotations have the volume 8π², as by Euler angles,
/// divide by 8; a density with respect to the uniform distribution itself is 1.
///
/// # Domain
/// - Point: unit quaternions with w ≥ 0, (x, y, z) = sin(θ/2) times the axis and w = cos(θ/2).
/// - Uniforms: three. (0, ½, 0) gives the identity.
///
/// # Accuracy
/// *Sample* is the distance from the exact quaternion, in four dimensions; its length is right to the same bound. *Pdf*
/// and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 2e-7 | 2.2e-7 | proven |
/// | pdf, relative | 5.5e-9 | 5.5e-9 | exhaustive |
/// | realised density, relative | 5.5e-9 | 5.5e-9 | exhaustive |
/// | inverse | 1.3e-7 | 1.2e-7 | found |
/// | round trip | 2.4e-7 | 2.4e-7 | found |
///
/// The error of the sample is proven for all uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Rotation -->137 instructions and 540 bytes of code on an M4F, 6,632 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let rotations = mw::Rotation::new();
/// assert_eq!(rotations.sample([0.0, 0.5, 0.0]), [0.0, 0.0, 0.0, 1.0]);
/// // A half turn about +y, and the same by its negative.
/// assert_eq!(rotations.invert([0.0, 1.0, 0.0, 0.0])[2], 0.25);
/// assert_eq!(rotations.invert([-0.5, 0.5, -0.5, -0.5]), rotations.invert([0.5, -0.5, 0.5, 0.5]));
/// ```
///
/// # See also
/// - [`Sphere`](super::Sphere): directions. The image of one direction under a uniform rotation is uniform.
/// - [`Frame`](super::Frame): an orthonormal frame about a given normal.
/// - `fixed::Rotation`, with feature `fixed`: on integers.
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
pub struct Rotation<T>(PhantomData<T>);

/// 1/π².
const DENSITY: f32 = 0.101_321_18;

impl<T: Tier> Rotation<T> {
    /// All rotations.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T: Tier> Warp for Rotation<T> {
    type Uniforms = [f32; 3];
    type Point = [f32; 4];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 3]>) -> [f32; 4] {
        let [u1, u2, u3] = u.get();
        let (x, y) = T::polar(T::sqrt(u1), u3);
        let (w, z) = T::polar(T::sqrt(1.0 - u1), 0.5 * u2 - 0.25);
        // The cosine of a quarter turn is a zero of either sign.
        [x, y, z, w.abs()]
    }

    #[inline]
    fn pdf(&self, quaternion: [f32; 4]) -> f32 {
        if quaternion.iter().all(|c| c.is_finite()) {
            DENSITY
        } else {
            0.0
        }
    }

    super::filled_in_blocks!(where T::VECTORS);
}

impl<T: Tier> Invert for Rotation<T> {
    #[inline]
    fn invert(&self, quaternion: [f32; 4]) -> [f32; 3] {
        let [.., w] = quaternion;
        let sign = if w < 0.0 { -1.0 } else { 1.0 };
        let [x, y, z, w] = quaternion.map(|c| sign * c);
        let share = x * x + y * y;
        [
            into_unit(share / (share + (z * z + w * w))),
            into_unit(0.5 + 2.0 * T::atan2_turns(z, w)),
            azimuth::<T>(x, y),
        ]
    }
}
