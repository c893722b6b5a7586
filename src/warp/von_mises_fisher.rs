//! The von Mises-Fisher distribution on the sphere.

use super::direction::{around, azimuth, is_direction};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp};
use crate::error::{Error, finite};
use crate::num::{
    Scaled, into_unit, quick_two_sum, remainder, representable, two_product, two_sum,
};
use crate::tier::{LOG2_E, Tier, exp_m1_of_product, exp2_m1, scaled_exp_of_product, times};
use core::f32::consts::TAU;
use core::marker::PhantomData;

/// The von Mises-Fisher distribution: the normal distribution of directions, for glossy lobes, light guiding and
/// noise on an orientation.
///
#[cfg_attr(doc, doc = include_str!("../pictures/von_mises_fisher.html"))]
///
/// Directions are local, about +z. The concentration κ is 0 for the uniform sphere; a large one gives a normal
/// distribution about +z of standard deviation 1/√κ radians in each of x and y. With v = 1 − u₁, 1 − cos θ is
/// −ln(1 − u₁(1 − e^(−2κ)))/κ and 1 + cos θ is ln(1 + v(e^(2κ) − 1))/κ. The nearer pole is measured from, and the
/// logarithm is taken of 1 + x or of v + u₁e^(−2κ), whichever keeps the digits: no two heights fall together, however
/// large κ is.
///
/// # Density
/// κ/(2π(1 − e^(−2κ))) e^(−κ(1 − cos θ)) per steradian, for any finite direction.
/// [`sample_with_pdf`](Warp::sample_with_pdf) takes it from the uniforms, without an exponential.
///
/// # Domain
/// Unit vectors. For large κ most of them have z = 1, and all the information is in x and y, which `pdf` and `invert`
/// read there. Two uniforms, polar then azimuth; +z is at u₁ = 0. κ is from 0 to 1e30. One below 2⁻³⁰ counts as that,
/// which changes no digit.
///
/// # Accuracy
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 3.6e-7 | 3.8e-7 | proven |
/// | sin θ, ulp | 3.7 | 3.7 | found |
/// | unit length | 1.8e-7 | 2.3e-7 | proven |
/// | pdf, relative | 4.3e-7 | 4.3e-7 | found |
/// | realised density, relative | 1.2e-5 | 1.2e-5 | found |
/// | pdf with the sample, relative | 3.6e-7 | 3.6e-7 | found |
/// | inverse | 3.1e-7 | 3.1e-7 | found |
/// | round trip | 3.2e-7 | 3.2e-7 | found |
///
/// These hold for every κ. The realised density counts the rounding of the direction up to 16.6 times: as far out,
/// 16.6/κ in 1 − cos θ, lies the last uniform. The density that comes with the sample does not know it. The errors of samples and
/// of their length are proven for every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost VonMisesFisher -->150 instructions and 1,692 bytes of code on an M4F, 6,414 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let gloss = mw::VonMisesFisher::new(1e8)?;
/// let ([x, y, z], density) = gloss.sample_with_pdf([0.5, 0.1]);
/// assert_eq!(z, 1.0);             // rounded away,
/// assert!(x * x + y * y > 1e-8);  // but not lost
/// assert!((density / (0.5 * gloss.pdf([0.0, 0.0, 1.0])) - 1.0).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`PhongLobe`](super::PhongLobe), a power of the cosine: a lobe that ends at the horizon.
/// - [`HenyeyGreenstein`](super::HenyeyGreenstein), with a peak as narrow and a far heavier tail.
/// - [`Oriented`](super::Oriented) turns it to another mean direction.
///
/// # Source
/// R. Fisher, "Dispersion on a Sphere", 1953, <https://doi.org/10.1098/rspa.1953.0064>; its inverse as in W. Jakob,
/// "Numerically stable sampling of the von Mises Fisher distribution on S² (and other tricks)", 2012, rearranged here.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "vmf")]
#[doc(alias = "fisher")]
#[doc(alias = "spherical_gaussian")]
pub struct VonMisesFisher<T> {
    kappa: f32,
    /// 1 − e^(−2κ).
    decay: f32,
    /// e^(−2κ).
    power: f32,
    /// e^(2κ) − 1; unused where no uniform leads behind the equator.
    rise: f32,
    /// The first uniform of the equator.
    equator: f32,
    /// The density at +z.
    peak: f32,
    tier: PhantomData<T>,
}

/// The smallest concentration that is told from the uniform sphere, 2⁻³⁰.
const FLAT: f32 = 9.313_226e-10;

/// From here on the equator lies beyond the last uniform.
const FRONT: f32 = 20.0;

/// 2⁻⁶⁰: a first uniform below it is itself the logarithm, however small it is.
const LINEAR: f32 = 8.673_617e-19;

/// 2⁻⁹⁰. Where 1 − cos θ is at least this, u₁(1 − e^(−2κ)) is a normal number for every κ; below it equals sin²θ/2.
const DEEP: f32 = 8.077_936e-28;

