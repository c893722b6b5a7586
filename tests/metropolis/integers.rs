//! Chains of integer weights beside those of densities: starts, limits, words, saving; what is recorded; and
//! counts in chains of densities.

use super::acceptance::{Given, positive, step as float_step};
use super::balance::Enumerated;
use super::enumeration::Words;
use super::stated::stated;
use host::speed;
use host::stats::{chi_square, threshold};
use microwarp::discrete::{Alias, AliasEntry, Cdf};
use microwarp::metropolis::{
    Chain, Chance, HastingsCounts, HastingsRatio, Independence, LogDensity, Mixture, Mutation,
    Outcome, Saved, Symmetric, Transition, TransitionTable, UniformIndex, UniformStep,
};
use microwarp::rejection::Failure;
use microwarp::tier::Poly;
use microwarp::{Error, poly};
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
            0 => assert_eq!(chain, Err(Error::NotPositive)),
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
fn a_chain_of_integers_is_resumed_and_burns_in_as_any() {
    let (mut chain, mut rng) = (Chain::new(0, weight).unwrap(), Pcg32::new(2, 2));
    for _ in 0..300 {
        chain.step(weight, &any(), &mut rng);
    }
    let saved = chain.save();
    let refused = |saved| Chain::resume(saved).err();
    let density = 0;
    assert_eq!(
        refused(Saved { density, ..saved }),
        Some(Error::NotPositive)
    );
    let accepted = saved.steps + 1;
    assert_eq!(
        refused(Saved { accepted, ..saved }),
        Some(Error::OutOfRange)
    );
    chain.burn_in(weight, &any(), 5, &mut rng);
    assert_eq!((chain.steps(), chain.accepted()), (0, 0));
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
        assert!(peak(step.state()) > 0);
    }
    println!("{forced} forced");
    assert!(forced > 10);
}

/// Sixty steps apart, states are as good as independent, by the second eigenvalue.
#[test]
fn states_of_a_chain_of_integers_have_their_weights() {
    const APART: u32 = 60;
    let states = speed::of("states", 10_000, 100_000);
    let rows = [7, 1, 9, 2, 8, 3].map(|k| {
        let row = std::array::from_fn(|j| (k * (j as u32 + 2)) % 13 + 1);
        Cdf::<[u32; 6]>::from_integers(&row).unwrap()
    });
    let pick = Cdf::<[u32; 2]>::from_integers(&[1, 1]).unwrap();
    let mutation = Mixture::from_table((any(), TransitionTable::new(rows).unwrap()), pick);
    let words = Words::Picked(vec![Words::TWO, Words::ONE]);
    let [second, _] = Enumerated::new(&WEIGHTS, &mutation, &words).second();
    assert!(second.powi(APART as i32) <= 1e-4, "{second}");
    let run = |f: [u32; 6], seed: u64| {
        let target = |i: usize| f[i];
        let (mut chain, mut rng) = (Chain::new(0, target).unwrap(), Pcg32::new(seed, 5));
        let (mut seen, mut recorded) = ([0_u64; 6], [0_u64; 6]);
        for _ in 0..states {
            for _ in 0..APART {
                let step = chain.step(target, &mutation, &mut rng);
                assert_eq!(step.recorded()[0].1 + step.recorded()[1].1, Chance::TOTAL);
                for (state, words) in step.recorded() {
                    recorded[state] += words >> 8;
                }
            }
            seen[chain.state()] += 1;
        }
        let total: f64 = WEIGHTS.iter().copied().map(f64::from).sum();
        let share = WEIGHTS.map(|w| f64::from(w) / total);
        let due = share.map(|s| s * states as f64);
        let all = (states * APART as usize) as f64 * 2_f64.powi(24);
        for (words, share) in recorded.iter().zip(share) {
            // Loosely: how exactly the weights are kept is said by the matrices.
            assert!(f != WEIGHTS || (*words as f64 / all - share).abs() <= 0.01);
        }
        chi_square(&seen, &due).map_or(0.0, |(_, _, p)| p)
    };
    let p = [run(WEIGHTS, 1), run(WEIGHTS.map(|w| w * 90_000_000), 2)];
    println!("p {p:.3?}");
    assert!(p.iter().all(|p| *p >= threshold(2)));
    // One weight off by a fifth, or three; a weight of 0 that is none.
    let off = [
        run([speed::of("for 5", 8, 6), 0, 1, 40, 0, 12], 3),
        run([5, 1, 1, 40, 0, 12], 4),
    ];
    println!("off: p {off:?}");
    assert!(off.iter().all(|p| *p < threshold(2)));
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

/// A mixture states as little as its parts do.
#[test]
fn mixtures_of_counts_stay_counts() {
    fn is<M: Mutation<X, Correction = C>, X, C: microwarp::metropolis::HastingsCorrection>(
        _: &M,
        _: C,
    ) {
    }
    let counts = HastingsCounts::new(1, 1);
    let row = Cdf::<[u32; 2]>::from_integers(&[1, 2]).unwrap();
    let bins = Alias::<[AliasEntry<u64>; 2]>::from_integers_u64(&[1, 2]).unwrap();
    let (cdf, alias) = (Independence::new(row), Independence::new(bins));
    let rows = TransitionTable::new([row; 2]).unwrap();
    let index = UniformIndex::new(2).unwrap();
    is(&cdf, counts);
    is(&alias, counts);
    is(&rows, counts);
    is(&Independence::new(index), counts);
    is(&Mixture::from_table((index, index), row), Symmetric);
    is(&Mixture::from_table((index, cdf), row), counts);
    is(&Mixture::from_table((alias, index), row), counts);
    is(&Mixture::from_table((rows, alias), row), counts);
    let given = Given(HastingsRatio::ONE);
    is(&Mixture::from_table((&given, cdf), row), HastingsRatio::ONE);
    is(&Mixture::from_table((cdf, &given), row), HastingsRatio::ONE);
    is(
        &Mixture::from_table((index, &given), row),
        HastingsRatio::ONE,
    );
    let warp = Independence::new(poly::Disk::new());
    is::<_, [f32; 2], _>(&warp, HastingsRatio::ONE);
    is::<_, f32, _>(&Independence::new(UniformStep::new()), HastingsRatio::ONE);
}

#[test]
#[cfg(target_pointer_width = "64")]
fn chains_of_integers_are_as_large_as_stated() {
    const SOURCE: &str = include_str!("../../src/metropolis/chain.rs");
    fn check<X>(column: usize) {
        for (row, size) in [
            ("[`Chain`], [`Saved`]", size_of::<Chain<X, u32>>()),
            ("[`Chain`], [`Saved`]", size_of::<Saved<X, u32>>()),
            (
                "of integer weights",
                size_of::<Transition<X, u32, Chance>>(),
            ),
        ] {
            assert_eq!(stated(SOURCE, row, column), size as f64, "{row} {column}");
        }
    }
    check::<f32>(1);
    check::<[f32; 2]>(2);
    check::<[f32; 32]>(3);
    check::<usize>(4);
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
