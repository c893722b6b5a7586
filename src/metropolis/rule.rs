//! The Metropolis–Hastings rule, and the ways to take a step.

use super::acceptance::{Acceptance as _, Probability as _};
use super::hastings_correction::Stated as _;
use super::standing::Standing;
use super::target_value::TargetValue;
use super::{Chain, Mutation, Outcome, Proposal, Transition};
use crate::uniform::infallible;
use core::num::NonZeroU32;
use rand_core::{Rng, TryRng};

impl<X: Copy, D: TargetValue> Chain<X, D> {
    /// The rule: proposes a state, and moves to it with the probability that keeps the density stationary. After `limit`
    /// rejections in a row it must move, which biases the chain; `u32::MAX` means no limit. Each way to take a step comes here.
    #[inline]
    fn advance<R: TryRng + ?Sized>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        limit: u32,
        rng: &mut R,
    ) -> Result<Transition<X, D, D::Acceptance>, R::Error> {
        let proposal = mutation.try_propose(self.state(), rng)?;
        let word = rng.try_next_u32()?;
        let density = target(proposal.state);
        let ratio = proposal.correction;
        let (a, outcome) = match density.standing().and(ratio.standing()) {
            Standing::Positive => match D::Acceptance::between(self.density(), density, ratio) {
                a if a.accepts(word) => (a, Outcome::Accepted),
                _ if self.must_move(limit) => (D::Acceptance::ALWAYS, Outcome::Forced),
                a => (a, Outcome::Rejected),
            },
            Standing::Zero => (D::Acceptance::NEVER, Outcome::Rejected),
            Standing::Unsound => (D::Acceptance::NEVER, Outcome::Refused),
        };
        Ok(self.take(&proposal, density, a, outcome))
    }

    /// Whether the next proposal that the rule allows must be accepted; never with a limit of `u32::MAX`.
    #[inline]
    const fn must_move(&self, limit: u32) -> bool {
        limit < u32::MAX && self.rejected_in_a_row() >= limit
    }

    /// Moves to the proposal or stays, and counts the step.
    #[inline]
    fn take<C>(
        &mut self,
        proposal: &Proposal<X, C>,
        density: D,
        acceptance: D::Acceptance,
        outcome: Outcome,
    ) -> Transition<X, D, D::Acceptance> {
        let step = Transition {
            from: self.state(),
            from_density: self.density(),
            proposed: proposal.state,
            proposed_density: density,
            acceptance,
            outcome,
            kind: proposal.kind,
        };
        if step.is_accepted() {
            self.moved(step.proposed, step.proposed_density);
        } else {
            self.stayed(outcome == Outcome::Refused);
        }
        step
    }

    /// Takes a step, as [`step`](Self::step) does, from a generator that can fail.
    ///
    /// # Errors
    /// The generator's own error; the chain is then unchanged.
    #[inline]
    pub fn try_step<R: TryRng + ?Sized>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        rng: &mut R,
    ) -> Result<Transition<X, D, D::Acceptance>, R::Error> {
        self.advance(target, mutation, u32::MAX, rng)
    }

    /// Takes a step: one proposal, accepted or not.
    ///
    /// Pass the target that the chain was started with. It must return the same density for the same state each time.
    #[inline]
    pub fn step(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        rng: &mut (impl Rng + ?Sized),
    ) -> Transition<X, D, D::Acceptance> {
        infallible(self.try_step(target, mutation, rng))
    }

    /// Takes a step, and rejects at most `limit` times in a row: the next proposal that has a positive density and a way
    /// back is then accepted whatever its probability ([`Outcome::Forced`](crate::metropolis::Outcome::Forced)).
    ///
    /// This **biases** the chain: f is no longer its stationary density. The states of high density, which the chain rarely
    /// leaves, lose time. A state left with probability A per step keeps 1 − (1 − A)^(limit + 1) of its time per visit, and
    /// the states it is forced to gain the rest. (It keeps more if some of its proposals cannot be forced, or propose the
    /// state itself.) If A is well above 1/limit, the loss is negligible. If A is below, a peak of density f is cut to about
    /// (limit + 1)·A·f. The share of forced steps tells which case you have.
    ///
    /// # Errors
    /// The generator's own error; the chain is then unchanged.
    #[inline]
    pub fn try_step_limited<R: TryRng + ?Sized>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        limit: NonZeroU32,
        rng: &mut R,
    ) -> Result<Transition<X, D, D::Acceptance>, R::Error> {
        // `u32::MAX` would mean no limit.
        let limit = limit.get().min(u32::MAX.saturating_sub(1));
        self.advance(target, mutation, limit, rng)
    }

    /// Takes a step, and rejects at most `limit` times in a row. This **biases** the chain: see
    /// [`try_step_limited`](Self::try_step_limited).
    #[inline]
    pub fn step_limited(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        limit: NonZeroU32,
        rng: &mut (impl Rng + ?Sized),
    ) -> Transition<X, D, D::Acceptance> {
        infallible(self.try_step_limited(target, mutation, limit, rng))
    }

    /// Takes `steps` steps and resets the counts, as [`burn_in`](Self::burn_in) does, from a generator that can fail.
    ///
    /// # Errors
    /// The generator's own error; the chain keeps, and counts, the steps before it.
    #[doc(alias = "warm_up")]
    #[inline]
    pub fn try_burn_in<R: TryRng + ?Sized>(
        &mut self,
        mut target: impl FnMut(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        steps: u32,
        rng: &mut R,
    ) -> Result<(), R::Error> {
        for _ in 0..steps {
            self.try_step(&mut target, mutation, rng)?;
        }
        self.reset_counts();
        Ok(())
    }

    /// Takes `steps` steps and resets the counts, so that an unlikely start loses its influence.
    ///
    /// No rule says how many steps are enough. A few times the integrated autocorrelation time of
    /// [`Autocorrelation`](crate::metropolis::Autocorrelation) leaves little bias, provided the chain has been everywhere.
    #[doc(alias = "warm_up")]
    #[inline]
    pub fn burn_in(
        &mut self,
        target: impl FnMut(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        steps: u32,
        rng: &mut (impl Rng + ?Sized),
    ) {
        infallible(self.try_burn_in(target, mutation, steps, rng));
    }
}
