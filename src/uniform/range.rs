//! Integers of a range: by a fixed number of words, with exact probabilities, and without a division.

use super::infallible;
use crate::error::Error;
use crate::num;
use crate::num::division::scaled;
use rand_core::{Rng, TryRng};

/// The integers from a lowest to a highest, both among them, with equal probabilities.
///
/// They increase with the word. There is no loop and no division, where `rand` loops until a word fits, and a remainder divides.
///
/// # Domain
/// - Points: `u32` by [`new`](Range::new) and [`below`](Range::below), `i32` by [`signed`](Range::signed), `u64` by
///   [`of_u64`](Range::of_u64).
/// - Words: 1; 2 for `u64`, and for the others by `draw_wide`.
/// - Parameters: any ends, also those of all integers of the type.
///
/// # Accuracy
/// - Of n integers each has ⌊2³²/n⌋ words or one more; `numerator` says how many. So a probability is off by less than n·2⁻³² of
///   it, the probability of any set by at most n·2⁻³⁴, and a power of two of integers are exactly alike.
/// - With two words that is n·2⁻⁶⁴. Both agree but for a share of n·2⁻³² of the draws. Take two from some 65,536 integers on.
///
/// # Cost
/// One product of two words, on a core without a long product of their halves; two for `draw_wide`, and four for `u64`.
///
/// # Examples
/// ```
/// use microwarp::{constant, uniform::Range};
/// use rand_pcg::Pcg32;
/// const DIE: Range = constant!(Range::new(1, 6));
/// let mut rng = Pcg32::new(42, 54);
/// let (face, index) = (DIE.draw(&mut rng), Range::below(10)?.draw(&mut rng));
/// assert!((1..=6).contains(&face) && index < 10);
/// let offset = Range::signed(-20, 20)?.draw(&mut rng);
/// assert!(offset.abs() <= 20);
/// assert_eq!(DIE.numerator(1), (1_u64 << 32).div_ceil(6));
/// assert_eq!(DIE.pmf(7), 0.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
/// What a word leaves over is a word again, so that one word rolls several dice:
/// ```
/// # use microwarp::{constant, uniform::Range};
/// # const DIE: Range = constant!(Range::new(1, 6));
/// let (first, rest) = DIE.select(0xdead_beef);
/// let (second, _) = DIE.select(rest);
/// assert_eq!([first, second], [6, 2]); // as one of 36 integers
/// ```
///
/// # See also
/// - [`up_to()`]: an integer without an error to handle.
/// - [`Chance`](super::Chance): whether an event happens.
/// - [`Cdf`](crate::discrete::Cdf), [`Alias`](crate::discrete::Alias): integers by weight.
///
/// # Source
/// D. Lemire, "Fast Random Integer Generation in an Interval", 2019, <https://doi.org/10.1145/3230636>, without its rejection.
#[doc(alias = "integer")]
#[doc(alias = "dice")]
#[doc(alias = "random_range")]
#[doc(alias = "gen_range")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Range<T = u32> {
    low: T,
    high: T,
}

impl Range<u32> {
    /// The integers from 0 to n − 1, such as the indices of n entries.
    ///
    /// # Errors
    /// [`Error::Empty`] for 0.
    pub const fn below(n: u32) -> Result<Self, Error> {
        match n.checked_sub(1) {
            Some(last) => Self::new(0, last),
            None => Err(Error::Empty(0)),
        }
    }
}

/// An integer up to `last`, and the rest.
#[inline]
const fn select_u32(last: u32, word: u32) -> (u32, u32) {
    let rest = word.wrapping_mul(last).wrapping_add(word);
    (num::up_to(last, word), rest)
}

/// Likewise. The sum does not overflow: it is at most (2⁶⁴ − 1)·2⁶⁴.
#[inline]
const fn select_u64(last: u64, word: u64) -> (u64, u64) {
    let word = word as u128;
    let product = word.wrapping_mul(last as u128).wrapping_add(word);
    ((product >> 64) as u64, product as u64)
}

#[inline]
fn try_u32<R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
    rng.try_next_u32()
}

/// The leading word comes first.
#[inline]
fn try_u64<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
    let (high, low) = (rng.try_next_u32()?, rng.try_next_u32()?);
    Ok(u64::from(high) << 32 | u64::from(low))
}

