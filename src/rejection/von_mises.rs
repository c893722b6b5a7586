//! The von Mises distribution on the circle, by rejection from a wrapped Cauchy.

use super::{Failure, Rejection, with_budget};
use crate::error::{Error, finite};
use crate::num::{clamp, happens, pair, representable, two_product, two_sum};
use crate::tier::{Tier, one_minus_cos_radians, scaled_exp, sqrt};
use core::f32::consts::{PI, TAU};
use core::marker::PhantomData;
use rand_core::TryRng;

/// The normal distribution of angles (von Mises), of any concentration: headings, phases, wind, the time of a day.
///
/// The form of Best and Fisher, written without a cancellation: an angle of a wrapped Cauchy is accepted or not. It serves all
/// concentrations, from a uniform angle to one that hardly scatters.
///
/// # Density
/// e^(κ cos(x − μ))/(2π I₀(κ)) per radian, from −π to π.
///
/// # Domain
/// - Point: an angle in radians from −π to π, both as rounded to `f32`.
/// - Words a try: two. The first proposes an angle, which increases with it about the mean; the second decides.
/// - Parameters: a mean direction from −2π to 2π radians, and a concentration κ of 0, or from 1e-30 to 1e30. About 1/√κ is the
///   standard deviation of a large one, and κ = 0 is uniform.
///
/// # Accuracy
/// A proposed angle is accepted with its probability to a
/// relative error of 1e-5, where its density is above 1e-3 of the peak. Beyond that, decisions by 32 bits show: the probability
/// is right to 2⁻³³ plus 1.3e-6 (1 + L) of itself, where L is κ(1 − cos(x − μ)).
///
/// The angle of a first word has an error of 1.1e-6 of its distance from the mean, and of 4e-7 rad more about a mean that is not 0.
///
/// The density has
/// a relative error of 9e-7 (1 + L), or an absolute one of 2⁻¹⁴⁸; about a mean beyond ±π, of a point whose distance from it is
/// off by 1e-14 rad.
///
/// The bounds are found, not proven: by counting decisions of thousands of angles under concentrations of all sizes, and by a search
/// among them.
///
/// # Cost
/// Efficiency: 1 for κ = 0, 0.87 for κ = 1, 0.66 for a large one.
///
/// The default budget of 42 tries is spent with a probability below 2⁻⁶⁴.
///
/// # Examples
/// ```
/// use microwarp::poly as mw;
/// use microwarp::rejection::Rejection;
/// use rand_pcg::Pcg32;
/// let heading = mw::VonMises::new(3.0, 20.0)?; // nearly south, with a spread of 13 degrees
/// let angle = heading.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(angle.abs() > 1.5); // on either side of π
/// assert!(heading.pdf(angle) > 0.0);
/// assert!((mw::VonMises::new(0.0, 0.0)?.pdf(1.0) - 0.159_154_94).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # See also
/// - [`warp::VonMisesFisher`](crate::warp::VonMisesFisher): directions in space, by inversion.
/// - [`warp::Normal`](crate::warp::Normal): a large concentration, with an inverse.
///
/// # Source
/// D. J. Best and N. I. Fisher, "Efficient Simulation of the von Mises Distribution", 1979, <https://doi.org/10.2307/2346732>.
#[doc(alias = "circular")]
#[doc(alias = "angle")]
#[doc(alias = "heading")]
#[doc(alias = "phase")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VonMises<T> {
    mean: f32,
    concentration: f32,
    /// The tangent of half an angle of the proposal over that of a uniform angle: (1 − ρ)/(1 + ρ).
    tangent: f32,
    /// κ times its square.
    steep: f32,
    /// What decides about a proposal at the mean, from 1/2 to 1.
    least: f32,
    /// The density at the mean.
    peak: f32,
    budget: u32,
    tier: PhantomData<T>,
}

/// By how much 2π is above its `f32`.
const REST: f32 = pair(core::f64::consts::TAU).1;

/// From how large a concentration on the Bessel function is a series of falling powers.
const LARGE: f32 = 12.0;

/// The density at the mean, 1/(2π e^−κ I₀(κ)).
fn peak<T: Tier>(k: f32) -> f32 {
    if k < LARGE {
        // Σ (κ²/4)ⁿ/n!², the innermost term first.
        let x = 0.25 * k * k;
        let bessel = (1_u8..=40)
            .rev()
            .fold(1.0, |sum, n| 1.0 + x / (f32::from(n) * f32::from(n)) * sum);
        T::exp(k) / (TAU * bessel)
    } else {
        // Σ (1·3·…·(2n − 1))²/(n! (8κ)ⁿ), likewise.
        let x = 0.125 / k;
        let series = (1_u8..=14).rev().fold(1.0, |sum, n| {
            let odd = 2.0 * f32::from(n) - 1.0;
            1.0 + x * (odd * odd / f32::from(n)) * sum
        });
        sqrt(k * (1.0 / TAU)) / series
    }
}

