//! What is left of a uniform after a selection: exact, as many bits as stated, and uniform again.

use host::generators::{Broken, Counting, Failing};
use host::speed;
use host::stats::threshold;
use microwarp::discrete::{
    Alias, AliasEntry, Cdf, ExactSelection, Reservoir, Selection, select_once,
};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::collections::BTreeSet;

/// What an f32 has below a word counts too.
#[test]
fn the_whole_of_a_uniform_is_left_of_a_single_entry() {
    let single = Cdf::new(&[1.0, 0.0]).unwrap();
    for u in [1e-12_f32, 3.3e-20, 1e-45, 0.25, 0.999_999_94] {
        assert_eq!(single.select_uniform(u).leftover, u);
    }
}

#[test]
fn as_many_values_as_bits_are_stated() {
    // Entries of 2^12 words each, and of fewer.
    let weights = vec![1.0; 1 << 20];
    let mut memory = vec![0; 1 << 20];
    let table = Cdf::<&[u32]>::new_in(&weights, &mut memory).unwrap();
    let words = table.words_of(777).unwrap();
    let values: BTreeSet<u32> = words.map(|w| table.select(w).leftover.to_bits()).collect();
    assert_eq!(table.select(777 << 12).leftover_bits, 12);
    assert_eq!(values.len(), 1 << 12);
    let mut memory = vec![AliasEntry::<u32>::EMPTY; 1 << 20];
    let table = Alias::<&[AliasEntry<u32>]>::new_in(&weights, &mut memory).unwrap();
    assert_eq!(table.select(777 << 12).leftover_bits, 12);
}

/// The p-value of leftovers, entry by entry, against the uniform law.
fn p_value(draw: impl Fn(&mut Pcg32) -> (usize, f64), pmf: &[f64], seed: u64) -> f64 {
    const CELLS: usize = 63;
    let n = speed::of("leftovers of each table", 400_000, 5_000_000);
    let cells: Vec<f64> = pmf.iter().flat_map(|p| [p / CELLS as f64; CELLS]).collect();
    let found = crate::cases::p_value(&cells, n, seed, |rng| {
        let (index, leftover) = draw(rng);
        index * CELLS + (leftover * CELLS as f64) as usize
    });
    found.unwrap()
}

#[test]
fn leftovers_are_uniform_and_tell_nothing_of_the_index() {
    const WEIGHTS: [f32; 7] = [1.0, 0.0, 4.0, 0.3, 2.2, 0.0, 0.9];
    let total: f64 = WEIGHTS.iter().map(|&w| f64::from(w)).sum();
    let pmf = WEIGHTS.map(|w| f64::from(w) / total);
    let narrow = Cdf::new(&WEIGHTS).unwrap();
    let wide = Cdf::new_u64(&WEIGHTS).unwrap();
    let alias = Alias::<[AliasEntry<u32>; 8]>::new(&WEIGHTS).unwrap();
    let wide_alias = Alias::<[AliasEntry<u64>; 16]>::new_u64(&WEIGHTS).unwrap();
    let exact = WEIGHTS.map(|w| (10.0 * w) as u32);
    let exact_narrow = Cdf::from_integers(&exact).unwrap();
    let exact_wide = Cdf::from_integers_u64(&exact).unwrap();
    let exact_alias = Alias::<[AliasEntry<u32>; 8]>::from_integers(&exact).unwrap();
    let pair = |s: Selection| (s.index, f64::from(s.leftover));
    fn exactly<C>(s: ExactSelection<C>) -> (usize, f64) {
        (s.index, f64::from(s.leftover) / 2_f64.powi(32))
    }
    let p_value = |seed, draw: &dyn Fn(&mut Pcg32) -> (usize, f64)| p_value(draw, &pmf, seed);
    let all = [
        p_value(1, &|rng| pair(narrow.draw(rng))),
        p_value(2, &|rng| pair(wide.draw(rng))),
        p_value(3, &|rng| pair(alias.draw(rng))),
        p_value(4, &|rng| pair(wide_alias.draw(rng))),
        p_value(5, &|rng| {
            pair(select_once(&WEIGHTS, rng.next_u32()).unwrap())
        }),
        p_value(6, &|rng| exactly(exact_narrow.draw_exact(rng))),
        p_value(7, &|rng| exactly(exact_wide.draw_exact(rng))),
        p_value(8, &|rng| exactly(exact_alias.draw_exact(rng))),
    ];
    println!("p {all:.3?}");
    let least = threshold(all.len());
    assert!(all.iter().all(|p| *p > least), "{all:?}");
    // The word itself, used again as it is, is rejected; and so is the place without its share's size.
    let reused = |rng: &mut Pcg32| {
        let word = rng.next_u32();
        (narrow.index(word), f64::from(word) / 2_f64.powi(32))
    };
    let place = |rng: &mut Pcg32| {
        let word = rng.next_u32();
        let index = narrow.index(word);
        let words = narrow.words_of(index).unwrap();
        (index, f64::from(word - words.start()) / 2_f64.powi(32))
    };
    assert!(p_value(9, &reused) < least && p_value(10, &place) < least);
}

