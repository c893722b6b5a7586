//! Mutations such as a user may write, each a function: of the state and some words, or of what another mutation proposes.

use microwarp::metropolis::{HastingsCorrection, HastingsRatio, Mutation, Proposal, Symmetric};
use rand_core::TryRng;

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
