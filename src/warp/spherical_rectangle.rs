//! The uniform distribution over the directions of a rectangle, seen from a point.

use super::seen::{self, Seen};
use super::{Invert, Warp, drawn_with_pdf};
use crate::error::Error;
use crate::num::{into_unit, representable};
use crate::tier::Tier;
use crate::uniform::{Canonical, Uniforms};
use core::f32::consts::PI;
use core::marker::PhantomData;

/// Uniform over the directions from a point to a rectangle, or any parallelogram: an area light, sampled by its solid
/// angle.
///
#[cfg_attr(doc, doc = include_str!("../pictures/spherical_rectangle.html"))]
///
/// Two spherical triangles about the corner, on both sides of the diagonal, each with the map of
/// [`SphericalTriangle`](super::SphericalTriangle): u₂ sweeps the solid angle from the first edge to the second, and the
/// map has no seam at the diagonal.
///
/// # Density
/// 1/Ω per steradian inside and 0 outside, farther than the rounding of samples, 4e-7·q rad. What
/// [`SphericalTriangle`](super::SphericalTriangle#density) says of small triangles and of `pdf(w) > 0` holds here, too.
///
/// Where q is above 64 before the inside, the point is so close to the rectangle that area is sampled instead, unless a
/// corner is 64 times as near as another. [`samples_area`](SphericalRectangle::samples_area) says so.
/// Densities and the inverse are then those of area, distance²/(cos θ · area) per steradian.
///
/// # Domain
/// - Point: unit vectors in world space. The rectangle is seen from both sides.
/// - Uniforms: two. The corner is at u₁ = 0; from the first edge to the second, u₂ grows. Where area is sampled they
///   are the coordinates along the edges.
/// - Parameters: those of [`SphericalTriangle`](super::SphericalTriangle#domain) for both halves; g is the smaller
///   determinant and q the larger nearness of the two. The edges are taken as they are given, so that a small one
///   keeps its digits far from 0.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length, *place on it* that of the
/// coordinates along the edges. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors
/// of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, of the size | 4.4e-7*q + 2e-14/g | 4.4e-7*q + 2e-14/g |
/// | unit length | 1.9e-7 | 1.9e-7 |
/// | place on it | 4.5e-7 + 3*p + 8e-14/g | 4.5e-7 + 3*p + 8e-14/g |
/// | pdf, relative | 1.4e-6 + 6e-15/g + 4.2e-7·a + 4·s | 1.4e-6 + 6e-15/g + 4.2e-7·a + 4·s |
/// | realised density, relative | 1.4e-6 + 6e-15/g + 4.2e-7·a + (2 + a)·s | 1.4e-6 + 6e-15/g + 4.2e-7·a + (2 + a)·s |
/// | pdf with the sample, relative | 1.4e-6 + 6e-15/g + 4.2e-7*a | 1.4e-6 + 6e-15/g + 4.2e-7*a |
/// | inverse | min(1, 5e-7 + 5e-7·q + (6 + 0.22·q)·r + 3e-8/h) | min(1, 5e-7 + 5e-7·q + (6 + 0.22·q)·r + 3e-8/h) |
/// | round trip | min(1, 5e-7 + 5e-7·q + (6 + 0.22·q)·r + 3e-8/h) | min(1, 5e-7 + 5e-7·q + (6 + 0.22·q)·r + 3e-8/h) |
///
/// These hold for every rectangle accepted. a is q where area is sampled and 0 elsewhere; s and r are the relative change
/// of the density and the change of the uniforms when each coordinate of the direction moves by 2⁻²⁴, and p is the change
/// of the place when the second uniform does. h is the sine of the smallest height of both halves: the second uniform of
/// a direction within rounding of the corner, where √u₁ h is below 2⁻²⁰, is lost.
///
/// # Cost
/// <!-- generated: cost SphericalRectangle -->
/// Instructions of a draw, PCG32 included, and bytes of flash:
/// - `poly`: 249 on a Cortex-M4F (1,736 bytes), 13,669 on a Cortex-M0, 496 as WASM.
/// - `libm`: 4,462 on a Cortex-M4F (8,016 bytes), 22,278 on a Cortex-M0, 619 as WASM.
/// <!-- end -->
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let spot = [0.0, 0.0, 0.0];
/// let panel = mw::SphericalRectangle::new(spot, [-1.0, -0.5, 3.0], [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0]])?;
/// let there = panel.locate([0.3, 0.8]);
/// assert!((there.pdf * panel.solid_angle() - 1.0).abs() < 1e-6);
/// let [s, t] = there.st;
/// assert!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0);
/// assert_eq!(there.direction, panel.sample([0.3, 0.8]));
/// assert_eq!(panel.pdf([0.0, 0.0, -1.0]), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// In a renderer, no refusal is worth ending a picture: edge-on, or next to the lamp, `new` returns an error. Take `.ok()`.
/// A lamp that is refused gives no light by this technique; what else hits it counts with density 0, so with weight 1.
///
/// # See also
/// - [`SphericalTriangle`](super::SphericalTriangle): three corners, and a fan of them for any polygon.
/// - [`Aabb`](super::Aabb): uniform on the rectangle itself, whatever sees it.
/// - [`SphericalPatch`](super::SphericalPatch): between two latitudes and two longitudes.
///
/// # Source
/// C. Ureña, M. Fajardo and A. King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013,
/// <https://doi.org/10.1111/cgf.12151>, for the problem; the map is that of
/// [`SphericalTriangle`](super::SphericalTriangle#source).
#[doc(alias = "solid_angle")]
#[doc(alias = "area_light")]
#[doc(alias = "quad")]
#[doc(alias = "parallelogram")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphericalRectangle<T> {
    /// The triangle of the first edge and the diagonal, and that of the diagonal and the second edge.
    halves: [Seen; 2],
    /// The parts of the solid angle that they have.
    shares: [f32; 2],
    density: f32,
    tier: PhantomData<T>,
}

