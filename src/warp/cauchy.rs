//! The Cauchy distribution.

use super::location_scale::{
    LocationScale, Standard, density_by_tails, invert, location_scale, location_scale_warp,
};
use super::{Invert, Warp};
use crate::num::above_zero;
use crate::tier::Tier;
use core::f32::consts::FRAC_1_PI;

/// What smaller tails count as, 2⁻⁶⁴: the smallest uniform of 64 bits. The cotangent of 2⁻¹⁴⁹ overflows.
const LEAST: f32 = 1.0 / 18_446_744_073_709_551_616.0;

/// Cauchy (Lorentz) with a location and a scale: the shape of spectral lines, and steps with a heavy tail.
///
/// x = x₀ − γ cot(πu), increasing with the uniform. The cotangent is a quotient of cosine and sine of half a turn, which
/// keeps its digits where the tangent of π(u − ½) has none.
///
#[cfg_attr(doc, doc = include_str!("../pictures/cauchy.html"))]
///
/// # Density
/// γ/(π(γ² + (x − x₀)²)), at least 2⁻¹⁴⁹ for every finite x. It has no mean and no variance.
///
/// # Domain
/// - Point: drawn samples end at 2.7e9γ on both sides. Uniforms on the 24-bit grid give −5.3e6γ to 5.3e6γ, except u = 0.
///   Uniforms below 2⁻⁶⁴, and 0 among them, count as 2⁻⁶⁴ and give −5.9e18γ. If you pass uniforms of your own, take them from
///   [`uniform::open`](crate::uniform::open()), which is never 0.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a finite location and a scale above 0 for which neither samples nor the density overflow.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the location or of the distance from it, whichever is larger. *Pdf*
/// and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, ulp of location or distance | 6.4 | 5.9 | proven |
/// | pdf, relative | 6.3e-7 | 6.8e-7 | found |
/// | realised density, relative | 5.7e-7 + 2.9*s/max(0, 1 - w/1e6) | 6.5e-7 + 3.4*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 6e-7 | 6e-7 | proven |
/// | inverse | 1.9e-7 | 9.4e-8 | found |
/// | round trip | 1.5e-7 + 3*r | 7e-8 + 2*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
/// a factor. s and r are the relative change of the density and the change of the inverse when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Cauchy -->81 instructions and 412 bytes of code on an M4F, 2,732 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let line = mw::Cauchy::new(656.3, 0.1)?;
/// assert_eq!(line.sample(0.5), 656.3);
/// assert!((line.sample(0.75) - 656.4).abs() < 1e-3); // the scale is half the width at half height
/// assert_eq!(line.invert(656.3), 0.5);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Normal`](super::Normal): light tails.
/// - [`EquiAngular`](super::EquiAngular): this density on an interval.
/// - [`Pareto`](super::Pareto): a heavy tail on one side, of any power.
///
/// # Source
/// N. L. Johnson, S. Kotz and N. Balakrishnan, "Continuous Univariate Distributions", volume 1, 1994, chapter 16. The form of
/// the cotangent is this crate's own.
#[doc(alias = "lorentz")]
#[doc(alias = "lorentzian")]
#[doc(alias = "breit_wigner")]
#[doc(alias = "heavy_tail")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cauchy<T>(LocationScale<T>);

location_scale!(Cauchy);

impl<T: Tier> Cauchy<T> {
    /// The standard point with this probability beyond it, and the sine of that part of half a turn.
    #[inline]
    fn deviate_and_sine(tail: f32, upper: bool) -> (f32, f32) {
        let tail = if tail > LEAST { tail } else { LEAST };
        let (sine, cosine) = T::sincos_turns(0.5 * tail);
        let size = cosine / sine;
        (if upper { size } else { -size }, sine)
    }

    /// The point with this probability beyond it, and its density: 1/(1 + cot²) is the square of the sine.
    #[inline]
    fn placed(&self, tail: f32, upper: bool) -> (f32, f32) {
        let (x, sine) = Self::deviate_and_sine(tail, upper);
        (self.at(x), above_zero(self.0.peak * (sine * sine)))
    }
}

impl<T: Tier> Warp for Cauchy<T> {
    location_scale_warp!();
    density_by_tails!();
}

impl<T: Tier> Invert for Cauchy<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        invert::<T, Self>(&self.0, x)
    }
}

impl<T: Tier> Standard for Cauchy<T> {
    const PEAK: f32 = FRAC_1_PI;
    const REACH: f32 = 6.0e18;

    #[inline]
    fn deviate(tail: f32, upper: bool) -> f32 {
        Self::deviate_and_sine(tail, upper).0
    }

    #[inline]
    fn density(peak: f32, (t, _): (f32, f32)) -> f32 {
        let square = t * t;
        if square <= f32::MAX {
            peak / (1.0 + square)
        } else {
            peak / t / t
        }
    }

    #[inline]
    fn cdf(t: f32) -> f32 {
        2.0 * T::atan2_turns(1.0, -t)
    }
}
