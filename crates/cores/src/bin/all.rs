//! Every public function, in both tiers.
#![no_std]
#![no_main]

use microwarp_cores::run;

/// The name that the check looks for, so that it knows it has read the right file.
#[unsafe(no_mangle)]
#[inline(never)]
fn microwarp_evaluate(index: usize, words: &mut [u32; 16]) -> usize {
    microwarp_list::evaluate(index, words)
}

#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn probe_main() {
    run(microwarp_list::cases(), microwarp_evaluate);
}
