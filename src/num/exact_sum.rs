//! Exact sums of products, for signs that rounding would decide otherwise.

use super::scaled::Scaled;
use core::array::from_fn;

/// The exact sum of up to 2¹⁶ products of two finite `f32`: a fixed-point number in two's complement, whose last bit is
/// 2⁻²⁹⁸. It takes integer operations alone.
#[derive(Clone, Copy)]
pub(crate) struct ExactSum([u64; 9]);

/// The significand of a finite `f32`, and its exponent from 2⁻¹⁴⁹ up.
#[inline]
pub(super) const fn parts(x: f32) -> (u64, u32) {
    let bits = x.to_bits();
    let (field, fraction) = ((bits >> 23) & 0xff, (bits & 0x007f_ffff) as u64);
    match field {
        0 => (fraction, 0),
        _ => (fraction | 0x0080_0000, field.wrapping_sub(1)),
    }
}

impl ExactSum {
    pub(crate) const ZERO: Self = Self([0; 9]);

    /// The sum and these words, or less them.
    fn and(self, negative: bool, words: Self) -> Self {
        let (mask, mut carry) = (u64::from(negative).wrapping_neg(), negative);
        let mut sum = self;
        for (word, more) in sum.0.iter_mut().zip(&words.0) {
            let (first, over) = word.overflowing_add(more ^ mask);
            let (last, again) = first.overflowing_add(u64::from(carry));
            (*word, carry) = (last, over | again);
        }
        sum
    }

    /// The sum and a·b.
    pub(crate) fn plus(self, a: f32, b: f32) -> Self {
        let ((a_part, a_up), (b_part, b_up)) = (parts(a), parts(b));
        // Below 2⁴⁸, so it reaches into one word more at most.
        let (product, up) = (a_part.wrapping_mul(b_part), a_up.wrapping_add(b_up));
        let (place, shift) = ((up >> 6) as usize, up & 63);
        let (low, high) = (product << shift, (product >> 1) >> (shift ^ 63));
        let words = from_fn(|k| match k.wrapping_sub(place) {
            0 => low,
            1 => high,
            _ => 0,
        });
        self.and(a.is_sign_negative() != b.is_sign_negative(), Self(words))
    }

    /// Whether the sum is negative, and its size, rounded; nothing where it is 0.
    pub(crate) fn value(self) -> (bool, Option<Scaled>) {
        let [.., last] = self.0;
        let negative = last >> 63 == 1;
        let (mut below, mut weight, mut size) = (0_u64, -298_i32, None);
        for &word in &Self::ZERO.and(negative, self).0 {
            if word > 0 {
                let zeros = word.leading_zeros();
                let bits = word << zeros | (below >> 1) >> (zeros ^ 63);
                size = Some(Scaled::of(bits as f32).raised(weight.wrapping_sub_unsigned(zeros)));
            }
            (below, weight) = (word, weight.wrapping_add(64));
        }
        (negative, size)
    }
}
