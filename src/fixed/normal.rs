//! The normal distribution, two at a time, by Box and Muller's map.

use super::direction::{PER_ANGLE, Scaled, UNIT, square_of};
use super::grade::{Fine, Grade, Kernels};
use super::kernel::exp::{self, one_minus_small};
use super::kernel::log;
use super::kernel::product::{near, near_signed};
use super::kernel::quotient::ratio;
use super::{Density, Deviate, Uniform};
use crate::error::Error;
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedI32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Two independent normals (Gaussians) of mean 0 and standard deviation 1, by Box and Muller's map.
///
/// A point of the plane: its radius is √(−2 ln(1 − u₁)), its angle u₂ turns.
///
/// # Density
/// e^(−r²/2)/(2π) per unit area, at least 2⁻³².
///
/// # Domain
/// - Point: each coordinate in [−6.661, 6.661].
/// - Uniforms: two words, radius then angle. (0, ·) gives the origin; the farthest point lies at 6.661.
///
/// # Accuracy
/// *Sample* is the distance of the points, *pdf* the absolute error of the density. *Round trip* is the error of the
/// uniforms after `sample` and `invert`, of the second as a distance along the circle of the radius.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 6.9e-6 | 6.0e-4 | 4.5e-6 | proven |
/// | sample, rms | 5.0e-7 | 9.7e-5 | 6.6e-7 | found |
/// | sample, mean | 2.6e-7 | -7.5e-5 | -1.4e-7 | found |
/// | pdf | 1.6e-7 | 1.4e-5 | 2.1e-8 | found |
/// | round trip | 1.5e-6 | 9.4e-5 | 1.2e-6 | found |
///
/// The largest error of a sample is proven for all pairs of words: see `docs/proofs.md`.
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed StandardNormalPair -->251 instructions and 508 bytes of code on an M0, 124 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::U0F32;
/// use microwarp::{Invert, Warp, fixed as mw};
/// let noise = mw::StandardNormalPair::new();
/// let [x, y] = noise.sample([0.864_664_7_f64, 0.5].map(U0F32::from_num));
/// assert!((x.to_num::<f64>() + 2.0).abs() < 1e-6 && y == 0);
/// ```
///
/// # See also
/// - [`NormalPair`] has any mean and standard deviation.
/// - [`warp::NormalPair`](crate::warp::NormalPair) is the pair of the float tiers, and
///   [`rejection::ZigguratStandardNormal`](crate::rejection::ZigguratStandardNormal) draws single normals in `f32`.
///
/// # Source
/// G. E. P. Box and M. E. Muller, "A Note on the Generation of Random Normal Deviates", 1958,
/// <https://doi.org/10.1214/aoms/1177706645>.
#[doc(alias = "gaussian")]
#[doc(alias = "normal")]
#[doc(alias = "box_muller")]
#[doc(alias = "randn")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StandardNormalPair<G = Fine>(PhantomData<G>);

