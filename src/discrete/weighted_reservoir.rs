//! Several items of a stream, drawn by weight without replacement, in integers.

use crate::num::doubles::ln;
use crate::num::up_to;
use crate::uniform::infallible;
use core::f64::consts::{LN_2, LOG2_E};
use core::num::NonZeroU32;
use rand_core::{Rng, TryRng};

/// Weighted reservoir sampling without replacement: holds up to `K` items of a stream of unknown length, drawn one after the
/// other, each by its weight among those that are left.
///
/// Each item gets a time, exponentially distributed with its weight as the rate, and the `K` earliest are held. No item is looked at
/// twice, and reservoirs of parts of a stream merge without a random word.
///
/// # Domain
/// - Weights: any `u32`. A weight of zero is never held. Float weights become integers by
///   [`to_integers`](super::resampling::to_integers), or by a unit of your own.
/// - Uniforms: one word an item, whatever its weight.
///
/// # Accuracy
/// - A time is that of the middle of its word's cell, to a relative error of 2e-8, and times are compared exactly.
/// - Of items of the same time, which words of 32 bits give to one pair of equal weights in 2³², the first is held.
/// - The items stand in the order in which they would be drawn from an urn: the first is item i with probability wᵢ/W. Of two
///   items the lighter one, v times lighter, has that to a relative error of (2⁻³²v)²/24: up to 4.2 %, and 2e-8 up to v = 2²¹.
///
/// # Cost
/// Memory of `K` items with 12 bytes each, rounded up to 8. An item takes six products of 32 bits, and four a comparison: one where it is not
/// held, which after n items of equal weights are all but K/n. No division and no floating-point operation.
///
/// # Examples
/// ```
/// use microwarp::discrete::WeightedReservoir;
/// use rand_pcg::Pcg32;
/// let mut rng = Pcg32::new(1, 1);
/// let mut kept = WeightedReservoir::<_, 2>::new();
/// for (time, level) in [5, 0, 20, 15].into_iter().enumerate() {
///     kept.offer(time, level, &mut rng);
/// }
/// assert_eq!(kept.items().count(), 2);
/// assert!(kept.items().all(|&time| time != 1));
/// ```
///
/// # See also
/// - [`Reservoir`](super::Reservoir): one item, of float weights, with its probability.
/// - [`SumTree::draw_distinct`](super::SumTree::draw_distinct): the same law, from weights in memory.
///
/// # Source
/// P. S. Efraimidis and P. G. Spirakis, "Weighted Random Sampling with a Reservoir", Information Processing Letters 97(5),
/// 2006: <https://doi.org/10.1016/j.ipl.2005.11.003>.
#[doc(alias = "efraimidis_spirakis")]
#[doc(alias = "exponential_race")]
#[doc(alias = "reservoir_sampling")]
#[doc(alias = "streaming")]
#[doc(alias = "without_replacement")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WeightedReservoir<T, const K: usize> {
    /// By falling priority, with nothing at the end.
    held: [Option<Held<T>>; K],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Held<T> {
    item: T,
    /// Never 0, so that a place without an item takes no more memory than one with it.
    weight: NonZeroU32,
    /// The exponential variable, whose quotient by the weight is the time.
    exponential: u64,
}

impl<T> Held<T> {
    /// Whether the time is before that of another.
    fn precedes(&self, other: &Self) -> bool {
        product(self.exponential, other.weight) < product(other.exponential, self.weight)
    }
}

/// The product as its leading 64 bits and the last 32.
#[inline]
fn product(x: u64, weight: NonZeroU32) -> (u64, u32) {
    let weight = u64::from(weight.get());
    let low = (x & 0xffff_ffff).wrapping_mul(weight);
    let high = (x >> 32).wrapping_mul(weight);
    (high.wrapping_add(low >> 32), low as u32)
}

