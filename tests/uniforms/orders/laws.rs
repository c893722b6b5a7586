//! The probability of each order, exactly: from the numbers of words that lead there.

use super::{drawn, listed, ordered};
use host::{speed, stats};
use microwarp::Error;
use microwarp::uniform::{self, ChoiceInOrder, ChoiceOfStream, FromFn};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::collections::BTreeMap;

pub type Law<R> = BTreeMap<R, f64>;

/// The first of the words of outcome k of so many, where words have so many digits.
pub fn first(k: u64, size: u64, bits: u32) -> u64 {
    (k << bits).div_ceil(size) << (32 - bits)
}

/// The law of what words do, one of each size. All words of an outcome do the same, by the first and the last of them.
fn law<R: Ord>(sizes: &[u64], bits: u32, run: impl Fn(&[u32]) -> R) -> Law<R> {
    let mut law = BTreeMap::new();
    for number in 0..sizes.iter().product() {
        let (mut rest, mut probability) = (number, 1.0);
        let mut ends = [Vec::new(), Vec::new()];
        for &size in sizes {
            let [from, to] = [0, 1].map(|more| first(rest % size + more, size, bits));
            ends[0].push(from as u32);
            ends[1].push((to - 1) as u32);
            probability *= (to - from) as f64 * 2.0_f64.powi(-32);
            rest /= size;
        }
        let [result, last] = ends.map(|words| run(&words));
        assert!(result == last, "outcome {number} is more than one");
        *law.entry(result).or_default() += probability;
    }
    law
}

/// How far a law is from that of so many equally likely results, relatively.
pub fn deviation<R>(law: &Law<R>, results: usize) -> f64 {
    assert!(law.len() <= results);
    let missing = if law.len() < results { 1.0 } else { 0.0 };
    let off = law.values().map(|p| (p * results as f64 - 1.0).abs());
    off.fold(missing, f64::max)
}

pub fn bound(count: u8) -> f64 {
    f64::from(count) * f64::from(count + 1) * 2.0_f64.powi(-33)
}

fn factorial(count: u8) -> usize {
    (1..=usize::from(count)).product()
}

/// Exchanges each place with one that a word chooses among so many from a place on.
fn exchanged(count: u8, words: &[u32], bits: u32, from: fn(usize) -> usize) -> Vec<u8> {
    ordered(count, |items| {
        for (place, word) in words.iter().enumerate() {
            let size = (items.len() - from(place)) as u64;
            let step = (u64::from(word >> (32 - bits)) * size) >> bits;
            items.swap(place, from(place) + step as usize);
        }
    })
}

#[test]
fn every_order_is_equally_likely() {
    for count in 2..=speed::of("items of which all orders are counted", 6, 8) {
        let sizes: Vec<u64> = (2..=count.into()).rev().collect();
        let shuffled = |words: &[u32]| {
            ordered(count, |items| {
                uniform::shuffle_each(items, &mut listed(words))
            })
        };
        let off = deviation(&law(&sizes, 32, shuffled), factorial(count));
        println!("{count} items: {off:e}");
        assert!(off <= bound(count));
    }
    // Over the whole array; by the first 24 bits of a word; and what is right by them all.
    let whole = law(&[5; 5], 32, |words| exchanged(5, words, 32, |_| 0));
    let short = law(&[5, 4, 3, 2], 24, |words| exchanged(5, words, 24, |i| i));
    let right = law(&[5, 4, 3, 2], 32, |words| exchanged(5, words, 32, |i| i));
    let offs = [&whole, &short, &right].map(|law| deviation(law, 120));
    println!("whole array, 24 bits, right: {offs:?}");
    assert!(offs[0] > 0.5 && offs[1] > 10.0 * bound(5));
    assert!(offs[2] <= bound(5));
}

