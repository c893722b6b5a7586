//! The chain: where it is, and what it counts.

use super::correction::{Judge, Verdict};
use super::weight::{Probability, Weight};
use super::{Mutation, Outcome, Saved, Step};
use crate::error::Error;
use crate::uniform::infallible;
use core::num::NonZeroU32;
use rand_core::{Rng, TryRng};

/// A Markov chain with a given stationary density, by the rule of Metropolis and Hastings.
///
/// At x, a mutation proposes x′, and with probability a = min(1, f(x′)T(x′→x)/(f(x)T(x→x′))) the chain goes
/// there; otherwise it stays, to the last bit. The target f and the mutation are handed to each step: the
/// chain itself is a plain value: one state, one density, three counts of 64 bits and one of 32. A [`Step`]
/// has two states and two densities.
///
/// | bytes, of states that are | `f32` | `[f32; 2]` | `[f32; 32]` | `usize` of 64 bits |
/// |---|--:|--:|--:|--:|
/// | [`Chain`], [`Saved`] | 40 | 40 | 160 | 40 |
/// | [`Step`] | 28 | 36 | 276 | 40 |
/// | of integer weights | 40 | 48 | 288 | 48 |
///
/// - States: any `Copy` type: an index, a point of ℝᴰ, the uniforms of a warp.
/// - Densities: `f32`, or [`LogDensity`](super::LogDensity), known up to a factor. Any positive finite ones
///   may meet in one chain: nothing over- or underflows on the way to the acceptance. Or integer weights, `u32`:
///   then the acceptance is exact, a [`Chance`](super::Chance), and no floating-point operation takes place.
/// - Words (`u32`) a step: those of the mutation and one more, which is drawn whether it decides or not.
/// - Error of the acceptance: half an ulp at a symmetric mutation, 2 ulp at one with a
///   [`Ratio`](super::Ratio); of logarithms, see [`LogDensity`](super::LogDensity). It is realised in steps
///   of 2⁻³², to the nearest: a proposal of an acceptance below 2⁻³³ is never taken. (In [`Step::recorded`] it
///   counts all the same.)
/// - A proposal whose density is NaN, infinite or negative is never accepted; it counts in
///   [`Chain::refused`].
///
/// Sources: N. Metropolis, A. W. Rosenbluth, M. N. Rosenbluth, A. H. Teller, E. Teller, "Equation of State
/// Calculations by Fast Computing Machines", 1953; W. K. Hastings, "Monte Carlo Sampling Methods Using Markov
/// Chains and Their Applications", 1970.
///
/// ```
/// use microwarp::metropolis::{BoxStep, Chain, Mixture, UniformStep, Wrapped};
/// use rand_pcg::Pcg32;
///
/// // Two humps at the ends of [0, 1). Small steps alone would hardly cross the valley.
/// let f = |x: f32| (x - 0.5) * (x - 0.5);
/// let small = Wrapped::new(BoxStep::new(0.1)?);
/// let mutation = Mixture::new((small, UniformStep::new()), &[0.9, 0.1])?;
///
/// let mut rng = Pcg32::new(42, 54);
/// let mut chain = Chain::new(0.1, f)?;
/// chain.burn_in(f, &mutation, 1000, &mut rng);
/// let mut right = 0.0;
/// for _ in 0..10_000 {
///     for (x, weight) in chain.step(f, &mutation, &mut rng).recorded() {
///         right += if x < 0.5 { 0.0 } else { weight };
///     }
/// }
/// assert!((right / 10_000.0 - 0.5).abs() < 0.1);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Chain<X, D = f32> {
    pub(super) at: Saved<X, D>,
}

impl<X: Copy, D: Weight> Chain<X, D> {
    /// A chain that starts at a state of one's own.
    ///
    /// # Errors
    /// [`Error::NotPositive`] if the density is 0 there, [`Error::Negative`] and [`Error::NotFinite`] if it
    /// is no density. Where no state of positive density is known, [`Chain::search`] looks for one.
    #[inline]
    pub fn new(start: X, target: impl FnOnce(X) -> D) -> Result<Self, Error> {
        let density = target(start);
        density.positive()?;
        Ok(Self::at(start, density))
    }

    /// A chain at a state of this density, which must be positive.
    #[inline]
    pub(super) const fn at(state: X, density: D) -> Self {
        let at = Saved {
            state,
            density,
            steps: 0,
            accepted: 0,
            refused: 0,
            rejected_in_a_row: 0,
        };
        Self { at }
    }

