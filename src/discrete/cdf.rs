//! A discrete distribution as a table of cumulated words, searched by halving.

use super::ladder::Ends;
use super::selection::{ExactSelection, Selection, Share, amount, selections};
use super::source::Source;
use super::storage::Storage;
use super::word::{Word, Words};
use crate::error::Error;
use crate::uniform::{Uniforms, infallible};
use core::ops::RangeInclusive;
use rand_core::{Rng, TryRng};

/// A bounded table that selects an index with probability proportional to its weight.
///
/// The weights are turned once into whole numbers of words: of the 2³² words of a `u32` (2⁶⁴ of a
/// `u64`), entry i is given the consecutive words [`Cdf::words_of`], and a selection is nothing but a search
/// for the entry that a word belongs to. So the probability that the table reports, [`Cdf::numerator`]
/// out of [`Word::TOTAL`], is exactly the one with which it selects.
///
/// - Storage: an array (a `const` in flash), a [`heapless::Vec`], or a borrowed slice; `u32` or `u64`.
///   As many words as entries.
/// - Uniforms: one, as 32 bits, as an `f32`, or as a word; drawing takes one `u32` from a table of `u32`,
///   two from a table of `u64`. The same bits give the same index in every form.
/// - Weights: up to [`MAX_ENTRIES`](super::MAX_ENTRIES) finite `f32` or `u32`, zero or positive, not all
///   zero. A weight is kept exactly unless it is below 2⁻⁴⁷ of the largest.
/// - A weight of zero is never selected. A positive weight is given at least one word.
/// - How far the probability may differ from weight/total: in a table of `u32` by less than 2⁻³² (by one step
///   at most where some weight is below a step), in a table of `u64` by less than n 2⁻⁶⁴ + 2⁻⁵⁵. Where no
///   division of the 2³² words has every entry within a step of its share and every positive weight at least
///   one, the constructor says [`Error::Unreachable`]; a table of `u64` takes any weights, from 2⁻¹⁴⁹ to
///   `f32::MAX` in one table, and the steps that weights below a step are given are taken from the others.
/// - The full words of the table, which drawing uses, reach every positive weight, each with its pmf. Fewer
///   bits divide their own steps: 32 bits in a table of `u64`, and the 24-bit grid of an `f32` in either,
///   give an entry its share to within one step of 2⁻³² or 2⁻²⁴ (and what the table's own words are off).
///   An entry about such a step or below it is then either not reached or, by the one bit string that its
///   words happen to hold, more often than its pmf says.
/// - Time: log₂ n comparisons. Building takes a 128-bit division an entry, digit by digit, and two more
///   where some weight is below a step; a `const` is built by the compiler. Beyond some thousand entries it
///   asks for `#![allow(long_running_const_eval)]`.
///
/// Source: L. Devroye, "Non-Uniform Random Variate Generation", 1986.
///
/// ```
/// use microwarp::discrete::Cdf;
/// use rand_pcg::Pcg32;
///
/// // Checked by the compiler, kept in flash.
/// const LOADED: Cdf<[u32; 4]> = match Cdf::<[u32; 4]>::new(&[1.0, 0.0, 2.0, 1.0]) {
///     Ok(table) => table,
///     Err(_) => panic!("bad weights"),
/// };
/// assert_eq!(LOADED.pmf(2), 0.5);
/// let chosen = LOADED.select_uniform(0.375);
/// assert_eq!((chosen.index, chosen.leftover), (2, 0.25));
/// let index = LOADED.draw(&mut Pcg32::new(1, 1)).index;
/// assert_ne!(index, 1);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cdf<S> {
    /// For every entry but the last the number of words below its end, saturating; in place of the last
    /// the index of the last entry of positive weight, whose end is beyond all words.
    ends: S,
}

/// Fills memory with as many words as there are weights.
pub(crate) const fn fill(mut ends: Ends<'_>, mut words: Words<'_>) {
    let last = ends.last();
    while words.left() > 0 {
        let end = match ends.next() {
            _ if words.left() == 1 => last as u128,
            Some(end) => end,
            None => u128::MAX,
        };
        words = words.then(end);
    }
}

