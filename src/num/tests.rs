//! Integers up to a last one: both kinds of cores give the same, and each integer gets the words that are its share. Square
//! roots are those of real numbers.
#![allow(
    clippy::arithmetic_side_effects,
    clippy::cast_lossless,
    clippy::cast_possible_wrap,
    clippy::indexing_slicing,
    clippy::integer_division_remainder_used,
    reason = "tests run where there are panics"
)]

use super::division::{Divisor, fraction_on, quotient_on, scaled_on};
use super::word::up_to_on;
use super::{
    Scaled, float, folded, folded_tail, inverse_square_root, square_root, up_to, up_to_by_two,
};
use host::errors::ulps;
use host::speed;
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::vec;
use std::vec::Vec;

/// The integer by products of 128 bits, of a fraction of 64.
fn exact(last: u32, high: u32, low: u32) -> u32 {
    let fraction = u128::from(high) << 32 | u128::from(low);
    ((fraction * (u128::from(last) + 1)) >> 64) as u32
}

/// Numbers whose halves are all pairs of the ends of 16 bits, of powers of two and of their neighbours.
fn structured() -> Vec<u32> {
    let mut halves = vec![0, 3, 0x5555, 0xaaaa, 0xfffe, 0xffff];
    halves.extend((0..16).map(|bit| 1 << bit));
    let high = halves.iter().map(|half| half << 16);
    high.flat_map(|high| halves.iter().map(move |low| high | low))
        .collect()
}

/// The first triple of numbers of which a function is not ⌊(word·last + word + carried)/2³²⌋.
fn wrong(form: impl Fn(u32, u32, u32) -> u32) -> Option<[u32; 3]> {
    let long = |[last, word, carried]: [u32; 3]| {
        let word = u128::from(word);
        ((word * u128::from(last) + word + u128::from(carried)) >> 32) as u32
    };
    let mut rng = Pcg32::new(5, 5);
    let random =
        (0..1 << 20).map(move |_| [(); 3].map(|()| rng.next_u32() >> (rng.next_u32() & 31)));
    let numbers = structured();
    let pairs = numbers
        .iter()
        .flat_map(|last| numbers.iter().map(move |word| (*last, *word)));
    let triples = pairs.flat_map(|(last, word)| [0, 0xffff, u32::MAX].map(|c| [last, word, c]));
    triples
        .chain(random)
        .find(|of @ [last, word, carried]| form(*last, *word, *carried) != long(*of))
}

#[test]
fn both_kinds_of_cores_give_the_same_integers() {
    assert_eq!(wrong(up_to_on::<true>), None);
    assert_eq!(wrong(up_to_on::<false>), None);
    // A carry that is lost is seen, also one out of the least column.
    assert!(wrong(|last, word, _| up_to_on::<true>(last, word, 0)).is_some());
    assert!(wrong(|last, word, carried| up_to_on::<true>(last, word, carried & !0xffff)).is_some());
}

#[test]
fn two_words_are_one_fraction() {
    let numbers = structured();
    let mut rng = Pcg32::new(7, 7);
    for last in numbers.iter().copied() {
        for high in numbers.iter().copied() {
            let low = rng.next_u32();
            assert_eq!(up_to(last, high), exact(last, high, 0));
            for low in [low, 0, u32::MAX, low | 0xffff_0000] {
                assert_eq!(up_to_by_two(last, high, low), exact(last, high, low));
            }
        }
    }
}

/// An analogue of words of 16 bits, by products of 8 as a narrow core has them.
fn analogue(last: u32, word: u32) -> u32 {
    let ([high, low], [last_high, last_low]) = ([word >> 8, word & 0xff], [last >> 8, last & 0xff]);
    let middle = high * last_low + high + ((low * last_low + low) >> 8);
    let other = low * last_high + (middle & 0xff);
    high * last_high + (middle >> 8) + (other >> 8)
}

/// The first range of so many integers of which one does not have the words from ⌈k·2¹⁶/n⌉ to ⌈(k + 1)·2¹⁶/n⌉ − 1, of all words
/// of 16 bits.
fn unfair(sizes: impl Iterator<Item = u32>, form: impl Fn(u32, u32) -> u32) -> Option<u32> {
    let fair = |n: u32| {
        let first = |k: u32| (k << 16).div_ceil(n);
        let mut word = 0;
        (0..n).all(|k| {
            while word < 1 << 16 && form(n, word) == k {
                word += 1;
            }
            word == if k + 1 < n { first(k + 1) } else { 1 << 16 }
        })
    };
    sizes.into_iter().find(|n| !fair(*n))
}

/// Of each integer of 16 bits that may be the last.
#[test]
fn each_integer_has_its_share_of_all_words() {
    let step = speed::or_all("one size of every", 97, 5, 1);
    let sizes = || {
        (1..=300)
            .chain((301..=1 << 16).step_by(step))
            .chain([1 << 16])
    };
    assert_eq!(unfair(sizes(), |n, word| analogue(n - 1, word)), None);
    assert_eq!(
        unfair(sizes(), |n, word| ((u64::from(word) * u64::from(n)) >> 16)
            as u32),
        None
    );
    // What is not fair: the remainder, whose words are not next to each other; and a uniform of fewer bits.
    assert_eq!(unfair(2..4, |n, word| word % n), Some(2));
    assert_eq!(unfair(1..300, |n, word| ((word >> 4) * n) >> 12), Some(3));
}

