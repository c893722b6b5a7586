//! A warp onto the plane from a marginal and a conditional.

use super::product::joint;
use super::{Invert, Warp};
use crate::uniform::Canonical;
use rand_core::TryRng;

/// A density in the plane: x from its marginal, then y from the conditional of that x.
///
#[cfg_attr(doc, doc = include_str!("../pictures/marginal_conditional.html"))]
///
/// # Density
/// p(x) p(y | x). Where the marginal is 0, as in an empty row, the density is 0 and the conditional is not called.
/// No sample comes from there.
///
/// # Domain
/// - Point: (x, y).
/// - Uniforms: two, for the marginal and for the conditional. Drawing takes the words that drawing from the two
///   warps takes.
/// - Both tiers share this code.
///
/// # Accuracy
/// The errors are those of the two warps. These are for the example below: *sample* relative to the size 1,
/// densities relative, *inverse* and *round trip* absolute. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 9.5e-8 | found |
/// | pdf, relative | 7.8e-8 | found |
/// | realised density, relative | 7.8e-8 | found |
/// | pdf with the sample, relative | 7.8e-8 | found |
/// | inverse | 3.9e-8 | found |
/// | round trip | 7.8e-8 | found |
///
/// # Cost
/// That of the two warps, and of the function that makes the conditional.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw, warp::{Interval, MarginalConditional}};
/// // Uniform on the triangle 0 ≤ y ≤ x ≤ 1: p(x) = 2x, p(y | x) = 1/x.
/// let whole = Interval::new(0.0, 1.0)?;
/// let triangle = MarginalConditional::new(mw::Linear::new(0.0, 1.0)?, |x: f32| {
///     Interval::new(0.0, x).unwrap_or(whole)
/// });
/// assert_eq!(triangle.sample([0.25, 0.5]), [0.5, 0.25]);
/// assert_eq!(triangle.pdf([0.5, 0.25]), 2.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`PiecewiseConstant2d`](crate::discrete::PiecewiseConstant2d): a table of the density, such as an environment
///   map.
/// - [`Transform`](super::Transform): a map of the plane.
///
/// # Source
/// M. Rosenblatt, "Remarks on a Multivariate Transformation", 1952, <https://doi.org/10.1214/aoms/1177729394>.
#[doc(alias = "conditional")]
#[doc(alias = "joint")]
#[doc(alias = "rosenblatt")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MarginalConditional<M, F> {
    marginal: M,
    conditional: F,
}

impl<M, F, C> MarginalConditional<M, F>
where
    M: Warp<Uniforms = f32, Point = f32, Density = f32>,
    C: Warp<Uniforms = f32, Point = f32, Density = f32>,
    F: Fn(f32) -> C,
{
    /// The warp of the given marginal, and of the conditional that `conditional` returns for an x.
    #[must_use]
    pub const fn new(marginal: M, conditional: F) -> Self {
        Self {
            marginal,
            conditional,
        }
    }

    /// The marginal.
    #[must_use]
    pub const fn marginal(&self) -> &M {
        &self.marginal
    }

    /// The conditional of this x.
    #[must_use]
    pub fn conditional(&self, x: f32) -> C {
        (self.conditional)(x)
    }
}

impl<M, F, C> Warp for MarginalConditional<M, F>
where
    M: Warp<Uniforms = f32, Point = f32, Density = f32>,
    C: Warp<Uniforms = f32, Point = f32, Density = f32>,
    F: Fn(f32) -> C,
{
    type Uniforms = [f32; 2];
    type Point = [f32; 2];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 2] {
        let [u1, u2] = u.each();
        let x = self.marginal.sample_canonical(u1);
        [x, (self.conditional)(x).sample_canonical(u2)]
    }

    #[inline]
    fn pdf(&self, point: [f32; 2]) -> f32 {
        let [x, y] = point;
        let marginal = self.marginal.pdf(x);
        if marginal > 0.0 {
            joint(marginal, (self.conditional)(x).pdf(y))
        } else {
            0.0
        }
    }

    #[inline]
    fn sample_words(&self, words: [u32; 2]) -> [f32; 2] {
        let [first, second] = words;
        let x = self.marginal.sample_words(first);
        [x, (self.conditional)(x).sample_words(second)]
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[f32; 2], R::Error> {
        let x = self.marginal.try_draw(rng)?;
        Ok([x, (self.conditional)(x).try_draw(rng)?])
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 2], f32) {
        let [u1, u2] = u.each();
        let (x, marginal) = self.marginal.sample_canonical_with_pdf(u1);
        let (y, conditional) = (self.conditional)(x).sample_canonical_with_pdf(u2);
        ([x, y], joint(marginal, conditional))
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<([f32; 2], f32), R::Error> {
        let (x, marginal) = self.marginal.try_draw_with_pdf(rng)?;
        let (y, conditional) = (self.conditional)(x).try_draw_with_pdf(rng)?;
        Ok(([x, y], joint(marginal, conditional)))
    }
}

impl<M, F, C> Invert for MarginalConditional<M, F>
where
    M: Invert<Uniforms = f32, Point = f32, Density = f32>,
    C: Invert<Uniforms = f32, Point = f32, Density = f32>,
    F: Fn(f32) -> C,
{
    #[inline]
    fn invert(&self, point: [f32; 2]) -> [f32; 2] {
        let [x, y] = point;
        let u1 = self.marginal.invert(x);
        let u2 = if self.marginal.pdf(x) > 0.0 {
            (self.conditional)(x).invert(y)
        } else {
            0.0
        };
        [u1, u2]
    }
}
