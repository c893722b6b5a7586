//! Light through a slit by Metropolis light transport, in the `poly` tier.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use microwarp::tier::Poly;
use microwarp_firmware::scene::run_chain;

#[entry]
fn main() -> ! {
    run_chain::<Poly>("poly")
}
