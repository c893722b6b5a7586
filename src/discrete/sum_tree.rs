//! A discrete distribution whose weights change: partial sums in place of the weights, as a tree.

use super::selection::{ExactSelection, Selection, Share, amount, numerator, selections};
use super::storage::Storage;
use super::weights::check_number;
use super::word::{Word, Words};
use crate::error::{Error, tried};
use crate::uniform::{Uniforms, infallible};
use rand_core::{Rng, TryRng};

/// A discrete distribution whose integer weights change: selects an index with probability proportional to its weight,
/// and sets a weight, each in log₂ n additions.
///
/// It is a Fenwick tree in place of the weights: where the tree stands, the weights stood, and
/// [`into_weights`](SumTree::into_weights) brings them back. Sums are integers, so they stay exact after any number of
/// changes. (Of float sums a weight that is subtracted leaves a residue, by which an entry of weight 0 can be selected.)
///
/// # Domain
/// - Weights: up to [`MAX_ENTRIES`](super::MAX_ENTRIES) integers, zero or positive, whose sum fits the word: `u32`, or `u64` for
///   larger ones. All may be 0; then selections are `None`.
/// - Uniforms: one, as 32 bits, as an `f32`, or as a word of the tree. A draw takes one `u32` of the generator for a tree of
///   `u32`, two for a tree of `u64`, also where it gives `None`.
/// - Storage: an array; a `heapless::Vec`, or with feature `alloc` a `Vec` or a `Box`; and `&mut` of any of these and of a
///   slice. A [`Storage`] of your own that is `AsMut<[u32]>` will do.
///
/// # Accuracy
/// - Entry i has the words from ⌈c·2³²/W⌉ to ⌈(c + w)·2³²/W⌉ − 1, where c is the sum of the weights before it and W that of
///   all; a tree of `u64` has 2⁶⁴ words. [`numerator`](SumTree::numerator) counts them exactly, and is less than 1 off 2³²·w/W.
/// - A weight of 0 is never selected. A positive weight has at least one word, because there are more words than W.
/// - The same bits select the same index as in a [`Cdf`](super::Cdf) of the same integers.
///
/// Float weights become integers once, by a unit that stays, rounded down; a positive one is at least 1.
///
/// # Cost
/// No memory beside the weights but 8 bytes and a `usize`. Of 4,096 weights `draw_index` takes 12 steps, and neither it nor `set`
/// divides. Probabilities and leftovers take divisions.
///
/// # Examples
/// ```
/// use microwarp::discrete::SumTree;
/// use rand_pcg::Pcg32;
///
/// let mut rng = Pcg32::new(1, 1);
/// let mut weights = [3_u32, 0, 5]; // urgency of three tasks
/// let mut tasks = SumTree::new_in(&mut weights)?;
/// assert_eq!(tasks.total(), 8);
/// let next = tasks.draw_index(&mut rng);
/// assert!(next == Some(0) || next == Some(2));
/// assert_eq!(tasks.set(1, 8), Ok(0)); // the weight that it had
/// assert_eq!(tasks.pmf(1), 0.5);
/// tasks.into_weights();
/// assert_eq!(weights, [3, 8, 5]);
/// # Ok::<(), microwarp::Error>(())
/// ```
/// Made by the compiler, and copied to memory that can change:
/// ```
/// use microwarp::{constant, discrete::SumTree};
/// const URN: SumTree<[u32; 3]> = constant!(SumTree::new([1, 2, 1]));
/// let mut urn = URN;
/// urn.set(2, 0)?;
/// assert_eq!((urn.total(), urn.numerator(2)), (3, 0));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Cdf`](super::Cdf), [`Alias`](super::Alias): faster draws, for weights that stay.
/// - [`WeightedReservoir`](super::WeightedReservoir): several items of a stream.
/// - [`select_once`](super::select_once): for weights of which all change with every selection.
///
/// # Source
/// - P. M. Fenwick, "A New Data Structure for Cumulative Frequency Tables", Software: Practice and Experience 24(3), 1994:
///   <https://doi.org/10.1002/spe.4380240306>.
/// - C. K. Wong and M. C. Easton, "An Efficient Method for Weighted Sampling without Replacement", SIAM Journal on
///   Computing 9(1), 1980: <https://doi.org/10.1137/0209009>.
#[doc(alias = "binary_indexed_tree")]
#[doc(alias = "categorical")]
#[doc(alias = "dynamic_weights")]
#[doc(alias = "fenwick")]
#[doc(alias = "gillespie")]
#[doc(alias = "segment_tree")]
#[doc(alias = "weighted_tree_index")]
#[doc(alias = "WeightedTreeIndex")]
#[doc(alias = "without_replacement")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SumTree<S> {
    /// The sum at the place that is i, counted from 1, is that of as many weights as the last bit of i says, up to this place.
    sums: S,
    /// Below 2^BITS of the word.
    total: u64,
    /// The largest power of two below the number of entries; 0 of one entry.
    step: usize,
}

