//! What one step of a chain did.

/// What became of a proposal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outcome {
    /// The chain is at the proposed state.
    Accepted,
    /// The chain stays where it was.
    Rejected,
    /// The chain stays where it was, because the proposed density is NaN, infinite or negative, or the
    /// ratio of the mutation is none.
    Refused,
    /// The chain is at the proposed state, because it had rejected as often in a row as it was allowed to.
    ///
    /// ```
    /// use core::num::NonZeroU32;
    /// use microwarp::metropolis::{Chain, Outcome, UniformStep};
    /// use rand_pcg::Pcg32;
    /// let spike = |x: f32| if x < 0.01 { 1e6 } else { 1.0 };
    /// let limit = NonZeroU32::new(100).ok_or(microwarp::Error::NotPositive)?;
    /// let (mut chain, mut rng) = (Chain::new(0.0, spike)?, Pcg32::new(1, 1));
    /// let mut forced = 0;
    /// for _ in 0..10_000 {
    ///     let step = chain.step_limited(spike, &UniformStep::new(), limit, &mut rng);
    ///     forced += u32::from(step.outcome == Outcome::Forced);
    ///     assert!(chain.rejected_in_a_row() <= 100);
    /// }
    /// assert!(forced > 10); // here the limit decides, and the bias is large
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    Forced,
}

/// One step of a chain: both states it dealt with, and how much each counts.
///
/// Of a run, either record [`Transition::state`] for each step, or [`Transition::recorded`], which has the same
/// expectation, and usually less variance: what was proposed counts even if it was not accepted.
///
/// Source: E. Veach, L. J. Guibas, "Metropolis Light Transport", 1997.
///
/// ```
/// use microwarp::metropolis::{Chain, UniformIndex};
/// use rand_pcg::Pcg32;
/// let weights = [9.0, 1.0];
/// let weight = |i: usize| weights[i];
/// let mutation = UniformIndex::new(2)?;
/// let (mut chain, mut rng) = (Chain::new(0, weight)?, Pcg32::new(1, 1));
/// let mut histogram = [0.0; 2];
/// for _ in 0..1000 {
///     for (state, share) in chain.step(weight, &mutation, &mut rng).recorded() {
///         histogram[state] += share;
///     }
/// }
/// assert!((histogram[0] / 1000.0 - 0.9_f32).abs() < 0.05);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transition<X, D = f32, A = f32> {
    /// The state before the step, x.
    pub from: X,
    /// Its density, as the target gave it.
    pub from_density: D,
    /// The state proposed, x′. Of a refused proposal, and of one of acceptance 0, it may be anything.
    pub proposed: X,
    /// Its density, as the target gave it; of a refused proposal it may be anything.
    pub proposed_density: D,
    /// The probability with which the proposal is accepted, a, in [0, 1]: 0 of a refused one, 1 of a forced
    /// one. An `f32`, or of integer weights a [`Chance`](super::Chance).
    pub acceptance: A,
    /// What became of it.
    pub outcome: Outcome,
    /// Which of the mutations of a [`Mixture`](super::Mixture) proposed it; 0 without one.
    pub kind: u32,
}

impl<X: Copy, D: Copy, A> Transition<X, D, A> {
    /// Whether the chain has moved to the proposed state.
    #[must_use]
    #[inline]
    pub const fn is_accepted(&self) -> bool {
        matches!(self.outcome, Outcome::Accepted | Outcome::Forced)
    }

    /// The state after the step.
    #[must_use]
    #[inline]
    pub const fn state(&self) -> X {
        if self.is_accepted() {
            self.proposed
        } else {
            self.from
        }
    }

    /// The density of the state after the step.
    #[must_use]
    #[inline]
    pub const fn density(&self) -> D {
        if self.is_accepted() {
            self.proposed_density
        } else {
            self.from_density
        }
    }
}

impl<X: Copy, D> Transition<X, D> {
    /// Both states with the weights to record them with: 1 − a and a, which sum to 1; as 1 − a is rounded, to
    /// 2⁻²⁵, and exactly in `f32`.
    ///
    /// This is the expectation of recording the state after the step. Pass over a state of weight 0: if
    /// refused, it may be outside the domain.
    #[must_use]
    #[inline]
    pub const fn recorded(&self) -> [(X, f32); 2] {
        [
            (self.from, 1.0 - self.acceptance),
            (self.proposed, self.acceptance),
        ]
    }
}
