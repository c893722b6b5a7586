//! Rules of acceptance that are wrong, by their ratio or by their comparison.

use crate::densities::*;
use crate::evidence::assert_passes;
use crate::flaws::{p_values, rejected};
use crate::subjects::{Subject, chain, walking};
use host::speed;
use microwarp::metropolis::{
    HastingsCorrection, HastingsRatio, Independence, Mutation, Outcome, Proposal, StateSource,
    Symmetric, Transition, UniformStep,
};
use microwarp::poly;
use rand_core::TryRng;
use rand_pcg::Pcg32;

/// A mutation whose ratio is replaced.
#[derive(Clone, Copy)]
struct Restated<M, C> {
    mutation: M,
    ratio: fn(f32, f32) -> C,
}

impl<M: Mutation<f32>, C: HastingsCorrection> Mutation<f32> for Restated<M, C> {
    type Correction = C;
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: f32,
        rng: &mut R,
    ) -> Result<Proposal<f32, C>, R::Error> {
        let to = self.mutation.try_propose(from, rng)?.state;
        Ok(Proposal::new(to, (self.ratio)(from, to)))
    }
}

#[test]
fn a_chain_that_forgets_the_ratio_is_rejected() {
    let factors = Multiply { reach: 1.5 };
    let source = Independence::new(poly::Exponential::from_rate(0.4).unwrap());
    let cells = gamma_cells;
    let forgets = |_, _| Symmetric;
    let wrong = Restated {
        mutation: factors,
        ratio: forgets,
    };
    rejected(&chain("factors without ratio", cells(), 40.0, gamma, wrong));
    let wrong = Restated {
        mutation: source,
        ratio: forgets,
    };
    rejected(&chain(
        "independence without ratio",
        cells(),
        40.0,
        gamma,
        wrong,
    ));
    let inverted = |from, to| HastingsRatio::new(1.0 / from, 1.0 / to);
    let wrong = Restated {
        mutation: factors,
        ratio: inverted,
    };
    rejected(&chain("the inverse ratio", cells(), 40.0, gamma, wrong));
    // x′/x to the power 1.03: how little is seen; of fewer steps, less.
    let nearly: fn(f32, f32) -> HastingsRatio = if speed::full() {
        |from, to| HastingsRatio::new(from.powf(1.03), to.powf(1.03))
    } else {
        |from, to| HastingsRatio::new(from.powf(1.15), to.powf(1.15))
    };
    let wrong = Restated {
        mutation: factors,
        ratio: nearly,
    };
    rejected(&chain(
        "a ratio some percent off in its logarithm",
        cells(),
        40.0,
        gamma,
        wrong,
    ));
    // Restated rightly, nothing is wrong.
    let rightly = |from, to| HastingsRatio::new(from, to);
    let right = Restated {
        mutation: factors,
        ratio: rightly,
    };
    assert_passes(
        "restated",
        &p_values(&chain("", cells(), 40.0, gamma, right)),
    );
    let rightly = |from, to| {
        let source = poly::Exponential::from_rate(0.4).unwrap();
        StateSource::<f32>::ratio_of_states(&source, from, to)
    };
    let right = Restated {
        mutation: source,
        ratio: rightly,
    };
    assert_passes(
        "restated",
        &p_values(&chain("", cells(), 40.0, gamma, right)),
    );
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
            let rejected = rejects((f64::from(word) / 4_294_967_296.0) as f32, acceptance);
            let step = Transition {
                from: at,
                from_density,
                proposed: proposal.state,
                proposed_density,
                acceptance: if acceptance.is_nan() {
                    1.0
                } else {
                    acceptance.min(1.0)
                },
                outcome: if rejected {
                    Outcome::Rejected
                } else {
                    Outcome::Accepted
                },
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
