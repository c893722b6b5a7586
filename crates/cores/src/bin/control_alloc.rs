//! Must be caught: a box. The allocator hands out one static word, which is all it is asked for, and
//! is kept out of line: inlined whole, it would leave no symbol. (The clean probes have no allocator
//! at all, so whatever asked for memory there would not even link.)
#![no_std]
#![no_main]

extern crate alloc;

use alloc::boxed::Box;
use core::alloc::{GlobalAlloc, Layout};
use core::hint::black_box;
use core::ptr::addr_of_mut;
use microwarp_cores::{input, output};

struct OneWord;

// SAFETY: the one word is large enough and aligned for the one u32 that is ever asked for.
unsafe impl GlobalAlloc for OneWord {
    #[inline(never)]
    unsafe fn alloc(&self, _: Layout) -> *mut u8 {
        static mut WORD: u32 = 0;
        addr_of_mut!(WORD).cast()
    }
    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static HEAP: OneWord = OneWord;

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let boxed = black_box(Box::new(input(1)));
    output(*boxed);
}
