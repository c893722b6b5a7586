//! Must be caught: one f64 multiplication, as in code that "only" widens for a moment.
#![no_std]
#![no_main]

use microwarp_cores::{input, output};

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let x = f32::from_bits(input(0x3f80_0000));
    output(((f64::from(x) * 1.1) as f32).to_bits());
}
