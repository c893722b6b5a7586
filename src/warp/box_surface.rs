//! The uniform distribution on the six faces of an axis-aligned box.

use super::surface_point::{NEAR, SurfacePoint, area, parts, scaled};
use super::{Invert, Warp};
use crate::error::Error;
use crate::num::{Scaled, Segment, clamp, extent, into_unit};
use crate::uniform::{Canonical, LARGEST};

/// Uniform on the surface of an axis-aligned box, by area.
///
/// The first uniform selects a pair of opposite faces and what is left of it is a coordinate; the second one selects a face of
/// the pair by its first bit, and the others are the other coordinate. A box that is flat in one axis has two faces.
///
#[cfg_attr(doc, doc = include_str!("../pictures/box_surface.html"))]
///
/// # Density
/// 1/area per unit area on the surface, and 0 farther from it than 2⁻²⁰ of the size.
///
/// # Domain
/// - Point: a [`SurfacePoint`], exactly on its face, with a normal along an axis. Density and inverse take the face from the
///   normal, which decides at edges and on a flat box.
/// - Uniforms: two. On a face across x, a uniform runs along y and the other one along z; across y, along z and x; across z,
///   along x and y. The pair of the smallest faces comes first, and below ½ the second uniform selects the lower face.
/// - Parameters: finite corners with aᵢ ≤ bᵢ, of which one side at most has no length, and an area whose density `f32` can
///   hold. A face without area is never selected.
/// - Both tiers share this code.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size, which is the largest bound. *Pdf* and *realised
/// density* are relative to the density with which points of the face are drawn, whose share of the uniforms is rounded
/// to `f32`. *Inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 6e-7 | found |
/// | pdf, relative | 8.7e-7 | found |
/// | realised density, relative | 8.7e-7 | found |
/// | inverse | 3.4e-7 | found |
/// | round trip | 2.5e-7 + 1.5*r | found |
///
/// r is the change of the inverse when the point moves by 2⁻²⁴ of the size.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost BoxSurface -->116 instructions and 584 bytes of code on an M4F, 2,301 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, warp::BoxSurface};
/// let crate_ = BoxSurface::new([0.0, -1.0, 0.0], [4.0, 1.0, 2.0])?;
/// let point = crate_.sample([0.35, 0.75]);
/// assert_eq!(point.normal, [0.0, 1.0, 0.0]);
/// assert_eq!(point.position[1], 1.0);
/// assert!((crate_.pdf(point) * 40.0 - 1.0).abs() < 1e-6);
/// let [u, v] = crate_.invert(point);
/// assert!((u - 0.35).abs() < 1e-6 && (v - 0.75).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Aabb`](super::Aabb): the inside of the box.
/// - [`SphericalRectangle`](super::SphericalRectangle): one face, seen from a point.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>, section II.4 on
/// compositions.
#[doc(alias = "cube")]
#[doc(alias = "cuboid")]
#[doc(alias = "area_light")]
#[doc(alias = "emitter")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoxSurface {
    sides: [Side; 3],
    /// The axes across which the faces lie, from the smallest to the largest.
    order: [Axis; 3],
    /// Below which first uniforms the first and the second of them are selected.
    below: [f32; 2],
    density: f32,
    /// How far from the surface its rounded points can lie.
    near: f32,
}

/// A side of the box.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Side {
    segment: Segment,
    low: f32,
    high: f32,
}

#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// What belongs to this axis, to the next one and to the one after that.
    #[inline]
    fn first<V>(self, [x, y, z]: [V; 3]) -> [V; 3] {
        match self {
            Self::X => [x, y, z],
            Self::Y => [y, z, x],
            Self::Z => [z, x, y],
        }
    }

    /// What belongs to x, y and z, of what belongs to this axis and the two that follow.
    #[inline]
    fn back<V>(self, values: [V; 3]) -> [V; 3] {
        // The same turn again: three of them are none.
        self.first(self.first(values))
    }
}

impl Side {
    /// The part of the side below a coordinate; 0 of a side without length.
    #[inline]
    fn part(&self, x: f32) -> f32 {
        let whole = (self.high - self.low).is_finite();
        let s = if whole { 1.0 } else { 0.5 };
        into_unit((x * s - self.low * s) / (self.high * s - self.low * s))
    }
}