/// What `const` code cannot have of both words at once.
macro_rules! arrays {
    ($($word:ident, $either:ident;)*) => {$(
        impl<const N: usize> Cdf<[$word; N]> {
            /// The table of these weights, as an array.
            ///
            /// # Errors
            /// [`Error::NoWeights`], [`Error::TooManyWeights`], [`Error::NegativeWeight`] and
            /// [`Error::NotFiniteWeight`] with the index, [`Error::AllZero`], and from a table of `u32`
            /// [`Error::Unreachable`] with the index of a positive weight below a step.
            pub const fn new(weights: &[f32; N]) -> Result<Self, Error> {
                Self::of(Source::floats(weights))
            }

            /// The table of these integer weights, as an array.
            ///
            /// # Errors
            /// As [`Cdf::new`], as far as integers can be at fault.
            pub const fn from_integers(weights: &[u32; N]) -> Result<Self, Error> {
                Self::of(Source::integers(weights))
            }

            const fn of(source: Result<Source<'_>, Error>) -> Result<Self, Error> {
                let mut ends = [0; N];
                match Ends::of(source, $word::BITS) {
                    Ok(steps) => {
                        fill(steps, Words::$either(&mut ends));
                        Ok(Self { ends })
                    }
                    Err(error) => Err(error),
                }
            }
        }
    )*};
}

arrays! {
    u32, U32;
    u64, U64;
}

impl<W: Word, const N: usize> Cdf<[W; N]> {
    /// A view of the table.
    #[must_use]
    pub const fn view(&self) -> Cdf<&[W]> {
        Cdf { ends: &self.ends }
    }
}

impl<W: Word, const N: usize> Cdf<heapless::Vec<W, N>> {
    /// The table of these weights, as a vector of bounded capacity.
    ///
    /// # Errors
    /// As for an array; [`Error::TooManyWeights`] also for more than the vector holds.
    pub fn new(weights: &[f32]) -> Result<Self, Error> {
        Self::of(Source::floats(weights)?, weights.len())
    }

    /// The table of these integer weights, as a vector of bounded capacity.
    ///
    /// # Errors
    /// As [`Cdf::new`], as far as integers can be at fault.
    pub fn from_integers(weights: &[u32]) -> Result<Self, Error> {
        Self::of(Source::integers(weights)?, weights.len())
    }

    fn of(source: Source<'_>, entries: usize) -> Result<Self, Error> {
        let mut ends = heapless::Vec::new();
        if ends.resize(entries, W::ZERO).is_err() {
            return Err(Error::TooManyWeights);
        }
        fill(Ends::new(source, W::BITS)?, W::words(&mut ends));
        Ok(Self { ends })
    }
}

impl<'a, W: Word> Cdf<&'a [W]> {
    /// The table of these weights, laid out at the beginning of memory of the caller's.
    ///
    /// # Errors
    /// As for an array; [`Error::TooManyWeights`] also for more than the memory holds. What the
    /// memory held is then untouched.
    pub fn new_in(weights: &[f32], memory: &'a mut [W]) -> Result<Self, Error> {
        Self::of(Source::floats(weights)?, weights.len(), memory)
    }

    /// The table of these integer weights, laid out at the beginning of memory of the caller's.
    ///
    /// # Errors
    /// As `new_in`, as far as integers can be at fault.
    pub fn from_integers_in(weights: &[u32], memory: &'a mut [W]) -> Result<Self, Error> {
        Self::of(Source::integers(weights)?, weights.len(), memory)
    }

    pub(crate) fn of(
        source: Source<'_>,
        entries: usize,
        memory: &'a mut [W],
    ) -> Result<Self, Error> {
        let ends = Ends::new(source, W::BITS)?;
        let out = memory.get_mut(..entries).ok_or(Error::TooManyWeights)?;
        fill(ends, W::words(out));
        Ok(Self { ends: out })
    }
}

