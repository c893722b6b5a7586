//! The largest of several uniforms: the power law of a whole exponent.

use super::{Invert, Warp};
use crate::num::{Scaled, into_unit, representable};
use crate::uniform::{Canonical, SMALLEST};

/// The largest of N uniforms: density N x^(N−1) on [0, 1).
///
/// The power law of exponent n = N − 1, without a logarithm or a root in the sample. The loop is bounded by N.
///
#[cfg_attr(doc, doc = include_str!("../pictures/power_max.html"))]
///
/// # Density
/// N x^(N−1) on [0, 1], else 0.
///
/// # Domain
/// - Point: (0, 1).
/// - Uniforms: N, all alike. N = 0 does not compile.
/// - Inverse: many sets of uniforms share their largest. `invert` gives N times the point itself, whose sample is
///   the point exactly.
/// - Both tiers share this code.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the exact point. *Pdf* and *realised density* are relative,
/// *inverse* and *round trip* are absolute errors of the uniform. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp | 1 | proven |
/// | pdf, relative | 1.6e-7 | found |
/// | realised density, relative | 1.6e-7 | found |
/// | inverse | 0 | found |
/// | round trip | 1.9e-45 | found |
///
/// The error of a sample is proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost PowerMax -->69 instructions and 176 bytes of code on an M4F, 423 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, warp::PowerMax};
/// let quadratic = PowerMax::<3>::new();
/// assert_eq!(quadratic.sample([0.5, 0.75, 0.25]), 0.75);
/// assert_eq!(quadratic.pdf(0.5), 0.75);
/// ```
///
/// # See also
/// - [`Power`](super::Power): any exponent and interval, from one uniform.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>.
#[doc(alias = "order_statistic")]
#[doc(alias = "maximum")]
#[doc(alias = "beta")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PowerMax<const N: usize>(());

impl<const N: usize> PowerMax<N> {
    /// N − 1, and its rounding error.
    const EXPONENT: (f32, f32) = {
        let n = N.wrapping_sub(1);
        (n as f32, (n as f64 - n as f32 as f64) as f32)
    };

    /// The largest of N uniforms.
    #[must_use]
    pub const fn new() -> Self {
        const { assert!(N > 0, "the largest of no uniforms does not exist") };
        Self(())
    }
}

impl<const N: usize> Default for PowerMax<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> Warp for PowerMax<N> {
    type Uniforms = [f32; N];
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; N]>) -> f32 {
        let mut largest = SMALLEST;
        for &u in &u.get() {
            if u > largest {
                largest = u;
            }
        }
        largest
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if !(0.0..=1.0).contains(&x) {
            return 0.0;
        }
        if N <= 4 {
            // N comes first: the power alone may be subnormal where the density is not.
            let mut density = N as f32;
            for _ in 1..N {
                density *= x;
            }
            representable(density)
        } else {
            let log = Scaled::of(x.abs()).log2();
            let peak = Scaled::of(N as f32);
            representable(peak.times_power(log, Self::EXPONENT).value())
        }
    }

    #[inline]
    fn sample_words(&self, words: [u32; N]) -> f32 {
        let largest = words.iter().fold(0, |most, word| most.max(*word));
        crate::uniform::deep_from_word(largest)
    }
}

impl<const N: usize> Invert for PowerMax<N> {
    #[inline]
    fn invert(&self, x: f32) -> [f32; N] {
        [into_unit(x); N]
    }
}
