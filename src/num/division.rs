//! Long division, digit by digit.
//!
//! For 128 bits the compiler's own routine is two to four times as fast on a host, and three kilobytes of flash on a
//! Cortex-M0.

/// `floor(x · 2^bits / total)` and whether something was left, for `x <= total < 2^127`.
pub(crate) const fn scaled(x: u128, total: u128, bits: u32) -> (u128, bool) {
    let mut quotient = 0_u128;
    let mut rest = x;
    // A whole is found at the start, and leaves less than the total from then on.
    if rest >= total {
        rest = rest.wrapping_sub(total);
        quotient = 1;
    }
    let mut left = bits;
    while left > 0 {
        rest <<= 1;
        quotient <<= 1;
        // Without a branch, which no processor could predict.
        let digit = (rest >= total) as u128;
        rest = rest.wrapping_sub(total & 0_u128.wrapping_sub(digit));
        quotient |= digit;
        left = left.wrapping_sub(1);
    }
    (quotient, rest > 0)
}

/// `floor(x · 2^31 / d)` and whether something was left, for `d <= x + x` and `x < d + d`.
pub(crate) const fn quotient(x: u64, d: u64) -> (u32, bool) {
    let (mut rest, mut digits) = if x >= d {
        (x.wrapping_sub(d), 1_u32)
    } else {
        (x, 0)
    };
    let mut left = 31_u32;
    while left > 0 {
        // The rest is below d, so that twice the rest less d fits even where twice the rest does not.
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
        /// `floor(x · 2^32 / d)` and whether something was left, for `x < d`.
        pub(crate) const fn $name(x: $word, d: $word) -> (u32, bool) {
            let (mut rest, mut digits) = (x, 1_u32);
            loop {
                // Twice the rest is compared with d without being formed, for it may not fit.
                let gap = d.wrapping_sub(rest);
                let digit = rest >= gap;
                rest = if digit {
                    rest.wrapping_sub(gap)
                } else {
                    rest << 1
                };
                let (shifted, last) = digits.overflowing_add(digits);
                digits = shifted | digit as u32;
                // The 1 of the beginning leaves at the 32nd digit. (A count is what compilers unroll, badly.)
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
