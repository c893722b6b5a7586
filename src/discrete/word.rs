//! The words a table is made of and is asked with: `u32` or `u64`.

use super::bins::{AliasEntry, Bins};
use crate::num::division::{fraction, fraction_u32, scaled};
use crate::num::up_to;
use crate::uniform::Canonical;
use core::fmt::Debug;
use core::hash::Hash;
use rand_core::TryRng;

/// What only tables need of a word.
pub(crate) mod sealed {
    use crate::discrete::bins::{AliasEntry, Bins};

    /// Memory for the words of a table, filled from the front. `const` code takes it in place of a type parameter.
    #[derive(Debug)]
    pub enum Words<'a> {
        U32(&'a mut [u32]),
        U64(&'a mut [u64]),
    }

    pub trait Arithmetic: Copy + Ord {
        const ZERO: Self;
        const ONE: Self;
        const MAX: Self;
        fn minus(self, other: Self) -> Self;
        fn plus(self, other: Self) -> Self;
        /// The sum, where it fits a word.
        fn checked_plus(self, other: Self) -> Option<Self>;
        /// The last bits of a number.
        fn low(x: u64) -> Self;
        fn widened(self) -> u64;
        /// The integer from 0 to this that a word gives: ⌊word·(this + 1)/2^BITS⌋.
        fn up_to(self, word: Self) -> Self;
        /// The first word that [`up_to`](Self::up_to)` total - 1` takes to this or beyond, ⌈this·2^BITS/total⌉; 0 for the total,
        /// which no word reaches.
        fn first_word(self, total: Self) -> Self;
        /// The leading `bits` bits as a number; 0 for no bits.
        fn leading(self, bits: u32) -> usize;
        /// All but the leading `bits` bits; at least one must be left.
        fn trailing(self, bits: u32) -> Self;
        /// 2^(BITS - bits), or 0 where that is 2^BITS.
        fn part(bits: u32) -> Self;
        fn as_index(self) -> usize;
        fn as_f32(self) -> f32;
        /// The whole part of a number that is in range.
        fn truncated(x: f32) -> Self;
        /// The exponent of the leading bit; the number must not be 0.
        fn log2(self) -> u32;
        /// The quotient of this and a larger number, in whole steps of 2^-32.
        fn fraction(self, of: Self) -> u32;
        /// The leading 32 bits.
        fn to_bits(self) -> u32;
        fn words(memory: &mut [Self]) -> Words<'_>;
        fn bins(memory: &mut [AliasEntry<Self>]) -> Bins<'_>;
    }
}
use sealed::Arithmetic;
pub(crate) use sealed::Words;

impl Words<'_> {
    pub(crate) const fn bits(&self) -> u32 {
        match self {
            Self::U32(_) => u32::BITS,
            Self::U64(_) => u64::BITS,
        }
    }

    /// How many words are still to come.
    #[inline]
    pub(crate) const fn left(&self) -> usize {
        match self {
            Self::U32(memory) => memory.len(),
            Self::U64(memory) => memory.len(),
        }
    }

    /// Sets the next word to this number, or to the largest word where the number is larger, and returns the rest.
    #[inline]
    pub(crate) const fn then(self, number: u128) -> Self {
        match self {
            Self::U32([slot, rest @ ..]) => {
                *slot = if number < u32::MAX as u128 {
                    number as u32
                } else {
                    u32::MAX
                };
                Self::U32(rest)
            }
            Self::U64([slot, rest @ ..]) => {
                *slot = if number < u64::MAX as u128 {
                    number as u64
                } else {
                    u64::MAX
                };
                Self::U64(rest)
            }
            full => full,
        }
    }
}

/// The words of a table: [`u32`] or [`u64`]. The trait is sealed.
///
/// A table of `u32` has probabilities in steps of 2⁻³², takes one `u32` of the generator, and 4 bytes an entry. A
/// table of `u64` has steps of 2⁻⁶⁴, takes two `u32`, and 8 bytes an entry.
pub trait Word: Arithmetic + Debug + Hash {
    /// Bits in a word.
    const BITS: u32;
    /// 2^−BITS, the step of the probabilities.
    const STEP: f32;
    /// The type of a number of words, which may be all of them: `u64` for `u32`, `u128` for `u64`.
    type Count: Copy + Ord + Debug + From<Self> + Into<u128>;
    /// How many words there are, 2^BITS.
    const TOTAL: Self::Count;

    /// A word whose leading bits are these; the bits it has beyond 32 are 0.
    #[must_use]
    fn from_bits(bits: u32) -> Self;

    /// The word that a uniform truncates to, and the fraction of a word that truncation dropped.
    #[must_use]
    #[inline]
    fn from_uniform(u: Canonical<f32>) -> (Self, f32) {
        // Exact: a power of two times less than 1, and its whole part has no more bits than it had.
        let scaled = u.get() * (1.0 / Self::STEP);
        let word = Self::truncated(scaled);
        (word, scaled - word.as_f32())
    }

    /// Draws a word: one `u32` of the generator for a `u32`, two for a `u64`, the leading one first.
    ///
    /// # Errors
    /// The generator's own error.
    fn try_draw<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self, R::Error>;
}

