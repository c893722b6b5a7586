//! The cosine-power lobe, also known as the Phong lobe.

use super::direction::{around, azimuth, is_direction, one_minus_cos};
use super::fill::{Place, placed};
use super::{Warp, into_unit, representable};
use crate::error::{Error, finite};
use crate::tier::Tier;
use crate::uniform::Canonical;
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;

/// Density ∝ cosⁿθ over the hemisphere about +z, for any n ≥ 0.
///
/// cos θ = (1 − u₁)^(1/(n+1)), carried as 1 − cos θ = −expm1(log1p(−u₁)/(n + 1)), so that a lobe of
/// n = 1e8 does not collapse onto its axis. n = 0 is the uniform hemisphere, n = 1 the cosine one.
///
/// - Uniforms: two, polar then azimuth; the axis is at u₁ = 0.
/// - Range: unit vectors with z > 0.
/// - Density: (n + 1)/(2π) cosⁿθ per steradian; never 0 at a sample.
///
/// | error | `libm` | `poly` |
/// |---|--:|--:|
/// | sample, of the size | 1.8e-7 | 2.0e-7 |
/// | sin θ, ulp | 2.7 | 2.7 |
/// | cos θ, ulp | 11 | 18 |
/// | unit length | 1.6e-7 | 1.9e-7 |
/// | pdf, relative | 2.6e-6 | 2.5e-6 |
/// | realised density, relative | 6.5e-6 | 6.5e-6 |
/// | inverse | 1.6e-7 | 1.7e-7 |
/// | round trip | 2.0e-7 | 2.0e-7 |
///
/// Source: E. P. Lafortune and Y. D. Willems, "Using the Modified Phong Reflectance Model for Physically
/// Based Rendering", 1994.
///
/// ```
/// use microwarp::{Warp, poly as mw};
/// let gloss = mw::PhongLobe::new(1e8)?;
/// let [x, y, z] = gloss.sample([0.5, 0.1]);
/// assert_eq!(z, 1.0);             // rounded away,
/// assert!(x * x + y * y > 1e-8);  // but not lost
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PhongLobe<T> {
    n: f32,
    /// n + 1.
    m: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> PhongLobe<T> {
    /// The lobe of exponent `n` ≥ 0.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] below 0.
    pub const fn new(n: f32) -> Result<Self, Error> {
        match finite(n) {
            Ok(n) if n < 0.0 => Err(Error::Negative),
            Ok(n) => Ok(Self {
                n,
                m: n + 1.0,
                tier: PhantomData,
            }),
            Err(e) => Err(e),
        }
    }

    /// ln cos θ of a direction with z > 0.
    #[inline]
    fn ln_cos(direction: [f32; 3]) -> f32 {
        let [_, _, z] = direction;
        if z > 0.5 {
            T::ln_1p(-one_minus_cos(direction))
        } else {
            T::ln(z)
        }
    }
}

impl<T: Tier> Place<3> for PhongLobe<T> {
    #[inline]
    fn place(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let (cos, q) = T::exp_neg_pair(T::neg_ln_1m(u1) / self.m);
        around::<T>(T::sqrt(q * (1.0 + cos)), cos, u2, to);
    }
}

impl<T: Tier> Warp for PhongLobe<T> {
    type Uniforms = [f32; 2];
    type Point = [f32; 3];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> [f32; 3] {
        placed(self, u)
    }

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let [_, _, z] = direction;
        if z > 0.0 && is_direction(direction) {
            let shape = T::exp(self.n * Self::ln_cos(direction));
            representable(self.m * (0.5 * FRAC_1_PI) * shape)
        } else {
            0.0
        }
    }

    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, z] = direction;
        let u1 = if z > 0.0 {
            -T::exp_m1(self.m * Self::ln_cos(direction))
        } else {
            1.0
        };
        [into_unit(u1), azimuth::<T>(x, y)]
    }

    super::filled_in_blocks!(of placed where T::VECTORS);
}
