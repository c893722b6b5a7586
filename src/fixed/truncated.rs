//! The exponential distribution truncated to an interval from 0.

use super::direction::{ONE, Scaled, UNIT};
use super::exponential::{in_means, mean_of, of_means, rate_of};
use super::grade::{Fine, Grade};
use super::kernel::product::{high, near, near_signed, square};
use super::kernel::quotient::{quotient, ratio};
use super::{Density, Uniform};
use crate::error::{Error, tried};
use crate::uniform::Canonical;
use crate::warp::{Invert, Warp};
use ::fixed::FixedU32;
use ::fixed::types::extra::LeEqU32;
use core::marker::PhantomData;

/// Exponential, truncated to an interval from 0: in proportion to e^(−x/mean) on [0, length).
///
/// With z = length/mean, x = −ln(1 − u(1 − e⁻ᶻ)) means. Where z is small (below 0.21, in grade
/// [`Coarse`](super::Coarse) below 0.49), four terms of the series of that keep the digits that the logarithm would lose:
/// length·u(1 − (1 − u)z/2 (1 − z/3 ((1 − 2u) − z/4 (1 − 6u(1 − u))))). For a long mean the limit is the uniform
/// distribution.
///
/// # Density
/// e^(−x/mean)/(mean (1 − e⁻ᶻ)) on [0, length), at least 2⁻³²; 0 elsewhere.
///
/// # Domain
/// - Point: [0, length), in steps of the format, cut to the step below.
/// - Uniforms: one word.
/// - Parameters: mean and length in one unsigned format of 32 bits; or the rate in `U32F32`, and the length. Here the
///   density always falls; the float tiers take rates of either sign.
///
/// # Accuracy
/// *Sample* is relative to the smaller of mean and length, beyond a word of the uniform and a step of the format. *Pdf* is
/// relative to the largest density, beyond a step of 2⁻³². *Round trip* is the error of the uniform after `sample` and
/// `invert`. The mean times 1 − e⁻ᶻ is n steps of the format.
///
/// | error | fine | coarse | compact | kind |
/// |---|--:|--:|--:|---|
/// | sample, max | 2.8e-6 | 8.2e-5 | 2.8e-6 | found |
/// | sample, rms | 4.8e-7 | 1.7e-5 | 4.4e-7 | found |
/// | sample, mean | 2.4e-7 | 9.2e-6 | 1.1e-7 | found |
/// | pdf | 9.8e-7 | 8.4e-5 | 1.4e-7 | found |
/// | round trip | 5.9e-6 + 1.4/n | 2.4e-4 + 1.4/n | 3.2e-6 + 1.4/n | found |
///
/// # Cost
/// One draw in `fine`, PCG32 included, takes <!-- figure: cost fixed TruncatedExponential -->148 instructions and 364 bytes of code on an M0, 59 instructions on an M3<!-- -->.
///
/// # Examples
/// ```
/// use fixed::types::{U0F32, U16F16};
/// use microwarp::{Invert, Warp, fixed as mw};
/// let segment = mw::TruncatedExponential::from_mean(U16F16::from_num(10), U16F16::from_num(4))?;
/// let middle = segment.sample(U0F32::from_num(0.5)).to_num::<f64>();
/// assert!((middle - 1.801_32).abs() < 2e-5);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Exponential`](super::Exponential) has no end.
/// - [`warp::TruncatedExponential`](crate::warp::TruncatedExponential) is the one of the float tiers.
///
/// # Source
/// C. Kulla and M. Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media", 2012,
/// <https://doi.org/10.1111/j.1467-8659.2012.03148.x>.
#[doc(alias = "bounded_exponential")]
#[doc(alias = "free_path")]
#[doc(alias = "fog")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TruncatedExponential<Frac, G = Fine> {
    mean: u32,
    length: u32,
    map: Map,
    /// The density at 0.
    height: Scaled,
    format: PhantomData<(Frac, G)>,
}

/// How samples are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Map {
    /// For small z: z, z/3 and (1 − e⁻ᶻ)/z, all in Q32.
    Series { z: u32, third: u32, mass: u64 },
    /// For other z: the word above e⁻ᶻ, so that the product with u < 1, which is cut, is off by less than a word; and in
    /// Q27 the largest multiple of the mean below the length.
    Logarithm { end: u32, most: u32 },
}

impl<Frac: LeEqU32, G: Grade> TruncatedExponential<Frac, G> {
    /// In proportion to e^(−x/mean) on [0, length).
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a mean or a length of 0.
    pub const fn from_mean(mean: FixedU32<Frac>, length: FixedU32<Frac>) -> Result<Self, Error> {
        let (mean, length) = (mean.to_bits(), length.to_bits());
        if mean == 0 || length == 0 {
            return Err(Error::NotPositive(if mean == 0 { 0 } else { 1 }));
        }
        let z = ratio(length, mean);
        // The mass is the reciprocal of the height: the part of the length, or of the mean, that truncation leaves.
        let (map, mass) = if z < G::SERIES {
            let mass = mean_density(z);
            let z = z as u32;
            let third = near(z, 0x5555_5556);
            (Map::Series { z, third, mass }, length as u64 * mass)
        } else {
            let end = exponential(z);
            let mass = mean as u64 * ((1 << 32) - end as u64);
            let (end, most) = (end + 1, most(z, length, mean));
            (Map::Logarithm { end, most }, mass)
        };
        Ok(Self {
            mean,
            length,
            map,
            height: UNIT.over(Scaled::of(mass, 32 + Frac::I32)),
            format: PhantomData,
        })
    }

