//! Mixtures: each step picks one of several mutations.

use super::hastings_correction::{Hastings, HastingsCorrection, Stated as _};
use super::{Mutation, Proposal, UniformStep};
use crate::discrete::Cdf;
use crate::error::Error;
use crate::num::nearest;
use rand_core::TryRng;

/// N mutations of the same states: an array of one type, or a tuple of up to eight.
///
/// To mix more, implement [`Mutation`] for an `enum` of mutations and put its values into an array.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a set of {N} mutations of states of type `{X}`",
    label = "not {N} mutations of `{X}`",
    note = "a mixture takes an array of one type, or a tuple of up to eight mutations, and as many weights"
)]
pub trait Mutations<X, const N: usize> {
    /// A form that holds the Hastings ratio of each of them.
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
            // Unreachable: no table gives an index beyond its last entry.
            None => Ok(Proposal::new(from, M::Correction::of(Hastings::One))),
        }
    }
}

/// A form of the Hastings ratio that holds those of several types.
macro_rules! joined {
    ($only:ty) => { $only };
    ($first:ty, $($rest:ty),+) => { <$first as HastingsCorrection>::With<joined!($($rest),+)> };
}
pub(super) use joined;

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
                    // Unreachable: no table gives an index beyond its last entry.
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

/// Proposes by one of N mutations, picked at each step with fixed probabilities.
///
/// Each of the mutations keeps the target stationary by itself, and so does the mixture. Combine them where one alone
/// reaches some states never or slowly. The probabilities change how fast the chain converges, not what it converges to.
///
/// # Domain
///
/// - States: those of the mutations.
/// - Words: one to pick the mutation, then those of the mutation picked.
/// - Hastings ratio: that of the mutation picked. A mixture of symmetric mutations is symmetric.
/// - [`Transition::kind`](super::Transition::kind) tells which was picked; for nested mixtures, that of the outer one.
///
/// # Examples
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
///
/// # See also
///
/// - [`LargeSmall`], the usual mixture in the unit cube.
/// - [`OneCoordinate`](super::OneCoordinate), which picks a coordinate instead of a mutation.
/// - [`discrete::Mixture`](crate::discrete::Mixture), of warps.
///
/// # Source
///
/// L. Tierney, "Markov Chains for Exploring Posterior Distributions", 1994,
/// [doi:10.1214/aos/1176325750](https://doi.org/10.1214/aos/1176325750).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mixture<M, const N: usize> {
    mutations: M,
    table: Cdf<[u32; N]>,
}

impl<M, const N: usize> Mixture<M, N> {
    /// Picks the mutations with probabilities in proportion to the weights. A mutation of weight 0 is never picked.
    ///
    /// Mutations that are not `Copy` go in by reference, or by [`Mixture::from_table`].
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

    /// Picks the mutations by this table. If the compiler builds the table, the program needs no code that builds tables.
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

    /// The table that picks, with probabilities in units of 2⁻³².
    #[must_use]
    pub const fn table(&self) -> &Cdf<[u32; N]> {
        &self.table
    }
}

/// A [`Mixture`] of large steps anywhere in the unit cube ([kind](super::Transition::kind) 0) and small steps (kind 1).
///
/// The states that large steps propose are uniform in the cube, whether accepted or not, so the mean of their densities
/// estimates the normalisation. (A refused one counts as 0 in it.)
#[doc(alias = "pssmlt")]
pub type LargeSmall<S> = Mixture<(UniformStep, S), 2>;

impl<S> LargeSmall<S> {
    /// Takes a large step with this probability, to the nearest multiple of 2⁻³², and a small step otherwise.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a probability outside [0, 1]; [`Error::Unreachable`] for a positive one below 2⁻³³, which
    /// no word would reach.
    pub const fn large_small(probability: f32, small: S) -> Result<Self, Error>
    where
        S: Copy,
    {
        if !(probability >= 0.0 && probability <= 1.0) {
            return Err(Error::OutOfRange(0));
        }
        // Built by hand, so that the program needs no code that builds tables.
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
