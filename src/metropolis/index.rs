//! Mutations of indices.

use super::{HastingsCounts, Mutation, Proposal, StateSource, Symmetric};
use crate::discrete::{Cdf, Storage, Word};
use crate::error::Error;
use crate::num::up_to_by_two;
use rand_core::TryRng;

/// Proposes any of n indices with equal probability, wherever the chain is.
///
/// # Domain
///
/// - States: 0 to n − 1.
/// - Words: 2, as one fraction of 64 bits.
/// - T(x→x′) = 1/n, to 2⁻⁶⁴.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Mutation, UniformIndex};
/// use rand_pcg::Pcg32;
/// let Ok(proposal) = UniformIndex::new(6)?.try_propose(0, &mut Pcg32::new(1, 1));
/// assert!(proposal.state < 6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`Independence`](super::Independence) of a table, to propose indices by weight.
/// - [`TransitionTable`], where the proposal depends on the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UniformIndex {
    count: u32,
}

impl UniformIndex {
    /// Indices from 0 to `count` − 1.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0.
    pub const fn new(count: u32) -> Result<Self, Error> {
        if count > 0 {
            Ok(Self { count })
        } else {
            Err(Error::NotPositive(0))
        }
    }

    /// How many indices there are.
    #[must_use]
    #[inline]
    pub const fn count(self) -> u32 {
        self.count
    }

    #[inline]
    fn has(self, state: usize) -> bool {
        (state as u64) < u64::from(self.count)
    }
}

impl StateSource<usize> for UniformIndex {
    type Correction = HastingsCounts;

    #[inline]
    fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<usize, R::Error> {
        let (high, low) = (rng.try_next_u32()?, rng.try_next_u32()?);
        Ok(up_to_by_two(self.count.wrapping_sub(1), high, low) as usize)
    }

    #[inline]
    fn pdf_of_state(&self, state: usize) -> f32 {
        if self.has(state) {
            1.0 / self.count as f32
        } else {
            0.0
        }
    }

    #[inline]
    fn ratio_of_states(&self, from: usize, to: usize) -> HastingsCounts {
        HastingsCounts::new(self.has(to).into(), self.has(from).into())
    }
}

impl Mutation<usize> for UniformIndex {
    type Correction = Symmetric;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        _: usize,
        rng: &mut R,
    ) -> Result<Proposal<usize, Symmetric>, R::Error> {
        Ok(Proposal::new(self.try_draw_state(rng)?, Symmetric))
    }
}

/// Proposes indices by a transition matrix T of n states: a draw from the table that belongs to the current state.
///
/// The acceptance turns it into a chain with the target density. A transition without a way back is never accepted.
///
/// # Domain
///
/// - States: 0 to n − 1. A chain at a state out of range stays there.
/// - Words: those of one draw from the table.
/// - T(x→x′) is the pmf of x′ in table x. The Hastings ratio is that of the numerators, as [`HastingsCounts`].
///
/// # Examples
///
/// ```
/// use microwarp::discrete::Cdf;
/// use microwarp::metropolis::{Chain, TransitionTable};
/// use rand_pcg::Pcg32;
/// let rows = [[0.0, 0.5, 0.5], [0.9, 0.0, 0.1], [0.5, 0.5, 0.0]];
/// let row = |i: usize| Cdf::new(&rows[i]);
/// let mutation = TransitionTable::new([row(0)?, row(1)?, row(2)?])?;
/// let weight = |i: usize| [1.0, 2.0, 4.0][i];
/// let step = Chain::new(0, weight)?.step(weight, &mutation, &mut Pcg32::new(1, 1));
/// assert_ne!(step.proposed, 0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`Independence`](super::Independence), with one table for all states.
///
/// # Source
///
/// W. K. Hastings, "Monte Carlo Sampling Methods Using Markov Chains and Their Applications", 1970,
/// [doi:10.1093/biomet/57.1.97](https://doi.org/10.1093/biomet/57.1.97).
#[doc(alias = "markov_matrix")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TransitionTable<S, const N: usize> {
    rows: [Cdf<S>; N],
}

impl<W: Word, S: Storage<Item = W>, const N: usize> TransitionTable<S, N> {
    /// Takes the table of each state in order, each with an entry for every state.
    ///
    /// # Errors
    /// [`Error::NoWeights`] without states, [`Error::NotATable`] if a table does not have N entries.
    pub fn new(rows: [Cdf<S>; N]) -> Result<Self, Error> {
        if N == 0 {
            Err(Error::NoWeights)
        } else if rows.iter().any(|row| row.entries() != N) {
            Err(Error::NotATable)
        } else {
            Ok(Self { rows })
        }
    }
}

impl<S, const N: usize> TransitionTable<S, N> {
    /// The table of each state.
    #[must_use]
    #[inline]
    pub const fn rows(&self) -> &[Cdf<S>; N] {
        &self.rows
    }
}

impl<W: Word, S: Storage<Item = W>, const N: usize> Mutation<usize> for TransitionTable<S, N> {
    type Correction = HastingsCounts;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: usize,
        rng: &mut R,
    ) -> Result<Proposal<usize, HastingsCounts>, R::Error> {
        let word = W::try_draw(rng)?;
        let Some(there) = self.rows.get(from) else {
            return Ok(Proposal::new(from, HastingsCounts::EQUAL));
        };
        let to = there.index(word);
        let counts = match self.rows.get(to) {
            Some(back) => {
                HastingsCounts::new(there.numerator(to).into(), back.numerator(from).into())
            }
            None => HastingsCounts::EQUAL,
        };
        Ok(Proposal::new(to, counts))
    }
}
