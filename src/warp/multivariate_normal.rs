//! The normal distribution of several correlated numbers, semi-definite too.

mod factor;

use self::factor::{Factors, Rows};
use super::normal::FRAC_1_SQRT_TAU;
use super::{Invert, Warp};
use crate::error::{Error, finite};
use crate::num::double_word::{DoubleWord, plus, times};
use crate::num::{
    Scaled, folded, into_unit, nearest_integer, representable, saturated, tail, two_product,
    two_sum,
};
use crate::tier::{LN_2, LOG2_E, Tier, density_of_tail, normal_quantile, normal_quantile_of_word};
use crate::uniform::{Canonical, Uniforms};
use core::marker::PhantomData;

/// How many roundings of what it is computed from a point may lie off the subspace.
const ROUNDINGS: f32 = 4.0;

/// Several correlated normal numbers (Gaussians) of a mean and a covariance matrix, which may be singular.
///
/// x = μ + A z with A Aᵀ = Σ, where each z is Φ⁻¹ of its uniform. The matrix is taken apart with pivots, in twice the digits of
/// `f32` and in units of each coordinate's own. So samples keep their digits however strongly coordinates are correlated, and
/// metres may stand beside radians.
///
#[cfg_attr(doc, doc = include_str!("../pictures/multivariate_normal.html"))]
///
/// A coordinate that follows from others, or that has no variance, has no randomness of its own: a robot that does not slide
/// moves along its heading alone. [`free`](Self::free) tells which coordinates do. [`whiten`](Self::whiten) is the way back from a
/// point to z, whose sum of squares is Mahalanobis' distance squared, and [`at`](Self::at) takes z of another source.
///
/// # Density
/// e^(−|z|²/2)/∏ Aᵢᵢ√2π over the free coordinates, with respect to these: of a regular Σ that is e^(−tᵀΣ⁻¹t/2)/√det 2πΣ with
/// t = x − μ. It is at least 2⁻¹⁴⁹ where the other coordinates are what the free ones say, to rounding, and 0 elsewhere. (Some
/// libraries take it with respect to the area of the subspace, by a pseudo-determinant; that is another constant.) Where it leaves
/// the range of `f32`, as it soon does in many dimensions, [`ln_pdf`](Self::ln_pdf) has its logarithm.
///
/// # Domain
/// - Point: D numbers. Each lies as far from its mean as those of [`Normal`](super::Normal) do, in units of √Σᵢᵢ and √D.
/// - Uniforms: D, one a coordinate; those of coordinates that are not free do nothing. A uniform of 0 counts as 2⁻¹⁴⁹. Drawing
///   takes all 32 bits of each word, as the middle of their cell.
/// - Parameters: a finite mean and a finite matrix, which is symmetric and semi-definite, both to D·9.5e-7 of √Σᵢᵢ √Σⱼⱼ, since
///   rounding makes others of such; of Σᵢⱼ and Σⱼᵢ the mean counts. What is left of a variance, given the others, counts as 0 up
///   to D·2.4e-7 of it, and so does a variance up to D·2.8e-45. D is any number from 1.
///
/// # Accuracy
/// These are for two dimensions. *Sample* is the distance from the exact point, relative to the size: the largest |μᵢ| plus 14.2 of
/// the largest √Σᵢᵢ. *Pdf* and *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniforms.
/// [What each row means](crate::warp#stated-errors).
///
/// | error | `libm` | `poly` | kind |
/// |---|--:|--:|---|
/// | sample, of the size | 5.6e-7 | 5.6e-7 | found |
/// | pdf, relative | 7e-7 + 5e-12*c | 7e-7 + 6*s | found |
/// | realised density, relative | 1e-6 + 3.5*s/max(0, 1 - s/0.1) | 1e-6 + 3.5*s/max(0, 1 - s/0.1) | found |
/// | pdf with the sample, relative | 9.6e-7 | 9.6e-7 | found |
/// | inverse | 2.3e-7 | 2.2e-7 + 3.4*r | found |
/// | round trip | 2.2e-7 + 3.3*r | 2.2e-7 + 5*r | found |
///
/// c is the condition number of the matrix of correlations, here at most 8.4e6; s and r are the relative change of the density and
/// the change of the inverse when the point moves by 2⁻²⁴ of the size. No realised density is stated where s reaches 0.1.
///
/// In D dimensions each coordinate of a sample is off by at most 3.2e-7 of |xᵢ| + |μᵢ| + √Σᵢᵢ max(1, |z|), whatever c is, and
/// pdf with the sample by 7e-7 + 1.3e-7·D. With q = |z|², whitened numbers in `poly` are off by 6e-7·√(c·q), the logarithm of the
/// density by 1.1e-7·(D + 4 + |ln p|) + 3.5e-7·√c·q, and so is the density, relatively and without |ln p|. In
/// [`libm`](crate::libm) these are 9e-8·√q and 1.1e-7·(D + 4 + |ln p|) + 2.2e-14·c·q. All are found, for D to 12.
///
/// # Cost
/// A draw takes D quantiles and D² products, a density as many products and an exponential. In [`libm`](crate::libm) those of the
/// density have twice the digits. 12 D² + 5 D + 8 bytes, rounded up to whole words.
///
/// # Examples
/// ```
/// use microwarp::{Error, Invert, Warp, poly as mw};
/// // The error of a robot's pose: x and y in metres, the heading in radians. It slides with its heading.
/// let error = mw::MultivariateNormal::new(
///     [0.0, 0.0, 0.1],
///     [[0.04, 0.0, 0.0], [0.0, 0.01, 0.002], [0.0, 0.002, 0.0016]],
/// )?;
/// let pose = error.sample([0.5, 0.5, 0.9]);
/// assert_eq!(pose[0..2], [0.0, 0.0]);
/// let [_, _, turned] = error.whiten(pose);
/// assert!((turned - 1.281_552).abs() < 1e-5); // the quantile of 0.9
/// let back = error.invert(pose);
/// assert!(back.iter().zip([0.5, 0.5, 0.9]).all(|(u, v)| (u - v).abs() < 1e-6));
///
/// // Two coordinates that are always equal: a singular matrix.
/// let line = mw::MultivariateNormal::new([0.0; 2], [[1.0, 1.0], [1.0, 1.0]])?;
/// assert_eq!((line.rank(), line.free()), (1, [true, false]));
/// let [x, y] = line.sample([0.7, 0.2]);
/// assert!(x == y && line.pdf([x, y]) > 0.0 && line.pdf([x, -y]) == 0.0);
///
/// // Correlations beyond 1 are no matrix of a law.
/// let wrong = mw::MultivariateNormal::new([0.0; 2], [[1.0, 2.0], [2.0, 1.0]]);
/// assert_eq!(wrong, Err(Error::NotNormalizable(1)));
/// # Ok::<(), Error>(())
/// ```
///
/// # See also
/// - [`Normal`](super::Normal): one number. [`NormalPair`](super::NormalPair): two independent ones of one deviation.
/// - [`Each`](super::Each): several independent ones of their own deviations.
///
/// # Source
/// N. J. Higham, "Analysis of the Cholesky Decomposition of a Semi-definite Matrix", 1990,
/// <https://eprints.maths.manchester.ac.uk/1193/>. The pivots by shares of variances, and the digits, are this crate's own.
#[doc(alias = "gaussian")]
#[doc(alias = "covariance")]
#[doc(alias = "cholesky")]
#[doc(alias = "mahalanobis")]
#[doc(alias = "correlated")]
#[doc(alias = "noise")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MultivariateNormal<T, const D: usize> {
    mean: [f32; D],
    /// A with Σ = A Aᵀ. The column of a coordinate that others determine is 0.
    factor: Rows<f32, D>,
    /// A⁻¹, and its rounding errors. The row of a coordinate that others determine gives how far it is from what they say.
    inverse: Rows<DoubleWord, D>,
    free: [bool; D],
    /// The density at the mean.
    peak: Scaled,
    tier: PhantomData<T>,
}

