//! The golden bits of the `libm` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp_firmware::golden::Part;
use microwarp_golden::{cases_of_tier, evaluate_libm};

#[entry]
fn main() -> ! {
    let part = Part {
        first: cases_of_tier(),
        count: cases_of_tier(),
        evaluate: evaluate_libm,
    };
    part.run()
}
