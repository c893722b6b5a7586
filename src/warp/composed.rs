//! Composition: the points of one warp as the uniforms of another.

use super::{Invert, Warp};
use crate::num::{into_unit, representable};
use crate::uniform::{Canonical, Uniforms};
use rand_core::TryRng;

/// Two warps composed: the points of `first`, a warp of the unit square, are the uniforms of `then`.
///
/// `first` weighs the samples of `then`, which keeps its domain. A [`Bilinear`](super::Bilinear) with the cosines at the
/// corners of a polygon makes samples of the polygon nearly cosine-weighted; a table that has learned where the light
/// comes from guides any warp.
///
#[cfg_attr(doc, doc = include_str!("../pictures/composed.html"))]
///
/// Cosine-weighted sampling of a polygon light by this is *approximate in shape*: the density follows the interpolated
/// cosine, not the cosine itself. It is *exact in density*: what is reported is the density of the samples, and an
/// estimate that divides by it has no bias. Weights of 0 leave out what has weight 0.
///
/// # Density
/// p₁(u) p₂(x), where u are the uniforms of x in `then`, p₁ the density of `first` and p₂ that of `then`. `sample_with_pdf`
/// multiplies the densities that both warps hand over, and inverts nothing.
///
/// `pdf` finds u by the inverse, which is rounded. Where `first` jumps, as a table does between cells, that may be the
/// other side of the jump. So prefer `sample_with_pdf` for a sample of its own. Where p₁ is 0 and p₂ is not, the largest p₁
/// at a distance of 2⁻²⁰ counts, and if that is 0, too, the density is 2⁻¹⁴⁹: it is 0 outside the domain of `then` alone.
///
/// # Domain
/// - Point: that of `then`.
/// - Uniforms: two, those of `first`. Drawing takes the words that drawing from `first` takes.
/// - Parameters: `first` is any warp of two uniforms onto [0, 1]², such as [`Bilinear`](super::Bilinear) or a
///   [`PiecewiseConstant2d`](crate::discrete::PiecewiseConstant2d), and `then` any warp of two uniforms with an inverse. A
///   point of `first` outside [0, 1)² is brought into it.
/// - Both tiers share this code.
///
/// # Accuracy
/// The errors are those of the two warps. These are for a [`Bilinear`](super::Bilinear) of any weights before
/// [`Triangle`](super::Triangle): *sample* relative to the size 1, densities relative, *inverse* and *round trip* absolute.
/// [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 7.9e-7 | found |
/// | pdf, relative | 5e-7 + 3.1*s | found |
/// | realised density, relative | 5e-7 + 7.3*s | found |
/// | pdf with the sample, relative | 8.6e-7 | found |
/// | inverse | 3.9e-7 + 3.4*r | found |
/// | round trip | 4.4e-7 + 5.8*r | found |
///
/// # Cost
/// That of the two warps.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// // Barycentric coordinates, nearly in proportion to weights of 1, 0.2 and 0.5 at the vertices. All points with an x of
/// // 0 are the first vertex.
/// let weights = mw::Bilinear::new([[1.0, 0.5], [1.0, 0.2]])?;
/// let lamp = mw::Composed::new(weights, mw::Triangle::new());
/// let (point, density) = lamp.sample_with_pdf([0.25, 0.5]);
/// assert!((lamp.pdf(point) / density - 1.0).abs() < 1e-5);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Transform`](super::Transform): a map after a warp, with its Jacobian.
/// - [`MarginalConditional`](super::MarginalConditional): a density from two on the line.
/// - [`Oriented`](super::Oriented): a warp over directions, turned.
///
/// # Source
/// D. Hart and others, "Practical Product Sampling by Fitting and
/// Composing Warps", 2020, <https://doi.org/10.1111/cgf.14060>.
#[doc(alias = "weighted")]
#[doc(alias = "product")]
#[doc(alias = "guiding")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Composed<B, W> {
    first: B,
    then: W,
}

/// How far a dark point looks for light, in each of two uniforms.
const BESIDE: f32 = f32::EPSILON * 8.0;

impl<B, W> Composed<B, W>
where
    B: Warp<Uniforms = [f32; 2], Point = [f32; 2], Density = f32>,
    W: Invert<Uniforms = [f32; 2], Density = f32>,
{
    /// The points of `first`, a warp of the unit square, as the uniforms of `then`.
    #[must_use]
    pub const fn new(first: B, then: W) -> Self {
        Self { first, then }
    }

    /// The warp of the unit square.
    #[must_use]
    pub const fn first(&self) -> &B {
        &self.first
    }

    /// The warp whose samples it weighs.
    #[must_use]
    pub const fn then(&self) -> &W {
        &self.then
    }

    /// The density of `first` at a point, or beside it where it is 0 there.
    #[inline]
    fn weight(&self, point: [f32; 2]) -> f32 {
        let weight = self.first.pdf(point);
        if weight > 0.0 {
            return weight;
        }
        let [x, y] = point.map(|c| [into_unit(c - BESIDE), into_unit(c + BESIDE)]);
        let beside = x.into_iter().flat_map(|x| y.map(|y| [x, y]));
        beside.map(|at| self.first.pdf(at)).fold(0.0, f32::max)
    }

    /// The point of a place in the unit square, and the density with which both come about.
    #[inline]
    fn composed(&self, (place, weight): ([f32; 2], f32)) -> (W::Point, f32) {
        let (point, density) = self.then.sample_canonical_with_pdf(place.canonical());
        (point, representable(weight * density))
    }
}

impl<B, W> Warp for Composed<B, W>
where
    B: Warp<Uniforms = [f32; 2], Point = [f32; 2], Density = f32>,
    W: Invert<Uniforms = [f32; 2], Density = f32>,
{
    type Uniforms = [f32; 2];
    type Point = W::Point;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> W::Point {
        let place = self.first.sample_canonical(u);
        self.then.sample_canonical(place.canonical())
    }

    #[inline]
    fn pdf(&self, x: W::Point) -> f32 {
        let density = self.then.pdf(x);
        if density > 0.0 {
            representable(self.weight(self.then.invert(x)) * density)
        } else {
            0.0
        }
    }

    #[inline]
    fn sample_words(&self, words: [u32; 2]) -> W::Point {
        let place = self.first.sample_words(words);
        self.then.sample_canonical(place.canonical())
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<W::Point, R::Error> {
        let place = self.first.try_draw(rng)?;
        Ok(self.then.sample_canonical(place.canonical()))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> (W::Point, f32) {
        self.composed(self.first.sample_canonical_with_pdf(u))
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(W::Point, f32), R::Error> {
        let drawn = self.first.try_draw_with_pdf(rng)?;
        Ok(self.composed(drawn))
    }
}

impl<B, W> Invert for Composed<B, W>
where
    B: Invert<Uniforms = [f32; 2], Point = [f32; 2], Density = f32>,
    W: Invert<Uniforms = [f32; 2], Density = f32>,
{
    #[inline]
    fn invert(&self, x: W::Point) -> [f32; 2] {
        self.first.invert(self.then.invert(x))
    }
}
