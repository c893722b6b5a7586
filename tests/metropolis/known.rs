//! Chains of which all can be said: two states in closed form; and chains that are wrong, each in one way, which the
//! checks that the right ones pass see. Stationary distributions and second eigenvalues of small matrices in f64, by squaring
//! them again and again.

use super::balance::{Enumerated, Examined};
use super::enumeration::Words;
use super::integer_chances::ALL;
use super::own::{forgetful, neighbour};
use microwarp::discrete::Cdf;
use microwarp::metropolis::{Independence, Mutation, TransitionTable, UniformIndex};
use num_bigint::BigUint;

pub fn table<const N: usize>(rows: [[f32; N]; N]) -> TransitionTable<[u32; N], N> {
    TransitionTable::new(rows.map(|row| Cdf::<[u32; N]>::new(&row).unwrap())).unwrap()
}

/// T = 1/2 everywhere, f = 9 : 1. M = [[1 - a/2, a/2], [1/2, 1/2]] with a = 1/9, in whole words.
#[test]
fn two_states_have_the_matrix_of_their_closed_form() {
    fn check<W: Examined>(f: [W; 2], ninth: u64) {
        let half = Cdf::<[u32; 2]>::from_integers(&[1, 1]).unwrap();
        for chain in [
            Enumerated::new(&f, &UniformIndex::new(2).unwrap(), &Words::TWO),
            Enumerated::new(&f, &Independence::new(half), &Words::ONE),
            Enumerated::new(&f, &TransitionTable::new([half; 2]).unwrap(), &Words::ONE),
        ] {
            let report = chain.report();
            assert!(report.passes(), "{report:?}");
            let unit = |x: u64| BigUint::from(x) << 95_u32;
            assert_eq!(chain.exact(0, 1), unit(ninth));
            assert_eq!(chain.exact(0, 0), unit((1 << 33) - ninth));
            assert_eq!(chain.exact(1, 0), unit(1 << 32));
            assert_eq!(chain.exact(1, 1), unit(1 << 32));
        }
    }
    // The `f32` nearest to 1/9 is 14913081 2^-27: 9 · 14913081 = 2^27 + 1. And 9 · 477218589 = 2^32 + 5, the next multiple.
    check([9.0_f32, 1.0], 14_913_081 << 5);
    check([9_u32, 1], 477_218_589);
}

#[test]
fn a_chain_that_forgets_its_ratio_is_seen_not_to_be_stationary() {
    let rows = [[0.5, 0.25, 0.25], [0.5, 0.25, 0.25], [0.125, 0.5, 0.375]];
    let f = [1.0_f32, 2.0, 3.0];
    let right = Enumerated::new(&f, &table(rows), &Words::ONE).report();
    assert!(right.passes(), "{right:?}");
    let wrong = Enumerated::new(&f, &forgetful(table(rows)), &Words::ONE).report();
    println!("{wrong:?}");
    // It is a chain, and it converges: to something else.
    assert!(wrong.rows && wrong.converges());
    assert!(wrong.wrong[0] > 0 && !wrong.is_stationary() && !wrong.passes());
    assert!(wrong.stationary > 1e4 && wrong.balance > 1e4);
}

/// Rows of integers, exactly.
pub fn integer_table<const N: usize>(rows: [[u32; N]; N]) -> TransitionTable<[u32; N], N> {
    TransitionTable::new(rows.map(|row| Cdf::<[u32; N]>::from_integers(&row).unwrap())).unwrap()
}

/// All is right, but for a chain that does not converge: its matrix.
fn not_converging<W: Examined, M: Mutation<usize>>(f: &[W], mutation: &M) -> Matrix {
    let chain = Enumerated::new(f, mutation, &Words::ONE);
    let report = chain.report();
    println!("{f:?}: {report:?}");
    assert!(report.is_right());
    assert!(!report.converges() && !report.passes());
    chain.matrix()
}

/// Blocks without a way from one to the other: the eigenvalue 1 comes twice, so that no pause makes it converge.
#[test]
fn a_reducible_chain_is_seen() {
    fn check<W: Examined, M: Mutation<usize>>(f: &[W], mutation: &M) {
        let value = second(&lazy(&not_converging(f, mutation)));
        assert!((value - 1.0).abs() <= 1e-9, "{value}");
    }
    // Nothing that leaves comes back.
    check(&[1.0_f32, 2.0], &table([[0.5, 0.5], [0.0, 1.0]]));
    check(&[1_u32, 2], &integer_table([[1, 1], [0, 1]]));
    // Two blocks, and never a proposal from one to the other.
    let blocks = [
        [0.5, 0.5, 0.0, 0.0],
        [0.25, 0.75, 0.0, 0.0],
        [0.0, 0.0, 0.1, 0.9],
        [0.0, 0.0, 0.5, 0.5],
    ];
    check(&[1.0_f32, 2.0, 3.0, 4.0], &table(blocks));
    let blocks = [[1, 1, 0, 0], [1, 3, 0, 0], [0, 0, 1, 9], [0, 0, 1, 1]];
    check(&[1_u32, 2, 3, 4], &integer_table(blocks));
    // A gap of density 0 that no proposal is wide enough for.
    check(&[1.0_f32, 2.0, 0.0, 3.0, 4.0, 0.0], &neighbour(6));
    check(&[1_u32, 2, 0, 3, 4, 0], &neighbour(6));
    // Valleys whose acceptance is below half a step of the decision word.
    check(&[1.0_f32, 1e-10, 2.0, 1e-11], &neighbour(4));
}

