//! The acceptance of integer weights: exact, and without a floating-point operation.

#![expect(
    clippy::arithmetic_side_effects,
    reason = "nothing overflows, which builds with overflow checks show"
)]

use super::weight::Probability;
use crate::num::Scaled as Apart;
use crate::num::division::{fraction, fraction_u32, scaled};

/// The acceptance of a step between integer weights: how many of the 2³² words that decide accept it.
///
/// For weights f of x and f′ of x′, and counts T of the way there and T′ of the way back, the word U accepts if
/// U·f·T < 2³²·f′·T′. So the accepting words are the first ⌈2³² f′T′/(fT)⌉, or all: the acceptance a, to less
/// than a step of 2⁻³² above, and never 0 where there is a way.
///
/// Two of them are equal if the same words accept.
///
/// ```
/// use microwarp::metropolis::{Chain, UniformIndex};
/// use rand_pcg::Pcg32;
/// const WEIGHTS: [u32; 2] = [9, 1];
/// let weight = |i: usize| WEIGHTS[i];
/// let (mut chain, mut rng) = (Chain::new(0, weight)?, Pcg32::new(1, 1));
/// let (mutation, mut histogram) = (UniformIndex::new(2)?, [0; 2]);
/// for _ in 0..1000 {
///     let step = chain.step(weight, &mutation, &mut rng);
///     if (step.from, step.proposed) == (0, 1) {
///         assert_eq!(step.acceptance.words(), (1_u64 << 32).div_ceil(9));
///     }
///     for (state, words) in step.recorded() {
///         histogram[state] += words; // both together 2³²
///     }
/// }
/// assert_eq!(histogram[0] + histogram[1], 1000 << 32);
/// assert!(histogram[0] > 850 << 32 && histogram[0] < 950 << 32);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Chance {
    /// The acceptance is `part`/`whole`, or 1 where `part` is the larger one; `whole` is positive.
    part: u64,
    whole: u64,
}

impl Chance {
    /// How many words there are, 2³².
    pub const TOTAL: u64 = 1 << 32;

    #[inline]
    pub(super) const fn of(part: u64, whole: u64) -> Self {
        Self { part, whole }
    }

    /// How many words accept: from 0 to [`Chance::TOTAL`].
    #[must_use]
    #[inline]
    pub const fn words(self) -> u64 {
        if self.part >= self.whole {
            return Self::TOTAL;
        }
        let (words, inexact) = if self.whole >> 32 == 0 {
            fraction_u32(self.part as u32, self.whole as u32)
        } else {
            fraction(self.part, self.whole)
        };
        words as u64 + inexact as u64
    }

    /// Whether a word accepts: whether it is below the number of words that do. No division takes place.
    #[must_use]
    #[inline]
    pub const fn accepts(self, word: u32) -> bool {
        // word · whole < 2^32 · part, in whole multiples of 2^32. The upper product is at most (2^32 - 1)^2.
        let (upper, lower) = (self.whole >> 32, self.whole & 0xffff_ffff);
        let word = word as u64;
        word * upper + ((word * lower) >> 32) < self.part
    }

    /// Of two weights, and two counts of 1 to 2⁶⁴.
    #[inline]
    pub(super) const fn of_counts(from: u32, to: u32, forward: u128, backward: u128) -> Self {
        /// Up to here the products with a weight have 64 bits.
        const NARROW: u128 = 1 << 32;
        if forward <= NARROW && backward <= NARROW {
            Self::of(to as u64 * backward as u64, from as u64 * forward as u64)
        } else {
            Self::wide(to as u128 * backward, from as u128 * forward)
        }
    }

    /// Of two weights and a ratio, which is an integer of 24 bits times a power of two.
    #[inline]
    pub(super) const fn of_apart(from: u32, to: u32, ratio: Apart) -> Self {
        let (significand, exponent) = ratio.parts();
        let digits = significand.to_bits() & 0x007f_ffff | 0x0080_0000;
        let (part, whole) = (to as u128 * digits as u128, from as u128);
        let exponent = exponent.saturating_sub(23);
        let by = exponent.unsigned_abs();
        // The part has 24 to 56 bits, the whole up to 32: shifted further than this, every word accepts, or one.
        if exponent >= 0 {
            Self::wide(part << if by < 40 { by } else { 40 }, whole)
        } else {
            Self::wide(part, whole << if by < 90 { by } else { 90 })
        }
    }

    /// Of numbers of up to 122 bits: the words are counted at once.
    const fn wide(part: u128, whole: u128) -> Self {
        if part >= whole {
            return Self::ALWAYS;
        }
        let (words, inexact) = scaled(part, whole, 32);
        Self::of(words as u64 + inexact as u64, Self::TOTAL)
    }
}

impl PartialEq for Chance {
    fn eq(&self, other: &Self) -> bool {
        self.words() == other.words()
    }
}

impl Eq for Chance {}

impl Probability for Chance {
    const NEVER: Self = Self::of(0, 1);
    const ALWAYS: Self = Self::of(1, 1);

    #[inline]
    fn happens(self, word: u32) -> bool {
        self.accepts(word)
    }
}
