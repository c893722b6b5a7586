//! Change of variables: a warp followed by a map, with its Jacobian.

use super::{Invert, Warp};
use crate::num::representable;
use crate::uniform::{Canonical, Uniforms};
use rand_core::TryRng;

/// A change of variables: a warp followed by a one-to-one map y = f(x), with the density p(x)/|J(x)|.
///
#[cfg_attr(doc, doc = include_str!("../pictures/transform.html"))]
///
/// # Density
/// That of the warp inside at x = f⁻¹(y), over |J(x)|, the factor by which the map stretches length, area or solid
/// angle at x. 0 where the density inside is 0; the largest `f32` where it overflows.
///
/// # Domain
/// - Point: what the map returns.
/// - Uniforms: those of the warp inside.
/// - Both tiers share this code.
///
/// # Accuracy
/// The errors are those of the warp inside and of the three functions. These are for y = sin x of an x with density 2x,
/// and for y = 2 ln x − ln 2. *Sample* counts units in the last place (ulp) of the exact point, densities are relative,
/// *inverse* and *round trip* absolute. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp | 4.2 | 6.5 | found |
/// | pdf, relative | 6.5e-7 | 5e-7 | found |
/// | realised density, relative | 1.13e-6 | 9.5e-7 | found |
/// | pdf with the sample, relative | 6e-7 | 4.5e-7 | found |
/// | inverse | 4.2e-7 | 4.6e-7 | found |
/// | round trip | 7.3e-7 | 7.3e-7 | found |
///
/// # Cost
/// That of the warp inside and of the functions given.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw, warp::Transform};
/// // x with density 2x on [0, 1]; y = 3x has density 2y/9 on [0, 3].
/// let stretched = Transform::new(mw::Linear::new(0.0, 1.0)?, |x: f32| 3.0 * x, |y: f32| y / 3.0, |_| 3.0);
/// assert_eq!(stretched.sample(0.25), 1.5);
/// assert!((stretched.pdf(1.5) - 1.0 / 3.0).abs() < 1e-7);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Inversion`](super::Inversion): a density on the line from its inverse CDF.
/// - [`Oriented`](super::Oriented): rotations.
///
/// # Source
/// E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997,
/// <https://graphics.stanford.edu/papers/veach_thesis/>.
#[doc(alias = "map")]
#[doc(alias = "jacobian")]
#[doc(alias = "change_of_variables")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transform<W, F, G, J> {
    warp: W,
    forward: F,
    backward: G,
    jacobian: J,
}

impl<W, F, G, J, Y> Transform<W, F, G, J>
where
    W: Warp<Density = f32>,
    F: Fn(W::Point) -> Y,
    G: Fn(Y) -> W::Point,
    J: Fn(W::Point) -> f32,
{
    /// `warp` followed by `forward`; `backward` is its inverse, and `jacobian` the absolute value of its
    /// derivative, or of its Jacobian determinant, at a point of the warp inside.
    #[must_use]
    pub const fn new(warp: W, forward: F, backward: G, jacobian: J) -> Self {
        Self {
            warp,
            forward,
            backward,
            jacobian,
        }
    }

    /// The warp inside.
    #[must_use]
    pub const fn warp(&self) -> &W {
        &self.warp
    }

    /// The density of f(x) for an x of the given density.
    #[inline]
    fn stretched(&self, x: W::Point, density: f32) -> f32 {
        if density > 0.0 {
            representable(density / (self.jacobian)(x).abs())
        } else {
            0.0
        }
    }

    /// f(x) and its density.
    #[inline]
    fn mapped(&self, (x, density): (W::Point, f32)) -> (Y, f32) {
        ((self.forward)(x), self.stretched(x, density))
    }
}

impl<W, F, G, J, Y> Warp for Transform<W, F, G, J>
where
    W: Warp<Density = f32>,
    F: Fn(W::Point) -> Y,
    G: Fn(Y) -> W::Point,
    J: Fn(W::Point) -> f32,
    Y: Copy,
{
    type Uniforms = W::Uniforms;
    type Point = Y;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<W::Uniforms>) -> Y {
        (self.forward)(self.warp.sample_canonical(u))
    }

    #[inline]
    fn pdf(&self, y: Y) -> f32 {
        let x = (self.backward)(y);
        self.stretched(x, self.warp.pdf(x))
    }

    #[inline]
    fn sample_words(&self, words: <W::Uniforms as Uniforms>::Words) -> Y {
        (self.forward)(self.warp.sample_words(words))
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Y, R::Error> {
        self.warp.try_draw(rng).map(&self.forward)
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<W::Uniforms>) -> (Y, f32) {
        self.mapped(self.warp.sample_canonical_with_pdf(u))
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<(Y, f32), R::Error> {
        let inner = self.warp.try_draw_with_pdf(rng)?;
        Ok(self.mapped(inner))
    }
}

impl<W, F, G, J, Y> Invert for Transform<W, F, G, J>
where
    W: Invert<Density = f32>,
    F: Fn(W::Point) -> Y,
    G: Fn(Y) -> W::Point,
    J: Fn(W::Point) -> f32,
    Y: Copy,
{
    #[inline]
    fn invert(&self, y: Y) -> W::Uniforms {
        self.warp.invert((self.backward)(y))
    }
}
