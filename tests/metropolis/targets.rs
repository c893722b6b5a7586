//! Continuous and discrete targets: every chain has the distribution that it should, in plain states, in weighted
//! ones and in states far apart. How that is judged, and why correlated states can be, `evidence` says.

use crate::evidence::{assert_passes, assert_rejected};
use crate::runs::{Outcome, Plan, plan};
use crate::subjects;
use host::speed;
use host::stats::p_value_of_uniforms;
use std::sync::OnceLock;

fn outcomes() -> &'static [(&'static str, Plan, Outcome)] {
    static OUTCOMES: OnceLock<Vec<(&'static str, Plan, Outcome)>> = OnceLock::new();
    OUTCOMES.get_or_init(|| {
        let seeded = subjects::all().into_iter().zip(500..);
        let run = |(s, seed): (subjects::Subject, u64)| (s.name, s.plan, s.run(seed));
        seeded.map(run).collect()
    })
}

#[test]
fn chains_have_the_distribution_of_their_target() {
    for (name, plan, outcome) in outcomes() {
        println!(
            "{name}: {} batches of {} steps, accepted {:.3}, times {:.2?}, thinned by {}, cell's time {:.2}",
            plan.batches,
            plan.steps,
            outcome.accepted,
            outcome.times,
            outcome.thin,
            outcome.cell_time,
        );
        assert_passes(name, &outcome.p_values);
    }
}

/// The times that thinning relies on: by `Autocorrelation`, by its definition in f64, and by the spread of batches.
#[test]
fn autocorrelation_times_agree_with_two_other_ways_to_them() {
    let mut ratios = Vec::new();
    for (name, plan, outcome) in outcomes().iter().filter(|o| o.1.apart > 0.0) {
        let stride = plan.stride as f64;
        for (measured, exact) in outcome.times.into_iter().zip(outcome.exact_times) {
            // Of 128 autocorrelations, each within 3e-7, twice the sum.
            let error = (measured - exact).abs() / stride;
            assert!(error <= 2.0 * 128.0 * 3e-7, "{name}: {measured}, {exact}");
        }
        // Whatever cell is the slowest, its times between states taken as independent are many.
        let times = outcome.thin as f64 / outcome.cell_time;
        assert!(times >= 3.0, "{name}: {times} times apart");
        // Not where every tenth state only was looked at.
        if plan.stride == 1 {
            ratios.push(outcome.batch_time / outcome.times[0]);
            println!(
                "{name}: {:.2} by batches, {:.2}",
                outcome.batch_time, outcome.times[0]
            );
        }
    }
    // A variance of k batches has the relative deviation √(2/(k−1)), 0.089 of 256; the time itself, of some thousand
    // times' length, about as much again.
    let allowed = 5.0 * (2.0 / (plan().batches - 1) as f64).sqrt() * 2_f64.sqrt();
    let off = |factor: f64| {
        ratios
            .iter()
            .map(|r| (r * factor).ln().abs())
            .fold(0.0, f64::max)
    };
    println!("largest |ln ratio| {:.3}", off(1.0));
    assert!(off(1.0) <= allowed);
    // The control: a time twice as large, or three times where batches are fewer.
    assert!(off(speed::of("times as large", 3.0, 2.0)) > allowed);
}

/// The p-values of many seeds are uniform, for batches shorter than those that are judged.
#[test]
fn p_values_of_right_chains_are_uniform() {
    let short = Plan {
        steps: 600,
        burn_in: 200,
        apart: 10.0,
        pilot: 4800,
        ..plan()
    };
    let all = subjects::all();
    let subject = all.iter().find(|s| s.name == "parabola, nine to one");
    let subject = subject.unwrap();
    let seeds = speed::of("seeds", 50, 150);
    let runs: Vec<Outcome> = (0..seeds)
        .map(|i| subject.run_by(&short, 9000 + i))
        .collect();
    let of = |way: usize| -> Vec<f64> { runs.iter().map(|o| o.p_values[way]).collect() };
    for (way, name) in ["plain", "weighted", "far apart"].into_iter().enumerate() {
        let p_values = of(way);
        let below = |bound: f64| p_values.iter().filter(|p| **p < bound).count();
        println!(
            "{name}: {} below 0.5, {} below 0.05",
            below(0.5),
            below(0.05)
        );
        assert_passes(name, &[p_value_of_uniforms(&mut p_values.clone())]);
    }
    // The control: as if every state were independent of the one before.
    let dense = Plan {
        apart: 0.01,
        ..short
    };
    let runs = (0..seeds / 3).map(|i| subject.run_by(&dense, 9000 + i).p_values[2]);
    let naive = p_value_of_uniforms(&mut runs.collect::<Vec<_>>());
    assert_rejected("correlated states", &[naive]);
}
