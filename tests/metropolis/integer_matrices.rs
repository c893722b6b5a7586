//! Exact transition matrices of chains of integer weights: every acceptance is the exact number of words, and
//! the weights are stationary and in detailed balance to the steps of 2^-32.

use super::balance::Enumerated;
use super::enumeration::Words;
use super::integer_chances::ALL;
use super::matrices::Neighbour;
use super::spectrum::by_rotations;
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::{Independence, Mixture, Mutation, TransitionTable, UniformIndex};
use num_bigint::BigUint;

const MODERATE: [u32; 8] = [3, 50, 725, 1, 12, 2, 550, 75];
const EXTREME: [u32; 8] = [1, u32::MAX, 1 << 31, 0, 3, u32::MAX - 1, 65_537, 1];
pub const LARGE: [u32; 8] = [
    4_000_000_007,
    u32::MAX,
    2_147_483_659,
    4_294_967_291,
    3_000_000_019,
    0xffff_fffe,
    0x8000_0000,
    0xaaaa_aaab,
];
const TARGETS: [(&str, [u32; 8]); 3] = [
    ("moderate", MODERATE),
    ("extreme", EXTREME),
    ("large", LARGE),
];

/// A mutation with every kind of target.
fn all_targets<M: Mutation<usize>, const N: usize>(
    name: &str,
    mutation: &M,
    words: &Words,
    uneven: u64,
) {
    for (target, f) in TARGETS {
        let found = Enumerated::new(&f[..N], mutation, words);
        let report = Enumerated { uneven, ..found }.report();
        println!("{name}, {target}: {report:.3?}");
        assert!(report.passes(), "{name}, {target}: {report:?}");
        assert!(report.wrong[1] >= N);
    }
}

/// Rows that differ from their transpose and each from the next.
fn rows<const N: usize>() -> [[u32; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| ((7 * i + 3 * j * j + i * j) % 11 + 1) as u32))
}

#[test]
fn uniform_indices_keep_the_weights() {
    fn of<const N: usize>() {
        let mutation = UniformIndex::new(N as u32).unwrap();
        let uneven = u64::from(!N.is_power_of_two());
        all_targets::<_, N>(
            &format!("UniformIndex({N})"),
            &mutation,
            &Words::TWO,
            uneven,
        );
    }
    of::<2>();
    of::<3>();
    of::<5>();
    of::<8>();
}

#[test]
fn tables_keep_the_weights() {
    fn of<const N: usize>() {
        let weights: [u32; N] = std::array::from_fn(|i| (i * i + 2) as u32);
        let named = |of: &str| format!("{of}, {N}");
        let narrow = Independence::new(Cdf::<[u32; N]>::from_integers(&weights).unwrap());
        all_targets::<_, N>(&named("Independence(Cdf u32)"), &narrow, &Words::ONE, 0);
        let wide = Independence::new(Cdf::<[u64; N]>::from_integers(&weights).unwrap());
        all_targets::<_, N>(&named("Independence(Cdf u64)"), &wide, &Words::TWO, 0);
        let alias = Alias::<[AliasEntry<u32>; 8]>::from_integers(&weights).unwrap();
        let words = Words::Fraction { bits: 32, parts: 8 };
        let alias = Independence::new(alias);
        all_targets::<_, N>(&named("Independence(Alias u32)"), &alias, &words, 0);
        let alias = Alias::<[AliasEntry<u64>; 8]>::from_integers(&weights).unwrap();
        let words = Words::Fraction { bits: 64, parts: 8 };
        let alias = Independence::new(alias);
        all_targets::<_, N>(&named("Independence(Alias u64)"), &alias, &words, 0);
        let narrow = rows::<N>().map(|row| Cdf::<[u32; N]>::from_integers(&row).unwrap());
        let narrow = TransitionTable::new(narrow).unwrap();
        all_targets::<_, N>(&named("TransitionTable(u32)"), &narrow, &Words::ONE, 0);
        let wide = rows::<N>().map(|row| Cdf::<[u64; N]>::from_integers(&row).unwrap());
        let wide = TransitionTable::new(wide).unwrap();
        all_targets::<_, N>(&named("TransitionTable(u64)"), &wide, &Words::TWO, 0);
    }
    of::<2>();
    of::<3>();
    of::<6>();
}

#[test]
fn mixtures_keep_the_weights() {
    let pick = Cdf::<[u32; 2]>::from_integers(&[3, 1]).unwrap();
    let symmetric = Mixture::from_table((UniformIndex::new(4).unwrap(), Neighbour(4)), pick);
    let words = Words::Picked(vec![Words::TWO, Words::ONE]);
    all_targets::<_, 4>("Mixture(UniformIndex, Neighbour)", &symmetric, &words, 0);
    let rows = rows::<4>().map(|row| Cdf::<[u32; 4]>::from_integers(&row).unwrap());
    let rows = TransitionTable::new(rows).unwrap();
    let both = Mixture::from_table((Neighbour(4), rows), pick);
    let words = Words::Picked(vec![Words::ONE, Words::ONE]);
    all_targets::<_, 4>("Mixture(Neighbour, TransitionTable)", &both, &words, 0);
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

pub fn table<const N: usize>(rows: [[u32; N]; N]) -> TransitionTable<[u32; N], N> {
    TransitionTable::new(rows.map(|row| Cdf::<[u32; N]>::from_integers(&row).unwrap())).unwrap()
}

/// Blocks without a way from one to the other: the eigenvalue 1 comes twice, and all else is right.
#[test]
fn a_reducible_chain_of_integers_is_seen() {
    let blocks = [[1, 1, 0, 0], [1, 3, 0, 0], [0, 0, 1, 9], [0, 0, 1, 1]];
    let cases = [
        Enumerated::new(&[1, 2], &table([[1, 1], [0, 1]]), &Words::ONE),
        Enumerated::new(&[1, 2, 3, 4], &table(blocks), &Words::ONE),
        Enumerated::new(&[1, 2, 0, 3, 4, 0], &Neighbour(6), &Words::ONE),
    ];
    for chain in cases {
        let report = chain.report();
        assert!(report.rows && report.wrong[0] == 0 && report.is_stationary());
        assert!(!report.converges() && !report.passes(), "{report:?}");
        let values = by_rotations(&chain.matrix());
        let ones = values.iter().filter(|v| (*v - 1.0).abs() <= 1e-9).count();
        assert_eq!(ones, 2, "{values:?}");
    }
}

/// T11 = T22 = 0 and every acceptance 1: the eigenvalue −1.
#[test]
fn a_cyclic_chain_of_integers_is_seen() {
    let swap = table([[0, 1], [1, 0]]);
    for chain in [
        Enumerated::new(&[1, 1], &swap, &Words::ONE),
        Enumerated::new(&[u32::MAX; 6], &Neighbour(6), &Words::ONE),
    ] {
        assert!(chain.paths.iter().flatten().all(|p| p.accepted == ALL));
        let report = chain.report();
        assert!(report.rows && report.wrong[0] == 0 && report.is_stationary());
        assert!(!report.converges() && !report.passes(), "{report:?}");
        let values = by_rotations(&chain.matrix());
        assert!((values[values.len() - 1] + 1.0).abs() <= 1e-9, "{values:?}");
    }
    // A rejection now and then is enough.
    let report = Enumerated::new(&[1_000_000, 999_999], &swap, &Words::ONE).report();
    assert!(report.passes(), "{report:?}");
}
