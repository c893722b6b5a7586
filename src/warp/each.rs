//! Independent warps of one type side by side.

use super::{Invert, Warp};
use crate::num::{Scaled, representable};
use crate::uniform::{Canonical, Uniforms};
use rand_core::TryRng;

/// The product of densities, 0 where one of them is. No product on the way leaves the range.
#[inline]
fn product(densities: impl Iterator<Item = f32> + Clone) -> f32 {
    let (mut product, mut plain) = (1.0, true);
    for density in densities.clone() {
        product *= density;
        plain &= (f32::MIN_POSITIVE..=f32::MAX).contains(&product);
    }
    if plain {
        return product;
    }
    let mut product = Scaled::ONE;
    for density in densities {
        if density > 0.0 {
            product = product.times(Scaled::of(density));
        } else {
            return 0.0;
        }
    }
    representable(product.value())
}

/// Several independent warps of one type side by side: a point of each.
///
/// Two tents are the bilinear filter of a pixel; laws on the line side by side are a law in N dimensions. For warps of two types take
/// [`Product`](super::Product).
///
#[cfg_attr(doc, doc = include_str!("../pictures/each.html"))]
///
/// # Density
/// The product of the densities, with respect to the product of their measures; 0 where one of them is 0. Nothing on the way to the
/// product leaves the range: of 1e30, 1e30 and 1e-30 it is 1e30. Where the product itself does, it is the nearest positive `f32`.
///
/// # Domain
/// - Point: the points in an array.
/// - Uniforms: the uniforms of each, in an array. Drawing takes the words that drawing from each warp takes, in order.
/// - Both tiers share this code.
///
/// # Accuracy
/// The errors are those of the warps, and 6e-8 of the density for each. These are for two [`Tent`](super::Tent) of radius 1: *sample*
/// relative to the radius, densities relative, *inverse* and *round trip* absolute; s is
/// what the rounding of the point changes in the density. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 1.6e-7 | found |
/// | pdf, relative | 2.6e-7 | found |
/// | realised density, relative | 3.2e-7 + 2.4*s | found |
/// | pdf with the sample, relative | 2.6e-7 | found |
/// | inverse | 9e-8 | found |
/// | round trip | 9e-8 | found |
///
/// # Cost
/// That of the warps.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, warp::{Each, Tent}};
/// // A separable filter: a tent of radius 1 in x, and one of radius 2 in y.
/// let filter = Each::new([Tent::new(1.0)?, Tent::new(2.0)?]);
/// let offset = filter.sample([0.5, 0.125]);
/// assert_eq!(offset, [0.0, -1.0]);
/// assert_eq!(filter.pdf(offset), 0.25);
/// assert_eq!(filter.invert(offset), [0.5, 0.125]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Product`](super::Product): two warps of different types.
/// - [`Aabb`](super::Aabb): a box, uniform in each coordinate.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "independent")]
#[doc(alias = "separable")]
#[doc(alias = "product")]
#[doc(alias = "filter")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Each<W, const N: usize> {
    parts: [W; N],
}

/// What stands in where an array has no number left, which never happens: all have the same length.
#[inline]
fn none<U: Uniforms>() -> Canonical<U> {
    U::from_words(U::ZERO_WORDS)
}

impl<W: Warp<Density = f32>, const N: usize> Each<W, N> {
    /// A point of each warp.
    #[must_use]
    pub const fn new(parts: [W; N]) -> Self {
        Self { parts }
    }

    /// The warps.
    #[must_use]
    pub const fn parts(&self) -> &[W; N] {
        &self.parts
    }

    /// What each warp makes of its uniforms.
    #[inline]
    fn of_each<V>(
        &self,
        u: Canonical<[W::Uniforms; N]>,
        make: impl Fn(&W, Canonical<W::Uniforms>) -> V,
    ) -> [V; N] {
        let mut u = u.each().into_iter();
        self.parts
            .each_ref()
            .map(|part| make(part, u.next().unwrap_or_else(none)))
    }

    /// What each warp draws.
    #[inline]
    fn drawn<V, E>(
        &self,
        mut draw: impl FnMut(&W) -> Result<V, E>,
        spare: impl Fn(&W) -> V,
    ) -> Result<[V; N], E> {
        let mut failed = None;
        let drawn = self.parts.each_ref().map(|part| {
            if failed.is_none() {
                match draw(part) {
                    Ok(value) => return value,
                    Err(error) => failed = Some(error),
                }
            }
            spare(part)
        });
        failed.map_or(Ok(drawn), Err)
    }
}

/// Points apart from their densities, and the product of these.
#[inline]
fn apart<P: Copy, const N: usize>(both: [(P, f32); N]) -> ([P; N], f32) {
    let density = product(both.iter().map(|(_, density)| *density));
    (both.map(|(point, _)| point), density)
}

impl<W: Warp<Density = f32>, const N: usize> Warp for Each<W, N> {
    type Uniforms = [W::Uniforms; N];
    type Point = [W::Point; N];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[W::Uniforms; N]>) -> [W::Point; N] {
        self.of_each(u, W::sample_canonical)
    }

    #[inline]
    fn pdf(&self, x: [W::Point; N]) -> f32 {
        let points = self.parts.iter().zip(&x);
        product(points.map(|(part, &x)| part.pdf(x)))
    }

    #[inline]
    fn sample_words(&self, words: [<W::Uniforms as Uniforms>::Words; N]) -> [W::Point; N] {
        let mut words = words.into_iter();
        self.parts
            .each_ref()
            .map(|part| part.sample_words(words.next().unwrap_or(W::Uniforms::ZERO_WORDS)))
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[W::Point; N], R::Error> {
        self.drawn(
            |part| part.try_draw(rng),
            |part| part.sample_canonical(none()),
        )
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[W::Uniforms; N]>) -> ([W::Point; N], f32) {
        apart(self.of_each(u, W::sample_canonical_with_pdf))
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<([W::Point; N], f32), R::Error> {
        let both = self.drawn(
            |part| part.try_draw_with_pdf(rng),
            |part| part.sample_canonical_with_pdf(none()),
        );
        both.map(apart)
    }
}

impl<W: Invert<Density = f32>, const N: usize> Invert for Each<W, N> {
    #[inline]
    fn invert(&self, x: [W::Point; N]) -> [W::Uniforms; N] {
        let mut parts = self.parts.iter();
        x.map(|x| {
            let part = parts.next();
            part.map_or_else(|| none().get(), |part| part.invert(x))
        })
    }
}
