//! What is asked of the transition matrix of a chain of integer weights: the exact number of accepting words on
//! every path, stationarity and detailed balance to the steps of 2^-32. Chains that are wrong, each in one way, are
//! seen by it.

use super::balance::{Enumerated, Examined, Report};
use super::enumeration::{Driven, Path, TOTAL_BITS, Words, rounded};
use super::integer_chances::{ALL, ceiling};
use super::known::integer_table as table;
use super::known::second;
use super::matrices::LARGE_INTEGERS as LARGE;
use super::own::forgetful;
use microwarp::metropolis::{Mutation, TransitionTable, UniformIndex};
use num_bigint::BigUint;

/// A quotient of large numbers, of which the divisor may be 0.
fn over(x: &BigUint, y: &BigUint) -> f64 {
    match *x == BigUint::ZERO {
        true => 0.0,
        false => rounded(x) / rounded(y),
    }
}

fn difference(x: BigUint, y: BigUint) -> BigUint {
    if x > y { x - y } else { y - x }
}

impl Enumerated<u32> {
    /// The words that must accept a path: its ways there and back are those that were counted.
    fn due(&self, i: usize, path: &Path) -> u64 {
        let there = self.proposals(path.kind, i, path.to);
        let back = self.proposals(path.kind, path.to, i);
        let uneven = BigUint::from(self.uneven) << 32_u32;
        let (there, back) = match difference(there.clone(), back.clone()) <= uneven {
            true => (BigUint::from(1_u32), BigUint::from(1_u32)),
            false => (there, back),
        };
        ceiling(back * self.f[path.to], &(there * self.f[i]))
    }
}

impl Examined for u32 {
    fn examine(chain: &Enumerated<Self>) -> Report {
        let n = chain.f.len();
        let one = BigUint::from(1_u32) << TOTAL_BITS;
        let mut wrong = [0, 0];
        for i in 0..n {
            for path in &chain.paths[i] {
                let due = chain.due(i, path);
                let right = path.accepted == due && path.acceptance == due;
                wrong[0] += usize::from(!right);
                wrong[1] += 1;
            }
        }
        // The flow from i to j, in units of 2^-128, and what may be off: less than a word of 2^32 of what is
        // proposed either way, and the uneven parts.
        let flow = |i: usize, j: usize| chain.exact(i, j) * chain.f[i];
        let granted = |i: usize, j: usize| {
            let proposed = |i: usize, j: usize| -> BigUint {
                let to = chain.paths[i].iter().filter(|p| p.to == j);
                to.map(|p| &p.proposals).sum()
            };
            let uneven = BigUint::from(chain.uneven) << 64_u32;
            (proposed(i, j) + &uneven) * chain.f[i] + (proposed(j, i) + &uneven) * chain.f[j]
        };
        let (mut stationary, mut balance) = (0.0_f64, 0.0_f64);
        for j in 0..n {
            let arriving: BigUint = (0..n).map(|i| flow(i, j)).sum();
            let allowed: BigUint = (0..n).filter(|i| *i != j).map(|i| granted(i, j)).sum();
            let off = difference(arriving, &one * chain.f[j]);
            stationary = stationary.max(over(&off, &allowed));
            for i in 0..j {
                let off = difference(flow(i, j), flow(j, i));
                balance = balance.max(over(&off, &granted(i, j)));
            }
        }
        Report {
            rows: chain.rows_sum_to_one(),
            wrong,
            stationary,
            balance,
            second: second(&chain.matrix()),
        }
    }
}

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
    let wrong = Enumerated::new(&f, &forgetful(table(ROWS)), &Words::ONE).report();
    println!("{wrong:?}");
    // It is a chain, and it converges: to something else.
    assert!(wrong.rows && wrong.converges());
    assert!(wrong.wrong[0] > 0 && !wrong.is_stationary());
    assert!(wrong.stationary > 1e7 && wrong.balance > 1e7);
}

/// The same weights and the same mutation through a float chain.
fn in_floats<M: Mutation<usize>>(f: &[u32], mutation: &M, words: &Words) -> Report {
    let driven = Driven::new(|i| f[i] as f32, mutation, words);
    let said = |path: Path| Path {
        acceptance: path.accepted,
        ..path
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
        let of = |path: &Path| {
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
