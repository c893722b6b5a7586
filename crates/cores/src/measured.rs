//! The measurement of one function on an emulated Cortex-M, and as WASM.
//!
//! `kernels` lists what is measured, `count.rs` measures, and `words.rs` defines the inputs and outputs of a kernel. Here is
//! what the program says to the host.

mod count;
#[cfg(sweep)]
mod edges;
mod kernels;
#[cfg(target_arch = "wasm32")]
mod module;
mod registry;
#[cfg(sweep)]
mod sweep;
mod textbook;
mod varied;
mod words;

/// Measures the one kernel that there is.
pub fn start() -> ! {
    if let Some(entry) = kernels::entry() {
        say(&count::measure(entry));
    }
    exit(true)
}

pub extern "C" fn halt() -> ! {
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
