//! `Cdf`: every entry's words counted, in both widths, from 24, 32 and 64 bits.

use crate::cases::{Exact, STEP, counts, grid_counts, grid_point};
use crate::cases::{cases, wild};
use host::speed;
use microwarp::Error;
use microwarp::discrete::Cdf;
use std::ops::RangeInclusive;
use std::sync::LazyLock;

/// What must hold of counts out of 2^bits: each within `slack` 2^-32 steps of its part, none for a weight of zero.
fn objections(exact: &Exact, counts: &[u128], bits: u32, slack: u64) -> Vec<String> {
    assert_eq!(counts.len(), exact.weights.len());
    assert_eq!(counts.iter().sum::<u128>(), 1 << bits);
    let nothing = 0_u32.into();
    let mut found = Vec::new();
    for (i, &count) in counts.iter().enumerate() {
        if exact.weights[i] == nothing && count > 0 {
            found.push(format!("entry {i} of weight 0 has {count} of 2^{bits}"));
        }
        if !exact.within(i, count, bits, slack) {
            found.push(format!("entry {i} has {count} of 2^{bits}"));
        }
    }
    found
}

fn assert_right(what: &str, exact: &Exact, counts: &[u128], bits: u32, slack: u64) {
    let found = objections(exact, counts, bits, slack);
    assert!(
        found.is_empty(),
        "{what}: {} objections, the first: {}",
        found.len(),
        found[0]
    );
}

/// The counts that a table claims, each held to its first and its last word: for tables too large for
/// galloping, and as good where the selection goes up with the word.
fn claimed(
    n: usize,
    last: u64,
    words: impl Fn(usize) -> Option<(u64, u64)>,
    index: impl Fn(u64) -> usize,
) -> Vec<u128> {
    let mut counts = vec![0; n];
    let mut next = Some(0);
    for (i, count) in counts.iter_mut().enumerate() {
        if let Some((start, end)) = words(i) {
            assert_eq!(Some(start), next, "{i}");
            assert_eq!((index(start), index(end)), (i, i));
            *count = u128::from(end - start) + 1;
            next = end.checked_add(1).filter(|&word| word <= last);
        }
    }
    assert_eq!(next, None, "words without an entry");
    counts
}

/// More entries than this are not galloped through at 64 bits.
static FEW: LazyLock<usize> =
    LazyLock::new(|| speed::of("entries that are galloped through at 64 bits", 300, 5000));

/// A table of u32 as counted, or the refusal that the weights deserve.
fn check_narrow(
    what: &str,
    weights: &[f32],
    exact: &Exact,
    memory: &mut [u32],
    one_by_one: bool,
) -> bool {
    let n = weights.len();
    let table = match Cdf::<&[u32]>::new_in(weights, memory) {
        Ok(table) => table,
        Err(error) => {
            assert!(
                !exact.divisible(32),
                "{what}: {error:?}, but it can be done"
            );
            let Error::Unreachable(index) = error else {
                panic!("{what}: {error:?}");
            };
            let small = &exact.weights[index];
            assert!(
                *small > 0_u32.into() && (small << 32_u32) < exact.total,
                "{what}"
            );
            return false;
        }
    };
    assert_eq!(table.entries(), n);
    let counted = counts(n, u32::MAX.into(), |word| table.index(word as u32));
    assert_right(what, exact, &counted, 32, STEP);
    for (i, &count) in counted.iter().enumerate() {
        assert_eq!(u128::from(table.numerator(i)), count, "{what} {i}");
        assert!(count > 0 || weights[i] == 0.0, "{what}: {i} is not reached");
        // 33 bits of numerator are exact in an f64, and its quotient by a power of two too.
        let pmf = (count as f64 / 4_294_967_296.0) as f32;
        assert_eq!(table.pmf(i).to_bits(), pmf.to_bits(), "{what} {i}");
        let words = table
            .words_of(i)
            .map_or(0, |r| u128::from(r.end() - r.start()) + 1);
        assert_eq!(words, count, "{what} {i}");
    }
    assert_eq!(table.numerator(n), 0);
    assert_eq!(table.pmf(usize::MAX).to_bits(), 0);
    assert!(table.words_of(n).is_none());
    let by_uniform = |u| table.select_uniform(u).index;
    let counted = counts(n, (1 << 24) - 1, |k| by_uniform(grid_point(k)));
    assert_right(what, exact, &counted, 24, STEP);
    if one_by_one {
        assert_eq!(counted, grid_counts(n, by_uniform), "{what}");
    }
    true
}

