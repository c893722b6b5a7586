//! Generators: PCG32 in the memory of the caller, and any other by a callback that may fail.

use core::convert::Infallible;
use core::ffi::c_void;
use core::fmt;
use core_crate::uniform::{ByPosition, Points};
use rand_core::utils::{fill_bytes_via_next_word, next_u64_via_u32};
use rand_core::{Rng, TryRng};

/// `mw_pcg32`: the generator PCG-XSH-RR 64/32.
#[repr(C)]
pub struct Pcg32 {
    state: u64,
    increment: u64,
}

impl Pcg32 {
    #[inline]
    fn next(&mut self) -> u32 {
        let old = self.state;
        self.state = old
            .wrapping_mul(0x5851_F42D_4C95_7F2D)
            // Odd already, but in a struct of zeros, which would give nothing but zeros.
            .wrapping_add(self.increment | 1);
        let folded = ((old >> 18) ^ old) >> 27;
        (folded as u32).rotate_right((old >> 59) as u32)
    }
}

/// `mw_source`: a callback with its context.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Source {
    /// None in a struct of zeros, which fails.
    next: Option<unsafe extern "C" fn(*mut c_void, *mut u32) -> bool>,
    context: *mut c_void,
}

/// The callback returned false.
#[derive(Debug)]
pub struct SourceFailed;

impl fmt::Display for SourceFailed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the source failed")
    }
}

impl core::error::Error for SourceFailed {}

impl TryRng for Pcg32 {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(self.next())
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        next_u64_via_u32(self)
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        fill_bytes_via_next_word(bytes, || self.try_next_u32())
    }
}

impl TryRng for Source {
    type Error = SourceFailed;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, SourceFailed> {
        let mut word = 0;
        // SAFETY: the caller of the library promises a callback that takes this context and writes one word.
        let written =
            |next: unsafe extern "C" fn(_, _) -> _| unsafe { next(self.context, &raw mut word) };
        if self.next.is_some_and(written) {
            Ok(word)
        } else {
            Err(SourceFailed)
        }
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, SourceFailed> {
        next_u64_via_u32(self)
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), SourceFailed> {
        fill_bytes_via_next_word(bytes, || self.try_next_u32())
    }
}

/// What a function that draws begins with; it takes no instruction.
///
/// On x86-64 the conversion of a word to a float keeps the upper part of its register, so it waits for whatever wrote
/// that register last: the call before this one. The compiler breaks such a wait only where it sees a register written.
#[inline(always)]
pub fn forget_registers() {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: there is no instruction.
    unsafe {
        core::arch::asm!(
            "",
            out("xmm0") _, out("xmm1") _, out("xmm2") _, out("xmm3") _,
            out("xmm4") _, out("xmm5") _, out("xmm6") _, out("xmm7") _,
            out("xmm8") _, out("xmm9") _, out("xmm10") _, out("xmm11") _,
            options(nomem, nostack, preserves_flags)
        );
    }
}

#[unsafe(export_name = "mw_pcg32_init")]
extern "C" fn init(rng: &mut Pcg32, seed: u64, stream: u64) {
    let increment = (stream << 1) | 1;
    rng.state = seed.wrapping_add(increment);
    rng.increment = increment;
    rng.next();
}

/// `SeedableRng::from_rng` of `rand_pcg`.
#[unsafe(export_name = "mw_pcg32_init_at")]
extern "C" fn init_at(rng: &mut Pcg32, seed: u32, index: u32) {
    let mut words = ByPosition::new(seed, index).at(0);
    let seed = words.next_u64();
    init(rng, seed, words.next_u64() >> 1);
}

#[unsafe(export_name = "mw_pcg32_next")]
extern "C" fn next(rng: &mut Pcg32) -> u32 {
    rng.next()
}
