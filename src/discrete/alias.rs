//! A discrete distribution as an alias table: one look-up, whatever the number of entries.

use super::bins::{AliasEntry, Bins};
use super::ladder::Ends;
use super::selection::{ExactSelection, Selection, Share, amount, selections};
use super::source::Source;
use super::storage::Storage;
use super::word::Word;
use crate::error::Error;
use crate::uniform::{Uniforms, infallible};
use rand_core::{Rng, TryRng};

impl<W: Word> AliasEntry<W> {
    /// What memory for a table is filled with before there is one.
    pub const EMPTY: Self = Self {
        threshold: W::ZERO,
        numerator: W::ZERO,
        alias: 0,
    };
}

impl<W: Word> Default for AliasEntry<W> {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// A bounded table that selects an index with probability proportional to its weight, in constant time.
///
/// The leading bits of a word are the bin, the bits after them the coin: no bit serves both. Bins are a
/// power of two in number, as many as the weights or more, so that every bin has the same number of words
/// and the table realises exactly the numerators that the [`Cdf`](super::Cdf) of the same weights has.
///
/// - Storage: an array, a [`heapless::Vec`] or a borrowed slice of [`AliasEntry`], with room for the
///   number of weights rounded up to a power of two; an array's length is such a power itself.
/// - Uniforms, weights, probabilities: those of [`Cdf`](super::Cdf). Words select other indices than
///   there, since an entry's words lie in several bins. For that reason also fewer bits than the word has
///   (the 24 of an `f32`, 32 for a table of `u64`) are off by up to a step for each bin an entry is in.
/// - Leftover: of a word, the coin's place within its part of the bin. From b random bits and 2^m bins it
///   holds b − m bits or fewer.
/// - Time: one look-up and one comparison. Building takes what the `Cdf` takes and two passes, in place.
///
/// Source: A. J. Walker, "An Efficient Method for Generating Discrete Random Variables with General
/// Distributions", 1977; M. D. Vose, "A Linear Algorithm for Generating Random Numbers with a Given
/// Distribution", 1991.
///
/// ```
/// use microwarp::discrete::{Alias, AliasEntry};
/// use rand_pcg::Pcg32;
///
/// const LOADED: Alias<[AliasEntry<u32>; 4]> =
///     match Alias::<[AliasEntry<u32>; 4]>::new(&[1.0, 0.0, 2.0]) {
///         Ok(table) => table,
///         Err(_) => panic!("bad weights"),
///     };
/// assert_eq!(LOADED.entries(), 3);
/// let index = LOADED.draw(&mut Pcg32::new(1, 1)).index;
/// assert!(index == 0 || index == 2);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Alias<S> {
    bins: S,
    entries: u32,
    /// The number of bins is 2 to this power.
    bin_bits: u32,
}

