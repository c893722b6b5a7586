//! Products, the same bits with and without a long multiply.

use core::hint::black_box;

/// ⌊a·b/2³²⌋, exactly.
#[inline]
pub(in crate::fixed) fn high(a: u32, b: u32) -> u32 {
    on_this_core!(high_on(a, b))
}

#[inline]
pub(super) fn high_on<const NARROW: bool>(a: u32, b: u32) -> u32 {
    if NARROW {
        let (ah, al, bh, bl) = (a >> 16, a & 0xffff, b >> 16, b & 0xffff);
        // Without it the compiler recognises a long product and calls a routine that is twice as slow.
        let bl = black_box(bl);
        let middle = ah * bl + ((al * bl) >> 16);
        let other = al * bh + (middle & 0xffff);
        ah * bh + (middle >> 16) + (other >> 16)
    } else {
        ((u64::from(a) * u64::from(b)) >> 32) as u32
    }
}

/// a·b/2³², less by up to 3: three narrow products, or fewer wide ones.
#[inline]
pub(in crate::fixed) const fn near(a: u32, b: u32) -> u32 {
    let (ah, bh, bl) = (a >> 16, b >> 16, b & 0xffff);
    by_half(a, bh) + ((ah * bl) >> 16)
}

/// a·b/2³² of a signed b, less by up to 3.
#[inline]
pub(in crate::fixed) const fn near_signed(a: u32, b: i32) -> i32 {
    let (ah, bh, bl) = (a >> 16, b >> 16, (b & 0xffff) as u32);
    by_signed_half(a, bh) + ((ah * bl) >> 16) as i32
}

/// ⌊a·b/2¹⁶⌋ of b < 2¹⁶, exactly.
#[inline]
pub(in crate::fixed) const fn by_half(a: u32, b: u32) -> u32 {
    on_this_core!(by_half_on(a, b))
}

#[inline]
pub(super) const fn by_half_on<const NARROW: bool>(a: u32, b: u32) -> u32 {
    if NARROW {
        (a >> 16) * b + (((a & 0xffff) * b) >> 16)
    } else {
        ((a as u64 * b as u64) >> 16) as u32
    }
}

/// ⌊a·b/2¹⁶⌋ of −2¹⁵ ≤ b < 2¹⁵, exactly.
#[inline]
pub(in crate::fixed) const fn by_signed_half(a: u32, b: i32) -> i32 {
    on_this_core!(by_signed_half_on(a, b))
}

#[inline]
pub(super) const fn by_signed_half_on<const NARROW: bool>(a: u32, b: i32) -> i32 {
    if NARROW {
        (a >> 16) as i32 * b + (((a & 0xffff) as i32 * b) >> 16)
    } else {
        ((a as i64 * b as i64) >> 16) as i32
    }
}

/// a·b/2³² of two signed numbers, less by up to 3.
#[inline]
pub(in crate::fixed) const fn near_of_signed(a: i32, b: i32) -> i32 {
    let (ah, bh, bl) = (a >> 16, b >> 16, b & 0xffff);
    signed_by_half(a, bh) + ((ah * bl) >> 16)
}

/// ⌊a·b/2¹⁶⌋ of a signed a and −2¹⁵ ≤ b < 2¹⁵, exactly.
#[inline]
const fn signed_by_half(a: i32, b: i32) -> i32 {
    on_this_core!(signed_by_half_on(a, b))
}

#[inline]
pub(super) const fn signed_by_half_on<const NARROW: bool>(a: i32, b: i32) -> i32 {
    if NARROW {
        (a >> 16) * b + (((a & 0xffff) * b) >> 16)
    } else {
        ((a as i64 * b as i64) >> 16) as i32
    }
}

/// a·b/2³² of a signed b of at most 2³⁰ in magnitude, from the first 15 bits of a and 17 of b: one narrow product.
#[inline]
pub(in crate::fixed) const fn rough_signed(a: u32, b: i32) -> i32 {
    ((a >> 17) as i32 * (b >> 14)) >> 1
}

/// a²/2³², less by up to 2.
#[inline]
pub(in crate::fixed) const fn square(a: u32) -> u32 {
    let (h, l) = (a >> 16, a & 0xffff);
    h * h + ((h * l) >> 15)
}

/// a·b, exactly.
#[inline]
pub(in crate::fixed) fn wide(a: u32, b: u32) -> u64 {
    u64::from(high(a, b)) << 32 | u64::from(a.wrapping_mul(b))
}
