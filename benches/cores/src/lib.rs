//! The cost of one function of microwarp on an emulated Cortex-M, and as WASM.
//!
//! This file is the small runtime: vectors, reset, output to the host. `kernels` lists what is measured, `count.rs`
//! measures, and `words.rs` defines the inputs and outputs of a kernel. There is no external runtime crate, so only the
//! compiler's, microwarp's and our own code is linked.
#![no_std]

mod count;
#[cfg(sweep)]
mod edges;
#[cfg(sweep)]
mod hard;
mod kernels;
#[cfg(target_arch = "wasm32")]
mod module;
mod registry;
#[cfg(sweep)]
mod sweep;
mod textbook;
mod varied;
mod words;

use core::ptr::{addr_of, addr_of_mut};

unsafe extern "C" {
    static mut data_start: u32;
    static data_end: u32;
    static data_load: u32;
    static mut bss_start: u32;
    static bss_end: u32;
}

/// The vectors after the initial stack pointer: reset, NMI, hard fault. Nothing else is enabled. Not `#[used]`,
/// which would keep all of this in what is measured alone.
#[unsafe(no_mangle)]
#[cfg_attr(target_os = "none", unsafe(link_section = ".vectors"))]
pub static VECTORS: [unsafe extern "C" fn() -> !; 3] = [reset, fault, fault];

/// Fills `.data` and `.bss`, switches the floating-point unit on where there is one, and measures.
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
    if let Some(entry) = kernels::entry() {
        say(&count::measure(entry));
    }
    exit(true)
}

extern "C" fn fault() -> ! {
    exit(false)
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    exit(false)
}

/// Writes words for the host, in hexadecimal, on one line.
fn say(words: &[u32]) {
    let digits = words
        .iter()
        .flat_map(|&word| {
            (0..8)
                .rev()
                .map(move |place| (word >> (4 * place)) & 15)
                .map(|digit| b"0123456789abcdef"[digit as usize])
                .chain([b' '])
        })
        .chain([b'\n']);
    for digit in digits {
        semihosting(3, (&raw const digit).addr());
    }
}

/// Ends the emulator. Without a line before it the host knows that something failed.
fn exit(well: bool) -> ! {
    semihosting(0x18, if well { 0x2_0026 } else { 0x2_0023 });
    loop {
        core::hint::spin_loop();
    }
}

#[cfg(target_arch = "arm")]
#[inline(never)]
fn semihosting(operation: usize, argument: usize) {
    // SAFETY: the call of Arm's semihosting; the operations used only read.
    unsafe {
        core::arch::asm!("bkpt 0xab", inout("r0") operation => _, in("r1") argument);
    }
}

/// On the host there is nothing to write to; there the package is only type-checked.
#[cfg(not(target_arch = "arm"))]
fn semihosting(_: usize, _: usize) {}
