//! The normal distribution restricted to an interval, by the hazard beyond the point that is nearest to the mean.

use super::location_scale::{decayed, standardised};
use super::normal::exponent;
use super::{Invert, Warp, drawn_with_pdf};
use crate::error::{Error, finite, positive};
use crate::num::{SMALLEST, Scaled, clamp, folded, into_unit, representable, two_product, two_sum};
use crate::tier::{Tier, hazard_above, scaled_exp};
use crate::uniform::Canonical;
use core::marker::PhantomData;

/// How far from the mean an interval may begin, in standard deviations.
const FARTHEST: f32 = 1.0e18;

/// An upper bound on how far a sample lies from the nearest point, in standard deviations: a normal number is beyond
/// 14.5 with a probability below 2⁻¹⁵⁰.
const REACH: f32 = 14.5;

/// Below this share of the tail its hazard is constant to half a unit in the last place.
const CONSTANT: f32 = 1.0 / 268_435_456.0;

/// Below this distance the logarithm of the hazard's rise would cancel.
const NEAR: f32 = 0.75;

/// 2¹⁰⁰, which keeps small shares of the tail in range, and its logarithm.
const LIFT: f32 = 1_267_650_600_228_229_401_496_703_205_376.0;
const LN_LIFT: f32 = 69.314_72;

/// Normal (Gaussian) with mean μ and standard deviation σ, restricted to an interval [a, b], of which one end may be
/// infinite.
///
/// x = μ + σΦ⁻¹((1 − u)Φ((a − μ)/σ) + uΦ((b − μ)/σ)), increasing with the uniform, except for single steps back between neighbours of
/// the grid by at most 3 ulp of x or of σ, whichever is larger. No two values of Φ are subtracted.
/// Instead x is found by its distance from x₀, the point of the interval nearest to the mean: over that distance the
/// hazard φ/(1 − Φ) has the integral −ln(1 − f), where f is the share of the tail beyond x₀ that lies before x. So the
/// distance keeps its digits however far out the interval lies and however narrow it is.
///
#[cfg_attr(doc, doc = include_str!("../pictures/truncated_normal.html"))]
///
/// # Density
/// e^(−(x−μ)²/2σ²)/(σ√2π(Φ((b − μ)/σ) − Φ((a − μ)/σ))) on [a, b], at least 2⁻¹⁴⁹; else 0.
///
/// # Domain
/// - Point: [a, b]. A point with less than 2⁻¹⁴⁹ of a tail beyond it is not reached.
/// - Uniforms: one. u = 0 counts as 2⁻¹⁴⁹ where there is no lower end, or less than 2⁻¹⁴⁹ of the tail beyond it.
///   Drawing takes all 32 bits of a word, as the middle of their cell.
/// - Parameters: a finite mean, a standard deviation above 0, and finite ends, of which the nearer one is at most 1e18σ
///   from the mean. Beyond an infinite end no sample may overflow.
///
/// # Accuracy
/// *Sample* counts units in the last place (ulp) of x₀, of x − x₀ or of l, whichever is largest. Where the mean is
/// between the ends, l is σ or the distance of the farther end, whichever is smaller; otherwise it is 0. *Pdf* and
/// *realised density* are relative, *inverse* and *round trip* are absolute errors of the uniform. [What each row
/// means](crate::warp#stated-errors).
///
/// | error | bound | kind |
/// |---|--:|---|
/// | sample, ulp of location or distance | 17 | found |
/// | pdf, relative | 1.1e-6 | found |
/// | realised density, relative | 1.1e-6 + 8*s/max(0, 1 - w/1e6) | found |
/// | pdf with the sample, relative | 5.2e-6 | found |
/// | inverse | 8.4e-7 | found |
/// | round trip | 4.8e-7 + 5.5*r | found |
///
/// A draw keeps the bound of a sample at the exact middle of its word. w is |x₀|(1 + c)/σ with c = |x₀ − μ|/σ. No realised
/// density is stated from w = 1e6 on, where densities of neighbouring `f32` differ by a factor. s and r are the relative change
/// of the density and the change of the inverse when x moves by one such ulp.
///
/// # Cost
/// One draw in `poly`, PCG32 included, takes <!-- figure: cost TruncatedNormal -->279 instructions and 1,864 bytes of code on an M4F, 15,677 instructions on an M0<!-- -->.
///
/// # Examples
/// ```
/// use microwarp::{Invert, Warp, poly as mw};
/// let tail = mw::TruncatedNormal::above(0.0, 1.0, 30.0)?;
/// assert_eq!(tail.sample(0.0), 30.0);
/// assert!((tail.sample(0.5) - 30.023_07).abs() < 1e-5);
/// let sensor = mw::TruncatedNormal::new(20.0, 5.0, 0.0, 100.0)?;
/// assert!((0.0..=100.0).contains(&sensor.sample(0.999)));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Normal`](super::Normal): without ends, at a lower cost.
/// - [`TruncatedExponential`](super::TruncatedExponential): what a far tail comes near to.
///
/// # Source
/// C. P. Robert, "Simulation of truncated normal variables", 1995, <https://doi.org/10.1007/BF00143942>, for the
/// problem. The inversion by the hazard is this crate's own.
#[doc(alias = "truncnorm")]
#[doc(alias = "gaussian")]
#[doc(alias = "half_normal")]
#[doc(alias = "clipped")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TruncatedNormal<T> {
    mean: f32,
    std_dev: f32,
    low: f32,
    high: f32,
    /// The point of the interval that is nearest to the mean.
    nearest: f32,
    /// How far from the mean that is in standard deviations, and its rounding error.
    from_mean: (f32, f32),
    /// The hazard there, and what it has above the distance.
    hazard: f32,
    above_distance: f32,
    /// The masses below and above it, in units that make the larger one at least 1.
    below: f32,
    above: f32,
    /// The unit, as a share of the tail beyond the nearest point; 0 where that underflows.
    unit: f32,
    /// The shares of the tail that are beyond the ends, times 2¹⁰⁰.
    beyond_low: f32,
    beyond_high: f32,
    /// The length that has one unit of mass, next to the nearest point.
    length: f32,
    /// The density at the nearest point.
    peak: f32,
    tier: PhantomData<T>,
}

