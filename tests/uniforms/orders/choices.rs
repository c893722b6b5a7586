//! The probability of each choice of items that come one by one, exactly.

use super::laws::{Law, bound, deviation, first};
use microwarp::uniform::{ChoiceInOrder, ChoiceOfStream};
use std::collections::{BTreeMap, BTreeSet};

/// The law of the items taken, of n, by how many of the 2³² words take the next one.
fn taken<C: Copy>(
    count: u32,
    choice: C,
    words: &dyn Fn(C) -> u64,
    next: &dyn Fn(C, bool) -> C,
) -> Law<Vec<u32>> {
    let mut law = BTreeMap::from([((Vec::new()), (1.0, choice))]);
    for item in 0..count {
        let mut longer = BTreeMap::new();
        for (items, (p, choice)) in law {
            let share = words(choice) as f64 * 2.0_f64.powi(-32);
            if share > 0.0 {
                let with = [items.clone(), vec![item]].concat();
                longer.insert(with, (p * share, next(choice, true)));
            }
            if share < 1.0 {
                longer.insert(items, (p * (1.0 - share), next(choice, false)));
            }
        }
        law = longer;
    }
    law.into_iter().map(|(items, (p, _))| (items, p)).collect()
}

/// How many of all words are below the first one that does not have a property.
fn prefix(has: impl Fn(u32) -> bool) -> u64 {
    let (mut from, mut to) = (0_u64, 1 << 32);
    while from < to {
        let middle = (from + to) / 2;
        (from, to) = if has(middle as u32) {
            (middle + 1, to)
        } else {
            (from, middle)
        };
    }
    from
}

fn binomial(n: u32, k: u32) -> usize {
    (0..k).fold(1, |all, i| all * (n - i) as usize / (i + 1) as usize)
}

#[test]
fn every_choice_in_order_is_equally_likely() {
    let words = |choice: ChoiceInOrder| prefix(|word| choice.clone().take(word));
    let next = |mut choice: ChoiceInOrder, taken| {
        assert_eq!(choice.take(if taken { 0 } else { u32::MAX }), taken);
        choice
    };
    for count in 0..=8 {
        for chosen in 0..=count {
            let choice = ChoiceInOrder::new(chosen, count).unwrap();
            let law = taken(count, choice, &words, &next);
            let off = deviation(&law, binomial(count, chosen));
            assert!(off <= bound(count as u8), "{chosen} of {count}: {off:e}");
            assert!(law.keys().all(|items| items.len() == chosen as usize));
            // Behind the last, none is.
            let none = taken(count + 2, choice, &words, &next);
            assert!(none == law);
        }
    }
    // An equal chance for all, by a coin each; and the right chances in 24 bits.
    let coins = taken(5, (), &|()| (2 << 32) / 5, &|(), _| ());
    assert!(coins.len() > binomial(5, 2));
    let next = |(wanted, left): (u64, u64), taken| (wanted - u64::from(taken), left - 1);
    let by = |bits: u32| {
        let words = move |(wanted, left)| {
            if left == 0 {
                0
            } else {
                first(wanted, left, bits)
            }
        };
        deviation(&taken(7, (3, 7), &words, &next), 35)
    };
    println!("24 and 32 bits: {:e}, {:e}", by(24), by(32));
    assert!(by(24) > 10.0 * bound(7) && by(32) <= bound(7));
}

/// The law of what an array of k holds behind n items.
fn held(places: u32, count: u32, take: impl Fn(u32, u32) -> Option<u32>) -> Law<Vec<u32>> {
    let mut law = BTreeMap::from([(vec![u32::MAX; places as usize], 1.0)]);
    for item in 0..count {
        let mut next = BTreeMap::new();
        let below = |place| prefix(|word| take(item, word).is_some_and(|found| found < place));
        for (array, p) in law {
            for place in 0..places {
                let words = below(place + 1) - below(place);
                let mut array = array.clone();
                array[place as usize] = item;
                *next.entry(array).or_default() += p * words as f64 * 2.0_f64.powi(-32);
            }
            *next.entry(array).or_default() += p * (1.0 - below(places) as f64 * 2.0_f64.powi(-32));
        }
        next.retain(|_, p| *p > 0.0);
        law = next;
    }
    law
}

/// The same law of what is held, whatever the order.
fn sets(law: &Law<Vec<u32>>) -> Law<BTreeSet<u32>> {
    let mut sets = BTreeMap::new();
    for (array, p) in law {
        *sets.entry(array.iter().copied().collect()).or_default() += p;
    }
    sets
}

#[test]
fn every_choice_of_a_stream_is_equally_likely_and_its_order_is_not_random() {
    for (places, count) in [(1, 5), (2, 6), (3, 7), (5, 5)] {
        let behind = |seen: u32| {
            let mut choice = ChoiceOfStream::new(places).unwrap();
            (0..seen).for_each(|_| {
                choice.take(7);
            });
            choice
        };
        let law = held(places, count, |seen, word| behind(seen).take(word));
        let off = deviation(&sets(&law), binomial(count, places));
        let bound = f64::from(count * count) * 2.0_f64.powi(-32);
        assert!(off <= bound, "{places} of {count}: {off:e}");
        for item in 0..count {
            let holds = law.iter().filter(|(array, _)| array.contains(&item));
            let p: f64 = holds.map(|(_, p)| p).sum();
            let due = f64::from(places) / f64::from(count);
            let bound = f64::from(count) * 2.0_f64.powi(-31);
            assert!(
                (p - due).abs() <= bound * due,
                "{places} of {count}: {item} {p}"
            );
        }
        assert!(law.keys().all(|array| !array[1..].contains(&0)));
    }
    // One place too many, one too few, and a coin.
    type Take = fn(u32, u64) -> u64;
    let wrong: [Take; 3] = [
        |seen, word| (word * u64::from(seen + 2)) >> 32,
        |seen, word| (word * u64::from(seen)) >> 32,
        |_, word| (word * 6) >> 32,
    ];
    for take in wrong {
        let law = held(3, 7, |seen, word| {
            let place = if seen < 3 {
                seen
            } else {
                take(seen, word.into()) as u32
            };
            (place < 3).then_some(place)
        });
        assert!(deviation(&sets(&law), 35) > 0.1);
    }
}