macro_rules! arithmetic {
    ($word:ident, $fraction:ident, $either:ident, $up_to:expr, $share:expr) => {
        impl Arithmetic for $word {
            const ZERO: Self = 0;
            const ONE: Self = 1;
            const MAX: Self = $word::MAX;
            #[inline]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            #[inline]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline]
            fn checked_plus(self, other: Self) -> Option<Self> {
                self.checked_add(other)
            }
            #[inline]
            fn low(x: u64) -> Self {
                x as Self
            }
            #[inline]
            fn widened(self) -> u64 {
                self.into()
            }
            #[inline]
            fn up_to(self, word: Self) -> Self {
                $up_to(self, word)
            }
            #[inline]
            fn first_word(self, total: Self) -> Self {
                if self >= total {
                    return 0;
                }
                let (quotient, inexact) = $share(self, total);
                quotient.wrapping_add(inexact.into())
            }
            #[inline]
            fn leading(self, bits: u32) -> usize {
                // In two steps, because a shift by all the bits would wrap to no shift.
                (self >> 1).wrapping_shr(($word::BITS - 1).wrapping_sub(bits)) as usize
            }
            #[inline]
            fn trailing(self, bits: u32) -> Self {
                self.wrapping_shl(bits).wrapping_shr(bits)
            }
            #[inline]
            fn part(bits: u32) -> Self {
                let half: Self = 1 << ($word::BITS - 1);
                half.wrapping_shr(bits) << 1
            }
            #[inline]
            fn as_index(self) -> usize {
                // Saturating, so that an index out of range is out of range on every target.
                self.try_into().unwrap_or(usize::MAX)
            }
            #[inline]
            fn as_f32(self) -> f32 {
                self as f32
            }
            #[inline]
            fn truncated(x: f32) -> Self {
                x as Self
            }
            #[inline]
            fn log2(self) -> u32 {
                ($word::BITS - 1).saturating_sub(self.leading_zeros())
            }
            #[inline]
            fn fraction(self, of: Self) -> u32 {
                $fraction(self, of).0
            }
            #[inline]
            fn to_bits(self) -> u32 {
                (self >> ($word::BITS - 32)) as u32
            }
            #[inline]
            fn words(memory: &mut [Self]) -> Words<'_> {
                Words::$either(memory)
            }
            #[inline]
            fn bins(memory: &mut [AliasEntry<Self>]) -> Bins<'_> {
                Bins::$either(memory)
            }
        }
    };
}

/// [`up_to`] of 64 bits.
#[inline]
const fn up_to_wide(last: u64, word: u64) -> u64 {
    let word = word as u128;
    (word.wrapping_mul(last as u128).wrapping_add(word) >> 64) as u64
}

/// ⌊x·2⁶⁴/total⌋ and whether there is a remainder, for `x < total`.
const fn share_wide(x: u64, total: u64) -> (u64, bool) {
    let (quotient, inexact) = scaled(x as u128, total as u128, 64);
    (quotient as u64, inexact)
}

arithmetic!(u32, fraction_u32, U32, up_to, fraction_u32);
arithmetic!(u64, fraction, U64, up_to_wide, share_wide);

impl Word for u32 {
    const BITS: u32 = 32;
    const STEP: f32 = 1.0 / 4_294_967_296.0;
    type Count = u64;
    const TOTAL: u64 = 1 << 32;

    #[inline]
    fn from_bits(bits: u32) -> Self {
        bits
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self, R::Error> {
        rng.try_next_u32()
    }
}

impl Word for u64 {
    const BITS: u32 = 64;
    const STEP: f32 = 1.0 / 18_446_744_073_709_551_616.0;
    type Count = u128;
    const TOTAL: u128 = 1 << 64;

    #[inline]
    fn from_bits(bits: u32) -> Self {
        Self::from(bits) << 32
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self, R::Error> {
        let high = rng.try_next_u32()?;
        let low = rng.try_next_u32()?;
        Ok(Self::from(high) << 32 | Self::from(low))
    }
}

/// The samples of a distribution on integers that has the count of a word.
macro_rules! drawn_by_word {
    () => {
        $crate::discrete::word::drawn_by_word!(u32 by count);
    };
    ($number:ident by $count:ident) => {
        /// The count of any `f32`, brought into [0, 1) by the rule of
        /// [`Uniforms::canonical`](crate::uniform::Uniforms::canonical) first: that of its first 32 bits.
        #[must_use]
        #[inline]
        pub fn sample(&self, u: f32) -> $number {
            let u = $crate::uniform::Uniforms::canonical(u);
            self.$count(<u32 as $crate::discrete::Word>::from_uniform(u).0)
        }

        /// Draws a count from a generator that can fail: one `u32`.
        ///
        /// # Errors
        /// The generator's own error.
        #[inline]
        pub fn try_draw<R: rand_core::TryRng + ?Sized>(
            &self,
            rng: &mut R,
        ) -> Result<$number, R::Error> {
            rng.try_next_u32().map(|word| self.$count(word))
        }

        /// Draws a count: one `u32` of the generator.
        #[inline]
        pub fn draw<R: rand_core::Rng + ?Sized>(&self, rng: &mut R) -> $number {
            $crate::uniform::infallible(self.try_draw(rng))
        }
    };
}
pub(super) use drawn_by_word;