/// A sample, and what its density asks for.
struct Place {
    x: f32,
    /// From the nearest point, in standard deviations; 0 where the hazard is constant.
    distance: f32,
    /// The share of the tail beyond the nearest point that is beyond this one, and a factor that it is still to be multiplied
    /// by.
    rest: (f32, f32),
}

/// The integral of the hazard over a distance beyond a point that is `from` standard deviations from the mean.
#[inline]
fn cumulated<T: Tier>(from: f32, hazard: f32, distance: f32) -> f32 {
    let mean = from + 0.5 * distance;
    if distance < NEAR {
        // Gauss's quadrature, since what the hazard has above the distance is smooth. Nothing cancels.
        let side = 0.387_298_35 * distance;
        let outer = hazard_above(mean - side) + hazard_above(mean + side);
        distance * (mean + (4.0 / 9.0 * hazard_above(mean) + 5.0 / 18.0 * outer))
    } else {
        let there = from + distance;
        distance * mean + T::ln((there + hazard_above(there)) / hazard)
    }
}

impl<T: Tier> TruncatedNormal<T> {
    /// Normal with this mean and this standard deviation on [low, high].
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for a standard deviation of 0 or less,
    /// [`Error::Reversed`] for ends in the wrong order, [`Error::OutOfRange`] for an interval that is more than 1e18
    /// standard deviations from the mean, [`Error::TooLarge`] if the length of the interval overflows, [`Error::Empty`]
    /// for equal ends and if the density overflows.
    pub fn new(mean: f32, std_dev: f32, low: f32, high: f32) -> Result<Self, Error> {
        Self::between(mean, std_dev, finite(low, 2)?, finite(high, 3)?)
    }

    /// Normal with this mean and this standard deviation from `low` up.
    ///
    /// # Errors
    /// Those of [`new`](Self::new), with [`Error::TooLarge`] if a sample could overflow.
    pub fn above(mean: f32, std_dev: f32, low: f32) -> Result<Self, Error> {
        Self::between(mean, std_dev, finite(low, 2)?, f32::INFINITY)
    }

    /// Normal with this mean and this standard deviation up to `high`.
    ///
    /// # Errors
    /// Those of [`new`](Self::new), with [`Error::TooLarge`] if a sample could overflow.
    pub fn below(mean: f32, std_dev: f32, high: f32) -> Result<Self, Error> {
        Self::between(mean, std_dev, f32::NEG_INFINITY, finite(high, 2)?)
    }

