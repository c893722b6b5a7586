//! The cosine-power lobe, also known as the Phong lobe.

use super::direction::{DEEP, around, azimuth, is_direction, one_minus_cos};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, finite};
use crate::num::{into_unit, remainder, representable, two_product, two_sum};
use crate::tier::{Tier, exp_of_product};
use crate::uniform::{Canonical, Uniforms, grid_from_word};
use core::f32::consts::FRAC_1_PI;
use core::marker::PhantomData;
use rand_core::TryRng;

/// In proportion to a power of the cosine over the hemisphere about +z: the Phong lobe.
///
/// cos θ = (1 − u₁)^(1/(n+1)). The code works with 1 − cos θ = −expm1(log1p(−u₁)/(n + 1)), so that a lobe of n =
/// 1e8 does not collapse onto its axis. Where that leaves the range of `f32`, sin θ = √(2 ln(1/(1 − u₁)))/√(n + 1),
/// so that sin θ is 0 at u₁ = 0 alone, up to the largest n. n = 0 is the uniform hemisphere, n = 1 the cosine one.
///
#[cfg_attr(doc, doc = include_str!("../pictures/phong_lobe.html"))]
///
/// # Density
/// (n + 1)/(2π) cosⁿθ per steradian where z > 0, else 0. Never 0 at a sample. Where z > ½, cos θ is read from all
/// three coordinates, because x and y hold digits that z has lost. [`sample_with_pdf`](Warp::sample_with_pdf) takes it from the
/// uniform, as (n + 1)(1 − u₁)/(2π cos θ).
///
/// # Domain
/// - Point: unit vectors with z > 0.
/// - Uniforms: two, for the polar angle and the azimuth. The axis is at u₁ = 0.
/// - Parameters: any finite n ≥ 0.
///
/// # Accuracy
/// *Sample* is the distance from the exact direction, *unit length* the error of the length. sin θ and cos θ count
/// units in the last place (ulp). *Pdf* and *realised density* are relative, *inverse* and *round trip* are
/// absolute errors of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 2.5e-7 | 3e-7 | proven |
/// | sin θ, ulp | 3.9 | 3.9 | found |
/// | cos θ, ulp | 44 | 56 | found |
/// | unit length | 1.9e-7 | 2.1e-7 | proven |
/// | pdf, relative | 5.3e-7 | 5.3e-7 | found |
/// | realised density, relative | min(1.1e-5, 8.1e-7 + 27*s) | min(1.1e-5, 8.1e-7 + 27*s) | found |
/// | pdf with the sample, relative | 5e-7 + 3e-6/(1 + k) | 5e-7 + 3e-6/(1 + k) | found |
/// | inverse | 2.3e-7 | 2.3e-7 | found |
/// | round trip | 3.1e-7 | 3.1e-7 | found |
///
/// k is n; the bounds hold for every n. s is the relative change of the density when sin θ and cos θ move by an ulp. Azimuths of
/// subnormal x and y, which only uniforms below 2⁻⁶⁴ give, have no more digits in the inverse than x and y have. The errors of the
/// sample and of the length are proven for every n and every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost PhongLobe -->147 instructions and 732 bytes of code on an M4F, 7,339 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let gloss = mw::PhongLobe::new(1e8)?;
/// let [x, y, z] = gloss.sample([0.5, 0.1]);
/// assert_eq!(z, 1.0);             // rounded away,
/// assert!(x * x + y * y > 1e-8);  // but not lost
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`CosineHemisphere`](super::CosineHemisphere), [`Hemisphere`](super::Hemisphere): n = 1 and n = 0 at a lower
///   cost.
/// - [`Oriented`](super::Oriented) turns it onto the direction of reflection.
/// - [`Cone`](super::Cone): a lobe with a sharp rim.
///
/// # Source
/// E. P. Lafortune and Y. D. Willems, "Using the Modified Phong Reflectance Model for Physically Based Rendering",
/// 1994, <http://www.graphics.cornell.edu/~eric/Phong.html>.
#[doc(alias = "cosine_power")]
#[doc(alias = "glossy")]
#[doc(alias = "specular")]
#[doc(alias = "lobe")]
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
        match finite(n, 0) {
            Ok(n) if n < 0.0 => Err(Error::Negative(0)),
            Ok(n) => Ok(Self {
                n,
                m: n + 1.0,
                tier: PhantomData,
            }),
            Err(e) => Err(e),
        }
    }

    /// The exponent n.
    #[must_use]
    pub const fn exponent(&self) -> f32 {
        self.n
    }

    /// The direction of -ln(1 - u₁) and u₂, and its density.
    #[inline]
    fn with_pdf(self, log: f32, [u1, u2]: [f32; 2]) -> ([f32; 3], f32) {
        let mut point = [0.0; 3];
        self.map_to(log, u2, &mut point);
        let [_, _, z] = point;
        let density = self.m * (0.5 * FRAC_1_PI) * ((1.0 - u1) / z);
        (point, representable(density))
    }

    /// m ln cos θ of a direction with z > 0.
    #[inline]
    fn log_rest(self, direction: [f32; 3]) -> f32 {
        let [x, y, z] = direction;
        if z <= 0.5 {
            self.m * T::ln(z)
        } else if self.m < NEEDLE {
            self.m * T::ln_1p(-one_minus_cos(direction))
        } else {
            // x² alone would underflow.
            -0.5 * (self.m * x * x + self.m * y * y)
        }
    }

    /// cosⁿθ of a direction with z > ½.
    ///
    /// cos θ is z(1 + d), where d tells what x and y know more than z: (1 − x² − y² − z²)/(z + z²), of which
    /// every digit counts, as n multiplies it.
    #[inline]
    fn power(self, [x, y, z]: [f32; 3]) -> f32 {
        let (x, y, n, half) = if self.n < NEEDLE {
            (x, y, self.n, 0.5)
        } else {
            // All that matters has z = 1 and x² near 1/n, which leaves the range: n x² = (n/s²)(s x)².
            let [x, y] = [x, y].map(|c| c * NEEDLE);
            (x, y, self.n / NEEDLE / NEEDLE, 0.0)
        };
        let ((x2, x2_rest), (y2, y2_rest)) = (two_product(x, x), two_product(y, y));
        let (z2, z2_rest) = two_product(z, z);
        let (sum, rest) = two_sum(1.0, -z2);
        let (sum, rest_x) = two_sum(sum, -x2);
        let (sum, rest_y) = two_sum(sum, -y2);
        let rest = (rest + rest_x + rest_y) - (x2_rest + y2_rest + z2_rest);
        let (lack, rest) = two_sum(sum, rest);
        let (over, over_rest) = two_sum(z, z2);
        let d = lack / over;
        let short = (remainder(lack, d, over) + (rest - d * (over_rest + z2_rest))) / over;
        let turned = exp_of_product::<T>(n, d);
        T::pow(z, self.n) * (turned + turned * n * (short - half * d * d))
    }
}

