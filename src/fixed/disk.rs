//! The uniform distribution on the unit disk.

use super::direction::{around, azimuth, square_of};
use super::grade::{Fine, Grade};
use super::{Coordinate, Density, Uniform};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use core::marker::PhantomData;

/// Uniform on the unit disk, by polar coordinates.
///
/// r = √u₁, and the angle is u₂ turns.
///
/// # Density
/// 1/π per unit area where x² + y² ≤ 1, to 2⁻³³; 0 elsewhere.
///
/// # Domain
/// - Point: x² + y² ≤ 1, always.
/// - Uniforms: two words, radius then angle. Two zeros give the centre.
///
/// # Accuracy
/// *Sample* is the absolute error of a coordinate. *Round trip* is the error of the uniforms after `sample` and
/// `invert`: of u₁, and of u₂ times the radius.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 1.1e-6 | 1.4e-4 | 8.6e-7 | proven |
/// | sample, rms | 1.5e-7 | 4.8e-5 | 2.3e-7 | found |
/// | sample, mean | -1.2e-9 | -5.7e-6 | 0 | found |
/// | round trip | 2.1e-6 | 3.8e-4 | 2.4e-6 | found |
///
/// The largest error of a sample is proven for all pairs of words: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed Disk -->204 instructions and 384 bytes of code on an M0, 98 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let disk = mw::Disk::new();
/// let [x, y] = disk.sample([0.25_f32, 0.5].map(U0F32::from_num));
/// assert_eq!((x.to_num::<f32>(), y.to_num::<f32>()), (-0.5, 0.0));
/// ```
///
/// # See also
/// - [`DiskRejection`](super::DiskRejection) and [`DiskRejection16`](super::DiskRejection16) need no sine and no root,
///   but no fixed number of words either.
/// - [`Float`](super::Float) gives the points of this disk in `f32`.
/// - [`warp::Disk`](crate::warp::Disk) is the disk of the float tiers.
///
/// # Source
/// P. Shirley, "Nonuniform Random Point Sets via Warping", Graphics Gems III, 1992.
#[doc(alias = "circle")]
#[doc(alias = "polar")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Disk<G = Fine>(PhantomData<G>);

impl<G: Grade> Disk<G> {
    /// The unit disk.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// 1/π in Q32.
const DENSITY: Density = Density::from_bits(1_367_130_551);

impl<G: Grade> Warp for Disk<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Coordinate; 2];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Coordinate; 2] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        let radius = G::root(u1).min(G::RIM);
        around::<G>(radius, u2).map(Coordinate::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [Coordinate; 2]) -> Density {
        uniform_density(point)
    }
}

impl<G: Grade> Invert for Disk<G> {
    #[inline]
    fn invert(&self, point: [Coordinate; 2]) -> [Uniform; 2] {
        let [x, y] = point;
        // Q60 to Q32, to the nearest; the rim counts as the last word.
        let u1 = (radius_squared(point) + (1 << 27)) >> 28;
        let u1 = u32::try_from(u1).unwrap_or(u32::MAX);
        [Uniform::from_bits(u1), azimuth::<G>(x, y)]
    }
}

/// x² + y² in Q60.
#[inline]
fn radius_squared(point: [Coordinate; 2]) -> u64 {
    square_of(point.map(|c| c.to_bits().unsigned_abs()))
}

/// The density of the uniform distribution at a point.
#[inline]
pub(super) fn uniform_density(point: [Coordinate; 2]) -> Density {
    if radius_squared(point) <= 1 << 60 {
        DENSITY
    } else {
        Density::ZERO
    }
}
