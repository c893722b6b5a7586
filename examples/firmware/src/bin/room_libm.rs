//! A matte room, in the `libm` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Libm;
use microwarp_firmware::scene::{brightness, run};
use microwarp_scene::golden::Room;

#[entry]
fn main() -> ! {
    run::<Room, Libm>("libm", brightness)
}
