//! Selection in integers alone: the entry that floats select by the same bits, and with it the exact place.

use host::generators::{Broken, Counting, Failing};
use host::speed;
use microwarp::discrete::{Alias, AliasEntry, Cdf, ExactSelection, Selection};
use microwarp::uniform::grid_from_word;
use num_bigint::BigUint;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// Integer weights of all kinds. Those below 2^24 are `f32` as well.
fn cases() -> Vec<(&'static str, Vec<u32>)> {
    let mut rng = Pcg32::new(24, 24);
    let mut random = |n: usize, bits: u32| -> Vec<u32> {
        let mut any = || match rng.next_u32() % 3 {
            0 => 0,
            _ => (rng.next_u32() >> (32 - bits)) >> (rng.next_u32() % bits),
        };
        let mut weights: Vec<u32> = (0..n).map(|_| any()).collect();
        weights[n / 3] = 1;
        weights
    };
    vec![
        ("one", vec![1]),
        ("one, large", vec![u32::MAX]),
        ("one of several", vec![0, 0, 9, 0]),
        ("a die", vec![1; 6]),
        ("a loaded die", vec![1, 1, 1, 1, 1, 3]),
        ("a coin", vec![1, 1]),
        ("a whole table of words", vec![1, u32::MAX]),
        ("equal, 1000", vec![7; 1000]),
        ("linear, 4095", (0..4095).collect()),
        ("geometric", (0..24).map(|k| 1 << k).collect()),
        ("geometric, all bits", (0..32).map(|k| 1 << k).collect()),
        ("one huge", vec![1, 0, u32::MAX, 1, 2]),
        ("random, small", random(100, 8)),
        ("random, 24 bits", random(777, 24)),
        ("random, 32 bits", random(300, 32)),
        ("random, few", random(5, 32)),
    ]
}

/// The words about the borders of the entries, the ends, and random ones.
fn words(table: &Cdf<Vec32>, rng: &mut Pcg32) -> Vec<u32> {
    let mut words = vec![0, 1, u32::MAX - 1, u32::MAX, 0x7fff_ffff, 0x8000_0000];
    for i in 0..table.entries().min(300) {
        if let Some(range) = table.words_of(i) {
            words.extend([*range.start(), *range.end(), range.start().wrapping_add(1)]);
        }
    }
    words.extend((0..2000).map(|_| rng.next_u32()));
    words
}

type Vec32 = heapless::Vec<u32, 4096>;
type Vec64 = heapless::Vec<u64, 4096>;
type Bins32 = heapless::Vec<AliasEntry<u32>, 4096>;
type Bins64 = heapless::Vec<AliasEntry<u64>, 4096>;

#[test]
fn integers_select_the_entry_that_floats_select_by_the_same_bits() {
    let mut rng = Pcg32::new(1, 1);
    let mut compared = 0;
    for (what, weights) in cases() {
        let floats: Vec<f32> = weights.iter().map(|&w| w as f32).collect();
        let exact = weights.iter().all(|&w| u64::from(w) == w as f32 as u64);
        let Ok(cdf) = Cdf::<Vec32>::from_integer_slice(&weights) else {
            panic!("{what}")
        };
        let alias = Alias::<Bins32>::from_integer_slice(&weights).unwrap();
        let wide = Cdf::<Vec64>::from_integer_slice(&weights).unwrap();
        let float_cdf = Cdf::<Vec32>::from_slice(&floats).unwrap();
        let float_alias = Alias::<Bins32>::from_slice(&floats).unwrap();
        if exact {
            // The same table, word by word.
            assert_eq!(cdf, float_cdf, "{what}");
            assert_eq!(alias, float_alias, "{what}");
            assert_eq!(wide, Cdf::<Vec64>::from_slice(&floats).unwrap(), "{what}");
            compared += 1;
        }
        for bits in words(&cdf, &mut rng) {
            // Where the weights are the same; the floats' own selections wherever they come from.
            if exact {
                assert_eq!(cdf.index(bits), float_cdf.select(bits).index, "{what}");
                assert_eq!(alias.index(bits), float_alias.select(bits).index, "{what}");
            }
            let grid = bits & 0xffff_ff00;
            let by_uniform = |u| [cdf.select_uniform(u).index, alias.select_uniform(u).index];
            assert_eq!(
                [cdf.select_exact(grid).index, alias.select_exact(grid).index],
                by_uniform(grid_from_word(bits)),
                "{what}"
            );
            assert_eq!(cdf.select_exact(bits).index, cdf.index(bits), "{what}");
            assert_eq!(alias.select_exact(bits).index, alias.index(bits), "{what}");
            let both = u64::from(bits) << 32;
            assert_eq!(wide.select_exact(bits).index, wide.index(both), "{what}");
        }
    }
    assert!(compared >= 9);
}

/// What must be said of a selection whose word is `offset` of `count` words, of which `missing` bits are 0.
fn assert_exact<C: Into<u128>>(
    what: &str,
    chosen: ExactSelection<C>,
    rounded: Selection,
    (offset, count): (u128, u128),
    missing: u32,
) {
    let leftover = (BigUint::from(offset) << 32_u32) / count;
    assert_eq!(BigUint::from(chosen.leftover), leftover, "{what}");
    let bits = count.ilog2().saturating_sub(missing);
    assert_eq!(chosen.leftover_bits, bits, "{what}");
    // What is rounded says the same, rounded.
    assert_eq!(chosen.index, rounded.index, "{what}");
    assert_eq!(chosen.leftover_bits, rounded.leftover_bits, "{what}");
    let due = offset as f64 / count as f64;
    let off = (f64::from(rounded.leftover) - due).abs();
    assert!(off <= 1.8e-7 * due, "{what}: {off}");
    assert!((0.0..1.0).contains(&rounded.leftover), "{what}");
}

