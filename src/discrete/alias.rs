//! A discrete distribution as an alias table: one look-up, whatever the number of entries.

use super::apportionment::Apportionment;
use super::bins::{AliasEntry, Bins};
use super::cdf::room;
use super::layout::is_layout;
use super::selection::{ExactSelection, Selection, Share, amount, numerator, selections};
use super::storage::{OwnedStorage, Storage};
use super::weights::Weights;
use super::word::Word;
use crate::error::Error;
use crate::uniform::{Uniforms, infallible};
use rand_core::{Rng, TryRng};

/// A discrete distribution as an alias table: selects an index with probability proportional to its weight,
/// in constant time.
///
/// The leading bits of a word select a bin, the others decide between the bin's own entry and its alias. There
/// are as many bins as weights, rounded up to a power of two, so that every bin has the same number of words.
/// The table therefore has exactly the probabilities of the [`Cdf`](super::Cdf) of the same weights.
///
/// # Domain
/// - Weights and uniforms: those of [`Cdf`](super::Cdf). The same word selects another index than there.
/// - Storage: anything that is a [`Storage`] of [`AliasEntry`], with one entry a bin. The constructors are those
///   of `Cdf`. An array of bins must be a power of two in length, and its type must be given, because the
///   compiler cannot compute it from the number of weights.
///
/// # Accuracy
/// That of [`Cdf`](super::Cdf) for whole words of the table. With fewer bits (32 for a table of `u64`, the 24
/// of an `f32`) an entry is off by up to one step for each bin it is in. The leftover is the place within the
/// entry's part of one bin: from b random bits and 2^m bins it holds b − m bits or fewer.
///
/// # Cost
/// A selection takes one look-up and one comparison. A bin takes 12 bytes with `u32`, 24 with `u64`. Building
/// takes what the `Cdf` takes, and two passes over the bins in place.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::{Alias, AliasEntry}};
/// use rand_pcg::Pcg32;
///
/// const LOADED: Alias<[AliasEntry<u32>; 4]> = constant!(Alias::new(&[1.0, 0.0, 2.0]));
/// assert_eq!(LOADED.entries(), 3);
/// let index = LOADED.draw_index(&mut Pcg32::new(1, 1));
/// assert!(index == 0 || index == 2);
/// ```
///
/// # See also
/// - [`Cdf`](super::Cdf): less memory, and an index that increases with the uniform, which stratified uniforms
///   need.
///
/// # Source
/// - A. J. Walker, "An Efficient Method for Generating Discrete Random Variables with General Distributions",
///   ACM Transactions on Mathematical Software 3(3), 1977: <https://doi.org/10.1145/355744.355749>.
/// - M. D. Vose, "A Linear Algorithm for Generating Random Numbers with a Given Distribution", IEEE Transactions
///   on Software Engineering 17(9), 1991: <https://doi.org/10.1109/32.92917>.
#[doc(alias = "alias_method")]
#[doc(alias = "categorical")]
#[doc(alias = "discrete_distribution")]
#[doc(alias = "multinomial")]
#[doc(alias = "vose")]
#[doc(alias = "walker")]
#[doc(alias = "weighted_alias_index")]
#[doc(alias = "weighted_index")]
#[doc(alias = "WeightedAliasIndex")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Alias<S> {
    bins: S,
    entries: u32,
    /// The number of bins is 2 to this power.
    bin_bits: u32,
}

