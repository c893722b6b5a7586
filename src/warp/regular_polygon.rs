//! The uniform distribution on a regular polygon.

use super::direction::{azimuth, nudged};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::Error;
use crate::num::{into_unit, remainder, two_product};
use crate::tier::Tier;
use core::f32::consts::TAU;
use core::marker::PhantomData;

/// Uniform on a regular polygon with its corners on the unit circle, the first at (1, 0).
///
/// The second uniform goes round the rim: ⌊n u₂⌋ counts the sides, and what is left of it, exactly, is the place along
/// that side. The first takes the point of the rim √u₁ of the way from the centre. The map is continuous, so that
/// strata stay together.
///
#[cfg_attr(doc, doc = include_str!("../pictures/regular_polygon.html"))]
///
/// The bladed aperture of a camera is one.
///
/// # Density
/// 1/(n/2 · sin(2π/n)) per unit area inside, up to the rounding of the coordinates (5e-7 of the radius); else 0.
///
/// # Domain
/// - Point: inside the polygon, up to the rounding of the coordinates.
/// - Uniforms: two, distance from the centre and place along the rim. Two zeros give the centre.
/// - Parameter: n from 3 to 65,535.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the radius 1. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 3.8e-7 | 3.8e-7 | proven |
/// | pdf, relative | 2.9e-7 | 2.8e-7 | found |
/// | realised density, relative | 2.9e-7 | 2.8e-7 | found |
/// | inverse | 6.2e-7 | 7.4e-7 | found |
/// | round trip | 1.1e-6 | 1.2e-6 | found |
///
/// The error of a sample is proven for all polygons and every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost RegularPolygon -->162 instructions and 736 bytes of code on an M4F, 7,561 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Error, Invert, Warp, poly as mw};
/// let aperture = mw::RegularPolygon::new(6)?;
/// let [x, y] = aperture.sample([0.25, 0.5]);
/// assert!((x + 0.5).abs() < 1e-6 && y.abs() < 1e-6); // half-way to the fourth corner
/// assert!(aperture.pdf([0.0, 0.86]) > 0.0 && aperture.pdf([0.0, 0.87]) == 0.0);
/// assert_eq!(mw::RegularPolygon::new(2), Err(Error::OutOfRange(0)));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Disk`](super::Disk): the limit of many corners.
/// - [`TriangleOn`](super::TriangleOn): any triangle.
/// - `fixed::RegularPolygon`, with feature `fixed`: on integers.
///
/// # Source
/// M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", third edition, 2016,
/// <https://pbr-book.org/3ed-2018/Monte_Carlo_Integration/2D_Sampling_with_Multidimensional_Transformations>, where
/// sampling regular polygons is an exercise.
#[doc(alias = "aperture")]
#[doc(alias = "bokeh")]
#[doc(alias = "hexagon")]
#[doc(alias = "pentagon")]
#[doc(alias = "n_gon")]
#[doc(alias = "uniform")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RegularPolygon<T> {
    corners: f32,
    /// The distance of a side from the centre, and half its length.
    apothem: f32,
    half_side: f32,
    density: f32,
    tier: PhantomData<T>,
}

/// How far beyond a side rounding can carry a sample.
const SLACK: f32 = 4.0 * f32::EPSILON;

/// An angle of so many parts of a turn, in turns, and by how many radians it was rounded.
#[inline]
fn quotient(parts: f32, of: f32) -> (f32, f32) {
    let turn = parts / of;
    (turn, remainder(parts, turn, of) / of * TAU)
}

/// Cosine and sine of such an angle.
fn unit_vector<T: Tier>(parts: f32, of: f32) -> [f32; 2] {
    let (turn, angle) = quotient(parts, of);
    let (sin, cos) = T::sincos_turns(turn);
    nudged(cos, sin, angle)
}

impl<T: Tier> RegularPolygon<T> {
    /// The polygon with so many corners.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for fewer than three.
    pub fn new(corners: u16) -> Result<Self, Error> {
        if corners < 3 {
            return Err(Error::OutOfRange(0));
        }
        let corners = f32::from(corners);
        let [apothem, half_side] = unit_vector::<T>(1.0, corners + corners);
        let [_, sine] = unit_vector::<T>(1.0, corners);
        Ok(Self {
            corners,
            apothem,
            half_side,
            density: 2.0 / (corners * sine),
            tier: PhantomData,
        })
    }

    /// The number of corners.
    #[must_use]
    pub const fn corners(&self) -> u16 {
        self.corners as u16
    }

    /// The angle in turns from +x to the middle of a side, and by how many radians it was rounded.
    #[inline]
    fn middle(&self, side: f32) -> (f32, f32) {
        quotient(side + side + 1.0, self.corners + self.corners)
    }

    /// The side behind which a point lies up to the rounding of its azimuth, how far out it lies in the direction of the
    /// side's middle, and how far along the side, of the distance out.
    #[inline]
    fn local(&self, x: f32, y: f32) -> (f32, f32, f32) {
        let place = azimuth::<T>(x, y) * self.corners;
        let side = (place as u32 as f32).min(self.corners - 1.0);
        let (turn, angle) = self.middle(side);
        let (sin, cos) = T::sincos_turns(turn);
        let (out, across) = (x * cos + y * sin, y * cos - x * sin);
        let [out, across] = nudged(out, across, -angle);
        // Beside a corner the azimuth may be rounded onto the next side. The right one is where a point is farther out.
        let (a, h) = (self.apothem, self.half_side);
        let beyond = out * ((a - h) * (a + h)) + across.abs() * (2.0 * a * h);
        let ratio = if out > 0.0 { across / out } else { 0.0 };
        (side, if beyond > out { beyond } else { out }, ratio)
    }
}

impl<T: Tier> PlanarMap<2> for RegularPolygon<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 2]) {
        // Exact: a product, and its rounding error.
        let (place, dropped) = two_product(u2, self.corners);
        let side = place as u32 as f32;
        let along = (place - side) + dropped;
        // Where the product was rounded up to a corner, or to the last one.
        let (side, along) = if along < 0.0 {
            (side - 1.0, along + 1.0)
        } else {
            (side, along)
        };
        let s = T::sqrt(u1);
        let (out, across) = (s * self.apothem, s * (self.half_side * (2.0 * along - 1.0)));
        let (turn, angle) = self.middle(side);
        let (sin, cos) = T::sincos_turns(turn);
        *to = nudged(out * cos - across * sin, out * sin + across * cos, angle);
    }

    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 2]) -> f32 {
        self.map_to(u1, u2, to);
        self.density
    }
}

impl<T: Tier> Warp for RegularPolygon<T> {
    planar!(2, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, [x, y]: [f32; 2]) -> f32 {
        let (_, out, _) = self.local(x, y);
        if out <= self.apothem + SLACK {
            self.density
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for RegularPolygon<T> {
    #[inline]
    fn invert(&self, [x, y]: [f32; 2]) -> [f32; 2] {
        let (side, out, ratio) = self.local(x, y);
        let s = out / self.apothem;
        let along = 0.5 + 0.5 * ratio * (self.apothem / self.half_side);
        [into_unit(s * s), into_unit((side + along) / self.corners)]
    }
}