/// The words about one that select the same entry, within the bits that a bin has: what is left is the place
/// among them.
fn part<I: Fn(u64) -> usize>(word: u64, bin: (u64, u64), index: I) -> (u128, u128) {
    let same = |w: u64| index(w) == index(word);
    // The last that is the same on the way to `end`, if all are the same up to it.
    let reach = |end: u64| {
        let (mut near, mut far) = (word, end);
        if same(end) {
            return end;
        }
        while near.abs_diff(far) > 1 {
            let middle = near / 2 + far / 2 + (near % 2 + far % 2) / 2;
            if same(middle) {
                near = middle;
            } else {
                far = middle;
            }
        }
        near
    };
    let (first, last) = (reach(bin.0), reach(bin.1));
    (u128::from(word - first), u128::from(last - first) + 1)
}

#[test]
fn exact_selections_are_exact() {
    let mut rng = Pcg32::new(2, 2);
    for (what, weights) in cases() {
        let cdf = Cdf::<Vec32>::from_integer_slice(&weights).unwrap();
        let wide = Cdf::<Vec64>::from_integer_slice(&weights).unwrap();
        let alias = Alias::<Bins32>::from_integer_slice(&weights).unwrap();
        let wide_alias = Alias::<Bins64>::from_integer_slice(&weights).unwrap();
        let bin_bits = alias.bins().trailing_zeros();
        for bits in words(&cdf, &mut rng) {
            let chosen = cdf.select_exact(bits);
            assert_eq!(chosen, cdf.select_exact_word(bits));
            let range = cdf.words_of(chosen.index).unwrap();
            let count = u128::from(range.end() - range.start()) + 1;
            assert_eq!(u128::from(chosen.numerator), count, "{what}");
            let place = (u128::from(bits - range.start()), count);
            assert_exact(what, chosen, cdf.select(bits), place, 0);

            let word = u64::from(bits) << 32 | u64::from(rng.next_u32());
            let chosen = wide.select_exact_word(word);
            let range = wide.words_of(chosen.index).unwrap();
            let count = u128::from(range.end() - range.start()) + 1;
            assert_eq!(chosen.numerator, count, "{what}");
            let place = (u128::from(word - range.start()), count);
            assert_exact(what, chosen, wide.select_word(word), place, 0);
            let short = u64::from(bits) << 32;
            let chosen = wide.select_exact(bits);
            let range = wide.words_of(chosen.index).unwrap();
            let count = u128::from(range.end() - range.start()) + 1;
            let place = (u128::from(short - range.start()), count);
            assert_exact(what, chosen, wide.select(bits), place, 32);

            let chosen = alias.select_exact(bits);
            assert_eq!(chosen.numerator, cdf.numerator(chosen.index), "{what}");
            let within = ((1_u64 << 32) - 1) >> bin_bits;
            let first = u64::from(bits) & !within;
            let place = part(bits.into(), (first, first + within), |w| {
                alias.index(w as u32)
            });
            assert_exact(what, chosen, alias.select(bits), place, 0);

            let chosen = wide_alias.select_exact_word(word);
            assert_eq!(chosen.numerator, wide.numerator(chosen.index), "{what}");
            let within = u64::MAX >> bin_bits;
            let first = word & !within;
            let place = part(word, (first, first + within), |w| wide_alias.index(w));
            assert_exact(what, chosen, wide_alias.select_word(word), place, 0);
        }
    }
}

#[test]
fn exact_draws_take_the_words_of_any_draw() {
    let weights = [3, 0, 5, 1];
    let cdf = Cdf::from_integers(&weights).unwrap();
    let wide = Alias::<[AliasEntry<u64>; 4]>::from_integers_u64(&weights).unwrap();
    let mut rng = Counting::new(Pcg32::new(3, 3));
    for _ in 0..100 {
        let mut again = Pcg32::clone(&rng.inner);
        let word = again.next_u32();
        assert_eq!(cdf.draw_exact(&mut rng), cdf.select_exact(word));
        let mut again = Pcg32::clone(&rng.inner);
        let word = u64::from(again.next_u32()) << 32 | u64::from(again.next_u32());
        assert_eq!(wide.draw_exact(&mut rng), wide.select_exact_word(word));
    }
    assert_eq!(rng.words, 300);
    let mut failing = Failing { word: 0, left: 1 };
    assert_eq!(wide.try_draw_exact(&mut failing), Err(Broken(17)));
    assert_eq!(cdf.try_draw_exact(&mut failing), Err(Broken(17)));
}

/// The leftover of an exact selection is the quotient of the place in the share by the share, for shares of every size.
#[test]
fn exact_leftovers_are_quotients() {
    let rounds = speed::of("shares", 200_000, 10_000_000);
    let mut rng = Pcg32::new(21, 54);
    for round in 0..rounds {
        let count = (rng.next_u32() >> (round % 32)).max(1);
        let table = Cdf::from_integers(&[count, count.wrapping_neg()]).unwrap();
        let places = [0, count / 3, count / 2, count - 1, rng.next_u32() % count];
        for place in places {
            let chosen = table.select_exact(place);
            assert_eq!((chosen.index, chosen.numerator), (0, count.into()));
            let due = (u64::from(place) << 32) / u64::from(count);
            assert_eq!(u64::from(chosen.leftover), due, "{place} of {count}");
        }
    }
}
