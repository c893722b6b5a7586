//! The golden bits of the integer tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp_firmware::golden::Part;
use microwarp_list::{cases, cases_of_tier, evaluate_fixed};

#[entry]
fn main() -> ! {
    let part = Part {
        first: 2 * cases_of_tier(),
        count: cases() - 2 * cases_of_tier(),
        evaluate: evaluate_fixed,
    };
    part.run()
}
