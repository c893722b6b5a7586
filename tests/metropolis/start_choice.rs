//! Which candidate starts a chain: its exact probability, by the words that choose it. And the search for a
//! first state, and what both refuse.

use crate::start_weights::Listed;
use host::generators::{Counting, Cycle};
use host::words::first_without;
use microwarp::metropolis::{Chain, LogDensity, TargetDensity};
use microwarp::rejection::Failure;
use microwarp::tier::{Libm, Poly, Tier};
use rand_pcg::Pcg32;

/// How many of all 2³² words let candidate j, the last one, take the place of the one held. The words that
/// do are those below a border.
fn words_that_choose<D: TargetDensity>(weights: &[D], states: &[usize]) -> u64 {
    let pdf = vec![1.0; weights.len()];
    let chosen = |word: u32| {
        let mut words: Vec<u32> = Vec::new();
        for (place, &state) in states.iter().enumerate() {
            let last = place + 1 == states.len();
            words.extend([state as u32, if last { word } else { u32::MAX }]);
        }
        // Told apart by place, not by index: the state of a candidate says which one it is.
        let mut calls = 0;
        let target = |state: usize| {
            calls += 1;
            weights[state]
        };
        let count = states.len() as u32;
        let start = Chain::resample(
            target,
            &Listed { pdf: &pdf },
            count,
            &mut Cycle::new(&words),
        );
        assert_eq!(calls, count);
        start.is_ok_and(|s| s.chain.state() == states[states.len() - 1])
    };
    first_without(0..1 << 32, |word| chosen(word as u32))
}

/// The probability of each candidate to be the start.
fn probabilities<D: TargetDensity>(weights: &[D]) -> Vec<f64> {
    let states: Vec<usize> = (0..weights.len()).collect();
    let taken: Vec<f64> = (1..=weights.len())
        .map(|count| words_that_choose(weights, &states[..count]) as f64 / 2_f64.powi(32))
        .collect();
    (0..weights.len())
        .map(|i| taken[i] * taken[i + 1..].iter().map(|t| 1.0 - t).product::<f64>())
        .collect()
}

#[test]
fn each_candidate_is_chosen_in_proportion_to_its_weight() {
    let lists: [&[f32]; 7] = [
        &[3.0],
        &[1.0, 1.0],
        &[1.0; 8],
        &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0],
        &[8.0, 0.7, 0.3, 1.1, 0.0, 5.0, 0.01, 3.0],
        &[1e-38, 1e38, 1.0, 2e38, 1e-30, 1.0, 1e37, 3e38],
        &[1e-45, 3e-45, 1e-44, 1e-43, 1e-42, 1e-41, 1e-40, 1e-39],
    ];
    for weights in lists {
        let total: f64 = weights.iter().map(|w| f64::from(*w)).sum();
        let found = probabilities(weights);
        let mut worst = 0.0_f64;
        for (p, w) in found.iter().zip(weights) {
            worst = worst.max((p - f64::from(*w) / total).abs());
        }
        let sum = found.iter().sum::<f64>() - 1.0;
        println!(
            "{weights:?}: off by {:.2} · 2⁻²⁴, sum by {sum:.1e}",
            worst * 16_777_216.0
        );
        // Of each candidate the weight, the sum and their quotient are rounded, to 2⁻²⁴ of at most 1, and the
        // word to 2⁻³³.
        let bound = weights.len() as f64 * (3.0 * 2_f64.powi(-24) + 2_f64.powi(-33));
        assert!(worst <= bound, "{weights:?}: {found:?}");
        assert!(sum.abs() <= 1e-12);
    }
}

/// The control: candidates taken with 1/count, whatever their weights, are not so chosen.
#[test]
fn the_proportion_is_seen_to_be_missed() {
    let weights = [1.0, 2.0, 3.0, 4.0_f64];
    let found = probabilities(&[1.0_f32; 4]);
    assert!((found[0] - weights[0] / 10.0).abs() > 0.1);
}

/// However far the logarithms are from 0 or from one another.
#[test]
fn candidates_are_chosen_by_logarithms_of_any_size() {
    fn check<T: Tier>(shift: f32, spacing: f32) {
        let logs = [shift, shift + spacing].map(LogDensity::<T>::new);
        let due = 1.0 / (1.0 + f64::exp(-f64::from(spacing)));
        let bound = 8.0 * 2_f64.powi(-24);
        let [rising, falling] = [probabilities(&logs), probabilities(&[logs[1], logs[0]])];
        for found in [rising[1], falling[0]] {
            assert!(
                (found - due).abs() <= bound,
                "{shift:e} {spacing:e}: {found} for {due}"
            );
        }
        // The control: logarithms that count as equal are chosen alike.
        assert!((probabilities(&[logs[0]; 2])[1] - due).abs() > 0.2);
    }
    for (shift, spacing) in [
        (0.0, 1.0),
        (1e4, 1.0),
        (-1e6, 1.0),
        (3e9, 256.0),
        (-3e9, 512.0),
        (-1e30, 1e29),
        (1e38, 2e38),
        (-f32::MAX, f32::MAX),
    ] {
        check::<Libm>(shift, spacing);
        check::<Poly>(shift, spacing);
    }
}

