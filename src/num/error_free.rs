//! Error-free transformations: sums, products and quotients with their rounding errors.

/// The upper 12 bits of the significand. The rest of `x` has at most 12 bits, too.
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

/// The remainder of a rounded quotient: `dividend - quotient·divisor`.
#[inline]
pub(crate) const fn remainder(dividend: f32, quotient: f32, divisor: f32) -> f32 {
    let (back, dropped) = two_product(quotient, divisor);
    (dividend - back) - dropped
}

/// `a * b` rounded, and its rounding error; exact unless the product overflows or underflows.
#[inline]
pub(crate) const fn two_product(a: f32, b: f32) -> (f32, f32) {
    let product = a * b;
    let ((a1, a0), (b1, b0)) = (split(a), split(b));
    let dropped = ((a1 * b1 - product) + a1 * b0 + a0 * b1) + a0 * b0;
    (product, dropped)
}

/// The rounded sum and its rounding error, exact for any order of magnitudes.
#[inline]
pub(crate) const fn two_sum(a: f32, b: f32) -> (f32, f32) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The rounded sum and its rounding error, for an `a` that is not the smaller.
#[inline]
pub(crate) const fn quick_two_sum(a: f32, b: f32) -> (f32, f32) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The product of two numbers that each consist of a rounded part and a rest, in the same form.
#[inline]
pub(crate) const fn product((a, a_rest): (f32, f32), (b, b_rest): (f32, f32)) -> (f32, f32) {
    let (product, dropped) = two_product(a, b);
    quick_two_sum(product, dropped + (a * b_rest + a_rest * b))
}

/// An `f64` as an `f32` and its rounding error. For constants: no double reaches the target.
pub(crate) const fn pair(x: f64) -> (f32, f32) {
    (x as f32, (x - x as f32 as f64) as f32)
}
