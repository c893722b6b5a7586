//! Light through a slit by Metropolis light transport, in the `libm` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Libm;
use microwarp_firmware::scene::run_chain;

#[entry]
fn main() -> ! {
    run_chain::<Libm>("libm")
}