impl<S> Cdf<S> {
    /// A table of words that are known to be one.
    #[inline]
    pub(crate) const fn trusted(ends: S) -> Self {
        Self { ends }
    }
}

impl<W: Word, S: Storage<Item = W>> Cdf<S> {
    /// A table out of the words of a finished one, such as [`Cdf::as_words`] gave: kept in flash by
    /// another program, sent over a wire.
    ///
    /// # Errors
    /// [`Error::NoWeights`] without words, [`Error::TooManyWeights`], [`Error::NotATable`] for words
    /// that are not one.
    pub fn from_words(words: S) -> Result<Self, Error> {
        let items = words.items();
        let (&last, interior) = items.split_last().ok_or(Error::NoWeights)?;
        if items.len() > super::MAX_ENTRIES {
            return Err(Error::TooManyWeights);
        }
        let last = last.as_index();
        if last > interior.len() {
            return Err(Error::NotATable);
        }
        let mut before = W::ZERO;
        for (index, &end) in interior.iter().enumerate() {
            if end < before || (index >= last && end != W::MAX) {
                return Err(Error::NotATable);
            }
            before = end;
        }
        Ok(Self { ends: words })
    }

    /// The words of the table.
    #[must_use]
    #[inline]
    pub fn as_words(&self) -> &[W] {
        self.ends.items()
    }

    /// How many entries there are, those of weight zero included; at least one.
    #[must_use]
    #[inline]
    pub fn entries(&self) -> usize {
        self.ends.items().len()
    }

    /// The ends of all entries but the last, and the last of positive weight.
    #[inline]
    fn parts(&self) -> (&[W], usize) {
        match self.ends.items().split_last() {
            Some((last, interior)) => (interior, last.as_index()),
            None => (&[], 0),
        }
    }

    /// The entry that a word belongs to. The search is here and nowhere else.
    #[must_use]
    #[inline]
    pub fn index(&self, word: W) -> usize {
        let (ends, last) = self.parts();
        let index = ends.partition_point(|&end| end <= word);
        if index < last { index } else { last }
    }

    /// The first word of an entry, and how many it has; of an entry of positive weight.
    #[inline]
    pub(crate) fn share(&self, index: usize) -> (W, W) {
        let (ends, last) = self.parts();
        let start = match index.checked_sub(1) {
            Some(before) => ends.get(before).copied().unwrap_or(W::ZERO),
            None => W::ZERO,
        };
        let end = if index < last {
            ends.get(index).copied().unwrap_or(W::ZERO)
        } else {
            // Beyond all words, which is 0 to subtraction that wraps.
            W::ZERO
        };
        (start, end.minus(start))
    }

    #[inline]
    pub(crate) fn locate(&self, word: W) -> Share<W> {
        let index = self.index(word);
        let (start, count) = self.share(index);
        Share {
            index,
            offset: word.minus(start),
            count,
        }
    }

    #[inline]
    fn selection(&self, word: W, fraction: f32, bits: u32) -> Selection {
        let share = self.locate(word);
        share.selection(amount(share.count) * W::STEP, fraction, bits)
    }

    selections!(W);

    /// The first word of an entry and how many it has, 0 meaning all; nothing for one that has none.
    #[inline]
    pub(crate) fn mass(&self, index: usize) -> Option<(W, W)> {
        let (_, last) = self.parts();
        if index > last {
            return None;
        }
        let (start, count) = self.share(index);
        (count != W::ZERO || index == last).then_some((start, count))
    }

    #[inline]
    fn count(&self, index: usize) -> Option<W> {
        self.mass(index).map(|(_, count)| count)
    }

    /// The words that select an entry; none for a weight of zero and beyond the last entry.
    #[must_use]
    #[inline]
    pub fn words_of(&self, index: usize) -> Option<RangeInclusive<W>> {
        let (start, count) = self.mass(index)?;
        Some(start..=start.minus(W::ONE.minus(count)))
    }
}
