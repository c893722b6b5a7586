//! Several mutations, of which each step picks one.

use super::hastings_correction::{Hastings, HastingsCorrection, Stated as _};
use super::{Mutation, Proposal, UniformStep};
use crate::discrete::Cdf;
use crate::error::Error;
use crate::num::nearest;
use rand_core::TryRng;

/// N mutations of the same states: an array of one type, or a tuple of up to eight.
///
/// A type of one's own, such as an `enum` of mutations, implements [`Mutation`] and goes into an array.
pub trait Mutations<X, const N: usize> {
    /// What any of them states.
    type Correction: HastingsCorrection;

    /// Proposes by the mutation of this index.
    ///
    /// # Errors
    /// The generator's own error.
    fn try_propose_by<R: TryRng + ?Sized>(
        &self,
        index: usize,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, Self::Correction>, R::Error>;
}

impl<X: Copy, M: Mutation<X>, const N: usize> Mutations<X, N> for [M; N] {
    type Correction = M::Correction;

    #[inline]
    fn try_propose_by<R: TryRng + ?Sized>(
        &self,
        index: usize,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, M::Correction>, R::Error> {
        match self.get(index) {
            Some(mutation) => mutation.try_propose(from, rng),
            // No table has an index beyond its last entry.
            None => Ok(Proposal::new(from, M::Correction::of(Hastings::One))),
        }
    }
}

/// The correction of all of several types.
macro_rules! joined {
    ($only:ty) => { $only };
    ($first:ty, $($rest:ty),+) => { <$first as HastingsCorrection>::With<joined!($($rest),+)> };
}

macro_rules! tuples {
    ($($count:literal: $($mutation:ident $index:tt),+;)*) => {$(
        impl<X: Copy, $($mutation: Mutation<X>),+> Mutations<X, $count> for ($($mutation,)+) {
            type Correction = joined!($($mutation::Correction),+);

            #[inline]
            fn try_propose_by<R: TryRng + ?Sized>(
                &self,
                index: usize,
                from: X,
                rng: &mut R,
            ) -> Result<Proposal<X, Self::Correction>, R::Error> {
                Ok(match index {
                    $($index => {
                        let proposal = self.$index.try_propose(from, rng)?;
                        Proposal {
                            state: proposal.state,
                            correction: Self::Correction::of(proposal.correction.hastings()),
                            kind: proposal.kind,
                        }
                    })+
                    // No table has an index beyond its last entry.
                    _ => Proposal::new(from, Self::Correction::of(Hastings::One)),
                })
            }
        }
    )*};
}

tuples! {
    1: A 0;
    2: A 0, B 1;
    3: A 0, B 1, C 2;
    4: A 0, B 1, C 2, E 3;
    5: A 0, B 1, C 2, E 3, F 4;
    6: A 0, B 1, C 2, E 3, F 4, G 5;
    7: A 0, B 1, C 2, E 3, F 4, G 5, H 6;
    8: A 0, B 1, C 2, E 3, F 4, G 5, H 6, I 7;
}

/// Proposes by one of N mutations, picked at each step with a fixed probability.
///
/// Each of them keeps the target stationary by itself, with its own ratio, and so does the mixture; where one
/// alone would not reach every state, or be slow to, another one can. Their frequencies change
/// how soon, not what the chain converges to.
///
/// - States: those of the mutations.
/// - Words: one, which picks, and those of the mutation picked.
/// - HastingsRatio: that of the mutation picked. Where all are symmetric, so is the mixture.
/// - [`Transition::kind`](super::Transition::kind) says which was picked. (Within a mixture of mixtures, the outer one's.)
///
/// Source: L. Tierney, "Markov Chains for Exploring Posterior Distributions", 1994.
///
/// ```
/// use microwarp::metropolis::{BoxStep, Chain, Mixture};
/// use microwarp::poly as mw;
/// use rand_pcg::Pcg32;
/// let steps = (BoxStep::new([10.0; 2])?, mw::NormalStep::new([0.1; 2])?, mw::LogUniformStep::new(0.01, 1.0)?);
/// let mutation = Mixture::new(steps, &[1.0, 4.0, 4.0])?;
/// let f = |[x, y]: [f32; 2]| 1.0 / (1.0 + x * x + y * y).powi(2);
/// let mut chain = Chain::new([0.0; 2], f)?;
/// let step = chain.step(f, &mutation, &mut Pcg32::new(1, 1));
/// assert!(step.kind < 3);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mixture<M, const N: usize> {
    mutations: M,
    table: Cdf<[u32; N]>,
}

impl<M, const N: usize> Mixture<M, N> {
    /// Picks the mutations with probabilities in the ratio of the weights. One of weight 0 is never picked.
    ///
    /// # Errors
    /// Those of [`Cdf`] for the weights.
    pub const fn new(mutations: M, weights: &[f32; N]) -> Result<Self, Error>
    where
        M: Copy,
    {
        match Cdf::new(weights) {
            Ok(table) => Ok(Self::from_table(mutations, table)),
            Err(error) => Err(error),
        }
    }

    /// Picks the mutations by a table of one's own: built by the compiler, it leaves what builds tables out
    /// of the program.
    #[must_use]
    pub const fn from_table(mutations: M, table: Cdf<[u32; N]>) -> Self {
        Self { mutations, table }
    }

    /// The mutations, in the order of their [kinds](super::Transition::kind).
    #[must_use]
    #[inline]
    pub const fn mutations(&self) -> &M {
        &self.mutations
    }

    /// How often each mutation is picked, in units of 2⁻³².
    #[must_use]
    pub const fn table(&self) -> &Cdf<[u32; N]> {
        &self.table
    }
}

/// A [`Mixture`] of large steps anywhere in the unit cube, of [kind](super::Transition::kind) 0, with small ones of
/// kind 1.
///
/// The states proposed by large steps are uniform in the cube, whatever becomes of them: the mean of their
/// densities estimates the normalisation. (A refused one counts in it as 0.)
pub type LargeSmall<S> = Mixture<(UniformStep, S), 2>;

impl<S> LargeSmall<S> {
    /// Large steps with this probability, to the nearest multiple of 2⁻³², small ones otherwise.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a probability outside [0, 1]; [`Error::Unreachable`] for a positive one
    /// below 2⁻³³, which no word would reach.
    pub const fn large_small(probability: f32, small: S) -> Result<Self, Error>
    where
        S: Copy,
    {
        if !(probability >= 0.0 && probability <= 1.0) {
            return Err(Error::OutOfRange);
        }
        // By hand, which leaves what builds tables out of the program.
        let words = if probability < 1.0 {
            [nearest(probability * 4_294_967_296.0), 1]
        } else {
            [u32::MAX, 0]
        };
        if matches!(words, [0, 1]) && probability > 0.0 {
            return Err(Error::Unreachable(0));
        }
        let table = Cdf::trusted(words);
        Ok(Self::from_table((UniformStep::new(), small), table))
    }
}

impl<X, M, const N: usize> Mutation<X> for Mixture<M, N>
where
    M: Mutations<X, N>,
{
    type Correction = M::Correction;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, M::Correction>, R::Error> {
        let index = self.table.try_draw_index(rng)?;
        let proposal = self.mutations.try_propose_by(index, from, rng)?;
        Ok(Proposal {
            kind: index as u32,
            ..proposal
        })
    }
}