impl<T, const K: usize> Default for WeightedReservoir<T, K> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T, const K: usize> WeightedReservoir<T, K> {
    /// An empty reservoir.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            held: [const { None }; K],
        }
    }

    /// Offers an item with a word. Returns whether the reservoir took it.
    pub fn offer_with(&mut self, item: T, weight: u32, word: u32) -> bool {
        NonZeroU32::new(weight).is_some_and(|weight| {
            let exponential = neg_log2(word);
            self.take(Held {
                item,
                weight,
                exponential,
            })
        })
    }

    /// Offers an item of a given weight. Returns whether the reservoir took it. Draws one `u32`.
    #[inline]
    pub fn offer<R: Rng + ?Sized>(&mut self, item: T, weight: u32, rng: &mut R) -> bool {
        infallible(self.try_offer(item, weight, rng))
    }

    /// Offers an item of a given weight, with a generator that can fail. Draws one `u32`.
    ///
    /// # Errors
    /// The generator's own error. The reservoir is then unchanged.
    #[inline]
    pub fn try_offer<R: TryRng + ?Sized>(
        &mut self,
        item: T,
        weight: u32,
        rng: &mut R,
    ) -> Result<bool, R::Error> {
        let word = rng.try_next_u32()?;
        Ok(self.offer_with(item, weight, word))
    }

    /// Merges the reservoir of another part of the stream into this one, which then holds what one of the whole stream would.
    pub fn merge(&mut self, other: Self) {
        for held in other.held.into_iter().flatten() {
            self.take(held);
        }
    }

    /// Puts an item in its place, if it is early enough.
    fn take(&mut self, new: Held<T>) -> bool {
        let Some((last, mut earlier)) = self.held.split_last_mut() else {
            return false;
        };
        if last.as_ref().is_some_and(|last| !new.precedes(last)) {
            return false;
        }
        let mut place = last;
        // Those that it precedes move one place to the end.
        while let Some((before, rest)) = earlier.split_last_mut() {
            if before.as_ref().is_some_and(|before| !new.precedes(before)) {
                break;
            }
            *place = before.take();
            (place, earlier) = (before, rest);
        }
        *place = Some(new);
        true
    }

    /// The items that are held, in the order in which they would be drawn: as many as were offered with a positive weight, up
    /// to `K`.
    pub fn items(&self) -> impl Iterator<Item = &T> {
        self.held.iter().flatten().map(|held| &held.item)
    }
}

/// Cells of a table from 1 down to ½, and one for ½ itself.
const CELLS: usize = 32;

/// For the upper end c of each cell: 1/c in units of 2⁻³⁰, and −log₂c in units of 2⁻⁵⁸.
#[allow(
    clippy::indexing_slicing,
    reason = "the compiler evaluates it, and a panic would stop the build"
)]
static LOG: [(u32, u64); CELLS + 1] = {
    let mut table = [(0, 0); CELLS + 1];
    let mut i = 0;
    while i <= CELLS {
        let end = (2 * CELLS - i) as f64 / (2 * CELLS) as f64;
        table[i] = (
            (1_073_741_824.0 / end) as u32,
            (-ln(end) / LN_2 * 288_230_376_151_711_744.0) as u64,
        );
        i += 1;
    }
    table
};

/// The series of log₂(1 − x)/−x to the cube in units of 2⁻³¹. Three quarters of the fourth power's end in the first cell are
/// spread over the cube.
const SERIES: [u32; 4] = [
    (LOG2_E * 2_147_483_648.0) as u32,
    (LOG2_E / 2.0 * 2_147_483_648.0) as u32,
    (LOG2_E / 3.0 * 2_147_483_648.0) as u32,
    (LOG2_E * (0.25 + 0.15 / (2 * CELLS) as f64) * 2_147_483_648.0) as u32,
];

/// −log₂((2·word + 1)/2³³) in units of 2⁻⁵⁸, to a relative error of 1.4e-8 at the largest word and less elsewhere.
#[inline]
fn neg_log2(word: u32) -> u64 {
    const CELL: u64 = 1 << 27;
    let zeros = word.leading_zeros();
    let significand = (u64::from(word) << 1 | 1).wrapping_shl(zeros);
    // The way from the significand to 1, in units of 2⁻³³, so that what is next to 1 keeps its digits.
    let rest = (1_u64 << 33).wrapping_sub(significand);
    let (inverse, log) = LOG.get((rest >> 27) as usize).copied().unwrap_or_default();
    let offset = rest & (CELL - 1);
    // As a part of the cell's end, in units of 2⁻³².
    let x = high((offset << 1) as u32, inverse);
    let [one, two, three, four] = SERIES;
    let slope = one.wrapping_add(high(
        x,
        two.wrapping_add(high(x, three.wrapping_add(high(x, four)))),
    ));
    let way = offset.wrapping_mul(high(inverse, slope).into()) >> 4;
    (u64::from(zeros) << 58).wrapping_add(log).wrapping_add(way)
}

/// ⌊x·y/2³²⌋ of a y above 0.
#[inline]
const fn high(x: u32, y: u32) -> u32 {
    up_to(y.wrapping_sub(1), x)
}