/// 2⁴⁰: an exponent from which on the lobe lies where z is 1.
const NEEDLE: f32 = 1_099_511_627_776.0;

impl<T: Tier> PlanarMap<3> for PhongLobe<T> {
    #[inline]
    fn first(&self, u1: f32) -> f32 {
        T::neg_ln_1m(u1)
    }

    #[inline]
    fn first_of_word(&self, word: u32) -> f32 {
        T::neg_ln_1m_of_word(word)
    }

    #[inline]
    fn map_to(&self, log: f32, u2: f32, to: &mut [f32; 3]) {
        let (cos, q) = T::exp_neg_pair(log / self.m);
        let sin = if q >= DEEP {
            T::sqrt(q * (1.0 + cos))
        } else {
            // q = log/m may be below the range of `f32`, its factors' roots are not.
            T::sqrt(2.0 * log) / T::sqrt(self.m)
        };
        around::<T>(sin, cos, u2, to);
    }
}

impl<T: Tier> Warp for PhongLobe<T> {
    planar!(3, where T::VECTORS);

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 3], f32) {
        let [u1, u2] = u.get();
        self.with_pdf(self.first(u1), [u1, u2])
    }

    #[inline]
    fn try_draw_with_pdf<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<([f32; 3], f32), R::Error> {
        let [a, b] = <[f32; 2]>::try_words(rng)?;
        Ok(self.with_pdf(self.first_of_word(a), [a, b].map(grid_from_word)))
    }

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        let [_, _, z] = direction;
        if z > 0.0 && is_direction(direction) {
            let shape = if z > 0.5 {
                self.power(direction)
            } else {
                T::pow(z, self.n)
            };
            representable(self.m * (0.5 * FRAC_1_PI) * shape)
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for PhongLobe<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, z] = direction;
        let u1 = if z > 0.0 {
            -T::exp_m1(self.log_rest(direction))
        } else {
            1.0
        };
        [into_unit(u1), azimuth::<T>(x, y)]
    }
}