    /// The distribution on an interval of which one end may be infinite.
    fn between(mean: f32, std_dev: f32, low: f32, high: f32) -> Result<Self, Error> {
        finite(mean, 0)?;
        positive(std_dev, 1)?;
        if low > high {
            return Err(Error::Reversed(3));
        }
        let nearest = clamp(mean, low, high);
        let (to_low, to_high) = (nearest - low, high - nearest);
        let unbounded = !(low.is_finite() && high.is_finite());
        let reach = if unbounded {
            nearest.abs() + 2.0 * REACH * std_dev
        } else {
            // With room for the rounding of products.
            1.001 * to_low.max(to_high)
        };
        // For a large distance its product with the standard deviation could overflow.
        let part = if (nearest - mean).abs() > 1.0e37 {
            0.25
        } else {
            1.0
        };
        let (distance, rest) = standardised(part * nearest, part * mean, part * std_dev);
        let from_mean = if distance < 0.0 {
            (-distance, -rest)
        } else {
            (distance, rest)
        };
        let (from, _) = from_mean;
        if from > FARTHEST || from.is_nan() {
            return Err(Error::OutOfRange(Error::NO_PLACE));
        }
        if !reach.is_finite() {
            return Err(Error::TooLarge(if unbounded { Error::NO_PLACE } else { 3 }));
        }
        let above_distance = hazard_above(from);
        let hazard = from + above_distance;
        let scale = Scaled::of(std_dev).over(Scaled::of(hazard));
        // The share of the tail on one side, and the share beyond its end, times 2^100.
        let side = |length: f32| {
            let distance = length / std_dev;
            if length <= 0.0 {
                (None, LIFT)
            } else if hazard * distance < CONSTANT {
                (Some(Scaled::of(length).over(scale)), LIFT)
            } else if length < f32::INFINITY {
                let cumulated = cumulated::<T>(from, hazard, distance);
                let beyond = if cumulated < 250.0 {
                    scaled_exp::<T>(LIFT, -cumulated, 0.0)
                } else {
                    0.0
                };
                (Some(Scaled::of(-T::exp_m1(-cumulated))), beyond)
            } else {
                (Some(Scaled::ONE), 0.0)
            }
        };
        let ((below, beyond_low), (above, beyond_high)) = (side(to_low), side(to_high));
        let exponent = |mass: Option<Scaled>| mass.map_or(i32::MIN, |mass| mass.parts().1);
        let up = 0_i32.wrapping_sub(exponent(below).max(exponent(above)));
        if below.is_none() && above.is_none() {
            return Err(Error::Empty(3));
        }
        let lifted = |mass: Option<Scaled>| mass.map_or(0.0, |mass| mass.raised(up).value());
        let (below, above) = (lifted(below), lifted(above));
        let down = 0_i32.wrapping_sub(up);
        let length = scale.raised(down);
        let peak = Scaled::ONE
            .over(length.times(Scaled::of(below + above)))
            .value();
        if !peak.is_finite() {
            return Err(Error::Empty(Error::NO_PLACE));
        }
        Ok(Self {
            mean,
            std_dev,
            low,
            high,
            nearest,
            from_mean,
            hazard,
            above_distance,
            below,
            above,
            unit: Scaled::ONE.raised(down).value(),
            beyond_low,
            beyond_high,
            length: length.value(),
            peak,
            tier: PhantomData,
        })
    }

    /// The mean of the normal distribution before it is restricted.
    #[must_use]
    pub const fn mean(&self) -> f32 {
        self.mean
    }

    /// The standard deviation of the normal distribution before it is restricted.
    #[must_use]
    pub const fn std_dev(&self) -> f32 {
        self.std_dev
    }

    /// The lower end, which may be −∞.
    #[must_use]
    pub const fn low(&self) -> f32 {
        self.low
    }

    /// The upper end, which may be ∞.
    #[must_use]
    pub const fn high(&self) -> f32 {
        self.high
    }

    /// The distance from the nearest point, in standard deviations, over which the integral of the hazard is `deviate`.
    #[inline]
    fn distance(&self, deviate: f32) -> f32 {
        let (from, hazard) = (self.from_mean.0, self.hazard);
        // Where the hazard rises evenly the integral is a quadratic. Its mean slope is a fit, which leaves the distance
        // off by less than 8 in 1000.
        let slope = hazard * self.above_distance;
        let weight = deviate / (5.5 + 3.0 * hazard + 1.25 * deviate);
        let slope = slope + (1.0 - slope) * weight;
        let even = deviate / hazard;
        let first = 2.0 * even / (1.0 + T::sqrt(1.0 + 2.0 * slope * (even / hazard)));
        // One step of Halley's method leaves 4e-8. The slope of the hazard is its product with what it has above t.
        let there = from + first;
        let above = hazard_above(there);
        let step = (cumulated::<T>(from, hazard, first) - deviate) / (there + above);
        first - step / (1.0 - 0.5 * step * above)
    }

