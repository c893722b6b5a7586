//! The square root, correctly rounded, by the hardware instruction where stable Rust can reach it.
//!
//! `libm` reaches the instruction on AArch64, but not on 32-bit Arm, on WASM only with an unstable compiler, and on x86-64
//! in a way that keeps loops from being vectorised. This is the only file with `unsafe`, for that one instruction. All
//! ways round correctly, so the bits are the same.

#[cfg(not(any(
    all(target_arch = "arm", target_abi = "eabihf"),
    target_arch = "x86_64",
    target_arch = "wasm32"
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

/// Every x86-64 processor has SSE. The compiler treats the intrinsic as any other square root.
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

/// With vectors, the compiler treats the intrinsic as any other square root, and loops get vectors.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    use core::arch::wasm32::{f32x4_extract_lane, f32x4_splat, f32x4_sqrt};
    f32x4_extract_lane::<0>(f32x4_sqrt(f32x4_splat(x)))
}

/// The compiler replaces the function of this name by the instruction. If it did not, the program would call the
/// function of compiler-builtins, which every WASM program links.
#[cfg(all(target_arch = "wasm32", not(target_feature = "simd128")))]
#[allow(unsafe_code)]
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    // SAFETY: the C function has this signature, and takes any number.
    unsafe extern "C" {
        safe fn sqrtf(x: f32) -> f32;
    }
    sqrtf(x)
}
