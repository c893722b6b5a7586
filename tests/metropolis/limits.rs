//! Steps with a limit: never more rejections in a row than it says, and nothing forced that may not be.

use super::own::given;
use host::generators::{Broken, Cycle, Failing};
use microwarp::metropolis::{
    Chain, Chance, HastingsRatio, Outcome, Saved, UniformIndex, UniformStep,
};
use rand_pcg::Pcg32;
use std::num::NonZeroU32;

fn limit(n: u32) -> NonZeroU32 {
    NonZeroU32::new(n).unwrap()
}

/// A peak that is hardly ever left.
fn peak(x: f32) -> f32 {
    if x < 0.01 { 1e12 } else { 1.0 + x }
}

#[test]
fn never_more_rejections_in_a_row_than_the_limit() {
    for most in [1, 2, 7, 100] {
        let mut rng = Pcg32::new(1, most.into());
        let mut chain = Chain::new(0.5, peak).unwrap();
        let (mut forced, mut longest) = (0, 0);
        for _ in 0..20_000 {
            let before = chain;
            let step = chain.step_limited(peak, &UniformStep::new(), limit(most), &mut rng);
            longest = longest.max(chain.rejected_in_a_row());
            assert_eq!(step.proposed_density, peak(step.proposed));
            if step.outcome == Outcome::Forced {
                forced += 1;
                assert_eq!(before.rejected_in_a_row(), most);
                assert_eq!((step.acceptance, step.is_accepted()), (1.0, true));
                assert_eq!(
                    step.recorded(),
                    [(before.state(), 0.0), (step.proposed, 1.0)]
                );
                assert_eq!(
                    (chain.state(), chain.density()),
                    (step.proposed, step.proposed_density)
                );
                assert_eq!(chain.accepted(), before.accepted() + 1);
                assert_eq!(chain.rejected_in_a_row(), 0);
            } else {
                assert!(step.is_accepted() || before.rejected_in_a_row() < most);
            }
        }
        println!("limit {most}: {forced} forced, {longest} rejections in a row");
        assert_eq!(longest, most);
        assert!(forced > 50);
        // Without a limit, they are many more: the peak is left once in 1e12 steps.
        let mut free = Chain::new(0.001, peak).unwrap();
        for _ in 0..1000 {
            let step = free.step(peak, &UniformStep::new(), &mut rng);
            assert_ne!(step.outcome, Outcome::Forced);
        }
        assert!(free.rejected_in_a_row() > most || free.state() != 0.001);
    }
}

/// A peak among holes.
fn holes(x: f32) -> f32 {
    match (x * 64.0) as u32 % 4 {
        0 => peak(x),
        1 => 0.0,
        2 => [f32::NAN, f32::INFINITY, -1.0][(x * 1000.0) as usize % 3],
        _ => -0.0,
    }
}

#[test]
fn what_has_no_density_is_never_forced() {
    let mut rng = Pcg32::new(2, 2);
    let mut chain = Chain::new(0.001, holes).unwrap();
    let (mut forced, mut beyond) = (0, 0);
    for _ in 0..100_000 {
        let before = chain.rejected_in_a_row();
        let step = chain.step_limited(holes, &UniformStep::new(), limit(3), &mut rng);
        let possible = step.proposed_density > 0.0 && step.proposed_density < f32::INFINITY;
        assert!(possible || !step.is_accepted());
        // At the limit, whatever is possible is taken.
        assert!(before < 3 || !possible || step.is_accepted());
        assert!(chain.density() > 0.0);
        forced += u32::from(step.outcome == Outcome::Forced);
        beyond += u32::from(chain.rejected_in_a_row() > 3);
    }
    println!(
        "{forced} forced; beyond the limit after {beyond} steps, for want of anything possible"
    );
    assert!(forced > 1000 && beyond > 1000);
}

fn rejected(times: u32) -> Chain<usize> {
    let saved = Saved {
        state: 0,
        density: 1.0,
        steps: 1 << 40,
        accepted: 0,
        refused: 0,
        rejected_in_a_row: times,
    };
    Chain::resume(saved).unwrap()
}

