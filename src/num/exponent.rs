//! Exponents: reading, changing and splitting off the exponent of a number by its bits.

/// 2^e, for an exponent from -126 to 127.
#[inline]
pub(crate) const fn power_of_two(e: i32) -> f32 {
    f32::from_bits((e.wrapping_add(127) as u32) << 23)
}

/// `(k, m - 1)` where the positive normal `x` is `m·2^k`, and m is at least the number with the bits `from` and below
/// twice that. Exact.
#[inline]
#[allow(
    clippy::cast_possible_wrap,
    reason = "the exponent is signed and its bits are shifted as such"
)]
pub(crate) const fn normalised(x: f32, from: u32) -> (i32, f32) {
    let bits = x.to_bits();
    let k = (bits.wrapping_sub(from) as i32) >> 23;
    (k, power_of_two_times(x, k.wrapping_neg()) - 1.0)
}

/// `x·2^k`, exact where both are normal.
#[inline]
#[allow(
    clippy::cast_sign_loss,
    reason = "adding a negative exponent wraps to a subtraction"
)]
pub(crate) const fn power_of_two_times(x: f32, k: i32) -> f32 {
    f32::from_bits(x.to_bits().wrapping_add((k as u32) << 23))
}

/// Whether `x` is positive, normal and finite.
#[inline]
pub(crate) fn is_plain(x: f32) -> bool {
    (f32::MIN_POSITIVE..=f32::MAX).contains(&x)
}

/// `x·2^k` for x near 1 and `|k| <= 252`, rounded once where it is subnormal.
#[cold]
pub(crate) fn ldexp(x: f32, k: i32) -> f32 {
    let half = k >> 1;
    let first = power_of_two_times(1.0, half);
    let second = power_of_two_times(1.0, k.wrapping_sub(half));
    x * first * second
}

/// The integer nearest to `x`, `|x| <= 2^22`: as `f32` and as an integer.
#[inline]
#[allow(
    clippy::cast_possible_wrap,
    reason = "the low bits are a signed integer"
)]
pub(crate) const fn nearest_integer(x: f32) -> (f32, i32) {
    // Adding 1.5·2^23 rounds to an integer and leaves it in the last bits.
    const ROUND: f32 = 12_582_912.0;
    let shifted = x + ROUND;
    let integer = shifted.to_bits().wrapping_sub(ROUND.to_bits()) as i32;
    (shifted - ROUND, integer)
}
