//! What a row of a picture weighs: the same as every other, or the solid angle of its zone of the sphere. In integers
//! and `const`, so that the words of a sky are the same in every tier and may lie in flash.

/// The rows of a picture.
#[derive(Clone, Copy)]
pub(crate) enum Zones {
    /// All weigh the same.
    Flat,
    /// So many zones between equally spaced parallels, from pole to pole.
    Sphere(usize),
}

/// Divisors of Taylor's series of the sine, the last first.
const DIVISORS: [u64; 7] = [14 * 15, 12 * 13, 10 * 11, 8 * 9, 6 * 7, 4 * 5, 2 * 3];

/// π/2 and its square, in steps of 2⁻³¹ and 2⁻³⁰.
const QUARTER: u64 = 3_373_259_426;
const QUARTER_SQUARED: u64 = 2_649_351_758;

/// The sine of k/n quarters of a turn, as m and s of m 2⁻ˢ: k from 1 to n, n below 2²⁶. It is right to 3 · 10⁻⁹ of
/// itself, and m < 2³³.
const fn sine(k: u64, n: u64) -> (u64, u32) {
    const ONE: u64 = 1 << 31;
    // The argument x as quarters, with 31 leading bits at least; its square, in steps of 2⁻³¹; and sin(x)/x.
    let shift = 31_u32
        .wrapping_add(k.leading_zeros())
        .wrapping_sub(n.leading_zeros());
    let quarters = quotient(k.wrapping_shl(shift), n);
    let plain = quotient(k.wrapping_shl(31), n);
    let square = (plain.wrapping_mul(plain) >> 31).wrapping_mul(QUARTER_SQUARED) >> 30;
    let mut ratio = ONE;
    let mut divisors: &[u64] = &DIVISORS;
    while let Some((&divisor, rest)) = divisors.split_first() {
        ratio = ONE.wrapping_sub(quotient(square.wrapping_mul(ratio) >> 31, divisor));
        divisors = rest;
    }
    let chord = quarters.wrapping_mul(ratio) >> 31;
    (chord.wrapping_mul(QUARTER) >> 31, shift)
}

const fn quotient(a: u64, b: u64) -> u64 {
    match a.checked_div(b) {
        Some(quotient) => quotient,
        None => 0,
    }
}

/// The sine of k/n quarters of a turn; 0 for k = 0.
pub(crate) const fn sine_of_quarters(k: usize, n: usize) -> f32 {
    if k == 0 {
        return 0.0;
    }
    let (m, shift) = sine(k as u64, n as u64);
    // At most 2⁵⁷, whose reciprocal is a normal number.
    m as f32 / (1_u64.wrapping_shl(shift)) as f32
}

impl Zones {
    /// The sum of a row's weights times what the row weighs, which is 1 at most. A sum above 0 stays above 0.
    pub(crate) const fn weigh(self, sum: u128, row: usize) -> u128 {
        let rows = match self {
            Self::Flat => return sum,
            Self::Sphere(rows) => rows,
        };
        // cos θ₀ − cos θ₁ = 2 sin((θ₀ + θ₁)/2) sin((θ₁ − θ₀)/2), of which the second sine is that of every zone.
        let middle = row.wrapping_mul(2).wrapping_add(1);
        let other = rows.wrapping_mul(2).saturating_sub(middle);
        let (m, shift) = sine(
            if middle < other { middle } else { other } as u64,
            rows as u64,
        );
        // Sums have 95 bits and m 33, but both at once only where the product has 128.
        let weighed = sum.wrapping_mul(m as u128).wrapping_shr(shift);
        if weighed == 0 && sum > 0 { 1 } else { weighed }
    }
}
