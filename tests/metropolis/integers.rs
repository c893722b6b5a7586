//! Chains of integer weights beside those of densities: starts, limits, what is recorded; and counts in
//! chains of densities.

use super::acceptance::{positive, step as float_step};
use microwarp::Error;
use microwarp::metropolis::{
    Chain, Chance, HastingsCounts, HastingsRatio, LogDensity, Outcome, Transition, UniformIndex,
    UniformStep,
};
use microwarp::rejection::Failure;
use microwarp::tier::Poly;
use rand_core::Rng as _;
use rand_pcg::Pcg32;
use std::num::NonZeroU32;

const WEIGHTS: [u32; 6] = [5, 0, 1, 40, 0, 12];

fn weight(i: usize) -> u32 {
    WEIGHTS[i]
}

fn any() -> UniformIndex {
    UniformIndex::new(6).unwrap()
}

#[test]
fn a_chain_of_integers_starts_where_the_weight_is_positive() {
    for (i, &w) in WEIGHTS.iter().enumerate() {
        let chain = Chain::new(i, weight);
        match w {
            0 => assert_eq!(chain, Err(Error::NotPositive(1))),
            _ => assert_eq!(chain.map(|c| (c.state(), c.density())), Ok((i, w))),
        }
    }
    let mut rng = Pcg32::new(1, 1);
    let found = Chain::search(weight, &any(), 1000, &mut rng).unwrap();
    assert!(weight(found.state()) > 0 && found.density() == weight(found.state()));
    let nowhere = Chain::search(|_: usize| 0, &any(), 9, &mut rng);
    assert_eq!(nowhere.err(), Some(Failure::BudgetSpent { tries: 9 }));
}

#[test]
fn a_limit_forces_a_chain_of_integers() {
    let peak = |i: usize| [u32::MAX, 1, 0][i];
    let any = UniformIndex::new(3).unwrap();
    let limit = NonZeroU32::new(4).unwrap();
    let (mut chain, mut rng) = (Chain::new(0, peak).unwrap(), Pcg32::new(3, 3));
    let mut forced = 0;
    for _ in 0..1000 {
        let step = chain.step_limited(peak, &any, limit, &mut rng);
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

/// In a chain of densities, counts are the ratio that they are in floating point, to the last bit.
#[test]
fn counts_in_a_chain_of_densities_are_their_ratio() {
    let mut rng = Pcg32::new(6, 6);
    for _ in 0..200_000 {
        let any = |rng: &mut Pcg32| u128::from(rng.next_u64() >> (rng.next_u32() % 64));
        let (forward, backward) = (any(&mut rng), any(&mut rng));
        let counts = HastingsCounts::new(forward, backward);
        let ratio = HastingsRatio::from_counts(forward, backward);
        assert_eq!(counts.ratio(), ratio);
        let (from, to, word) = (positive(&mut rng), positive(&mut rng), rng.next_u32());
        let bits = |s: Transition<usize>| (s.acceptance.to_bits(), s.outcome);
        assert_eq!(
            bits(float_step(from, to, counts, word)),
            bits(float_step(from, to, ratio, word))
        );
        let log = |x: f32| LogDensity::<Poly>::new(x.ln());
        assert_eq!(
            float_step(log(from), log(to), counts, word)
                .acceptance
                .to_bits(),
            float_step(log(from), log(to), ratio, word)
                .acceptance
                .to_bits()
        );
    }
}

/// States need not be indices.
#[test]
fn a_target_of_integers_may_have_any_states() {
    let steps = |x: f32| (x * 5.0) as u32;
    let (mut chain, mut rng) = (Chain::new(0.9, steps).unwrap(), Pcg32::new(7, 7));
    let mut seen = [0_u32; 5];
    for _ in 0..10_000 {
        chain.step(steps, &UniformStep::new(), &mut rng);
        seen[steps(chain.state()) as usize] += 1;
    }
    assert!(
        seen[0] == 0 && seen[1..].iter().all(|n| *n > 500),
        "{seen:?}"
    );
}
