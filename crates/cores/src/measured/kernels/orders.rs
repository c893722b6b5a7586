//! Shuffles of items on the stack, which are laid out first; and a number of a permutation in memory, by its place.

use crate::measured::registry::{kernels, loaded, made};
use microwarp::uniform::{Permutation, choose, shuffle, shuffle_each};

fn deck() -> [u8; 52] {
    core::array::from_fn(|card| card as u8)
}

kernels! {
    "shuffle_52_pcg32" (rng) -> u32 = { let mut deck = deck(); shuffle(&mut deck, rng); deck[0].into() };
    "shuffle_each_52_pcg32" (rng) -> u32 = { let mut deck = deck(); shuffle_each(&mut deck, rng); deck[0].into() };
    "choose_52_5_pcg32" (rng) -> u32 = { let mut deck = deck(); u32::from(choose(&mut deck, 5, rng).is_ok()) + u32::from(deck[4]) };
    "permutation_16" (place: u32) -> u32 = loaded(|| Permutation::new(16, 7)).get(place >> 28).unwrap_or(0),
        _ = made(|| Permutation::new(16, 7));
    "permutation_1000" (place: u32) -> u32 = loaded(|| Permutation::new(1000, 7)).get(place >> 23).unwrap_or(0),
        _ = made(|| Permutation::new(1000, 7));
    "permutation_1000_inverse" (number: u32) -> u32 = loaded(|| Permutation::new(1000, 7)).index_of(number >> 23).unwrap_or(0),
        _ = made(|| Permutation::new(1000, 7));
}