impl<G: Grade> StandardNormalPair<G> {
    /// Two normals of mean 0 and standard deviation 1.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// √(−2 ln(1 − u)) in Q29, which is an eighth of it in Q32.
#[inline]
pub(super) fn radius<G: Kernels>(u: u32) -> u32 {
    // Read in Q32, the logarithm in Q27 is the square of an eighth of the radius. Near the centre, where the root is
    // steep, it has 12 more bits.
    let (square, half_of_them) = if u < log::SMALL {
        (log::small(u), 6)
    } else {
        (G::log(u), 0)
    };
    G::root(square) >> half_of_them
}

/// The point at this distance in the direction of a phase. No grade uses a shorter product here: most radii are far
/// below the largest, and would keep few digits.
#[inline]
pub(super) fn around<G: Kernels>(radius: u32, phase: u32) -> [i32; 2] {
    let (sin, cos) = G::sincos(phase);
    [near_signed(radius, cos), near_signed(radius, sin)]
}

/// e^(−r²/2) of r² in Q54.
#[inline]
pub(super) fn bell<G: Kernels>(square: u64) -> u32 {
    G::exp(u32::try_from(square >> 28).unwrap_or(u32::MAX))
}

/// 1 − e^(−r²/2) of r² in Q54.
#[inline]
pub(super) fn outside<G: Kernels>(square: u64) -> u32 {
    let half = u32::try_from(square >> 28).unwrap_or(u32::MAX);
    if half < exp::SMALL {
        one_minus_small((square >> 21) as u32, 34) >> 2
    } else {
        !G::exp(half)
    }
}

impl<G: Grade> Warp for StandardNormalPair<G> {
    type Uniforms = [Uniform; 2];
    type Point = [Deviate; 2];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [Deviate; 2] {
        let [u1, u2] = u.get().map(Uniform::to_bits);
        around::<G>(radius::<G>(u1), u2).map(Deviate::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [Deviate; 2]) -> Density {
        let [x, y] = point.map(|c| c.to_bits().unsigned_abs());
        PER_ANGLE.density(bell::<G>(square_of([x, y])))
    }
}

impl<G: Grade> Invert for StandardNormalPair<G> {
    #[inline]
    fn invert(&self, point: [Deviate; 2]) -> [Uniform; 2] {
        let [x, y] = point.map(Deviate::to_bits);
        let square = square_of([x.unsigned_abs(), y.unsigned_abs()]);
        [outside::<G>(square), G::angle(y, x)].map(Uniform::from_bits)
    }
}

/// Two independent normals (Gaussians) with a mean point and a common standard deviation, by Box and Muller's map.
///
/// The point of a [`StandardNormalPair`] times the standard deviation σ, rounded to the format's step.
///
/// # Density
/// e^(−r²/2σ²)/(2πσ²) per unit area, at least 2⁻³². For σ above 2.2·10⁴ it is 2⁻³² everywhere.
///
/// # Domain
/// - Point: up to 6.661σ from the mean point.
/// - Uniforms: two words, radius then angle. (0, ·) gives the mean point itself.
/// - Parameters: mean point and σ > 0 in one signed format of 32 bits, in which the mean and 6.67σ fit.
///
/// # Accuracy
/// *Sample* is relative to σ, beyond half a step of the format in each coordinate. *Pdf* is relative to the largest
/// density, beyond a step of 2⁻³². *Round trip* is that of [`StandardNormalPair`]. σ is n steps of the format.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 8.4e-6 | 7.8e-4 | 5.8e-6 | found |
/// | pdf | 9.8e-7 | 8.4e-5 | 1.4e-7 | found |
/// | round trip | 1.4e-6 + 2.7/n | 9.4e-5 + 2.8/n | 1.2e-6 + 2.8/n | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed NormalPair -->272 instructions and 556 bytes of code on an M0, 131 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{I16F16, U0F32};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let noise = mw::NormalPair::new([100, -20].map(I16F16::from_num), I16F16::from_num(5))?;
/// let [x, y] = noise.sample([0.864_664_7_f64, 0.5].map(U0F32::from_num));
/// assert!((x.to_num::<f64>() - 90.0).abs() < 3e-5 && y == -20);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`StandardNormalPair`] has mean 0 and standard deviation 1, at lower cost.
/// - [`warp::NormalPair`](crate::warp::NormalPair) is the pair of the float tiers.
///
/// # Source
/// G. E. P. Box and M. E. Muller, "A Note on the Generation of Random Normal Deviates", 1958,
/// <https://doi.org/10.1214/aoms/1177706645>.
#[doc(alias = "gaussian")]
#[doc(alias = "normal")]
#[doc(alias = "box_muller")]
#[doc(alias = "noise")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NormalPair<Frac, G = Fine> {
    mean: [i32; 2],
    /// The standard deviation, shifted until its first bit is set. Products with it are 2⁵ too small.
    std_dev: u32,
    shift: u32,
    /// The density at the mean point.
    peak: Scaled,
    format: PhantomData<(Frac, G)>,
}

impl<Frac: LeEqU32, G: Grade> NormalPair<Frac, G> {
    /// Normals about the given mean point with the given standard deviation in each coordinate.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a standard deviation of 0 or less; [`Error::TooLarge`] for 1/16 of the format's range
    /// or more, or if the mean and 6.67 deviations overflow the format; [`Error::Empty`] if the density overflows,
    /// for a standard deviation below 6.1e-6.
    pub const fn new(mean: [FixedI32<Frac>; 2], std_dev: FixedI32<Frac>) -> Result<Self, Error> {
        let [x, y] = mean;
        let (x, y, std_dev) = (x.to_bits(), y.to_bits(), std_dev.to_bits());
        if std_dev <= 0 {
            return Err(Error::NotPositive(1));
        }
        // 6.67 standard deviations, and a step for rounding.
        let reach = ((std_dev as i64 * 427) >> 6) + 1;
        let room = i32::MAX as i64 - reach;
        if std_dev >= 1 << 27 || x.unsigned_abs() as i64 > room || y.unsigned_abs() as i64 > room {
            return Err(Error::TooLarge(1));
        }
        let shift = std_dev.leading_zeros();
        let inverse = UNIT.over(Scaled::of(std_dev as u64, Frac::I32));
        let peak = inverse.times(inverse).times(PER_ANGLE);
        let peak = Scaled::normal(peak.mantissa, peak.exponent);
        if peak.exponent < -32 {
            return Err(Error::Empty(1));
        }
        Ok(Self {
            mean: [x, y],
            std_dev: (std_dev as u32) << shift,
            shift: shift - 5,
            peak,
            format: PhantomData,
        })
    }

