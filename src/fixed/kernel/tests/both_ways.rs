//! Cores without a long multiply compute by other products and other loops than those with one: the bits are the
//! same, and where products are said to be exact they are.
//!
//! In tests a function that knows two ways takes both and compares them, so that each call here is a comparison.

use super::structured;
use crate::fixed::kernel::{angle, exp, float, log, product, root, sine};
use host::parallel::{in_parallel, threads};
use host::speed;
use host::words::edges;
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;
use std::vec::Vec;

/// Whether two functions agree on all pairs of structured operands and on many at random.
fn agree<R: PartialEq>(f: impl Fn(u32, u32) -> R, g: impl Fn(u32, u32) -> R) -> bool {
    let structured = structured();
    let mut rng = Pcg32::seed_from_u64(3);
    let mut random = || {
        let word = rng.next_u32();
        word >> (rng.next_u32() & 31)
    };
    let pairs = structured
        .iter()
        .flat_map(|a| structured.iter().map(move |b| (*a, *b)));
    let random = (0..1 << 22).map(|_| (random(), random()));
    pairs.chain(random).all(|(a, b)| f(a, b) == g(a, b))
}

/// A product that takes a half: the operand's lower one, also with a sign.
const fn half(b: u32) -> u32 {
    b & 0xffff
}
const fn signed_half(b: u32) -> i32 {
    b as u16 as i16 as i32
}

#[test]
fn both_kinds_of_products_give_the_same_bits() {
    use product::{by_half_on, by_signed_half_on, high_on, signed_by_half_on};
    assert!(agree(high_on::<true>, high_on::<false>));
    assert!(agree(
        |a, b| by_half_on::<true>(a, half(b)),
        |a, b| by_half_on::<false>(a, half(b))
    ));
    assert!(agree(
        |a, b| by_signed_half_on::<true>(a, signed_half(b)),
        |a, b| by_signed_half_on::<false>(a, signed_half(b))
    ));
    assert!(agree(
        |a, b| signed_by_half_on::<true>(a as i32, signed_half(b)),
        |a, b| signed_by_half_on::<false>(a as i32, signed_half(b))
    ));
    // The comparison itself sees a carry that is lost, and a sign.
    let careless = |a: u32, b: u32| (a >> 16) * (b >> 16) + (((a >> 16) * (b & 0xffff)) >> 16);
    assert!(!agree(careless, high_on::<false>));
    assert!(!agree(
        |a, b| by_half_on::<true>(a, half(b)) as i32,
        |a, b| by_signed_half_on::<false>(a, signed_half(b))
    ));
}

/// By products of 128 bits.
#[test]
fn products_are_as_exact_as_they_say() {
    use product as w;
    let product = |a: u32, b: u32| u128::from(a) * u128::from(b);
    assert!(agree(w::high, |a, b| (product(a, b) >> 32) as u32));
    assert!(agree(w::wide, |a, b| product(a, b) as u64));
    assert!(agree(
        |a, b| w::by_half(a, half(b)),
        |a, b| (product(a, half(b)) >> 16) as u32
    ));
    let signed = |a: u32, b: i32| i128::from(a) * i128::from(b);
    assert!(agree(
        |a, b| w::by_signed_half(a, signed_half(b)),
        |a, b| (signed(a, signed_half(b)) >> 16) as i32
    ));
    // Within so much from below.
    let below = |exact: i128, got: i128, most: i128| (0..=most).contains(&(exact - got));
    assert!(agree(
        |a, b| below((product(a, b) >> 32) as i128, w::near(a, b).into(), 2),
        |_, _| true
    ));
    assert!(agree(
        |a, b| below(
            signed(a, b as i32) >> 32,
            w::near_signed(a, b as i32).into(),
            2
        ),
        |_, _| true
    ));
    let both_signed = |a: i32, b: i32| i128::from(a) * i128::from(b);
    assert!(agree(
        |a, b| {
            let [a, b] = [a, b].map(|x| x as i32);
            below(both_signed(a, b) >> 32, w::near_of_signed(a, b).into(), 2)
        },
        |_, _| true
    ));
    assert!(agree(
        |a, _| below((product(a, a) >> 32) as i128, w::square(a).into(), 2),
        |_, _| true
    ));
    // The same comparison rejects an allowance that is too small.
    assert!(!agree(
        |a, b| below((product(a, b) >> 32) as i128, w::near(a, b).into(), 0),
        |_, _| true
    ));
}

/// Calls all kernels that know two ways, with a word.
fn every_kernel(word: u32) {
    let small = word >> 8;
    core::hint::black_box((
        [sine::fine(word), sine::coarse(word), sine::compact(word)],
        [root::fine(word), root::coarse(word), root::compact(word)],
        [log::fine(word), log::coarse(word), log::compact(word)],
        [log::small(small), log::eighth(word >> 3)],
        [exp::fine(word), exp::coarse(word), exp::compact(word)],
        exp::one_minus_small(small, 27),
        [0, 7, 27, 32].map(|fraction| float::of(word, fraction)),
        angle::vectoring(word as i32, word.wrapping_mul(0x9e37_79b9) as i32, 8),
    ));
}

#[test]
fn both_kinds_of_kernels_give_the_same_bits() {
    let stride = speed::or_all("one word of both ways tried of every", 16_411, 257, 17);
    let parts: Vec<u32> = (0..256).collect();
    in_parallel(threads(), &parts, |part| {
        let words = (part << 24)..=(part << 24 | 0x00ff_ffff);
        words.step_by(stride).for_each(every_kernel);
    });
    edges().into_iter().for_each(every_kernel);
}