impl<T: Tier, const D: usize> MultivariateNormal<T, D> {
    /// The law with this mean and this covariance matrix.
    ///
    /// # Errors
    /// [`Error::Empty`] for D = 0, [`Error::NotFinite`] for NaN or infinity in either, [`Error::Negative`] for a variance below 0,
    /// [`Error::OutOfRange`] for a matrix that is not symmetric, [`Error::NotNormalizable`] for one that is not semi-definite, such
    /// as one with a correlation beyond 1.
    pub fn new(mean: [f32; D], covariance: [[f32; D]; D]) -> Result<Self, Error> {
        if D < 1 {
            return Err(Error::Empty(Error::NO_PLACE));
        }
        for x in &mean {
            finite(*x, 0)?;
        }
        let Factors {
            factor,
            inverse,
            free,
            content,
        } = Factors::new(&covariance)?;
        let peak = free.iter().fold(Scaled::ONE, |peak, free| {
            if *free {
                peak.times(Scaled::of(FRAC_1_SQRT_TAU))
            } else {
                peak
            }
        });
        Ok(Self {
            mean,
            factor,
            inverse,
            free,
            peak: peak.over(content),
            tier: PhantomData,
        })
    }

    /// The mean.
    #[must_use]
    pub const fn mean(&self) -> [f32; D] {
        self.mean
    }

