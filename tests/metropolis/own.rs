//! Mutations such as a user may write, each a function: of the state and some words, or of what another mutation proposes. And
//! what a harness asks of densities and integer weights alike, so that one harness serves both kinds of chain.

use microwarp::metropolis::{
    Chance, HastingsCorrection, HastingsRatio, LogDensity, Mutation, Proposal, Saved, Symmetric,
    TargetValue, Transition,
};
use microwarp::tier::Tier;
use rand_core::TryRng;
use std::fmt::Debug;

/// Proposes what a function makes of the state and `W` words.
#[derive(Clone, Copy)]
struct By<F, const W: usize>(F);

impl<X, C, F, const W: usize> Mutation<X> for By<F, W>
where
    C: HastingsCorrection,
    F: Fn(X, [u32; W]) -> Proposal<X, C>,
{
    type Correction = C;
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, C>, R::Error> {
        let mut words = [0; W];
        for word in &mut words {
            *word = rng.try_next_u32()?;
        }
        Ok((self.0)(from, words))
    }
}

pub fn by<X, C: HastingsCorrection, const W: usize>(
    function: impl Fn(X, [u32; W]) -> Proposal<X, C> + Copy,
) -> impl Mutation<X, Correction = C> + Copy {
    By(function)
}

/// Proposes one state always, and takes no word.
pub fn given<X: Copy, C: HastingsCorrection>(
    state: X,
    correction: C,
) -> impl Mutation<X, Correction = C> + Copy {
    by(move |_, []| Proposal::new(state, correction))
}

/// Proposes one state always, at the cost of one word.
pub fn to<X: Copy>(state: X) -> impl Mutation<X, Correction = Symmetric> + Copy {
    by(move |_, [_]| Proposal::new(state, Symmetric))
}

/// One place up or down in a circle of so many.
pub fn neighbour(places: usize) -> impl Mutation<usize, Correction = Symmetric> + Copy {
    by(move |from, [word]| {
        let by = [1, places - 1][word as usize >> 31];
        Proposal::new((from + by) % places, Symmetric)
    })
}

/// Multiplies by any factor from 1/e^reach to e^reach, each order of magnitude as likely: T(x→x′) ∝ 1/x′.
pub fn multiply(reach: f32) -> impl Mutation<f32, Correction = HastingsRatio> + Copy {
    by(move |from, [word]| {
        let turn = f64::from(word) / 2_147_483_648.0 - 1.0;
        let to = (f64::from(from) * (turn * f64::from(reach)).exp()) as f32;
        Proposal::new(to, HastingsRatio::new(1.0 / to, 1.0 / from))
    })
}

/// Proposes what a function makes of a state and of what another mutation proposes from it.
#[derive(Clone, Copy)]
struct Then<M, F>(M, F);

impl<X, C, M, F> Mutation<X> for Then<M, F>
where
    X: Copy,
    C: HastingsCorrection,
    M: Mutation<X>,
    F: Fn(X, X) -> Proposal<X, C>,
{
    type Correction = C;
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, C>, R::Error> {
        let to = self.0.try_propose(from, rng)?.state;
        Ok((self.1)(from, to))
    }
}

pub fn then<X: Copy, C: HastingsCorrection, M: Mutation<X> + Copy>(
    mutation: M,
    function: impl Fn(X, X) -> Proposal<X, C> + Copy,
) -> impl Mutation<X, Correction = C> + Copy {
    Then(mutation, function)
}

/// Says of any mutation that the way back is as likely.
pub fn forgetful<X: Copy, M: Mutation<X> + Copy>(
    mutation: M,
) -> impl Mutation<X, Correction = Symmetric> + Copy {
    then(mutation, |_, to| Proposal::new(to, Symmetric))
}

/// A weight, whose acceptances can be compared.
pub trait Weighed:
    TargetValue<Acceptance: Copy + PartialEq + Debug + Bits> + Bits + PartialEq + Debug
{
}

impl Weighed for f32 {}
impl<T: Tier> Weighed for LogDensity<T> {}
impl Weighed for u32 {}

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

impl Bits for Chance {
    fn bits(&self) -> Vec<u64> {
        vec![self.words()]
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
