//! Contests of tables of weights.

use crate::args::{EACH, FLOOR, INDEX, RAND_DISTR, SELECTION, TEXTBOOK, WIDE};
use host::contest::Contest;
use host::peers::{drawn, rejecting, textbook};
use microwarp::discrete::{Alias, AliasEntry, Cdf, SumTree};
use microwarp::uniform::{Chance, Range, choose as choose_of, shuffle as shuffle_of, shuffle_each};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

/// Whole numbers below 4,096, the same for all; a few are 0.
pub fn weights(n: usize) -> Vec<f32> {
    let mut rng = Pcg32::new(2, 2);
    (0..n).map(|_| (rng.next_u32() >> 20) as f32).collect()
}

/// A contest of indices with the generator alone.
pub fn of_indices() -> Contest<usize> {
    Contest::new(0).draw(FLOOR, |rng| rng.next_u32() as usize)
}

/// Memory that a table borrows until the program ends.
fn memory<T: Clone>(blank: T, n: usize) -> &'static mut [T] {
    vec![blank; n].leak()
}

/// Sums and a search.
pub fn cdf(n: usize) -> Contest<usize> {
    let weights = weights(n);
    let table = Cdf::<&[u32]>::new_in(&weights, memory(0, n)).unwrap();
    let sums = textbook::Sums::new(&weights);
    of_indices()
        .draw(INDEX, move |rng| table.draw_index(rng))
        .draw(SELECTION, move |rng| black_box(table.draw(rng)).index)
        .draw(RAND_DISTR, rejecting::cumulative(&weights))
        .draw(TEXTBOOK, drawn(move |u| sums.index(u)))
}

/// Aliases.
pub fn alias(n: usize) -> Contest<usize> {
    let weights = weights(n);
    let memory = memory(AliasEntry::<u32>::EMPTY, n.next_power_of_two());
    let table = Alias::<&[AliasEntry<u32>]>::new_in(&weights, memory).unwrap();
    of_indices()
        .draw(INDEX, move |rng| table.draw_index(rng))
        .draw(SELECTION, move |rng| black_box(table.draw(rng)).index)
        .draw(RAND_DISTR, rejecting::aliases(&weights))
}

/// Weights of which one changes between two selections: the drawn index gets another one.
pub fn tree(n: usize) -> Contest<usize> {
    let integers: Vec<u32> = weights(n).into_iter().map(|w| w as u32).collect();
    let mut sums = SumTree::new_in(memory(0, n)).unwrap();
    for (index, weight) in integers.iter().enumerate() {
        sums.set(index, *weight).unwrap();
    }
    of_indices()
        .draw(INDEX, move |rng| {
            let index = sums.draw_index(rng).unwrap_or(0);
            let _ = black_box(sums.set(index, 1 + index as u32 % 4095));
            index
        })
        .draw(RAND_DISTR, rejecting::tree(integers))
}

// Contests of integers of a range, coins and orders, beside rand.

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
