//! A range sensor in fog, in the `libm` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Libm;
use microwarp_firmware::scene::{nearness, run};
use microwarp_scene::golden::Sensor;

#[entry]
fn main() -> ! {
    run::<Sensor, Libm>("libm", nearness)
}
