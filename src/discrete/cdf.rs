//! A discrete distribution as a table of cumulated words, searched by halving.

use super::apportionment::Apportionment;
use super::selection::{ExactSelection, Selection, Share, amount, numerator, selections};
use super::storage::{OwnedStorage, Storage};
use super::weights::Weights;
use super::word::{Word, Words};
use crate::error::Error;
use crate::num::VECTORS;
use crate::uniform::{Uniforms, infallible};
use core::ops::RangeInclusive;
use rand_core::{Rng, TryRng};

/// A discrete distribution, searched by its cumulative sums: selects an index with probability proportional
/// to its weight.
///
/// The table divides the 2³² words of a `u32` (the 2⁶⁴ of a `u64`) among the entries, once. Entry i gets the
/// consecutive words [`words_of(i)`](Cdf::words_of), and a selection is a search for the entry that a word
/// belongs to. The probability that the table reports, [`numerator`](Cdf::numerator) out of [`Word::TOTAL`],
/// is therefore exactly the one with which it selects.
///
/// # Domain
/// - Weights: up to [`MAX_ENTRIES`](super::MAX_ENTRIES) finite `f32` or `u32`, zero or positive, not all zero.
/// - Uniforms: one, as 32 bits, as an `f32`, or as a word of the table. The same bits select the same index in
///   every form. A draw takes one `u32` of the generator for a table of `u32`, two for a table of `u64`.
/// - Storage: anything that is a [`Storage`], with one word an entry.
///
/// | weights | constructor | table |
/// |---|---|---|
/// | an array | [`new`](Cdf::new), [`new_u64`](Cdf::new_u64), both `const` | `Cdf<[u32; N]>`, `Cdf<[u64; N]>` |
/// | a slice | [`from_slice`](Cdf::from_slice) | `Cdf<heapless::Vec<u32, CAPACITY>>`; with feature `alloc` `Cdf<Vec<u32>>` |
/// | a slice, and memory to use | [`new_in`](Cdf::new_in) | `Cdf<&[u32]>` |
/// | none: a finished table | [`from_words`](Cdf::from_words), [`from_trusted_words`](Cdf::from_trusted_words) | of any storage |
///
/// Each of the first three has a twin for integer weights: [`from_integers`](Cdf::from_integers),
/// [`from_integer_slice`](Cdf::from_integer_slice), [`from_integers_in`](Cdf::from_integers_in).
///
/// # Accuracy
/// - A weight of zero is never selected. A positive weight is given at least one word.
/// - In a table of `u32` a probability differs from weight/total by less than 2⁻³², or by at most 2⁻³² where
///   some weight is below such a step. Where the words cannot be divided so, the constructor returns
///   [`Error::Unreachable`].
/// - In a table of `u64` it differs by less than n 2⁻⁶⁴ + 2⁻⁵⁵, and any weights go together, from 2⁻¹⁴⁹ to
///   `f32::MAX`. Weights below a step take their word from the others.
/// - A weight is kept exactly unless it is below 2⁻⁴⁷ of the largest.
/// - Selecting with fewer bits than a word has (32 for a table of `u64`, the 24 of an `f32` for either) gives
///   an entry its share to within one step of 2⁻³² or 2⁻²⁴. An entry below such a step is then either never
///   selected, or more often than its pmf says. Draws use whole words, so they are not affected.
///
/// # Cost
/// A selection takes log₂ n comparisons; of up to 16 entries vectors compare all at once. Building takes one
/// 128-bit division an entry, and two more where some weight is below a step: digit by digit, but for a table of `u32` on a
/// processor of 64 bits, which multiplies. A `const` table is built by the compiler; from some thousand entries on it asks for
/// `#![allow(long_running_const_eval)]`.
///
/// # Examples
/// ```
/// use microwarp::discrete::Cdf;
/// use rand_pcg::Pcg32;
///
/// let table = Cdf::new(&[1.0, 0.0, 2.0, 1.0])?;
/// assert_eq!(table.pmf(2), 0.5);
/// let chosen = table.select_uniform(0.375);
/// assert_eq!((chosen.index, chosen.leftover), (2, 0.25));
/// let index = table.draw_index(&mut Pcg32::new(1, 1));
/// assert_ne!(index, 1);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// Checked by the compiler, and kept in flash:
/// ```
/// use microwarp::{constant, discrete::Cdf};
/// const LOADED: Cdf<[u32; 6]> = constant!(Cdf::from_integers(&[1, 1, 1, 1, 1, 3]));
/// assert_eq!(LOADED.pmf(5), 0.375);
/// ```
///
/// # See also
/// - [`Alias`](super::Alias): the same probabilities from one look-up, in three times the memory or more.
/// - [`SumTree`](super::SumTree): for weights that change.
/// - [`select_once`](super::select_once): without a table, for weights that change with every selection.
/// - [`PiecewiseConstant1d`](super::PiecewiseConstant1d): a point in a cell instead of an index.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapter III.2:
/// <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "categorical")]
#[doc(alias = "cumulative")]
#[doc(alias = "discrete_distribution")]
#[doc(alias = "inversion")]
#[doc(alias = "multinomial")]
#[doc(alias = "weighted_choice")]
#[doc(alias = "weighted_index")]
#[doc(alias = "WeightedIndex")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cdf<S> {
    /// For every entry but the last, the number of words below its end, saturating. In place of the last, the
    /// index of the last entry of positive weight, whose end is beyond all words.
    ends: S,
}

