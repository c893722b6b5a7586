//! The golden bits of the `libm` tier, second half.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Libm;
use microwarp_firmware::golden::Part;
use microwarp_list::cases_of_tier;

#[entry]
fn main() -> ! {
    Part::second_half::<Libm>(cases_of_tier()).run()
}