    /// The mean point.
    #[must_use]
    pub const fn mean(&self) -> [FixedI32<Frac>; 2] {
        let [x, y] = self.mean;
        [FixedI32::from_bits(x), FixedI32::from_bits(y)]
    }

    /// The standard deviation of each coordinate.
    #[must_use]
    pub const fn std_dev(&self) -> FixedI32<Frac> {
        FixedI32::from_bits((self.std_dev >> (self.shift + 5)) as i32)
    }

    /// The distances of a point from the mean in each coordinate, in standard deviations (Q27) and at most 16.
    #[inline]
    fn standardised(&self, point: [FixedI32<Frac>; 2]) -> [u32; 2] {
        let ([x, y], [mx, my]) = (point.map(FixedI32::to_bits), self.mean);
        let std_dev = self.std_dev >> (self.shift + 5);
        [x.abs_diff(mx), y.abs_diff(my)]
            .map(|c| u32::try_from(ratio(c, std_dev) >> 5).map_or(1 << 31, |c| c.min(1 << 31)))
    }
}

impl<Frac: LeEqU32, G: Grade> Warp for NormalPair<Frac, G> {
    type Uniforms = [Uniform; 2];
    type Point = [FixedI32<Frac>; 2];
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<[Uniform; 2]>) -> [FixedI32<Frac>; 2] {
        let ([u1, u2], [mx, my]) = (u.get().map(Uniform::to_bits), self.mean);
        let [x, y] = around::<G>(near(radius::<G>(u1), self.std_dev), u2);
        let half = (1 << self.shift) >> 1;
        [
            mx + ((x + half) >> self.shift),
            my + ((y + half) >> self.shift),
        ]
        .map(FixedI32::from_bits)
    }

    #[inline]
    fn pdf(&self, point: [FixedI32<Frac>; 2]) -> Density {
        let square = square_of(self.standardised(point));
        self.peak.density(bell::<G>(square))
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for NormalPair<Frac, G> {
    #[inline]
    fn invert(&self, point: [FixedI32<Frac>; 2]) -> [Uniform; 2] {
        let square = square_of(self.standardised(point));
        let ([x, y], [mx, my]) = (point.map(FixedI32::to_bits), self.mean);
        // No sample has a difference that saturates.
        let angle = G::angle(y.saturating_sub(my), x.saturating_sub(mx));
        [outside::<G>(square), angle].map(Uniform::from_bits)
    }
}

#[cfg(feature = "defmt")]
impl<Frac, G> defmt::Format for NormalPair<Frac, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        let [x, y] = self.mean;
        let std_dev = self.std_dev >> (self.shift + 5);
        defmt::write!(
            f,
            "NormalPair {{ mean: [{=i32}, {=i32}], std_dev: {=u32} }}",
            x,
            y,
            std_dev
        );
    }
}
