//! Points of any format as the integers of their bits, and back.

use ::fixed::FixedI32;

/// The bits of a point.
pub(super) const fn bits<Frac, const D: usize>(point: &[FixedI32<Frac>; D]) -> [i32; D] {
    let mut bits = [0; D];
    let (mut rest, mut slots): (_, &mut [i32]) = (point.as_slice(), &mut bits);
    while let ([x, others @ ..], [slot, later @ ..]) = (rest, slots) {
        *slot = x.to_bits();
        (rest, slots) = (others, later);
    }
    bits
}

/// The point of these bits.
pub(super) const fn of_bits<Frac, const D: usize>(bits: &[i32; D]) -> [FixedI32<Frac>; D] {
    let mut point = [FixedI32::ZERO; D];
    let (mut rest, mut slots): (_, &mut [FixedI32<Frac>]) = (bits.as_slice(), &mut point);
    while let ([x, others @ ..], [slot, later @ ..]) = (rest, slots) {
        *slot = FixedI32::from_bits(*x);
        (rest, slots) = (others, later);
    }
    point
}
