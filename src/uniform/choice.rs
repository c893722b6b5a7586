//! A random choice of some of a known number of items.

use super::infallible;
use super::order::{exchange, first_places};
use crate::error::Error;
use crate::num::up_to;
use rand_core::{Rng, TryRng};

/// Moves `count` random items to the front, in random order. Returns these, and the others.
///
/// # Domain
/// - Items: as for [`shuffle_each`](super::shuffle_each).
/// - Words: one for each item that is chosen.
///
/// # Accuracy
/// All choices of k of n items, in every order, are equally likely to a relative error of k·n·2⁻³².
///
/// # Errors
/// [`Error::OutOfRange`] for more than there are. Nothing has changed then, and no word has been drawn.
///
/// # Examples
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let mut players = ["Ada", "Emmy", "Sofia", "Mary", "Grace"];
/// let (team, bench) = uniform::choose(&mut players, 2, &mut Pcg32::new(1, 1))?;
/// assert_eq!((team.len(), bench.len()), (2, 3));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`ChoiceInOrder`]: items stay where they are.
/// - [`ChoiceOfStream`](super::ChoiceOfStream): it is not known how many items come.
/// - [`Permutation`](super::Permutation): its first k places are a choice without memory.
#[doc(alias = "sample")]
#[doc(alias = "partial_shuffle")]
#[inline]
pub fn choose<'a, T, R: Rng + ?Sized>(
    items: &'a mut [T],
    count: usize,
    rng: &mut R,
) -> Result<(&'a mut [T], &'a mut [T]), Error> {
    infallible(try_choose(items, count, rng))
}

/// [`choose`], with a generator that can fail.
///
/// # Errors
/// The outer error is the generator's; the items may be in another order then. The inner one is that of [`choose`].
#[inline]
#[expect(
    clippy::type_complexity,
    reason = "two errors, and two parts of a slice"
)]
pub fn try_choose<'a, T, R: TryRng + ?Sized>(
    items: &'a mut [T],
    count: usize,
    rng: &mut R,
) -> Result<Result<(&'a mut [T], &'a mut [T]), Error>, R::Error> {
    let all = items.len();
    let done = try_choose_with(all, count, rng, |i, j| exchange(items, i, j))?;
    if let Err(refused) = done {
        return Ok(Err(refused));
    }
    Ok(items
        .split_at_mut_checked(count)
        .ok_or(Error::OutOfRange(1)))
}

/// [`choose`] from what is no slice: moves `chosen` of `count` items to the front, where `swap(i, j)` exchanges items i and j, i < j.
///
/// # Errors
/// That of [`choose`].
///
/// # Examples
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let mut swapped = 0;
/// uniform::choose_with(100, 3, &mut Pcg32::new(1, 1), |_, _| swapped += 1)?;
/// assert!(swapped <= 3);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[inline]
pub fn choose_with<R: Rng + ?Sized>(
    count: usize,
    chosen: usize,
    rng: &mut R,
    swap: impl FnMut(usize, usize),
) -> Result<(), Error> {
    infallible(try_choose_with(count, chosen, rng, swap))
}

/// [`choose_with`], with a generator that can fail.
///
/// # Errors
/// The outer error is the generator's; some items may have been exchanged then. The inner one is that of [`choose`].
#[inline]
pub fn try_choose_with<R: TryRng + ?Sized>(
    count: usize,
    chosen: usize,
    rng: &mut R,
    swap: impl FnMut(usize, usize),
) -> Result<Result<(), Error>, R::Error> {
    if chosen > count {
        return Ok(Err(Error::OutOfRange(1)));
    }
    first_places(count, chosen, rng, swap).map(Ok)
}

/// A random choice of k of n items, which says of one item after the other whether it is chosen.
///
/// Items stay where they are, in their order, and nothing is stored.
///
/// # Domain
/// - Items: n from 0 to 2³² − 1, of which k are chosen. Behind the last, none is.
/// - Words: one an item.
///
/// # Accuracy
/// All choices are equally likely to a relative error of n(n + 1)·2⁻³³. Exactly k items are chosen.
///
/// # Cost
/// Eight bytes; one product an item.
///
/// # Examples
/// ```
/// use microwarp::uniform::ChoiceInOrder;
/// use rand_pcg::Pcg32;
/// let (mut choice, mut rng) = (ChoiceInOrder::new(3, 100)?, Pcg32::new(1, 1));
/// let rows = (0..100).filter(|_| choice.draw(&mut rng));
/// assert_eq!(rows.count(), 3);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`choose`]: k items of a slice, in random order, by k words.
/// - [`ChoiceOfStream`](super::ChoiceOfStream): where n is not known.
///
/// # Source
/// C. T. Fan, M. E. Muller, I. Rezucha, "Development of Sampling Plans by Using Sequential (Item by Item) Selection Techniques and
/// Digital Computers", 1962, <https://doi.org/10.1080/01621459.1962.10480667>.
#[doc(alias = "selection_sampling")]
#[doc(alias = "subset")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ChoiceInOrder {
    /// How many are still to be chosen, and of how many items.
    wanted: u32,
    left: u32,
}

impl ChoiceInOrder {
    /// A choice of `chosen` of `count` items.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for more than there are.
    pub const fn new(chosen: u32, count: u32) -> Result<Self, Error> {
        if chosen > count {
            return Err(Error::OutOfRange(1));
        }
        Ok(Self {
            wanted: chosen,
            left: count,
        })
    }

    /// Whether the next item is chosen, by a random word.
    #[inline]
    pub const fn take(&mut self, word: u32) -> bool {
        self.left = self.left.saturating_sub(1);
        let taken = up_to(self.left, word) < self.wanted;
        if taken {
            self.wanted = self.wanted.wrapping_sub(1);
        }
        taken
    }

    /// Whether the next item is chosen. One word.
    #[inline]
    pub fn draw<R: Rng + ?Sized>(&mut self, rng: &mut R) -> bool {
        infallible(self.try_draw(rng))
    }

    /// Whether the next item is chosen, with a generator that can fail. One word.
    ///
    /// # Errors
    /// The generator's own error. The item counts as not seen then.
    #[inline]
    pub fn try_draw<R: TryRng + ?Sized>(&mut self, rng: &mut R) -> Result<bool, R::Error> {
        Ok(self.take(rng.try_next_u32()?))
    }
}
