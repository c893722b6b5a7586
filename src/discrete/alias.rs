//! A discrete distribution as an alias table: one look-up, whatever the number of entries.

use super::ladder::Ends;
use super::selection::{ExactSelection, Selection, Share, amount, selections};
use super::source::Source;
use super::storage::Storage;
use super::word::Word;
use crate::error::Error;
use crate::uniform::{Uniforms, infallible};
use rand_core::{Rng, TryRng};

/// An entry of an [`Alias`] table: 12 bytes for `u32`, 24 for `u64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AliasEntry<W> {
    /// How many of the words of this bin select its own entry; the others select its alias.
    threshold: W,
    /// How many words in all select the entry; 0 where it is the alias of its own bin means all.
    numerator: W,
    alias: u32,
}

macro_rules! empty {
    ($word:ident) => {
        impl AliasEntry<$word> {
            /// What memory for a table is filled with before there is one.
            pub const EMPTY: Self = Self {
                threshold: 0,
                numerator: 0,
                alias: 0,
            };
        }

        impl Default for AliasEntry<$word> {
            fn default() -> Self {
                Self::EMPTY
            }
        }
    };
}

empty!(u32);
empty!(u64);

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

macro_rules! constructors {
    ($word:ident, $lay:ident) => {
        /// Lays the table out in a power of two of bins, at least as many as there are entries.
        const fn $lay(mut ends: Ends<'_>, bins: &mut [AliasEntry<$word>]) {
            let all = 1_u128 << $word::BITS;
            let part = all.wrapping_shr(bins.len().trailing_zeros());
            let mut index = 0_u32;
            let mut before = 0;
            let mut rest: &mut [AliasEntry<$word>] = &mut *bins;
            while let Some((bin, others)) = rest.split_first_mut() {
                let end = match ends.next() {
                    Some(end) => end,
                    None => before,
                };
                // All the words wrap to 0, which the alias of its own bin tells from none.
                let numerator = end.wrapping_sub(before) as $word;
                let whole = end.wrapping_sub(before) == all;
                *bin = AliasEntry {
                    threshold: numerator,
                    numerator,
                    alias: index,
                };
                if whole {
                    bin.threshold = $word::MAX;
                }
                before = end;
                index = index.wrapping_add(1);
                rest = others;
            }
            AliasEntry::<$word>::settle(part, bins);
        }

        impl AliasEntry<$word> {
            /// How many words select an entry.
            const fn of(bins: &[Self], index: usize) -> Option<u128> {
                match bins.split_at_checked(index) {
                    Some((_, [bin, ..])) if bin.numerator == 0 && bin.threshold > 0 => {
                        Some(1 << $word::BITS)
                    }
                    Some((_, [bin, ..])) => Some(bin.numerator as u128),
                    _ => None,
                }
            }

            /// The first from `from` on that has less than a bin's words, or that has not.
            const fn seek(
                part: u128,
                bins: &[Self],
                from: usize,
                light: bool,
            ) -> Option<(usize, u128)> {
                let mut index = from;
                while let Some(words) = Self::of(bins, index) {
                    if (words < part) == light {
                        return Some((index, words));
                    }
                    index = index.wrapping_add(1);
                }
                None
            }

            const fn put(bins: &mut [Self], index: usize, threshold: u128, alias: usize) {
                if let Some((_, [bin, ..])) = bins.split_at_mut_checked(index) {
                    bin.threshold = threshold as $word;
                    bin.alias = alias as u32;
                }
            }

            /// Fills up the bins of light entries, in order, with words of the heavy ones, in order: what
            /// has been passed is settled, so nothing need be remembered but two places.
            const fn settle(part: u128, bins: &mut [Self]) {
                // The words of all make a bin's words times the bins, so some entry has a bin's words.
                let Some((mut giver, mut has)) = Self::seek(part, bins, 0, false) else {
                    return;
                };
                let mut light = 0;
                loop {
                    if has < part {
                        // The giver has become light itself: the next one fills up its bin.
                        let after = giver.wrapping_add(1);
                        let Some((next, words)) = Self::seek(part, bins, after, false) else {
                            return;
                        };
                        Self::put(bins, giver, has, next);
                        has = words.wrapping_sub(part.wrapping_sub(has));
                        giver = next;
                    } else {
                        let Some((taker, words)) = Self::seek(part, bins, light, true) else {
                            // Nothing is left to fill: each giver to come fills its own bin.
                            return;
                        };
                        Self::put(bins, taker, words, giver);
                        has = has.wrapping_sub(part.wrapping_sub(words));
                        light = taker.wrapping_add(1);
                    }
                }
            }
        }

        impl<const M: usize> Alias<[AliasEntry<$word>; M]> {
            /// The table of these weights, as an array of bins; a power of two of them, which the
            /// compiler checks.
            ///
            /// # Errors
            /// As [`Cdf::new`](super::Cdf::new); [`Error::TooManyWeights`] also for more weights than
            /// bins.
            pub const fn new<const N: usize>(weights: &[f32; N]) -> Result<Self, Error> {
                match Source::floats(weights) {
                    Ok(source) => Self::of(source, N),
                    Err(error) => Err(error),
                }
            }

            /// The table of these integer weights, as an array of bins.
            ///
            /// # Errors
            /// As [`Alias::new`], as far as integers can be at fault.
            pub const fn from_integers<const N: usize>(weights: &[u32; N]) -> Result<Self, Error> {
                match Source::integers(weights) {
                    Ok(source) => Self::of(source, N),
                    Err(error) => Err(error),
                }
            }

            const fn of(source: Source<'_>, entries: usize) -> Result<Self, Error> {
                const { assert!(M.is_power_of_two(), "bins must be a power of two in number") }
                if entries > M || M > super::MAX_ENTRIES {
                    return Err(Error::TooManyWeights);
                }
                match Ends::new(source, $word::BITS) {
                    Ok(ends) => {
                        let mut bins = [AliasEntry::<$word>::EMPTY; M];
                        $lay(ends, &mut bins);
                        Ok(Self {
                            bins,
                            entries: entries as u32,
                            bin_bits: M.trailing_zeros(),
                        })
                    }
                    Err(error) => Err(error),
                }
            }

            /// A view of the table.
            #[must_use]
            pub const fn view(&self) -> Alias<&[AliasEntry<$word>]> {
                Alias {
                    bins: &self.bins,
                    entries: self.entries,
                    bin_bits: self.bin_bits,
                }
            }
        }

        impl<const M: usize> Alias<heapless::Vec<AliasEntry<$word>, M>> {
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
                if bins.resize(count, AliasEntry::<$word>::EMPTY).is_err() {
                    return Err(Error::TooManyWeights);
                }
                $lay(Ends::new(source, $word::BITS)?, &mut bins);
                Ok(Self {
                    bins,
                    entries: entries as u32,
                    bin_bits: count.trailing_zeros(),
                })
            }
        }

        impl<'a> Alias<&'a [AliasEntry<$word>]> {
            /// The table of these weights, laid out at the beginning of memory of the caller's.
            ///
            /// # Errors
            /// As for an array; [`Error::TooManyWeights`] also where the memory does not hold the number
            /// of weights rounded up to a power of two. What the memory held is then untouched.
            pub fn new_in(
                weights: &[f32],
                memory: &'a mut [AliasEntry<$word>],
            ) -> Result<Self, Error> {
                Self::of(Source::floats(weights)?, weights.len(), memory)
            }

            /// The table of these integer weights, laid out at the beginning of memory of the caller's.
            ///
            /// # Errors
            /// As `new_in`, as far as integers can be at fault.
            pub fn from_integers_in(
                weights: &[u32],
                memory: &'a mut [AliasEntry<$word>],
            ) -> Result<Self, Error> {
                Self::of(Source::integers(weights)?, weights.len(), memory)
            }

            fn of(
                source: Source<'_>,
                entries: usize,
                memory: &'a mut [AliasEntry<$word>],
            ) -> Result<Self, Error> {
                let ends = Ends::new(source, $word::BITS)?;
                let count = entries.next_power_of_two();
                let bins = memory.get_mut(..count).ok_or(Error::TooManyWeights)?;
                $lay(ends, bins);
                Ok(Self {
                    bins,
                    entries: entries as u32,
                    bin_bits: count.trailing_zeros(),
                })
            }
        }
    };
}

constructors!(u32, lay_u32);
constructors!(u64, lay_u64);

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