// What a draw takes from a generator, and that it is what the words select.

#[test]
fn a_draw_takes_the_stated_words_and_passes_a_failure_on() {
    fn driver(left: u64) -> Counting<Failing> {
        Counting::new(Failing {
            word: 0x9234_5678,
            left,
        })
    }
    fn takes<T>(words: u64, draw: impl Fn(&mut Counting<Failing>) -> Result<T, Broken>) {
        let mut rng = driver(9);
        assert!(draw(&mut rng).is_ok());
        assert_eq!(rng.words, words);
        for left in 0..words {
            assert!(draw(&mut driver(left)).is_err());
        }
    }
    const WEIGHTS: [f32; 4] = [1.0, 2.0, 0.0, 4.0];
    let narrow = Cdf::new(&WEIGHTS).unwrap();
    let wide = Cdf::new_u64(&WEIGHTS).unwrap();
    let alias = Alias::<[AliasEntry<u32>; 4]>::new(&WEIGHTS).unwrap();
    let wide_alias = Alias::<[AliasEntry<u64>; 4]>::new_u64(&WEIGHTS).unwrap();
    takes(1, |rng| narrow.try_draw(rng));
    takes(2, |rng| wide.try_draw(rng));
    takes(1, |rng| alias.try_draw(rng));
    takes(1, |rng| narrow.try_draw_index(rng));
    takes(2, |rng| wide_alias.try_draw_index(rng));
    takes(2, |rng| wide_alias.try_draw(rng));
    takes(2, |rng| Reservoir::new().try_offer(1, 0.0, rng));
    takes(2, |rng| {
        Reservoir::<u8>::new().try_merge(Reservoir::new(), rng)
    });
    // What is drawn is what the words select, of which every one is counted; the leading word comes first.
    let (mut rng, mut words) = (Pcg32::new(4, 4), Pcg32::new(4, 4));
    for _ in 0..1000 {
        let word = words.next_u32();
        assert_eq!(narrow.draw(&mut rng), narrow.select(word));
        let word = words.next_u32();
        assert_eq!(alias.draw(&mut rng), alias.select(word));
        let word = u64::from(words.next_u32()) << 32 | u64::from(words.next_u32());
        assert_eq!(wide.draw(&mut rng), wide.select_word(word));
        let word = u64::from(words.next_u32()) << 32 | u64::from(words.next_u32());
        assert_eq!(wide_alias.draw(&mut rng), wide_alias.select_word(word));
        // The index alone is that of the selection.
        let word = words.next_u32();
        assert_eq!(narrow.draw_index(&mut rng), narrow.index(word));
        let word = u64::from(words.next_u32()) << 32 | u64::from(words.next_u32());
        assert_eq!(wide_alias.draw_index(&mut rng), wide_alias.index(word));
    }
    assert_eq!(rng, words);
}
