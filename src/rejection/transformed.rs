//! How counts are proposed and accepted where their distribution is a sum of trials that need not be alike: the hat that
//! binomial and hypergeometric distributions share.

use super::stirling::TAILS;
use crate::num::{happens, power_of_two};
use crate::tier::sqrt;
use core::ops::RangeInclusive;

/// A map from a word to a count, whose density over its bound covers the distribution.
///
/// The hat covers all n and p of binomials, where the nearest it comes is a factor of 1.0009 and a small p is the hardest, and
/// all urns, where it is 1.0008.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Hat {
    /// The mean, cut to an integer.
    whole: u32,
    /// The slope of the map that proposes: in the tails, and at the centre.
    tail: f32,
    slope: f32,
    /// The bits behind the point of a proposal, and its centre in such steps; both slopes in steps of 32.
    places: u32,
    tail_steps: u64,
    slope_steps: u64,
    centre: i64,
    /// The density of proposals at a slope of 1, over its bound.
    scale: f32,
    /// A second word below this accepts whatever does not lie in the tails.
    squeeze: u32,
}

/// How many places a proposal has beyond those of the slopes.
const FINER: u32 = 5;

/// The end of a word, in units of 2⁻³³, from which it proposes counts that are accepted.
const OUT: u64 = 1 << 10;

impl Hat {
    /// Of a variance from 10 up, around a centre from the mean that is cut to an integer. It lies a half above the mean, less a
    /// twentieth of the skewness times the deviation, which is 1 of Poisson's distribution.
    pub(super) fn new(variance: f32, whole: u32, centre: f32) -> Self {
        let slope = 0.966 + 2.5325 * sqrt(variance);
        let accepted = 0.9255 - 3.8 / (slope - 1.6);
        let tail = 0.0247 * slope - 0.056;
        // The slope is below 2^18, and has 31 bits in such steps; the tail has 26 and all its digits.
        let places = 157_u32.wrapping_sub(slope.to_bits() >> 23);
        let steps = 1_u64.wrapping_shl(places) as f32;
        Self {
            whole,
            tail,
            slope,
            places: places.wrapping_add(FINER),
            tail_steps: (tail * steps) as u64,
            slope_steps: (slope * steps) as u64,
            centre: (centre * steps * (1_u32 << FINER) as f32) as i64,
            scale: 1.0 / (1.1266 + 1.16 / (slope - 2.4)),
            squeeze: (accepted * 4_294_967_296.0) as u32,
        }
    }

    /// How far a count is from the mean, whose part behind the point is given.
    #[inline]
    pub(super) fn away(&self, count: u32, rest: f32) -> f32 {
        i64::from(count).wrapping_sub(i64::from(self.whole)) as f32 - rest
    }

    /// One try with two words, of a range of counts. The first word counts from its other end if it is `turned`.
    #[inline]
    pub(super) fn attempt(
        &self,
        words: [u32; 2],
        turned: bool,
        range: RangeInclusive<u32>,
        pmf: impl FnOnce(u32) -> f32,
    ) -> Option<u32> {
        let [place, decision] = words;
        let upper = place >> 31 == 1;
        let rank = if upper { !place } else { place };
        // The end of the words lies at 0, the middle at 2³², and each word between two.
        let end = u64::from(rank << 1 | 1);
        // So far out no decision accepts, and numbers might not fit.
        if end < OUT {
            return None;
        }
        let from_middle = (1_u64 << 32).wrapping_sub(end);
        let straight = self.slope_steps.wrapping_mul(from_middle) >> 33_u32.wrapping_sub(FINER);
        let bent = (self.tail_steps << 33_u32.wrapping_add(FINER)).checked_div(end)?;
        let away = straight
            .wrapping_add(bent)
            .wrapping_sub(self.tail_steps << 1_u32.wrapping_add(FINER));
        let x = if upper == turned {
            self.centre.wrapping_sub_unsigned(away)
        } else {
            self.centre.wrapping_add_unsigned(away)
        };
        let count = i64::from(self.whole).wrapping_add(x.wrapping_shr(self.places));
        let count = u32::try_from(count)
            .ok()
            .filter(|count| range.contains(count))?;
        let end = end as f32 * power_of_two(-33);
        if end >= TAILS && decision < self.squeeze {
            return Some(count);
        }
        let slope = self.tail / (end * end) + self.slope;
        happens(pmf(count) * slope * self.scale, decision).then_some(count)
    }
}
