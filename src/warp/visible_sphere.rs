//! The directions in which a sphere is seen from a point.

use super::contract::drawn_by;
use super::direction::{around, normalised};
use super::planar::{PlanarMap, planar};
use super::{Cone, Frame, Invert, LightSample, Oriented, Warp};
use crate::error::{Error, finite, positive};
use crate::num::vector::{copied, magnitude};
use crate::num::{
    ExactSum, Scaled, clamp, product, quick_two_sum, remainder, two_product, two_sum,
};
use crate::tier::{Tier, sqrt};
use crate::uniform::Uniforms;

/// A place on a surface that is seen from a point: in which direction, how far away, and with which density.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SurfaceSample {
    /// The direction from the point to the surface, a unit vector in world coordinates.
    pub direction: [f32; 3],
    /// The distance to the surface in that direction.
    pub distance: f32,
    /// The density of the direction, per steradian.
    pub pdf: f32,
}

/// Uniform over the directions in which a sphere is seen from a point: a sphere light, sampled by solid angle.
///
#[cfg_attr(doc, doc = include_str!("../pictures/visible_sphere.html"))]
///
/// From outside, the directions fill a [`Cone`] about the centre. With d the distance to the centre and r the radius,
/// its cos θmax is `√(d² − r²)/d`, and `k = 1 − cos θmax = r²/(d²(1 + cos θmax))`. Where d² − r² is
/// below d²/4 it is worked out from both roundings of centre − point, and next to the surface exactly. So no height above
/// the surface is too small, and whether the point is inside is always decided right.
///
/// # Density
/// 1/(2πk) per steradian from outside, on the directions of the cone and up to 5e-7 rad beyond its rim; 1/(4π) in all
/// directions from inside. On the surface itself k is 1, and the directions fill the hemisphere towards the centre: the
/// limit from outside.
///
/// `pdf(w) > 0` is no hit test, and a lamp of half angle below about 1e-5 rad is best taken as a point.
/// [`Oriented`](super::Oriented#density) says why. The density that comes with a sample belongs to its uniforms, and is
/// right however narrow the cone is.
///
/// # Domain
/// - Point: unit vectors in world coordinates. [`VisibleSphere::sample_surface`] adds the distance to the surface: to
///   the near side from outside, from inside to the far one.
/// - Uniforms: two. The direction of the centre is at u₁ = 0, the rim (from inside, the opposite direction) at u₁ = 1.
/// - Parameters: any finite point and centre, and any radius above 0, if the half angle is at least 1.6e-19 rad and
///   the far side of the sphere not beyond the range of `f32`.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. *Pdf* and *realised density*
/// are relative, *inverse* and *round trip* are absolute errors of the uniforms; r is what one rounding of the direction
/// changes in them. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 9e-7 | 9e-7 | found |
/// | unit length | 5.3e-7 | 5.3e-7 | found |
/// | pdf, relative | 9e-7 | 9e-7 | found |
/// | realised density, relative | 9e-7 | 9e-7 | found |
/// | inverse | min(1, 5e-7 + 15*r) | min(1, 5e-7 + 15*r) | found |
/// | round trip | min(1, 6.2e-7 + 11*r) | min(1, 6.2e-7 + 11*r) | found |
///
/// In both tiers k is right to 8e-7 and the distance to 1.9e-6, relatively. The distance belongs to the uniforms, and
/// loses digits where it is below 1e-37, or the point nearer to the surface than 1e-37 radii.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost VisibleSphere -->107 instructions and 468 bytes of code on an M4F, 5,074 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let lamp = mw::VisibleSphere::new([0.0, 0.0, 0.0], [0.0, 3.0, 4.0], 0.5)?;
/// let seen = lamp.sample_surface([0.9, 0.3]);
/// assert!(seen.distance >= 4.5 && seen.distance < 5.0); // the end of a shadow ray
/// assert!((seen.pdf * lamp.solid_angle() - 1.0).abs() < 1e-6);
/// assert_eq!(seen.direction, lamp.sample([0.9, 0.3]));
/// assert_eq!(seen.pdf, lamp.pdf(seen.direction));
///
/// // Inside, every direction meets the lamp.
/// let within = mw::VisibleSphere::new([0.0, 3.0, 4.25], [0.0, 3.0, 4.0], 0.5)?;
/// assert!(within.is_inside() && within.pdf([1.0, 0.0, 0.0]) > 0.0);
/// assert_eq!(within.sample_surface([0.0, 0.0]).distance, 0.75);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// In a renderer, no refusal is worth ending a picture: edge-on, or next to the lamp, `new` returns an error. Take `.ok()`.
/// A lamp that is refused gives no light by this technique; what else hits it counts with density 0, so with weight 1.
///
/// # See also
/// - [`Cone`]: the same about +z, by its angle.
/// - [`EquiAngular`](super::EquiAngular): a ray through the fog around a lamp.
///
/// # Source
/// P. Shirley, C. Wang and K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM
/// Transactions on Graphics, 1996, <https://doi.org/10.1145/226150.226151>, rearranged here.
#[doc(alias = "sphere_light")]
#[doc(alias = "solid_angle")]
#[doc(alias = "spherical_cap")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VisibleSphere<T> {
    point: [f32; 3],
    centre: [f32; 3],
    radius: f32,
    cone: Oriented<Cone<T>>,
    /// cos θmax; 0 inside.
    cos: f32,
    /// A power of two, the unit of the next two.
    scale: f32,
    /// d.
    distance: f32,
    /// |d² − r²|.
    gap: f32,
}

