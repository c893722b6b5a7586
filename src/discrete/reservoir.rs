//! A weighted selection from a stream of unknown length, in constant memory.

use super::total::Total;
use super::word::Word as _;
use crate::error::Error;
use crate::uniform::infallible;
use rand_core::{Rng, TryRng};

/// Holds one item of a stream, each with probability proportional to its weight among those seen so far.
///
/// An item of weight w takes the reservoir with probability w/(sum with w), so that nothing need be known
/// of what is to come. Reservoirs of parts of a stream can be merged.
///
/// - Memory: one item, two sums.
/// - Uniforms: one of 64 bits an offer or merger, which is two `u32` of a generator, taken whatever the
///   weight.
/// - A weight of zero is never held. A positive weight is taken for one bit string in 2⁶⁴ at least when it is
///   offered; the probabilities are off by less than 2⁻⁶³ for each item that follows.
///
/// Source: M. T. Chao, "A General Purpose Unequal Probability Sampling Plan", 1982.
///
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

    /// Offers an item with a uniform of 64 bits; says whether the reservoir took it.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Negative`] for the weight; the reservoir is then unchanged.
    pub fn offer_with(&mut self, item: T, weight: f32, bits: u64) -> Result<bool, Error> {
        let weight = Total::of(weight)?;
        Ok(self.take(item, weight, weight, bits))
    }

    /// Offers an item of a given weight; says whether the reservoir took it. Two words.
    ///
    /// # Errors
    /// As [`Reservoir::offer_with`]; the generator has then been drawn from.
    #[inline]
    pub fn offer<R: Rng + ?Sized>(
        &mut self,
        item: T,
        weight: f32,
        rng: &mut R,
    ) -> Result<bool, Error> {
        infallible(self.try_offer(item, weight, rng))
    }

    /// Offers an item, with a generator that can fail. Two words.
    ///
    /// # Errors
    /// Outside the generator's own error; inside as [`Reservoir::offer_with`]. The reservoir is unchanged
    /// after either.
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

    /// Merges the reservoir of another part of the stream into this one, with a uniform of 64 bits; says
    /// whether the other's item was taken.
    pub fn merge_with(&mut self, other: Self, bits: u64) -> bool {
        match other.held {
            Some((item, own)) => self.take(item, own, other.total, bits),
            None => false,
        }
    }

    /// Merges the reservoir of another part of the stream into this one. Two words.
    #[inline]
    pub fn merge<R: Rng + ?Sized>(&mut self, other: Self, rng: &mut R) -> bool {
        infallible(self.try_merge(other, rng))
    }

    /// Merges, with a generator that can fail. Two words.
    ///
    /// # Errors
    /// The generator's own error; the reservoir is then unchanged.
    #[inline]
    pub fn try_merge<R: TryRng + ?Sized>(
        &mut self,
        other: Self,
        rng: &mut R,
    ) -> Result<bool, R::Error> {
        let bits = u64::try_draw(rng)?;
        Ok(self.merge_with(other, bits))
    }

    /// Takes an item of weight `own` with which the sum grows by `mass`.
    fn take(&mut self, item: T, own: Total, mass: Total, bits: u64) -> bool {
        if mass.is_zero() {
            return false;
        }
        self.total = self.total.plus(mass);
        let taken = mass.contains(bits, self.total);
        if taken {
            self.held = Some((item, own));
        }
        taken
    }

    /// The item held; nothing before the first of positive weight.
    #[must_use]
    pub const fn item(&self) -> Option<&T> {
        match &self.held {
            Some((item, _)) => Some(item),
            None => None,
        }
    }

    /// The probability with which the item held is the one: its weight over the sum, correctly rounded
    /// unless subnormal; 0 while nothing is held, and never 0 afterwards.
    #[must_use]
    pub fn pmf(&self) -> f32 {
        match &self.held {
            Some((_, own)) => own.ratio(self.total),
            None => 0.0,
        }
    }
}
