//! What a harness asks of densities and integer weights alike, so that one harness serves both kinds of chain.

use microwarp::metropolis::{Chain, Chance, LogDensity, Mutation, Saved, TargetValue, Transition};
use microwarp::tier::Tier;
use rand_core::{Rng, TryRng};
use std::fmt::Debug;
use std::num::NonZeroU32;

/// A weight, and the steps of its chain.
pub trait Weighed: TargetValue + Bits + PartialEq + Debug {
    /// The acceptance as a number; of integer weights, how many words accept.
    type Share: Copy + PartialEq + Debug + Bits;

    fn is_positive(self) -> bool;

    /// A step, with a limit of rejections in a row or without.
    fn try_step<X: Copy, M: Mutation<X>, R: TryRng>(
        chain: &mut Chain<X, Self>,
        target: impl FnOnce(X) -> Self,
        mutation: &M,
        limit: Option<NonZeroU32>,
        rng: &mut R,
    ) -> Result<Transition<X, Self, Self::Share>, R::Error>;

    fn step<X: Copy, M: Mutation<X>, R: Rng>(
        chain: &mut Chain<X, Self>,
        target: impl FnOnce(X) -> Self,
        mutation: &M,
        limit: Option<NonZeroU32>,
        rng: &mut R,
    ) -> Transition<X, Self, Self::Share> {
        let Ok(step) = Self::try_step(chain, target, mutation, limit, rng);
        step
    }
}

macro_rules! weighed {
    ($([$($tier:ident)?] $weight:ty, $acceptance:ty, $said:expr, $is_positive:expr;)*) => {$(
        impl<$($tier: Tier)?> Weighed for $weight {
            type Share = $acceptance;

            fn is_positive(self) -> bool {
                $is_positive(self)
            }

            fn try_step<X: Copy, M: Mutation<X>, R: TryRng>(
                chain: &mut Chain<X, Self>,
                target: impl FnOnce(X) -> Self,
                mutation: &M,
                limit: Option<NonZeroU32>,
                rng: &mut R,
            ) -> Result<Transition<X, Self, $acceptance>, R::Error> {
                let step = match limit {
                    Some(limit) => chain.try_step_limited(target, mutation, limit, rng),
                    None => chain.try_step(target, mutation, rng),
                }?;
                Ok(Transition {
                    from: step.from,
                    from_density: step.from_density,
                    proposed: step.proposed,
                    proposed_density: step.proposed_density,
                    acceptance: $said(step.acceptance),
                    outcome: step.outcome,
                    kind: step.kind,
                })
            }
        }
    )*};
}

weighed! {
    [] f32, f32, |a| a, |f| f > 0.0;
    [T] LogDensity<T>, f32, |a| a, |f: Self| f.get() > f32::NEG_INFINITY;
    [] u32, u64, Chance::words, |f| f > 0;
}

/// What consists of bits: NaN is equal to itself, and 0 is not -0.
pub trait Bits {
    fn bits(&self) -> Vec<u64>;
}

impl Bits for usize {
    fn bits(&self) -> Vec<u64> {
        vec![*self as u64]
    }
}

impl Bits for u32 {
    fn bits(&self) -> Vec<u64> {
        vec![(*self).into()]
    }
}

impl Bits for u64 {
    fn bits(&self) -> Vec<u64> {
        vec![*self]
    }
}

impl Bits for f32 {
    fn bits(&self) -> Vec<u64> {
        vec![self.to_bits().into()]
    }
}

impl<const N: usize> Bits for [f32; N] {
    fn bits(&self) -> Vec<u64> {
        self.iter().map(|x| x.to_bits().into()).collect()
    }
}

impl<T: Tier> Bits for LogDensity<T> {
    fn bits(&self) -> Vec<u64> {
        self.get().bits()
    }
}

impl<X: Bits, D: Bits> Bits for Saved<X, D> {
    fn bits(&self) -> Vec<u64> {
        let counts = [
            self.steps,
            self.accepted,
            self.refused,
            self.rejected_in_a_row.into(),
        ];
        [self.state.bits(), self.density.bits(), counts.to_vec()].concat()
    }
}

impl<X: Bits, D: Bits, A: Bits> Bits for Transition<X, D, A> {
    fn bits(&self) -> Vec<u64> {
        let rest = [self.outcome as u64, self.kind.into()];
        let from = [self.from.bits(), self.from_density.bits()].concat();
        let to = [self.proposed.bits(), self.proposed_density.bits()].concat();
        [from, to, self.acceptance.bits(), rest.to_vec()].concat()
    }
}
