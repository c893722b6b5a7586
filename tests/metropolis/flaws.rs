//! Wrong chains, which the tests must reject.

use crate::densities::*;
use crate::evidence::{assert_passes, assert_rejected};
use crate::own::then;
use crate::runs::FULL;
use crate::subjects::{Subject, chain, nine_to_one, slow_box, walking};
use host::speed;
use microwarp::metropolis::{BoxStep, Chain, Mutation, Outcome, Proposal, Symmetric, Transition};
use rand_core::TryRng;
use rand_pcg::Pcg32;

/// The p-values of right chains here, computed beside the wrong ones': two of one chain, and three of each of four.
pub const P_VALUES: usize = 14;

/// Seeds of their own; the same plan as the right chains.
pub fn p_values(subject: &Subject) -> [f64; 3] {
    subject.run(77).p_values
}

pub fn rejected(subject: &Subject) {
    assert_rejected(subject.name, &p_values(subject));
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
    let [plain, weighted, apart] = p_values(&swapped);
    assert_rejected("swapped weights", &[weighted]);
    // It is the recording alone that is wrong there.
    assert_passes("and its plain states", &[plain, apart]);
    let proposals = |step: Transition<f32>| {
        Some(Transition {
            acceptance: 1.0,
            outcome: Outcome::Forced,
            ..step
        })
    };
    rejected(&altered("proposals for states", proposals));
    assert_passes("nothing altered", &p_values(&altered("", Some)));
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