/// 2³⁰ and its reciprocal: within these, squares of distances and of radii, and their quotients, are plain numbers.
const FAR: f32 = 1_073_741_824.0;
const SMALL: f32 = 1.0 / FAR;

/// Where d² − r² is a smaller part of d², the rounding of squares shows in it.
const CLOSE: f32 = 0.25;

/// 2⁻¹⁶. Where d² − r² is a smaller part of d², the sum in twice the precision of `f32` has lost digits of it.
const NEAR: f32 = 1.0 / 65_536.0;

impl<T: Tier> VisibleSphere<T> {
    /// The sphere of the given centre and radius, seen from `point`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a radius of 0 or less, [`Error::TooLarge`] where
    /// the far side of the sphere is beyond the range of `f32`, [`Error::Empty`] for a sphere seen under less than 1.6e-19 rad.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[inline(always)]
    pub fn new(point: [f32; 3], centre: [f32; 3], radius: f32) -> Result<Self, Error> {
        let ([px, py, pz], [cx, cy, cz]) = (point, centre);
        let (x, y, z) = (cx - px, cy - py, cz - pz);
        let (square, r2) = (x * x + y * y + z * z, radius * radius);
        let gap = square - r2;
        // False for NaN.
        let plain = gap >= CLOSE * square && square < FAR * FAR && radius > SMALL;
        let Cap {
            normal,
            k,
            cos,
            scale,
            distance,
            gap,
        } = if plain {
            let (distance, rim) = (sqrt(square), sqrt(gap));
            let inverse = 1.0 / distance;
            Cap {
                normal: [x * inverse, y * inverse, z * inverse],
                k: r2 / (square + distance * rim),
                cos: rim * inverse,
                scale: 1.0,
                distance,
                gap,
            }
        } else {
            compensated(copied(point), copied(centre), radius)?
        };
        Ok(Self {
            point,
            centre,
            radius,
            cone: Oriented::new(Cone::of(k), Frame::about(normal)),
            cos,
            scale,
            distance,
            gap,
        })
    }

    /// The point from which the sphere is seen.
    #[must_use]
    pub const fn point(&self) -> [f32; 3] {
        self.point
    }

    /// The centre of the sphere.
    #[must_use]
    pub const fn centre(&self) -> [f32; 3] {
        self.centre
    }

    /// The radius of the sphere.
    #[must_use]
    pub const fn radius(&self) -> f32 {
        self.radius
    }

    /// k: 1 − cos θmax from outside, 2 from inside.
    #[must_use]
    pub const fn one_minus_cos(&self) -> f32 {
        self.cone.warp().one_minus_cos()
    }

    /// Whether the point is inside the sphere. On its surface it is not.
    #[must_use]
    pub fn is_inside(&self) -> bool {
        self.one_minus_cos() > 1.0
    }

    /// The solid angle in steradians under which the sphere is seen, 2πk.
    #[must_use]
    pub const fn solid_angle(&self) -> f32 {
        self.cone.warp().solid_angle()
    }

    /// The density of every direction that meets the sphere, per steradian: for one that another technique has found, as
    /// multiple importance sampling needs it. `pdf` tells such directions from others, which takes longer.
    #[must_use]
    #[inline]
    pub const fn density(&self) -> f32 {
        self.cone.warp().density()
    }

    /// The place on the sphere that is seen in the direction of two uniforms.
    #[must_use]
    pub fn sample_surface(&self, u: [f32; 2]) -> SurfaceSample {
        let u = u.canonical();
        let (direction, pdf) = self.sample_canonical_with_pdf(u);
        let [u1, _] = u.get();
        let distance = if self.is_inside() {
            // d cos θ, and half of the chord.
            let along = self.distance * (1.0 - 2.0 * u1);
            let half = sqrt(self.gap + along * along);
            if along < 0.0 {
                self.gap / (half - along)
            } else {
                half + along
            }
        } else {
            // The same in units of d, from what the rim leaves: nothing cancels at either end.
            let (v, c, k) = (1.0 - u1, self.cos, self.one_minus_cos());
            let reach = (v + u1 * c) + sqrt(k * v * (v + c * (1.0 + u1)));
            self.gap / (self.distance * reach)
        };
        SurfaceSample {
            direction,
            distance: clamp(distance * self.scale, 0.0, f32::MAX),
            pdf,
        }
    }

