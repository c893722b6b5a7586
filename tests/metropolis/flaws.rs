//! Wrong chains, which the tests must reject.

use crate::densities::*;
use crate::own::{multiply, then};
use crate::subjects::{Subject, chain, nine_to_one, slow_box, walking};
use crate::targets::{FAMILY, FULL};
use host::speed;
use microwarp::metropolis::{
    BoxStep, Chain, HastingsCorrection, HastingsRatio, Mutation, Outcome, Proposal, Symmetric,
    Transition, UniformStep,
};
use rand_core::TryRng;
use rand_pcg::Pcg32;

/// Seeds of their own; the same plan as the right chains.
pub fn p_values(subject: &Subject) -> [f64; 2] {
    subject.run(77).p_values
}

pub fn rejected(subject: &Subject) {
    FAMILY.assert_rejected(subject.name, &p_values(subject));
}

/// Steps on the parabola, nine to one, after which `then` has its say.
fn altered(
    name: &'static str,
    then: impl Fn(Transition<f32>) -> Option<Transition<f32>> + Copy + 'static,
) -> Subject {
    walking(name, parabola_cells(), move |_| {
        let mut chain = Chain::new(0.45, parabola).unwrap();
        let mutation = nine_to_one();
        move |rng: &mut Pcg32| {
            loop {
                if let Some(step) = then(chain.step(parabola, &mutation, rng)) {
                    return step;
                }
            }
        }
    })
}

#[test]
fn wrong_recordings_are_rejected() {
    let moves = altered("accepted moves only", |step| {
        step.is_accepted().then_some(step)
    });
    // Few steps are not enough to see it.
    rejected(&moves.planned(FULL));
    let swapped = |step: Transition<f32>| {
        let acceptance = 1.0 - step.acceptance;
        Some(Transition { acceptance, ..step })
    };
    let swapped = altered("swapped weights", swapped);
    let [plain, weighted] = p_values(&swapped);
    FAMILY.assert_rejected("swapped weights", &[weighted]);
    // It is the recording alone that is wrong there.
    FAMILY.assert_passes("and its plain states", &[plain]);
    let proposals = |step: Transition<f32>| {
        Some(Transition {
            acceptance: 1.0,
            outcome: Outcome::Forced,
            ..step
        })
    };
    rejected(&altered("proposals for states", proposals));
    FAMILY.assert_passes("nothing altered", &p_values(&altered("", Some)));
}

/// Proposes anew until it is inside.
#[derive(Clone, Copy)]
struct Insistent(BoxStep<f32>);

impl Mutation<f32> for Insistent {
    type Correction = Symmetric;
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: f32,
        rng: &mut R,
    ) -> Result<Proposal<f32, Symmetric>, R::Error> {
        loop {
            let proposal = self.0.try_propose(from, rng)?;
            if (0.0..=1.0).contains(&proposal.state) {
                return Ok(proposal);
            }
        }
    }
}

#[test]
fn wrong_borders_are_rejected() {
    let narrow = BoxStep::new(0.1).unwrap();
    // Put back to the border where it leaves the unit interval.
    let clamped = then(narrow, |_, to: f32| {
        Proposal::new(to.clamp(0.0, 1.0), Symmetric)
    });
    rejected(&slow_box("clamped to the border", clamped));
    rejected(&slow_box("proposed anew at the border", Insistent(narrow)));
}

/// A chain that steps nine to one, for the target that it is given.
fn for_another(name: &'static str, target: impl Fn(f32) -> f32 + 'static) {
    rejected(&chain(name, parabola_cells(), 0.45, target, nine_to_one()));
}

#[test]
fn targets_that_are_slightly_off_are_rejected() {
    let times = speed::of("factor on one side, floor", [1.2, 0.012], [1.05, 0.003]);
    for_another("some percent on one side", move |x| {
        parabola(x) * if x > 0.5 { times[0] } else { 1.0 }
    });
    for_another("a floor of 3.6 % or more", move |x| parabola(x) + times[1]);
}

/// A chain that hardly moves off its start passes no test that starts far away.
#[test]
fn a_stuck_chain_is_rejected() {
    for_another("stuck", |x| if x == 0.45 { 1e30 } else { parabola(x) });
}

// Rules of acceptance that are wrong, by their ratio or by their comparison.

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
    FAMILY.assert_passes("restated", &p_values(&right));
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
    FAMILY.assert_passes("Barker's rule", &p_values(&other));
    let right = naive("", cells(), parabola, low);
    FAMILY.assert_passes("the right comparison", &p_values(&right));
}
