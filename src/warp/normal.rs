//! The normal distribution: one number by its quantile, two by Box and Muller's map; densities with samples from the uniform.

use super::direction::azimuth;
use super::location_scale::{checked, decayed, peak_of_pair, standardised};
use super::planar::{PlanarMap, planar};
use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, tried};
use crate::num::{folded, into_unit, representable, tail, two_product, two_sum};
use crate::tier::{Tier, density_of_tail, normal_quantile, normal_quantile_of_word};
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// 1/√(2π) = (2/√π)/√8.
pub(super) const FRAC_1_SQRT_TAU: f32 =
    (core::f64::consts::FRAC_2_SQRT_PI * core::f64::consts::FRAC_1_SQRT_2 * 0.5) as f32;

/// An upper bound on how far a sample lies from the mean, in standard deviations: the quantile of 2⁻¹⁴⁹ is −14.2.
const REACH: f32 = 14.5;

/// Normal (Gaussian) with a mean and a standard deviation, one number at a time.
///
/// x = μ + σΦ⁻¹(u), increasing with the uniform, so that strata stay strata: never back from one uniform of the 24-bit grid to
/// the next, and by at most 2 ulp of location or distance from one word to the next. Up to 2.88σ it comes by a table of 640
/// bytes, beyond by a logarithm and a root. Words as far from either end give opposite Φ⁻¹(u), to the last bit.
///
#[cfg_attr(doc, doc = include_str!("../pictures/normal.html"))]
///
/// # Density
/// e^(−(x−μ)²/2σ²)/(σ√2π), at least 2⁻¹⁴⁹ for every finite x.
///
/// # Domain
/// - Point: drawn samples end at 6.34σ on both sides. Uniforms on the 24-bit grid give −5.30σ to 5.30σ, except
///   u = 0: it counts as 2⁻¹⁴⁹ and gives −14.2σ, an outlier that comes once in 2²⁴ uniforms. If you pass uniforms of
///   your own, take them from [`uniform::open`](crate::uniform::open()), which is never 0, or from
///   [`Strata1d::draw`](crate::uniform::Strata1d::draw), which has more bits near 0.
/// - Uniforms: one. Drawing takes all 32 bits of a word, as the middle of their cell, so that the moments of what
///   can be drawn are those of the normal distribution (the eighth to 1e-6).
/// - Parameters: a finite mean and a standard deviation above 0 for which no sample overflows. A standard deviation
///   near the spacing of `f32` at the mean (6e-8 of it) is lost in the rounding of the samples.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of μ or of x − μ, whichever is larger. *Pdf* and *realised
/// density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// A draw keeps the bound of a sample at the exact middle of its word. The realised density is stated for |μ| < 1e6 σ. In its
/// formula w is |μ|/σ, and the divisor max(0, 1 − w/1e6) ends it there: it is nearly 1 for common parameters, and beyond 1e6
/// the densities of neighbouring `f32` differ by a factor. s and r are the relative change of the density and the change of the
/// inverse when x moves by one ulp.
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of location or distance | 7.1 | proven |
/// | pdf, relative | 7.9e-7 | found |
/// | realised density, relative | 7.7e-7 + 5.4*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 4.8e-7 | proven |
/// | inverse | 2.5e-7 | found |
/// | round trip | 2.1e-7 + 3*r | found |
///
/// The errors of a sample and of the density with it are proven for all parameters and uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost Normal -->62 instructions and 824 bytes of code on an M4F, 1,601 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let noise = mw::Normal::new(10.0, 2.0)?;
/// assert_eq!(noise.sample(0.5), 10.0);
/// assert!((noise.invert(12.0) - 0.841_344_8).abs() < 1e-6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`TruncatedNormal`](super::TruncatedNormal): on an interval, or beyond a bound.
/// - [`NormalPair`](super::NormalPair): two numbers from two uniforms. Its [`fill`](crate::Warp::fill) is the fastest way to
///   fill a slice on a PC. Take it where strata do not matter.
/// - [`rejection::ZigguratNormal`](crate::rejection::ZigguratNormal) is the fastest one number at a time: take it
///   where words come from a generator and neither an inverse nor a fixed number of uniforms is needed.
///
/// # Source
/// M. J. Wichura, "Algorithm AS 241: The Percentage Points of the Normal Distribution", 1988,
/// <https://doi.org/10.2307/2347330>, for the division into regions. The table and the coefficients are this crate's own.
#[doc(alias = "gaussian")]
#[doc(alias = "bell_curve")]
#[doc(alias = "probit")]
#[doc(alias = "noise")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normal<T> {
    mean: f32,
    std_dev: f32,
    /// The density at the mean.
    peak: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> Normal<T> {
    /// Normal with the given mean and standard deviation.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a standard deviation of 0 or less,
    /// [`Error::TooLarge`] if a sample could overflow, [`Error::Empty`] if the density could.
    pub const fn new(mean: f32, std_dev: f32) -> Result<Self, Error> {
        let peak = FRAC_1_SQRT_TAU / std_dev;
        tried!(checked(mean, std_dev, REACH, 0));
        if peak.is_finite() {
            Ok(Self {
                mean,
                std_dev,
                peak,
                tier: PhantomData,
            })
        } else {
            Err(Error::Empty(1))
        }
    }

    /// The mean.
    #[must_use]
    pub const fn mean(&self) -> f32 {
        self.mean
    }

    /// The standard deviation.
    #[must_use]
    pub const fn std_dev(&self) -> f32 {
        self.std_dev
    }
}