fn check_wide(what: &str, weights: &[f32], exact: &Exact, memory: &mut [u64], one_by_one: bool) {
    let n = weights.len();
    let table = Cdf::<&[u64]>::new_in(weights, memory).unwrap();
    let counted = if n > *FEW {
        let words = |i| table.words_of(i).map(RangeInclusive::into_inner);
        claimed(n, u64::MAX, words, |word| table.index(word))
    } else {
        counts(n, u64::MAX, |word| table.index(word))
    };
    // The steps that tiny weights are given, and those lost where weights span more than 47 binary orders.
    assert_right(what, exact, &counted, 64, STEP << 21);
    for (i, &count) in counted.iter().enumerate() {
        assert_eq!(table.numerator(i), count, "{what} {i}");
        assert!(count > 0 || weights[i] == 0.0, "{what}: {i} is not reached");
        let pmf = count as f32 / 2_f32.powi(64);
        assert_eq!(table.pmf(i).to_bits(), pmf.to_bits(), "{what} {i}");
    }
    // The same, seen from 32 bits.
    let counted = counts(n, u32::MAX.into(), |bits| table.select(bits as u32).index);
    assert_right(what, exact, &counted, 32, STEP + (1 << 21));
    let by_uniform = |u| table.select_uniform(u).index;
    let counted = counts(n, (1 << 24) - 1, |k| by_uniform(grid_point(k)));
    assert_right(what, exact, &counted, 24, STEP + (1 << 21));
    if one_by_one {
        assert_eq!(counted, grid_counts(n, by_uniform), "{what}");
    }
}

#[test]
fn every_entry_has_its_share_of_the_words() {
    let (mut narrow, mut wide) = (vec![0; 1 << 20], vec![0; 1 << 20]);
    let mut refused = Vec::new();
    let grid = speed::of(
        "sizes of tables counted over the whole grid",
        5..=5,
        5..=1000,
    );
    for (what, weights) in cases() {
        let exact = Exact::of(&weights);
        let few = grid.contains(&weights.len());
        if !check_narrow(what, &weights, &exact, &mut narrow, few) {
            refused.push(what);
        }
        check_wide(what, &weights, &exact, &mut wide, few);
        println!("{what}: {} entries counted", weights.len());
    }
    println!("too small to be reached by 32 bits: {refused:?}");
    let mut due = vec![
        "geometric, 253",
        "geometric, 2^20",
        "geometric down",
        "geometric, 20 decades",
        "all there is",
        "one huge first",
        "one huge amid",
        "one huge last",
        "random, 60 decades",
    ];
    due.retain(|what| cases().iter().any(|case| case.0 == *what));
    assert_eq!(refused, due);
}

#[test]
fn wild_tables_are_as_good_as_can_be() {
    let (mut narrow, mut wide) = ([0; 24], [0; 24]);
    let (mut taken, mut crowded) = (0_u32, 0_u32);
    let tables = speed::of("wild tables", 1_000_u32, 20_000);
    for seed in 0..u64::from(tables) {
        let weights = wild(seed);
        let exact = Exact::of(&weights);
        let what = format!("{weights:?}");
        if check_narrow(&what, &weights, &exact, &mut narrow, false) {
            taken += 1;
        }
        crowded += u32::from(
            exact
                .weights
                .iter()
                .any(|w| *w > 0_u32.into() && (w << 32_u32) < exact.total),
        );
        check_wide(&what, &weights, &exact, &mut wide, false);
    }
    println!("{taken} of {tables} taken by u32, {crowded} with a weight below a step");
    assert!(crowded > tables / 10 && taken > tables - crowded + tables / 40);
}

/// In the quick speed every 4093th word, and those next to where an entry begins.
#[test]
fn all_the_words_of_a_table_counted_one_by_one() {
    let weights = [0.0, 1.0, 1e-9, 0.0, 2.5, 3e-10, 0.0];
    let table = Cdf::new(&weights).unwrap();
    // Galloping finds as many words as there are.
    let galloped = counts(7, u32::MAX.into(), |word| table.index(word as u32));
    for (i, count) in galloped.iter().enumerate() {
        assert_eq!(u128::from(table.numerator(i)), *count, "{i}");
    }
    if !speed::full() {
        let starts = (0..7).filter_map(|i| table.words_of(i).map(|words| *words.start()));
        let near = starts.flat_map(|start| {
            (0..1 << 16).map(move |by: u32| start.wrapping_add(by).wrapping_sub(1 << 15))
        });
        for word in (0..=u32::MAX).step_by(4093).chain(near) {
            let words = table.words_of(table.index(word)).unwrap();
            assert!(words.contains(&word), "{word:#x}");
        }
        return;
    }
    let totals = std::sync::Mutex::new([0_u64; 7]);
    std::thread::scope(|scope| {
        for half in 0..2_u32 {
            let (table, totals) = (&table, &totals);
            scope.spawn(move || {
                let mut counts = [0_u64; 7];
                for rest in 0..1_u32 << 31 {
                    counts[table.index(half << 31 | rest)] += 1;
                }
                let mut totals = totals.lock().unwrap();
                for (total, count) in totals.iter_mut().zip(counts) {
                    *total += count;
                }
            });
        }
    });
    let totals = totals.into_inner().unwrap();
    for (i, total) in totals.into_iter().enumerate() {
        assert_eq!(table.numerator(i), total, "{i}");
    }
}

