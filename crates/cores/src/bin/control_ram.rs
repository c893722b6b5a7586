//! A control: a table in RAM, which the check of RAM must see.
#![no_std]
#![no_main]

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use microwarp_cores::{input, output};

static TABLE: [AtomicU32; 528] = [const { AtomicU32::new(0) }; 528];

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    for (word, index) in TABLE.iter().zip(0..) {
        word.store(input(index), Relaxed);
    }
    for word in &TABLE {
        output(word.load(Relaxed));
    }
}
