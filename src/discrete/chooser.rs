//! An exact choice by the words of a table, and what it leaves of the word.

use super::cdf::Cdf;
use super::selection::Share;
use super::word::Word;
use super::word::sealed::Arithmetic as _;
use crate::error::{Error, tried};
use crate::num::division::scaled;
use crate::num::{LARGEST, up_to, up_to_carried};
use crate::uniform::Uniforms as _;

/// One of N entries by a word, and the rest of the word without a division.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Chooser<const N: usize> {
    table: Cdf<[u32; N]>,
    /// ⌊2⁶⁴/c⌋ − 1 for an entry of c words.
    scales: [u64; N],
    /// The probabilities, correctly rounded.
    pmfs: [f32; N],
}

/// 2⁻⁶⁴.
const STEP: f32 = 1.0 / 18_446_744_073_709_551_616.0;

impl<const N: usize> Chooser<N> {
    pub(super) const fn new(weights: &[f32; N]) -> Result<Self, Error> {
        let table = tried!(Cdf::<[u32; N]>::new(weights));
        let (mut scales, mut pmfs) = ([0; N], [0.0; N]);
        let mut left: (&mut [u64], &mut [f32], &[u32]) = (&mut scales, &mut pmfs, table.ends());
        let (mut start, mut before_last) = (0_u64, table.last());
        while let ([scale, scales @ ..], [pmf, pmfs @ ..], [end, ends @ ..]) = left {
            let end = if before_last > 0 {
                *end as u64
            } else {
                1 << 32
            };
            if end > start {
                let count = end.wrapping_sub(start);
                *scale = scaled(1, count as u128, 64).0.wrapping_sub(1) as u64;
                *pmf = count as f32 * <u32 as Word>::STEP;
            }
            if before_last == 0 {
                break;
            }
            (start, before_last) = (end, before_last.wrapping_sub(1));
            left = (scales, pmfs, ends);
        }
        Ok(Self {
            table,
            scales,
            pmfs,
        })
    }

    #[inline]
    fn scale(&self, index: usize) -> u64 {
        self.scales.get(index).copied().unwrap_or(0)
    }

    /// The entry of a word, and where in its share the word lies: the middle of the word, in steps of 2⁻³².
    #[inline]
    pub(super) fn choose(&self, word: u32) -> (usize, u32) {
        let Share { index, offset, .. } = self.table.locate(word);
        let scale = self.scale(index);
        let (high, low) = ((scale >> 32) as u32, scale as u32);
        // Half of 2⁶⁴/c is added for the middle. The sum is below 2⁶⁴.
        let half = (scale >> 1).wrapping_add(scale & 1);
        let rest = offset
            .wrapping_mul(high)
            .wrapping_add((half >> 32) as u32)
            .wrapping_add(up_to_carried(low, offset, half as u32));
        (index, rest)
    }

    /// The same of a uniform in [0, 1), with all its digits.
    #[inline]
    pub(super) fn choose_uniform(&self, u: f32) -> (usize, f32) {
        let (word, fraction) = u32::from_uniform(u.canonical());
        let Share { index, offset, .. } = self.table.locate(word);
        let rest = (offset.as_f32() + fraction) * (self.scale(index) as f32 * STEP);
        (index, if rest < 1.0 { rest } else { LARGEST })
    }

    /// The probability of an entry, correctly rounded; 0 for a weight of 0.
    #[inline]
    pub(super) fn pmf(&self, index: usize) -> f32 {
        self.pmfs.get(index).copied().unwrap_or(0.0)
    }

    /// The probabilities.
    #[inline]
    pub(super) const fn pmfs(&self) -> &[f32; N] {
        &self.pmfs
    }

    /// How many of the 2³² words give an entry.
    pub(super) fn numerator(&self, index: usize) -> u64 {
        self.table.numerator(index)
    }

    /// A uniform for which [`choose_uniform`](Self::choose_uniform) gives this entry and about this rest. Of an entry with fewer words
    /// than an `f32` can tell apart there, it is the nearest one.
    #[inline]
    pub(super) fn uniform(&self, index: usize, rest: f32) -> f32 {
        let (start, count) = self.table.mass(index).unwrap_or((0, 0));
        if start == 0 {
            // It has all the digits of the rest, far below a word, too.
            let u = rest.canonical().get() * self.pmf(index);
            let (word, _) = u32::from_uniform(u.canonical());
            return if self.table.locate(word).index == index {
                u
            } else {
                f32::from_bits(u.to_bits().wrapping_sub(1))
            };
        }
        let (word, _) = u32::from_uniform(rest.canonical());
        let word = start.wrapping_add(up_to(count.wrapping_sub(1), word));
        // Cut to the 24 digits of an `f32`, or the next one above where that would be before the share.
        let dropped = 8_u32.saturating_sub(word.leading_zeros());
        let cut = (word >> dropped) << dropped;
        let unit = 1_u32 << dropped;
        let cut = if cut < start {
            cut.saturating_add(unit)
        } else {
            cut
        };
        let u = (cut as f32) * u32::STEP;
        if u < 1.0 { u } else { LARGEST }
    }
}
