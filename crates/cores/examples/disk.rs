//! Poly disks and nothing else, to see how large such a module is.
#![no_std]
#![allow(unsafe_code)]

use core::panic::PanicInfo;
use microwarp::{Warp, poly as mw};
use rand_pcg::Pcg32;

/// Draws one point from a generator seeded with `seed`: the bits of x above those of y.
#[unsafe(no_mangle)]
pub extern "C" fn disk(seed: u64) -> u64 {
    let [x, y] = mw::Disk::new().draw(&mut Pcg32::new(seed, 1));
    u64::from(x.to_bits()) << 32 | u64::from(y.to_bits())
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}
