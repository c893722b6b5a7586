//! The normal distribution of several correlated numbers, semi-definite too.

mod factor;

use self::factor::{Factors, Rows, at, entry, put};
use super::direction::{Scaled, UNIT, square_of};
use super::grade::{Fine, Grade};
use super::kernel::product::near_of_signed;
use super::normal::{around, bell, outside, radius};
use super::{Coordinate, Density, Deviate, Uniform};
use crate::error::{Error, tried};
use crate::num::division::{fraction, scaled};
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
    means: [i32; D],
    /// σ, shifted until 31 bits are set, and by how much. 0 stays.
    deviations: [u32; D],
    shifts: [u8; D],
    /// Rows of L times these deviations. Products with numbers in Q27 are 2⁵ too small.
    factor: Rows<i32, D>,
    /// How many steps a coordinate that is not free may be off what the free ones say.
    slack: [u32; D],
    /// First the free coordinates, in the order in which each follows from those before it, then the others.
    order: [u8; D],
    rank: u8,
    /// The density at the mean.
    peak: Scaled,
    format: PhantomData<(Frac, G)>,
}

/// 1/√2π.
const PER_ROOT_TAU: Scaled = Scaled::normal(1_713_444_047, 0);

/// How far points lie from their means, at most, of a deviation in steps.
const fn reach(deviation: i32, numbers: usize) -> i64 {
    /// 6.67², of each pair.
    const SQUARE: u64 = 2_915_625;
    // In Q32; a step for rounding.
    let squares = (((numbers as u64 + 1) >> 1) * SQUARE) << 16;
    ((deviation as i64 * (squares.isqrt() as i64 + 1)) >> 16) + 1
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
        if D < 1 {
            return Err(Error::Empty(Error::NO_PLACE));
        }
        let mut law = Self {
            means: [0; D],
            deviations: [0; D],
            shifts: [5; D],
            factor: [[0; D]; D],
            slack: [0; D],
            order: [0; D],
            rank: 0,
            peak: UNIT,
            format: PhantomData,
        };
        let (mut varies, mut i) = ([false; D], 0);
        while i < D {
            let mean = at(&means, i, FixedI32::ZERO).to_bits();
            let deviation = at(&deviations, i, FixedI32::ZERO).to_bits();
            if deviation < 0 {
                return Err(Error::Negative(1));
            }
            let room = i32::MAX as i64 - reach(deviation, D);
            if deviation >= 1 << 26 || (deviation > 0 && mean.unsigned_abs() as i64 > room) {
                return Err(Error::TooLarge(1));
            }
            put(&mut law.means, i, mean);
            if deviation > 0 {
                let shift = deviation.leading_zeros() - 1;
                put(&mut law.deviations, i, (deviation as u32) << shift);
                put(&mut law.shifts, i, shift as u8);
                put(&mut varies, i, true);
            }
            i += 1;
        }
        let factors = tried!(Factors::new(&correlations, varies));
        law.order = factors.order;
        law.rank = factors.rank as u8;
        law.scale(&factors);
        law.allow(&factors);
        Ok(law)
    }

    /// Takes over the factor, in the units of the deviations, and the density at the mean.
    const fn scale(&mut self, factors: &Factors<D>) {
        let (mut peak, mut i) = (UNIT, 0);
        while i < D {
            let (mut row, mut j) = ([0; D], 0);
            let own = at(&self.deviations, i, 0);
            while j < D {
                let part = entry(&factors.factor, i, j);
                // At most 2³¹ · 2³².
                let product = part.unsigned_abs() * own as u64;
                let nearest = (product >> 31).div_ceil(2);
                let most = i32::MAX as u64;
                let magnitude = if nearest < most { nearest } else { most } as i32;
                put(&mut row, j, if part < 0 { -magnitude } else { magnitude });
                j += 1;
            }
            put(&mut self.factor, i, row);
            let (root, digits) = at(&factors.diagonal, i, (0, 0));
            if root > 0 {
                let shift = at(&self.shifts, i, 0) as i32;
                let deviation = Scaled::of(own as u64, Frac::I32 + shift);
                let own = deviation.times(Scaled::of(root as u64, digits));
                let own = Scaled::normal(own.mantissa, own.exponent);
                peak = peak.over(own).times(PER_ROOT_TAU);
                peak = Scaled::normal(peak.mantissa, peak.exponent);
            }
            i += 1;
        }
        // Any larger one exceeds the largest density just so.
        if peak.exponent < -63 {
            peak.exponent = -63;
        }
        self.peak = peak;
    }

    /// What rounding of a point to its steps does to z, in Q32, and to what the free coordinates say of the others.
    const fn allow(&mut self, factors: &Factors<D>) {
        /// What the products of a sample cut, in each.
        const CUT: u128 = 3 << 5;
        let (mut errors, mut place) = ([0_u128; D], 0);
        while place < D {
            let i = at(&self.order, place, 0) as usize;
            let row = at(&self.factor, i, [0; D]);
            let shift = at(&self.shifts, i, 0);
            let (mut off, mut j) = (((1 << shift) + CUT * D as u128) << 32, 0);
            while j < D {
                off += at(&row, j, 0).unsigned_abs() as u128 * at(&errors, j, 0);
                j += 1;
            }
            if place < factors.rank {
                // By the order, what others add is at most three times as much for each of them, so that 2⁹⁰ is out of reach.
                let own = at(&row, i, 1) as u128;
                put(&mut errors, i, scaled(off, own << 90, 90).0 + 1);
            } else if at(&self.deviations, i, 0) > 0 {
                let steps = (off >> 32 >> shift) + 1;
                let most = u32::MAX as u128;
                put(
                    &mut self.slack,
                    i,
                    if steps < most { steps } else { most } as u32,
                );
            }
            place += 1;
        }
    }
}