impl<T: Tier> Normal<T> {
    /// The point so many standard deviations from the mean.
    #[inline]
    fn at(&self, z: f32) -> f32 {
        self.mean + self.std_dev * z
    }

    /// Its density, from the probability beyond it on its side.
    #[inline]
    fn pdf_of_tail(&self, tail: f32, z: f32) -> f32 {
        let (decayed, factor) = density_of_tail(tail, z);
        representable(self.peak * decayed * factor)
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        let z = normal_quantile_of_word::<T>(1.0, word);
        (self.at(z), self.pdf_of_tail(folded(word).0, z))
    }
}

/// −t²/2 and its rounding error, for a t whose rounding error is `rest`.
#[inline]
pub(super) fn exponent((t, rest): (f32, f32)) -> (f32, f32) {
    let (square, dropped) = two_product(-0.5 * t, t);
    (square, dropped - t * rest)
}

impl<T: Tier> Warp for Normal<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        self.at(normal_quantile::<T>(u.get()))
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.at(normal_quantile_of_word::<T>(1.0, word))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let u = u.get();
        let z = normal_quantile::<T>(u);
        (self.at(z), self.pdf_of_tail(tail(u), z))
    }

    drawn_with_pdf!(from of_word_with_pdf);

    #[inline]
    fn map_with_pdf(&self, uniforms: &[f32], points: &mut [f32], densities: &mut [f32]) {
        // One by one, but for the densities, which the compiler works out in vectors.
        let mut count = 0..;
        for ((point, z), &u) in points.iter_mut().zip(&mut *densities).zip(uniforms) {
            *z = normal_quantile::<T>(into_unit(u));
            *point = self.at(*z);
            count.next();
        }
        for (density, &u) in densities.iter_mut().zip(uniforms).take(count.start) {
            *density = self.pdf_of_tail(tail(into_unit(u)), *density);
        }
    }

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if x.is_finite() {
            let t = standardised(x, self.mean, self.std_dev);
            representable(decayed::<T>(self.peak, exponent(t)))
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for Normal<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let t = (x - self.mean) / self.std_dev;
        into_unit(if t > 0.0 {
            1.0 - T::normal_cdf_lower(-t)
        } else {
            T::normal_cdf_lower(t)
        })
    }
}

/// Two independent normals (Gaussians) with a common standard deviation, by Box and Muller's map.
///
/// Radius σ√(−2 ln(1 − u₁)), angle u₂ turns: a point of the plane about the mean point.
///
#[cfg_attr(doc, doc = include_str!("../pictures/normal_pair.html"))]
///
/// # Density
/// e^(−r²/2σ²)/(2πσ²) per unit area, at least 2⁻¹⁴⁹ for every finite point.
///
/// # Domain
/// - Point: within 5.77σ of the mean point.
/// - Uniforms: two, radius and angle. u₁ = 0 gives the mean point itself.
/// - Parameters: a finite mean point and a standard deviation above 0 for which neither samples nor the density
///   overflow.
///
/// # Accuracy
/// *Sample* is the distance from the exact point, relative to the size: the farthest coordinate, which is the
/// larger |μ| plus 5.77σ. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors
/// of the uniforms. [What each row means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, of the size | 3.6e-7 | proven |
/// | pdf, relative | 4.4e-7 | found |
/// | realised density, relative | 7.2e-7 + 5.3*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 3.9e-7 | found |
/// | inverse | 2.1e-7 | found |
/// | round trip | 1.5e-7 + 1.8*r | found |
///
/// w is the larger |μ| over σ; no realised density is stated from 1e6 on. s and r are the relative change of the
/// density and the change of the inverse when the point moves by 2⁻²⁴ of the size. The error of the sample is proven for
/// all parameters and every pair of uniforms: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost NormalPair -->110 instructions and 484 bytes of code on an M4F, 4,975 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let noise = mw::NormalPair::new([0.0, 0.0], 1.0)?;
/// assert_eq!(noise.sample([0.0, 0.7]), [0.0, 0.0]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Normal`](super::Normal): one number from one uniform, increasing with it, for stratified uniforms.
/// - [`rejection::ZigguratNormal`](crate::rejection::ZigguratNormal): the fastest one number at a time, without an
///   inverse. Into a slice on a PC, [`fill`](crate::Warp::fill) of this type is the fastest.
///
/// # Source
/// G. E. P. Box and M. E. Muller, "A Note on the Generation of Random Normal Deviates", 1958,
/// <https://doi.org/10.1214/aoms/1177706645>.
#[doc(alias = "gaussian")]
#[doc(alias = "box_muller")]
#[doc(alias = "bivariate_normal")]
#[doc(alias = "noise")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NormalPair<T> {
    mean: [f32; 2],
    std_dev: f32,
    /// The density at the mean point.
    peak: f32,
    tier: PhantomData<T>,
}

