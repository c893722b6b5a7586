//! The uniform distribution over a cone of directions (a spherical cap).

use super::direction::{around, azimuth, is_direction, one_minus_cos};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, positive};
use crate::num::into_unit;
use crate::tier::{Tier, one_minus_cos_radians, sqrt};
use core::f32::consts::{FRAC_1_PI, PI};
use core::marker::PhantomData;

/// 2¹²⁶, its reciprocal and the root of that. k is kept lifted by it, so that its product with a uniform does not underflow.
const LIFT: f32 = 8.507_059e37;
const UNLIFT: f32 = 1.0 / LIFT;
const UNLIFT_ROOT: f32 = 1.084_202_2e-19;

/// How far beyond the rim a direction still counts as inside, relative to 1 − cos θ: by the rounding of a sample on
/// the rim.
const RIM_SLACK: f32 = 1.0 + 8.0 * f32::EPSILON;

/// Uniform over the directions within an angle of +z: a cone, also called a spherical cap.
///
/// With k = 1 − cos θmax and q = u₁k: sin θ = √(q(2 − q)), cos θ = 1 − q. The warp stores k, and 2 − k beside it,
/// because k keeps its digits where cos θmax has rounded to 1. A cone of 1e-19 rad samples as accurately as a wide
/// one. k is kept times a power of two, so that no product underflows and sin θ is 0 at u₁ = 0 alone.
///
#[cfg_attr(doc, doc = include_str!("../pictures/cone.html"))]
///
/// # Density
/// 1/(2πk) per steradian inside the cone, and a few ulp beyond its rim; 0 elsewhere. `pdf(w) > 0` is no hit test:
/// whether a ray meets the lamp is a question to the geometry.
///
/// # Domain
/// - Point: unit vectors with 1 − cos θ ≤ k. For cones under 3e-4 rad z is 1 and x and y hold all the information,
///   which `pdf` and `invert` use.
/// - Uniforms: two, for the polar angle and the azimuth. The axis is at u₁ = 0.
/// - Parameters: a half angle in radians, its sine, or 1 − cos of it.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 3.3e-7 | 3.5e-7 | proven |
/// | sin θ, ulp | 3.7 | 3.7 | found |
/// | unit length | 1.8e-7 | 2.3e-7 | proven |
/// | pdf, relative | 3.5e-7 | 3.5e-7 | found |
/// | realised density, relative | 3.5e-7 | 3.5e-7 | found |
/// | inverse | 5.4e-7 | 5.4e-7 | found |
/// | round trip | 7e-7 | 7e-7 | found |
///
/// These hold for every cone of each constructor; of a u₁ below 2⁻¹²⁶ and a k below 2⁻¹⁰⁰, sin θ has fewer digits. Azimuths of subnormal x and y, which only uniforms below 2⁻⁶⁴
/// give, have no more digits in the inverse than x and y have.
///
/// The errors of the sample and of the length are proven for every cone and every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Cone -->94 instructions and 456 bytes of code on an M4F, 4,041 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let sun = mw::Cone::from_radians(0.004_65)?; // half the angle the sun subtends, in radians
/// let direction = sun.sample([0.9, 0.3]);
/// assert!(sun.pdf(direction) > 0.0);
/// assert_eq!(sun.pdf([1.0, 0.0, 0.0]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`VisibleSphere`](super::VisibleSphere): a spherical lamp seen from a point, outside or inside.
/// - [`Oriented`](super::Oriented) turns the cone onto a direction.
/// - [`Hemisphere`](super::Hemisphere), [`Sphere`](super::Sphere): wider domains at lower cost.
/// - [`SphericalPatch`](super::SphericalPatch): bounded in azimuth, too.
///
/// # Source
/// P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM
/// Transactions on Graphics, 1996, <https://doi.org/10.1145/226150.226151>.
#[doc(alias = "spherical_cap")]
#[doc(alias = "solid_angle")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cone<T> {
    /// 1 − cos of the half angle, in (0, 2], lifted, which is exact.
    lifted: f32,
    /// 1 + cos of the half angle, which 2 − k has lost where the cone is nearly the sphere.
    rest: f32,
    tier: PhantomData<T>,
}

