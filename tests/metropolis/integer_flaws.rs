//! Chains of integer weights that are wrong, each in one way: the checks that the right ones pass see it.

use super::balance::Enumerated;
use super::counterexamples::{Forgetful, integer_table as table};
use super::enumeration::{Driven, Path, Words};
use super::integer_balance::Report;
use super::integer_chances::ALL;
use super::matrices::LARGE_INTEGERS as LARGE;
use microwarp::metropolis::{Mutation, TransitionTable, UniformIndex};
use num_bigint::BigUint;

const ROWS: [[u32; 3]; 3] = [[4, 2, 2], [4, 2, 2], [1, 4, 3]];

fn right<M: Mutation<usize>>(f: &[u32], mutation: &M, words: &Words) -> Enumerated<u32> {
    let found = Enumerated::new(f, mutation, words);
    let report = found.report();
    assert!(report.passes(), "{report:?}");
    found
}

#[test]
fn a_chain_of_integers_that_forgets_its_counts_is_seen() {
    let f = [1, 2, 3];
    right(&f, &table(ROWS), &Words::ONE);
    let wrong = Enumerated::new(&f, &Forgetful(table(ROWS)), &Words::ONE).report();
    println!("{wrong:?}");
    // It is a chain, and it converges: to something else.
    assert!(wrong.rows && wrong.converges());
    assert!(wrong.wrong[0] > 0 && !wrong.is_stationary());
    assert!(wrong.stationary > 1e7 && wrong.balance > 1e7);
}

/// The same weights and the same mutation through a float chain.
fn in_floats<M: Mutation<usize>>(f: &[u32], mutation: &M, words: &Words) -> Report {
    let driven = Driven {
        target: |i: usize| f[i] as f32,
        mutation,
        words,
    };
    let said = |path: Path| {
        let words = path.accepted;
        path.saying(|_| words)
    };
    let paths = |i: usize| driven.paths(i).into_iter().map(said).collect();
    Enumerated::of(f, (0..f.len()).map(paths).collect()).report()
}

/// An f32 holds 24 bits of a weight of 32, and a quotient of 24 bits: some hundred words of 2^32.
#[test]
fn an_acceptance_rounded_to_a_float_is_seen() {
    let any = UniformIndex::new(8).unwrap();
    right(&LARGE, &any, &Words::TWO);
    let wrong = in_floats(&LARGE, &any, &Words::TWO);
    println!("{wrong:?}");
    assert!(wrong.rows && wrong.converges());
    assert!(wrong.wrong[0] > 10 && !wrong.is_stationary());
    assert!(wrong.stationary > 10.0);
    // Of small weights, and with a ratio, it is the number of words alone that tells.
    let wrong = in_floats(&[1, 2, 3], &table(ROWS), &Words::ONE);
    println!("{wrong:?}");
    assert!(wrong.wrong[0] > 0 && !wrong.passes());
}

/// The words of each path as another rule would have them.
fn by_another_rule(found: Enumerated<u32>, rule: fn(BigUint, BigUint) -> BigUint) -> Report {
    let f = found.f.clone();
    let paths = (0..f.len()).map(|i| {
        let of = |path: &Path<u64>| {
            let there = found.proposals(path.kind, i, path.to) * f[i];
            let back = found.proposals(path.kind, path.to, i) * f[path.to];
            let words = rule(back << 32_u32, there);
            let words = u64::try_from(words).unwrap_or(ALL).min(ALL);
            Path {
                acceptance: words,
                accepted: words,
                ..path.clone()
            }
        };
        found.paths[i].iter().map(of).collect()
    });
    Enumerated::of(&f, paths.collect()).report()
}

#[test]
fn another_comparison_is_seen() {
    let f = [4, 1, 6, 3];
    let rows = [[2, 1, 1, 1], [4, 3, 2, 1], [1, 1, 1, 1], [9, 1, 5, 1]];
    let mutation: TransitionTable<_, 4> = table(rows);
    let found = || right(&f, &mutation, &Words::ONE);
    let exact = |part, whole: BigUint| (part + &whole - 1_u32) / whole;
    assert!(by_another_rule(found(), exact).passes());
    // U·f·T ≤ 2^32·f'·T': a word more where the quotient is whole, as 4 to 1 by equal ways is.
    let any = UniformIndex::new(4).unwrap();
    let closed = |part: BigUint, whole: BigUint| part / whole + 1_u32;
    let wrong = by_another_rule(right(&f, &any, &Words::TWO), closed);
    assert!(wrong.wrong[0] > 0 && !wrong.passes(), "{wrong:?}");
    // Truncated, as a uniform compared with ≥ would be; and to the nearest.
    let truncated = |part: BigUint, whole: BigUint| part / whole;
    let wrong = by_another_rule(found(), truncated);
    assert!(wrong.wrong[0] > 0 && !wrong.passes(), "{wrong:?}");
    let nearest = |part: BigUint, whole: BigUint| (part * 2_u32 + &whole) / (whole * 2_u32);
    let wrong = by_another_rule(found(), nearest);
    assert!(wrong.wrong[0] > 0 && !wrong.passes(), "{wrong:?}");
    // The inverse ratio.
    let inverse = |part: BigUint, whole: BigUint| {
        let whole: BigUint = whole << 32_u32;
        let quotient = &whole + &part - 1_u32;
        (quotient / part) << 32_u32
    };
    assert!(!by_another_rule(found(), inverse).is_stationary());
}
