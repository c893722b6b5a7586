//! The golden bits of the integer tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::{Libm, Poly};
use microwarp_firmware::golden::Part;
use microwarp_list::{Golden as _, cases, evaluate_fixed};

#[entry]
fn main() -> ! {
    let part = Part {
        first: Poly::cases() + Libm::cases(),
        count: cases() - Poly::cases() - Libm::cases(),
        evaluate: evaluate_fixed,
    };
    part.run()
}
