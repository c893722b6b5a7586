//! The 32-bit numbers that points of the integer tier consist of.

use ::fixed::types::extra::LeEqU32;
use ::fixed::{FixedI32, FixedU32};

mod sealed {
    /// A number as its bits.
    pub trait Bits32: Copy {
        /// The number of fraction bits.
        const FRACTION: u32;
        /// The sign bit; 0 for unsigned numbers.
        const SIGN: u32;
        fn to_word(self) -> u32;
        fn from_word(word: u32) -> Self;
    }
}
pub(super) use sealed::Bits32;

/// A number of 32 bits: `i32`, `u32`, or `FixedI32` and `FixedU32` of the crate `fixed`, with any number of fraction bits.
///
/// The values of an [`Interval`](super::Interval) are such numbers. The trait is sealed.
pub trait Number: Bits32 {}

impl<T: Bits32> Number for T {}

impl Bits32 for u32 {
    const FRACTION: u32 = 0;
    const SIGN: u32 = 0;

    #[inline]
    fn to_word(self) -> u32 {
        self
    }

    #[inline]
    fn from_word(word: u32) -> Self {
        word
    }
}

impl Bits32 for i32 {
    const FRACTION: u32 = 0;
    const SIGN: u32 = 1 << 31;

    #[inline]
    fn to_word(self) -> u32 {
        self as u32
    }

    #[inline]
    fn from_word(word: u32) -> Self {
        word as i32
    }
}

impl<Frac: LeEqU32> Bits32 for FixedU32<Frac> {
    const FRACTION: u32 = Frac::U32;
    const SIGN: u32 = 0;

    #[inline]
    fn to_word(self) -> u32 {
        self.to_bits()
    }

    #[inline]
    fn from_word(word: u32) -> Self {
        Self::from_bits(word)
    }
}

impl<Frac: LeEqU32> Bits32 for FixedI32<Frac> {
    const FRACTION: u32 = Frac::U32;
    const SIGN: u32 = 1 << 31;

    #[inline]
    fn to_word(self) -> u32 {
        self.to_bits() as u32
    }

    #[inline]
    fn from_word(word: u32) -> Self {
        Self::from_bits(word as i32)
    }
}
