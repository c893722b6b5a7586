//! Spherical coordinates with their Jacobians, and the uniform distribution on a latitude-longitude patch.

use super::direction::{Azimuths, azimuth, between_poles, is_direction, nudged, one_minus_cos};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, finite, tried};
use crate::num::vector::scaled;
use crate::num::{clamp, into_unit};
use crate::tier::{Tier, sqrt};
use core::f32::consts::TAU;
use core::marker::PhantomData;

/// A point in spherical coordinates: radius, polar angle θ from +z and azimuth φ from +x, both in turns.
///
/// # Density
/// The volume element is r² sin θ dr dθ dφ and the solid angle is sin θ dθ dφ, with θ and φ in radians: see
/// [`Spherical::volume_jacobian`] and [`Spherical::solid_angle_jacobian`].
///
/// # Domain
/// - Coordinates: r ≥ 0, θ in [0, ½], φ any finite number of turns (one turn is 2π radians). `from_cartesian` gives
///   φ in [0, 1).
/// - A radius that overflows is the largest `f32`.
///
/// # Accuracy
/// Whatever the coordinates: radius 1.4e-7 relative, Cartesian coordinates 1.5e-7 of the radius, angles 9.8e-8
/// turns (`libm`) or 6.0e-8 (`poly`). The Jacobians are right to 7.2e-8 (sin θ, absolute) and, for θ from 1e-37 to
/// below ½, to 2.5e-7 (r² sin θ, relative). Where a result is subnormal, half a step of the subnormals comes on
/// top. Azimuths are reduced exactly, however many turns they are.
///
/// # Examples
/// ```
/// use microwarp::poly as mw;
/// let p = mw::Spherical::from_cartesian([0.0, 3.0, 0.0]);
/// assert_eq!((p.radius(), p.theta_turns(), p.phi_turns()), (3.0, 0.25, 0.25));
/// assert_eq!(p.to_cartesian(), [0.0, 3.0, 0.0]);
/// assert_eq!(p.volume_jacobian(), 9.0);
/// ```
///
/// # See also
/// - [`SphericalPatch`](super::SphericalPatch) samples between two polar angles and two azimuths.
/// - [`LatLongMap`](crate::discrete::LatLongMap): an environment map by latitude and longitude.
#[doc(alias = "polar")]
#[doc(alias = "cartesian")]
#[doc(alias = "latitude")]
#[doc(alias = "longitude")]
#[doc(alias = "jacobian")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Spherical<T> {
    radius: f32,
    theta: f32,
    phi: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> Spherical<T> {
    /// The point at the given radius, polar angle and azimuth, with both angles in turns.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a negative radius,
    /// [`Error::OutOfRange`] for a polar angle outside [0, ½] turns. Any finite azimuth is accepted.
    pub const fn from_turns(radius: f32, theta: f32, phi: f32) -> Result<Self, Error> {
        tried!(finite(radius, 0));
        tried!(finite(theta, 1));
        tried!(finite(phi, 2));
        if radius < 0.0 {
            Err(Error::Negative(0))
        } else if theta < 0.0 || theta > 0.5 {
            Err(Error::OutOfRange(1))
        } else {
            Ok(Self {
                radius,
                theta,
                phi,
                tier: PhantomData,
            })
        }
    }

    /// The spherical coordinates of a point. At the origin both angles are 0. A coordinate that is not finite counts as
    /// 0.
    #[must_use]
    pub fn from_cartesian(point: [f32; 3]) -> Self {
        let point = point.map(|c| if c.is_finite() { c } else { 0.0 });
        let (scale, [x, y, z]) = scaled(point);
        let equatorial = sqrt(x * x + y * y);
        let radius = sqrt(x * x + y * y + z * z) * scale;
        // Not the divided x and y, which underflow beside a far larger z.
        let [x, y, _] = point;
        let phi = azimuth::<T>(x, y);
        Self {
            radius: clamp(radius, 0.0, f32::MAX),
            theta: T::atan2_turns(equatorial, z).abs(),
            phi,
            tier: PhantomData,
        }
    }

    /// The radius.
    #[must_use]
    pub const fn radius(&self) -> f32 {
        self.radius
    }

    /// The polar angle from +z in turns, in [0, ½].
    #[must_use]
    pub const fn theta_turns(&self) -> f32 {
        self.theta
    }

    /// The azimuth from +x in turns.
    #[must_use]
    pub const fn phi_turns(&self) -> f32 {
        self.phi
    }

    /// The point in Cartesian coordinates.
    #[must_use]
    pub fn to_cartesian(&self) -> [f32; 3] {
        let (sin, cos) = T::sincos_turns(self.theta);
        // `Tier::polar` takes fewer than 2^20 turns.
        let (sin_phi, cos_phi) = T::sincos_turns(self.phi);
        [sin * cos_phi, sin * sin_phi, cos].map(|c| c * self.radius)
    }

    /// sin θ: multiplies a density per steradian into one per radian of θ and radian of φ. At both poles it is 0:
    /// +0 at θ = 0, −0 at θ = ½. Divide by it only where it is `> 0.0`; a density over −0 is −∞.
    #[must_use]
    pub fn solid_angle_jacobian(&self) -> f32 {
        T::sincos_turns(self.theta).0
    }

    /// r² sin θ: multiplies a density per unit volume into one per unit of r, radian of θ and radian
    /// of φ. The largest `f32` where it overflows; a zero of either sign at the poles.
    #[must_use]
    pub fn volume_jacobian(&self) -> f32 {
        clamp(
            self.radius * self.solid_angle_jacobian() * self.radius,
            0.0,
            f32::MAX,
        )
    }
}

