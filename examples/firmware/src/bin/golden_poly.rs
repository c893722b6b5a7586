//! The golden bits of the `poly` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp_firmware::golden::Part;
use microwarp_golden::{cases_of_tier, evaluate_poly};

#[entry]
fn main() -> ! {
    let part = Part {
        first: 0,
        count: cases_of_tier(),
        evaluate: evaluate_poly,
    };
    part.run()
}