#[test]
fn integer_weights_are_exact() {
    let weights = [0, 1, u32::MAX, 3, 0, u32::MAX - 1, 0];
    let table = Cdf::from_integers_u64(&weights).unwrap();
    let total: u128 = weights.iter().map(|&w| u128::from(w)).sum();
    let mut below = 0;
    for (i, &weight) in weights.iter().enumerate() {
        let up = |w: u128| (w << 64).div_ceil(total);
        let count = up(below + u128::from(weight)) - up(below);
        assert_eq!(table.numerator(i), count, "{i}");
        below += u128::from(weight);
    }
}

/// Some ends are repeated, as those of zero weights are.
#[test]
fn the_search_is_right_for_every_length() {
    let last = u64::from(u32::MAX);
    let longest = speed::of("longest table of all lengths", 140, 2_100);
    for n in (1..longest).chain([255, 256, 512, 1023, 1024, 1025, 2047, 2048]) {
        let mut words: Vec<u64> = (1..n).map(|i| (i / 3 + i / 2) * 2_000_000).collect();
        let ends = words.iter().copied().chain([last + 1]);
        let starts = [0].into_iter().chain(words.iter().copied());
        let due: Vec<u128> = ends.zip(starts).map(|(e, s)| u128::from(e - s)).collect();
        let closed = |word| words.partition_point(|&end| end < word);
        let wrong = counts(due.len(), last, closed);
        assert!(n < 3 || wrong != due, "a wrong search goes unnoticed");

        words.push(n - 1);
        let narrow: Vec<u32> = words.iter().map(|&word| word as u32).collect();
        let narrow = Cdf::from_trusted_words(narrow).unwrap();
        let wide = Cdf::from_trusted_words(words).unwrap();
        let found = counts(due.len(), last, |word| narrow.index(word as u32));
        assert_eq!(found, due, "{n} entries, u32");
        let found = counts(due.len(), last, |word| wide.index(word));
        assert_eq!(found, due, "{n} entries, u64");
    }
}

/// The check rejects what peers do: running sums in f32, and the convention that ends belong to the
/// entry before them.
#[test]
fn wrong_tables_are_rejected() {
    let weights = vec![0.1_f32; 100_000];
    let exact = Exact::of(&weights);
    let mut sum = 0.0;
    let ends: Vec<f32> = weights
        .iter()
        .map(|w| {
            sum += w;
            sum
        })
        .collect();
    let ends: Vec<u64> = ends
        .iter()
        .map(|end| (f64::from(end / sum) * 4_294_967_296.0) as u64)
        .collect();
    let naive = |word: u64| ends.partition_point(|&end| end <= word);
    let counted = counts(100_000, u32::MAX.into(), naive);
    let found = objections(&exact, &counted, 32, STEP);
    assert!(found.len() > 90_000, "{}", found.len());

    let weights = [0.0, 1.0, 0.0, 1.0];
    let exact = Exact::of(&weights);
    let ends = [0.0, 0.5, 0.5, 1.0];
    let closed = |u: f32| ends.partition_point(|&end| end < u);
    let found = objections(&exact, &grid_counts(4, closed), 24, STEP);
    assert_eq!(found, ["entry 0 of weight 0 has 1 of 2^24"]);

    // Off by two steps of 2^32, at one border.
    let table = Cdf::new(&[1.0, 2.0, 3.0, 4.0]).unwrap();
    let mut words: [u32; 4] = *table.as_words().first_chunk().unwrap();
    words[1] += 2;
    let wrong = Cdf::from_words(words).unwrap();
    let counted = counts(4, u32::MAX.into(), |word| wrong.index(word as u32));
    let found = objections(&Exact::of(&[1.0, 2.0, 3.0, 4.0]), &counted, 32, STEP);
    assert_eq!(found.len(), 2, "{found:?}");
}
