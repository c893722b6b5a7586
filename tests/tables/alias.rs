//! `Alias`: the words of every entry counted over all bins; they are those of the `Cdf`.

use crate::cases::runs;
use crate::cases::{cases, wild};
use host::speed;
use microwarp::discrete::{Alias, AliasEntry, Cdf};

/// How many words select each entry: in each bin the runs, which may be two.
fn counts(n: usize, bins: usize, bits: u32, index: impl Fn(u64) -> usize) -> Vec<u128> {
    let mut counts = vec![0; n];
    let bin_bits = bins.trailing_zeros();
    for bin in 0..bins as u64 {
        let first = if bin_bits == 0 {
            0
        } else {
            bin << (bits - bin_bits)
        };
        let last = first + (u64::MAX >> (64 - bits) >> bin_bits);
        let runs = runs(first, last, &index);
        assert!(runs.len() <= 2, "bin {bin} has {} parts", runs.len());
        for (i, count) in runs {
            counts[i] += count;
        }
    }
    counts
}

struct Memory {
    ends: Vec<u32>,
    wide_ends: Vec<u64>,
    bins: Vec<AliasEntry<u32>>,
    wide_bins: Vec<AliasEntry<u64>>,
}

impl Memory {
    fn new(n: usize) -> Self {
        Self {
            ends: vec![0; n],
            wide_ends: vec![0; n],
            bins: vec![AliasEntry::<u32>::EMPTY; n],
            wide_bins: vec![AliasEntry::<u64>::EMPTY; n],
        }
    }

    fn check(&mut self, what: &str, weights: &[f32]) {
        let n = weights.len();
        let wide = Cdf::<&[u64]>::new_in(weights, &mut self.wide_ends).unwrap();
        let table = Alias::<&[AliasEntry<u64>]>::new_in(weights, &mut self.wide_bins).unwrap();
        let both = |word| {
            let index = table.index(word);
            assert_eq!(table.select_word(word).index, index);
            index
        };
        let counted = counts(n, table.bins(), 64, both);
        for (i, &count) in counted.iter().enumerate() {
            assert_eq!(count, wide.numerator(i), "{what}: {i} of {n}");
            assert_eq!(table.numerator(i), count, "{what}: {i} of {n}");
            assert_eq!(table.pmf(i).to_bits(), wide.pmf(i).to_bits());
        }
        let narrow = Cdf::<&[u32]>::new_in(weights, &mut self.ends);
        let table = Alias::<&[AliasEntry<u32>]>::new_in(weights, &mut self.bins);
        match (narrow, table) {
            (Ok(narrow), Ok(table)) => {
                let both = |word| {
                    let index = table.index(word as u32);
                    assert_eq!(table.select(word as u32).index, index);
                    index
                };
                let counted = counts(n, table.bins(), 32, both);
                for (i, &count) in counted.iter().enumerate() {
                    assert_eq!(count, u128::from(narrow.numerator(i)), "{what}: {i} of {n}");
                    assert_eq!(
                        table.numerator(i),
                        narrow.numerator(i),
                        "{what}: {i} of {n}"
                    );
                    assert_eq!(table.pmf(i).to_bits(), narrow.pmf(i).to_bits());
                }
                assert_eq!((table.entries(), table.pmf(table.bins())), (n, 0.0));
            }
            (narrow, table) => assert_eq!(narrow.err(), table.err(), "{what}"),
        }
    }
}

#[test]
fn every_entry_has_the_words_it_has_in_a_cdf() {
    let mut memory = Memory::new(1 << 20);
    for (what, weights) in cases() {
        memory.check(what, &weights);
    }
}

#[test]
fn wild_tables_too() {
    let mut memory = Memory::new(32);
    for seed in 20_000..20_000 + speed::of("wild tables of aliases", 2_000, 20_000) {
        let weights = wild(seed);
        memory.check(&format!("{weights:?}"), &weights);
    }
}

#[test]
fn more_bins_than_needed_change_nothing_but_their_size() {
    let weights = [3.0, 0.0, 1.0];
    let tight = Alias::<[AliasEntry<u32>; 4]>::new(&weights).unwrap();
    let loose = Alias::<[AliasEntry<u32>; 64]>::new(&weights).unwrap();
    let counted = counts(3, 64, 32, |word| loose.index(word as u32));
    for (i, count) in counted.into_iter().enumerate() {
        assert_eq!(u128::from(tight.numerator(i)), count);
        assert_eq!(u128::from(loose.numerator(i)), count);
    }
    assert_eq!((tight.bins(), loose.bins(), loose.entries()), (4, 64, 3));
}

/// The counting sees a table whose bin and coin share bits: there a word's bin tells its coin.
#[test]
fn shared_bits_are_rejected() {
    let weights = [1.0, 2.0, 3.0, 4.0];
    let cdf = Cdf::new(&weights).unwrap();
    // Thresholds of the four bins with aliases 3, 3, 2, 3, and the whole word as the coin.
    let thresholds = [0.4, 0.8, 1.0, 1.0].map(|t| (t * 4_294_967_295.0) as u32);
    let aliases = [2, 3, 2, 3];
    let shared = |word: u64| {
        let bin = (word >> 30) as usize;
        if (word as u32) < thresholds[bin] {
            bin
        } else {
            aliases[bin]
        }
    };
    let counted = counts(4, 4, 32, shared);
    let off = (0..4).filter(|&i| counted[i] != u128::from(cdf.numerator(i)));
    assert!(off.count() >= 2);
}
