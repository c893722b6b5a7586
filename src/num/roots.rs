//! Roots, of operations that IEEE 754 rounds exactly. Both tiers share them.

use super::error_free::{head, remainder, two_product};
use super::exponent::power_of_two;
use super::scaled::Scaled;

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

/// √x for a constructor, to 0.501 units in the last place: that of the processor is not `const`.
pub(crate) const fn square_root(x: Scaled) -> f32 {
    let (x, half) = even(x);
    let inverse = inverse_root_near(x);
    let root = x * inverse;
    (root + 0.5 * inverse * remainder(x, root, root)) * power_of_two(half)
}

/// 1/√x for a constructor, likewise.
pub(crate) const fn inverse_square_root(x: Scaled) -> f32 {
    let (x, half) = even(x);
    let near = inverse_root_near(x);
    // 1 - x·near², to all its digits.
    let (square, dropped) = two_product(near, near);
    let left = remainder(1.0, square, x) - x * dropped;
    (near + 0.5 * near * left) * power_of_two(half.wrapping_neg())
}

/// A number in [1, 4) and half the exponent of the power of 4 by which to multiply it.
const fn even(x: Scaled) -> (f32, i32) {
    let (significand, exponent) = x.parts();
    (significand * power_of_two(exponent & 1), exponent >> 1)
}

/// 1/√x to 5e-6 of itself.
const fn inverse_root_near(x: f32) -> f32 {
    // Half the bits is half the exponent, and about half the logarithm of the fraction: 3.5 % off. Newton's step squares that.
    let guess = f32::from_bits(0x5f37_59df_u32.wrapping_sub(x.to_bits() >> 1));
    let half = 0.5 * x;
    let near = guess * (1.5 - half * guess * guess);
    near * (1.5 - half * near * near)
}
