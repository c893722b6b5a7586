//! The normal distribution of several correlated numbers, semi-definite too.

mod factor;
mod law;

use self::law::Law;
use super::bits::{bits, of_bits};
use super::grade::{Fine, Grade};
use super::{Coordinate, Density, Deviate, Uniform};
use crate::error::{Error, tried};
use crate::uniform::{Canonical, Uniforms};
use crate::warp::{Invert, Warp};
use ::fixed::FixedI32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

mod sealed {
    use super::{Uniform, Uniforms};

    /// As many numbers, made of words two by two.
    #[diagnostic::on_unimplemented(message = "a multivariate normal has up to 16 dimensions here")]
    pub trait InPairs {
        /// An even number of words.
        type Words: Uniforms + AsRef<[Uniform]> + AsMut<[Uniform]>;
        const ZEROS: Self::Words;
    }

    macro_rules! in_pairs {
        ($($words:literal of $($numbers:literal)*;)*) => {$($(
            impl InPairs for [Uniform; $numbers] {
                type Words = [Uniform; $words];
                const ZEROS: [Uniform; $words] = [Uniform::ZERO; $words];
            }
        )*)*};
    }
    in_pairs! { 0 of 0; 2 of 1 2; 4 of 3 4; 6 of 5 6; 8 of 7 8; 10 of 9 10; 12 of 11 12; 14 of 13 14; 16 of 15 16; }
}
use sealed::InPairs;

/// Several correlated normal numbers (Gaussians), of deviations and correlations, which may be singular: the noise of a robot's
/// pose, or of the axes of a sensor.
///
/// xᵢ = μᵢ + σᵢ Σⱼ Lᵢⱼ zⱼ with L Lᵀ = C, the matrix of correlations, where the z are standard normals, two by two by Box and
/// Muller's map. The matrix is taken apart with pivots in 64 bits, when the law is made: in a constant by the compiler. A draw
/// divides nothing.
///
/// A coordinate that follows from others, or whose deviation is 0, has no randomness of its own. [`free`](Self::free) tells which
/// coordinates do. [`whiten`](Self::whiten) is the way back from a point to z, whose sum of squares is Mahalanobis' distance
/// squared.
///
/// # Density
/// e^(−|z|²/2)/∏ σᵢ Lᵢᵢ √2π over the free coordinates, with respect to these, where the other coordinates are what the free ones
/// say to the step of the format; 0 elsewhere. On the former it is at least 2⁻³², and what exceeds the largest [`Density`] counts
/// as that: in many dimensions both come soon.
///
/// # Domain
/// - Point: each coordinate up to 6.67·√p·σᵢ from its mean, of p pairs of words.
/// - Uniforms: D words, of an odd D one more: radius and angle for every two coordinates. The second normal of the last two does
///   nothing if D is odd, nor do those of coordinates that are not free. Words of 0 give the means themselves.
/// - Parameters: means and deviations σ ≥ 0 in one signed format of 32 bits, in which each mean and 6.67·√p·σᵢ fit. A symmetric
///   matrix of correlations, exactly 1 on its diagonal and semi-definite to D·7.5e-9. What is left of a variance, given the others,
///   counts as 0 up to D·1.9e-9 of it. The correlations of a coordinate whose deviation is 0 do nothing. D is 1 to 16.
/// - `invert` returns words whose sample is the point, to rounding: 0 for what does nothing.
///
/// # Accuracy
/// These are for up to four dimensions. *Sample* is the error of a coordinate relative to its σ, beyond half a step of the format.
/// *Pdf* is relative to the largest density, beyond a step of 2⁻³². *Round trip* is the error of the words after `sample` and
/// `invert`, where both normals of two words are of free coordinates; of the second word as a distance along the circle of the
/// radius. d is the number of dimensions, n the smallest σᵢ of a free coordinate in steps, and k the smallest such Lᵢᵢ: the root of
/// what the others leave of a variance.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 5.7e-6*sqrt(d + 1) | 5.5e-4*sqrt(d + 1) | 3.9e-6*sqrt(d + 1) | found |
/// | pdf | 9.7e-7 + 1.2e-8*d/k | 8.4e-5 + 1.2e-8*d/k | 1.2e-7 + 1.2e-8*d/k | found |
/// | round trip | 2e-6 + (1.9/n + 2.6e-7)*d/k | 9.4e-5 + (1.15/n + 1.6e-7)*d/k | 1.9e-6 + (2.4/n + 3.3e-7)*d/k | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed MultivariateNormal -->647 instructions and 748 bytes of code on an M0, 289 instructions on an M3<!-- -->. A law has 4 D² + 14 D + 9
/// bytes, rounded up to whole words.
///
/// # Examples
/// ```
/// use fixed::types::{I2F30, I16F16, U0F32, extra::U16};
/// use microwarp::{Warp, constant, fixed as mw};
/// // The error of a robot's pose: x and y in metres, the heading in radians. It slides with its heading.
/// const ERROR: mw::MultivariateNormal<U16, 3> = constant!(mw::MultivariateNormal::new(
///     [I16F16::lit("0"), I16F16::lit("0"), I16F16::lit("0.1")],
///     [I16F16::lit("0.2"), I16F16::lit("0.1"), I16F16::lit("0.04")],
///     [
///         [I2F30::lit("1"), I2F30::lit("0"), I2F30::lit("0")],
///         [I2F30::lit("0"), I2F30::lit("1"), I2F30::lit("0.5")],
///         [I2F30::lit("0"), I2F30::lit("0.5"), I2F30::lit("1")],
///     ],
/// ));
/// let pose = ERROR.sample([0.0, 0.0, 0.864_664_7, 0.5].map(U0F32::from_num::<f64>));
/// assert_eq!(pose[0..2], [0.0, 0.0]);
/// // Two deviations of what y leaves of the heading, below its mean.
/// assert!((pose[2].to_num::<f64>() - 0.030_7).abs() < 1e-4);
/// let [_, _, turned] = ERROR.whiten(pose);
/// assert!((turned.to_num::<f64>() + 2.0).abs() < 1e-3);
/// ```
///
/// # See also
/// - [`NormalPair`](super::NormalPair): two independent numbers of one deviation, at a lower cost.
/// - [`warp::MultivariateNormal`](crate::warp::MultivariateNormal) is the one of the float tiers, of a covariance matrix and of any
///   dimension; each number increases with a uniform of its own there.
///
/// # Source
/// N. J. Higham, "Analysis of the Cholesky Decomposition of a Semi-definite Matrix", 1990,
/// <https://eprints.maths.manchester.ac.uk/1193/>; G. E. P. Box and M. E. Muller, "A Note on the Generation of Random Normal
/// Deviates", 1958, <https://doi.org/10.1214/aoms/1177706645>.
#[doc(alias = "gaussian")]
#[doc(alias = "covariance")]
#[doc(alias = "cholesky")]
#[doc(alias = "mahalanobis")]
#[doc(alias = "correlated")]
#[doc(alias = "noise")]
#[doc(alias = "imu")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MultivariateNormal<Frac, const D: usize, G = Fine> {
    law: Law<D>,
    format: PhantomData<(Frac, G)>,
}

