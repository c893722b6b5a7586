//! The record of one step of a chain.

/// What became of a proposal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Outcome {
    /// The chain moved to the proposed state.
    Accepted,
    /// The chain stayed where it was.
    Rejected,
    /// The chain stayed where it was, because the proposed density is NaN, infinite or negative, or the Hastings ratio is not
    /// valid.
    Refused,
    /// The chain moved to the proposed state because it had reached the limit of rejections in a row
    /// ([`Chain::step_limited`](super::Chain::step_limited)).
    ///
    /// ```
    /// use core::num::NonZeroU32;
    /// use microwarp::metropolis::{Chain, Outcome, UniformStep};
    /// use rand_pcg::Pcg32;
    /// let spike = |x: f32| if x < 0.01 { 1e6 } else { 1.0 };
    /// let limit = NonZeroU32::new(100).ok_or(microwarp::Error::NotPositive(0))?;
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

/// The record of one step of a chain: the old state, the proposal, and what became of it.
///
/// To record a run, take either [`Transition::state`] of each step, or [`Transition::recorded`]. The second has the same
/// expectation and usually less variance, since a proposal counts even if it is not accepted.
///
/// # Examples
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
///
/// # Source
///
/// E. Veach, L. J. Guibas, "Metropolis Light Transport", 1997,
/// [doi:10.1145/258734.258775](https://doi.org/10.1145/258734.258775).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transition<X, D = f32, A = f32> {
    /// The state before the step, x.
    pub from: X,
    /// The density of x, as the target returned it.
    pub from_density: D,
    /// The proposed state, x′. If the proposal was refused or its acceptance is 0, it may be anything.
    pub proposed: X,
    /// The density of x′, as the target returned it. If the proposal was refused, it may be anything.
    pub proposed_density: D,
    /// The probability that the proposal is accepted, a, in [0, 1]: 0 if it was refused, 1 if it was forced. An `f32`, or a
    /// [`Chance`](super::Chance) for integer weights.
    pub acceptance: A,
    /// What became of the proposal.
    pub outcome: Outcome,
    /// The index of the mutation of a [`Mixture`](super::Mixture) that proposed it; 0 without a mixture.
    pub kind: u32,
}

impl<X: Copy, D: Copy, A> Transition<X, D, A> {
    /// Whether the chain moved to the proposed state.
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
    /// Both states, each with the weight to record it with: 1 − a and a. They sum to exactly 1 in `f32`; 1 − a is rounded to
    /// 2⁻²⁵.
    ///
    /// This is the expectation of recording the state after the step. Skip a state of weight 0: if the proposal was refused,
    /// it may be outside the domain.
    #[must_use]
    #[inline]
    pub const fn recorded(&self) -> [(X, f32); 2] {
        [
            (self.from, 1.0 - self.acceptance),
            (self.proposed, self.acceptance),
        ]
    }
}

impl<X, D: Copy> Transition<X, D> {
    /// What the target returned for both states, each with the weight to record it with: like [`Transition::recorded`], but with
    /// the densities, and [what goes with them](super::WithPayload), instead of the states.
    ///
    /// Skip a value of weight 0: if the proposal was refused, it may be anything.
    #[must_use]
    #[inline]
    pub const fn recorded_values(&self) -> [(D, f32); 2] {
        [
            (self.from_density, 1.0 - self.acceptance),
            (self.proposed_density, self.acceptance),
        ]
    }
}
