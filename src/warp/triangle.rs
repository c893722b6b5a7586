//! The uniform distribution on a triangle in barycentric coordinates.

use super::{Invert, Warp};
use crate::num::{clamp, into_unit};
use crate::tier::sqrt;
use crate::uniform::Canonical;

/// Uniform barycentric coordinates: the shares of the three vertices of a triangle.
///
/// u = 1 − √U₁, v = √U₁ U₂, w = √U₁ (1 − U₂), with u in the form (1 − U₁)/(1 + √U₁), which keeps its digits near 0.
///
#[cfg_attr(doc, doc = include_str!("../pictures/triangle.html"))]
///
/// # Density
/// 2 with respect to (u, v), where none of the three is negative and their sum is 1 to rounding; else 0.
///
/// # Domain
/// - Point: [u, v, w], none negative, with sum 1 to rounding.
/// - Uniforms: two.
/// - Both tiers share this code. It needs nothing but a square root.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size 1. *Pdf* and *realised density* are
/// relative, *inverse* and *round trip* are absolute errors of the uniforms. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 1.2e-7 | proven |
/// | pdf, relative | 0 | exhaustive |
/// | realised density, relative | 0 | exhaustive |
/// | inverse | 2.45e-7 | found |
/// | round trip | 8.1e-8 | found |
///
/// The error of the sample is proven for every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Triangle -->50 instructions and 216 bytes of code on an M4F, 1,677 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, warp::Triangle};
/// assert_eq!(Triangle::new().sample([0.25, 0.5]), [0.5, 0.25, 0.25]);
/// assert_eq!(Triangle::new().invert([0.5, 0.25, 0.25]), [0.25, 0.5]);
/// ```
///
/// # See also
/// - [`TriangleOn`](super::TriangleOn): the points of a triangle given by its vertices, and their density per unit
///   area.
///
/// # Source
/// G. Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
#[doc(alias = "barycentric")]
#[doc(alias = "simplex")]
#[doc(alias = "dirichlet")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Triangle(());

impl Triangle {
    /// The triangle of all barycentric coordinates.
    #[must_use]
    pub const fn new() -> Self {
        Self(())
    }
}

impl Warp for Triangle {
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        let [u1, u2] = u.get();
        let s = sqrt(u1);
        [(1.0 - u1) / (1.0 + s), s * u2, s * (1.0 - u2)]
    }

    #[inline]
    fn pdf(&self, point: [f32; 3]) -> f32 {
        let [u, v, w] = point;
        let whole = (u + v + w - 1.0).abs() <= 4.0 * f32::EPSILON;
        if u >= 0.0 && v >= 0.0 && w >= 0.0 && whole {
            2.0
        } else {
            0.0
        }
    }

    super::filled_in_blocks!();
}

impl Invert for Triangle {
    #[inline]
    fn invert(&self, point: [f32; 3]) -> [f32; 2] {
        let [u, v, w] = point.map(|c| clamp(c, 0.0, 1.0));
        let s = v + w;
        // The smaller of √U₁ and 1 − √U₁ holds the digits.
        let u1 = if s < 0.5 { s * s } else { 1.0 - u * (2.0 - u) };
        [into_unit(u1), into_unit(if s > 0.0 { v / s } else { 0.0 })]
    }
}
