//! What runs on a core without an operating system: with the feature `kernels` one function of microwarp that is measured,
//! otherwise a program of `src/bin`, whose symbols are read.
//!
//! This file is the runtime of both: vectors and reset. There is no external runtime crate, so only the compiler's,
//! microwarp's and our own code is linked.
#![no_std]

#[cfg(feature = "kernels")]
mod measured;
#[cfg(not(feature = "kernels"))]
mod program;

use core::hint::black_box;
use core::ptr::{addr_of, addr_of_mut};
#[cfg(feature = "kernels")]
use measured::{halt, start};
#[cfg(not(feature = "kernels"))]
use program::{halt, start};

unsafe extern "C" {
    static mut data_start: u32;
    static data_end: u32;
    static data_load: u32;
    static mut bss_start: u32;
    static bss_end: u32;
}

/// The vectors after the initial stack pointer: reset, NMI, hard fault. Nothing else is enabled. Not `#[used]` beside
/// kernels, which would keep all of this in what is measured alone.
#[unsafe(no_mangle)]
#[cfg_attr(not(feature = "kernels"), used)]
#[cfg_attr(target_os = "none", unsafe(link_section = ".vectors"))]
pub static VECTORS: [unsafe extern "C" fn() -> !; 3] = [reset, halt, halt];

/// Fills `.data` and `.bss`, switches the floating-point unit on where there is one, and starts.
///
/// # Safety
/// Only the processor calls it, once, before anything else runs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn reset() -> ! {
    // SAFETY: the linker script lays these sections out, word-aligned, and nobody else runs yet.
    unsafe {
        let (mut to, mut from) = (addr_of_mut!(data_start), addr_of!(data_load));
        while to.cast_const() < addr_of!(data_end) {
            to.write_volatile(from.read_volatile());
            to = to.add(1);
            from = from.add(1);
        }
        let mut to = addr_of_mut!(bss_start);
        while to.cast_const() < addr_of!(bss_end) {
            to.write_volatile(0);
            to = to.add(1);
        }
    }
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    // SAFETY: CPACR of an ARMv7E-M core; full access to coprocessors 10 and 11.
    unsafe {
        let cpacr = 0xE000_ED88 as *mut u32;
        cpacr.write_volatile(cpacr.read_volatile() | 0xF << 20);
        core::arch::asm!("dsb", "isb");
    }
    start()
}

/// A number the optimiser knows nothing about.
#[inline(never)]
pub fn input(value: u32) -> u32 {
    black_box(value)
}

/// A write the optimiser must perform.
#[inline(never)]
pub fn output(word: u32) {
    static mut SINK: u32 = 0;
    // SAFETY: there is one thread and no interrupt.
    unsafe { addr_of_mut!(SINK).write_volatile(word) }
}

/// Runs every golden case through `evaluate` and puts the bits out.
pub fn run(cases: usize, evaluate: fn(usize, &mut [u32; 16]) -> usize) {
    for index in 0..input(cases as u32) {
        let mut words = [0; 16];
        let written = evaluate(index as usize, &mut words);
        words.iter().take(written).for_each(|&word| output(word));
    }
}