    /// A, with A Aᵀ = Σ. In a row and column for each coordinate; the column of one that is not free is 0.
    #[must_use]
    pub const fn factor(&self) -> &[[f32; D]; D] {
        &self.factor
    }

    /// Which coordinates have randomness of their own. The others follow from these, or have no variance.
    #[must_use]
    pub const fn free(&self) -> [bool; D] {
        self.free
    }

    /// How many coordinates are free: the rank of the covariance matrix, to rounding.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.free.iter().filter(|free| **free).count()
    }

    /// The point μ + A z of standard normal numbers from elsewhere, such as a ziggurat, or of chosen distances from the mean.
    ///
    /// It is finite for |zᵢ| up to 14.5 and any parameters. Numbers of coordinates that are not free do nothing.
    ///
    /// ```
    /// use microwarp::poly as mw;
    /// let pair = mw::MultivariateNormal::new([1.0, 2.0], [[4.0, 2.0], [2.0, 2.0]])?;
    /// assert_eq!(pair.at([1.0, -1.0]), [3.0, 2.0]);
    /// assert_eq!(pair.whiten([3.0, 2.0]), [1.0, -1.0]);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn at(&self, z: [f32; D]) -> [f32; D] {
        let mut point = self.mean;
        for (x, row) in point.iter_mut().zip(&self.factor) {
            let products = row.iter().zip(&z).map(|(a, z)| a * z);
            *x += products.fold(0.0, |sum, product| sum + product);
        }
        point
    }

    /// The standard normal numbers z of a point, each for its coordinate; 0 for those that are not free. Always finite.
    ///
    /// The sum of their squares is the squared distance of Mahalanobis, tᵀΣ⁻¹t with t = x − μ; of samples it is chi-square with
    /// [`rank`](Self::rank) degrees of freedom.
    #[must_use]
    #[inline]
    pub fn whiten(&self, x: [f32; D]) -> [f32; D] {
        let mut z = self.standardised(x).map(|(z, rest)| saturated(z + rest));
        for (z, free) in z.iter_mut().zip(&self.free) {
            if !free {
                *z = 0.0;
            }
        }
        z
    }

    /// The natural logarithm of the density, also where the density itself leaves the range of `f32`. −∞ where the density is 0.
    #[must_use]
    #[inline]
    pub fn ln_pdf(&self, x: [f32; D]) -> f32 {
        let (significand, exponent) = self.peak.parts();
        let twos = exponent as f32;
        match self.exponent(x) {
            None => f32::NEG_INFINITY,
            Some(own) if own.0 > f32::MIN => {
                let peak = plus(times((twos, 0.0), LN_2), (T::ln(significand), 0.0));
                let (sum, rest) = plus(peak, own);
                sum + rest
            }
            Some(_) => f32::MIN,
        }
    }

    /// The rows of the inverse times the distance from the mean.
    #[inline]
    fn standardised(&self, x: [f32; D]) -> [DoubleWord; D] {
        let mut offset = [(0.0, 0.0); D];
        for (to, (x, mean)) in offset.iter_mut().zip(x.iter().zip(&self.mean)) {
            *to = two_sum(*x, -mean);
        }
        self.inverse.each_ref().map(|row| {
            let terms = row.iter().zip(&offset);
            if T::TABLES {
                let products = terms.map(|(a, t)| a.0 * t.0);
                (products.fold(0.0, |sum, product| sum + product), 0.0)
            } else {
                let (sum, rest) = terms.fold((0.0, 0.0), |sum, (a, t)| plus(sum, times(*a, *t)));
                // What cancels leaves a rest that is no longer small beside the sum.
                two_sum(sum, rest)
            }
        })
    }

    /// −|z|²/2 in two parts; nothing off the subspace.
    #[inline]
    fn exponent(&self, x: [f32; D]) -> Option<DoubleWord> {
        if !x.iter().all(|x| x.is_finite()) {
            return None;
        }
        let all = self.standardised(x);
        let mut sum = (0.0, 0.0);
        for (z, free) in all.iter().zip(&self.free) {
            if *free {
                let (square, dropped) = two_product(-0.5 * z.0, z.0);
                sum = plus(sum, (square, dropped - z.0 * z.1));
            }
        }
        if self.free.iter().all(|free| *free) || self.holds(x, all.map(|(z, rest)| z + rest)) {
            // Far out it overflowed, and is not a number where infinities met.
            Some(if sum.0 > f32::MIN {
                sum
            } else {
                (f32::MIN, 0.0)
            })
        } else {
            None
        }
    }

    /// Whether the coordinates that others determine are what those say, to rounding.
    fn holds(&self, x: [f32; D], all: [f32; D]) -> bool {
        let rows = self.inverse.iter().zip(&self.factor).zip(&all);
        rows.zip(&self.free)
            .enumerate()
            .all(|(i, (((inverse, factor), off), free))| {
                let terms = inverse.iter().zip(x.iter().zip(&self.mean));
                let placed = terms.map(|(a, (x, mean))| a.0.abs() * (x.abs() + mean.abs()));
                let own = inverse.get(i).map_or(0.0, |own| own.0);
                let made = factor.iter().zip(&all).map(|(a, z)| (own * a * z).abs());
                let size = placed.chain(made).fold(0.0, |sum, size| sum + size);
                *free || off.abs() <= ROUNDINGS * f32::EPSILON * size && off.is_finite()
            })
    }

    /// The density of an exponent: the peak times its exponential.
    #[inline]
    fn decayed(&self, (exponent, rest): DoubleWord) -> f32 {
        // Beyond this the density underflows with any peak.
        if exponent > -1.0e6 {
            let (twos, power) = nearest_integer(exponent * (LOG2_E.0 + LOG2_E.1));
            let (left, dropped) = plus((exponent, rest), times((-twos, 0.0), LN_2));
            let near = T::exp(left);
            let near = Scaled::of(near + near * dropped).raised(power);
            representable(self.peak.times(near).value())
        } else {
            representable(0.0)
        }
    }

    /// The point of standard normal numbers, and its density by the probabilities beyond them.
    #[inline]
    fn placed(&self, z: [f32; D], tails: [f32; D]) -> ([f32; D], f32) {
        let mut density = self.peak;
        for ((z, tail), free) in z.iter().zip(&tails).zip(&self.free) {
            if *free {
                let (decayed, factor) = density_of_tail(*tail, *z);
                let decayed = Scaled::of(decayed).times(Scaled::of(factor));
                density = density.times(decayed);
            }
        }
        (self.at(z), representable(density.value()))
    }
}

