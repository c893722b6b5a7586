//! The samplers of microwarp as C functions; `include/microwarp.h` declares and describes them.
//!
//! The warps come from the lists of `crates/list`, one macro for all. The other samplers have a file each.
//!
//! # Safety
//! The callers are C programs, and what they promise stands at the top of the header: a pointer is valid for what the
//! function does with it, and a struct has been made by its `_init`. Each `unsafe` below rests on that. Every input is
//! read before an output is written, so these may overlap.
#![no_std]
#![deny(clippy::undocumented_unsafe_blocks)]
#![allow(
    improper_ctypes_definitions,
    reason = "an out-parameter of a number is an empty struct, which no calling convention passes"
)]

mod chain;
mod chooser;
mod discrete;
mod error;
mod estimate;
mod frame;
mod generators;
mod integers;
mod layout;
mod lights;
mod maps;
mod orders;
mod points;
mod rejection;
mod tables;
mod trees;
mod value;
mod warps;
mod weighted;

/// Nothing here panics, so no program links this; `bindings/c/test` looks.
#[cfg(not(test))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
