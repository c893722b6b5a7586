//! A matte room, in the `poly` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Poly;
use microwarp_firmware::scene::{brightness, run};
use microwarp_scene::golden::Room;

#[entry]
fn main() -> ! {
    run::<Room, Poly>("poly", brightness)
}