    drawn_by! {
        /// Draws a place on the sphere: [`sample_surface`](Self::sample_surface) of a generator.
        draw_surface, try_draw_surface, sample_surface -> SurfaceSample
    }

    drawn_by! {
        /// Draws a direction to the sphere with its distance: [`sample_light`](Self::sample_light) of a generator.
        draw_light, try_draw_light, sample_light -> LightSample
    }

    /// The same as all lamps give it, to the same errors; a sphere has no coordinates of the place.
    #[must_use]
    pub fn sample_light(&self, u: [f32; 2]) -> LightSample {
        let seen = self.sample_surface(u);
        LightSample {
            direction: seen.direction,
            distance: seen.distance,
            pdf: seen.pdf,
            place: [0.0; 2],
        }
    }
}

/// What a sphere is from a point: its middle, 1 − cos θmax, and the figures of [`VisibleSphere`].
struct Cap {
    normal: [f32; 3],
    k: f32,
    cos: f32,
    scale: f32,
    distance: f32,
    gap: f32,
}

/// A sphere whose parameters may be anything: with the point inside or close to the surface, of any size. It takes five
/// times as long as the plain way.
#[cold]
#[inline(never)]
fn compensated(point: [f32; 3], centre: [f32; 3], radius: f32) -> Result<Cap, Error> {
    for (vector, place) in [(point, 0), (centre, 1)] {
        for c in vector {
            finite(c, place)?;
        }
    }
    positive(radius, 2)?;
    let ([px, py, pz], [cx, cy, cz]) = (point, centre);
    let sides = [(cx, px), (cy, py), (cz, pz)].map(|(c, p)| two_sum(c, -p));
    let axis = sides.map(|(side, _)| side);
    let [x, y, z] = axis;
    let scale = magnitude([x, y, z, radius]);
    let (unit, r) = (1.0 / scale, radius / scale);
    // d² and its rounding error.
    let (mut square, mut rest) = (0.0, 0.0);
    for (side, lost) in &sides {
        let (side, lost) = (side * unit, lost * unit);
        let (part, dropped) = two_product(side, side);
        let (sum, short) = two_sum(square, part);
        (square, rest) = (sum, rest + (short + (dropped + 2.0 * side * lost)));
    }
    let (square, rest) = quick_two_sum(square, rest);
    let distance = sqrt(square);
    if !(distance * scale + radius).is_finite() {
        return Err(Error::TooLarge(Error::NO_PLACE));
    }
    // r² times a power of two, and its rounding error.
    let lift = if r < SMALL { 1.0 / SMALL } else { 1.0 };
    let unlift = 1.0 / (lift * lift);
    let (r2, r2_rest) = two_product(r * lift, r * lift);
    let (gap, short) = two_sum(square, -r2 * unlift);
    let gap = gap + (short + (rest - r2_rest * unlift));
    let (inside, gap) = if gap.abs() < NEAR * square {
        exact_gap(&sides, radius, scale)
    } else {
        (gap < 0.0, gap.abs())
    };
    let (k, cos) = if inside {
        (2.0, 0.0)
    } else {
        let cos = sqrt(gap / square);
        let (whole, more) = product((square, rest), quick_two_sum(1.0, cos));
        let k = r2 / whole;
        let short = remainder(r2, k, whole) + (r2_rest - k * more);
        ((k + short / whole) * unlift, cos)
    };
    if k < f32::MIN_POSITIVE {
        return Err(Error::Empty(Error::NO_PLACE));
    }
    let normal = normalised(axis, Error::NO_PLACE).unwrap_or([0.0, 0.0, 1.0]);
    Ok(Cap {
        normal,
        k,
        cos,
        scale,
        distance,
        gap,
    })
}

/// Whether d² − r² is negative, and its size in units of the square of `scale`, from the sides of d as numbers and
/// their rounding errors.
#[cold]
fn exact_gap(sides: &[(f32, f32); 3], radius: f32, scale: f32) -> (bool, f32) {
    let mut sum = ExactSum::ZERO.plus(radius, -radius);
    for &(side, lost) in sides {
        let twice = sum.plus(side, lost).plus(side, lost);
        sum = twice.plus(side, side).plus(lost, lost);
    }
    let (negative, size) = sum.value();
    let unit = Scaled::of(scale);
    (
        negative,
        size.map_or(0.0, |size| size.over(unit).over(unit).value()),
    )
}

impl<T: Tier> PlanarMap<3> for VisibleSphere<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        // From outside k is at most 1, from inside 2, so that nothing cancels.
        let down = u1 * self.one_minus_cos();
        let mut local = [0.0; 3];
        around::<T>(T::sqrt(down * (2.0 - down)), 1.0 - down, u2, &mut local);
        *to = self.cone.frame().to_world(local);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        self.density()
    }
}

impl<T: Tier> Warp for VisibleSphere<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        self.cone.pdf(direction)
    }
}

impl<T: Tier> Invert for VisibleSphere<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        self.cone.invert(direction)
    }
}