    /// In proportion to e^(−rate·x) on [0, length).
    ///
    /// The mean is 1/`rate`, rounded to the nearest step of the format of the points.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a rate or a length of 0, [`Error::Empty`] for a mean that rounds to 0 and for any
    /// rate above 2³¹, [`Error::TooLarge`] for a mean that the format does not hold.
    pub const fn from_rate(rate: Density, length: FixedU32<Frac>) -> Result<Self, Error> {
        let mean = tried!(mean_of(rate));
        Self::from_mean(mean, length)
    }

    /// The mean of the exponential distribution before it was truncated.
    #[must_use]
    pub const fn mean(&self) -> FixedU32<Frac> {
        FixedU32::from_bits(self.mean)
    }

    /// The rate: 1/mean, rounded to the nearest step of 2⁻³², or the largest [`Density`] if it does not fit.
    #[must_use]
    pub const fn rate(&self) -> Density {
        rate_of(self.mean())
    }

    /// The length of the interval.
    #[must_use]
    pub const fn length(&self) -> FixedU32<Frac> {
        FixedU32::from_bits(self.length)
    }
}

/// The largest word in Q27 whose product with the mean is below the length.
const fn most(z: u64, length: u32, mean: u32) -> u32 {
    let most = z >> 5;
    if most > u32::MAX as u64 {
        return u32::MAX;
    }
    // The cut made z smaller, unless it was exact.
    (most - (most * mean as u64 == (length as u64) << 27) as u64) as u32
}

/// 1 minus a power series with alternating signs at z < 1, in Q32. All partial results are positive.
pub(super) const fn alternating(z: u64, terms: &[u32]) -> u64 {
    let (mut sum, mut rest) = (0, terms);
    while let Some((&term, others)) = rest.split_last() {
        sum = term as u64 - ((z * sum + (1 << 31)) >> 32);
        rest = others;
    }
    (1 << 32) - ((z * sum + (1 << 31)) >> 32)
}

/// 1/k! from k = 2 on, in Q32.
const FACTORIALS: [u32; 12] = [
    2_147_483_648,
    715_827_883,
    178_956_971,
    35_791_394,
    5_965_232,
    852_176,
    106_522,
    11_836,
    1_184,
    108,
    9,
    1,
];

/// (1 − e⁻ᶻ)/z of z below 1, both in Q32: the mean of the density relative to its value at 0.
const fn mean_density(z: u64) -> u64 {
    alternating(z, &FACTORIALS)
}

/// e⁻ᶻ of z ≥ 0.2, both in Q32, cut.
const fn exponential(z: u64) -> u32 {
    /// ln 2 in Q32.
    const LN_2: u64 = 2_977_044_472;
    let (mut rest, mut halvings) = (z, 0);
    while rest >= LN_2 {
        if halvings == 32 {
            return 0;
        }
        rest -= LN_2;
        halvings += 1;
    }
    // 1 − x (1 − x/2 + x²/6 − …).
    let power = (1 << 32) - ((rest * mean_density(rest)) >> 32);
    (power >> halvings) as u32
}

impl<Frac: LeEqU32, G: Grade> Warp for TruncatedExponential<Frac, G> {
    type Uniforms = Uniform;
    type Point = FixedU32<Frac>;
    type Density = Density;

    #[inline]
    fn sample_canonical(&self, u: Canonical<Uniform>) -> FixedU32<Frac> {
        let u = u.get().to_bits();
        FixedU32::from_bits(match self.map {
            Map::Series { z, third, .. } => high(self.length, series(u, z, third)),
            Map::Logarithm { end, most } => {
                let log = G::log(u - high(u, end));
                of_means(log.min(most), self.mean)
            }
        })
    }

    #[inline]
    fn pdf(&self, x: FixedU32<Frac>) -> Density {
        let x = x.to_bits();
        if x < self.length {
            let means = in_means(x, self.mean);
            self.height.density(G::exp(means.to_bits()))
        } else {
            Density::ZERO
        }
    }
}

impl<Frac: LeEqU32, G: Grade> Invert for TruncatedExponential<Frac, G> {
    #[inline]
    fn invert(&self, x: FixedU32<Frac>) -> Uniform {
        let x = x.to_bits().min(self.length - 1);
        Uniform::from_bits(match self.map {
            Map::Series { mass, .. } => {
                // The share of the length, and by how much the mean density up to x exceeds that of the whole.
                let share = quotient(x, self.length);
                let more = mean_density(ratio(x, self.mean)).saturating_sub(mass);
                // For a mass of 1 the excess is 0, and the divisor does not matter.
                share.saturating_add(high(share, quotient(more as u32, mass as u32)))
            }
            Map::Logarithm { end, .. } => {
                let below = G::exp_m1_neg(in_means(x, self.mean)).to_bits();
                let all = 1_u32.wrapping_sub(end);
                match all {
                    0 => below,
                    _ if below < all => quotient(below, all),
                    _ => u32::MAX,
                }
            }
        })
    }
}

/// The series of the map, in Q32: at most u, hence below 1.
#[inline]
fn series(u: u32, z: u32, third: u32) -> u32 {
    let spread = u - square(u);
    // z u (1 − u)/2 in Q34, and its factor in Q30.
    let bend = near(spread, z) << 1;
    let fourth = near_signed(z, ONE - (6 * (spread >> 2)) as i32) >> 2;
    let factor = ONE - near_signed(third, ONE - (u >> 1) as i32 - fourth);
    u - near_signed(bend, factor) as u32
}

#[cfg(feature = "defmt")]
impl<Frac, G> defmt::Format for TruncatedExponential<Frac, G> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(
            f,
            "TruncatedExponential {{ mean: {=u32}, length: {=u32} }}",
            self.mean,
            self.length
        );
    }
}
