//! A warp from an inverse CDF.

use super::{Invert, Warp};
use crate::num::into_unit;
use crate::uniform::Canonical;

/// Any density on the line, from its inverse CDF, the density itself and its CDF.
///
#[cfg_attr(doc, doc = include_str!("../pictures/inversion.html"))]
///
/// # Density
/// That of the function given. The three functions must belong together. What they return is passed on as it is,
/// except that `invert` is brought into [0, 1).
///
/// # Domain
/// - Point: what the inverse CDF returns.
/// - Uniforms: one. Drawn ones are never 0 ([`deep_from_word`](crate::uniform::deep_from_word)), where an inverse
///   CDF may be infinite. Explicit ones can be.
/// - Both tiers share this code.
///
/// # Accuracy
/// The errors are those of the three functions; the warp adds none. These are for p(x) = ½ + x: *sample* in units
/// in the last place (ulp) of the exact point, densities relative, *inverse* and *round trip* absolute. [What each
/// row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 3.2 | found |
/// | pdf, relative | 8.7e-8 | found |
/// | realised density, relative | 1.5e-7 | found |
/// | inverse | 8.7e-8 | found |
/// | round trip | 1.8e-7 | found |
///
/// # Cost
/// That of the functions given.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, warp::Inversion};
/// // p(x) = 2x on [0, 1]
/// let ramp = Inversion::new(
///     |u: f32| libm::sqrtf(u),
///     |x: f32| if (0.0..=1.0).contains(&x) { 2.0 * x } else { 0.0 },
///     |x: f32| x * x,
/// );
/// assert_eq!(ramp.sample(0.25), 0.5);
/// assert_eq!(ramp.pdf(0.5), 1.0);
/// assert_eq!(ramp.invert(0.5), 0.25);
/// ```
///
/// # See also
/// - [`Transform`](super::Transform): a map after another warp.
/// - [`rejection::Rejection`](crate::rejection::Rejection): where no inverse CDF is known.
/// - [`PiecewiseConstant1d`](crate::discrete::PiecewiseConstant1d), [`PiecewiseLinear1d`](crate::discrete::PiecewiseLinear1d):
///   a table of the density.
///
/// # Source
/// J. von Neumann's letter to S. Ulam of 1947, in R. Eckhardt, "Stan Ulam, John von Neumann, and the Monte Carlo
/// Method", Los Alamos Science, 1987, <https://mcnp.lanl.gov/pdf_files/Article_1987_LAS_Eckhardt_131--141.pdf>.
#[doc(alias = "inverse_cdf")]
#[doc(alias = "quantile")]
#[doc(alias = "inverse_transform_sampling")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Inversion<Q, P, C> {
    quantile: Q,
    pdf: P,
    cdf: C,
}

impl<Q, P, C> Inversion<Q, P, C>
where
    Q: Fn(f32) -> f32,
    P: Fn(f32) -> f32,
    C: Fn(f32) -> f32,
{
    /// The warp with inverse CDF `quantile`, density `pdf` and CDF `cdf`.
    #[must_use]
    pub const fn new(quantile: Q, pdf: P, cdf: C) -> Self {
        Self { quantile, pdf, cdf }
    }
}

impl<Q, P, C> Warp for Inversion<Q, P, C>
where
    Q: Fn(f32) -> f32,
    P: Fn(f32) -> f32,
    C: Fn(f32) -> f32,
{
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        (self.quantile)(u.get())
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        (self.pdf)(x)
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.sample_canonical(crate::uniform::deep(word))
    }
}

impl<Q, P, C> Invert for Inversion<Q, P, C>
where
    Q: Fn(f32) -> f32,
    P: Fn(f32) -> f32,
    C: Fn(f32) -> f32,
{
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        into_unit((self.cdf)(x))
    }
}
