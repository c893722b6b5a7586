//! A random choice of items of a stream.

use super::infallible;
use crate::error::Error;
use crate::num::up_to;
use rand_core::{Rng, TryRng};

/// A random choice of k items of a stream whose length is not known: says where in an array of k each item goes, if anywhere.
///
/// After any number of items the array holds a random choice of them. **Its order is not random**: the first item is in the first
/// place or gone. [`shuffle`](super::shuffle) the array where the order matters.
///
/// # Domain
/// - Places: k from 1 to 2³² − 1. The first k items go to one after the other.
/// - Items: n up to 2³². Of those behind, too many are taken.
/// - Words: one an item, the first k too.
///
/// # Accuracy
/// Each item is held with a probability of k/n, to a relative error of n·2⁻³¹.
///
/// # Examples
/// ```
/// use microwarp::uniform::ChoiceOfStream;
/// use rand_pcg::Pcg32;
/// let (mut choice, mut rng) = (ChoiceOfStream::new(4)?, Pcg32::new(1, 1));
/// let mut kept = [0; 4];
/// for reading in 100..1000 {
///     if let Some(place) = choice.draw(&mut rng) {
///         kept[place as usize] = reading;
///     }
/// }
/// assert!(kept.iter().all(|reading| *reading >= 100));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`ChoiceInOrder`](super::ChoiceInOrder): where n is known.
/// - [`discrete::Reservoir`](crate::discrete::Reservoir): one item, by weight.
///
/// # Source
/// Algorithm R of A. G. Waterman, in J. S. Vitter, "Random Sampling with a Reservoir", 1985, <https://doi.org/10.1145/3147.3165>.
#[doc(alias = "reservoir_sampling")]
#[doc(alias = "streaming")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ChoiceOfStream {
    places: u32,
    seen: u32,
}

impl ChoiceOfStream {
    /// A choice of so many items.
    ///
    /// # Errors
    /// [`Error::Empty`] for none.
    pub const fn new(places: u32) -> Result<Self, Error> {
        if places == 0 {
            return Err(Error::Empty(0));
        }
        Ok(Self { places, seen: 0 })
    }

    /// The place below k where the next item goes, by a random word; `None` where it is not chosen.
    #[inline]
    pub const fn take(&mut self, word: u32) -> Option<u32> {
        let place = if self.seen < self.places {
            self.seen
        } else {
            up_to(self.seen, word)
        };
        self.seen = self.seen.saturating_add(1);
        if place < self.places {
            Some(place)
        } else {
            None
        }
    }

    /// The place where the next item goes; `None` where it is not chosen. One word.
    #[inline]
    pub fn draw<R: Rng + ?Sized>(&mut self, rng: &mut R) -> Option<u32> {
        infallible(self.try_draw(rng))
    }

    /// The place where the next item goes, with a generator that can fail. One word.
    ///
    /// # Errors
    /// The generator's own error. The item counts as not seen then.
    #[inline]
    pub fn try_draw<R: TryRng + ?Sized>(&mut self, rng: &mut R) -> Result<Option<u32>, R::Error> {
        Ok(self.take(rng.try_next_u32()?))
    }
}