    /// Takes a step: one proposal, accepted or not.
    ///
    /// The target must be the one that the chain was started with, and its density at a state always the
    /// same.
    ///
    /// # Errors
    /// The generator's own error; the chain is then as it was.
    #[inline]
    pub fn try_step<M, R>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &M,
        rng: &mut R,
    ) -> Result<Step<X, D, D::Acceptance>, R::Error>
    where
        M: Mutation<X> + ?Sized,
        R: TryRng + ?Sized,
    {
        self.advance(target, mutation, u32::MAX, rng)
    }

    /// Takes a step with a generator that cannot fail.
    #[inline]
    pub fn step<M, R>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &M,
        rng: &mut R,
    ) -> Step<X, D, D::Acceptance>
    where
        M: Mutation<X> + ?Sized,
        R: Rng + ?Sized,
    {
        infallible(self.try_step(target, mutation, rng))
    }

    /// Takes a step, but rejects no more than `limit` times in a row: the next proposal that has a positive
    /// density and a way back is accepted then, whatever the probability ([`Outcome::Forced`]).
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
    pub fn try_step_limited<M, R>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &M,
        limit: NonZeroU32,
        rng: &mut R,
    ) -> Result<Step<X, D, D::Acceptance>, R::Error>
    where
        M: Mutation<X> + ?Sized,
        R: TryRng + ?Sized,
    {
        // A count that saturates never reaches no limit at all.
        let limit = limit.get().min(u32::MAX.saturating_sub(1));
        self.advance(target, mutation, limit, rng)
    }

    /// Likewise with a generator that cannot fail.
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
    #[inline]
    pub fn step_limited<M, R>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &M,
        limit: NonZeroU32,
        rng: &mut R,
    ) -> Step<X, D, D::Acceptance>
    where
        M: Mutation<X> + ?Sized,
        R: Rng + ?Sized,
    {
        infallible(self.try_step_limited(target, mutation, limit, rng))
    }

    /// The one step; a limit of `u32::MAX` is none.
    #[inline]
    fn advance<M, R>(
        &mut self,
        target: impl FnOnce(X) -> D,
        mutation: &M,
        limit: u32,
        rng: &mut R,
    ) -> Result<Step<X, D, D::Acceptance>, R::Error>
    where
        M: Mutation<X> + ?Sized,
        R: TryRng + ?Sized,
    {
        let at = self.at;
        let proposal = mutation.try_propose(at.state, rng)?;
        let word = rng.try_next_u32()?;
        let density = target(proposal.state);
        let (acceptance, outcome) = match proposal.correction.judge(at.density, density) {
            Verdict::With(a) if a.happens(word) => (a, Outcome::Accepted),
            Verdict::With(_) if limit < u32::MAX && at.rejected_in_a_row >= limit => {
                (D::Acceptance::ALWAYS, Outcome::Forced)
            }
            Verdict::With(a) => (a, Outcome::Rejected),
            Verdict::Never => (D::Acceptance::NEVER, Outcome::Rejected),
            Verdict::Refused => (D::Acceptance::NEVER, Outcome::Refused),
        };
        let step = Step {
            from: at.state,
            from_density: at.density,
            proposed: proposal.state,
            proposed_density: density,
            acceptance,
            outcome,
            kind: proposal.kind,
        };
        self.count(&step);
        Ok(step)
    }

    #[inline]
    fn count(&mut self, step: &Step<X, D, D::Acceptance>) {
        let at = &mut self.at;
        at.steps = at.steps.saturating_add(1);
        if step.is_accepted() {
            at.state = step.proposed;
            at.density = step.proposed_density;
            at.accepted = at.accepted.saturating_add(1);
            at.rejected_in_a_row = 0;
        } else {
            let refused = u64::from(step.outcome == Outcome::Refused);
            at.refused = at.refused.saturating_add(refused);
            at.rejected_in_a_row = at.rejected_in_a_row.saturating_add(1);
        }
    }

    /// Takes `steps` steps and forgets them: a start that the density would hardly have chosen weighs less
    /// and less with each. The counts begin anew.
    ///
    /// How many are enough, no rule says; a few times the integrated autocorrelation time of
    /// [`Health`](super::Health) leaves little, if the chain has been everywhere.
    ///
    /// # Errors
    /// The generator's own error; the steps before it are taken, and counted.
    #[inline]
    pub fn try_burn_in<M, R>(
        &mut self,
        mut target: impl FnMut(X) -> D,
        mutation: &M,
        steps: u32,
        rng: &mut R,
    ) -> Result<(), R::Error>
    where
        M: Mutation<X> + ?Sized,
        R: TryRng + ?Sized,
    {
        for _ in 0..steps {
            self.try_step(&mut target, mutation, rng)?;
        }
        self.reset_counts();
        Ok(())
    }

    /// Likewise with a generator that cannot fail.
    #[inline]
    pub fn burn_in<M, R>(
        &mut self,
        target: impl FnMut(X) -> D,
        mutation: &M,
        steps: u32,
        rng: &mut R,
    ) where
        M: Mutation<X> + ?Sized,
        R: Rng + ?Sized,
    {
        infallible(self.try_burn_in(target, mutation, steps, rng));
    }

    /// Sets all counts to 0, the rejections in a row included.
    #[inline]
    pub const fn reset_counts(&mut self) {
        self.at.steps = 0;
        self.at.accepted = 0;
        self.at.refused = 0;
        self.at.rejected_in_a_row = 0;
    }

    /// Where the chain is.
    #[must_use]
    #[inline]
    pub const fn state(&self) -> X {
        self.at.state
    }

    /// The density there, as the target gave it.
    #[must_use]
    #[inline]
    pub const fn density(&self) -> D {
        self.at.density
    }

    /// The steps taken since the start or the end of the burn-in.
    #[must_use]
    #[inline]
    pub const fn steps(&self) -> u64 {
        self.at.steps
    }

    /// How many of them went to the proposed state, forced ones included.
    #[must_use]
    #[inline]
    pub const fn accepted(&self) -> u64 {
        self.at.accepted
    }

    /// How many proposals were refused because their density was NaN, infinite or negative, or their ratio
    /// none.
    #[must_use]
    #[inline]
    pub const fn refused(&self) -> u64 {
        self.at.refused
    }

    /// How many steps in a row, the last one included, have stayed where they were.
    #[must_use]
    #[inline]
    pub const fn rejected_in_a_row(&self) -> u32 {
        self.at.rejected_in_a_row
    }

    /// The share of steps that went to the proposed state; [`None`] before the first.
    #[must_use]
    #[inline]
    pub fn acceptance_rate(&self) -> Option<f32> {
        (self.at.steps > 0).then(|| self.at.accepted as f32 / self.at.steps as f32)
    }
}