#[test]
fn a_way_without_return_is_never_forced_and_an_acceptance_of_0_is() {
    let most = limit(5);
    for times in [4, 5, 6, u32::MAX] {
        for (ratio, density, outcome) in [
            (HastingsRatio::new(1.0, 0.0), 1.0, Outcome::Rejected),
            (HastingsRatio::new(0.0, 1.0), 1.0, Outcome::Refused),
            // One that underflows is a way all the same.
            (HastingsRatio::new(f32::MAX, 1e-45), 1.0, Outcome::Forced),
            (HastingsRatio::ONE, 1e-45, Outcome::Forced),
            (HastingsRatio::ONE, 1.0, Outcome::Accepted),
        ] {
            let mut chain = rejected(times);
            let target = |_| density;
            let mut rng = Cycle::new(&[u32::MAX]);
            let step = chain.step_limited(target, &given(1, ratio), most, &mut rng);
            let outcome = match outcome {
                Outcome::Forced if times < 5 => Outcome::Rejected,
                other => other,
            };
            assert_eq!(step.outcome, outcome, "{ratio:?} after {times}");
            let in_a_row = if step.is_accepted() {
                0
            } else {
                times.saturating_add(1)
            };
            assert_eq!(chain.rejected_in_a_row(), in_a_row);
        }
    }
}

/// Of the largest limit nothing is seen, and a step without a limit never forces.
#[test]
fn a_count_that_saturates_forces_nothing() {
    let mut chain = rejected(u32::MAX);
    for _ in 0..3 {
        let step = chain.step(
            |_| 1e-45,
            &given(1, HastingsRatio::ONE),
            &mut Cycle::new(&[u32::MAX]),
        );
        assert_eq!(step.outcome, Outcome::Rejected);
        assert_eq!(chain.rejected_in_a_row(), u32::MAX);
    }
    let mut chain = rejected(u32::MAX - 2);
    let mut step = || {
        let mut rng = Cycle::new(&[u32::MAX]);
        chain.step_limited(
            |_| 1e-45,
            &given(1, HastingsRatio::ONE),
            NonZeroU32::MAX,
            &mut rng,
        )
    };
    assert_eq!(step().outcome, Outcome::Rejected);
    assert_eq!(step().outcome, Outcome::Forced);
}

/// Until the limit is reached, a limited step is a step.
#[test]
fn a_limit_that_is_not_reached_changes_nothing() {
    let f = |x: f32| 1.0 + x;
    let (mut rng, mut again) = (Pcg32::new(3, 3), Pcg32::new(3, 3));
    let mut chain = Chain::new(0.5, f).unwrap();
    let mut limited = chain;
    for _ in 0..10_000 {
        let step = chain.step(f, &UniformStep::new(), &mut rng);
        let other = limited.step_limited(f, &UniformStep::new(), limit(60), &mut again);
        assert_eq!((step, chain), (other, limited));
    }
    assert_eq!(rng, again);
}

#[test]
fn a_failed_limited_step_leaves_no_trace() {
    for left in 0..2 {
        let mut chain = Chain::new(0.001, peak).unwrap();
        chain.step(|_| 0.0, &UniformStep::new(), &mut Cycle::new(&[7]));
        let before = chain;
        let mut failing = Failing {
            word: 1 << 31,
            left,
        };
        let end = chain.try_step_limited(peak, &UniformStep::new(), limit(1), &mut failing);
        assert_eq!((end, chain), (Err(Broken(17)), before));
    }
}

#[test]
fn a_limit_forces_a_chain_of_integers() {
    let peak = |i: usize| [u32::MAX, 1, 0][i];
    let any = UniformIndex::new(3).unwrap();
    let (mut chain, mut rng) = (Chain::new(0, peak).unwrap(), Pcg32::new(3, 3));
    let mut forced = 0;
    for _ in 0..1000 {
        let step = chain.step_limited(peak, &any, limit(4), &mut rng);
        if step.outcome == Outcome::Forced {
            forced += 1;
            assert_eq!((step.state(), step.acceptance.words()), (1, Chance::TOTAL));
            assert_eq!(step.recorded(), [(0, 0), (1, 1 << 32)]);
        }
        let [(_, stays), (_, goes)] = step.recorded();
        assert_eq!(stays + goes, Chance::TOTAL);
        assert!(peak(step.state()) > 0);
    }
    println!("{forced} forced");
    assert!(forced > 10);
}