/// A place on a rectangle: its direction, its coordinates along the edges, and the density of the direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnRectangle {
    /// The direction from the point, a unit vector.
    pub direction: [f32; 3],
    /// The coordinates [s, t] of the place corner + s ex + t ey, from 0 to 1.
    pub st: [f32; 2],
    /// The density of the direction, per steradian.
    pub pdf: f32,
}

impl<T: Tier> SphericalRectangle<T> {
    /// The directions from `point` to the rectangle of `corner` and two edges, from either side. The edges need not be
    /// at right angles.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::TooLarge`] for a coordinate beyond 2⁶⁰, [`Error::ZeroLength`]
    /// for an edge of length 0, [`Error::Empty`] for a rectangle that is too small, too thin or seen too much from its
    /// edge, [`Error::NotNormalizable`] for a point on the rectangle. The section on the domain says where these begin.
    pub fn new(point: [f32; 3], corner: [f32; 3], edges: [[f32; 3]; 2]) -> Result<Self, Error> {
        seen::checked(&[point, corner])?;
        seen::checked(&edges)?;
        if edges.contains(&[0.0; 3]) {
            return Err(Error::ZeroLength);
        }
        let [ex, ey] = edges.map(|edge| edge.map(|x| (x, 0.0)));
        let apex = seen::difference(corner, point);
        let diagonal = seen::sum(ex, ey);
        let [along_x, along_y, far] = [ex, ey, diagonal].map(|edge| seen::sum(apex, edge));
        let back = seen::negative;
        let first = Seen::new::<T>([apex, along_x, far], [ey, back(diagonal), ex]);
        let second = Seen::new::<T>([apex, far, along_y], [back(ex), back(ey), diagonal]);
        let [first, second] = match (first, second) {
            (Ok(first), Ok(second)) => [first, second],
            // One half may see from its edge the point on which the other one lies.
            (Err(Error::NotNormalizable), _) | (_, Err(Error::NotNormalizable)) => {
                return Err(Error::NotNormalizable);
            }
            (Err(e), _) | (_, Err(e)) => return Err(e),
        };
        let half = first.half() + second.half();
        Ok(Self {
            halves: [first, second],
            shares: [first.half() / half, second.half() / half],
            density: 1.0 / (4.0 * PI * half),
            tier: PhantomData,
        })
    }

    /// The solid angle of the rectangle, in steradians.
    #[must_use]
    pub const fn solid_angle(&self) -> f32 {
        let [first, second] = &self.halves;
        4.0 * PI * (first.half() + second.half())
    }