/// The largest power of two below a number from 1 to [`MAX_ENTRIES`](super::MAX_ENTRIES); 0 for 1.
const fn step(entries: usize) -> usize {
    entries.next_power_of_two() >> 1
}

/// The number without its last bit.
#[inline]
const fn without_last(bits: usize) -> usize {
    bits & bits.wrapping_sub(1)
}

/// Does the same to words of either length.
macro_rules! of_either {
    ($words:expr, $memory:ident => $body:expr) => {
        match $words {
            Words::U32($memory) => $body,
            Words::U64($memory) => $body,
        }
    };
}

/// Of each stretch of twice this length, adds to the last sum the one in the middle; or takes it away again.
macro_rules! level {
    ($memory:ident, $half:ident, $operation:ident) => {
        let mut rest = &mut *$memory;
        while let Some((low, others)) = rest.split_at_mut_checked($half) {
            let Some((high, others)) = others.split_at_mut_checked($half) else {
                break;
            };
            if let ([.., middle], [.., last]) = (low, high) {
                *last = last.$operation(*middle);
            }
            rest = others;
        }
    };
}

/// Makes sums of weights, level by level, and returns the total and the step.
const fn build(words: Words<'_>) -> Result<(u64, usize), Error> {
    let (entries, bits) = (words.left(), words.bits());
    tried!(check_number(entries));
    let step = step(entries);
    of_either!(words, memory => {
        let (mut total, mut rest) = (0_u128, &*memory);
        while let Some((&weight, others)) = rest.split_first() {
            total = total.wrapping_add(weight as u128);
            rest = others;
        }
        if total >> bits > 0 {
            return Err(Error::TooLarge(0));
        }
        let mut half = 1;
        while half < entries {
            level!(memory, half, wrapping_add);
            half <<= 1;
        }
        Ok((total as u64, step))
    })
}

/// Makes weights of sums again.
const fn undo(words: Words<'_>, step: usize) {
    of_either!(words, memory => {
        let mut half = step;
        while half > 0 {
            level!(memory, half, wrapping_sub);
            half >>= 1;
        }
    });
}

