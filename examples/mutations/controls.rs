//! Controls: chains that are wrong on purpose, or too short. The tests must reject each.

use crate::run::walk;
use crate::study::{AGREED, LENGTHS, STARTS, Study};
use crate::thinned::Thinned;
use microwarp::Error;
use microwarp::metropolis::Transition;
use rand_pcg::Pcg32;
use support::verdict::{Outcome, passes};

pub struct Control {
    pub name: String,
    pub samples: u64,
    pub outcome: Outcome,
}

/// What a faulty chain would record for a step.
type Record = fn(&Transition<f32>) -> Option<f32>;

fn accepted_only(step: &Transition<f32>) -> Option<f32> {
    step.is_accepted().then(|| step.state())
}

fn every_proposal(step: &Transition<f32>) -> Option<f32> {
    (step.proposed_density > 0.0).then_some(step.proposed)
}

/// Faulty recordings, as long as the long runs, that must not pass for the target. (With the box step alone they
/// would take as long as everything else.)
pub fn all(studies: &[Study], seed: u64) -> Result<Vec<Control>, Error> {
    const WRONG: [(&str, Record); 2] = [
        ("accepted moves only", accepted_only),
        ("every proposal", every_proposal),
    ];
    let mut controls = Vec::new();
    for study in studies.iter().filter(|study| study.is_long(LENGTHS[1])) {
        for (stream, (what, record)) in (1000..).zip(WRONG) {
            let mut thinned = Thinned::new(&study.truth);
            let mut rng = Pcg32::new(seed, stream);
            walk(study.rule, STARTS[0], study.long.steps, &mut rng, |step| {
                record(step).into_iter().for_each(|x| thinned.push(x));
            })?;
            controls.push(Control {
                name: format!("{}, {what} recorded", study.rule.name()),
                samples: thinned.samples(),
                outcome: thinned.test(),
            });
        }
    }
    Ok(controls)
}

/// The controls that pass although they are wrong.
pub fn complaints(controls: &[Control], studies: &[Study]) -> Vec<String> {
    let passed = controls.iter().filter(|control| passes(&control.outcome));
    let mut complaints: Vec<String> = passed
        .map(|control| format!("{}: the test lets this pass", control.name))
        .collect();
    // Runs too short to have been everywhere must show it in their numbers alone.
    for study in studies {
        let short = |steps: u64| (steps as f64) < study.truth.relaxation();
        for pair in study.pairs.iter().filter(|pair| short(pair.steps)) {
            let (name, r_hat) = (study.rule.name(), pair.r_hat);
            // Written so that NaN, from chains that never moved, counts too.
            if r_hat <= AGREED {
                let steps = pair.steps;
                complaints.push(format!("{name}, {steps} steps: split R̂ is only {r_hat:.3}"));
            }
        }
    }
    complaints
}
