//! Must be caught: an index that can be out of bounds.
#![no_std]
#![no_main]

use microwarp_cores::{input, output};

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let table = [input(1), input(2), input(3)];
    output(table[input(4) as usize]);
}
