//! The rule of Metropolis and Hastings, for a chain of densities, and the ways to take a step.

use super::hastings_correction::{HastingsCorrection, Stated as _};
use super::target_density::TargetDensity;
use super::target_value::{Standing, TargetValue};
use super::{Chain, Mutation, Outcome, Proposal, Transition};
use crate::num::happens;
use crate::uniform::infallible;
use core::num::NonZeroU32;
use rand_core::{Rng, TryRng};

/// The rule: min(1, f′T′/(fT)), of a proposal of density f′ by a chain at a state of density f, both positive.
#[inline]
fn acceptance<D: TargetDensity>(f: D, f_new: D, ratio: impl HastingsCorrection) -> f32 {
    let product = match ratio.value() {
        // T′ = T. The quotient of a smaller number by a larger one cannot overflow.
        None if f.exceeds(f_new) => return f_new.over(f),
        None => return 1.0,
        Some(ratio) => f_new.quotient(f).times(ratio).value(),
    };
    if product < 1.0 { product } else { 1.0 }
}

impl<X: Copy, D: TargetDensity> Chain<X, D> {
    /// The one step; a limit of `u32::MAX` is none.
    #[inline]
    fn advance<R: TryRng + ?Sized>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &(impl Mutation<X> + ?Sized),
        limit: u32,
        rng: &mut R,
    ) -> Result<Transition<X, D>, R::Error> {
        let proposal = mutation.try_propose(self.state(), rng)?;
        let word = rng.try_next_u32()?;
        let density = target(proposal.state);
        let ratio = proposal.correction;
        let (a, outcome) = match density.standing().and(ratio.standing()) {
            Standing::Positive => match acceptance(self.density(), density, ratio) {
                a if happens(a, word) => (a, Outcome::Accepted),
                _ if self.must_move(limit) => (1.0, Outcome::Forced),
                a => (a, Outcome::Rejected),
            },
            Standing::Zero => (0.0, Outcome::Rejected),
            Standing::Unsound => (0.0, Outcome::Refused),
        };
        Ok(self.take(&proposal, density, a, outcome))
    }
}

steps!(D, f32, D: TargetDensity);

impl<X: Copy, D: TargetValue> Chain<X, D> {
    /// Whether the next proposal there is a way to has to be accepted; never if the limit is `u32::MAX`.
    #[inline]
    pub(super) const fn must_move(&self, limit: u32) -> bool {
        limit < u32::MAX && self.rejected_in_a_row() >= limit
    }

    /// Goes to a proposal or stays, and counts it.
    #[inline]
    pub(super) fn take<C, A>(
        &mut self,
        proposal: &Proposal<X, C>,
        density: D,
        acceptance: A,
        outcome: Outcome,
    ) -> Transition<X, D, A> {
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
}

/// The ways to take a step, by the `advance` of a kind of chain.
macro_rules! steps {
    ($weight:ty, $acceptance:ty $(, $generic:ident: $bound:ident)?) => {
        impl<X: Copy $(, $generic: $bound)?> Chain<X, $weight> {
            /// Takes a step: one proposal, accepted or not.
            ///
            /// The target must be the one that the chain was started with, and its density at a state always the
            /// same.
            ///
            /// # Errors
            /// The generator's own error; the chain is then as it was.
            #[inline]
            pub fn try_step<R: TryRng + ?Sized>(
                &mut self,
                target: impl FnOnce(X) -> $weight,
                mutation: &(impl Mutation<X> + ?Sized),
                rng: &mut R,
            ) -> Result<Transition<X, $weight, $acceptance>, R::Error> {
                self.advance(target, mutation, u32::MAX, rng)
            }

            /// Takes a step with a generator that cannot fail.
            #[inline]
            pub fn step(
                &mut self,
                target: impl FnOnce(X) -> $weight,
                mutation: &(impl Mutation<X> + ?Sized),
                rng: &mut (impl Rng + ?Sized),
            ) -> Transition<X, $weight, $acceptance> {
                infallible(self.try_step(target, mutation, rng))
            }

            /// Takes a step, but rejects no more than `limit` times in a row: the next proposal that has a positive
            /// density and a way back is accepted then, whatever the probability ([`Outcome::Forced`](crate::metropolis::Outcome::Forced)).
            ///
            /// This **biases** the chain: it is no longer stationary in f. States that are left seldom, which are
            /// those of high density, lose: one left with probability A a step keeps 1 − (1 − A)^(limit + 1) of the
            /// time it would have had in a stay, and what it loses goes to where it is forced. (That is if each
            /// proposal could be forced. It keeps more where some cannot, and where the state itself is proposed,
            /// which counts as accepted.) With A well above 1/limit the loss is next to nothing; below, a peak of
            /// density f is cut to about (limit + 1)·A·f. The share of forced steps says which it is.
            ///
            /// # Errors
            /// The generator's own error; the chain is then as it was.
            #[inline]
            pub fn try_step_limited<R: TryRng + ?Sized>(
                &mut self,
                target: impl FnOnce(X) -> $weight,
                mutation: &(impl Mutation<X> + ?Sized),
                limit: NonZeroU32,
                rng: &mut R,
            ) -> Result<Transition<X, $weight, $acceptance>, R::Error> {
                // A count that saturates never reaches no limit at all.
            let limit = limit.get().min(u32::MAX.saturating_sub(1));
            self.advance(target, mutation, limit, rng)
            }

            /// Takes a step of limited rejections with a generator that cannot fail.
            #[inline]
            pub fn step_limited(
                &mut self,
                target: impl FnOnce(X) -> $weight,
                mutation: &(impl Mutation<X> + ?Sized),
                limit: NonZeroU32,
                rng: &mut (impl Rng + ?Sized),
            ) -> Transition<X, $weight, $acceptance> {
                infallible(self.try_step_limited(target, mutation, limit, rng))
            }

            /// Takes `steps` steps and forgets them: a start that the density would hardly have chosen weighs less
            /// and less with each. The counts begin anew.
            ///
            /// How many are enough, no rule says; a few times the integrated autocorrelation time of
            /// [`Autocorrelation`](crate::metropolis::Autocorrelation) leaves little, if the chain has been everywhere.
            ///
            /// # Errors
            /// The generator's own error; the steps before it are taken, and counted.
            #[inline]
            pub fn try_burn_in<R: TryRng + ?Sized>(
                &mut self,
                mut target: impl FnMut(X) -> $weight,
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

            /// Takes `steps` steps with a generator that cannot fail, and forgets them.
            #[inline]
            pub fn burn_in(
                &mut self,
                target: impl FnMut(X) -> $weight,
                mutation: &(impl Mutation<X> + ?Sized),
                steps: u32,
                rng: &mut (impl Rng + ?Sized),
            ) {
                infallible(self.try_burn_in(target, mutation, steps, rng));
            }
        }
    };
}
pub(super) use steps;