/// What `const` code cannot have of both words at once.
macro_rules! arrays {
    ($($word:ident, $either:ident;)*) => {$(
        impl<const M: usize> Alias<[AliasEntry<$word>; M]> {
            /// The table of these weights, as an array of bins; a power of two of them, which the
            /// compiler checks.
            ///
            /// # Errors
            /// As [`Cdf::new`](super::Cdf::new); [`Error::TooManyWeights`] also for more weights than
            /// bins.
            pub const fn new<const N: usize>(weights: &[f32; N]) -> Result<Self, Error> {
                Self::of(Source::floats(weights), N)
            }

            /// The table of these integer weights, as an array of bins.
            ///
            /// # Errors
            /// As [`Alias::new`], as far as integers can be at fault.
            pub const fn from_integers<const N: usize>(weights: &[u32; N]) -> Result<Self, Error> {
                Self::of(Source::integers(weights), N)
            }

            const fn of(
                source: Result<Source<'_>, Error>,
                entries: usize,
            ) -> Result<Self, Error> {
                const { assert!(M.is_power_of_two(), "bins must be a power of two in number") }
                let source = match source {
                    Ok(source) => source,
                    Err(error) => return Err(error),
                };
                if entries > M || M > super::MAX_ENTRIES {
                    return Err(Error::TooManyWeights);
                }
                match Ends::new(source, $word::BITS) {
                    Ok(ends) => {
                        let mut bins = [AliasEntry::<$word>::EMPTY; M];
                        Bins::$either(&mut bins).lay(ends);
                        Ok(Self::trusted(bins, entries, M))
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

impl<S> Alias<S> {
    /// A table laid out in so many bins.
    const fn trusted(bins: S, entries: usize, count: usize) -> Self
    where
        S: Copy,
    {
        Self {
            bins,
            entries: entries as u32,
            bin_bits: count.trailing_zeros(),
        }
    }
}

impl<W: Word, const M: usize> Alias<[AliasEntry<W>; M]> {
    /// A view of the table.
    #[must_use]
    pub const fn view(&self) -> Alias<&[AliasEntry<W>]> {
        Alias {
            bins: &self.bins,
            entries: self.entries,
            bin_bits: self.bin_bits,
        }
    }
}

impl<W: Word, const M: usize> Alias<heapless::Vec<AliasEntry<W>, M>> {
    /// The table of these weights, as a vector of bounded capacity.
    ///
    /// # Errors
    /// As for an array; [`Error::TooManyWeights`] also where the vector does not hold the number
    /// of weights rounded up to a power of two.
    pub fn new(weights: &[f32]) -> Result<Self, Error> {
        Self::of(Source::floats(weights)?, weights.len())
    }

    /// The table of these integer weights, as a vector of bounded capacity.
    ///
    /// # Errors
    /// As `new`, as far as integers can be at fault.
    pub fn from_integers(weights: &[u32]) -> Result<Self, Error> {
        Self::of(Source::integers(weights)?, weights.len())
    }

    fn of(source: Source<'_>, entries: usize) -> Result<Self, Error> {
        let count = entries.next_power_of_two();
        let mut bins = heapless::Vec::new();
        if bins.resize(count, AliasEntry::EMPTY).is_err() {
            return Err(Error::TooManyWeights);
        }
        W::bins(&mut bins).lay(Ends::new(source, W::BITS)?);
        Ok(Self {
            bins,
            entries: entries as u32,
            bin_bits: count.trailing_zeros(),
        })
    }
}

impl<'a, W: Word> Alias<&'a [AliasEntry<W>]> {
    /// The table of these weights, laid out at the beginning of memory of the caller's.
    ///
    /// # Errors
    /// As for an array; [`Error::TooManyWeights`] also where the memory does not hold the number
    /// of weights rounded up to a power of two. What the memory held is then untouched.
    pub fn new_in(weights: &[f32], memory: &'a mut [AliasEntry<W>]) -> Result<Self, Error> {
        Self::of(Source::floats(weights)?, weights.len(), memory)
    }

    /// The table of these integer weights, laid out at the beginning of memory of the caller's.
    ///
    /// # Errors
    /// As `new_in`, as far as integers can be at fault.
    pub fn from_integers_in(
        weights: &[u32],
        memory: &'a mut [AliasEntry<W>],
    ) -> Result<Self, Error> {
        Self::of(Source::integers(weights)?, weights.len(), memory)
    }

    fn of(
        source: Source<'_>,
        entries: usize,
        memory: &'a mut [AliasEntry<W>],
    ) -> Result<Self, Error> {
        let ends = Ends::new(source, W::BITS)?;
        let count = entries.next_power_of_two();
        let bins = memory.get_mut(..count).ok_or(Error::TooManyWeights)?;
        W::bins(bins).lay(ends);
        Ok(Self::trusted(bins, entries, count))
    }
}

impl<W: Word, S: Storage<Item = AliasEntry<W>>> Alias<S> {
    /// How many entries there are, those of weight zero included; at least one.
    #[must_use]
    #[inline]
    pub fn entries(&self) -> usize {
        self.entries as usize
    }

    /// How many bins there are: the number of entries, rounded up to a power of two or further.
    #[must_use]
    #[inline]
    pub fn bins(&self) -> usize {
        self.bins.items().len()
    }

    #[inline]
    fn bin(&self, index: usize) -> Option<&AliasEntry<W>> {
        self.bins.items().get(index)
    }

    /// Selects an index by a word, and the word's place in its part of the bin.
    #[inline]
    fn locate(&self, word: W) -> Share<W> {
        let bin = word.leading(self.bin_bits);
        let coin = word.trailing(self.bin_bits);
        let part = W::part(self.bin_bits);
        match self.bin(bin) {
            Some(entry) if entry.alias as usize == bin => Share {
                index: bin,
                offset: coin,
                count: part,
            },
            Some(entry) if coin >= entry.threshold => Share {
                index: entry.alias as usize,
                offset: coin.minus(entry.threshold),
                count: part.minus(entry.threshold),
            },
            Some(entry) => Share {
                index: bin,
                offset: coin,
                count: entry.threshold,
            },
            // There is a bin for every leading bits.
            None => Share {
                index: 0,
                offset: W::ZERO,
                count: W::ZERO,
            },
        }
    }

    /// The entry that a word selects, and nothing else.
    #[must_use]
    #[inline]
    pub fn index(&self, word: W) -> usize {
        let bin = word.leading(self.bin_bits);
        match self.bin(bin) {
            // Where the alias is the bin itself it does not matter which is taken.
            Some(entry) if word.trailing(self.bin_bits) >= entry.threshold => entry.alias as usize,
            _ => bin,
        }
    }

    /// How many words an entry has, 0 meaning all; nothing for one that has none.
    #[inline]
    fn count(&self, index: usize) -> Option<W> {
        let entry = self.bin(index)?;
        let some = entry.numerator != W::ZERO || entry.alias as usize == index;
        some.then_some(entry.numerator)
    }

    #[inline]
    fn selection(&self, word: W, fraction: f32, bits: u32) -> Selection {
        let share = self.locate(word);
        share.selection(self.pmf(share.index), fraction, bits)
    }

    selections!(W);
}