impl BoxSurface {
    /// The surface of the box between two opposite corners, `low` and `high`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Reversed`] where a coordinate of `low` is above that of `high`.
    /// [`Error::Empty`] for a box without area, or so small that the density overflows, [`Error::TooLarge`] for one whose
    /// density is below the smallest normal number.
    pub fn new(low: [f32; 3], high: [f32; 3]) -> Result<Self, Error> {
        let ([a, b, c], [d, e, f]) = (low, high);
        let [x, y, z] = [[a, d], [b, e], [c, f]].map(|side| extent(side, [0, 1]));
        let [x, y, z] =
            [x?, y?, z?].map(|(scale, length)| Some(scaled(length)?.over(Scaled::of(scale))));
        // Of both faces of each pair.
        let ([p, q, r], sum, density) = parts([area(y, z), area(z, x), area(x, y)], 2.0)?;
        let (mut first, mut second, mut third) = ((p, Axis::X), (q, Axis::Y), (r, Axis::Z));
        if second.0 > third.0 {
            (second, third) = (third, second);
        }
        if first.0 > second.0 {
            (first, second) = (second, first);
        }
        if second.0 > third.0 {
            (second, third) = (third, second);
        }
        // A share below the range of `f32` is none: no uniform would be in it but 0.
        let share = |areas: f32| match areas / sum {
            share if share >= f32::MIN_POSITIVE => share,
            _ => 0.0,
        };
        let below = match share(first.0) {
            0.0 => [0.0, share(second.0)],
            below => [below, share(first.0 + second.0)],
        };
        let largest = low
            .iter()
            .chain(&high)
            .fold(0.0, |most: f32, x| clamp(x.abs(), most, f32::MAX));
        let side = |low, high| Side {
            segment: Segment::new(low, high),
            low,
            high,
        };
        Ok(Self {
            sides: [side(a, d), side(b, e), side(c, f)],
            order: [first.1, second.1, third.1],
            below,
            density,
            near: NEAR * largest,
        })
    }

    /// The lower corner.
    #[must_use]
    pub fn low(&self) -> [f32; 3] {
        self.sides.map(|side| side.low)
    }

    /// The upper corner.
    #[must_use]
    pub fn high(&self) -> [f32; 3] {
        self.sides.map(|side| side.high)
    }

    /// The area of all faces.
    #[must_use]
    pub fn area(&self) -> f32 {
        1.0 / self.density
    }
}

/// The axis along which a normal points, and whether upwards; [`None`] where the coordinate taken for
/// the largest is 1/2 at most, or not a number.
#[inline]
fn axis_of([x, y, z]: [f32; 3]) -> Option<(Axis, bool)> {
    let (axis, most) = if x.abs() > y.abs() {
        (Axis::X, x)
    } else {
        (Axis::Y, y)
    };
    let (axis, most) = if z.abs() > most.abs() {
        (Axis::Z, z)
    } else {
        (axis, most)
    };
    (most.abs() > 0.5).then_some((axis, most > 0.0))
}

impl Warp for BoxSurface {
    type Uniforms = [f32; 2];
    type Point = SurfacePoint;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> SurfacePoint {
        let ([u1, u2], [p, q]) = (u.get(), self.below);
        let [a, b, c] = self.order;
        let (axis, start, end) = if u1 < p {
            (a, 0.0, p)
        } else if u1 < q {
            (b, p, q)
        } else {
            (c, q, 1.0)
        };
        let s = (u1 - start) / (end - start);
        let s = if s < 1.0 { s } else { LARGEST };
        let upper = u2 >= 0.5;
        let t = 2.0 * u2 - f32::from(u8::from(upper));
        let [own, next, last] = axis.first(self.sides);
        let (plane, outwards) = if upper {
            (own.high, 1.0)
        } else {
            (own.low, -1.0)
        };
        SurfacePoint {
            position: axis.back([plane, next.segment.at(s), last.segment.at(t)]),
            normal: axis.back([outwards, 0.0, 0.0]),
        }
    }

    #[inline]
    fn pdf(&self, point: SurfacePoint) -> f32 {
        let Some((axis, upper)) = axis_of(point.normal) else {
            return 0.0;
        };
        let [own, next, last] = axis.first(self.sides);
        let [x, y, z] = axis.first(point.position);
        let plane = if upper { own.high } else { own.low };
        let within = |side: Side, x: f32| x >= side.low - self.near && x <= side.high + self.near;
        if (x - plane).abs() <= self.near && within(next, y) && within(last, z) {
            self.density
        } else {
            0.0
        }
    }
}

impl Invert for BoxSurface {
    #[inline]
    fn invert(&self, point: SurfacePoint) -> [f32; 2] {
        let (axis, upper) = axis_of(point.normal).unwrap_or((Axis::Z, true));
        let [_, next, last] = axis.first(self.sides);
        let [_, y, z] = axis.first(point.position);
        let ([a, b, _], [p, q]) = (self.order, self.below);
        let (start, end) = if axis == a {
            (0.0, p)
        } else if axis == b {
            (p, q)
        } else {
            (q, 1.0)
        };
        let first = start + (end - start) * next.part(y);
        let second = 0.5 * last.part(z) + if upper { 0.5 } else { 0.0 };
        [into_unit(first), into_unit(second)]
    }
}
