//! Products: two independent warps side by side.

use super::{Invert, Warp};
use crate::num::representable;
use crate::uniform::{Canonical, Uniforms};
use rand_core::TryRng;

/// The product of two densities; 0 where one of them is.
#[inline]
pub(super) fn joint(a: f32, b: f32) -> f32 {
    if a > 0.0 && b > 0.0 {
        representable(a * b)
    } else {
        0.0
    }
}

/// Two independent warps side by side: a point of each.
///
/// A disk and an interval make a cylinder's interior, two laws on the line a law in the plane. [`Transform`](super::Transform) makes
/// one vector of the pair, with 1 as its Jacobian. For several warps of one type take [`Each`](super::Each).
///
#[cfg_attr(doc, doc = include_str!("../pictures/product.html"))]
///
/// # Density
/// p₁(x) p₂(y), with respect to the product of both measures; 0 where one of them is 0. Where the product leaves the range of `f32` it
/// is the nearest positive number, also of a product inside another.
///
/// # Domain
/// - Point: the pair of the points.
/// - Uniforms: the pair of the uniforms. Drawing takes the words that drawing from the two warps takes, in order.
/// - Both tiers share this code.
///
/// # Accuracy
/// The errors are those of the two warps, and 6e-8 of the density. These are for the interior of a cylinder, a
/// [`Disk`](super::Disk) and an [`Interval`](super::Interval): *sample* relative to the radius 1, densities relative, *inverse* and
/// *round trip* absolute. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 2.8e-7 | 2.8e-7 | found |
/// | pdf, relative | 9e-8 | 9e-8 | found |
/// | realised density, relative | 9e-8 | 9e-8 | found |
/// | inverse | 1.9e-7 | 1.5e-7 | found |
/// | round trip | 2.5e-7 | 1.8e-7 | found |
///
/// # Cost
/// That of the two warps.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw, warp::{Interval, Product, Transform}};
/// // The interior of a cylinder.
/// let parts = Product::new(mw::Disk::new(), Interval::new(0.0, 2.0)?);
/// let inside = Transform::new(
///     parts,
///     |([x, y], z)| [x, y, z],
///     |[x, y, z]| ([x, y], z),
///     |_| 1.0,
/// );
/// let point = inside.sample(([0.25, 0.5], 0.75));
/// assert_eq!(point, [-0.5, 0.0, 1.5]);
/// assert!((inside.pdf(point) * 2.0 * core::f32::consts::PI - 1.0).abs() < 2e-7);
/// assert_eq!(inside.invert(point), ([0.25, 0.5], 0.75));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Each`](super::Each): several warps of one type.
/// - [`MarginalConditional`](super::MarginalConditional): where the second depends on the first point.
/// - [`metropolis::Product`](crate::metropolis::Product): of mutations of Markov chains.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "independent")]
#[doc(alias = "joint")]
#[doc(alias = "cylinder")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Product<A, B> {
    first: A,
    second: B,
}

impl<A, B> Product<A, B>
where
    A: Warp<Density = f32>,
    B: Warp<Density = f32>,
{
    /// Points of `first` beside points of `second`.
    #[must_use]
    pub const fn new(first: A, second: B) -> Self {
        Self { first, second }
    }

    /// The warp of the first points.
    #[must_use]
    pub const fn first(&self) -> &A {
        &self.first
    }

    /// The warp of the second points.
    #[must_use]
    pub const fn second(&self) -> &B {
        &self.second
    }
}

impl<A, B> Warp for Product<A, B>
where
    A: Warp<Density = f32>,
    B: Warp<Density = f32>,
{
    type Uniforms = (A::Uniforms, B::Uniforms);
    type Point = (A::Point, B::Point);
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Self::Uniforms>) -> Self::Point {
        let (u, v) = u.split();
        (
            self.first.sample_canonical(u),
            self.second.sample_canonical(v),
        )
    }

    #[inline]
    fn pdf(&self, (x, y): Self::Point) -> f32 {
        joint(self.first.pdf(x), self.second.pdf(y))
    }

    #[inline]
    fn sample_words(&self, (u, v): <Self::Uniforms as Uniforms>::Words) -> Self::Point {
        (self.first.sample_words(u), self.second.sample_words(v))
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Self::Point, R::Error> {
        Ok((self.first.try_draw(rng)?, self.second.try_draw(rng)?))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<Self::Uniforms>) -> (Self::Point, f32) {
        let (u, v) = u.split();
        let (x, a) = self.first.sample_canonical_with_pdf(u);
        let (y, b) = self.second.sample_canonical_with_pdf(v);
        ((x, y), joint(a, b))
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<(Self::Point, f32), R::Error> {
        let (x, a) = self.first.try_draw_with_pdf(rng)?;
        let (y, b) = self.second.try_draw_with_pdf(rng)?;
        Ok(((x, y), joint(a, b)))
    }
}

impl<A, B> Invert for Product<A, B>
where
    A: Invert<Density = f32>,
    B: Invert<Density = f32>,
{
    #[inline]
    fn invert(&self, (x, y): Self::Point) -> Self::Uniforms {
        (self.first.invert(x), self.second.invert(y))
    }
}
