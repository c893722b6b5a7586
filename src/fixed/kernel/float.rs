//! Conversions from and to the bits of an `f32`, without an operation on floats.

/// The bits of 1.
const ONE: u32 = 127 << 23;
/// The bits of infinity. Larger bits are NaN or have a sign.
const INFINITY: u32 = 255 << 23;

/// The word of a uniform by the rule of [`canonical`](crate::uniform::Uniforms::canonical), cut to Q32.
#[inline]
pub(in crate::fixed) fn uniform(bits: u32) -> u32 {
    // How far to shift the fraction, with its first bit set.
    let right = ((ONE >> 23) - 1).wrapping_sub(bits >> 23);
    if right < 32 {
        (bits << 8 | 1 << 31) >> right
    } else if (ONE..=INFINITY).contains(&bits) {
        u32::MAX << 8
    } else {
        0
    }
}

/// The `f32` of a number with so many fraction bits, at most 32, cut to 24 digits.
#[inline]
pub(in crate::fixed) fn of(number: u32, fraction: u32) -> u32 {
    if number == 0 {
        return 0;
    }
    // The first bit of the fraction adds 1 to the exponent.
    let exponent = (ONE >> 23) + 30 - fraction;
    on_this_core!(scaled_on(number, exponent))
}

/// The bits of a positive number times a power of two. `exponent` belongs to the highest bit of a word.
#[inline]
fn scaled_on<const NARROW: bool>(number: u32, exponent: u32) -> u32 {
    if NARROW {
        let (mut m, mut bits) = (number, exponent << 23);
        while m >> 31 == 0 {
            m <<= 1;
            bits -= 1 << 23;
        }
        bits + (m >> 8)
    } else {
        let zeros = number.leading_zeros();
        ((exponent - zeros) << 23) + (number << zeros >> 8)
    }
}

/// The magnitude of an `f32` with so many fraction bits, at most 32, cut. A number that does not fit counts as the
/// largest word, NaN as 0.
#[inline]
pub(in crate::fixed) fn magnitude(bits: u32, fraction: u32) -> u32 {
    let magnitude = bits & (u32::MAX >> 1);
    let right = ((ONE >> 23) + 31 - fraction).wrapping_sub(magnitude >> 23) as i32;
    if magnitude > INFINITY || right > 31 {
        0
    } else if right < 0 {
        u32::MAX
    } else {
        (bits << 8 | 1 << 31) >> right
    }
}