impl<Frac: LeEqU32, const D: usize, G: Grade> MultivariateNormal<Frac, D, G>
where
    [Uniform; D]: InPairs,
{
    /// The means.
    #[must_use]
    pub const fn means(&self) -> [FixedI32<Frac>; D] {
        let (mut means, mut i) = ([FixedI32::ZERO; D], 0);
        while i < D {
            put(&mut means, i, FixedI32::from_bits(at(&self.means, i, 0)));
            i += 1;
        }
        means
    }

    /// The standard deviations.
    #[must_use]
    pub const fn deviations(&self) -> [FixedI32<Frac>; D] {
        let (mut deviations, mut i) = ([FixedI32::ZERO; D], 0);
        while i < D {
            let deviation = at(&self.deviations, i, 0) >> at(&self.shifts, i, 0);
            put(&mut deviations, i, FixedI32::from_bits(deviation as i32));
            i += 1;
        }
        deviations
    }

    /// L, with L Lᵀ = C, the matrix of correlations. In a row and column for each coordinate; the column of one that is not free is
    /// 0, and so is the row of one whose deviation is 0.
    #[must_use]
    pub const fn factor(&self) -> [[Coordinate; D]; D] {
        let (mut factor, mut i) = ([[Coordinate::ZERO; D]; D], 0);
        while i < D {
            let (mut parts, mut j) = ([Coordinate::ZERO; D], 0);
            let (row, own) = (at(&self.factor, i, [0; D]), at(&self.deviations, i, 0));
            while j < D && own > 0 {
                let part = at(&row, j, 0);
                let twice = scaled(part.unsigned_abs() as u128, own as u128, 31).0 as u64;
                let magnitude = twice.div_ceil(2) as i32;
                let part = if part < 0 { -magnitude } else { magnitude };
                put(&mut parts, j, Coordinate::from_bits(part));
                j += 1;
            }
            put(&mut factor, i, parts);
            i += 1;
        }
        factor
    }

    /// Which coordinates have randomness of their own. The others follow from these, or have no deviation.
    #[must_use]
    pub const fn free(&self) -> [bool; D] {
        let (mut free, mut place) = ([false; D], 0);
        while place < self.rank() {
            put(&mut free, at(&self.order, place, 0) as usize, true);
            place += 1;
        }
        free
    }

    /// How many coordinates are free: the rank of the covariance matrix, to rounding.
    #[must_use]
    pub const fn rank(&self) -> usize {
        self.rank as usize
    }

    /// The standard normal numbers z of a point, each for its coordinate and at most 16; 0 for those that are not free.
    ///
    /// The sum of their squares is the squared distance of Mahalanobis; of samples it is chi-square with [`rank`](Self::rank)
    /// degrees of freedom.
    #[must_use]
    #[inline]
    pub fn whiten(&self, point: [FixedI32<Frac>; D]) -> [Deviate; D] {
        self.standardised(point).0.map(Deviate::from_bits)
    }

    /// z, and whether the coordinates that are not free are what the free ones say.
    #[inline]
    fn standardised(&self, point: [FixedI32<Frac>; D]) -> ([i32; D], bool) {
        let (mut z, mut holds) = ([0; D], true);
        for (place, i) in self.order.iter().enumerate() {
            let i = usize::from(*i);
            let (x, mean) = (
                at(&point, i, FixedI32::ZERO).to_bits(),
                at(&self.means, i, 0),
            );
            let shift = at(&self.shifts, i, 0);
            let (Some(row), Some(slack)) = (self.factor.get(i), self.slack.get(i)) else {
                continue;
            };
            let said = row.iter().zip(&z).fold(0, |sum, (a, z)| {
                sum + ((i64::from(*a) * i64::from(*z)) >> 27)
            });
            let off = ((i64::from(x) - i64::from(mean)) << shift) - said;
            if place < self.rank() {
                put(&mut z, i, quotient(off, at(row, i, 0)));
            } else {
                holds &= off.unsigned_abs() >> shift <= u64::from(*slack);
            }
        }
        (z, holds)
    }
}