/// By how much the `f32` nearest to π is too large.
const PI_EXCESS: f32 = (PI as f64 - core::f64::consts::PI) as f32;

impl<T: Tier> Cone<T> {
    /// The cone of 1 − cos θmax = `k`, in (0, 2]. A `k` of 2 is the whole sphere.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less,
    /// [`Error::OutOfRange`] above 2, [`Error::Empty`] below the smallest normal `f32`.
    pub const fn from_one_minus_cos(k: f32) -> Result<Self, Error> {
        match positive(k, 0) {
            Ok(k) if k > 2.0 => Err(Error::OutOfRange(0)),
            Ok(k) if k < f32::MIN_POSITIVE => Err(Error::Empty(0)),
            Ok(k) => Ok(Self::of(k)),
            Err(e) => Err(e),
        }
    }

    /// A cone whose k is known to be in the domain.
    pub(super) const fn of(k: f32) -> Self {
        Self {
            lifted: k * LIFT,
            rest: 2.0 - k,
            tier: PhantomData,
        }
    }

    /// The cone of the given half angle in radians, in (0, π].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less,
    /// [`Error::OutOfRange`] above π, [`Error::Empty`] below about 1.6e-19 rad.
    pub fn from_radians(half_angle: f32) -> Result<Self, Error> {
        let half_angle = positive(half_angle, 0)?;
        if half_angle > PI {
            return Err(Error::OutOfRange(0));
        }
        let k = one_minus_cos_radians::<T>(half_angle);
        let mut cone = Self::from_one_minus_cos(if k > 2.0 { 2.0 } else { k })?;
        // 1 + cos θ is 1 - cos(π - θ).
        cone.rest = one_minus_cos_radians::<T>((PI - half_angle) - PI_EXCESS);
        Ok(cone)
    }

    /// The cone of the given sine of the half angle, in (0, 1]. Next to 1 it hangs on the last digits of the sine: for the
    /// cone in which a sphere is seen, take [`VisibleSphere`](super::VisibleSphere).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less,
    /// [`Error::OutOfRange`] above 1, [`Error::Empty`] below 1.6e-19.
    pub fn from_sine(sine: f32) -> Result<Self, Error> {
        let sine = positive(sine, 0)?;
        if sine > 1.0 {
            return Err(Error::OutOfRange(0));
        }
        let cos = sqrt((1.0 - sine) * (1.0 + sine));
        Self::from_one_minus_cos(sine * sine / (1.0 + cos))
    }

    /// 1 − cos θmax.
    #[must_use]
    pub const fn one_minus_cos(&self) -> f32 {
        self.lifted * UNLIFT
    }

    /// The solid angle in steradians, 2πk.
    #[must_use]
    pub const fn solid_angle(&self) -> f32 {
        2.0 * PI * self.one_minus_cos()
    }

    /// The density inside.
    #[inline]
    pub(crate) const fn density(self) -> f32 {
        0.5 * FRAC_1_PI / self.one_minus_cos()
    }
}

impl<T: Tier> PlanarMap<3> for Cone<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let lifted = u1 * self.lifted;
        let down = lifted * UNLIFT;
        let up = self.rest + (1.0 - u1) * self.one_minus_cos();
        // The smaller of the two holds the digits.
        let (lifted, small, cos) = if down < 1.0 {
            (lifted, down, 1.0 - down)
        } else {
            (up * LIFT, up, up - 1.0)
        };
        let sin = T::sqrt(lifted * (2.0 - small)) * UNLIFT_ROOT;
        around::<T>(sin, cos, u2, to);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        self.density()
    }
}

impl<T: Tier> Warp for Cone<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        if is_direction(direction) && one_minus_cos(direction) <= self.one_minus_cos() * RIM_SLACK {
            self.density()
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Cone<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, _] = direction;
        [
            into_unit(one_minus_cos(direction) / self.one_minus_cos()),
            azimuth::<T>(x, y),
        ]
    }
}