    /// The point with these shares of the mass below and above it, and what its density asks for. The smaller share is good to
    /// its last digit.
    #[inline]
    fn place(&self, below: f32, above: f32) -> Place {
        let mass = below * self.above - above * self.below;
        let upper = mass > 0.0;
        let size = mass.abs();
        let share = size * self.unit;
        let (along, distance, rest) = if share < CONSTANT {
            // Products with the smallest uniforms would lose their digits.
            let along = if size < 1.0e-30 {
                let lifted = (LIFT * below) * self.above - above * (LIFT * self.below);
                lifted.abs() * self.length * (1.0 / LIFT)
            } else {
                size * self.length
            };
            (along, 0.0, (1.0, 1.0))
        } else {
            let (rest, deviate) = if share < 0.5 {
                ((1.0 - share, 1.0), T::neg_ln_1m(share))
            } else {
                let rest = if upper {
                    self.rest(above, below, self.below, self.beyond_high)
                } else {
                    self.rest(below, above, self.above, self.beyond_low)
                };
                let lift = if rest.1 < 1.0 { LN_LIFT } else { 0.0 };
                (rest, lift - T::ln(rest.0))
            };
            let distance = self.distance(deviate);
            (self.std_dev * distance, distance, rest)
        };
        let x = if upper {
            self.nearest + along
        } else {
            self.nearest - along
        };
        Place {
            x: clamp(x, self.low, self.high),
            distance,
            rest,
        }
    }

    /// The share of a tail that is beyond a point, and a factor that it is still to be multiplied by; from the shares of the
    /// mass beyond the point and before it, the mass on the other side, and the share of the tail beyond the end.
    #[inline]
    fn rest(&self, beyond: f32, before: f32, other: f32, beyond_end: f32) -> (f32, f32) {
        const SMALL: f32 = 1.0 / 18_446_744_073_709_551_616.0;
        let whole = 1.0 + other * self.unit;
        if beyond > SMALL || beyond_end > SMALL * LIFT {
            (beyond * whole + before * (beyond_end / LIFT), 1.0)
        } else {
            let beyond = if beyond == 0.0 && beyond_end < SMALLEST * LIFT {
                SMALLEST
            } else {
                beyond
            };
            (beyond * LIFT * whole + before * beyond_end, 1.0 / LIFT)
        }
    }

    /// The point of a place and its density: that at the nearest point, times the share of the tail beyond and the hazard's
    /// rise.
    #[inline]
    fn with_pdf(&self, place: &Place) -> (f32, f32) {
        let there = self.from_mean.0 + place.distance;
        let (rest, factor) = place.rest;
        let risen = if place.distance > 0.0 {
            (there + hazard_above(there)) / self.hazard
        } else {
            1.0
        };
        let density = if factor < 1.0 {
            let factor = Scaled::of(factor).times(Scaled::of(rest * risen));
            Scaled::of(self.peak).times(factor).value()
        } else {
            self.peak * (rest * risen)
        };
        (place.x, representable(density))
    }

    /// The place of the middle of a word's cell.
    #[inline]
    fn place_of_word(&self, word: u32) -> Place {
        let (tail, upper) = folded(word);
        if upper {
            self.place(1.0 - tail, tail)
        } else {
            self.place(tail, 1.0 - tail)
        }
    }

    #[inline]
    fn of_word_with_pdf(&self, word: u32) -> (f32, f32) {
        self.with_pdf(&self.place_of_word(word))
    }
}

impl<T: Tier> Warp for TruncatedNormal<T> {
    type Uniforms = f32;
    type Point = f32;
    type Density = f32;

    #[inline]
    fn sample_canonical(&self, u: Canonical<f32>) -> f32 {
        let u = u.get();
        self.place(u, 1.0 - u).x
    }

    #[inline]
    fn sample_words(&self, word: u32) -> f32 {
        self.place_of_word(word).x
    }

    #[inline]
    fn sample_canonical_with_pdf(&self, u: Canonical<f32>) -> (f32, f32) {
        let u = u.get();
        self.with_pdf(&self.place(u, 1.0 - u))
    }

    drawn_with_pdf!(from of_word_with_pdf);

    #[inline]
    fn pdf(&self, x: f32) -> f32 {
        if !(x >= self.low && x <= self.high && x.is_finite()) {
            return 0.0;
        }
        let (from, from_rest) = self.from_mean;
        let (t, rest) = standardised(x, self.nearest, self.std_dev);
        let (t, rest) = if t < 0.0 { (-t, -rest) } else { (t, rest) };
        let (line, dropped) = two_product(-t, from);
        let line_rest = dropped - (t * from_rest + rest * from);
        let (square, square_rest) = exponent((t, rest));
        let (sum, dropped) = two_sum(line, square);
        representable(decayed::<T>(
            self.peak,
            (sum, dropped + (line_rest + square_rest)),
        ))
    }
}

impl<T: Tier> Invert for TruncatedNormal<T> {
    #[inline]
    fn invert(&self, x: f32) -> f32 {
        let x = clamp(x, self.low, self.high);
        let length = (x - self.nearest).abs();
        let distance = length / self.std_dev;
        let size = if self.hazard * distance < CONSTANT {
            length / self.length
        } else {
            -T::exp_m1(-cumulated::<T>(self.from_mean.0, self.hazard, distance)) / self.unit
        };
        let below = if x > self.nearest {
            self.below + size
        } else {
            self.below - size
        };
        into_unit(below / (self.below + self.above))
    }
}
