//! Chains that are wrong, each in one way: the checks that the right ones pass see it.

use super::balance::Enumerated;
use super::enumeration::Words;
use super::integer_chances::ALL;
use super::matrices::Neighbour;
use super::spectrum::by_rotations;
use microwarp::discrete::Cdf;
use microwarp::metropolis::{Mutation, Proposal, Symmetric, TransitionTable};
use rand_core::TryRng;

pub fn table<const N: usize>(rows: [[f32; N]; N]) -> TransitionTable<[u32; N], N> {
    TransitionTable::new(rows.map(|row| Cdf::<[u32; N]>::new(&row).unwrap())).unwrap()
}

/// Proposes by a table, and says that the way back is as likely.
pub struct Forgetful<const N: usize>(pub TransitionTable<[u32; N], N>);

impl<const N: usize> Mutation<usize> for Forgetful<N> {
    type Correction = Symmetric;

    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: usize,
        rng: &mut R,
    ) -> Result<Proposal<usize, Symmetric>, R::Error> {
        let proposal = self.0.try_propose(from, rng)?;
        Ok(Proposal::new(proposal.state, Symmetric))
    }
}

#[test]
fn a_chain_that_forgets_its_ratio_is_seen_not_to_be_stationary() {
    let rows = [[0.5, 0.25, 0.25], [0.5, 0.25, 0.25], [0.125, 0.5, 0.375]];
    let f = [1.0_f32, 2.0, 3.0];
    let right = Enumerated::new(&f, &table(rows), &Words::ONE).report();
    assert!(right.passes(), "{right:?}");
    let wrong = Enumerated::new(&f, &Forgetful(table(rows)), &Words::ONE).report();
    println!("{wrong:?}");
    // It is a chain, and it converges: to something else.
    assert!(wrong.rows && wrong.converges());
    assert!(!wrong.is_stationary() && !wrong.is_balanced() && !wrong.passes());
    assert!(wrong.stationary > 0.01 && wrong.balance > 1e4);
}

/// Every acceptance between the blocks is 0: the eigenvalue 1 comes twice.
#[test]
fn a_reducible_chain_is_seen() {
    let cases = [
        // Nothing that leaves comes back.
        (
            vec![1.0_f32, 2.0],
            Enumerated::new(&[1.0, 2.0], &table([[0.5, 0.5], [0.0, 1.0]]), &Words::ONE),
        ),
        // Two blocks, and never a proposal from one to the other.
        (
            vec![1.0, 2.0, 3.0, 4.0],
            Enumerated::new(
                &[1.0, 2.0, 3.0, 4.0],
                &table([
                    [0.5, 0.5, 0.0, 0.0],
                    [0.25, 0.75, 0.0, 0.0],
                    [0.0, 0.0, 0.1, 0.9],
                    [0.0, 0.0, 0.5, 0.5],
                ]),
                &Words::ONE,
            ),
        ),
        // A gap of density 0 that no proposal is wide enough for.
        (
            vec![1.0, 2.0, 0.0, 3.0, 4.0, 0.0],
            Enumerated::new(&[1.0, 2.0, 0.0, 3.0, 4.0, 0.0], &Neighbour(6), &Words::ONE),
        ),
        // Valleys whose acceptance is below half a step of the decision word.
        (
            vec![1.0, 1e-10, 2.0, 1e-11],
            Enumerated::new(&[1.0, 1e-10, 2.0, 1e-11], &Neighbour(4), &Words::ONE),
        ),
    ];
    for (f, chain) in cases {
        let report = chain.report();
        println!("{f:?}: {report:?}");
        assert!(report.is_stationary() && report.is_balanced());
        assert!(!report.converges() && !report.passes());
        let values = by_rotations(&chain.matrix());
        let ones = values.iter().filter(|v| (*v - 1.0).abs() <= 1e-9).count();
        assert_eq!(ones, 2, "{values:?}");
    }
}

/// T11 = T22 = 0 and every acceptance 1: the eigenvalue -1.
#[test]
fn a_cyclic_chain_is_seen() {
    let swap = table([[0.0, 1.0], [1.0, 0.0]]);
    for chain in [
        Enumerated::new(&[1.0_f32, 1.0], &swap, &Words::ONE),
        Enumerated::new(&[7.0_f32; 6], &Neighbour(6), &Words::ONE),
    ] {
        assert!(chain.paths.iter().flatten().all(|p| p.accepted == 1 << 32));
        let report = chain.report();
        println!("{report:?}");
        assert!(report.is_stationary() && report.is_balanced());
        assert!(!report.converges() && !report.passes());
        let values = by_rotations(&chain.matrix());
        assert!((values[values.len() - 1] + 1.0).abs() <= 1e-9, "{values:?}");
    }
    // A rejection now and then is enough.
    let report = Enumerated::new(&[1.0_f32, 0.999], &swap, &Words::ONE).report();
    assert!(report.passes(), "{report:?}");
}

/// Rows of integers, exactly.
pub fn integer_table<const N: usize>(rows: [[u32; N]; N]) -> TransitionTable<[u32; N], N> {
    TransitionTable::new(rows.map(|row| Cdf::<[u32; N]>::from_integers(&row).unwrap())).unwrap()
}

/// Blocks without a way from one to the other: the eigenvalue 1 comes twice, and all else is right.
#[test]
fn a_reducible_chain_of_integers_is_seen() {
    let blocks = [[1, 1, 0, 0], [1, 3, 0, 0], [0, 0, 1, 9], [0, 0, 1, 1]];
    let cases = [
        Enumerated::new(&[1, 2], &integer_table([[1, 1], [0, 1]]), &Words::ONE),
        Enumerated::new(&[1, 2, 3, 4], &integer_table(blocks), &Words::ONE),
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
    let swap = integer_table([[0, 1], [1, 0]]);
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