/// T11 = T22 = 0 and every acceptance 1: the eigenvalue -1, of which pauses make a 0.
#[test]
fn a_cyclic_chain_is_seen() {
    fn check<W: Examined, M: Mutation<usize>>(f: &[W], mutation: &M) {
        let chain = Enumerated::new(f, mutation, &Words::ONE);
        assert!(chain.paths.iter().flatten().all(|p| p.accepted == ALL));
        let matrix = not_converging(f, mutation);
        let (value, paused) = (second(&matrix), second(&lazy(&matrix)));
        assert!(
            (value - 1.0).abs() <= 1e-9 && paused <= 0.9,
            "{value} {paused}"
        );
    }
    let (swap, whole) = (
        table([[0.0, 1.0], [1.0, 0.0]]),
        integer_table([[0, 1], [1, 0]]),
    );
    check(&[1.0_f32, 1.0], &swap);
    check(&[1_u32, 1], &whole);
    check(&[7.0_f32; 6], &neighbour(6));
    check(&[u32::MAX; 6], &neighbour(6));
    // A rejection now and then is enough.
    let report = Enumerated::new(&[1.0_f32, 0.999], &swap, &Words::ONE).report();
    assert!(report.passes(), "{report:?}");
    let report = Enumerated::new(&[1_000_000_u32, 999_999], &whole, &Words::ONE).report();
    assert!(report.passes(), "{report:?}");
}

pub type Matrix = Vec<Vec<f64>>;

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut product = vec![vec![0.0; b[0].len()]; a.len()];
    for (row, out) in a.iter().zip(&mut product) {
        for (x, across) in row.iter().zip(b) {
            for (out, y) in out.iter_mut().zip(across) {
                *out += x * y;
            }
        }
    }
    product
}

/// The chain that stays at every other step, and is therefore never periodic.
pub fn lazy(m: &Matrix) -> Matrix {
    let mut lazy = m.clone();
    for (i, row) in lazy.iter_mut().enumerate() {
        row.iter_mut().for_each(|x| *x *= 0.5);
        row[i] += 0.5;
    }
    lazy
}

/// A distribution that the matrix leaves as it is: where the lazy chain ends up from the first state.
pub fn stationary(m: &Matrix) -> Vec<f64> {
    let mut lazy = lazy(m);
    for _ in 0..60 {
        lazy = product(&lazy, &lazy);
        for row in &mut lazy {
            let sum: f64 = row.iter().sum();
            row.iter_mut().for_each(|x| *x /= sum);
        }
    }
    lazy.swap_remove(0)
}

/// The largest magnitude of an eigenvalue but one that is 1, of a matrix whose rows sum to 1.
///
/// Taking 1π away puts a 0 in place of that 1 and leaves all others; the norm of the 2^k-th power then tells
/// the largest.
pub fn second(m: &Matrix) -> f64 {
    let pi = stationary(m);
    let mut power: Matrix = m
        .iter()
        .map(|row| row.iter().zip(&pi).map(|(x, p)| x - p).collect())
        .collect();
    let (mut log_norm, mut exponent) = (0.0, 1.0);
    for _ in 0..40 {
        let norm = power
            .iter()
            .flatten()
            .fold(0.0_f64, |most, x| most.max(x.abs()));
        if norm == 0.0 {
            return 0.0;
        }
        power.iter_mut().flatten().for_each(|x| *x /= norm);
        log_norm += norm.ln() / exponent;
        power = product(&power, &power);
        exponent *= 2.0;
    }
    log_norm.exp()
}

/// Against matrices whose eigenvalues are known, cycles and blocks included.
#[test]
fn second_eigenvalues_are_those_of_known_matrices() {
    // A walk on a ring of n with probability 1/2 either way has the eigenvalues cos(2πk/n).
    for n in [3, 5, 8] {
        let step = |i: usize, j: usize| (i + 1) % n == j || (j + 1) % n == i;
        let ring: Matrix = (0..n)
            .map(|i| (0..n).map(|j| if step(i, j) { 0.5 } else { 0.0 }).collect())
            .collect();
        let exact = (1..n).map(|k| (std::f64::consts::TAU * k as f64 / n as f64).cos().abs());
        let exact = exact.fold(0.0, f64::max);
        assert!((second(&ring) - exact).abs() <= 1e-10, "{n}");
    }
    let two = |a: f64, b: f64| vec![vec![1.0 - a, a], vec![b, 1.0 - b]];
    for (a, b) in [(0.1, 0.9), (1.0, 1.0), (0.0, 0.0), (0.3, 0.001)] {
        let (got, exact) = (second(&two(a, b)), (1.0_f64 - a - b).abs());
        assert!((got - exact).abs() <= 1e-10, "{a} {b}: {got}");
    }
}
