//! What becomes of a panic: an import, which stands in a module if and only if something in it can panic. The page's
//! module has this handler, and so has the control in `examples/panics.rs`.
#![no_std]
#![allow(unsafe_code, reason = "an import is declared")]

use core::panic::PanicInfo;

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    safe fn panicked() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    #[cfg(target_arch = "wasm32")]
    panicked();
    #[cfg(not(target_arch = "wasm32"))]
    loop {}
}
