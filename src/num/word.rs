//! Decisions by a word: an integer in a range, whether an event happens, and on which side of a symmetric distribution a
//! point lies.

use super::exponent::power_of_two;

/// Whether the core lacks a product of 32 bits by 32 to 64. Among Arm cores these are the ones without compare-and-swap.
pub(crate) const NARROW: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// The integer from 0 to `last` that a word gives: ⌊word·(last + 1)/2³²⌋. For the largest `last` it is the word itself.
#[inline]
pub(crate) const fn up_to(last: u32, word: u32) -> u32 {
    up_to_on::<NARROW>(last, word, 0)
}

/// The same of a fraction of two words, the leading one first.
#[inline]
pub(crate) const fn up_to_by_two(last: u32, high: u32, low: u32) -> u32 {
    up_to_on::<NARROW>(last, high, up_to(last, low))
}

/// ⌊(word·last + word + carried)/2³²⌋.
#[inline]
pub(crate) const fn up_to_carried(last: u32, word: u32, carried: u32) -> u32 {
    up_to_on::<NARROW>(last, word, carried)
}

/// ⌊(word·last + word + carried)/2³²⌋, by products of 16 bits on a narrow core. None of the sums can overflow, since
/// x·y + x + z is below 2³² for three numbers of 16 bits. With `word` among them the compiler does not recognise a long
/// product, for which a narrow core calls a routine.
#[inline]
pub(super) const fn up_to_on<const NARROW: bool>(last: u32, word: u32, carried: u32) -> u32 {
    if NARROW {
        let (high, low) = (word >> 16, word & 0xffff);
        let (last_high, last_low) = (last >> 16, last & 0xffff);
        let least = low
            .wrapping_mul(last_low)
            .wrapping_add(low)
            .wrapping_add(carried & 0xffff);
        let middle = high
            .wrapping_mul(last_low)
            .wrapping_add(high)
            .wrapping_add(least >> 16);
        let other = low
            .wrapping_mul(last_high)
            .wrapping_add(middle & 0xffff)
            .wrapping_add(carried >> 16);
        high.wrapping_mul(last_high)
            .wrapping_add(middle >> 16)
            .wrapping_add(other >> 16)
    } else {
        let word = word as u64;
        let product = word.wrapping_mul(last as u64).wrapping_add(word);
        (product.wrapping_add(carried as u64) >> 32) as u32
    }
}

/// Whether an event of this probability happens, by a word. True for 2³² times the probability of all words, rounded to
/// an integer: never for 0, always for 1.
#[inline]
pub(crate) fn happens(probability: f32, word: u32) -> bool {
    if probability >= 1.0 {
        return true;
    }
    // Exact: a power of two.
    word < nearest(probability * 4_294_967_296.0)
}

/// The integer nearest to a number from 0 to 2³², halves upwards.
#[inline]
pub(crate) const fn nearest(x: f32) -> u32 {
    /// The number below 1/2. Added to a number whose fraction is at least 1/2, it still rounds to the next integer. A
    /// half added to this number itself would round to 1.
    const HALF: f32 = 0.5 - f32::EPSILON / 4.0;
    // From 2²³ up x is an integer, and the sum could round to the next.
    let shifted = if x < 8_388_608.0 { x + HALF } else { x };
    shifted as u32
}

/// The middle of a word's cell of uniforms, rounded.
#[inline]
pub(crate) fn middle(word: u32) -> f32 {
    // The half counts where the word has digits to spare.
    (word as f32 + 0.5) * (f32::EPSILON / 512.0)
}

/// The float nearest to n - 2³¹, or to n where `offset` is 0, each half of n going in as digits.
///
/// On x86-64 the instruction that converts an integer keeps the rest of its register. In a loop of draws that may be with what the
/// last one ends, and the compiler does not always break such a dependency.
#[inline]
const fn by_halves(n: u32, offset: f32) -> f32 {
    // 2³⁹ and the upper half, less 2³⁹ and 2²³; and 2²³ and the lower half. Only their sum is rounded.
    let high = f32::from_bits(0x5300_0000 | n >> 16) - (549_764_202_496.0 + offset);
    high + f32::from_bits(0x4b00_0000 | n & 0xffff)
}

/// An integer as a float, for what is followed by a long chain of operations.
#[inline]
#[expect(clippy::cast_sign_loss, reason = "its bits")]
pub(crate) const fn float(n: i32) -> f32 {
    if cfg!(target_arch = "x86_64") {
        by_halves(n as u32 ^ 1 << 31, 2_147_483_648.0)
    } else {
        n as f32
    }
}

/// The middle of a word's cell, counted from the nearer end in units of 2⁻³³.
#[inline]
const fn middle_from_the_end(word: u32) -> u32 {
    let rank = if word >> 31 == 1 { !word } else { word };
    rank << 1 | 1
}

/// The tail of [`folded`], likewise.
#[inline]
pub(crate) const fn folded_tail(word: u32) -> f32 {
    let middle = middle_from_the_end(word);
    let middle = if cfg!(target_arch = "x86_64") {
        by_halves(middle, 0.0)
    } else {
        middle as f32
    };
    middle * (f32::EPSILON / 1024.0)
}

/// The tail of a word of a symmetric distribution: the probability beyond its point, in (0, 1/2], as the middle of the
/// words that round to it; and whether the tail is the upper one.
#[inline]
pub(crate) fn folded(word: u32) -> (f32, bool) {
    // The middle of the cell, rounded once.
    let tail = middle_from_the_end(word) as f32 * (f32::EPSILON / 1024.0);
    (tail, word >> 31 == 1)
}

/// The same with all digits of the tail: its first 24 bits and the rest.
#[inline]
pub(crate) fn folded_exactly(word: u32) -> ((f32, f32), bool) {
    let middle = middle_from_the_end(word);
    let zeros = middle.leading_zeros();
    let digits = middle.wrapping_shl(zeros);
    // 2⁻³³ in units of the last digit.
    let unit = power_of_two((-33_i32).wrapping_sub_unsigned(zeros));
    let high = (digits >> 8) as f32 * (256.0 * unit);
    ((high, (digits & 0xff) as f32 * unit), word >> 31 == 1)
}
