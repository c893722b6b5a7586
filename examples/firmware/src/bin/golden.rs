//! The golden bits: the first half of the `poly` tier; with the features `libm` and `second` those of that tier and half, with
//! `integers` those of the integer tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
#[cfg(feature = "libm")]
use microwarp::tier::Libm as Tier;
#[cfg(not(feature = "libm"))]
use microwarp::tier::Poly as Tier;
use microwarp_firmware::golden::Part;

#[entry]
fn main() -> ! {
    let part = if cfg!(feature = "integers") {
        Part::integers()
    } else if cfg!(feature = "second") {
        Part::second_half::<Tier>()
    } else {
        Part::first_half::<Tier>()
    };
    part.run()
}
