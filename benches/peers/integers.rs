//! Contests of integers of a range, coins and orders, beside rand.

use crate::contestants::{EACH, FLOOR, INDEX, RAND_DISTR, WIDE};
use host::contest::Contest;
use host::peers::rejecting;
use microwarp::uniform::{Chance, Range, choose as choose_of, shuffle as shuffle_of, shuffle_each};
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

/// An index; how many there are is not known to the compiler.
pub fn below(n: u32) -> Contest<u32> {
    let (ours, peer) = black_box((Range::below(n).unwrap(), n));
    Contest::new(0)
        .draw(FLOOR, |rng| rng.next_u32())
        .draw(INDEX, move |rng| ours.draw(rng))
        .draw(WIDE, move |rng| ours.draw_wide(rng))
        .draw(RAND_DISTR, rejecting::below(peer))
}

/// An integer of a range with a sign.
pub fn range(low: i32, high: i32) -> Contest<i32> {
    let (ours, [low, high]) = black_box((Range::signed(low, high).unwrap(), [low, high]));
    Contest::new(0)
        .draw(FLOOR, |rng| rng.next_u32() as i32)
        .draw(INDEX, move |rng| ours.draw(rng))
        .draw(WIDE, move |rng| ours.draw_wide(rng))
        .draw(RAND_DISTR, rejecting::range(low, high))
}

/// An integer of 64 bits.
pub fn below_of_64_bits(n: u64) -> Contest<u64> {
    let (ours, peer) = black_box((Range::of_u64(0, n - 1).unwrap(), n));
    Contest::new(0)
        .draw(FLOOR, |rng| {
            u64::from(rng.next_u32()) << 32 | u64::from(rng.next_u32())
        })
        .draw(INDEX, move |rng| ours.draw(rng))
        .draw(RAND_DISTR, rejecting::below_of_64_bits(peer))
}

/// A coin.
pub fn chance(p: f32) -> Contest<bool> {
    let (ours, peer) = black_box((Chance::new(p).unwrap(), f64::from(p)));
    Contest::new(false)
        .draw(FLOOR, |rng| rng.next_u32() >> 31 == 1)
        .draw(INDEX, move |rng| ours.draw(rng))
        .draw(RAND_DISTR, rejecting::chance(peer))
}

/// Orders in place of each other, some at a time. The generator alone draws a word an item.
fn of_orders(items: u32) -> Contest<u32> {
    Contest::of_blocks(0, 16, 4).draw(FLOOR, move |rng| {
        (1..items).fold(0, |all, _| all ^ rng.next_u32())
    })
}

fn numbers(items: u32) -> Vec<u32> {
    (0..items).collect()
}

/// A random order of so many numbers.
pub fn shuffle(items: u32) -> Contest<u32> {
    let [mut ours, mut each] = [numbers(items), numbers(items)];
    of_orders(items)
        .draw(INDEX, move |rng| {
            shuffle_of(&mut ours, rng);
            ours[0]
        })
        .draw(EACH, move |rng| {
            shuffle_each(&mut each, rng);
            each[0]
        })
        .draw(RAND_DISTR, rejecting::shuffle(numbers(items)))
}

/// Some of so many numbers.
pub fn choose(items: u32, chosen: usize) -> Contest<u32> {
    let mut ours = numbers(items);
    let number = black_box(chosen);
    of_orders(chosen as u32 + 1)
        .draw(INDEX, move |rng| {
            let (chosen, _) = choose_of(&mut ours, number, rng).unwrap();
            chosen[0]
        })
        .draw(RAND_DISTR, rejecting::choose(numbers(items), number))
}
