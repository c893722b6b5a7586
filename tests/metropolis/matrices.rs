//! Exact transition matrices of the implemented step: each keeps its target stationary, is in detailed balance, and
//! has one eigenvalue of magnitude 1. Of integer weights every acceptance is the exact number of words.

use super::balance::{Enumerated, Examined};
use super::enumeration::Words;
use super::own::neighbour;
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::{
    Independence, LogDensity, Mixture, Mutation, TransitionTable, UniformIndex,
};
use microwarp::tier::{Libm, Poly};
use num_bigint::BigUint;

const MODERATE: [f32; 8] = [3.0, 0.5, 7.25, 1.0, 0.125, 2.0, 5.5, 0.75];
/// From the smallest subnormal to nearly the largest number, and a zero.
const EXTREME: [f32; 8] = [1e-38, 1e38, 1.0, 0.0, 1e-45, 3e38, 2.5e-40, 1e37];
/// Where many a density is a few steps of the decision word.
const STEPPED: [f32; 8] = [1.0, 1e-9, 3e-10, 0.9, 1e-8, 2e-10, 1e-7, 0.3];
const SPREAD: [f32; 8] = [1.0, 9.0, 0.25, 4.0, 0.5, 2.0, 30.0, 0.001];
const LOGS: [f32; 8] = [0.0, -2.5, 1.75, -7.0, 3.125, 0.1, -0.3, 2.0];
const FAR_LOGS: [f32; 8] = [
    -1e4,
    1e4,
    f32::NEG_INFINITY,
    9_999.0,
    9_980.5,
    -88.0,
    1e4,
    9_977.8,
];

const INTEGERS: [u32; 8] = [3, 50, 725, 1, 12, 2, 550, 75];
const EXTREME_INTEGERS: [u32; 8] = [1, u32::MAX, 1 << 31, 0, 3, u32::MAX - 1, 65_537, 1];
pub const LARGE_INTEGERS: [u32; 8] = [
    4_000_000_007,
    u32::MAX,
    2_147_483_659,
    4_294_967_291,
    3_000_000_019,
    0xffff_fffe,
    0x8000_0000,
    0xaaaa_aaab,
];
/// Examines a chain, prints what was found, and demands that it passes.
fn examine<W: Examined, M: Mutation<usize>>(
    name: &str,
    f: &[W],
    mutation: &M,
    words: &Words,
    uneven: u64,
) -> Enumerated<W> {
    let found = Enumerated::new(f, mutation, words);
    let found = Enumerated { uneven, ..found };
    let report = found.report();
    println!("{name}, {f:?}: {report:.3?}");
    assert!(
        report.passes() && report.wrong[1] >= f.len(),
        "{name}, {f:?}: {report:?}"
    );
    found
}

/// A mutation with every kind of target; ways there and back that differ by as many of 2^64 words count as equal.
fn all_targets<M: Mutation<usize>, const N: usize>(
    name: &str,
    mutation: &M,
    words: &Words,
    uneven: u64,
) {
    for f in [&MODERATE, &EXTREME, &STEPPED] {
        examine(name, &f[..N], mutation, words, uneven);
    }
    for logs in [&LOGS, &FAR_LOGS] {
        let libm = logs.map(LogDensity::<Libm>::new);
        examine(name, &libm[..N], mutation, words, uneven);
        let poly = logs.map(LogDensity::<Poly>::new);
        examine(name, &poly[..N], mutation, words, uneven);
    }
    for f in [INTEGERS, EXTREME_INTEGERS, LARGE_INTEGERS] {
        examine(name, &f[..N], mutation, words, uneven);
    }
}

fn first<const N: usize>() -> [f32; N] {
    std::array::from_fn(|i| SPREAD[i])
}

#[test]
fn uniform_indices() {
    fn of<const N: usize>() {
        let mutation = UniformIndex::new(N as u32).unwrap();
        let uneven = u64::from(!N.is_power_of_two());
        let name = format!("UniformIndex({N})");
        all_targets::<_, N>(&name, &mutation, &Words::TWO, uneven);
    }
    of::<2>();
    of::<3>();
    of::<4>();
    of::<5>();
    of::<6>();
    of::<7>();
    of::<8>();
}

#[test]
fn independence_over_tables() {
    fn of<const N: usize>() {
        let (narrow, wide) = (
            Cdf::<[u32; N]>::new(&first()).unwrap(),
            Cdf::<[u64; N]>::new_u64(&first()).unwrap(),
        );
        let named = |of: &str| format!("Independence({of}; {N})");
        all_targets::<_, N>(
            &named("Cdf u32"),
            &Independence::new(narrow),
            &Words::ONE,
            0,
        );
        all_targets::<_, N>(&named("Cdf u64"), &Independence::new(wide), &Words::TWO, 0);
        let narrow_alias = Alias::<[AliasEntry<u32>; 8]>::new::<N>(&first()).unwrap();
        let words = Words::Fraction { bits: 32, parts: 8 };
        let mutation = Independence::new(narrow_alias);
        all_targets::<_, N>(&named("Alias u32"), &mutation, &words, 0);
        let wide_alias = Alias::<[AliasEntry<u64>; 8]>::new_u64::<N>(&first()).unwrap();
        let words = Words::Fraction { bits: 64, parts: 8 };
        let mutation = Independence::new(wide_alias);
        all_targets::<_, N>(&named("Alias u64"), &mutation, &words, 0);
        // What is proposed is what the table states.
        let found = Enumerated::new(&[1.0_f32; N], &mutation, &words);
        for j in 0..N {
            let due = BigUint::from(wide_alias.numerator(j)) << 32_u32;
            assert_eq!(found.proposals(0, 0, j), due);
            assert_eq!(wide_alias.numerator(j), wide.numerator(j));
        }
    }
    of::<2>();
    of::<3>();
    of::<5>();
    of::<8>();
}

