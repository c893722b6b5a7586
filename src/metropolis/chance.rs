//! Integer weights, and the acceptance between them: exact, without floating-point operations.

#![expect(
    clippy::arithmetic_side_effects,
    reason = "nothing overflows, which builds with overflow checks show"
)]

use super::acceptance::{Acceptance, Probability};
use super::hastings_correction::{Hastings, HastingsCorrection};
use super::standing::Standing;
use super::target_value::{TargetValue, Weighing};
use super::{HastingsCounts, Transition};
use crate::error::Error;
use crate::num::Scaled;
use crate::num::division::scaled;
use crate::uniform::Chance;

// The word U accepts if U·f·T < 2³²·f′·T′, for weights f of x and f′ of x′, and counts T of the way there and T′ of the way back.
impl Chance {
    /// Of two weights and two counts from 1 to 2⁶⁴.
    #[inline]
    const fn of_counts(from: u32, to: u32, counts: HastingsCounts) -> Self {
        /// Up to here the products with a weight have 64 bits.
        const NARROW: u128 = 1 << 32;
        let HastingsCounts {
            forward,
            backward,
            raised,
        } = counts;
        if forward <= NARROW && backward <= NARROW && raised == 0 {
            Self::of(to as u64 * backward as u64, from as u64 * forward as u64)
        } else {
            Self::wide(to as u128 * backward, from as u128 * forward, raised)
        }
    }

    /// Of two weights and a ratio: an integer of 24 bits times a power of two.
    #[inline]
    const fn of_ratio(from: u32, to: u32, ratio: Scaled) -> Self {
        let (significand, exponent) = ratio.parts();
        let digits = significand.to_bits() & 0x007f_ffff | 0x0080_0000;
        let part = to as u128 * digits as u128;
        Self::wide(part, from as u128, exponent.saturating_sub(23))
    }

    /// Of positive numbers below 2⁹⁷, the first times a power of two; it counts the words right away.
    const fn wide(part: u128, whole: u128, raised: i32) -> Self {
        let raise = raised.unsigned_abs();
        // What is raised is shifted as far as there is room: with 127 bits it is the larger one, by 2²⁹ and more.
        let (part, whole, rest) = if raised < 0 {
            let by = least(raise, whole.leading_zeros() - 1);
            (part, whole << by, raise - by)
        } else {
            (part << least(raise, part.leading_zeros() - 1), whole, 0)
        };
        if part >= whole {
            return Self::ALWAYS;
        }
        let bits = 32_u32.saturating_sub(rest);
        let (words, inexact) = scaled(part, whole, bits);
        Self::of(words as u64 + inexact as u64, Self::TOTAL)
    }
}

const fn least(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}

impl Probability for Chance {
    const NEVER: Self = Self::of(0, 1);
    const ALWAYS: Self = Self::of(1, 1);

    #[inline]
    fn accepts(self, word: u32) -> bool {
        Self::accepts(self, word)
    }
}

impl Acceptance<u32> for Chance {
    #[inline]
    fn between(f: u32, f_new: u32, ratio: impl HastingsCorrection) -> Self {
        match ratio.hastings() {
            Hastings::One => Self::of(f_new.into(), f.into()),
            Hastings::HastingsCounts(counts) => Self::of_counts(f, f_new, counts),
            Hastings::HastingsRatio(ratio) => Self::of_ratio(f, f_new, ratio.value),
        }
    }
}

impl Weighing for u32 {
    #[inline]
    fn standing(self) -> Standing {
        if self > 0 {
            Standing::Positive
        } else {
            Standing::Zero
        }
    }

    #[inline]
    fn fault(self, place: usize) -> Error {
        Error::NotPositive(place)
    }
}

impl TargetValue for u32 {
    type Acceptance = Chance;
}

impl<X: Copy, D> Transition<X, D, Chance> {
    /// Both states, each with its share of the 2³² words: those that reject and those that accept. They sum to 2³² exactly.
    ///
    /// This is exactly the expectation of recording the state after the step. Skip a state without words: if the proposal
    /// was refused, it may be outside the domain.
    #[must_use]
    #[inline]
    pub const fn recorded(&self) -> [(X, u64); 2] {
        let words = self.acceptance.words();
        [
            (self.from, Chance::TOTAL.wrapping_sub(words)),
            (self.proposed, words),
        ]
    }
}

impl<X, D: Copy> Transition<X, D, Chance> {
    /// What the target returned for both states, each with its share of the 2³² words: like [`Transition::recorded`], but with
    /// the weights, and [what goes with them](super::WithPayload), instead of the states.
    ///
    /// Skip a value without words: if the proposal was refused, it may be anything.
    #[must_use]
    #[inline]
    pub const fn recorded_values(&self) -> [(D, u64); 2] {
        let words = self.acceptance.words();
        [
            (self.from_density, Chance::TOTAL.wrapping_sub(words)),
            (self.proposed_density, words),
        ]
    }
}
