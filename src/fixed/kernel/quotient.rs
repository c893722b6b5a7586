//! Quotients, digit by digit, for constructors, densities and inverses. Every core computes the same.

/// ⌊a·2³²/b⌋, for a < b.
#[inline]
pub(in crate::fixed) const fn quotient(a: u32, b: u32) -> u32 {
    let (mut rest, mut digits, mut step) = (a, 0, 0);
    while step < 32 {
        let carried = rest >> 31 != 0;
        rest <<= 1;
        digits <<= 1;
        if carried || rest >= b {
            rest = rest.wrapping_sub(b);
            digits |= 1;
        }
        step += 1;
    }
    digits
}

/// ⌊a·2³²/b⌋, for any a and for b > 0.
pub(in crate::fixed) const fn ratio(a: u32, b: u32) -> u64 {
    let (mut rest, mut digits, mut left) = (0_u64, 0_u64, 64);
    while left > 0 {
        left -= 1;
        rest = rest << 1 | ((a as u64) << 32 >> left) & 1;
        digits <<= 1;
        if rest >= b as u64 {
            rest -= b as u64;
            digits |= 1;
        }
    }
    digits
}

/// 2ᵖ/b rounded to the nearest integer, for 0 < b ≤ 2⁶³; the largest word if it does not fit.
pub(in crate::fixed) const fn reciprocal(power: u32, b: u64) -> u64 {
    let (mut rest, mut digits, mut left) = (1, 0_u64, power);
    loop {
        if rest >= b {
            rest -= b;
            if digits >> 63 != 0 {
                return u64::MAX;
            }
            digits |= 1;
        }
        if left == 0 {
            // Half of b or more is rounded up.
            return digits.saturating_add((rest >= b - rest) as u64);
        }
        left -= 1;
        rest <<= 1;
        if digits >> 63 != 0 {
            return u64::MAX;
        }
        digits <<= 1;
    }
}
