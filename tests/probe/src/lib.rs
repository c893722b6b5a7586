//! The little runtime under the probes: vectors, reset, the panic handler, and the two ends of an
//! optimiser-proof pipe (`input`, `output`). What a probe calls is in `src/bin/`.
//!
//! There is no outside runtime crate, so that every symbol of a linked probe is the compiler's,
//! microwarp's or ours.
#![no_std]

use core::hint::black_box;
use core::panic::PanicInfo;
use core::ptr::{addr_of, addr_of_mut};

unsafe extern "C" {
    static mut data_start: u32;
    static data_end: u32;
    static data_load: u32;
    static mut bss_start: u32;
    static bss_end: u32;
    /// What the probe does, once memory is ready.
    safe fn probe_main();
}

/// The vectors after the initial stack pointer: reset, NMI, hard fault. Nothing else is enabled.
#[used]
#[unsafe(link_section = ".vectors")]
static VECTORS: [unsafe extern "C" fn() -> !; 3] = [reset, halt, halt];

/// Fills `.data` and `.bss`, switches the floating-point unit on where there is one, runs the probe.
///
/// # Safety
/// Only the processor calls it, once, before anything else runs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn reset() -> ! {
    // SAFETY: the linker script lays these sections out, word-aligned, and nobody else runs yet.
    unsafe {
        copy_words(
            addr_of_mut!(data_start),
            addr_of!(data_end),
            addr_of!(data_load),
        );
        clear_words(addr_of_mut!(bss_start), addr_of!(bss_end));
    }
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    // SAFETY: CPACR of an ARMv7E-M core; full access to coprocessors 10 and 11.
    unsafe {
        let cpacr = 0xE000_ED88 as *mut u32;
        cpacr.write_volatile(cpacr.read_volatile() | 0xF << 20);
    }
    probe_main();
    halt()
}

unsafe fn copy_words(mut to: *mut u32, end: *const u32, mut from: *const u32) {
    while to.cast_const() < end {
        // SAFETY: the caller's ranges are valid and aligned.
        unsafe {
            to.write_volatile(from.read_volatile());
            to = to.add(1);
            from = from.add(1);
        }
    }
}

unsafe fn clear_words(mut to: *mut u32, end: *const u32) {
    while to.cast_const() < end {
        // SAFETY: the caller's range is valid and aligned.
        unsafe {
            to.write_volatile(0);
            to = to.add(1);
        }
    }
}

/// Stops for good.
#[unsafe(no_mangle)]
pub extern "C" fn halt() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

/// Reads the whole message, so that no part of the panic machinery can be optimised away: where a
/// panic can be reached, `core::panicking`, `core::fmt` and `probe_panicked` are all in the symbols.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    probe_panicked(info)
}

#[unsafe(no_mangle)]
#[inline(never)]
fn probe_panicked(info: &PanicInfo) -> ! {
    struct Sink;
    impl core::fmt::Write for Sink {
        fn write_str(&mut self, text: &str) -> core::fmt::Result {
            text.bytes().for_each(|byte| output(byte.into()));
            Ok(())
        }
    }
    let _ = core::fmt::write(&mut Sink, format_args!("{info}"));
    halt()
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