    /// Whether the point is so close to the rectangle, or to its diagonal, that its area is sampled, with the density
    /// of that.
    #[must_use]
    pub const fn samples_area(&self) -> bool {
        let [first, second] = &self.halves;
        (first.close() || second.close()) && first.even() && second.even()
    }

    /// The weights that a bilinear density on the unit square takes in order to follow the cosine to `normal`, of any
    /// length: `weights[row][column]`, where u₂ is 0 and 1 in the rows and u₁ is 0 and 1 in the columns.
    ///
    /// They are the cosines of corner, corner + ex, corner and corner + ey, 0 below the horizon. Where only the fourth
    /// corner is above it, its cosine stands for both corners of the second column, between which it lies.
    ///
    /// # Errors
    /// [`Error::AllZero`] for a rectangle below the horizon, [`Error::NotFinite`] and [`Error::ZeroLength`] for a normal
    /// that is none.
    pub fn cosine_weights(&self, normal: [f32; 3]) -> Result<[[f32; 2]; 2], Error> {
        let [first, second] = &self.halves;
        let [corner, x, far] = seen::cosines(first.corners(), normal)?;
        let [_, _, y] = seen::cosines(second.corners(), normal)?;
        if corner > 0.0 || x > 0.0 || y > 0.0 {
            Ok([[corner, x], [corner, y]])
        } else if far > 0.0 {
            Ok([[0.0, far], [0.0, far]])
        } else {
            Err(Error::AllZero)
        }
    }

    /// The direction, the place on the rectangle and the density of two uniforms. They are brought into range as
    /// [`Warp::sample`] does.
    #[must_use]
    pub fn locate(&self, u: [f32; 2]) -> OnRectangle {
        let [u1, u2] = u.canonical().get();
        let ([first, second], [share, other]) = (&self.halves, self.shares);
        if self.samples_area() {
            // Barycentric coordinates of the half in which the place lies.
            let (direction, spread) = if u1 > u2 {
                first.towards([1.0 - u1, u1 - u2, u2])
            } else {
                second.towards([1.0 - u2, u1, u2 - u1])
            };
            return OnRectangle {
                direction,
                st: [u1, u2],
                pdf: representable(spread),
            };
        }
        let (half, weights, in_first) = if u2 < share {
            let turn = u2 / share;
            (first, first.weights::<T>(u1, turn, 1.0 - turn), true)
        } else {
            let rest = (1.0 - u2) / other;
            let rest = if rest < 1.0 { rest } else { 1.0 };
            (second, second.weights::<T>(u1, 1.0 - rest, rest), false)
        };
        let [_, p, q] = half.barycentric(weights);
        OnRectangle {
            direction: half.direction(weights),
            st: if in_first { [p + q, q] } else { [p, p + q] },
            pdf: self.density,
        }
    }

    /// The half in which a direction lies, and whether that is the first.
    #[inline]
    fn half(&self, direction: [f32; 3]) -> (&Seen, bool) {
        let [first, second] = &self.halves;
        if first.over_side_1(direction) > 0.0 {
            (first, true)
        } else {
            (second, false)
        }
    }
}

impl<T: Tier> Warp for SphericalRectangle<T> {
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        self.locate(u.get()).direction
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 3], f32) {
        let there = self.locate(u.get());
        (there.direction, there.pdf)
    }

    drawn_with_pdf!();

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let [first, second] = &self.halves;
        if !(first.holds(direction) || second.holds(direction)) {
            0.0
        } else if self.samples_area() {
            let (half, _) = self.half(direction);
            let (_, spread) = half.place(direction);
            representable(spread)
        } else {
            self.density
        }
    }
}

impl<T: Tier> Invert for SphericalRectangle<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let (half, in_first) = self.half(direction);
        if self.samples_area() {
            let ([_, p, q], _) = half.place(direction);
            let st = if in_first { [p + q, q] } else { [p, p + q] };
            return st.map(into_unit);
        }
        let [out, turn] = half.uniforms::<T>(direction).map(into_unit);
        let [share, other] = self.shares;
        let turn = if in_first {
            turn * share
        } else {
            1.0 - (1.0 - turn) * other
        };
        [out, into_unit(turn)]
    }
}