/// e^z − 1 with what it lacks, and e^z; for |z| up to 80.
fn exponential(z: f32) -> ((f32, f32), f32) {
    let (exact, small) = times(LOG2_E, z);
    let (k, rise) = exp2_m1(quick_two_sum(exact, small));
    let scale = Scaled::ONE.raised(k).value();
    let (less_one, dropped) = two_sum(scale - 1.0, scale * rise.0);
    let power = scale + scale * rise.0;
    ((less_one, dropped + scale * rise.1), power)
}

impl<T: Tier> VonMisesFisher<T> {
    /// The distribution about +z of concentration `kappa`, from 0 to 1e30.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] below 0, [`Error::OutOfRange`] above 1e30.
    pub fn new(kappa: f32) -> Result<Self, Error> {
        let kappa = finite(kappa, 0)?;
        if kappa < 0.0 {
            return Err(Error::Negative(0));
        }
        if kappa > 1e30 {
            return Err(Error::OutOfRange(0));
        }
        let told = if kappa > FLAT { kappa } else { FLAT };
        let ((less, less_rest), power) = if told < 2.0 * FRONT {
            exponential(-2.0 * told)
        } else {
            ((-1.0, 0.0), 0.0)
        };
        let (rise, equator) = if told < FRONT {
            let ((rise, _), _) = exponential(2.0 * told);
            let (_, half) = exponential(-told);
            (rise, 1.0 / (1.0 + half))
        } else {
            (0.0, 1.0)
        };
        let peak = Scaled::of_quotient((told, 0.0), (less, less_rest), Scaled::of(TAU));
        Ok(Self {
            kappa: told,
            decay: -less,
            power,
            rise,
            equator,
            peak: peak.value(),
            tier: PhantomData,
        })
    }

    /// The concentration κ; at least 2⁻³⁰.
    #[must_use]
    pub const fn concentration(&self) -> f32 {
        self.kappa
    }

    /// v + u₁e^(−2κ): the density over that at +z.
    #[inline]
    fn share(self, u1: f32) -> f32 {
        (1.0 - u1) + u1 * self.power
    }

    /// κ(1 − cos θ) of a uniform before the equator.
    #[inline]
    fn depth(self, u1: f32) -> f32 {
        let drop = u1 * self.decay;
        if drop <= 0.5 {
            -T::ln_1p(-drop)
        } else {
            -T::ln(self.share(u1))
        }
    }
}

/// 1 − cos θ of a direction, at most 2, and what it lacks, which κ multiplies.
#[inline]
fn off_peak([x, y, z]: [f32; 3]) -> (f32, f32) {
    let height = z.abs();
    if height <= 0.5 {
        return two_sum(1.0, -z);
    }
    // From the nearer pole, by x and y, which know more than z.
    let ((x2, x2_rest), (y2, y2_rest)) = (two_product(x, x), two_product(y, y));
    let ((top, top_rest), (over, over_rest)) = (two_sum(x2, y2), two_sum(1.0, height));
    let near = top / over;
    let rest = top_rest + (x2_rest + y2_rest) - near * over_rest;
    let lack = (remainder(top, near, over) + rest) / over;
    if z > 0.0 && near < 2.0 {
        (near, lack)
    } else if near < 2.0 {
        let (off, rest) = two_sum(2.0, -near);
        (off, rest - lack)
    } else {
        // Of what is no unit vector.
        (2.0, 0.0)
    }
}

impl<T: Tier> PlanarMap<3> for VonMisesFisher<T> {
    #[inline]
    fn map_to(&self, u1: f32, u2: f32, to: &mut [f32; 3]) {
        let (small, side) = if u1 <= self.equator {
            (self.depth(u1) / self.kappa, 1.0)
        } else {
            (T::ln_1p((1.0 - u1) * self.rise) / self.kappa, -1.0)
        };
        let (sin, cos) = if small >= DEEP {
            (T::sqrt(small * (2.0 - small)), side * (1.0 - small))
        } else if u1 < LINEAR {
            let slope = 2.0 * self.decay / self.kappa;
            (T::sqrt(u1) * T::sqrt(slope), 1.0)
        } else {
            // 1 − cos θ may be below the range of `f32`, its factors' roots are not.
            (T::sqrt(self.depth(u1)) * T::sqrt(2.0 / self.kappa), 1.0)
        };
        around::<T>(sin, cos, u2, to);
    }

    /// The density without an exponential, and free of what rounding the direction does.
    #[inline]
    fn put(&self, u1: f32, u2: f32, to: &mut [f32; 3]) -> f32 {
        self.map_to(u1, u2, to);
        self.peak * self.share(u1)
    }
}

impl<T: Tier> Warp for VonMisesFisher<T> {
    planar!(3, with its density, where T::VECTORS);

    #[inline]
    fn pdf(&self, direction: [f32; 3]) -> f32 {
        if is_direction(direction) {
            let (off, lack) = off_peak(direction);
            let density = scaled_exp_of_product::<T>(self.peak, -self.kappa, off);
            representable(density - density * (self.kappa * lack))
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for VonMisesFisher<T> {
    #[inline]
    fn invert(&self, direction: [f32; 3]) -> [f32; 2] {
        let [x, y, _] = direction;
        let (off, _) = off_peak(direction);
        let u1 = -exp_m1_of_product::<T>(-self.kappa, off) / self.decay;
        [into_unit(u1), azimuth::<T>(x, y)]
    }
}
