//! What a selection yields: the index, its probability, and what is left of the uniform.

use super::word::Word;
use crate::uniform::LARGEST;

/// An entry that was selected.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Selection {
    /// The index of the entry.
    pub index: usize,
    /// The probability with which this entry is selected, correctly rounded.
    pub pmf: f32,
    /// Where within the entry's share the uniform fell, in [0, 1): again a uniform, independent of the
    /// index.
    pub leftover: f32,
    /// How many random bits the leftover holds, at most; an `f32` can show the leading 24 of them. From
    /// 32 bits, an entry of probability p leaves 32 + log₂ p, rounded down. With fewer than are wanted,
    /// draw a fresh uniform.
    pub leftover_bits: u32,
}

/// A place within the share of an entry: `offset` of `count` words, where a count of 0 means all words.
#[derive(Clone, Copy)]
pub(crate) struct Share<W> {
    pub(crate) index: usize,
    pub(crate) offset: W,
    pub(crate) count: W,
}

impl<W: Word> Share<W> {
    /// The place within the share, `fraction` being what lies below a word.
    #[inline]
    pub(crate) fn leftover(&self, fraction: f32) -> f32 {
        let quotient = (self.offset.as_f32() + fraction) / amount(self.count);
        if quotient < 1.0 { quotient } else { LARGEST }
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

/// A number of words as an `f32`, correctly rounded; 0 means all of them.
#[inline]
pub(crate) fn amount<W: Word>(count: W) -> f32 {
    if count == W::ZERO {
        1.0 / W::STEP
    } else {
        count.as_f32()
    }
}
