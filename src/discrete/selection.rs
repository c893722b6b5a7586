//! The result of a selection: the index, its probability, and what is left of the uniform.

use super::word::Word;
use crate::uniform::LARGEST;

/// A selected entry: its index, its probability, and what is left of the uniform.
///
/// # Examples
/// ```
/// use microwarp::discrete::Cdf;
/// let chosen = Cdf::new(&[1.0, 3.0])?.select(0x7000_0000);
/// assert_eq!((chosen.index, chosen.pmf), (1, 0.75));
/// assert_eq!((chosen.leftover, chosen.leftover_bits), (0.25, 31)); // a fresh uniform, for the next decision
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// [`ExactSelection`]: the same in integers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Selection {
    /// The index of the entry.
    pub index: usize,
    /// The probability with which this entry is selected, correctly rounded.
    pub pmf: f32,
    /// Where the uniform fell within the entry's share, in [0, 1). This is again a uniform, independent of the
    /// index.
    pub leftover: f32,
    /// How many random bits the leftover holds, at most: those of the uniform less those spent on the index. An
    /// entry of probability p leaves 32 + log₂ p, rounded down, of 32 bits, and 24 + log₂ p of the 24 bits of an
    /// `f32` ([`select_uniform`](super::Cdf::select_uniform)): p = 1/4 leaves 30 or 22. Below 0 it is 0. An `f32`
    /// shows the leading 24 of them. In an [`Alias`](super::Alias) p is the probability of the entry's part of one
    /// bin. If you need more bits, draw a fresh uniform.
    pub leftover_bits: u32,
}

/// A selected entry in integers alone: what a [`Selection`] says, without rounding.
///
/// The numerator is a `u64` for a table of `u32` and a `u128` for one of `u64`, because it may be the number of all
/// words.
///
/// # Examples
/// ```
/// use microwarp::{constant, discrete::Cdf};
/// const LOADED: Cdf<[u32; 3]> = constant!(Cdf::from_integers(&[1, 0, 3]));
/// let chosen = LOADED.select_exact(0x7000_0000);
/// assert_eq!((chosen.index, chosen.numerator), (2, 3 << 30));
/// assert_eq!(chosen.leftover, 0x4000_0000); // a quarter of its share, which begins at 0x4000_0000
/// assert_eq!(chosen.leftover_bits, 31);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExactSelection<C = u64> {
    /// The index of the entry.
    pub index: usize,
    /// How many of the words select this entry: its probability is this out of
    /// [`Word::TOTAL`](super::Word::TOTAL).
    pub numerator: C,
    /// Where the word fell within the entry's share, in steps of 2⁻³², truncated. These are again 32 bits to
    /// select by, independent of the index.
    pub leftover: u32,
    /// How many random bits the leftover holds, at most, as in [`Selection`]; a leftover can show 32 of them.
    pub leftover_bits: u32,
}

/// A place within the share of an entry: word `offset` of `count` words. A count of 0 means all words.
#[derive(Clone, Copy)]
pub(crate) struct Share<W> {
    pub(crate) index: usize,
    pub(crate) offset: W,
    pub(crate) count: W,
}

impl<W: Word> Share<W> {
    /// The place within the share; `fraction` is the part of a word below the word.
    #[inline]
    pub(crate) fn leftover(&self, fraction: f32) -> f32 {
        let quotient = (self.offset.as_f32() + fraction) / amount(self.count);
        if quotient < 1.0 { quotient } else { LARGEST }
    }

    /// The way from the place to the end of the share, at most 1: 1 less the leftover, with digits of its own.
    #[inline]
    pub(crate) fn rest(&self, fraction: f32) -> f32 {
        let quotient = (amount(self.count.minus(self.offset)) - fraction) / amount(self.count);
        if quotient < 1.0 { quotient } else { 1.0 }
    }

    /// The place within the share in whole steps of 2^-32.
    #[inline]
    pub(crate) fn exact_leftover(&self) -> u32 {
        if self.count == W::ZERO {
            self.offset.to_bits()
        } else {
            self.offset.fraction(self.count)
        }
    }

    /// How many bits the leftover holds where the word had that many.
    #[inline]
    pub(crate) fn bits(&self, of: u32) -> u32 {
        let bits = if self.count == W::ZERO {
            W::BITS
        } else {
            self.count.log2()
        };
        bits.saturating_sub(W::BITS.saturating_sub(of))
    }

    /// The selection in integers, by a word of so many random bits.
    #[inline]
    pub(crate) fn exact(&self, numerator: W::Count, bits: u32) -> ExactSelection<W::Count> {
        ExactSelection {
            index: self.index,
            numerator,
            leftover: self.exact_leftover(),
            leftover_bits: self.bits(bits),
        }
    }

    #[inline]
    pub(crate) fn selection(&self, pmf: f32, fraction: f32, bits: u32) -> Selection {
        Selection {
            index: self.index,
            pmf,
            leftover: self.leftover(fraction),
            leftover_bits: self.bits(bits),
        }
    }
}

