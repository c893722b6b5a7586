//! One warp of the integer tier drawn with one generator: what it links is what it costs.
#![no_std]
#![no_main]

use fixed::types::I2F30;
use microwarp::{Warp, fixed as mw};
use microwarp_cores::{input, output};
use rand_pcg::Pcg32;

/// The name that the check looks for, so that it knows it has read the right file.
#[unsafe(no_mangle)]
#[inline(never)]
fn microwarp_fixed_disk(rng: &mut Pcg32) -> [I2F30; 2] {
    mw::Disk::new().draw(rng)
}

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    let mut rng = Pcg32::new(input(1).into(), input(2).into());
    for _ in 0..input(100) {
        for coordinate in microwarp_fixed_disk(&mut rng) {
            output(coordinate.to_bits() as u32);
        }
    }
}
