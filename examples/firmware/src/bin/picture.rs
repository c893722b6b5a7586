//! A picture in the `poly` tier, or with the feature `libm` in that one: a matte room; with `sensor` a range sensor in fog, with
//! `slit` light through a slit by Metropolis light transport.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
#[cfg(feature = "libm")]
use microwarp::tier::Libm as Tier;
#[cfg(not(feature = "libm"))]
use microwarp::tier::Poly as Tier;
use microwarp_firmware::scene::{brightness, nearness, run, run_chain};
use microwarp_scene::golden::{Room, Sensor};

#[entry]
fn main() -> ! {
    let tier = if cfg!(feature = "libm") {
        "libm"
    } else {
        "poly"
    };
    if cfg!(feature = "sensor") {
        run::<Sensor, Tier>(tier, nearness)
    } else if cfg!(feature = "slit") {
        run_chain::<Tier>(tier)
    } else {
        run::<Room, Tier>(tier, brightness)
    }
}
