//! Error-free transformations: sums, products and quotients with what their rounding drops.

/// The upper 12 bits of the significand; what is left of `x` has no more than 12 either.
#[inline]
pub(crate) const fn head(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0xffff_f000)
}

/// The head and the rest, whose sum is `x`.
#[inline]
const fn split(x: f32) -> (f32, f32) {
    let high = head(x);
    (high, x - high)
}

/// What a rounded quotient leaves of its dividend: `dividend - quotient·divisor`.
#[inline]
pub(crate) const fn remainder(dividend: f32, quotient: f32, divisor: f32) -> f32 {
    let (back, dropped) = two_product(quotient, divisor);
    (dividend - back) - dropped
}

/// `a * b` rounded, and what the rounding dropped: exact unless the product over- or underflows.
#[inline]
pub(crate) const fn two_product(a: f32, b: f32) -> (f32, f32) {
    let product = a * b;
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    let dropped = ((a1 * b1 - product) + a1 * b0 + a0 * b1) + a0 * b0;
    (product, dropped)
}

/// The sum and what rounding it dropped, exact for any order of magnitudes.
#[inline]
pub(crate) const fn two_sum(a: f32, b: f32) -> (f32, f32) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The sum and what rounding it dropped, for an `a` that is not the smaller.
#[inline]
pub(crate) const fn quick_two_sum(a: f32, b: f32) -> (f32, f32) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The product of two sums of two, likewise.
#[inline]
pub(crate) const fn product((a, a_rest): (f32, f32), (b, b_rest): (f32, f32)) -> (f32, f32) {
    let (product, dropped) = two_product(a, b);
    quick_two_sum(product, dropped + (a * b_rest + a_rest * b))
}

/// A number and what it lacks as an `f32`, worked out by the compiler: no double reaches the target.
pub(crate) const fn pair(x: f64) -> (f32, f32) {
    (x as f32, (x - x as f32 as f64) as f32)
}