/// Of fewer ends than this vectors compare all sooner than halving finds the one.
const SHORT: usize = 16;

/// Whether longer tables are searched by [`ladder`], which as WASM takes more bytes than a page wants to load.
const LADDER: bool = VECTORS && cfg!(not(target_arch = "wasm32"));

/// How many ends are at most the word; of ends in ascending order.
///
/// A loop that halves spends most of its instructions on counting, and its time depends on where its code lies. Here every
/// level has a length of its own that the compiler knows. The first chooses between two windows of 3·2ᵏ ends that overlap,
/// each further one between the halves of a window, and three ends are compared at once.
// With windows of 2ᵏ ends LLVM shifts what a comparison gives and adds it, which takes five instructions a level; a step of
// 3·2ᵏ it takes by a conditional move, in three.
// Inlined, it would keep its caller from being inlined.
#[inline(never)]
fn ladder<W: Word>(ends: &[W], word: W) -> usize {
    macro_rules! from {
        ($($n:literal)*) => {{
            let window = ends;
            $(
                let (Some(low), Some(high)) = (window.first_chunk::<$n>(), window.last_chunk::<$n>()) else {
                    return 0;
                };
                let window = if high[0] <= word { high } else { low };
            )*
            let start = window.as_ptr().addr().wrapping_sub(ends.as_ptr().addr()) >> size_of::<W>().trailing_zeros();
            let counted = window.map(|end| usize::from(end <= word));
            counted.iter().fold(start, |sum, &one| sum.wrapping_add(one))
        }};
    }
    match ends.len() {
        3..=5 => from!(3),
        6..=11 => from!(6 3),
        12..=23 => from!(12 6 3),
        24..=47 => from!(24 12 6 3),
        48..=95 => from!(48 24 12 6 3),
        96..=191 => from!(96 48 24 12 6 3),
        192..=383 => from!(192 96 48 24 12 6 3),
        384..=767 => from!(384 192 96 48 24 12 6 3),
        768..=1535 => from!(768 384 192 96 48 24 12 6 3),
        1536..=3071 => from!(1536 768 384 192 96 48 24 12 6 3),
        _ => ends.partition_point(|&end| end <= word),
    }
}

