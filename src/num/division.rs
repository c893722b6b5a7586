//! Long division: by the processor where it has 64 bits, else digit by digit.
//!
//! The compiler's own routine for 128 bits takes three kilobytes of flash on a Cortex-M0, and one or two as WASM.

/// Whether the processor divides numbers of 64 bits.
const DIVIDES: bool = cfg!(target_pointer_width = "64");

/// `floor(x · 2^bits / total)` and whether there is a remainder, for `x <= total < 2^127`.
#[inline]
pub(crate) const fn scaled(x: u128, total: u128, bits: u32) -> (u128, bool) {
    scaled_on::<DIVIDES>(x, total, bits)
}

/// The same where the processor divides, or not.
pub(super) const fn scaled_on<const DIVIDES: bool>(
    x: u128,
    total: u128,
    bits: u32,
) -> (u128, bool) {
    let mut quotient = 0_u128;
    let mut rest = x;
    // The integer part is 0 or 1. The rest is below the total from here on.
    if rest >= total {
        rest = rest.wrapping_sub(total);
        quotient = 1;
    }
    let mut left = bits;
    if DIVIDES && total.leading_zeros() > 32 {
        while left > 0 {
            let count = if left < 32 { left } else { 32 };
            let (digits, more) = next_digits(rest, total, count);
            (quotient, rest) = (quotient.wrapping_shl(count) | digits as u128, more);
            left = left.wrapping_sub(count);
        }
    }
    while left > 0 {
        rest <<= 1;
        quotient <<= 1;
        // No branch: no processor could predict it.
        let digit = (rest >= total) as u128;
        rest = rest.wrapping_sub(total & 0_u128.wrapping_sub(digit));
        quotient |= digit;
        left = left.wrapping_sub(1);
    }
    (quotient, rest > 0)
}

/// The next so many binary digits of a quotient, at most 32, and the rest, for `rest < total < 2^95`. By a division of 64 bits:
/// the compiler's of 128 is a function that a program in C may lack.
#[expect(
    clippy::cast_possible_wrap,
    reason = "they are below 2^127, and a difference has its sign"
)]
const fn next_digits(rest: u128, total: u128, count: u32) -> (u64, u128) {
    let up = total.leading_zeros();
    let (high, divisor) = (rest.wrapping_shl(up) >> 64, total.wrapping_shl(up) >> 64);
    // The divisor has 32 bits or more left and is too small by less than one, so that this is too large by two at most, and too
    // small by one, since the dividend is cut.
    let mut digits = match (high as u64).checked_div((divisor as u64) >> count) {
        Some(digits) => digits,
        None => 0,
    };
    let (product, total) = (total.wrapping_mul(digits as u128), total as i128);
    let mut rest = rest.wrapping_shl(count).wrapping_sub(product) as i128;
    // Counted, since words of a table may be wrong.
    let mut left = 3_u32;
    while left > 0 && rest < 0 {
        (rest, digits) = (rest.wrapping_add(total), digits.wrapping_sub(1));
        left = left.wrapping_sub(1);
    }
    if rest >= total {
        (rest, digits) = (rest.wrapping_sub(total), digits.wrapping_add(1));
    }
    (digits, rest as u128)
}

/// A total by which many numbers are divided: by multiplications, where processors have them of 64 bits.
#[derive(Clone, Copy)]
pub(crate) struct Divisor {
    /// Above 0 and below 2^127.
    total: u128,
    /// Nothing on small cores.
    inverse: [Inverse; DIVIDES as usize],
}

#[derive(Clone, Copy)]
struct Inverse {
    /// How many bits of the total lie above its first.
    up: u32,
    /// 2^127 by its 64 leading bits, cut; 0 of a total beyond 2^95.
    digits: u64,
}

impl Divisor {
    pub(crate) const fn of(total: u128) -> Self {
        let up = total.leading_zeros();
        let digits = if DIVIDES && up > 32 {
            let (digits, _) = scaled(1 << 63, total.wrapping_shl(up) >> 64, 64);
            // Of a power of two it is 2^64.
            if digits >> 64 > 0 {
                u64::MAX
            } else {
                digits as u64
            }
        } else {
            0
        };
        Self {
            total,
            inverse: [Inverse { up, digits }; DIVIDES as usize],
        }
    }

    /// `floor(x · 2^bits / total)` and whether there is a remainder, for `x <= total`.
    #[allow(clippy::inline_always, reason = "a call takes as long as what it does")]
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[cfg_attr(not(target_pointer_width = "64"), inline)]
    #[expect(
        clippy::cast_possible_wrap,
        reason = "they are below 2^127, and a difference has its sign"
    )]
    pub(crate) const fn scaled(&self, x: u128, bits: u32) -> (u128, bool) {
        let Self { total, inverse } = *self;
        let (up, digits) = match inverse.as_slice() {
            [Inverse { up, digits }] if *digits > 0 && bits == 32 => (*up, *digits),
            _ => return scaled(x, total, bits),
        };
        let leading = x.wrapping_shl(up) >> 64;
        // What is cut off changes the quotient by less than 2^-30, so that this is off by one at most.
        let mut quotient = leading.wrapping_mul(digits as u128) >> 95;
        let mut rest = (x << 32).wrapping_sub(total.wrapping_mul(quotient));
        if (rest as i128) < 0 {
            (rest, quotient) = (rest.wrapping_add(total), quotient.wrapping_sub(1));
        } else if rest >= total {
            (rest, quotient) = (rest.wrapping_sub(total), quotient.wrapping_add(1));
        }
        (quotient, rest > 0)
    }
}

