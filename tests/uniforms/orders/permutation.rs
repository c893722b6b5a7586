//! Permutations: each number stands at one place, and is found there; over seeds orders are random.

use host::{speed, stats};
use microwarp::Error;
use microwarp::uniform::Permutation;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::collections::BTreeMap;

fn of(count: u32, seed: u32) -> Permutation {
    Permutation::new(count, seed).unwrap()
}

fn every_number_once(count: u32, seed: u32) {
    let order = of(count, seed);
    let mut seen = vec![false; count as usize];
    for place in 0..count {
        let number = order.get(place).unwrap();
        let again = std::mem::replace(&mut seen[number as usize], true);
        assert!(!again, "{number} of {count}");
        assert_eq!(order.index_of(number), Some(place), "{number} of {count}");
    }
    assert_eq!([order.get(count), order.index_of(count)], [None; 2]);
    assert_eq!([order.get(u32::MAX), order.index_of(u32::MAX)], [None; 2]);
}

#[test]
fn every_number_stands_at_one_place_and_is_found_there() {
    let seeds = speed::of("seeds of each permutation", 2, 16);
    for count in 1..400 {
        (0..seeds).for_each(|seed| every_number_once(count, seed));
    }
    for count in [1000, 1023, 1024, 1025, 4097, 65_536, 65_537, 99_991] {
        every_number_once(count, 7);
    }
}

#[test]
fn numbers_of_many_are_found() {
    let mut rng = Pcg32::new(5, 1);
    for count in [
        1 << 20,
        1_000_003,
        1 << 31,
        (1 << 31) + 1,
        4_000_000_000,
        u32::MAX,
    ] {
        let order = of(count, 9);
        let ends = [0, 1, count / 2, count - 1];
        let random = (0..2000).map(|_| rng.next_u32() % count);
        for place in random.chain(ends) {
            let number = order.get(place).unwrap();
            assert!(number < count);
            assert_eq!(order.index_of(number), Some(place));
        }
        assert_eq!([order.get(count), order.index_of(count)], [None; 2]);
    }
    assert_eq!(Permutation::new(0, 1), Err(Error::Empty(0)));
    const ORDER: Permutation = microwarp::constant!(Permutation::new(1000, 3));
    assert_eq!((ORDER, ORDER.count()), (of(1000, 3), 1000));
}

#[test]
fn few_numbers_are_shuffled() {
    let orders = |count: u32, at: &dyn Fn(u32, u32) -> u32| {
        let seeds = speed::of("seeds of few numbers", 120_000, 2_000_000);
        let mut counts = BTreeMap::new();
        for seed in 0..seeds {
            let order: Vec<u32> = (0..count).map(|place| at(seed, place)).collect();
            *counts.entry(order).or_insert(0_u64) += 1;
        }
        let all = (1..=count as usize).product();
        let mut counts: Vec<u64> = counts.into_values().collect();
        counts.resize(all, 0);
        let expected = vec![f64::from(seeds) / all as f64; all];
        stats::chi_square(&counts, &expected).map_or(f64::NAN, |found| found.2)
    };
    let threshold = stats::threshold(6);
    let p: Vec<_> = (2..=7)
        .map(|n| orders(n, &|seed, place| of(n, seed).get(place).unwrap()))
        .collect();
    stats::assert_passes("orders of 2 to 7", &p, threshold);
    // By rounds in place of exchanges, as many as make each number even.
    let rounds = orders(4, &|seed, place| textbook(4, seed, 4, place));
    stats::assert_rejected("orders of 4 by four rounds", &[rounds], threshold);
}

/// The crate's hash of a number under a key.
fn keyed(key: u32, number: u32) -> u32 {
    let golden = ((1_u64 << 32) as f64 * 0.618_033_988_749_894_9) as u32;
    let mut x = key.wrapping_add(golden.wrapping_mul(number.wrapping_add(1)));
    for (shift, factor) in [(16, 0x7feb_352d_u32), (15, 0x846c_a68b)] {
        x = (x ^ x >> shift).wrapping_mul(factor);
    }
    x ^ x >> 16
}

/// The definition, by so many rounds.
fn textbook(count: u32, seed: u32, rounds: u32, place: u32) -> u32 {
    let bits = 64 - u64::from(count - 1).leading_zeros();
    let (key, size) = (keyed(seed, 0), 1_u64 << bits);
    let mut at = u64::from(place);
    loop {
        for round in 0..rounds {
            let add = keyed(key, 2 * round);
            let multiply = keyed(key, 2 * round + 1) | 1;
            at = (at + u64::from(add)) % size * u64::from(multiply) % size;
            at ^= at >> bits.div_ceil(2);
        }
        if at < u64::from(count) {
            return at as u32;
        }
    }
}

