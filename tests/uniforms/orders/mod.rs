//! Orders: shuffles, choices, and permutations that are computed.
//!
//! - `laws`: the probability of each order, by counting all words exactly; and what is refused
//! - `choices`: the same of choices of items that come one by one
//! - `batches`: a shuffle by few words against its definition in long integers; how many words it draws
//! - `permutation`: each number once, and back; statistics of places over seeds

mod batches;
mod choices;
mod laws;
mod permutation;

use microwarp::uniform::FromFn;
use rand_pcg::rand_core::Rng;

/// A generator of these words, and then of zeros.
fn listed(words: &[u32]) -> impl Rng {
    let mut words = words.iter().copied();
    FromFn(move || words.next().unwrap_or(0))
}

/// How many words are drawn.
fn drawn(draw: impl FnOnce(&mut dyn Rng)) -> usize {
    let mut count = 0;
    draw(&mut FromFn(|| {
        count += 1;
        0x9e37_79b9_u32.wrapping_mul(count as u32)
    }));
    count
}

/// The items 0 to n − 1 behind what is done to them.
fn ordered(count: u8, act: impl FnOnce(&mut [u8])) -> Vec<u8> {
    let mut items: Vec<u8> = (0..count).collect();
    act(&mut items);
    items
}
