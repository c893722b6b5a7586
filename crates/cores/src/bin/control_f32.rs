//! Must be caught on a core without a floating-point unit: one f32 multiplication of an integer's share.
#![no_std]
#![no_main]

use microwarp_cores::{input, output};

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    output((input(3) as f32 * 0.1) as u32);
}
