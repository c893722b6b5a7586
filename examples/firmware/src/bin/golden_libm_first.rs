//! The golden bits of the `libm` tier, first half.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::{Libm, Poly};
use microwarp_firmware::golden::Part;
use microwarp_list::Golden as _;

#[entry]
fn main() -> ! {
    Part::first_half::<Libm>(Poly::cases()).run()
}