#[test]
fn every_choice_in_every_order_is_equally_likely() {
    for (chosen, count) in [(0, 5), (1, 7), (2, 7), (3, 6), (5, 5)] {
        let chosen_of = |words: &[u32]| {
            let mut items: Vec<u8> = (0..count).collect();
            let mut rng = listed(words);
            let (some, others) = uniform::choose(&mut items, chosen, &mut rng).unwrap();
            assert_eq!(some.len() + others.len(), usize::from(count));
            let (some, mut all) = (some.to_vec(), items);
            all.sort();
            assert!(all.into_iter().eq(0..count));
            some
        };
        let sizes: Vec<u64> = (0..chosen as u64).map(|i| u64::from(count) - i).collect();
        let results = sizes.iter().product::<u64>() as usize;
        let off = deviation(&law(&sizes, 32, chosen_of), results);
        let bound = chosen as f64 * f64::from(count) * 2.0_f64.powi(-32);
        assert!(off <= bound, "{chosen} of {count}: {off:e}");
    }
}

#[test]
fn what_is_refused_changes_nothing() {
    let mut items = [3, 1, 2];
    let mut refused = None;
    let words = drawn(|rng| refused = uniform::choose(&mut items, 4, rng).err());
    assert_eq!(
        (refused, words, items),
        (Some(Error::OutOfRange(1)), 0, [3, 1, 2])
    );
    assert_eq!(ChoiceInOrder::new(4, 3), Err(Error::OutOfRange(1)));
    assert_eq!(ChoiceOfStream::new(0), Err(Error::Empty(0)));
    // A generator that fails says so, and a choice has not seen the item.
    let mut failing = FromFn(|| Err::<u32, _>(std::fmt::Error));
    let mut choices = (
        ChoiceInOrder::new(2, 3).unwrap(),
        ChoiceOfStream::new(2).unwrap(),
    );
    let before = choices;
    assert!(choices.0.try_draw(&mut failing).is_err() && choices.1.try_draw(&mut failing).is_err());
    assert_eq!(choices, before);
    assert!(uniform::try_shuffle(&mut items, &mut failing).is_err());
    assert!(uniform::try_shuffle_each(&mut items, &mut failing).is_err());
    assert!(uniform::try_choose(&mut items, 1, &mut failing).is_err());
    assert_eq!(items, [3, 1, 2]);
    // Neither the ends of numbers nor words matter.
    let mut all = ChoiceOfStream::new(u32::MAX).unwrap();
    assert_eq!(all.take(u32::MAX), Some(0));
    let mut all = ChoiceInOrder::new(u32::MAX, u32::MAX).unwrap();
    assert!(all.take(u32::MAX) && all.take(0));
}

/// The p-value of equal numbers of all orders of 5 items.
fn p_value(mut shuffle: impl FnMut(&mut [u8])) -> f64 {
    let mut counts = BTreeMap::new();
    let runs = speed::of("shuffles of 5 items", 60_000, 1_200_000);
    for _ in 0..runs {
        *counts.entry(ordered(5, &mut shuffle)).or_insert(0) += 1;
    }
    let mut counts: Vec<u64> = counts.into_values().collect();
    counts.resize(120, 0);
    let found = stats::chi_square(&counts, &[f64::from(runs) / 120.0; 120]);
    found.map_or(f64::NAN, |found| found.2)
}

#[test]
fn orders_of_a_generator_are_equally_frequent() {
    let rng = || Pcg32::new(33, 2);
    let (mut few, mut each, mut chosen) = (rng(), rng(), rng());
    let threshold = stats::threshold(3);
    let p = [
        p_value(|items| uniform::shuffle(items, &mut few)),
        p_value(|items| uniform::shuffle_each(items, &mut each)),
        p_value(|items| assert!(uniform::choose(items, 5, &mut chosen).is_ok())),
    ];
    stats::assert_passes("shuffle, shuffle_each, choose", &p, threshold);
    // Over the whole array, and by remainders of a generator whose low bits hardly change.
    let mut words = rng();
    let whole = p_value(|items| {
        (0..5).for_each(|i| items.swap(i, ((u64::from(words.next_u32()) * 5) >> 32) as usize));
    });
    let mut state = 1_u32;
    let remainders = p_value(|items| {
        for last in (1..5).rev() {
            state = state.wrapping_mul(1_103_515_245).wrapping_add(12_345);
            items.swap(last, state as usize % (last + 1));
        }
    });
    stats::assert_rejected("the whole array", &[whole], threshold);
    stats::assert_rejected("remainders", &[remainders], threshold);
}