/// Fills memory with as many words as there are weights.
pub(crate) const fn fill(mut ends: Apportionment<'_>, mut words: Words<'_>) {
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

/// The constructors that `const` code can call: there, code cannot be generic over the word.
macro_rules! arrays {
    ($(
        $word:ident, $either:ident;
        $(#[$new_doc:meta])*
        $new:ident;
        $(#[$integers_doc:meta])*
        $from_integers:ident;
    )*) => {$(
        impl<const N: usize> Cdf<[$word; N]> {
            $(#[$new_doc])*
            pub const fn $new(weights: &[f32; N]) -> Result<Self, Error> {
                Self::array(Weights::floats(weights))
            }

            $(#[$integers_doc])*
            pub const fn $from_integers(weights: &[u32; N]) -> Result<Self, Error> {
                Self::array(Weights::integers(weights))
            }

            pub(crate) const fn array(weights: Result<Weights<'_>, Error>) -> Result<Self, Error> {
                let mut ends = [0; N];
                match Apportionment::of(weights, $word::BITS) {
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
    /// The table of an array of weights, with words of 32 bits: the usual one. `const`.
    ///
    /// # Errors
    /// [`Error::NoWeights`], [`Error::TooManyWeights`], [`Error::AllZero`]; with the index of the weight
    /// [`Error::NegativeWeight`], [`Error::NotFiniteWeight`], and [`Error::Unreachable`] for a positive weight
    /// that is too small beside the others.
    ///
    /// # Cost
    /// At most 4 times the table and 2 KiB of stack, the table included; up to 8 times without optimisation. For
    /// large tables take [`Cdf::new_in`], or with feature `alloc` [`Cdf::from_slice`].
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::Cdf;
    /// let coin = Cdf::new(&[1.0, 3.0])?;
    /// assert_eq!(coin.pmf(1), 0.75);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    /// The length must be known to the compiler. From a slice it is not:
    /// ```compile_fail
    /// use microwarp::discrete::Cdf;
    /// let weights: &[f32] = &[1.0, 3.0];
    /// let coin = Cdf::new(weights)?; // expected `&[f32; _]`, found `&[f32]`
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    /// [`Cdf::from_slice`] and [`Cdf::new_in`] take slices:
    /// ```
    /// use microwarp::discrete::Cdf;
    /// let weights: &[f32] = &[1.0, 3.0];
    /// let coin = Cdf::<heapless::Vec<u32, 8>>::from_slice(weights)?;
    /// let mut memory = [0_u32; 8];
    /// assert_eq!(Cdf::new_in(weights, &mut memory)?.as_words(), coin.as_words());
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    new;
    /// The table of an array of integer weights, with words of 32 bits. `const`, and without a floating-point
    /// operation.
    ///
    /// # Errors
    /// Those of [`Cdf::new`], except for weights that are negative or not finite.
    from_integers;
    u64, U64;
    /// The table of an array of weights, with words of 64 bits: for weights of very different size. `const`.
    ///
    /// # Errors
    /// Those of [`Cdf::new`], except [`Error::Unreachable`].
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::Cdf;
    /// let table = Cdf::new_u64(&[1e-20, 1.0, 1e-30])?;
    /// assert!(table.pmf(2) > 0.0);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    new_u64;
    /// The table of an array of integer weights, which are `u32` here too, with words of 64 bits. `const`, and
    /// without a floating-point operation.
    ///
    /// # Errors
    /// Those of [`Cdf::from_integers`], except [`Error::Unreachable`].
    from_integers_u64;
}

impl<W: Word, const N: usize> Cdf<[W; N]> {
    /// A view of the table.
    #[must_use]
    pub const fn view(&self) -> Cdf<&[W]> {
        Cdf { ends: &self.ends }
    }
}

impl<const N: usize> Cdf<[u32; N]> {
    /// The words of the table, of which the last is [`last`](Self::last).
    pub(super) const fn ends(&self) -> &[u32; N] {
        &self.ends
    }

    /// The last entry of positive weight.
    pub(super) const fn last(&self) -> usize {
        match self.ends.as_slice() {
            [.., last] => *last as usize,
            [] => 0,
        }
    }
}

impl<W: Word, S: Storage<Item = W>> Cdf<S> {
    /// The table of a slice of weights, in storage of its own: a [`heapless::Vec`], with feature `alloc` a
    /// `Vec` or a `Box`, or your own [`OwnedStorage`].
    ///
    /// # Errors
    /// Those of [`Cdf::new`]; [`Error::TooManyWeights`] also where the storage has no room for them.
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::Cdf;
    /// let weights = vec![1.0, 2.0, 1.0];
    /// let table = Cdf::<heapless::Vec<u32, 16>>::from_slice(&weights)?;
    /// assert_eq!(table.entries(), 3);
    /// # #[cfg(feature = "alloc")] {
    /// let table: Cdf<Vec<u32>> = Cdf::from_slice(&weights)?; // needs feature `alloc`
    /// assert_eq!(table.entries(), 3);
    /// # }
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    /// An array is no such storage, and the compiler says what is:
    /// ```compile_fail
    /// use microwarp::discrete::Cdf;
    /// let table = Cdf::<[u32; 3]>::from_slice(&[1.0, 2.0, 1.0])?;
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
    /// Those of [`Cdf::from_integers`]; [`Error::TooManyWeights`] also where the storage has no room for them.
    pub fn from_integer_slice(weights: &[u32]) -> Result<Self, Error>
    where
        S: OwnedStorage,
    {
        Self::owned(Weights::integers(weights)?, weights.len())
    }

    pub(crate) fn owned(weights: Weights<'_>, entries: usize) -> Result<Self, Error>
    where
        S: OwnedStorage,
    {
        let mut ends = room(W::ZERO, entries)?;
        fill(
            Apportionment::new(weights, W::BITS)?,
            W::words(S::items_mut(&mut ends)),
        );
        Ok(Self { ends })
    }
}

/// Storage of so many items.
pub(crate) fn room<S: OwnedStorage>(item: S::Item, length: usize) -> Result<S, Error> {
    match S::filled(item, length) {
        Some(storage) if storage.items().len() == length => Ok(storage),
        _ => Err(Error::TooManyWeights),
    }
}

impl<'a, W: Word> Cdf<&'a [W]> {
    /// The table of a slice of weights, laid out at the beginning of borrowed memory.
    ///
    /// # Errors
    /// Those of [`Cdf::new`]; [`Error::TooManyWeights`] also where the memory has no room for them. The memory
    /// is untouched after any error.
    ///
    /// # Cost
    /// At most 2 KiB of stack, whatever the number of weights; up to 8 KiB without optimisation.
    pub fn new_in(weights: &[f32], memory: &'a mut [W]) -> Result<Self, Error> {
        Self::borrowed(Weights::floats(weights)?, weights.len(), memory)
    }

    /// The table of a slice of integer weights, laid out at the beginning of borrowed memory, without a
    /// floating-point operation.
    ///
    /// # Errors
    /// Those of [`Cdf::from_integers`]; [`Error::TooManyWeights`] also where the memory has no room for them.
    /// The memory is untouched after any error.
    pub fn from_integers_in(weights: &[u32], memory: &'a mut [W]) -> Result<Self, Error> {
        Self::borrowed(Weights::integers(weights)?, weights.len(), memory)
    }

    pub(crate) fn borrowed(
        weights: Weights<'_>,
        entries: usize,
        memory: &'a mut [W],
    ) -> Result<Self, Error> {
        let ends = Apportionment::new(weights, W::BITS)?;
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
    /// A table from the words of a finished one, as [`Cdf::as_words`] gave them: kept in flash by another
    /// program, or sent over a wire. All words are checked.
    ///
    /// # Errors
    /// [`Error::NoWeights`] without words, [`Error::TooManyWeights`], [`Error::NotATable`] for words that no
    /// table has.
    ///
    /// # See also
    /// [`Cdf::from_trusted_words`] checks nothing but the number of words.
    pub fn from_words(words: S) -> Result<Self, Error> {
        let table = Self::from_trusted_words(words)?;
        let (interior, last) = table.parts();
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
        Ok(table)
    }

    /// A table from the words of a finished one, in constant time: the words are not looked at.
    ///
    /// The words must be those that [`Cdf::as_words`] gave, for the same type of word. With any other words
    /// the distribution is meaningless, and zero weights may be selected. Still nothing panics or loops, every
    /// selected index is below [`Cdf::entries`], a pmf is in [0, 1] and a leftover in [0, 1).
    ///
    /// # Errors
    /// [`Error::NoWeights`] without words, [`Error::TooManyWeights`] for more than
    /// [`MAX_ENTRIES`](super::MAX_ENTRIES).
    ///
    /// # Examples
    /// ```
    /// use microwarp::discrete::Cdf;
    /// let sent = Cdf::new(&[1.0, 2.0, 1.0])?;
    /// let received = Cdf::from_trusted_words(sent.as_words())?;
    /// assert_eq!(received.pmf(1), 0.5);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[inline]
    pub fn from_trusted_words(words: S) -> Result<Self, Error> {
        match words.items().len() {
            0 => Err(Error::NoWeights),
            1..=super::MAX_ENTRIES => Ok(Self::trusted(words)),
            _ => Err(Error::TooManyWeights),
        }
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

    /// The entry that a word belongs to. Every search starts here.
    #[must_use]
    #[inline]
    pub fn index(&self, word: W) -> usize {
        let (ends, last) = self.parts();
        let index = if VECTORS && W::BITS == 32 && ends.len() < SHORT {
            ends.iter().filter(|&&end| end <= word).count()
        } else if LADDER {
            ladder(ends, word)
        } else {
            ends.partition_point(|&end| end <= word)
        };
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
