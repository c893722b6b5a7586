//! The golden bits of the `poly` tier, first half.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Poly;
use microwarp_firmware::golden::Part;

#[entry]
fn main() -> ! {
    Part::first_half::<Poly>(0).run()
}