/// Uniform over the directions between two polar angles and two azimuths, a rectangle of latitude and longitude.
///
/// cos θ is uniform between its two ends, and φ is uniform. The code works with 1 − cos θ and 1 + cos θ, so that
/// neither pole cancels.
///
#[cfg_attr(doc, doc = include_str!("../pictures/spherical_patch.html"))]
///
/// # Density
/// 1/Ω per steradian inside, with Ω = (cos θ₀ − cos θ₁)(φ₁ − φ₀)·2π; else 0. A direction counts as inside up to the
/// rounding of its coordinates: 5e-7 relative in 1 ∓ cos θ, and 3e-7 turns of azimuth, which matters in patches
/// only a few times wider than that.
///
/// # Domain
/// - Point: unit vectors with θ and φ in the given ranges (φ modulo one turn).
/// - Uniforms: two, for the polar angle and the azimuth.
/// - Parameters: angles in turns (one turn is 2π radians): 0 ≤ θ₀ < θ₁ ≤ ½, −1 ≤ φ₀ ≤ 1, φ₀ < φ₁ ≤ φ₀ + 1.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 6.4e-7 | 6.4e-7 | found |
/// | unit length | 2.7e-7 | 3.3e-7 | found |
/// | pdf, relative | 7.5e-7 | 7.5e-7 | found |
/// | realised density, relative | 7.5e-7 | 7.5e-7 | found |
/// | inverse | min(1, 2.9e-7 + 7.1e-7*q/c + 2.1e-7/w) | min(1, 3e-7 + 7.3e-7*q/c + 1.6e-7/w) | found |
/// | round trip | min(1, 2.8e-7 + 8.1e-7*q/c + 2e-7/w) | min(1, 2.7e-7 + 7.9e-7*q/c + 1.6e-7/w) | found |
///
/// These hold for every patch: c is cos θ₀ − cos θ₁, w the width φ₁ − φ₀ in turns, and q the smaller of 1 − cos θ₁
/// and 1 + cos θ₀.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost SphericalPatch -->108 instructions and 500 bytes of code on an M4F, 5,506 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let octant = mw::SphericalPatch::from_turns(0.0, 0.25, 0.0, 0.25)?;
/// assert!((octant.solid_angle() - core::f32::consts::FRAC_PI_2).abs() < 1e-6);
/// assert!(octant.pdf([0.6, 0.0, 0.8]) > 0.0);
/// assert_eq!(octant.pdf([-0.6, 0.0, 0.8]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Cone`](super::Cone), [`Sphere`](super::Sphere): the whole circle of azimuths at a lower cost.
/// - [`Spherical`](super::Spherical): the coordinates and their Jacobians.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://pbr-book.org/3ed-2018/contents>, for dω = sin θ dθ dφ.
#[doc(alias = "latitude")]
#[doc(alias = "longitude")]
#[doc(alias = "solid_angle")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphericalPatch<T> {
    // Single numbers: other types would stand in the bounds of `defmt::Format`.
    theta0: f32,
    theta1: f32,
    /// 1 − cos θ at the first polar angle, 1 + cos θ at the second, and the gain of each towards the other.
    down: f32,
    up: f32,
    drop: f32,
    start: f32,
    width: f32,
    rest: f32,
    density: f32,
    tier: PhantomData<T>,
}

/// How far outside the patch rounding can carry a sample, relative in 1 − cos θ and 1 + cos θ.
const POLAR_SLACK: f32 = 4.0 * f32::EPSILON;
/// The part of 1 ∓ cos θ that underflows next to a pole.
const UNDERFLOW: f32 = 4.0 * f32::MIN_POSITIVE;

