//! Densities that carry what else the target has found at the state.

use super::HastingsCorrection;
use super::acceptance::Acceptance;
use super::standing::Standing;
use super::target_density::{Arithmetic, TargetDensity};
use super::target_value::{TargetValue, Weighing};
use crate::error::Error;
use crate::num::Scaled;

/// What a target returns for a state, and beside it a payload: the pixel and the colour of a path, or whatever else was
/// found on the way to the density.
///
/// The chain keeps it with the state. So [`Chain::density`](super::Chain::density), both densities of a
/// [`Transition`](super::Transition) and [`Transition::recorded_values`](super::Transition::recorded_values) hand out the
/// payload of the very state, and nothing is computed twice. The steps are those of a chain without payloads, bit for bit.
///
/// # Domain
///
/// - The density is an `f32`, a [`LogDensity`](super::LogDensity) or an integer weight, `u32`.
/// - The payload is of any `Copy` type. The chain does not look at it.
/// - Of a state that is refused or has density 0, the payload may be anything.
/// - The weight of a [`Start`](super::Start) has the payload of some candidate, which says nothing: take its `density`.
///
/// # Cost
///
/// The payload adds its own size to a [`Chain`](super::Chain), and twice that to a [`Transition`](super::Transition).
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Chain, UniformStep, WithPayload};
/// use rand_pcg::Pcg32;
///
/// // Light that falls on four pixels: a path finds its pixel and two colours.
/// let path = |[x, y]: [f32; 2]| {
///     let colour = [x * y, x * x];
///     WithPayload::new(colour[0] + colour[1], ((4.0 * x) as usize, colour))
/// };
/// let mut rng = Pcg32::new(42, 54);
/// let start = Chain::resample(path, &UniformStep::new(), 1000, &mut rng)?;
/// let (mut chain, steps) = (start.chain, 10_000);
/// let scale = start.weight.density / steps as f32;
/// let mut picture = [[0.0; 2]; 4];
/// for _ in 0..steps {
///     for (found, share) in chain.step(path, &UniformStep::new(), &mut rng).recorded_values() {
///         let (pixel, colour) = found.payload;
///         if share > 0.0 {
///             for (sum, c) in picture[pixel].iter_mut().zip(colour) {
///                 *sum += c * share * scale / found.density;
///             }
///         }
///     }
/// }
/// // In the last pixel the mean of x² is 37/48, and it has a quarter of the states.
/// assert!((picture[3][1] / (37.0 / 192.0) - 1.0_f32).abs() < 0.1);
/// # Ok::<(), microwarp::rejection::Failure>(())
/// ```
///
/// # See also
///
/// - [`primary_density`](super::primary_density), to drive a warp with a chain.
///
/// # Source
///
/// C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the Metropolis Light
/// Transport Algorithm", 2002, [doi:10.1111/1467-8659.t01-1-00703](https://doi.org/10.1111/1467-8659.t01-1-00703).
#[doc(alias = "cache")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WithPayload<D, P> {
    /// The density of the state, or its integer weight.
    pub density: D,
    /// What else was found there.
    pub payload: P,
}

impl<D, P> WithPayload<D, P> {
    /// The density of a state, and what else was found there.
    #[must_use]
    #[inline]
    pub const fn new(density: D, payload: P) -> Self {
        Self { density, payload }
    }
}

impl<D: TargetValue, P: Copy> Weighing for WithPayload<D, P> {
    #[inline]
    fn standing(self) -> Standing {
        self.density.standing()
    }

    #[inline]
    fn fault(self, place: usize) -> Error {
        self.density.fault(place)
    }
}

impl<D: TargetValue, P: Copy> TargetValue for WithPayload<D, P> {
    type Acceptance = D::Acceptance;
}

/// The payload does not matter.
impl<A: Acceptance<D>, D, P> Acceptance<WithPayload<D, P>> for A {
    #[inline]
    fn between(
        f: WithPayload<D, P>,
        f_new: WithPayload<D, P>,
        ratio: impl HastingsCorrection,
    ) -> Self {
        A::between(f.density, f_new.density, ratio)
    }
}

impl<D: TargetDensity, P: Copy> Arithmetic for WithPayload<D, P> {
    #[inline]
    fn exceeds(self, other: Self) -> bool {
        self.density.exceeds(other.density)
    }

    #[inline]
    fn over(self, larger: Self) -> f32 {
        self.density.over(larger.density)
    }

    #[inline]
    fn quotient(self, other: Self) -> Scaled {
        self.density.quotient(other.density)
    }

    #[inline]
    fn scaled(self, by: Scaled) -> Self {
        Self {
            density: self.density.scaled(by),
            ..self
        }
    }
}

impl<D: TargetDensity, P: Copy> TargetDensity for WithPayload<D, P> {}
