//! Long division, digit by digit.
//!
//! The compiler's own routine for 128 bits is two to four times as fast on a host, but takes three kilobytes of flash on
//! a Cortex-M0.

/// `floor(x · 2^bits / total)` and whether there is a remainder, for `x <= total < 2^127`.
pub(crate) const fn scaled(x: u128, total: u128, bits: u32) -> (u128, bool) {
    let mut quotient = 0_u128;
    let mut rest = x;
    // The integer part is 0 or 1. The rest is below the total from here on.
    if rest >= total {
        rest = rest.wrapping_sub(total);
        quotient = 1;
    }
    let mut left = bits;
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

/// `floor(x · 2^31 / d)` and whether there is a remainder, for `d <= x + x` and `x < d + d`.
pub(crate) const fn quotient(x: u64, d: u64) -> (u32, bool) {
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

macro_rules! fractions {
    ($($name:ident of $word:ident;)*) => {$(
        /// `floor(x · 2^32 / d)` and whether there is a remainder, for `x < d`.
        pub(crate) const fn $name(x: $word, d: $word) -> (u32, bool) {
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
    )*};
}

fractions! {
    fraction of u64;
    fraction_u32 of u32;
}
