//! Whether an event happens, by one word: an exact number of the 2³² words say yes.

#![expect(
    clippy::arithmetic_side_effects,
    reason = "nothing overflows, which builds with overflow checks show"
)]

use super::infallible;
use crate::error::Error;
use crate::num::division::{fraction, fraction_u32};
use crate::num::up_to;
use rand_core::{Rng, TryRng};

/// Whether an event happens, as a coin of a given probability says: how many of the 2³² possible words accept.
///
/// The words that accept are the smallest. A draw compares; it never divides.
///
/// [`metropolis`](crate::metropolis) has the same type as the exact acceptance of a step between integer weights.
///
/// # Domain
/// - Point: a `bool`. Words: 1.
/// - Parameters: a probability from 0 to 1 as an `f32`, or as a ratio of integers, of which no division is taken.
///
/// # Accuracy
/// - A number p has ⌈2³²p⌉ words, and a ratio ⌈2³²a/b⌉. So the probability is never below p, and above it by less than
///   2⁻³². From 2⁻⁹ up a number is exact. 0 never happens, 1 always, and what is positive may happen.
/// - [`probability`](Self::probability) is that of the words. Multiply by [`weight`](Self::weight), not by 1/p, where what
///   survived is to keep its mean.
///
/// A uniform compared with p, as in `grid(rng) < p`, decides by 24 bits: it is off by up to 0.6 % near p = 1e-5.
///
/// Two values are equal if the same words accept.
///
/// # Examples
/// ```
/// use microwarp::{constant, uniform::Chance};
/// use rand_pcg::Pcg32;
/// const LOST: Chance = constant!(Chance::new(0.1)); // a packet in ten
/// const SIX: Chance = constant!(Chance::from_ratio(1, 6));
/// let mut rng = Pcg32::new(42, 54);
/// let lost = (0..1000).filter(|_| LOST.draw(&mut rng)).count();
/// assert!((50..150).contains(&lost));
/// assert!(SIX.accepts(0) && !SIX.accepts(u32::MAX));
/// assert_eq!(SIX.words(), (1_u64 << 32).div_ceil(6));
/// assert_eq!(LOST.probability(), 0.1);
/// ```
///
/// # See also
/// - [`Range`](super::Range): an integer of several.
/// - [`Geometric`](crate::discrete::Geometric): how many events happen before the first that does not.
/// - [`roulette`](crate::estimate::roulette()), for paths whose chance of going on changes.
/// - [`Chain`](crate::metropolis::Chain), whose steps between integer weights are accepted by this.
#[doc(alias = "coin")]
#[doc(alias = "bool")]
#[doc(alias = "bernoulli")]
#[doc(alias = "probability")]
#[doc(alias = "random_bool")]
#[doc(alias = "random_ratio")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Chance {
    /// The probability is min(1, `part`/(`last` + 1)). `last` is at most 2⁶⁴ − 2.
    part: u64,
    last: u64,
}

impl Chance {
    /// How many words there are: 2³².
    pub const TOTAL: u64 = 1 << 32;

    /// Of a positive `whole`.
    #[inline]
    pub(crate) const fn of(part: u64, whole: u64) -> Self {
        let last = whole.wrapping_sub(1);
        Self { part, last }
    }

    /// The chance of a probability from 0 to 1, rounded up to a whole number of words.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::Negative`] below 0, [`Error::OutOfRange`] above 1.
    pub const fn new(p: f32) -> Result<Self, Error> {
        const ONE: u32 = 1.0_f32.to_bits();
        /// The exponent field from which on the last digit counts whole words: 2³²·2^(field − 150) is 1 there.
        const WHOLE: u32 = 118;
        // By its bits, so that a core without an FPU links no routine for floats.
        let bits = p.to_bits() & 0x7fff_ffff;
        if bits >= f32::INFINITY.to_bits() {
            return Err(Error::NotFinite(0));
        }
        if p.to_bits() > 1 << 31 {
            return Err(Error::Negative(0));
        }
        if bits > ONE {
            return Err(Error::OutOfRange(0));
        }
        let (field, digits) = match bits >> 23 {
            0 => (1, bits as u64),
            field => (field, (bits & 0x007f_ffff | 0x0080_0000) as u64),
        };
        let words = if field >= WHOLE {
            digits.wrapping_shl(field - WHOLE)
        } else if digits > 0 {
            // Rounded up. Beyond 63 digits nothing changes any more.
            let below = WHOLE - field;
            ((digits - 1) >> if below < 63 { below } else { 63 }) + 1
        } else {
            0
        };
        Ok(Self::of(words, Self::TOTAL))
    }

    /// The chance of so many in so many, such as 1 in 6. No division is taken.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for 0 in all, [`Error::OutOfRange`] for more than all.
    pub const fn from_ratio(part: u32, all: u32) -> Result<Self, Error> {
        if all == 0 {
            Err(Error::NotPositive(1))
        } else if part > all {
            Err(Error::OutOfRange(1))
        } else {
            Ok(Self::of(part as u64, all as u64))
        }
    }

    /// How many words accept, from 0 to [`Chance::TOTAL`].
    #[must_use]
    #[inline]
    pub const fn words(self) -> u64 {
        if self.part > self.last {
            return Self::TOTAL;
        }
        if self.last == u32::MAX as u64 {
            return self.part;
        }
        let whole = self.last + 1;
        let (words, inexact) = if whole >> 32 == 0 {
            fraction_u32(self.part as u32, whole as u32)
        } else {
            fraction(self.part, whole)
        };
        words as u64 + inexact as u64
    }

    /// The probability that a word accepts, to half an ulp.
    #[must_use]
    pub const fn probability(self) -> f32 {
        // Exact: a power of two.
        self.words() as f32 * (f32::EPSILON / 512.0)
    }

    /// By what to multiply what happened so that its mean is that of the whole: 1 over the probability of the words. It is
    /// rounded once for a number, twice for a ratio. 0 where it never happens.
    #[must_use]
    pub const fn weight(self) -> f32 {
        let words = self.words();
        if words == 0 {
            return 0.0;
        }
        Self::TOTAL as f32 / words as f32
    }

    /// Whether this word accepts, that is, whether it is below [`Chance::words`]. It takes no division.
    #[must_use]
    #[inline]
    pub const fn accepts(self, word: u32) -> bool {
        // word·whole < 2³²·part, in whole multiples of 2³². The upper product is at most (2³² − 1)².
        let upper = self.last >> 32;
        let product = if upper > 0 { word as u64 * upper } else { 0 };
        product + (up_to(self.last as u32, word) as u64) < self.part
    }

    /// Draws whether the event happens, from a generator that can fail. One word.
    ///
    /// # Errors
    /// The generator's own error.
    #[inline]
    pub fn try_draw<R: TryRng + ?Sized>(self, rng: &mut R) -> Result<bool, R::Error> {
        Ok(self.accepts(rng.try_next_u32()?))
    }

    /// Draws whether the event happens. One word.
    #[inline]
    pub fn draw<R: Rng + ?Sized>(self, rng: &mut R) -> bool {
        infallible(self.try_draw(rng))
    }
}

impl PartialEq for Chance {
    fn eq(&self, other: &Self) -> bool {
        self.words() == other.words()
    }
}

impl Eq for Chance {}