/// Rows that differ from their transpose and each from the next; the ring of nonzero entries is whole.
fn rows<const N: usize>() -> [[f32; N]; N] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match (j + N - i) % N {
            0 => 0.0,
            1 => SPREAD[(i + j) % 8] + 1.0,
            k => (SPREAD[(3 * i + j) % 8] + 0.5) / k as f32,
        })
    })
}

fn table<const N: usize>() -> TransitionTable<[u32; N], N> {
    TransitionTable::new(rows().map(|row| Cdf::<[u32; N]>::new(&row).unwrap())).unwrap()
}

fn wide_table<const N: usize>() -> TransitionTable<[u64; N], N> {
    TransitionTable::new(rows().map(|row| Cdf::<[u64; N]>::new_u64(&row).unwrap())).unwrap()
}

#[test]
fn transition_tables() {
    fn of<const N: usize>() {
        let named = |of: &str| format!("TransitionTable({of}; {N})");
        all_targets::<_, N>(&named("u32"), &table::<N>(), &Words::ONE, 0);
        all_targets::<_, N>(&named("u64"), &wide_table::<N>(), &Words::TWO, 0);
    }
    // With two states and none of them staying, there would be no rejection where densities are equal.
    of::<2>();
    of::<3>();
    of::<4>();
    of::<6>();
    of::<8>();
    // Ways of no return, which are never taken, among others.
    let rows = [[0.2, 0.5, 0.3], [0.4, 0.0, 0.6], [0.0, 0.7, 0.3]];
    let rows = rows.map(|row| Cdf::<[u32; 3]>::new(&row).unwrap());
    let one_way = TransitionTable::new(rows).unwrap();
    let found = examine(
        "TransitionTable(one way)",
        &[3.0, 1.0, 2.0],
        &one_way,
        &Words::ONE,
        0,
    );
    assert!(found.proposals(0, 0, 2) > BigUint::ZERO);
    assert_eq!(found.exact(0, 2), BigUint::ZERO);
}

#[test]
fn a_mutation_written_by_a_user() {
    // Not with valleys that the decision word does not resolve: see the counter-examples.
    for (n, f) in [
        (3, &MODERATE),
        (5, &MODERATE),
        (8, &MODERATE),
        (5, &EXTREME),
    ] {
        let name = format!("Neighbour({n})");
        examine(&name, &f[..n], &neighbour(n), &Words::ONE, 0);
    }
    let (libm, poly) = (
        LOGS.map(LogDensity::<Libm>::new),
        LOGS.map(LogDensity::<Poly>::new),
    );
    examine(
        "Neighbour(8), logs, libm",
        &libm,
        &neighbour(8),
        &Words::ONE,
        0,
    );
    examine(
        "Neighbour(8), logs, poly",
        &poly,
        &neighbour(8),
        &Words::ONE,
        0,
    );
}

#[test]
fn mixtures_of_all_of_them() {
    let uniform = UniformIndex::new(5).unwrap();
    let independence = Independence::new(Cdf::<[u64; 5]>::new_u64(&first()).unwrap());

    let both_symmetric = Mixture::new((uniform, neighbour(5)), &[0.3, 0.7]).unwrap();
    let words = Words::Picked(vec![Words::TWO, Words::ONE]);
    all_targets::<_, 5>(
        "Mixture(UniformIndex, Neighbour)",
        &both_symmetric,
        &words,
        1,
    );

    let both_kinds = Mixture::new((neighbour(5), table::<5>()), &[0.6, 0.4]).unwrap();
    let words = Words::Picked(vec![Words::ONE, Words::ONE]);
    all_targets::<_, 5>(
        "Mixture(Neighbour, TransitionTable)",
        &both_kinds,
        &words,
        0,
    );

    let four = (wide_table::<5>(), uniform, independence, neighbour(5));
    let four = Mixture::new(four, &[1.0, 1e-6, 2.0, 3.0]).unwrap();
    let words = Words::Picked(vec![Words::TWO, Words::TWO, Words::TWO, Words::ONE]);
    all_targets::<_, 5>("Mixture of four", &four, &words, 1);

    let other = [[0.1, 0.2, 0.7], [0.3, 0.3, 0.4], [0.8, 0.1, 0.1]];
    let other = other.map(|row| Cdf::<[u32; 3]>::new(&row).unwrap());
    let two = [table::<3>(), TransitionTable::new(other).unwrap()];
    let array = Mixture::new(two, &[0.5, 0.5]).unwrap();
    let words = Words::Picked(vec![Words::ONE, Words::ONE]);
    all_targets::<_, 3>("Mixture of an array", &array, &words, 0);
}
