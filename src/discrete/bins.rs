//! How an alias table is laid out: the bins of light entries are filled up with words of heavy ones.

use super::apportionment::Apportionment;

/// A bin of an [`Alias`](super::Alias) table, and the entry of the same index: 12 bytes for `u32`, 24 for `u64`.
///
/// A table's bins can be stored or sent as their three numbers:
/// ```
/// use microwarp::discrete::{Alias, AliasEntry};
/// let table = Alias::<[_; 4]>::new(&[1.0, 0.0, 2.0])?;
/// let sent: Vec<_> = table.as_bins().iter().map(|b| (b.threshold(), b.numerator(), b.alias())).collect();
/// let received: Vec<AliasEntry<u32>> = sent.iter().map(|b| AliasEntry::new(b.0, b.1, b.2)).collect();
/// assert_eq!(Alias::from_bins(received.as_slice(), 3)?, table.view());
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AliasEntry<W> {
    /// How many of the words of this bin select its own entry; the others select its alias.
    pub(crate) threshold: W,
    /// How many words in all select the entry; 0 where it is the alias of its own bin means all.
    pub(crate) numerator: W,
    pub(crate) alias: u32,
}

/// Memory for the bins of a table. `const` code takes it in place of a type parameter.
#[derive(Debug)]
pub enum Bins<'a> {
    U32(&'a mut [AliasEntry<u32>]),
    U64(&'a mut [AliasEntry<u64>]),
}

macro_rules! entry {
    ($($word:ident)*) => {$(
        #[allow(clippy::inline_always, reason = "as that of the bins below")]
        impl AliasEntry<$word> {
            /// The bin of this index before words are given away; all of them wrap to 0.
            #[inline(always)]
            const fn own(words: u128, index: u32) -> Self {
                let numerator = words as $word;
                let all = words >> $word::BITS > 0;
                Self {
                    threshold: if all { $word::MAX } else { numerator },
                    numerator,
                    alias: index,
                }
            }

            /// How many words select the entry of this bin, which has given none away.
            #[inline(always)]
            const fn words(&self) -> u128 {
                if self.numerator == 0 && self.threshold > 0 {
                    1 << $word::BITS
                } else {
                    self.numerator as u128
                }
            }
        }
    )*};
}
entry!(u32 u64);

#[allow(
    clippy::inline_always,
    reason = "which word it is must be known at each place, or firmware of one carries the other"
)]
impl Bins<'_> {
    /// How many bins there are, and how many bits a word has.
    #[inline(always)]
    const fn shape(&self) -> (usize, u32) {
        match self {
            Self::U32(bins) => (bins.len(), u32::BITS),
            Self::U64(bins) => (bins.len(), u64::BITS),
        }
    }

    /// How many words select an entry.
    #[inline(always)]
    const fn words(&self, index: usize) -> Option<u128> {
        match self {
            Self::U32(bins) => match bins.split_at_checked(index) {
                Some((_, [bin, ..])) => Some(bin.words()),
                _ => None,
            },
            Self::U64(bins) => match bins.split_at_checked(index) {
                Some((_, [bin, ..])) => Some(bin.words()),
                _ => None,
            },
        }
    }

    /// Gives an entry the words that select it.
    #[inline(always)]
    const fn own(&mut self, index: usize, words: u128) {
        match self {
            Self::U32(bins) => {
                if let Some((_, [bin, ..])) = bins.split_at_mut_checked(index) {
                    *bin = AliasEntry::<u32>::own(words, index as u32);
                }
            }
            Self::U64(bins) => {
                if let Some((_, [bin, ..])) = bins.split_at_mut_checked(index) {
                    *bin = AliasEntry::<u64>::own(words, index as u32);
                }
            }
        }
    }

    #[inline(always)]
    const fn put(&mut self, index: usize, threshold: u128, alias: usize) {
        match self {
            Self::U32(bins) => {
                if let Some((_, [bin, ..])) = bins.split_at_mut_checked(index) {
                    (bin.threshold, bin.alias) = (threshold as u32, alias as u32);
                }
            }
            Self::U64(bins) => {
                if let Some((_, [bin, ..])) = bins.split_at_mut_checked(index) {
                    (bin.threshold, bin.alias) = (threshold as u64, alias as u32);
                }
            }
        }
    }

    /// Lays the table out in a power of two of bins, at least as many as there are entries.
    #[inline(always)]
    pub(crate) const fn lay(mut self, mut ends: Apportionment<'_>) {
        let (bins, bits) = self.shape();
        let part = 1_u128.wrapping_shl(bits.wrapping_sub(bins.trailing_zeros()));
        let (mut index, mut before) = (0, 0);
        while index < bins {
            let end = match ends.next() {
                Some(end) => end,
                None => before,
            };
            self.own(index, end.wrapping_sub(before));
            before = end;
            index = index.wrapping_add(1);
        }
        self.settle(part);
    }

    /// The first from `from` on that has less than a bin's words, or that has not.
    #[inline(always)]
    const fn seek(&self, part: u128, from: usize, light: bool) -> Option<(usize, u128)> {
        let mut index = from;
        while let Some(words) = self.words(index) {
            if (words < part) == light {
                return Some((index, words));
            }
            index = index.wrapping_add(1);
        }
        None
    }

    /// Fills up the bins of light entries, in order, with words of the heavy ones, in order: what
    /// has been passed is settled, so nothing need be remembered but two places.
    #[inline(always)]
    const fn settle(&mut self, part: u128) {
        // The words of all make a bin's words times the bins, so some entry has a bin's words.
        let Some((mut giver, mut has)) = self.seek(part, 0, false) else {
            return;
        };
        let mut light = 0;
        loop {
            if has < part {
                // The giver has become light itself: the next one fills up its bin.
                let after = giver.wrapping_add(1);
                let Some((next, words)) = self.seek(part, after, false) else {
                    return;
                };
                self.put(giver, has, next);
                has = words.wrapping_sub(part.wrapping_sub(has));
                giver = next;
            } else {
                let Some((taker, words)) = self.seek(part, light, true) else {
                    // Nothing is left to fill: each giver to come fills its own bin.
                    return;
                };
                self.put(taker, words, giver);
                has = has.wrapping_sub(part.wrapping_sub(words));
                light = taker.wrapping_add(1);
            }
        }
    }
}