#[test]
fn integers_that_go_in_by_halves_are_floats_as_converted() {
    let mut rng = Pcg32::new(6, 6);
    let random = (0..speed::of("random integers", 100_000, 100_000_000)).map(|_| rng.next_u32());
    for word in structured().into_iter().chain(random) {
        let n = word as i32;
        assert_eq!(float(n).to_bits(), (n as f32).to_bits(), "{n}");
        assert_eq!(
            folded_tail(word).to_bits(),
            folded(word).0.to_bits(),
            "{word}"
        );
    }
}

/// Divisors of all lengths, each with dividends from half of it to just below it, and to just below twice as much.
fn divisions() -> impl Iterator<Item = [u64; 2]> {
    let mut rng = Pcg32::new(6, 6);
    let mut divisors: Vec<u64> = (0..1 << 16)
        .map(|_| rng.next_u64() >> (rng.next_u32() & 63))
        .filter(|&d| d > 1)
        .collect();
    divisors.extend((1..64).flat_map(|bit| [1 << bit, (1 << bit) + 1, u64::MAX >> (bit - 1)]));
    divisors.into_iter().flat_map(move |d| {
        let least = d.div_ceil(2);
        let most = d.saturating_mul(2).saturating_sub(1);
        let within = least + rng.next_u64() % (most - least + 1);
        [least, d - 1, d, within, most].map(|x| [x.max(least), d])
    })
}

/// The first of these of which a function is not so many binary digits of the quotient and whether that is inexact.
fn wrong_quotient(digits: u32, form: impl Fn(u64, u64) -> (u32, bool)) -> Option<[u64; 2]> {
    divisions().find(|&[x, d]| {
        let (dividend, divisor) = (u128::from(x) << digits, u128::from(d));
        let (quotient, rest) = (dividend / divisor, dividend % divisor);
        // Where a fraction is asked for, the dividend is the smaller one.
        (digits == 31 || x < d) && form(x, d) != (quotient as u32, rest > 0)
    })
}

#[test]
fn both_kinds_of_cores_divide_alike() {
    let scaled = |x: u64, d: u64| {
        let (quotient, inexact) = scaled_on::<false>(x.into(), d.into(), 31);
        (quotient as u32, inexact)
    };
    assert_eq!(wrong_quotient(31, quotient_on::<true>), None);
    assert_eq!(wrong_quotient(31, quotient_on::<false>), None);
    assert_eq!(wrong_quotient(31, scaled), None);
    assert_eq!(wrong_quotient(32, fraction_on::<true>), None);
    assert_eq!(wrong_quotient(32, fraction_on::<false>), None);
    // A last digit that is not worked out, and a remainder that is not looked at, are seen.
    let short = |x, d| {
        let (quotient, inexact) = quotient_on::<false>(x, d);
        (quotient & !1, inexact)
    };
    assert!(wrong_quotient(31, short).is_some());
    assert!(wrong_quotient(32, |x, d| (fraction_on::<false>(x, d).0, true)).is_some());
}

/// The first sum of some total that is not divided as digit by digit.
fn wrong_share(share: impl Fn(&Divisor, u128) -> (u128, bool)) -> Option<[u128; 2]> {
    let mut rng = Pcg32::new(9, 31);
    let mut any = || {
        let words = [(); 4].map(|()| rng.next_u32());
        let number = words
            .iter()
            .fold(0, |all, &word| all << 32 | u128::from(word));
        // Of any length, and now and then next to a power of two.
        let number = number >> (words[0] % 126) & u128::MAX >> 2;
        match words[1] % 4 {
            0 => (number + 1).next_power_of_two() - u128::from(words[2] & 1),
            _ => number,
        }
    };
    (0..300_000).find_map(|_| {
        let total = any().max(1);
        let x = match any() {
            part @ 0..4 => total.saturating_sub(part),
            part => part % (total + 1),
        };
        let wrong = share(&Divisor::of(total), x) != scaled_on::<false>(x, total, 32);
        wrong.then_some([x, total])
    })
}

#[test]
fn sums_are_divided_by_a_total_as_digit_by_digit() {
    assert_eq!(wrong_share(|total, x| total.scaled(x, 32)), None);
    let cut = |total: &Divisor, x| (total.scaled(x, 32).0 & !1, total.scaled(x, 32).1);
    assert!(wrong_share(cut).is_some());
}

/// The largest error of a root of numbers of two neighbouring exponents, which stand for all, in units in the last place.
fn error_of_root(root: impl Fn(f32) -> f32, exact: impl Fn(f64) -> f64) -> f64 {
    let step = speed::of("stride of numbers of which roots are taken", 41, 1);
    let errors = (0..1_u32 << 24).step_by(step).map(|i| {
        let x = f32::from_bits(1.0_f32.to_bits() + i);
        ulps(root(x), exact(x.into()))
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn square_roots_are_good_to_half_a_unit() {
    let inverse = |x: f64| 1.0 / x.sqrt();
    for (root, exact) in [
        (
            square_root as fn(Scaled) -> f32,
            f64::sqrt as fn(f64) -> f64,
        ),
        (inverse_square_root, inverse),
    ] {
        let error = error_of_root(|x| root(Scaled::of(x)), exact);
        assert!(error <= 0.501, "{error}");
        // A root that is rounded twice is seen.
        let error = error_of_root(|x| root(Scaled::of(x)) * 3.0 / 3.0, exact);
        assert!(error > 0.501, "{error}");
        for x in [f32::from_bits(1), f32::MIN_POSITIVE, f32::MAX] {
            let (found, truth) = (f64::from(root(Scaled::of(x))), exact(x.into()));
            assert!((found / truth - 1.0).abs() <= 6e-8, "{x}: {found}");
        }
    }
}
