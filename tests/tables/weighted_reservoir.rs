//! `WeightedReservoir`: the words of a second item counted against the exponential race, then streams, orders and mergers.

use host::generators::{Broken, Counting, Failing};
use host::speed;
use host::stats::threshold;
use microwarp::discrete::WeightedReservoir;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// How many words of a second item displace the first, of given weights and a given word.
fn displacing([a, b]: [u32; 2], word: u32) -> u64 {
    let takes = |other: u32| {
        let mut reservoir = WeightedReservoir::<_, 1>::new();
        assert!(reservoir.offer_with('a', a, word));
        reservoir.offer_with('b', b, other)
    };
    // Later words are earlier times.
    let (mut from, mut to) = (0, 1_u64 << 32);
    while from < to {
        let middle = (from + to) / 2;
        if takes(middle as u32) {
            to = middle;
        } else {
            from = middle + 1;
        }
    }
    (1 << 32) - from
}

/// By how much the share of displacing words is off 1 − u^(b/a), in units of it and of half a word.
fn off(weights: [u32; 2], word: u32, displacing: u64) -> f64 {
    let left = (2.0 * f64::from(!word) + 1.0) / 8_589_934_592.0;
    let ratio = f64::from(weights[1]) / f64::from(weights[0]);
    let due = -(ratio * (-left).ln_1p()).exp_m1() * 4_294_967_296.0;
    (displacing as f64 - due).abs() / (0.5 + 4e-8 * due)
}

const PAIRS: [[u32; 2]; 9] = [
    [1, 1],
    [1, 2],
    [3, 1],
    [1, 1000],
    [1000, 1],
    [u32::MAX, 1],
    [1, u32::MAX],
    [u32::MAX, u32::MAX - 1],
    [123_456_789, 987_654_321],
];

#[test]
fn a_second_item_takes_the_place_with_the_words_of_the_race() {
    let mut rng = Pcg32::new(1, 34);
    let (mut worst, mut counted) = (0.0_f64, 0);
    for weights in PAIRS {
        let some = (0..speed::of("words of a first item", 3000, 100_000)).map(|_| rng.next_u32());
        let ends = (0..100).flat_map(|i| [i, u32::MAX - i, (1 << 31) + i, (1 << 31) - i]);
        for word in some.chain(ends) {
            let off = off(weights, word, displacing(weights, word));
            assert!(off <= 1.01, "{weights:?} {word:x}: {off}");
            worst = worst.max(off);
            counted += 1;
        }
    }
    println!("{counted} words, at most {worst:.3} of what is allowed");
    // Times that are uniform, not exponential, are off.
    let word = 0x8000_0000;
    let uniform = u64::from(!word).wrapping_mul(2);
    assert!(off([1, 2], word, uniform) > 1e3);
}

const WEIGHTS: [u32; 5] = [1, 0, 2, 3, 4];

/// The p-value of pairs that are held, in their order, against draws from an urn.
fn p_value(seed: u64, mut pair: impl FnMut(&mut Pcg32) -> [usize; 2]) -> Result<f64, String> {
    let total: u32 = WEIGHTS.iter().sum();
    let chance = |a: usize, b: usize| {
        let [first, second] = [a, b].map(|i| f64::from(WEIGHTS[i]));
        let left = f64::from(total) - first;
        if a == b {
            0.0
        } else {
            first / f64::from(total) * second / left
        }
    };
    let cells: Vec<f64> = (0..25).map(|cell| chance(cell / 5, cell % 5)).collect();
    let runs = speed::of("pairs of a stream", 100_000, 2_000_000);
    crate::cases::p_value(&cells, runs, seed, |rng| {
        let [a, b] = pair(rng);
        5 * a + b
    })
}

fn held<const K: usize>(reservoir: &WeightedReservoir<usize, K>) -> Vec<usize> {
    reservoir.items().copied().collect()
}

#[test]
fn pairs_follow_draws_from_an_urn_in_their_order() {
    let stream = |rng: &mut Pcg32, word: fn(u32, u32) -> (u32, u32)| {
        let mut reservoir = WeightedReservoir::<_, 2>::new();
        for (item, weight) in WEIGHTS.into_iter().enumerate() {
            let (weight, word) = word(weight, rng.next_u32());
            reservoir.offer_with(item, weight, word);
        }
        let [a, b] = held(&reservoir)[..] else {
            panic!()
        };
        [a, b]
    };
    let right = p_value(1, |rng| stream(rng, |weight, word| (weight, word))).unwrap();
    println!("p: {right:.3}");
    assert!(right > threshold(1));
    // Words that a weight multiplies are not its power: the largest of u·w.
    let wrong = p_value(2, |rng| {
        let mut keys: Vec<_> = WEIGHTS
            .iter()
            .enumerate()
            .map(|(item, &weight)| (u64::from(rng.next_u32()) * u64::from(weight), item))
            .collect();
        keys.sort_unstable();
        [keys[4].1, keys[3].1]
    });
    assert!(wrong.unwrap() < threshold(1));
}

#[test]
fn parts_of_a_stream_merge_to_what_the_whole_holds() {
    let mut rng = Pcg32::new(3, 34);
    for n in 0..40 {
        let offers: Vec<[u32; 2]> = (0..n)
            .map(|_| [rng.next_u32() >> (rng.next_u32() & 31), rng.next_u32()])
            .collect();
        let part = |range: std::ops::Range<usize>| {
            let mut reservoir = WeightedReservoir::<_, 5>::default();
            for i in range {
                let [weight, word] = offers[i];
                reservoir.offer_with(i, weight, word);
            }
            reservoir
        };
        let whole = part(0..n);
        let (mut first, second) = (part(0..n / 3), part(n / 3..n));
        first.merge(second);
        assert_eq!(first, whole);
        // The last that is held is the first that a smaller one drops.
        let mut smaller = WeightedReservoir::<_, 4>::new();
        for (i, &[weight, word]) in offers.iter().enumerate() {
            smaller.offer_with(i, weight, word);
        }
        let held = held(&whole);
        assert!(smaller.items().eq(held.iter().take(4)));
        let positive = offers.iter().filter(|offer| offer[0] > 0).count();
        assert_eq!(held.len(), positive.min(5));
    }
}

#[test]
fn an_item_takes_one_word_and_a_weight_of_zero_is_never_held() {
    let mut rng = Counting::new(Pcg32::new(1, 1));
    let mut reservoir = WeightedReservoir::<_, 3>::new();
    for item in 0..10 {
        assert!(!reservoir.offer(item, 0, &mut rng));
    }
    assert!(reservoir.offer(10, 1, &mut rng));
    assert_eq!((rng.words, held(&reservoir)), (11, vec![10]));
    assert!(!WeightedReservoir::<_, 0>::new().offer(1, 1, &mut rng));
    let before = reservoir;
    let mut failing = Failing { word: 7, left: 0 };
    assert!(matches!(
        reservoir.try_offer(11, 1, &mut failing),
        Err(Broken(_))
    ));
    assert_eq!(reservoir, before);
}