/// The constructors that `const` code can call: there, code cannot be generic over the word.
macro_rules! arrays {
    ($(
        $word:ident, $either:ident;
        $(#[$new_doc:meta])*
        $new:ident;
        $(#[$integers_doc:meta])*
        $from_integers:ident;
    )*) => {$(
        impl<const M: usize> Alias<[AliasEntry<$word>; M]> {
            $(#[$new_doc])*
            pub const fn $new<const N: usize>(weights: &[f32; N]) -> Result<Self, Error> {
                Self::array(Weights::floats(weights), N)
            }

            $(#[$integers_doc])*
            pub const fn $from_integers<const N: usize>(
                weights: &[u32; N],
            ) -> Result<Self, Error> {
                Self::array(Weights::integers(weights), N)
            }

            const fn array(
                weights: Result<Weights<'_>, Error>,
                entries: usize,
            ) -> Result<Self, Error> {
                const { assert!(M.is_power_of_two(), "bins must be a power of two in number") }
                let weights = match weights {
                    Ok(weights) => weights,
                    Err(error) => return Err(error),
                };
                if entries > M || M > super::MAX_ENTRIES {
                    return Err(Error::TooManyWeights);
                }
                match Apportionment::new(weights, $word::BITS) {
                    Ok(ends) => {
                        let mut bins = [AliasEntry::<$word>::EMPTY; M];
                        Bins::$either(&mut bins).lay(ends);
                        Ok(Self {
                            bins,
                            entries: entries as u32,
                            bin_bits: M.trailing_zeros(),
                        })
                    }
                    Err(error) => Err(error),
                }
            }
        }
    )*};
}

arrays! {
    u32, U32;
    /// The table of an array of weights, with words of 32 bits, in an array of bins. `const`.
    ///
    /// The number of bins must be given. It is a power of two, which the compiler checks, and at least the
    /// number of weights.
    ///
    /// # Errors
    /// Those of [`Cdf::new`](super::Cdf::new); [`Error::TooManyWeights`] also for more weights than bins.
    ///
    /// # Cost
    /// At most 4 times the table and 2 KiB of stack, the table included; up to 8 times without optimisation. For
    /// large tables take [`Alias::new_in`], or with feature `alloc` [`Alias::from_slice`].
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::Alias;
    /// let table = Alias::<[_; 4]>::new(&[1.0, 0.0, 2.0])?;
    /// assert_eq!((table.entries(), table.bins()), (3, 4));
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    /// Without a number of bins the compiler asks for one:
    /// ```compile_fail
    /// use microwarp::discrete::Alias;
    /// let table = Alias::new(&[1.0, 0.0, 2.0])?; // cannot infer the value of the const parameter `M`
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    new;
    /// The table of an array of integer weights, with words of 32 bits, in an array of bins. `const`, and
    /// without a floating-point operation.
    ///
    /// # Errors
    /// Those of [`Alias::new`], except for weights that are negative or not finite.
    from_integers;
    u64, U64;
    /// The table of an array of weights, with words of 64 bits, in an array of bins: for weights of very
    /// different size. `const`.
    ///
    /// # Errors
    /// Those of [`Alias::new`], except [`Error::Unreachable`].
    new_u64;
    /// The table of an array of integer weights, which are `u32` here too, with words of 64 bits, in an array
    /// of bins. `const`, and without a floating-point operation.
    ///
    /// # Errors
    /// Those of [`Alias::from_integers`], except [`Error::Unreachable`].
    from_integers_u64;
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

impl<W: Word, S: Storage<Item = AliasEntry<W>>> Alias<S> {
    /// The table of a slice of weights, in storage of its own: a [`heapless::Vec`], with feature `alloc` a
    /// `Vec` or a `Box`, or your own [`OwnedStorage`].
    ///
    /// # Errors
    /// Those of [`Cdf::new`](super::Cdf::new); [`Error::TooManyWeights`] also where the storage has no room for
    /// the number of weights rounded up to a power of two.
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::{Alias, AliasEntry};
    /// let weights = vec![1.0, 2.0, 1.0];
    /// let table = Alias::<heapless::Vec<AliasEntry<u32>, 16>>::from_slice(&weights)?;
    /// assert_eq!((table.entries(), table.bins()), (3, 4));
    /// # #[cfg(feature = "alloc")] {
    /// let table = Alias::<Vec<AliasEntry<u32>>>::from_slice(&weights)?; // needs feature `alloc`
    /// assert_eq!((table.entries(), table.bins()), (3, 4));
    /// # }
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    pub fn from_slice(weights: &[f32]) -> Result<Self, Error>
    where
        S: OwnedStorage,
    {
        Self::owned(Weights::floats(weights)?, weights.len())
    }

    /// The table of a slice of integer weights, in storage of its own, without a floating-point operation.
    ///
    /// # Errors
    /// Those of [`Alias::from_slice`], except for weights that are negative or not finite.
    pub fn from_integer_slice(weights: &[u32]) -> Result<Self, Error>
    where
        S: OwnedStorage,
    {
        Self::owned(Weights::integers(weights)?, weights.len())
    }

    fn owned(weights: Weights<'_>, entries: usize) -> Result<Self, Error>
    where
        S: OwnedStorage,
    {
        let count = entries.next_power_of_two();
        let mut bins = room(AliasEntry::EMPTY, count)?;
        W::bins(S::items_mut(&mut bins)).lay(Apportionment::new(weights, W::BITS)?);
        Ok(Self {
            bins,
            entries: entries as u32,
            bin_bits: count.trailing_zeros(),
        })
    }
}

impl<'a, W: Word> Alias<&'a [AliasEntry<W>]> {
    /// The table of a slice of weights, laid out at the beginning of borrowed memory.
    ///
    /// # Errors
    /// Those of [`Cdf::new`](super::Cdf::new); [`Error::TooManyWeights`] also where the memory has no room for
    /// the number of weights rounded up to a power of two. The memory is untouched after any error.
    ///
    /// # Cost
    /// At most 2 KiB of stack, whatever the number of weights; up to 8 KiB without optimisation.
    pub fn new_in(weights: &[f32], memory: &'a mut [AliasEntry<W>]) -> Result<Self, Error> {
        Self::borrowed(Weights::floats(weights)?, weights.len(), memory)
    }

    /// The table of a slice of integer weights, laid out at the beginning of borrowed memory, without a
    /// floating-point operation.
    ///
    /// # Errors
    /// Those of [`Alias::new_in`], except for weights that are negative or not finite.
    pub fn from_integers_in(
        weights: &[u32],
        memory: &'a mut [AliasEntry<W>],
    ) -> Result<Self, Error> {
        Self::borrowed(Weights::integers(weights)?, weights.len(), memory)
    }

    fn borrowed(
        weights: Weights<'_>,
        entries: usize,
        memory: &'a mut [AliasEntry<W>],
    ) -> Result<Self, Error> {
        let ends = Apportionment::new(weights, W::BITS)?;
        let count = entries.next_power_of_two();
        let bins = memory.get_mut(..count).ok_or(Error::TooManyWeights)?;
        W::bins(bins).lay(ends);
        Ok(Self {
            bins,
            entries: entries as u32,
            bin_bits: count.trailing_zeros(),
        })
    }
}

impl<W: Word, S: Storage<Item = AliasEntry<W>>> Alias<S> {
    /// A table from the bins of a finished one, as [`Alias::as_bins`] gave them, and its number of entries. All
    /// bins are checked.
    ///
    /// # Errors
    /// Those of [`Alias::from_trusted_bins`]; [`Error::NotATable`] also for bins that no constructor here lays
    /// out.
    pub fn from_bins(bins: S, entries: usize) -> Result<Self, Error> {
        let table = Self::from_trusted_bins(bins, entries)?;
        if is_layout(table.as_bins(), entries) {
            Ok(table)
        } else {
            Err(Error::NotATable)
        }
    }

    /// A table from the bins of a finished one and its number of entries, in constant time: the bins are not
    /// looked at.
    ///
    /// The bins must be those that [`Alias::as_bins`] gave, and the number that of [`Alias::entries`]. With any
    /// other bins the distribution is meaningless, and a selected index may be any `u32`, so check it before
    /// it indexes anything. Still nothing panics or loops, a pmf is in [0, 1] and a leftover in [0, 1).
    ///
    /// # Errors
    /// [`Error::NoWeights`] without entries, [`Error::TooManyWeights`] for more than
    /// [`MAX_ENTRIES`](super::MAX_ENTRIES) bins, [`Error::NotATable`] where the bins are not a power of two in
    /// number or fewer than the entries.
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::Alias;
    /// let sent = Alias::<[_; 4]>::new(&[1.0, 2.0, 1.0])?;
    /// let received = Alias::from_trusted_bins(sent.as_bins(), 3)?;
    /// assert_eq!(received.pmf(1), 0.5);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[inline]
    pub fn from_trusted_bins(bins: S, entries: usize) -> Result<Self, Error> {
        let count = bins.items().len();
        if entries == 0 {
            return Err(Error::NoWeights);
        }
        if count > super::MAX_ENTRIES {
            return Err(Error::TooManyWeights);
        }
        if !count.is_power_of_two() || entries > count {
            return Err(Error::NotATable);
        }
        Ok(Self {
            bins,
            entries: entries as u32,
            bin_bits: count.trailing_zeros(),
        })
    }

    /// The bins of the table.
    #[must_use]
    #[inline]
    pub fn as_bins(&self) -> &[AliasEntry<W>] {
        self.bins.items()
    }

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

    /// The index that a word selects, and the word's place in its part of the bin.
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
            // Never: there is a bin for all leading bits.
            None => Share {
                index: 0,
                offset: W::ZERO,
                count: W::ZERO,
            },
        }
    }

    /// The index that a word selects, and nothing else.
    #[must_use]
    #[inline]
    pub fn index(&self, word: W) -> usize {
        let bin = word.leading(self.bin_bits);
        match self.bin(bin) {
            // Where the alias is the bin itself, either may be taken.
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
