//! Mutations that change some coordinates and keep the others.

use super::{Mutation, Proposal};
use crate::error::Error;
use crate::num::up_to;
use rand_core::TryRng;

/// Changes K of D coordinates by a mutation of points of K coordinates.
///
/// # Domain
///
/// - States: `[f32; D]`, in ℝᴰ or the unit cube, as for the mutation.
/// - Words: those of the mutation.
/// - The Hastings ratio is the mutation's. It may depend only on the coordinates that change.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Mutation, Subset, UniformStep};
/// use rand_pcg::Pcg32;
/// let lens = Subset::<_, 2, 5>::new(UniformStep::new(), [3, 4])?;
/// let Ok(proposal) = lens.try_propose([0.5; 5], &mut Pcg32::new(1, 1));
/// assert_eq!(proposal.state[..3], [0.5; 3]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`OneCoordinate`], which picks a coordinate at random.
#[doc(alias = "block")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Subset<M, const K: usize, const D: usize> {
    mutation: M,
    axes: [usize; K],
}

impl<M, const K: usize, const D: usize> Subset<M, K, D> {
    /// Changes the coordinates `axes`, counted from 0. The mutation sees them in this order. Pass a mutation that is not
    /// `Copy` by reference.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a coordinate that does not exist or is named twice, and for an empty list.
    pub const fn new(mutation: M, axes: [usize; K]) -> Result<Self, Error>
    where
        M: Copy,
    {
        let mut rest: &[usize] = &axes;
        while let Some((&axis, others)) = rest.split_first() {
            let mut later = others;
            while let Some((&other, beyond)) = later.split_first() {
                if other == axis {
                    return Err(Error::OutOfRange(1));
                }
                later = beyond;
            }
            if axis >= D {
                return Err(Error::OutOfRange(1));
            }
            rest = others;
        }
        if K == 0 {
            return Err(Error::OutOfRange(1));
        }
        Ok(Self { mutation, axes })
    }

    /// The mutation of the chosen coordinates.
    #[must_use]
    #[inline]
    pub const fn mutation(&self) -> &M {
        &self.mutation
    }

    /// The coordinates that change, in the order in which the mutation sees them.
    #[must_use]
    #[inline]
    pub const fn axes(&self) -> &[usize; K] {
        &self.axes
    }
}

impl<M, const K: usize, const D: usize> Mutation<[f32; D]> for Subset<M, K, D>
where
    M: Mutation<[f32; K]>,
{
    type Correction = M::Correction;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        mut from: [f32; D],
        rng: &mut R,
    ) -> Result<Proposal<[f32; D], M::Correction>, R::Error> {
        let part = self
            .axes
            .map(|axis| from.get(axis).copied().unwrap_or_default());
        Ok(self.mutation.try_propose(part, rng)?.map(|part| {
            for (axis, x) in self.axes.iter().zip(part) {
                if let Some(place) = from.get_mut(*axis) {
                    *place = x;
                }
            }
            from
        }))
    }
}

/// Changes one coordinate, picked at random, by a mutation of a single number.
///
/// Take it in many dimensions, where a step along all coordinates at once is rarely accepted unless it is small.
///
/// # Domain
///
/// - States: `[f32; D]`, in ℝᴰ or the unit cube, as for the mutation.
/// - Words: one to pick the coordinate, then those of the mutation. Each coordinate has probability 1/D, to 2⁻³².
/// - The Hastings ratio is the mutation's.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Mutation, OneCoordinate, UniformStep};
/// use rand_pcg::Pcg32;
/// let one = OneCoordinate::new(UniformStep::new());
/// let Ok(proposal) = one.try_propose([0.5; 32], &mut Pcg32::new(1, 1));
/// assert_eq!(proposal.state.iter().filter(|x| **x != 0.5).count(), 1);
/// ```
///
/// # See also
///
/// - [`Subset`], which always changes the same coordinates.
#[doc(alias = "gibbs")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OneCoordinate<M> {
    mutation: M,
}

impl<M> OneCoordinate<M> {
    /// Changes one coordinate by this mutation.
    #[must_use]
    #[inline]
    pub const fn new(mutation: M) -> Self {
        Self { mutation }
    }

    /// The mutation of the coordinate that is picked.
    #[must_use]
    #[inline]
    pub const fn mutation(&self) -> &M {
        &self.mutation
    }
}

impl<M: Mutation<f32>, const D: usize> Mutation<[f32; D]> for OneCoordinate<M> {
    type Correction = M::Correction;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        mut from: [f32; D],
        rng: &mut R,
    ) -> Result<Proposal<[f32; D], M::Correction>, R::Error> {
        let axis = up_to((D as u32).wrapping_sub(1), rng.try_next_u32()?) as usize;
        // With no coordinates nothing changes, but the words are taken all the same.
        let before = from.get(axis).copied().unwrap_or_default();
        Ok(self.mutation.try_propose(before, rng)?.map(|x| {
            if let Some(place) = from.get_mut(axis) {
                *place = x;
            }
            from
        }))
    }
}
