//! The golden evaluation behind three exports: how many cases, evaluate one, where its words are.
#![no_std]
#![allow(unsafe_code)]

use core::panic::PanicInfo;
use core::ptr::addr_of_mut;

/// The words of the case evaluated last.
static mut WORDS: [u32; 16] = [0; 16];

/// How many cases there are.
#[unsafe(no_mangle)]
pub extern "C" fn golden_cases() -> usize {
    microwarp_list::cases()
}

/// Evaluates one case; returns how many words of the buffer it filled.
#[unsafe(no_mangle)]
pub extern "C" fn golden_evaluate(index: usize) -> usize {
    // SAFETY: a module instance has one thread, and no reference outlives this call.
    let words = unsafe { &mut *addr_of_mut!(WORDS) };
    microwarp_list::evaluate(index, words)
}

/// Where the sixteen words of the buffer are.
#[unsafe(no_mangle)]
pub extern "C" fn golden_words() -> *const u32 {
    addr_of_mut!(WORDS).cast_const().cast()
}

/// A trap, which node reports as an exception.
#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    #[cfg(target_arch = "wasm32")]
    core::arch::wasm32::unreachable();
    #[cfg(not(target_arch = "wasm32"))]
    loop {}
}