impl<T: Tier, const D: usize> Warp for MultivariateNormal<T, D> {
    type Uniforms = [f32; D];
    type Point = [f32; D];
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[f32; D]>) -> [f32; D] {
        self.at(u.get().map(normal_quantile::<T>))
    }

    #[inline]
    fn sample_words(&self, words: [u32; D]) -> [f32; D] {
        self.at(words.map(|word| normal_quantile_of_word::<T>(1.0, word)))
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<[f32; D]>) -> ([f32; D], f32) {
        let u = u.get();
        self.placed(u.map(normal_quantile::<T>), u.map(tail))
    }

    #[inline]
    fn try_draw_with_pdf<R: rand_core::TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<([f32; D], f32), R::Error> {
        let words = <[f32; D]>::try_words(rng)?;
        let z = words.map(|word| normal_quantile_of_word::<T>(1.0, word));
        Ok(self.placed(z, words.map(|word| folded(word).0)))
    }

    #[inline]
    fn pdf(&self, x: [f32; D]) -> f32 {
        self.exponent(x).map_or(0.0, |own| self.decayed(own))
    }
}

impl<T: Tier, const D: usize> Invert for MultivariateNormal<T, D> {
    #[inline]
    fn invert(&self, x: [f32; D]) -> [f32; D] {
        self.whiten(x).map(|z| {
            into_unit(if z > 0.0 {
                1.0 - T::normal_cdf_lower(-z)
            } else {
                T::normal_cdf_lower(z)
            })
        })
    }
}