impl<T: Tier> NormalPair<T> {
    /// Normals about the given mean point with the given standard deviation in each coordinate.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a standard deviation of 0 or less,
    /// [`Error::TooLarge`] if a sample could overflow or the density vanish, [`Error::Empty`] if the
    /// density could overflow.
    pub const fn new(mean: [f32; 2], std_dev: f32) -> Result<Self, Error> {
        Ok(Self {
            mean,
            std_dev,
            peak: tried!(peak_of_pair(mean, std_dev, REACH, 0)),
            tier: PhantomData,
        })
    }

    /// The mean.
    #[must_use]
    pub const fn mean(&self) -> [f32; 2] {
        self.mean
    }

    /// The standard deviation of each coordinate.
    #[must_use]
    pub const fn std_dev(&self) -> f32 {
        self.std_dev
    }
}

impl<T: Tier> NormalPair<T> {
    /// The density at the radius of this uniform.
    #[inline]
    fn pdf_of_radius(&self, u1: f32) -> f32 {
        representable(self.peak * (1.0 - u1))
    }
}

impl<T: Tier> PlanarMap<2> for NormalPair<T> {
    #[inline]
    fn first(&self, u1: f32) -> f32 {
        T::neg_ln_1m(u1)
    }

    #[inline]
    fn first_of_word(&self, word: u32) -> f32 {
        T::neg_ln_1m_of_word(word)
    }

    #[inline]
    fn map_to(&self, log: f32, u2: f32, to: &mut [f32; 2]) {
        let [mx, my] = self.mean;
        let (x, y) = T::polar(self.std_dev * T::sqrt(2.0 * log), u2);
        *to = [mx + x, my + y];
    }
}

impl<T: Tier> Warp for NormalPair<T> {
    planar!(2, where T::VECTORS);
    drawn_with_pdf!();

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; 2]>) -> ([f32; 2], f32) {
        let [u1, _] = u.get();
        (self.sample_canonical(u), self.pdf_of_radius(u1))
    }

    #[inline]
    fn map_with_pdf(&self, uniforms: &[[f32; 2]], points: &mut [[f32; 2]], densities: &mut [f32]) {
        let count = points.len().min(densities.len());
        if let (Some(points), Some(densities)) =
            (points.get_mut(..count), densities.get_mut(..count))
        {
            self.map(uniforms, points);
            for (density, &[u1, _]) in densities.iter_mut().zip(uniforms) {
                *density = self.pdf_of_radius(into_unit(u1));
            }
        }
    }

    #[inline]
    fn pdf(&self, point: [f32; 2]) -> f32 {
        let ([x, y], [mx, my]) = (point, self.mean);
        if x.is_finite() && y.is_finite() {
            let (x, x_rest) = exponent(standardised(x, mx, self.std_dev));
            let (y, y_rest) = exponent(standardised(y, my, self.std_dev));
            let (sum, dropped) = two_sum(x, y);
            representable(decayed::<T>(self.peak, (sum, dropped + (x_rest + y_rest))))
        } else {
            0.0
        }
    }
}

impl<T: Tier> Invert for NormalPair<T> {
    #[inline]
    fn invert(&self, point: [f32; 2]) -> [f32; 2] {
        let ([x, y], [mx, my]) = (point, self.mean);
        let [x, y] = [x - mx, y - my];
        let [across, along] = [x / self.std_dev, y / self.std_dev];
        // Divided by the standard deviation, the smallest distances would lose their direction.
        [
            into_unit(-T::exp_m1(-0.5 * (across * across + along * along))),
            azimuth::<T>(x, y),
        ]
    }
}