#[test]
fn places_are_those_of_the_definition() {
    for count in [
        17,
        31,
        32,
        33,
        52,
        64,
        1000,
        1025,
        65_537,
        1 << 31,
        u32::MAX,
    ] {
        for seed in 0..50 {
            let place = keyed(seed, count) % count;
            assert_eq!(
                of(count, seed).get(place),
                Some(textbook(count, seed, 8, place))
            );
        }
    }
}

type Places<'a> = &'a dyn Fn(u32, [u32; 3]) -> [u32; 3];

/// p-values over seeds: of the differences and the differing bits of the numbers at pairs of places, of the number at a
/// place, and of pairs of triples' numbers.
fn p_values(count: u32, at: Places) -> Vec<f64> {
    let seeds = speed::of("seeds of pairs of places", 100_000, 1_000_000);
    let half = count / 2;
    let triples = [
        [0, 1, 2],
        [0, half, count - 1],
        [1, 3, half + 1],
        [5, 5 ^ 8, 7],
    ];
    let mut found = Vec::new();
    for places in triples {
        let bits = 32 - (count - 1).leading_zeros();
        let mut differences = vec![0; count as usize];
        let (mut changes, mut numbers) = (vec![0; 1 << bits], vec![0; count as usize]);
        for seed in 0..seeds {
            let [a, b, c] = at(seed, places);
            differences[((a + count - b) % count) as usize] += 1;
            changes[(a ^ b) as usize] += 1;
            changes[(b ^ c) as usize] += 1;
            numbers[c as usize] += 1;
        }
        let all = f64::from(seeds);
        let equal = |k: u32| {
            if k == 0 {
                0.0
            } else {
                all / f64::from(count - 1)
            }
        };
        let expected: Vec<_> = (0..count).map(equal).collect();
        // Ordered pairs that differ in these bits.
        let pairs = |change: u32| {
            (0..count)
                .filter(|a| a ^ change < count && change > 0)
                .count() as f64
        };
        let of_pair = 2.0 * all / (f64::from(count) * f64::from(count - 1));
        let changed: Vec<_> = (0..1 << bits)
            .map(|change| of_pair * pairs(change))
            .collect();
        let even = vec![all / f64::from(count); count as usize];
        for (observed, expected) in [
            (&differences, &expected),
            (&changes, &changed),
            (&numbers, &even),
        ] {
            found.push(stats::chi_square(observed, expected).map_or(f64::NAN, |found| found.2));
        }
    }
    found
}

#[test]
fn pairs_of_places_are_random_and_those_of_fewer_rounds_are_not() {
    let counts = [17, 31, 64, 100];
    let threshold = stats::threshold(12 * counts.len());
    for count in counts {
        let p = p_values(count, &|seed, places| {
            let order = of(count, seed);
            places.map(|place| order.get(place).unwrap())
        });
        stats::assert_passes(&format!("{count} numbers"), &p, threshold);
    }
    let six = p_values(64, &|seed, places| {
        places.map(|place| textbook(64, seed, 6, place))
    });
    stats::assert_rejected("six rounds", &six, threshold);
}

/// The p-value over seeds of the difference of the numbers at one place under a seed and another.
#[test]
fn orders_of_neighbouring_seeds_are_independent() {
    let count = 101;
    let differences = |other: fn(u32) -> u32| {
        let seeds = 100_000;
        let mut differences = vec![0; count as usize];
        for seed in 0..seeds {
            let [a, b] = [seed, other(seed)].map(|seed| of(count, seed).get(7).unwrap());
            differences[((a + count - b) % count) as usize] += 1;
        }
        let expected = vec![f64::from(seeds) / f64::from(count); count as usize];
        stats::chi_square(&differences, &expected).map_or(f64::NAN, |found| found.2)
    };
    // The last is a step of the hash's counter.
    let others: [fn(u32) -> u32; 3] = [
        |seed| seed + 1,
        |seed| seed ^ 1 << 31,
        |seed| seed.wrapping_add(0x9e37_79b9),
    ];
    let threshold = stats::threshold(3);
    stats::assert_passes("neighbouring seeds", &others.map(differences), threshold);
    stats::assert_rejected("equal seeds", &[differences(|seed| seed)], threshold);
}