/// The constructors that `const` code can call: there, code cannot be generic over the word.
macro_rules! arrays {
    ($($word:ident, $either:ident; $(#[$doc:meta])* $new:ident;)*) => {$(
        impl<const N: usize> SumTree<[$word; N]> {
            $(#[$doc])*
            pub const fn $new(weights: [$word; N]) -> Result<Self, Error> {
                let mut sums = weights;
                let (total, step) = tried!(build(Words::$either(&mut sums)));
                Ok(Self { sums, total, step })
            }
        }
    )*};
}

arrays! {
    u32, U32;
    /// The tree of an array of weights. `const`.
    ///
    /// # Errors
    /// [`Error::NoWeights`], [`Error::TooManyWeights`], [`Error::TooLarge`] for a sum of 2³² or more.
    ///
    /// # Examples
    /// ```
    /// use microwarp::{Error, discrete::SumTree};
    /// assert_eq!(SumTree::new([1, 3])?.pmf(1), 0.75);
    /// assert_eq!(SumTree::new([u32::MAX, 1]), Err(Error::TooLarge(0)));
    /// assert!(SumTree::new_u64([u32::MAX.into(), 1]).is_ok());
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    new;
    u64, U64;
    /// The tree of an array of weights of 64 bits. `const`.
    ///
    /// # Errors
    /// Those of [`SumTree::new`], the last for a sum of 2⁶⁴ or more.
    new_u64;
}

impl<W: Word, S: Storage<Item = W> + AsMut<[W]>> SumTree<S> {
    /// The tree in the memory of its weights: `&mut` of a slice or an array, or a storage by value.
    ///
    /// # Errors
    /// Those of [`SumTree::new`]. The weights are as they were then.
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::SumTree;
    /// let mut weights = [0_u32; 100];
    /// let mut tree = SumTree::new_in(&mut weights[..10])?;
    /// tree.set(7, 1)?;
    /// assert_eq!(tree.select_exact(0x8000_0000).map(|chosen| chosen.index), Some(7));
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    pub fn new_in(weights: S) -> Result<Self, Error> {
        let mut sums = weights;
        let (total, step) = build(W::words(sums.as_mut()))?;
        Ok(Self { sums, total, step })
    }

    /// The weights, where the tree was.
    #[must_use]
    pub fn into_weights(self) -> S {
        let mut weights = self.sums;
        undo(W::words(weights.as_mut()), self.step);
        weights
    }

    /// Sets a weight, and returns the one that was there.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for an index beyond the last entry, [`Error::TooLarge`] where the sum of all weights would not
    /// fit the word. The tree is as it was then.
    #[inline]
    pub fn set(&mut self, index: usize, weight: W) -> Result<W, Error> {
        let before = self.get(index).ok_or(Error::OutOfRange(0))?;
        let others = W::low(self.total).minus(before);
        let total = others.checked_plus(weight).ok_or(Error::TooLarge(1))?;
        let difference = weight.minus(before);
        let (sums, mut at) = (self.sums.as_mut(), index);
        while let Some(sum) = sums.get_mut(at) {
            *sum = sum.plus(difference);
            at |= at.wrapping_add(1);
        }
        self.total = total.widened();
        Ok(before)
    }

    /// Draws entries one after the other, each from those that are left, and writes down where they stand and what they weigh.
    /// Returns those that it drew: fewer than there is room for where all positive weights are drawn. The weights are as they
    /// were at the end.
    ///
    /// Draws as many words as there is room for, of two `u32` each in a tree of `u64`.
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::SumTree;
    /// use rand_pcg::Pcg32;
    /// let mut urn = SumTree::new([5, 0, 1, 9])?;
    /// let mut winners = [(0, 0); 4];
    /// let drawn = urn.draw_distinct(&mut winners, &mut Pcg32::new(1, 1));
    /// assert_eq!(drawn.len(), 3); // one of the four has no chance
    /// assert_eq!(drawn.iter().map(|&(_, weight)| weight).sum::<u32>(), urn.total());
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[inline]
    pub fn draw_distinct<'c, R: Rng + ?Sized>(
        &mut self,
        chosen: &'c mut [(usize, W)],
        rng: &mut R,
    ) -> &'c [(usize, W)] {
        infallible(self.try_draw_distinct(chosen, rng))
    }

    /// [`draw_distinct`](SumTree::draw_distinct), with a generator that can fail.
    ///
    /// # Errors
    /// The generator's own error. The weights are as they were.
    pub fn try_draw_distinct<'c, R: TryRng + ?Sized>(
        &mut self,
        chosen: &'c mut [(usize, W)],
        rng: &mut R,
    ) -> Result<&'c [(usize, W)], R::Error> {
        let (mut drawn, mut result) = (0_usize, Ok(()));
        for place in chosen.iter_mut() {
            match self.try_draw_index(rng) {
                Ok(index) => {
                    // Lowering a weight is never refused.
                    let taken =
                        index.and_then(|index| Some((index, self.set(index, W::ZERO).ok()?)));
                    if let Some(taken) = taken {
                        *place = taken;
                        drawn = drawn.wrapping_add(1);
                    }
                }
                Err(error) => {
                    result = Err(error);
                    break;
                }
            }
        }
        let drawn = chosen.get(..drawn).unwrap_or(&[]);
        for &(index, weight) in drawn {
            let _ = self.set(index, weight);
        }
        result.map(|()| drawn)
    }
}

impl<W: Word, S: Storage<Item = W>> SumTree<S> {
    /// A tree from the sums of a finished one, as [`SumTree::as_sums`] gave them, in log₂ n steps: the sums are not checked.
    ///
    /// With any other sums the distribution is meaningless, and a selected index may be the number of entries. Still nothing
    /// panics or loops, a pmf is in [0, 1] and a leftover in [0, 1).
    ///
    /// # Errors
    /// [`Error::NoWeights`], [`Error::TooManyWeights`].
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::SumTree;
    /// let tree = SumTree::new([1, 2, 1])?;
    /// assert_eq!(SumTree::from_trusted_sums(*tree.as_sums())?, tree);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[inline]
    pub fn from_trusted_sums(sums: S) -> Result<Self, Error> {
        let entries = sums.items().len();
        check_number(entries)?;
        let step = step(entries);
        let mut tree = Self {
            sums,
            total: 0,
            step,
        };
        tree.total = tree.before(entries).widened();
        Ok(tree)
    }

