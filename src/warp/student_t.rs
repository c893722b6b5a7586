//! Student's t: one number from two uniforms, without a loop.

use super::degrees::{Degrees, Square};
use super::location_scale::{LocationScale, checked};
use super::{Invert, Warp};
use crate::error::{Error, tried};
use crate::num::{LARGEST, folded_tail};
use crate::tier::Tier;
use crate::uniform::Canonical;

/// Student's t with some degrees of freedom, a location and a scale: noise with outliers, by how many of them there are.
///
/// x = μ − σ√ν √((1 − u₁)^(−2/ν) − 1) cos πu₂, Bailey's form. It takes no loop, and increases with u₂. One degree of freedom is
/// [`Cauchy`](super::Cauchy), and many are [`Normal`](super::Normal); the form serves them all.
///
#[cfg_attr(doc, doc = include_str!("../pictures/student_t.html"))]
///
/// # Density
/// C(1 + t²/ν)^(−(ν+1)/2)/σ, where t = (x − μ)/σ and C = Γ((ν+1)/2)/(√(νπ) Γ(ν/2)); at least 2⁻¹⁴⁹ for every finite x.
///
/// # Domain
/// - Point: drawn samples end at √ν √(4^(33/ν) − 1) σ on both sides: 8.6e9σ for one degree of freedom, 6.8σ for many.
/// - Uniforms: two. Drawing takes all 32 bits of both words, as the middles of their cells, but for the second one near the
///   location, of which 24 bits count. Words as far from either end of the second one give opposite numbers.
/// - Parameters: degrees of freedom above 0 that need not be whole, a finite location and a scale above 0, for which neither
///   samples nor the density overflow: at a scale of 1, from 0.27 degrees on.
/// - Inverse: many pairs of uniforms share their point, and none is special. `invert` gives the pair with the smallest u₁, and
///   u₂ at an end. A one-to-one map takes two numbers, [`StudentPair`](super::StudentPair).
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of the location or of the distance from it, whichever is larger. *Pdf*
/// and *realised density* are relative, *inverse* is the absolute error of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of location or distance | 14 | found |
/// | pdf, relative | 7.6e-7 | found |
/// | realised density, relative | 7.8e-7 + 9.7*s/max(0, 1 - w/1e6) | found |
/// | inverse | 1.8e-7 | found |
/// | round trip | 1 | found |
///
/// w is |location|/scale. No realised density is stated from 1e6 on, where the densities of neighbouring `f32` differ by
/// a factor. s is the relative change of the density when x moves by one ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost StudentT -->151 instructions and 668 bytes of code on an M4F, 7,175 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Warp, poly as mw};
/// let noise = mw::StudentT::new(5.0, 20.0, 0.5)?; // of five degrees of freedom
/// assert_eq!(noise.sample([0.3, 0.5]), 20.0);
/// assert!((noise.pdf(20.0) - 2.0 * 0.379_606_7).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`StudentPair`](super::StudentPair): two numbers from two uniforms, with an inverse.
/// - [`Cauchy`](super::Cauchy), [`Normal`](super::Normal): one number from one uniform, with an inverse.
///
/// # Source
/// R. W. Bailey, "Polar Generation of Random Variates with the t-Distribution", 1994,
/// <https://doi.org/10.1090/S0025-5718-1994-1219702-8>. The forms free of cancellation are this crate's own.
#[doc(alias = "t_distribution")]
#[doc(alias = "heavy_tail")]
#[doc(alias = "outlier")]
#[doc(alias = "robust")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StudentT<T> {
    degrees: Degrees,
    own: LocationScale<T>,
}

impl<T: Tier> StudentT<T> {
    /// Student's t with these degrees of freedom, this location and this scale. The standard law has 0 and 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for degrees or a scale of 0 or less,
    /// [`Error::TooLarge`] if a sample could overflow, [`Error::Empty`] if the density could.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub const fn new(degrees: f32, location: f32, scale: f32) -> Result<Self, Error> {
        let (degrees, reach) = tried!(Degrees::new(degrees));
        tried!(checked(location, scale, reach, 1));
        // No density of scale 1 is above 1.
        if scale < f32::MIN_POSITIVE && !degrees.steepest(scale).is_finite() {
            return Err(Error::Empty(2));
        }
        Ok(Self {
            degrees,
            own: LocationScale::of(location, scale, degrees.peak() / scale),
        })
    }

    /// The degrees of freedom.
    #[must_use]
    pub const fn degrees(&self) -> f32 {
        self.degrees.count
    }

    /// The location.
    #[must_use]
    pub const fn location(&self) -> f32 {
        self.own.location
    }

    /// The scale.
    #[must_use]
    pub const fn scale(&self) -> f32 {
        self.own.scale
    }

    /// The point at this radius and this part of half a turn from the lower end; from the upper one if a bit of the sign is set.
    #[inline]
    fn at(&self, radius: f32, half: f32, sign: u32) -> f32 {
        let (x, _) = T::polar(-self.own.scale * radius, 0.5 * half);
        // A branch on a random bit would be mispredicted.
        self.own.location + f32::from_bits(x.to_bits() ^ sign)
    }
}

impl<T: Tier> Warp for StudentT<T> {
    type Uniforms = [f32; 2];
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> f32 {
        let [u1, u2] = u.get();
        self.at(self.degrees.radius(u1), u2, 0)
    }

    // In a loop of draws a call would take a tenth more, on x86-64.
    #[allow(clippy::inline_always, reason = "as of `try_draw`, which calls it")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn sample_words(&self, [a, b]: [u32; 2]) -> f32 {
        let radius = self.degrees.radius_of_word(a);
        self.at(radius, folded_tail(b), b & 1 << 31)
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if x.is_finite() {
            let square = Square::of(x, self.own.location, self.own.scale);
            self.degrees.density::<T>(self.own.peak, square, 1.0)
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for StudentT<T> {
    #[inline]
    fn invert(&self, x: f32) -> [f32; 2] {
        let square = Square::of(x, self.own.location, self.own.scale);
        let end = if x < self.own.location { 0.0 } else { LARGEST };
        [self.degrees.uniform::<T>(square), end]
    }
}
