//! The numbers a bin of an alias table is made of, and whether bins are laid out as a table's.

use super::bins::AliasEntry;
use super::word::Word;

impl<W: Word> AliasEntry<W> {
    /// What memory for a table is filled with before there is one.
    pub const EMPTY: Self = Self::new(W::ZERO, W::ZERO, 0);

    /// A bin of a finished table, from its three numbers.
    #[must_use]
    pub const fn new(threshold: W, numerator: W, alias: u32) -> Self {
        Self {
            threshold,
            numerator,
            alias,
        }
    }

    /// How many of the words of this bin select its own entry. The others select its alias.
    #[must_use]
    pub const fn threshold(&self) -> W {
        self.threshold
    }

    /// How many words in all select the entry, modulo 2^[`BITS`](Word::BITS).
    #[must_use]
    pub const fn numerator(&self) -> W {
        self.numerator
    }

    /// The entry that the other words of this bin select.
    #[must_use]
    pub const fn alias(&self) -> u32 {
        self.alias
    }

    /// How many words in all select the entry.
    fn count(&self) -> u128 {
        if self.numerator == W::ZERO && self.threshold > W::ZERO {
            W::TOTAL.into()
        } else {
            W::Count::from(self.numerator).into()
        }
    }
}

impl<W: Word> Default for AliasEntry<W> {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// The first entry from `from` on that has less than a bin's words, or that has not.
fn seek<W: Word>(
    bins: &[AliasEntry<W>],
    part: u128,
    from: usize,
    light: bool,
) -> Option<(usize, u128)> {
    let mut counts = (from..).zip(bins.get(from..)?.iter().map(AliasEntry::count));
    counts.find(|(_, count)| (*count < part) == light)
}

/// Whether so many bins, a power of two, are what `Bins::lay` makes of the entries' numbers of words.
///
/// It goes the way of `Bins::settle` again, which nothing but these numbers decides.
pub(crate) fn is_layout<W: Word>(bins: &[AliasEntry<W>], entries: usize) -> bool {
    let total: u128 = W::TOTAL.into();
    let part = total.wrapping_shr(bins.len().trailing_zeros());
    let (mut sum, mut aliases) = (0_u128, 0_usize);
    for (index, bin) in bins.iter().enumerate() {
        sum = sum.wrapping_add(bin.count());
        if index >= entries && bin.count() > 0 {
            return false;
        }
        if bin.alias as usize != index {
            aliases = aliases.wrapping_add(1);
        } else if bin.count() < total && bin.threshold != bin.numerator {
            return false;
        }
    }
    if sum != total {
        return false;
    }
    // Each bin with an alias is met once, so as many as were counted must be met, and each be right.
    let mut right = |index: usize, words: u128, alias: usize| {
        aliases = aliases.wrapping_sub(1);
        bins.get(index).is_some_and(|bin| {
            W::Count::from(bin.threshold).into() == words && bin.alias as usize == alias
        })
    };
    let Some((mut giver, mut has)) = seek(bins, part, 0, false) else {
        return false;
    };
    let mut light = 0;
    loop {
        if has < part {
            let after = giver.wrapping_add(1);
            let Some((next, words)) = seek(bins, part, after, false) else {
                break;
            };
            if !right(giver, has, next) {
                return false;
            }
            has = words.wrapping_sub(part.wrapping_sub(has));
            giver = next;
        } else {
            let Some((taker, words)) = seek(bins, part, light, true) else {
                break;
            };
            if !right(taker, words, giver) {
                return false;
            }
            has = has.wrapping_sub(part.wrapping_sub(words));
            light = taker.wrapping_add(1);
        }
    }
    aliases == 0
}