/// Weights below and above what `f32` holds are the nearest positive ones.
#[test]
fn weights_out_of_range_are_the_nearest_in_range() {
    let tiny = f32::from_bits(1);
    for (density, pdf, weight) in [
        (tiny, 100.0, tiny),
        (tiny, f32::MAX, tiny),
        (f32::MAX, 1e-3, f32::MAX),
        (f32::MAX, tiny, f32::MAX),
        (3.0, 2.0, 1.5),
    ] {
        let source = Listed { pdf: &[pdf] };
        let start = Chain::resample(|_| density, &source, 5, &mut Pcg32::new(1, 1)).unwrap();
        assert_eq!(start.weight, weight, "{density:e} {pdf:e}");
        let log = |_| LogDensity::<Poly>::new(f32::MAX);
        let start = Chain::resample(log, &source, 5, &mut Pcg32::new(1, 1)).unwrap();
        assert!(start.weight.get().is_finite());
    }
}

/// The expectation of W at each state, over all sequences of candidates, is the target: exactly what makes
/// the start unbiased.
#[test]
fn the_expected_weight_of_each_start_is_the_target() {
    let target = [0.5_f32, 0.0, 2.0, 3.5];
    let pdf = 0.25;
    for count in 1..=4_u32 {
        let mut expected = [0.0_f64; 4];
        for sequence in 0..4_usize.pow(count) {
            let states: Vec<usize> = (0..count).map(|j| sequence >> (2 * j) & 3).collect();
            let weights: Vec<f32> = states.iter().map(|s| target[*s]).collect();
            let mean = weights.iter().map(|w| f64::from(*w)).sum::<f64>() / f64::from(count) / pdf;
            if mean == 0.0 {
                continue;
            }
            let words: Vec<u32> = states.iter().flat_map(|s| [*s as u32, 0]).collect();
            let source = Listed { pdf: &[0.25; 4] };
            let start = Chain::resample(|i| target[i], &source, count, &mut Cycle::new(&words));
            let weight = f64::from(start.unwrap().weight);
            assert!((weight / mean - 1.0).abs() <= 2_f64.powi(-22));
            let chance = pdf.powi(count as i32);
            for (state, p) in states.iter().zip(probabilities(&weights)) {
                expected[*state] += chance * weight * p;
            }
        }
        for (found, f) in expected.iter().zip(target) {
            assert!(
                (found - f64::from(f)).abs() <= 1e-6,
                "{count}: {expected:?}"
            );
        }
    }
}

#[test]
fn a_search_ends_at_the_first_positive_density_or_with_its_budget() {
    let source = Listed { pdf: &[1.0; 8] };
    let target = [
        0.0,
        f32::NAN,
        -1.0,
        f32::INFINITY,
        0.0,
        7.0,
        9.0,
        f32::NEG_INFINITY,
    ];
    let words = [0, 1, 2, 3, 4, 7, 5, 6];
    for budget in 0..=9 {
        let mut asked = 0;
        let mut rng = Counting::new(Cycle::new(&words));
        let density = |i: usize| {
            asked += 1;
            target[i]
        };
        let found = Chain::try_search(density, &source, budget, &mut rng);
        let needed = if budget < 7 {
            assert_eq!(found, Err(Failure::BudgetSpent { tries: budget }));
            budget
        } else {
            let chain = found.unwrap();
            assert_eq!((chain.state(), chain.density(), chain.steps()), (5, 7.0, 0));
            7
        };
        assert_eq!((asked, rng.words), (needed, needed.into()));
    }
    let logs = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1e30];
    let log = |i: usize| LogDensity::<Poly>::new(logs[i]);
    let source = Listed { pdf: &[1.0; 4] };
    let chain = Chain::search(log, &source, 4, &mut Cycle::new(&[0, 1, 2, 3])).unwrap();
    assert_eq!((chain.state(), chain.density().get()), (3, -1e30));
}

#[test]
fn a_source_of_a_wrong_density_is_reported() {
    for wrong in [0.0, -0.0, -1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let source = Listed { pdf: &[1.0, wrong] };
        for density in [1.0, 0.0, f32::NAN] {
            let words = [0, 0, 1, 0];
            let found = Chain::resample(|_| density, &source, 2, &mut Cycle::new(&words));
            assert_eq!(found, Err(Failure::ProposalDensity), "{wrong} {density}");
            // A search does not ask for it.
            let search = Chain::search(|_| 1.0, &source, 2, &mut Cycle::new(&[1]));
            assert_eq!(search.unwrap().state(), 1);
        }
        // Nor is it of account where no such state is drawn.
        let found = Chain::resample(|_| 1.0, &source, 2, &mut Cycle::new(&[0, 0]));
        assert_eq!(found.unwrap().weight, 1.0);
    }
}

#[test]
fn candidates_of_no_density_are_none() {
    let source = Listed { pdf: &[1.0; 4] };
    for none in [0.0, f32::NAN, f32::INFINITY, -1.0] {
        let found = Chain::resample(|_| none, &source, 5, &mut Pcg32::new(1, 1));
        assert_eq!(found, Err(Failure::BudgetSpent { tries: 5 }));
        let some = |i: usize| if i == 2 { 3.0 } else { none };
        let words = [0, 0, 1, 0, 2, u32::MAX, 3, 0];
        let start = Chain::resample(some, &source, 4, &mut Cycle::new(&words)).unwrap();
        assert_eq!((start.chain.state(), start.positive), (2, 1));
        assert_eq!(start.weight, 0.75);
        // One weight of 3 and three of 0 have the variance 27/16 about 3/4.
        let error = f64::from(start.relative_error.unwrap());
        assert!((error - 1.0).abs() <= 1e-6, "{error}");
    }
    let found = Chain::resample(|_| 1.0, &source, 0, &mut Pcg32::new(1, 1));
    assert_eq!(found, Err(Failure::BudgetSpent { tries: 0 }));
}
