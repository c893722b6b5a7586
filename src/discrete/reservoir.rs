//! A weighted selection from a stream of unknown length, in constant memory.

use super::total::Total;
use super::word::Word as _;
use crate::error::Error;
use crate::uniform::infallible;
use rand_core::{Rng, TryRng};

/// Weighted reservoir sampling: holds one item of a stream, each with probability proportional to its weight
/// among those seen so far.
///
/// An item of weight w takes the place with probability w/(sum with w), so the length of the stream need not be
/// known. Reservoirs of parts of a stream can be merged.
///
/// # Domain
/// - Weights: finite `f32`, zero or positive. A weight of zero is never held.
/// - Uniforms: one of 64 bits for each offer or merger, which is two `u32` of the generator, whatever the weight.
///
/// # Accuracy
/// A positive weight is taken by at least one of the 2⁶⁴ bit strings when it is offered. The probabilities are
/// off by less than 2⁻⁶³ for each item that follows.
///
/// # Cost
/// The memory of one item and two sums; a 128-bit product an offer.
///
/// # Examples
/// ```
/// use microwarp::discrete::Reservoir;
/// use rand_pcg::Pcg32;
/// let mut rng = Pcg32::new(1, 1);
/// let mut loudest = Reservoir::new();
/// for (time, level) in [0.5, 0.0, 2.0, 1.5].into_iter().enumerate() {
///     loudest.offer(time, level, &mut rng)?;
/// }
/// assert!(loudest.item().is_some_and(|&time| time != 1));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`WeightedReservoir`](super::WeightedReservoir): several items, of integer weights.
/// - [`select_once`](super::select_once): one uniform in all, for weights in a slice.
///
/// # Source
/// M. T. Chao, "A General Purpose Unequal Probability Sampling Plan", Biometrika 69(3), 1982:
/// <https://doi.org/10.1093/biomet/69.3.653>.
#[doc(alias = "reservoir_sampling")]
#[doc(alias = "ris")]
#[doc(alias = "streaming")]
#[doc(alias = "weighted_reservoir")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Reservoir<T> {
    held: Option<(T, Total)>,
    total: Total,
}

impl<T> Default for Reservoir<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T> Reservoir<T> {
    /// An empty reservoir.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            held: None,
            total: Total::ZERO,
        }
    }

    /// Offers an item with a uniform of 64 bits. Returns whether the reservoir took it.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Negative`] for the weight. The reservoir is unchanged after an error.
    pub fn offer_with(&mut self, item: T, weight: f32, bits: u64) -> Result<bool, Error> {
        let weight = Total::of(weight, 1)?;
        Ok(self.take(item, weight, weight, bits))
    }

    /// Offers an item of a given weight. Returns whether the reservoir took it. Draws two `u32`.
    ///
    /// # Errors
    /// Those of [`Reservoir::offer_with`]; the two `u32` have been drawn all the same.
    #[inline]
    pub fn offer<R: Rng + ?Sized>(
        &mut self,
        item: T,
        weight: f32,
        rng: &mut R,
    ) -> Result<bool, Error> {
        infallible(self.try_offer(item, weight, rng))
    }

    /// Offers an item of a given weight, with a generator that can fail. Draws two `u32`.
    ///
    /// # Errors
    /// The outer error is the generator's, the inner one that of [`Reservoir::offer_with`]. The reservoir is
    /// unchanged after either.
    #[inline]
    pub fn try_offer<R: TryRng + ?Sized>(
        &mut self,
        item: T,
        weight: f32,
        rng: &mut R,
    ) -> Result<Result<bool, Error>, R::Error> {
        let bits = u64::try_draw(rng)?;
        Ok(self.offer_with(item, weight, bits))
    }

    /// Merges the reservoir of another part of the stream into this one, with a uniform of 64 bits. Returns
    /// whether the other's item was taken.
    pub fn merge_with(&mut self, other: Self, bits: u64) -> bool {
        match other.held {
            Some((item, own)) => self.take(item, own, other.total, bits),
            None => false,
        }
    }

    /// Merges the reservoir of another part of the stream into this one. Returns whether the other's item was
    /// taken. Draws two `u32`.
    #[inline]
    pub fn merge<R: Rng + ?Sized>(&mut self, other: Self, rng: &mut R) -> bool {
        infallible(self.try_merge(other, rng))
    }

    /// Merges the reservoir of another part of the stream into this one, with a generator that can fail. Draws
    /// two `u32`.
    ///
    /// # Errors
    /// The generator's own error. The reservoir is then unchanged.
    #[inline]
    pub fn try_merge<R: TryRng + ?Sized>(
        &mut self,
        other: Self,
        rng: &mut R,
    ) -> Result<bool, R::Error> {
        let bits = u64::try_draw(rng)?;
        Ok(self.merge_with(other, bits))
    }

    /// Offers an item of weight `own` that adds `mass` to the sum.
    fn take(&mut self, item: T, own: Total, mass: Total, bits: u64) -> bool {
        let taken = self.total.grow(mass, bits);
        if taken {
            self.held = Some((item, own));
        }
        taken
    }

    /// The item held; `None` before the first of positive weight.
    #[must_use]
    pub const fn item(&self) -> Option<&T> {
        match &self.held {
            Some((item, _)) => Some(item),
            None => None,
        }
    }

    /// The probability of holding the item that is held: its weight over the sum, correctly rounded unless
    /// subnormal. 0 while nothing is held, and never 0 afterwards.
    #[must_use]
    pub fn pmf(&self) -> f32 {
        match &self.held {
            Some((_, own)) => own.ratio(self.total),
            None => 0.0,
        }
    }
}