impl<Frac: LeEqU32, const D: usize, G: Grade> MultivariateNormal<Frac, D, G>
where
    [Uniform; D]: InPairs,
{
    /// The law with these means, standard deviations and correlations.
    ///
    /// # Errors
    /// [`Error::Empty`] for D = 0. [`Error::Negative`] for a deviation below 0, [`Error::TooLarge`] for one of 1/32 of the format's
    /// range or more, or if a mean and 6.67·√p·σᵢ overflow the format, of p pairs of words. [`Error::OutOfRange`] for a
    /// correlation beyond 1, one of a coordinate with itself that is not 1, or a matrix that is not symmetric;
    /// [`Error::NotNormalizable`] for one that is not semi-definite.
    pub const fn new(
        means: [FixedI32<Frac>; D],
        deviations: [FixedI32<Frac>; D],
        correlations: [[Coordinate; D]; D],
    ) -> Result<Self, Error> {
        let (means, deviations) = (bits(&means), bits(&deviations));
        let law = tried!(Law::new(means, deviations, &correlations, Frac::I32));
        Ok(Self {
            law,
            format: PhantomData,
        })
    }

    /// The means.
    #[must_use]
    pub const fn means(&self) -> [FixedI32<Frac>; D] {
        of_bits(&self.law.means)
    }

    /// The standard deviations.
    #[must_use]
    pub const fn deviations(&self) -> [FixedI32<Frac>; D] {
        of_bits(&self.law.steps())
    }

    /// L, with L Lᵀ = C, the matrix of correlations. In a row and column for each coordinate; the column of one that is not free is
    /// 0, and so is the row of one whose deviation is 0.
    #[must_use]
    pub const fn factor(&self) -> [[Coordinate; D]; D] {
        self.law.factor()
    }

    /// Which coordinates have randomness of their own. The others follow from these, or have no deviation.
    #[must_use]
    pub const fn free(&self) -> [bool; D] {
        self.law.free()
    }

    /// How many coordinates are free: the rank of the covariance matrix, to rounding.
    #[must_use]
    pub const fn rank(&self) -> usize {
        self.law.rank as usize
    }

    /// The standard normal numbers z of a point, each for its coordinate and at most 16; 0 for those that are not free.
    ///
    /// The sum of their squares is the squared distance of Mahalanobis; of samples it is chi-square with [`rank`](Self::rank)
    /// degrees of freedom.
    #[must_use]
    #[inline]
    pub fn whiten(&self, point: [FixedI32<Frac>; D]) -> [Deviate; D] {
        of_bits(&self.law.standardised(&bits(&point)).0)
    }
}

impl<Frac: LeEqU32, const D: usize, G: Grade> Warp for MultivariateNormal<Frac, D, G>
where
    [Uniform; D]: InPairs,
{
    type Uniforms = <[Uniform; D] as InPairs>::Words;
    type Point = [FixedI32<Frac>; D];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Self::Uniforms>) -> [FixedI32<Frac>; D] {
        of_bits(&self.law.point::<G>(u.get().as_ref()))
    }

    #[inline]
    fn pdf(&self, point: [FixedI32<Frac>; D]) -> Density {
        self.law.pdf::<G>(&bits(&point))
    }
}

impl<Frac: LeEqU32, const D: usize, G: Grade> Invert for MultivariateNormal<Frac, D, G>
where
    [Uniform; D]: InPairs,
{
    #[inline]
    fn invert(&self, point: [FixedI32<Frac>; D]) -> Self::Uniforms {
        let mut words = <[Uniform; D]>::ZEROS;
        self.law.words::<G>(&bits(&point), words.as_mut());
        words
    }
}

#[cfg(feature = "defmt")]
impl<Frac, const D: usize, G> defmt::Format for MultivariateNormal<Frac, D, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "MultivariateNormal {{ means: {}, deviations: {} >> {}, factor: {} }}",
            self.law.means,
            self.law.deviations,
            self.law.shifts,
            self.law.factor
        );
    }
}