/// An angle up to 3π and its rounding error, brought to a turn about 0.
#[inline]
fn wrapped((angle, rest): (f32, f32)) -> f32 {
    if angle > PI {
        (angle - TAU) + (rest - REST)
    } else if angle < -PI {
        (angle + TAU) + (rest + REST)
    } else {
        angle + rest
    }
}

impl<T: Tier> VonMises<T> {
    /// The default budget. A true random generator spends it with a probability below 2⁻⁶⁴.
    pub const BUDGET: u32 = 42;

    with_budget!(const);

    /// Angles about this mean direction, in radians, of this concentration.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] for a concentration below 0, [`Error::OutOfRange`] for one
    /// beside 0 that is not from 1e-30 to 1e30, and for a mean beyond 2π either way.
    pub fn new(mean: f32, concentration: f32) -> Result<Self, Error> {
        let (mean, k) = (finite(mean, 0)?, finite(concentration, 1)?);
        if k < 0.0 {
            return Err(Error::Negative(1));
        }
        if mean.abs() > TAU {
            return Err(Error::OutOfRange(0));
        }
        if !(k == 0.0 || (1.0e-30..=1.0e30).contains(&k)) {
            return Err(Error::OutOfRange(1));
        }
        let twice = 2.0 * k;
        // The 1 is lost in the root beyond, where the square would overflow.
        let h = if k < 1.0e9 {
            sqrt(1.0 + twice * twice)
        } else {
            twice
        };
        let above = 1.0 + h;
        let root = sqrt(2.0 * above);
        let whole = above + root;
        // 1 − ρ, of which nothing cancels, and ρ.
        let short = (1.0 + 1.0 / (h + twice) + root) / whole;
        let tangent = short / (1.0 + twice / whole);
        Ok(Self {
            mean,
            concentration: k,
            tangent,
            steep: k * tangent * tangent,
            least: 0.25 * short * short * whole,
            peak: peak::<T>(k),
            budget: Self::BUDGET,
            tier: PhantomData,
        })
    }

    /// The mean direction.
    #[must_use]
    pub const fn mean(&self) -> f32 {
        self.mean
    }

    /// The concentration κ.
    #[must_use]
    pub const fn concentration(&self) -> f32 {
        self.concentration
    }

    /// One try with two given words, of which the first proposes an angle and the second decides: a smaller one accepts
    /// more. `None` if the angle is rejected.
    #[must_use]
    #[inline]
    #[expect(clippy::cast_possible_wrap, reason = "a distance with its sign")]
    pub fn attempt(&self, words: [u32; 2]) -> Option<f32> {
        let [place, decision] = words;
        // Half of half a turn about the middle of the words, where it has all digits.
        let quarter = ((place ^ 1 << 31) as i32 as f32 + 0.5) * (f32::EPSILON / 1024.0);
        let (s, c) = T::sincos_turns(quarter);
        let across = self.tangent * s;
        // κ(1 − cos) of the angle with this tangent of its half.
        let decay = 2.0 * self.steep * s * s / (across * across + c * c);
        let decides = self.least + decay;
        let accepted = happens(decides * T::exp(1.0 - decides), decision);
        accepted.then(|| {
            let angle = T::atan2_turns(across, c) * (2.0 * TAU);
            clamp(wrapped(two_sum(self.mean, angle)), -PI, PI)
        })
    }

    /// The density at an angle in radians; 0 beyond −π and π alone.
    #[must_use]
    pub fn pdf(&self, x: f32) -> f32 {
        if !(-PI..=PI).contains(&x) {
            return 0.0;
        }
        // From −3π to 3π.
        let away = wrapped(two_sum(x, -self.mean)).abs();
        let (exponent, rest) = two_product(
            -self.concentration,
            one_minus_cos_radians::<T>(clamp(away, 0.0, PI)),
        );
        let density = if exponent > -250.0 {
            scaled_exp::<T>(self.peak, exponent, rest)
        } else {
            0.0
        };
        representable(density)
    }
}

impl<T: Tier> Rejection for VonMises<T> {
    type Point = f32;

    #[inline]
    fn budget(&self) -> u32 {
        self.budget
    }

    #[inline]
    fn try_once<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<Option<f32>, Failure<R::Error>> {
        let place = rng.try_next_u32().map_err(Failure::Generator)?;
        let decision = rng.try_next_u32().map_err(Failure::Generator)?;
        Ok(self.attempt([place, decision]))
    }
}
