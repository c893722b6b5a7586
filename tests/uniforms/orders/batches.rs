//! A shuffle by few words: it is that of the definition in long integers, and each order has its share of 64 bits.

use super::{drawn, listed, ordered};
use host::speed;
use microwarp::uniform;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::collections::BTreeSet;

fn shuffled(count: u8, words: u64) -> Vec<u8> {
    let words = [(words >> 32) as u32, words as u32];
    ordered(count, |items| uniform::shuffle(items, &mut listed(&words)))
}

#[test]
fn the_number_of_words_is_that_of_the_page() {
    let page = host::docs::Doc::find("uniform", "shuffle").unwrap().text();
    let rows = [
        (12, "2 to 12", 2),
        (20, "20", 6),
        (52, "52", 16),
        (256, "256", 116),
        (1000, "1,000", 612),
        (65_536, "65,536", 64_938),
    ];
    for (items, name, words) in rows {
        let count = drawn(|rng| uniform::shuffle_with(items, rng, |i, j| assert!(i < j)));
        assert_eq!(count, words, "{items}");
        let row = format!("| {name} | {} |", name_of(words));
        assert!(page.contains(&row), "{row}");
    }
    let words = |items| drawn(|rng| uniform::shuffle_with(items, rng, |_, _| {}));
    assert_eq!([0, 1, 2, 13, 65_537].map(words), [0, 0, 2, 4, 64_940]);
    assert_eq!(drawn(|rng| uniform::shuffle_each(&mut [0; 52], rng)), 51);
    assert_eq!(drawn(|rng| uniform::shuffle_each(&mut [0; 0], rng)), 0);
}

fn name_of(number: usize) -> String {
    match number {
        1000.. => format!("{},{:03}", number / 1000, number % 1000),
        _ => number.to_string(),
    }
}

/// What is wrong about the orders that words give, where each of n! orders should have ⌊2⁶⁴/n!⌋ or ⌈2⁶⁴/n!⌉ neighbouring words.
fn fault(count: u8, order: impl Fn(u64) -> Vec<u8>) -> Option<String> {
    let orders: u128 = (1..=u128::from(count)).product();
    let first = |k: u128| (k << 64).div_ceil(orders);
    let mut seen = BTreeSet::new();
    let mut rng = Pcg32::new(count.into(), 1);
    for k in 0..orders {
        let (from, to) = (first(k) as u64, (first(k + 1) - 1) as u64);
        let found = order(from);
        let between = from + rng.next_u64() % (to - from);
        if [to, between].into_iter().any(|word| order(word) != found) {
            return Some(format!("number {k} is more than one order"));
        }
        if !seen.insert(found) {
            return Some(format!("number {k} is one of those before"));
        }
    }
    None
}

#[test]
fn every_order_has_its_share_of_two_words() {
    for count in 2..=speed::of("items of which all orders are tried", 7, 9) {
        assert_eq!(fault(count, |words| shuffled(count, words)), None);
    }
}

#[test]
fn wrong_digits_of_two_words_are_rejected() {
    type Digit = fn(&mut u64, u64) -> u64;
    // By remainders of the same number, of its quotients with a wrong divisor, and of 24 bits.
    let same: Digit = |words, size| *words % size;
    let wrong: Digit = |words, size| {
        let digit = (u128::from(*words) * u128::from(size)) >> 64;
        *words = words.wrapping_mul(size + 1);
        digit as u64
    };
    let short: Digit = |words, size| {
        let digit = ((*words >> 40) * size) >> 24;
        *words = words.wrapping_mul(size);
        digit
    };
    let right: Digit = |words, size| {
        let product = u128::from(*words) * u128::from(size);
        *words = product as u64;
        (product >> 64) as u64
    };
    let by = |digit: Digit| {
        fault(5, move |mut words| {
            ordered(5, |items| {
                for last in (1..items.len()).rev() {
                    items.swap(digit(&mut words, last as u64 + 1) as usize, last);
                }
            })
        })
    };
    for digit in [same, wrong, short] {
        println!("{}", by(digit).expect("no fault"));
    }
    assert_eq!(by(right), None);
}

/// The definition: of each two words the digits of ⌊words·P/2⁶⁴⌋ by the sizes of as many exchanges as have P ≤ 2³² outcomes.
fn defined(count: usize, rng: &mut impl Rng) -> Vec<u32> {
    let mut items: Vec<u32> = (0..count as u32).collect();
    let mut left = count;
    while left > 1 {
        let words = u128::from(rng.next_u32()) << 32 | u128::from(rng.next_u32());
        let (mut outcomes, mut sizes) = (1, Vec::new());
        while left > 1 && outcomes * left as u128 <= 1 << 32 {
            outcomes *= left as u128;
            sizes.push(left);
            left -= 1;
        }
        let mut rest = (words * outcomes) >> 64;
        for size in sizes {
            outcomes /= size as u128;
            items.swap((rest / outcomes) as usize, size - 1);
            rest %= outcomes;
        }
    }
    items
}

#[test]
fn shuffles_of_any_length_are_those_of_the_definition() {
    for count in [0, 1, 2, 3, 12, 13, 20, 21, 52, 255, 256, 1000, 4097, 65_537] {
        let [mut one, mut other] = [1, 1].map(|stream| Pcg32::new(count as u64, stream));
        let mut items: Vec<u32> = (0..count as u32).collect();
        uniform::shuffle(&mut items, &mut one);
        assert!(items == defined(count, &mut other), "{count} items");
        assert_eq!(one, other, "{count} items");
    }
}