/// What the ranges of each type have; by its word, and by what counts all words.
macro_rules! integers {
    ($($new:ident, $int:ident, $word:ident, $count:ident, $select:ident, $try_word:ident, $words:literal;)*) => {$(
        impl Range<$int> {
            /// The integers from `low` to `high`, both among them.
            ///
            /// # Errors
            /// [`Error::Empty`] where `low` is above `high`.
            pub const fn $new(low: $int, high: $int) -> Result<Self, Error> {
                if low <= high {
                    Ok(Self { low, high })
                } else {
                    Err(Error::Empty(1))
                }
            }

            /// The lowest integer.
            #[must_use]
            #[inline]
            pub const fn low(self) -> $int {
                self.low
            }

            /// The highest integer, which is reached.
            #[must_use]
            #[inline]
            pub const fn high(self) -> $int {
                self.high
            }

            #[inline]
            #[allow(clippy::cast_lossless, reason = "one of these types is the word itself")]
            const fn last(self) -> $word {
                self.high.wrapping_sub(self.low) as $word
            }

            /// The integer of a word, and the rest: where the word lies in the share of the integer, as a word again.
            ///
            /// A range of m integers that selects by the rest of one of n gives, with the first integer, exactly what a range of
            /// n·m integers gives by the word.
            #[must_use]
            #[inline]
            #[allow(clippy::cast_possible_wrap, reason = "the sum wraps to the right integer")]
            pub const fn select(self, word: $word) -> ($int, $word) {
                let (offset, rest) = $select(self.last(), word);
                (self.low.wrapping_add(offset as $int), rest)
            }

            #[doc = concat!("Draws an integer from a generator that can fail. ", $words)]
            ///
            /// # Errors
            /// The generator's own error.
            #[inline]
            pub fn try_draw<R: TryRng + ?Sized>(self, rng: &mut R) -> Result<$int, R::Error> {
                let (integer, _) = self.select($try_word(rng)?);
                Ok(integer)
            }

            #[doc = concat!("Draws an integer. ", $words)]
            #[inline]
            pub fn draw<R: Rng + ?Sized>(self, rng: &mut R) -> $int {
                infallible(self.try_draw(rng))
            }

            /// How many of all words select an integer; 0 for one outside.
            #[must_use]
            pub const fn numerator(self, integer: $int) -> $count {
                if integer < self.low || integer > self.high {
                    return 0;
                }
                let place = integer.wrapping_sub(self.low) as $word as u128;
                let all = (self.last() as u128).wrapping_add(1);
                let (from, more) = scaled(place, all, $word::BITS);
                let (to, most) = scaled(place.wrapping_add(1), all, $word::BITS);
                to.wrapping_add(most as u128).wrapping_sub(from.wrapping_add(more as u128)) as $count
            }

            /// The probability of an integer by one word of its own, to half an ulp; 0 for one outside.
            #[must_use]
            pub const fn pmf(self, integer: $int) -> f32 {
                const STEP: f32 = 1.0 / (1_u128 << $word::BITS) as f32;
                self.numerator(integer) as f32 * STEP
            }
        }
    )*};
}

integers! {
    new, u32, u32, u64, select_u32, try_u32, "One word.";
    signed, i32, u32, u64, select_u32, try_u32, "One word.";
    of_u64, u64, u64, u128, select_u64, try_u64, "Two words, the leading one first.";
}

/// The ranges whose integers one word selects, by two.
macro_rules! wide {
    ($($int:ident)*) => {$(
        impl Range<$int> {
            /// Draws an integer from a generator that can fail, with a probability that is off by less than n·2⁻⁶⁴ of it. Two words,
            /// the leading one first.
            ///
            /// # Errors
            /// The generator's own error.
            #[inline]
            #[allow(clippy::cast_possible_wrap, reason = "the sum wraps to the right integer")]
            pub fn try_draw_wide<R: TryRng + ?Sized>(self, rng: &mut R) -> Result<$int, R::Error> {
                let (high, low) = (rng.try_next_u32()?, rng.try_next_u32()?);
                let offset = num::up_to_by_two(self.last(), high, low);
                Ok(self.low.wrapping_add(offset as $int))
            }

            /// Draws an integer, with a probability that is off by less than n·2⁻⁶⁴ of it. Two words, the leading one first.
            #[inline]
            pub fn draw_wide<R: Rng + ?Sized>(self, rng: &mut R) -> $int {
                infallible(self.try_draw_wide(rng))
            }
        }
    )*};
}

wide!(u32 i32);

/// The integer from 0 to `last` that a word gives: ⌊word·(last + 1)/2³²⌋.
///
/// Any `last` will do: for `u32::MAX` it is the word itself.
///
/// ```
/// use microwarp::uniform;
/// assert_eq!(uniform::up_to_from_word(5, 0), 0);
/// assert_eq!(uniform::up_to_from_word(5, u32::MAX), 5);
/// assert_eq!(uniform::up_to_from_word(u32::MAX, 7), 7);
/// ```
#[must_use]
#[inline]
pub const fn up_to_from_word(last: u32, word: u32) -> u32 {
    num::up_to(last, word)
}

/// Draws an integer from 0 to `last` from a generator that can fail. One word.
///
/// # Errors
/// The generator's own error.
#[inline]
pub fn try_up_to<R: TryRng + ?Sized>(last: u32, rng: &mut R) -> Result<u32, R::Error> {
    Ok(num::up_to(last, rng.try_next_u32()?))
}

/// Draws an integer from 0 to `last`, which is among them. One word.
///
/// Each has the probability that [`Range`] states. No `last` is refused, so that there is no error to handle.
///
/// ```
/// use microwarp::uniform;
/// use rand_pcg::Pcg32;
/// let face = 1 + uniform::up_to(5, &mut Pcg32::new(1, 1)); // of a die
/// assert!((1..=6).contains(&face));
/// ```
#[doc(alias = "integer")]
#[inline]
pub fn up_to<R: Rng + ?Sized>(last: u32, rng: &mut R) -> u32 {
    infallible(try_up_to(last, rng))
}