/// `floor(x · 2^31 / d)` and whether there is a remainder, for `d <= x + x` and `x < d + d`.
#[inline]
pub(crate) const fn quotient(x: u64, d: u64) -> (u32, bool) {
    quotient_on::<DIVIDES>(x, d)
}

/// The same where the processor divides, or not.
pub(super) const fn quotient_on<const DIVIDES: bool>(x: u64, d: u64) -> (u32, bool) {
    if DIVIDES {
        let (quotient, inexact) = scaled_on::<true>(x as u128, d as u128, 31);
        return (quotient as u32, inexact);
    }
    let (mut rest, mut digits) = if x >= d {
        (x.wrapping_sub(d), 1_u32)
    } else {
        (x, 0)
    };
    let mut left = 31_u32;
    while left > 0 {
        // The rest is below d, so twice the rest less d fits even where twice the rest does not.
        let carried = rest >> 63 > 0;
        rest <<= 1;
        digits <<= 1;
        if carried || rest >= d {
            rest = rest.wrapping_sub(d);
            digits |= 1;
        }
        left = left.wrapping_sub(1);
    }
    (digits, rest > 0)
}

/// `floor(x · 2^32 / d)` and whether there is a remainder, for `x < d`.
#[inline]
pub(crate) const fn fraction(x: u64, d: u64) -> (u32, bool) {
    fraction_on::<DIVIDES>(x, d)
}

/// The same where the processor divides, or not.
pub(super) const fn fraction_on<const DIVIDES: bool>(x: u64, d: u64) -> (u32, bool) {
    if DIVIDES {
        let (quotient, inexact) = scaled_on::<true>(x as u128, d as u128, 32);
        return (quotient as u32, inexact);
    }
    let (mut rest, mut digits) = (x, 1_u32);
    loop {
        // Compares twice the rest with d without forming it, since it may not fit.
        let gap = d.wrapping_sub(rest);
        let digit = rest >= gap;
        rest = if digit {
            rest.wrapping_sub(gap)
        } else {
            rest << 1
        };
        let (shifted, last) = digits.overflowing_add(digits);
        digits = shifted | digit as u32;
        // The initial 1 leaves at the 32nd digit. (Compilers unroll a counted loop, badly.)
        if last {
            return (digits, rest > 0);
        }
    }
}

/// [`fraction`] of words, by multiplications: a fifth of the instructions on a core that does not divide.
pub(crate) const fn fraction_u32(x: u32, d: u32) -> (u32, bool) {
    let zeros = d.leading_zeros();
    let (d, rest) = (d.wrapping_shl(zeros), x.wrapping_shl(zeros) as u64);
    let r = reciprocal(d >> 16);
    let (first, rest) = digits(rest, d, r, 11);
    let (second, rest) = digits(rest, d, r, 11);
    let (third, rest) = digits(rest, d, r, 10);
    let quotient = (first << 21).wrapping_add(second << 10).wrapping_add(third);
    let divisor = d as u64;
    if rest >= divisor {
        (quotient.wrapping_add(1), rest > divisor)
    } else {
        (quotient, rest > 0)
    }
}

/// `2^31/(high + 1)` for a half word with its leading bit set, or less by up to 2^-13 of it.
const fn reciprocal(high: u32) -> u32 {
    let above = high.wrapping_add(1);
    // 2.9142 - 2t is 1/t within 8.6 % on [1/2, 1]. Each step of Newton's squares that, and stays below.
    let mut r = 95_494_u32.wrapping_sub(above);
    r = r.wrapping_mul(above.wrapping_mul(r).wrapping_neg() >> 16) >> 15;
    r.wrapping_mul(above.wrapping_mul(r).wrapping_neg() >> 16) >> 15
}

/// The next so many binary digits, at most 11, of a quotient by a word with its leading bit set, and the rest. The
/// digits never exceed the true ones. They lack less than 1.7, so a rest below 2d stays below 2d.
const fn digits(rest: u64, d: u32, r: u32, count: u32) -> (u32, u64) {
    let digits = ((rest >> 17) as u32).wrapping_mul(r) >> 30_u32.wrapping_sub(count);
    // In halves, because a core without a long product calls a function for it.
    let high = digits.wrapping_mul(d >> 16) as u64;
    let low = digits.wrapping_mul(d & 0xffff) as u64;
    (
        digits,
        (rest << count).wrapping_sub(high << 16).wrapping_sub(low),
    )
}
