//! Cores without a long multiply compute by other products and other loops than those with one: the bits are the
//! same, and where products are said to be exact they are.
//!
//! The kernels are compiled here in both ways from the very same files.

use super::{narrow, wide};
use crate::inputs::{Words, edges};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;
use support::speed;

/// Operands whose halves are all pairs of the ends of 16 bits and of powers of two.
pub fn structured() -> Vec<u32> {
    let mut halves = vec![
        0, 1, 2, 3, 0x00ff, 0x5555, 0x7ffe, 0x7fff, 0xaaaa, 0xfffe, 0xffff,
    ];
    halves.extend((2..16).map(|bit| 1 << bit));
    let high = halves.iter().map(|half| half << 16);
    high.flat_map(|high| halves.iter().map(move |low| high | low))
        .collect()
}

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
    let count = speed::of("pairs of operands at random", 1 << 18, 1 << 22);
    let random = (0..count).map(|_| (random(), random()));
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
    use narrow::product as n;
    use wide::product as w;
    assert!(agree(n::high, w::high));
    assert!(agree(n::near, w::near));
    assert!(agree(n::wide, w::wide));
    assert!(agree(
        |a, b| n::by_half(a, half(b)),
        |a, b| w::by_half(a, half(b))
    ));
    assert!(agree(
        |a, b| n::by_signed_half(a, signed_half(b)),
        |a, b| w::by_signed_half(a, signed_half(b))
    ));
    assert!(agree(
        |a, b| n::near_signed(a, b as i32),
        |a, b| w::near_signed(a, b as i32)
    ));
    // The comparison itself sees a carry that is lost, and a sign.
    let careless = |a: u32, b: u32| (a >> 16) * (b >> 16) + (((a >> 16) * (b & 0xffff)) >> 16);
    assert!(!agree(careless, w::high));
    assert!(!agree(
        |a, b| n::by_half(a, half(b)) as i32,
        |a, b| w::by_signed_half(a, signed_half(b))
    ));
}

/// By products of 128 bits.
#[test]
fn products_are_as_exact_as_they_say() {
    use wide::product as w;
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

/// Everything a word gives in all kernels of one kind.
macro_rules! all_of {
    ($kind:ident, $word:expr) => {{
        use crate::fixed::$kind::{angle, exp, float, log, root, sine};
        let word: u32 = $word;
        let small = word >> 8;
        (
            [sine::fine(word), sine::coarse(word), sine::compact(word)],
            [root::fine(word), root::coarse(word), root::compact(word)],
            [
                log::fine(word),
                log::coarse(word),
                log::compact(word),
                log::small(small),
                log::eighth(word >> 3),
            ],
            [exp::fine(word), exp::coarse(word), exp::compact(word)],
            exp::one_minus_small(small, 27),
            [0, 7, 27, 32].map(|fraction| float::of(word, fraction)),
            angle::vectoring(word as i32, word.wrapping_mul(0x9e37_79b9) as i32, 8),
        )
    }};
}

#[test]
fn both_kinds_of_kernels_give_the_same_bits() {
    let differ = Words::all_or(16, 256).fold(
        "both kinds",
        &edges(),
        || 0_u64,
        |differ, word| *differ += u64::from(all_of!(narrow, word) != all_of!(wide, word)),
    );
    assert_eq!(differ.iter().sum::<u64>(), 0);
}
