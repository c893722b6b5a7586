//! The cube root, of operations that IEEE 754 rounds exactly. Both tiers share it.

use super::error_free::head;

/// The cube root of a number in [0, 1], to 0.51 units in the last place; 0 for what is not above 0.
///
/// The bound is that of every number; `tests/laws` measures it through the radius of a ball.
#[inline]
pub(crate) fn cube_root(x: f32) -> f32 {
    /// 2⁻⁸⁸. Below it the products of 24 more bits would underflow.
    const LEAST: f32 = 1.0 / (1_u128 << 88) as f32;
    if x >= LEAST {
        of_large(x)
    } else if x > 0.0 {
        // Both factors are powers of two, and the second is the cube root of the first.
        of_large(x * (1_u64 << 60) as f32) * (1.0 / 1_048_576.0)
    } else {
        0.0
    }
}

#[inline]
fn of_large(x: f32) -> f32 {
    // A third of the bits is a third of the exponent, and about a third of the logarithm of the fraction: 3.3 % off.
    let third = (u64::from(x.to_bits()).wrapping_mul(0x5555_5556) >> 32) as u32;
    let guess = f32::from_bits(third.wrapping_add(0x2a51_0554));
    // Halley's step cubes the error: 2.4e-5.
    let cube = guess * guess * guess;
    let near = guess * ((cube + (x + x)) / ((cube + cube) + x));
    // Of 12 bits, so that its square is exact, and so are its products with both halves of the square: the step below
    // knows x - near³ to all its digits.
    let near = head(near);
    let square = near * near;
    let high = head(square);
    let left = (x - near * high) - near * (square - high);
    let cube = near * square;
    near + near * (left / ((cube + cube) + x))
}
