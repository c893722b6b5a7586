//! What is left of a uniform after a selection, as many bits as stated; and what a draw takes. That leftovers are the place in
//! the share is in `exact` and `select_once`.

use host::generators::{Broken, Counting, Failing};
use microwarp::discrete::{Alias, AliasEntry, Cdf, Reservoir};
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
