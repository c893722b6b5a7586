//! Directions into which the microfacets of a rough surface reflect a view.

use super::direction::{is_direction, length};
use super::ggx::{GgxVisible, RIM_SLACK, Reflection};
use super::{Invert, Warp, drawn_with_pdf};
use crate::num::{above_zero, representable};
use crate::tier::Tier;
use crate::uniform::Canonical;

/// Directions into which GGX microfacets reflect a view: a warp of directions out of `GgxVisible`, a warp of normals.
///
/// It mixes with other lobes in a [`Mixture`](crate::discrete::Mixture), which normals do not: their density by solid angle is another.
/// For the normal beside the direction take [`GgxVisible::reflect`].
///
#[cfg_attr(doc, doc = include_str!("../pictures/reflected.html"))]
///
/// # Density
/// `D(m)/(2(w_z + ℓ))` per steradian, with the normal m half way between the view w and the direction, as
/// [`GgxVisible::reflected_pdf`] has it. [`sample_with_pdf`](Warp::sample_with_pdf) takes m from the sampler. `pdf` takes it from the
/// rounded direction, which at small roughness holds only a few of its digits, and at a grazing view may hold none: prefer the
/// former, or let [`GgxVisible::reflected_pdf`] have the normal. Divide by the density that belongs to the value, by the same m.
///
/// # Domain
/// - Point: unit vectors about the surface normal +z. Some of them lie below the surface, where z < 0; they have density too.
/// - Uniforms: two, those of [`GgxVisible`].
/// - Parameters: those of [`GgxVisible`]. Of [`GgxVisible::bounded`] fewer directions lie below the surface.
///
/// # Accuracy
/// These hold for the normals of [`GgxVisible::bounded`] with a roughness from 0.2 up, seen from up to 60° from +z. Elsewhere no
/// bounds are stated: at a roughness of 1e-4 a direction is off by up to 1e-3, as twice its normal. *Sample* is the distance from the exact direction,
/// *unit length* the error of the length. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors
/// of the uniforms; s and r are what one ulp of the direction changes in density and inverse. The azimuth is not held where
/// u₁ is below 2⁻⁴⁰, next to the pole of the cap. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 3.2e-6 | found |
/// | unit length | 2.2e-7 | found |
/// | pdf, relative | 1.8e-6 + 5.8*s | found |
/// | realised density, relative | 2.7e-6 + 7*s | found |
/// | pdf with the sample, relative | 4.8e-6 | found |
/// | inverse | 2.8e-6 + 16*r | found |
/// | round trip | 3e-6 + 29*r | found |
///
/// # Cost
/// That of the normal, and some twenty products.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let normals = mw::GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.3])?;
/// let gloss = mw::Reflected::new(normals);
/// let (direction, density) = gloss.sample_with_pdf([0.25, 0.5]);
/// assert_eq!(density, normals.reflect([0.25, 0.5]).pdf);
/// assert!((gloss.pdf(direction) / density - 1.0).abs() < 1e-5);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`GgxVisible`]: the normals.
/// - [`PhongLobe`](super::PhongLobe): a lobe about the direction of a mirror, once it is [`Oriented`](super::Oriented).
///
/// # Source
/// E. Heitz, "Sampling the GGX Distribution of Visible Normals", 2018, <https://jcgt.org/published/0007/04/01/>.
#[doc(alias = "microfacet")]
#[doc(alias = "brdf")]
#[doc(alias = "reflection")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Reflected<T> {
    normals: GgxVisible<T>,
}

impl<T: Tier> Reflected<T> {
    /// The directions into which microfacets of these normals reflect the view.
    #[must_use]
    pub const fn new(normals: GgxVisible<T>) -> Self {
        Self { normals }
    }

    /// The normals.
    #[must_use]
    pub const fn normals(&self) -> &GgxVisible<T> {
        &self.normals
    }

    /// A reflection brought to unit length, of which it lacks some rounding errors at most.
    #[inline]
    fn direction(bounce: &Reflection) -> [f32; 3] {
        let [x, y, z] = bounce.direction;
        let scale = 1.5 - 0.5 * (x * x + y * y + z * z);
        [x * scale, y * scale, z * scale]
    }

    /// The normal half way between the view and a direction, and the length of their sum. A height that rounding has taken is that of a
    /// normal at the horizon.
    #[inline]
    fn half_way(&self, direction: [f32; 3]) -> Option<([f32; 3], f32)> {
        let ([x, y, z], [wx, wy, wz]) = (direction, self.normals.view());
        let (x, y, z) = (x + wx, y + wy, z + wz);
        if !is_direction([x, y, z]) || z < -RIM_SLACK {
            return None;
        }
        let sum = [x, y, above_zero(z)];
        let length = length(sum);
        (length > 0.0 && length <= f32::MAX).then(|| (sum.map(|c| c / length), length))
    }
}

impl<T: Tier> Warp for Reflected<T> {
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        Self::direction(&self.normals.reflect(u.get()))
    }

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        match self.half_way(direction) {
            Some((normal, length)) if self.normals.reaches(direction, normal, length) => {
                representable(self.normals.share(0.5, normal))
            }
            _ => 0.0,
        }
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 3], f32) {
        let bounce = self.normals.reflect(u.get());
        (Self::direction(&bounce), bounce.pdf)
    }

    drawn_with_pdf!();
}

impl<T: Tier> Invert for Reflected<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        match self.half_way(direction) {
            Some((normal, _)) => self.normals.invert(normal),
            None => [0.0; 2],
        }
    }
}
