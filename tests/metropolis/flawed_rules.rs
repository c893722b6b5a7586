//! Rules of acceptance that are wrong, by their ratio or by their comparison.

use crate::densities::*;
use crate::evidence::assert_passes;
use crate::flaws::{p_values, rejected};
use crate::own::{multiply, then};
use crate::subjects::{Subject, chain, walking};
use host::speed;
use microwarp::metropolis::{
    HastingsCorrection, HastingsRatio, Mutation, Outcome, Proposal, Symmetric, Transition,
    UniformStep,
};
use rand_core::TryRng;
use rand_pcg::Pcg32;

/// Steps by factors for the gamma law, whose ratio is replaced.
fn restated<C: HastingsCorrection + 'static>(
    name: &'static str,
    ratio: fn(f32, f32) -> C,
) -> Subject {
    let mutation = then(multiply(1.5), move |from, to| {
        Proposal::new(to, ratio(from, to))
    });
    chain(name, gamma_cells(), 40.0, gamma, mutation)
}

#[test]
fn a_chain_that_forgets_the_ratio_is_rejected() {
    rejected(&restated("without ratio", |_, _| Symmetric));
    rejected(&restated("the inverse ratio", |from, to| {
        HastingsRatio::new(1.0 / from, 1.0 / to)
    }));
    // x′/x to the power 1.03: how little is seen; of fewer steps, less.
    let nearly: fn(f32, f32) -> HastingsRatio = if speed::full() {
        |from, to| HastingsRatio::new(from.powf(1.03), to.powf(1.03))
    } else {
        |from, to| HastingsRatio::new(from.powf(1.15), to.powf(1.15))
    };
    rejected(&restated("off in its logarithm", nearly));
    // Restated rightly, nothing is wrong.
    let right = restated("restated", HastingsRatio::new);
    assert_passes("restated", &p_values(&right));
}

/// Metropolis's rule with a mistake of one's choice in the comparison.
fn naive(
    name: &'static str,
    cells: Cells<f32>,
    target: fn(f32) -> f32,
    rejects: fn(f32, f32) -> bool,
) -> Subject {
    walking(name, cells, move |_| {
        let mut at = 0.45;
        move |rng: &mut Pcg32| {
            let Ok(proposal) = UniformStep::new().try_propose(at, rng);
            let Ok(word) = rng.try_next_u32();
            let [from_density, proposed_density] = [at, proposal.state].map(target);
            let acceptance = proposed_density / from_density;
            let uniform = (f64::from(word) / 4_294_967_296.0) as f32;
            let outcome = match rejects(uniform, acceptance) {
                true => Outcome::Rejected,
                false => Outcome::Accepted,
            };
            let step = Transition {
                from: at,
                from_density,
                proposed: proposal.state,
                proposed_density,
                // Of NaN it is 1.
                acceptance: acceptance.min(1.0),
                outcome,
                kind: 0,
            };
            at = step.state();
            step
        }
    })
}

#[test]
fn wrong_comparisons_are_rejected() {
    let low = |u: f32, a: f32| u >= a;
    let nan = naive("NaN accepted", gap_cells(), gap, low);
    rejected(&nan);
    let cells = parabola_cells;
    let coarse = |u: f32, a: f32| (u * 32.0).floor() / 32.0 >= a;
    rejected(&naive("a coin of five bits", cells(), parabola, coarse));
    let generous: fn(f32, f32) -> bool = if speed::full() {
        |u, a| u >= a.max(0.03)
    } else {
        |u, a| u >= a.max(0.15)
    };
    rejected(&naive(
        "never below some percent",
        cells(),
        parabola,
        generous,
    ));
    let heat = |u: f32, a: f32| u >= a / (1.0 + a);
    let other = naive("another rule", cells(), parabola, heat);
    // Barker's rule is as right as Metropolis's; only the recorded weights are then not its own, and they have
    // detailed balance all the same.
    assert_passes("Barker's rule", &p_values(&other));
    let right = naive("", cells(), parabola, low);
    assert_passes("the right comparison", &p_values(&right));
}
