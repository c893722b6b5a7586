//! The golden bits: the first half of the `poly` tier; with the features `libm` and `second` those of that tier and half, with
//! `integers` those of the integer tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::{Libm, Poly};
use microwarp_firmware::golden::Part;
use microwarp_list::{Golden, cases, evaluate_fixed};

#[cfg(feature = "libm")]
type Tier = Libm;
#[cfg(not(feature = "libm"))]
type Tier = Poly;

#[entry]
fn main() -> ! {
    let tiers = Poly::cases() + Libm::cases();
    let part = if cfg!(feature = "integers") {
        Part {
            first: tiers,
            count: cases() - tiers,
            evaluate: evaluate_fixed,
        }
    } else {
        let first = if cfg!(feature = "libm") {
            Poly::cases()
        } else {
            0
        };
        if cfg!(feature = "second") {
            Part::second_half::<Tier>(first)
        } else {
            Part::first_half::<Tier>(first)
        }
    };
    part.run()
}
