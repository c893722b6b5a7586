//! The hashes of the pictures of the example `scene`, behind the exports of the golden evaluation.
#![no_std]
#![allow(unsafe_code)]

use core::panic::PanicInfo;
use core::ptr::addr_of_mut;
use microwarp_scene::golden::cases;

/// The hash of the picture that was rendered last.
static mut HASH: u32 = 0;

/// How many pictures there are.
#[unsafe(no_mangle)]
pub extern "C" fn golden_cases() -> usize {
    cases().count()
}

/// Renders one of them; returns how many words its hash has.
#[unsafe(no_mangle)]
pub extern "C" fn golden_evaluate(index: usize) -> usize {
    let hash = cases()
        .nth(index)
        .and_then(|case| (case.hash)(&case.plan).ok());
    // SAFETY: a module instance has one thread.
    unsafe { addr_of_mut!(HASH).write(hash.map_or(0, |hash| hash.word())) }
    usize::from(hash.is_some())
}

/// Where the hash is.
#[unsafe(no_mangle)]
pub extern "C" fn golden_words() -> *const u32 {
    addr_of_mut!(HASH).cast_const()
}

/// A trap, which node reports as an exception.
#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    #[cfg(target_arch = "wasm32")]
    core::arch::wasm32::unreachable();
    #[cfg(not(target_arch = "wasm32"))]
    loop {}
}
