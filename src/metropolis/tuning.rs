//! The scale of a proposal: tuned while a chain burns in, and then left alone.

use super::target_density::TargetDensity;
use super::{Chain, Coordinates, Mutation, Scalable};
use crate::error::{Error, positive};
use crate::num::clamp;
use crate::tier::{exp2_pair, sqrt};
use crate::uniform::infallible;
use rand_core::{Rng, TryRng};

/// The binary logarithm of the scale is from minus this to this.
const REACH: f32 = 64.0;

/// A chain that burns in, and scales the steps of its mutation until the share that is accepted is the one you ask for.
///
/// Steps that are too short or too long explore slowly. The best share is about 0.44 for one coordinate, or one at a time,
/// 0.35 for two and 0.234 for many.
///
/// While the scale follows the states, the density is **not** stationary: draws taken meanwhile would be biased. So the chain is
/// locked in until [`freeze`](Self::freeze) returns it, with a mutation that no longer changes.
///
/// # Domain
///
/// - Mutations: those that are [`Scalable`]. The scales of the coordinates keep their ratio.
/// - The scale is from 2⁻⁶⁴ to 2⁶⁴ times that of the mutation, whatever the target returns. A proposal that is refused counts as
///   rejected.
/// - Words: those of the chain's steps.
///
/// # Accuracy
///
/// After k steps the scale of the next changes by the factor 4^((a − goal)/√k) for an acceptance a, and the result is a mean of
/// the logarithms with weights that let early ones fade. For these shares 1000 steps make up for a start 10⁶ times too short
/// or 10⁴ times too long: the share accepted is then within 0.1 of the goal, once the chain is where the density is.
///
/// # Cost
///
/// Beside the chain and the mutation 12 bytes, and a step takes two roots and a power of 2 more than that of the chain.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Chain, LogDensity, Tuning};
/// use microwarp::poly as mw;
/// use microwarp::tier::Poly;
/// use rand_pcg::Pcg32;
/// // A normal density whose deviation of 0.001 nobody knows.
/// let f = |x: f32| LogDensity::<Poly>::new(-5e5 * x * x);
/// let mut rng = Pcg32::new(42, 54);
/// let mut tuning = Tuning::new(Chain::new(0.01, f)?, mw::NormalStep::new(1.0)?, 0.44)?;
/// for _ in 0..1000 {
///     tuning.step(f, &mut rng);
/// }
/// let (mut chain, step) = tuning.freeze();
/// assert!((step.std_devs() / 0.0024 - 1.0).abs() < 0.2);
/// for _ in 0..1000 {
///     chain.step(f, &step, &mut rng);
/// }
/// assert!(chain.acceptance_rate().is_some_and(|rate| (rate - 0.44).abs() < 0.05));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`Chain::burn_in`], where the scale is known.
/// - [`LogUniformStep`](super::LogUniformStep), whose steps have all scales at once.
///
/// # Source
///
/// H. Robbins, S. Monro, "A Stochastic Approximation Method", 1951,
/// [doi:10.1214/aoms/1177729586](https://doi.org/10.1214/aoms/1177729586); B. T. Polyak, A. B. Juditsky, "Acceleration of
/// Stochastic Approximation by Averaging", 1992, [doi:10.1137/0330046](https://doi.org/10.1137/0330046); G. O. Roberts,
/// J. S. Rosenthal, "Optimal Scaling for Various Metropolis-Hastings Algorithms", 2001,
/// [doi:10.1214/ss/1015346320](https://doi.org/10.1214/ss/1015346320), for the shares.
#[doc(alias = "adaptive")]
#[doc(alias = "warm_up")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tuning<X, M, D = f32> {
    chain: Chain<X, D>,
    mutation: M,
    goal: f32,
    /// The binary logarithm of the scale of the next step.
    next: f32,
    /// That of the result.
    mean: f32,
}

impl<X: Coordinates, M: Mutation<X> + Scalable, D: TargetDensity> Tuning<X, M, D> {
    /// Tunes this mutation for this chain, whose counts begin anew, toward a share of accepted steps.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::NotPositive`] for the share, and [`Error::OutOfRange`] if it is not below 1.
    pub fn new(mut chain: Chain<X, D>, mutation: M, goal: f32) -> Result<Self, Error> {
        if positive(goal, 2)? >= 1.0 {
            return Err(Error::OutOfRange(2));
        }
        chain.reset_counts();
        Ok(Self {
            chain,
            mutation,
            goal,
            next: 0.0,
            mean: 0.0,
        })
    }

    /// Takes a step, and adapts the scale to its acceptance; from a generator that can fail.
    ///
    /// # Errors
    /// The generator's own error; chain and scale are then unchanged.
    pub fn try_step<R: TryRng + ?Sized>(
        &mut self,
        target: impl FnOnce(X) -> D,
        rng: &mut R,
    ) -> Result<(), R::Error> {
        let mutation = self.mutation.scaled(power(self.next));
        let acceptance = self.chain.try_step(target, &mutation, rng)?.acceptance;
        let root = sqrt(self.chain.steps() as f32);
        let next = self.next + 2.0 * (acceptance - self.goal) / root;
        self.next = clamp(next, -REACH, REACH);
        // The weight k^(−3/4), which is 1 at the first step.
        self.mean += (self.next - self.mean) / (root * sqrt(root));
        Ok(())
    }

    /// Takes a step, and adapts the scale to its acceptance. The target is that of the chain.
    pub fn step(&mut self, target: impl FnOnce(X) -> D, rng: &mut (impl Rng + ?Sized)) {
        infallible(self.try_step(target, rng));
    }

    /// How many steps have been taken.
    #[must_use]
    #[inline]
    pub const fn steps(&self) -> u64 {
        self.chain.steps()
    }

    /// The share of accepted steps that is the goal.
    #[must_use]
    #[inline]
    pub const fn goal(&self) -> f32 {
        self.goal
    }

    /// The factor that the mutation is scaled by, as found so far; 1 before the first step.
    #[must_use]
    pub fn scale(&self) -> f32 {
        power(self.mean)
    }

    /// Ends the burn-in: the chain where it is, with counts of 0, and the mutation with the scale that was found.
    ///
    /// The mutation is an ordinary one, and the chain takes ordinary steps by it, so the density is stationary again.
    #[must_use = "the tuned mutation is in the result"]
    pub fn freeze(mut self) -> (Chain<X, D>, M) {
        self.chain.reset_counts();
        (self.chain, self.mutation.scaled(self.scale()))
    }
}

/// The power of 2, positive and finite: the logarithm is within its bounds.
fn power(log2: f32) -> f32 {
    exp2_pair(log2, 0.0).0
}
