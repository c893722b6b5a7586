//! A range sensor in fog, in the `poly` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Poly;
use microwarp_firmware::scene::{nearness, run};
use microwarp_scene::golden::Sensor;

#[entry]
fn main() -> ! {
    run::<Sensor, Poly>("poly", nearness)
}
