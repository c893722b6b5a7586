//! Two states, where all can be said in closed form.

use super::balance::Enumerated;
use super::enumeration::Words;
use super::integer_chances::ALL;
use microwarp::discrete::Cdf;
use microwarp::metropolis::{Independence, Mutation, TransitionTable, UniformIndex};
use num_bigint::BigUint;

/// Nine to one.
const F: [f32; 2] = [9.0, 1.0];

fn table(weights: [f32; 2]) -> Cdf<[u32; 2]> {
    Cdf::<[u32; 2]>::new(&weights).unwrap()
}

fn acceptance(chain: &Enumerated<f32>, from: usize, to: usize) -> f32 {
    let all: Vec<f32> = chain.paths[from]
        .iter()
        .filter(|p| p.to == to)
        .map(|p| f32::from_bits(p.acceptance as u32))
        .collect();
    assert_eq!(all.len(), 1, "one way from {from} to {to}");
    all[0]
}

/// The `f32` nearest to 1/9 is 14913081 2^-27: 9 · 14913081 = 2^27 + 1.
const NINTH: u64 = 14_913_081;

/// T = 1/2 everywhere.
#[test]
fn the_first_binary_example_is_exact() {
    assert_eq!(9 * NINTH, (1 << 27) + 1);
    fn check<M: Mutation<usize>>(mutation: &M, words: &Words) {
        let chain = Enumerated::new(&F, mutation, words);
        assert!(chain.report().passes());
        assert_eq!(
            f64::from(acceptance(&chain, 0, 1)) * 2_f64.powi(27),
            NINTH as f64
        );
        for (from, to) in [(0, 0), (1, 0), (1, 1)] {
            assert_eq!(acceptance(&chain, from, to), 1.0);
        }
        // M = [[1 - a/2, a/2], [1/2, 1/2]] in units of 2^-128, of which a is NINTH 2^-27.
        let unit = |x: u64, bits: u32| BigUint::from(x) << bits;
        assert_eq!(chain.exact(0, 1), unit(NINTH, 100));
        assert_eq!(chain.exact(0, 0), unit((1 << 28) - NINTH, 100));
        assert_eq!(chain.exact(1, 0), unit(1, 127));
        assert_eq!(chain.exact(1, 1), unit(1, 127));
    }
    check(&UniformIndex::new(2).unwrap(), &Words::TWO);
    let half = table([1.0, 1.0]);
    check(&Independence::new(half), &Words::ONE);
    check(&TransitionTable::new([half, half]).unwrap(), &Words::ONE);
}

/// T is f, normalised: 9/10 and 1/10, from either state.
#[test]
fn the_second_binary_example_accepts_everything() {
    fn check<M: Mutation<usize>>(mutation: &M) {
        let chain = Enumerated::new(&F, mutation, &Words::ONE);
        assert!(chain.report().passes());
        for (from, to) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            assert_eq!(acceptance(&chain, from, to), 1.0);
        }
        // So M is T, to the word, which is 9/10 and 1/10 to less than a step of the table.
        for (from, to) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let words = chain.proposals(0, from, to);
            assert_eq!(chain.exact(from, to), &words << 32_u32);
            let (ten, due) = (words * 10_u32, BigUint::from([9_u32, 1][to]) << 96_u32);
            let off = if ten > due { &ten - &due } else { &due - &ten };
            assert!(off < BigUint::from(10_u32) << 64_u32);
        }
    }
    let pmf = table([9.0, 1.0]);
    check(&Independence::new(pmf));
    check(&TransitionTable::new([pmf, pmf]).unwrap());
}

/// A script prints T = 8/9, 1/9 for the second example with f = (9, 1), and acceptances of 1. That T is not
/// f/10, and the acceptance of a -> b under it is (1 · 8/9)/(9 · 1/9) = 8/9.
#[test]
fn the_misprinted_second_example_does_not_accept_everything() {
    let pmf = table([8.0, 1.0]);
    for chain in [
        Enumerated::new(&F, &Independence::new(pmf), &Words::ONE),
        Enumerated::new(&F, &TransitionTable::new([pmf, pmf]).unwrap(), &Words::ONE),
    ] {
        assert!(chain.report().passes());
        let a = f64::from(acceptance(&chain, 0, 1));
        // 2 ulp, and the parts of 2^32 which 8/9 and 1/9 are not.
        assert!((a - 8.0 / 9.0).abs() <= 2.0 * 2_f64.powi(-24) + 1e-8, "{a}");
        for (from, to) in [(0, 0), (1, 0), (1, 1)] {
            assert_eq!(acceptance(&chain, from, to), 1.0);
        }
    }
}

/// T = 1/2 everywhere, f = 9 : 1. M = [[1 - a/2, a/2], [1/2, 1/2]] with a = 1/9, in whole words.
#[test]
fn the_first_binary_example_is_exact_in_integers() {
    fn check<M: Mutation<usize>>(mutation: &M, words: &Words) {
        let chain = Enumerated::new(&[9, 1], mutation, words);
        let report = chain.report();
        assert!(report.passes(), "{report:?}");
        let unit = |x: u64, bits: u32| BigUint::from(x) << bits;
        // 9 · 477218589 = 2^32 + 5, which is the next multiple.
        const NINTH: u64 = 477_218_589;
        assert_eq!((9 * NINTH, 5), (ALL + 5, 9 - ALL % 9));
        assert_eq!(chain.exact(0, 1), unit(NINTH, 95));
        assert_eq!(chain.exact(0, 0), unit((1 << 33) - NINTH, 95));
        assert_eq!(chain.exact(1, 0), unit(1, 127));
        assert_eq!(chain.exact(1, 1), unit(1, 127));
    }
    check(&UniformIndex::new(2).unwrap(), &Words::TWO);
    let half = Cdf::<[u32; 2]>::from_integers(&[1, 1]).unwrap();
    check(&Independence::new(half), &Words::ONE);
    check(&TransitionTable::new([half; 2]).unwrap(), &Words::ONE);
}

/// T is f, normalised, to less than a word either way: 10 words of 2^32 in proportion to the smaller one, so that
/// all but 20 words accept. Where T is f to the last word, all do.
#[test]
fn the_second_binary_example_accepts_everything_in_integers() {
    for (f, least) in [([9, 1], ALL - 20), ([3, 1], ALL), ([1, u32::MAX], ALL)] {
        let table = Cdf::<[u32; 2]>::from_integers(&f).unwrap();
        let mutations = [
            Enumerated::new(&f, &Independence::new(table), &Words::ONE),
            Enumerated::new(&f, &TransitionTable::new([table; 2]).unwrap(), &Words::ONE),
        ];
        for chain in mutations {
            let report = chain.report();
            assert!(report.passes(), "{report:?}");
            let accepted: Vec<u64> = chain.paths.iter().flatten().map(|p| p.accepted).collect();
            assert_eq!(accepted.len(), 4);
            assert!(accepted.iter().all(|a| *a >= least), "{f:?}: {accepted:?}");
        }
    }
}
