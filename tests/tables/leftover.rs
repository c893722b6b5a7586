//! What is left of a uniform after a selection: exact, as many bits as stated, and uniform again.

use host::speed;
use host::stats::{chi_square, threshold};
use microwarp::discrete::{Alias, AliasEntry, Cdf, Selection, select_once};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::collections::BTreeSet;

#[test]
fn the_leftover_is_the_place_among_the_words_of_the_entry() {
    let weights: Vec<f32> = (0..100).map(|i| [0.0, 1.0, 1e-6, 37.0][i % 4]).collect();
    let (mut narrow, mut wide) = (vec![0; 100], vec![0; 100]);
    let narrow = Cdf::<&[u32]>::new_in(&weights, &mut narrow).unwrap();
    let wide = Cdf::<&[u64]>::new_in(&weights, &mut wide).unwrap();
    let mut rng = Pcg32::new(2, 2);
    let close = |chosen: Selection, exact: f64| {
        let error = (f64::from(chosen.leftover) - exact).abs();
        assert!(error <= exact * 1.8e-7, "{chosen:?} {exact}");
        assert!((0.0..1.0).contains(&chosen.leftover));
    };
    for _ in 0..200_000 {
        let word = rng.next_u32();
        let chosen = narrow.select(word);
        let words = narrow.words_of(chosen.index).unwrap();
        assert!(words.contains(&word));
        let count = f64::from(words.end() - words.start()) + 1.0;
        close(chosen, f64::from(word - words.start()) / count);
        assert_eq!(chosen.leftover_bits, count.log2().floor() as u32);

        let word = u64::from(word) << 32 | u64::from(rng.next_u32());
        let chosen = wide.select_word(word);
        let words = wide.words_of(chosen.index).unwrap();
        assert!(words.contains(&word));
        let count = (words.end() - words.start()) as f64 + 1.0;
        close(chosen, (word - words.start()) as f64 / count);
        assert_eq!(chosen.leftover_bits, count.log2().floor() as u32);
        let few = wide.select((word >> 32) as u32);
        assert_eq!(
            few.leftover_bits,
            (count.log2().floor() as u32).saturating_sub(32)
        );
    }
    // What an f32 has below a word counts too.
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
fn p_value(mut draw: impl FnMut(&mut Pcg32) -> (usize, f32), pmf: &[f64], seed: u64) -> f64 {
    const CELLS: usize = 63;
    let n = speed::of("leftovers of each table", 500_000, 5_000_000);
    let mut rng = Pcg32::new(seed, 5);
    let mut observed = vec![0; pmf.len() * CELLS];
    for _ in 0..n {
        let (index, leftover) = draw(&mut rng);
        observed[index * CELLS + (leftover * CELLS as f32) as usize] += 1;
    }
    let expected: Vec<f64> = pmf
        .iter()
        .flat_map(|p| [p * f64::from(n) / CELLS as f64; CELLS])
        .collect();
    chi_square(&observed, &expected).unwrap().2
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
    let pair = |s: Selection| (s.index, s.leftover);
    let all = [
        p_value(|rng| pair(narrow.draw(rng)), &pmf, 1),
        p_value(|rng| pair(wide.draw(rng)), &pmf, 2),
        p_value(|rng| pair(alias.draw(rng)), &pmf, 3),
        p_value(|rng| pair(wide_alias.draw(rng)), &pmf, 4),
        p_value(
            |rng| pair(select_once(&WEIGHTS, rng.next_u32()).unwrap()),
            &pmf,
            5,
        ),
    ];
    println!("p {all:.3?}");
    let least = threshold(all.len());
    assert!(all.iter().all(|p| *p > least), "{all:?}");
    // The uniform itself, used again without rescaling, is rejected.
    let reused = p_value(
        |rng| {
            let word = rng.next_u32();
            (narrow.index(word), microwarp::uniform::grid_from_word(word))
        },
        &pmf,
        6,
    );
    assert!(reused < least);
}
