//! The uniform distribution in the unit ball.

use super::direction::azimuth;
use super::{Invert, Warp, drawn_with_pdf};
use crate::num::{cube_root, into_unit};
use crate::tier::Tier;
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// Uniform in the unit ball, the solid sphere.
///
/// r = ∛u₁, and a direction of [`Sphere`](super::Sphere): z = r(1 − 2u₂), √(x² + y²) = 2r√(u₂(1 − u₂)), φ = u₃ turns.
/// The cube root is right to 0.51 units in the last place.
///
#[cfg_attr(doc, doc = include_str!("../pictures/ball.html"))]
///
/// # Density
/// 3/(4π) per unit volume where x² + y² + z² ≤ 1, up to the rounding of the coordinates (3.6e-7 of the radius); else 0.
///
/// # Domain
/// - Point: x² + y² + z² ≤ 1, up to the rounding of the coordinates.
/// - Uniforms: three, for radius, height and azimuth. Strata of the first are shells of equal volume.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 2.8e-7 | proven |
/// | pdf, relative | 1e-8 | exhaustive |
/// | realised density, relative | 1e-8 | exhaustive |
/// | inverse | 3e-7 | found |
/// | round trip | 1.1e-6 | found |
///
/// The error of the sample is proven for all uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Ball -->146 instructions and 720 bytes of code on an M4F, 6,739 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let ball = mw::Ball::new();
/// assert_eq!(ball.sample([0.125, 0.5, 0.25]), [0.0, 0.5, 0.0]);
/// assert_eq!(ball.invert([0.0, 0.5, 0.0]), [0.125, 0.5, 0.25]);
/// ```
///
/// # See also
/// - [`Sphere`](super::Sphere): its surface.
/// - [`rejection::BallRejection`](crate::rejection::BallRejection) needs no sine and no root, but no fixed number of
///   uniforms either.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
#[doc(alias = "sphere")]
#[doc(alias = "solid")]
#[doc(alias = "volume")]
#[doc(alias = "cube_root")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ball<T>(PhantomData<T>);

/// 3/(4π).
const DENSITY: f32 = 0.238_732_41;

/// How far outside rounding can carry a sample, in the square of the radius.
const SLACK: f32 = 6.0 * f32::EPSILON;

impl<T: Tier> Ball<T> {
    /// The unit ball.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<T: Tier> Warp for Ball<T> {
    type Uniforms = [f32; 3];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 3]>) -> [f32; 3] {
        let [u1, u2, u3] = u.get();
        let r = cube_root(u1);
        let (x, y) = T::polar(r * (2.0 * T::sqrt(u2 * (1.0 - u2))), u3);
        [x, y, r * (1.0 - 2.0 * u2)]
    }

    #[inline]
    fn pdf(&self, [x, y, z]: [f32; 3]) -> f32 {
        if x * x + y * y + z * z <= 1.0 + SLACK {
            DENSITY
        } else {
            0.0
        }
    }

    /// Without the test of `pdf`.
    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 3]>) -> ([f32; 3], f32) {
        (self.sample_canonical(u), DENSITY)
    }

    drawn_with_pdf!();
    super::filled_in_blocks!(where T::VECTORS);
}

impl<T: Tier> Invert for Ball<T> {
    #[inline]
    fn invert(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let equatorial = x * x + y * y;
        let square = equatorial + z * z;
        let r = T::sqrt(square);
        // 1 − cos θ, from x and y near +z, where z has lost the digits.
        let down = if z > 0.5 * r {
            equatorial / (r * (r + z))
        } else {
            1.0 - z / r
        };
        [
            into_unit(square * r),
            into_unit(0.5 * down),
            azimuth::<T>(x, y),
        ]
    }
}
