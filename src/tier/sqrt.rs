//! The square root, correctly rounded, by the hardware instruction where stable Rust can reach it.
//!
//! `libm` reaches the instruction on x86-64, AArch64 and WASM but not on 32-bit Arm, and on x86-64 in a way
//! that keeps a loop from being vectorised; `unsafe` stands for that one instruction. All ways
//! round correctly, so the bits are the same.

#[cfg(not(any(
    all(target_arch = "arm", target_abi = "eabihf"),
    target_arch = "x86_64"
)))]
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    ::libm::sqrtf(x)
}

/// A hard-float ABI implies the floating-point unit and its single-precision square root.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[allow(unsafe_code)]
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // SAFETY: the three instructions read and write only the named registers, touch no memory and
    // no flags. The value passes through a core register because the `sreg` operand class is
    // refused on single-precision units; `s0` is declared as clobbered.
    unsafe {
        core::arch::asm!(
            "vmov s0, {0}",
            "vsqrt.f32 s0, s0",
            "vmov {0}, s0",
            inout(reg) bits,
            out("s0") _,
            options(pure, nomem, nostack, preserves_flags)
        );
    }
    f32::from_bits(bits)
}

/// Every x86-64 processor has SSE. The compiler reads the intrinsic as a square root like any other.
#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)]
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    use core::arch::x86_64::{_mm_cvtss_f32, _mm_set_ss, _mm_sqrt_ss};
    // Newer compilers know that the target has the feature, and would call the block unused.
    #[allow(unused_unsafe)]
    // SAFETY: SSE is part of the architecture.
    unsafe {
        _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x)))
    }
}