/// A number of words, where 0 means all of them.
#[inline]
pub(crate) fn numerator<W: Word>(count: W) -> W::Count {
    if count == W::ZERO {
        W::TOTAL
    } else {
        count.into()
    }
}

/// A number of words as an `f32`, correctly rounded; 0 means all of them.
#[inline]
pub(crate) fn amount<W: Word>(count: W) -> f32 {
    if count == W::ZERO {
        1.0 / W::STEP
    } else {
        count.as_f32()
    }
}

/// The methods that all kinds of table have: selection by bits, by a word, by a uniform, from a generator, and
/// the probabilities. The table provides `locate(word)`, `selection(word, fraction, bits)`, and `count(index)`, the number of
/// words of an entry, where 0 means all. One that may have nothing to select names what selections yield, and provides
/// `exact(word, bits)`.
macro_rules! selections {
    ($word:ident) => {
        selections!($word, Selection, ExactSelection<$word::Count>, usize);

        #[inline]
        fn exact(&self, word: $word, bits: u32) -> ExactSelection<$word::Count> {
            let share = self.locate(word);
            share.exact(self.numerator(share.index), bits)
        }
    };
    ($word:ident, $selection:ty, $exact:ty, $index:ty) => {
        /// Selects by 32 bits.
        #[must_use]
        #[inline]
        pub fn select(&self, bits: u32) -> $selection {
            self.selection($word::from_bits(bits), 0.0, 32)
        }

        /// Selects by a whole word of the table.
        #[must_use]
        #[inline]
        pub fn select_word(&self, word: $word) -> $selection {
            self.selection(word, 0.0, $word::BITS)
        }

        /// Selects by any `f32`, brought into [0, 1) by the rule of
        /// [`Uniforms::canonical`](crate::uniform::Uniforms::canonical) first.
        ///
        /// [`uniform::grid_from_word`](crate::uniform::grid_from_word) of a word selects the entry that the
        /// leading 24 bits of the word select. The bits of the leftover are counted for a 24-bit uniform.
        #[must_use]
        #[inline]
        pub fn select_uniform(&self, u: f32) -> $selection {
            let (word, fraction) = $word::from_uniform(u.canonical());
            self.selection(word, fraction, 24)
        }

        /// Draws an entry from a generator that can fail: one `u32` for a table of `u32`, two for a table of
        /// `u64`.
        ///
        /// # Errors
        /// The generator's own error.
        #[inline]
        pub fn try_draw<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<$selection, R::Error> {
            Ok(self.select_word($word::try_draw(rng)?))
        }

        /// Draws an entry: one `u32` of the generator for a table of `u32`, two for a table of `u64`.
        #[inline]
        pub fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> $selection {
            infallible(self.try_draw(rng))
        }

        /// Selects by 32 bits, without a floating-point operation. The leftover takes a division of 32 digits,
        /// which the compiler drops where the leftover is not used.
        #[must_use]
        #[inline]
        pub fn select_exact(&self, bits: u32) -> $exact {
            self.exact($word::from_bits(bits), 32)
        }

        /// Selects by a whole word of the table, without a floating-point operation.
        #[must_use]
        #[inline]
        pub fn select_exact_word(&self, word: $word) -> $exact {
            self.exact(word, $word::BITS)
        }

        /// Draws an entry without a floating-point operation, from a generator that can fail: one `u32` for a
        /// table of `u32`, two for a table of `u64`.
        ///
        /// # Errors
        /// The generator's own error.
        #[inline]
        pub fn try_draw_exact<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<$exact, R::Error> {
            Ok(self.select_exact_word($word::try_draw(rng)?))
        }

        /// Draws an entry without a floating-point operation: one `u32` of the generator for a table of `u32`,
        /// two for a table of `u64`.
        #[inline]
        pub fn draw_exact<R: Rng + ?Sized>(&self, rng: &mut R) -> $exact {
            infallible(self.try_draw_exact(rng))
        }

        /// Draws the index of an entry and nothing else, from a generator that can fail: one `u32` for a table
        /// of `u32`, two for a table of `u64`.
        ///
        /// # Errors
        /// The generator's own error.
        #[inline]
        pub fn try_draw_index<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<$index, R::Error> {
            Ok(self.index($word::try_draw(rng)?))
        }

        /// Draws the index of an entry and nothing else: one `u32` of the generator for a table of `u32`, two
        /// for a table of `u64`. Take it on cores without an FPU, where pmf and leftover are most of the cost.
        #[inline]
        pub fn draw_index<R: Rng + ?Sized>(&self, rng: &mut R) -> $index {
            infallible(self.try_draw_index(rng))
        }

        /// How many words select an entry: its probability is exactly this out of [`Word::TOTAL`].
        #[must_use]
        #[inline]
        pub fn numerator(&self, index: usize) -> $word::Count {
            self.count(index).map_or($word::ZERO.into(), numerator)
        }

        /// The probability of an entry: the numerator over the total, correctly rounded; 0 beyond the last
        /// entry.
        #[must_use]
        #[inline]
        pub fn pmf(&self, index: usize) -> f32 {
            self.count(index)
                .map_or(0.0, |count| amount(count) * $word::STEP)
        }
    };
}
pub(crate) use selections;
