//! Quotients, digit by digit: for constructors, densities and inverses, and the same on every core.

/// ⌊a·2³²/b⌋ of a < b.
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