    /// The sums that stand in place of the weights.
    #[must_use]
    #[inline]
    pub const fn as_sums(&self) -> &S {
        &self.sums
    }

    /// How many entries there are, those of weight zero included; at least one.
    #[must_use]
    #[inline]
    pub fn entries(&self) -> usize {
        self.sums.items().len()
    }

    /// The sum of all weights.
    #[must_use]
    #[inline]
    pub fn total(&self) -> W {
        W::low(self.total)
    }

    /// The weight of an entry; `None` beyond the last.
    #[must_use]
    #[inline]
    pub fn get(&self, index: usize) -> Option<W> {
        let sums = self.sums.items();
        let mut weight = *sums.get(index)?;
        // What the sum at this place has beyond the weight are the sums at earlier ones.
        let (mut to, from) = (index, index & index.wrapping_add(1));
        while to > from {
            weight = weight.minus(self.sum_at(to));
            to = without_last(to);
        }
        Some(weight)
    }

    /// The sum at a place from 1 up.
    #[inline]
    fn sum_at(&self, place: usize) -> W {
        let sum = self.sums.items().get(place.wrapping_sub(1));
        sum.copied().unwrap_or(W::ZERO)
    }

    /// The sum of so many weights.
    #[inline]
    fn before(&self, entries: usize) -> W {
        let (mut sum, mut left) = (W::ZERO, entries);
        while left > 0 {
            sum = sum.plus(self.sum_at(left));
            left = without_last(left);
        }
        sum
    }

    /// The entry that a point below the total belongs to.
    #[inline]
    fn at(&self, point: W) -> usize {
        let sums = self.sums.items();
        let (mut left, mut index, mut step) = (point, 0_usize, self.step);
        while step > 0 {
            let sum = sums.get(index.wrapping_add(step).wrapping_sub(1));
            let sum = sum.copied().unwrap_or(W::MAX);
            // A mask, not a branch: no processor could predict it. The point is below the largest word.
            let passed = u64::from(sum <= left).wrapping_neg();
            left = left.minus(W::low(sum.widened() & passed));
            index = index.wrapping_add(step & passed as usize);
            step >>= 1;
        }
        index
    }

    /// The point that a word gives, below the total; none where that is 0.
    #[inline]
    fn point(&self, word: W) -> Option<W> {
        let total = self.total();
        (total != W::ZERO).then(|| total.minus(W::ONE).up_to(word))
    }

    /// The entry that a word belongs to; `None` where all weights are 0.
    #[must_use]
    #[inline]
    pub fn index(&self, word: W) -> Option<usize> {
        self.point(word).map(|point| self.at(point))
    }

    /// The words of an entry: the first, and how many, where 0 means all.
    fn words(&self, index: usize) -> Option<(W, W)> {
        let weight = self.get(index)?;
        if weight == W::ZERO {
            return None;
        }
        let (total, before) = (self.total(), self.before(index));
        let first = before.first_word(total);
        let end = before.plus(weight).first_word(total);
        Some((first, end.minus(first)))
    }

    fn count(&self, index: usize) -> Option<W> {
        self.words(index).map(|(_, count)| count)
    }

    fn locate(&self, word: W) -> Option<Share<W>> {
        let index = self.index(word)?;
        let (first, count) = self.words(index)?;
        Some(Share {
            index,
            offset: word.minus(first),
            count,
        })
    }

    fn selection(&self, word: W, fraction: f32, bits: u32) -> Option<Selection> {
        let share = self.locate(word)?;
        Some(share.selection(amount(share.count) * W::STEP, fraction, bits))
    }

    fn exact(&self, word: W, bits: u32) -> Option<ExactSelection<W::Count>> {
        let share = self.locate(word)?;
        Some(share.exact(numerator(share.count), bits))
    }

    selections!(
        W,
        Option<Selection>,
        Option<ExactSelection<W::Count>>,
        Option<usize>
    );
}