impl<T: Tier> SphericalPatch<T> {
    /// The directions with θ in [`theta0`, `theta1`] and φ in [`phi0`, `phi1`], all in turns.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Reversed`] if an upper end is below its lower,
    /// [`Error::OutOfRange`] for polar angles outside [0, ½], a `phi0` outside [−1, 1] or a width above 1
    /// turn, [`Error::Empty`] for a patch with no extent, one whose density overflows or
    /// one whose cos θ₀ − cos θ₁ is below the smallest normal `f32`. A width that rounds to 1 is a whole turn.
    pub fn from_turns(theta0: f32, theta1: f32, phi0: f32, phi1: f32) -> Result<Self, Error> {
        for (angle, place) in [theta0, theta1, phi0, phi1].into_iter().zip(0..) {
            finite(angle, place)?;
        }
        if theta0 > theta1 || phi0 > phi1 {
            return Err(Error::Reversed(if theta0 > theta1 { 1 } else { 3 }));
        }
        if theta0 < 0.0 || theta1 > 0.5 {
            return Err(Error::OutOfRange(usize::from(theta0 >= 0.0)));
        }
        let Azimuths { start, width, rest } = Azimuths::new([phi0, phi1], [2, 3])?;
        // 1 - cos θ = 2 sin²(θ/2); cos θ₀ - cos θ₁ = 2 sin((θ₀+θ₁)/2) sin((θ₁-θ₀)/2).
        let (sin_half, _) = T::sincos_turns(0.5 * theta0);
        let (_, cos_half) = T::sincos_turns(0.5 * theta1);
        // The sine of the mean is measured from the nearer pole: beside the lower one the sum of both angles has lost
        // the digits.
        let sum = theta0 + theta1;
        let sum = if sum <= 0.5 {
            sum
        } else {
            (0.5 - theta0) + (0.5 - theta1)
        };
        let (mean, _) = T::sincos_turns(0.5 * sum);
        let (half_width, _) = T::sincos_turns(0.5 * (theta1 - theta0));
        let drop = 2.0 * mean * half_width;
        let density = 1.0 / TAU / drop / width;
        if !(density.is_finite() && drop >= f32::MIN_POSITIVE && width > 0.0) {
            return Err(Error::Empty(if theta0 >= theta1 {
                1
            } else if phi0 >= phi1 {
                3
            } else {
                Error::NO_PLACE
            }));
        }
        Ok(Self {
            theta0,
            theta1,
            down: 2.0 * sin_half * sin_half,
            up: 2.0 * cos_half * cos_half,
            drop,
            start,
            width,
            rest,
            density,
            tier: PhantomData,
        })
    }

    /// The solid angle in steradians.
    #[must_use]
    pub fn solid_angle(&self) -> f32 {
        1.0 / self.density
    }

    /// The polar angles of the upper and the lower side in turns.
    #[must_use]
    pub const fn theta_turns(&self) -> [f32; 2] {
        [self.theta0, self.theta1]
    }

    /// The azimuths of the two sides in turns. The second of a whole turn is the first plus 1, rounded to `f32`.
    #[must_use]
    pub const fn phi_turns(&self) -> [f32; 2] {
        self.azimuths().sides()
    }

    const fn azimuths(&self) -> Azimuths {
        let Self {
            start, width, rest, ..
        } = *self;
        Azimuths { start, width, rest }
    }
}

/// 1 + cos θ, by the mirror image.
#[inline]
fn one_plus_cos([x, y, z]: [f32; 3]) -> f32 {
    one_minus_cos([x, y, -z])
}

impl<T: Tier> PlanarMap<3> for SphericalPatch<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let down = self.down + u1 * self.drop;
        let up = self.up + (1.0 - u1) * self.drop;
        let (turn, angle) = self.azimuths().at(u2);
        between_poles::<T>(down, up, turn, to);
        let [x, y, z] = *to;
        let [x, y] = nudged(x, y, angle);
        *to = [x, y, z];
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        self.density
    }
}

impl<T: Tier> Warp for SphericalPatch<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let [x, y, _] = direction;
        let first = self.down - self.down * POLAR_SLACK - UNDERFLOW;
        let last = self.up - self.up * POLAR_SLACK - UNDERFLOW;
        // A pole lies in every patch that touches it, whatever its azimuth.
        let beside = (x == 0.0 && y == 0.0) || self.azimuths().contain::<T>(x, y);
        let between = one_minus_cos(direction) >= first && one_plus_cos(direction) >= last;
        if is_direction(direction) && between && beside {
            self.density
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for SphericalPatch<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, z] = direction;
        let polar = if z < 0.0 {
            1.0 - (one_plus_cos(direction) - self.up) / self.drop
        } else {
            (one_minus_cos(direction) - self.down) / self.drop
        };
        [into_unit(polar), self.azimuths().invert::<T>(x, y)]
    }
}