/// a/b in Q27 and to the nearest, at most 16, of a positive b.
#[inline]
fn quotient(a: i64, b: i32) -> i32 {
    let (magnitude, most) = (a.unsigned_abs(), u64::from(b.unsigned_abs()) << 4);
    let word = if magnitude < most {
        fraction(magnitude, most).0.div_ceil(2)
    } else {
        1 << 31
    };
    if a < 0 {
        word.wrapping_neg() as i32
    } else {
        word.min(i32::MAX as u32) as i32
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
        let mut z = [0; D];
        let (u, mut numbers) = (u.get(), z.iter_mut());
        // Chunks divide by their length where the code is to be small, and may panic.
        let mut words = u.as_ref().iter();
        while let (Some(u1), Some(u2)) = (words.next(), words.next()) {
            for x in around::<G>(radius::<G>(u1.to_bits()), u2.to_bits()) {
                if let Some(z) = numbers.next() {
                    *z = x;
                }
            }
        }
        let mut point = self.means;
        for ((x, row), shift) in point.iter_mut().zip(&self.factor).zip(&self.shifts) {
            // No sum of the first of them exceeds their lengths' product, either.
            let off = row
                .iter()
                .zip(&z)
                .fold(0, |sum, (a, z)| sum + near_of_signed(*z, *a));
            let shift = shift - 5;
            *x += (off + ((1 << shift) >> 1)) >> shift;
        }
        point.map(FixedI32::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [FixedI32<Frac>; D]) -> Density {
        let (z, holds) = self.standardised(point);
        if holds {
            let square = z.iter().fold(0_u64, |sum, z| {
                sum.saturating_add(square_of([z.unsigned_abs(), 0]))
            });
            self.peak.density(bell::<G>(square))
        } else {
            Density::ZERO
        }
    }
}

impl<Frac: LeEqU32, const D: usize, G: Grade> Invert for MultivariateNormal<Frac, D, G>
where
    [Uniform; D]: InPairs,
{
    #[inline]
    fn invert(&self, point: [FixedI32<Frac>; D]) -> Self::Uniforms {
        let (z, _) = self.standardised(point);
        let mut words = <[Uniform; D]>::ZEROS;
        let (mut numbers, mut places) = (z.into_iter(), words.as_mut().iter_mut());
        while let (Some(u1), Some(u2)) = (places.next(), places.next()) {
            let [x, y] = [numbers.next(), numbers.next()].map(Option::unwrap_or_default);
            let square = square_of([x, y].map(i32::unsigned_abs));
            *u1 = Uniform::from_bits(outside::<G>(square));
            *u2 = Uniform::from_bits(G::angle(y, x));
        }
        words
    }
}

#[cfg(feature = "defmt")]
impl<Frac, const D: usize, G> defmt::Format for MultivariateNormal<Frac, D, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "MultivariateNormal {{ means: {}, deviations: {} >> {}, factor: {} }}",
            self.means,
            self.deviations,
            self.shifts,
            self.factor
        );
    }
}
