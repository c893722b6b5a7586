//! Contests of tables of weights.

use crate::contestants::{FLOOR, INDEX, RAND_DISTR, SELECTION, TEXTBOOK};
use host::contest::Contest;
use host::peers::{drawn, rejecting, textbook};
use microwarp::discrete::{Alias, AliasEntry, Cdf, SumTree};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::hint::black_box;

/// Whole numbers below 4,096, the same for all; a few are 0.
fn weights(n: usize) -> Vec<f32> {
    let mut rng = Pcg32::new(2, 2);
    (0..n).map(|_| (rng.next_u32() >> 20) as f32).collect()
}

/// A contest of indices with the generator alone.
fn of_indices() -> Contest<usize> {
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
