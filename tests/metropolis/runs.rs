//! How a chain is run for its evidence: batches, and what they record.

use crate::densities::Cells;
use crate::targets::hotelling;
use host::speed;
use host::stats;
use microwarp::metropolis::Transition;
use rand_pcg::Pcg32;

/// How much is run.
#[derive(Clone, Copy)]
pub struct Plan {
    pub batches: usize,
    /// Steps of a batch that count.
    pub steps: usize,
    /// Steps before.
    pub burn_in: usize,
}

/// The full plan. Its burn-in leaves little: correlations fall as e^(−2t/τ) where a single relaxation dominates.
pub const FULL: Plan = Plan {
    batches: 256,
    steps: 8000,
    burn_in: 1000,
};

/// The plan of the speed.
pub fn plan() -> Plan {
    let quick = Plan {
        batches: 128,
        steps: 3000,
        ..FULL
    };
    if speed::full() { FULL } else { quick }
}

/// What came of the batches of one chain.
pub struct Outcome {
    /// The p-values of plain states and of weighted ones.
    pub p_values: [f64; 2],
    /// That of plain states if each were independent of the one before.
    pub naive: f64,
    /// The share of steps that moved.
    pub accepted: f64,
}

/// What is looked at of a step.
pub struct Seen<X> {
    recorded: [(X, f32); 2],
    accepted: bool,
}

impl<X: Copy> Seen<X> {
    pub fn of<D: Copy>(step: &Transition<X, D>) -> Self {
        let (recorded, accepted) = (step.recorded(), step.is_accepted());
        Self { recorded, accepted }
    }
}

/// A chain about to be stepped, its types erased but for that of its states.
pub type Walk<X> = Box<dyn FnMut(&mut Pcg32) -> Seen<X>>;
pub type Start<X> = dyn Fn(&mut Pcg32) -> Walk<X>;

/// Runs batches of what `start` makes.
pub fn run<X: Copy>(plan: &Plan, cells: &Cells<X>, start: &Start<X>, seed: u64) -> Outcome {
    let mut vectors = [Vec::new(), Vec::new()];
    let mut counts = vec![0_u64; cells.exact.len()];
    let (mut outside, mut moved) = (false, 0_u64);
    for batch in 0..plan.batches {
        let mut rng = Pcg32::new(seed, 2 * batch as u64 + 1);
        let mut walk = start(&mut rng);
        for _ in 0..plan.burn_in {
            walk(&mut rng);
        }
        let mut shares = [(); 2].map(|()| vec![0.0; counts.len()]);
        let mut here = None;
        for _ in 0..plan.steps {
            let step = walk(&mut rng);
            // Of a state of weight 0 nothing may be asked.
            let [(before, _), (proposed, acceptance)] = step.recorded;
            let from = here.or_else(|| (cells.place)(before));
            let to = if acceptance > 0.0 || step.accepted {
                (cells.place)(proposed)
            } else {
                from
            };
            for (place, (_, weight)) in [from, to].into_iter().zip(step.recorded) {
                match place {
                    Some(cell) => shares[1][cell] += f64::from(weight),
                    None => outside |= weight != 0.0,
                }
            }
            here = if step.accepted { to } else { from };
            moved += u64::from(step.accepted);
            match here {
                Some(cell) => {
                    shares[0][cell] += 1.0;
                    counts[cell] += 1;
                }
                None => outside = true,
            }
        }
        for (vectors, shares) in vectors.iter_mut().zip(shares) {
            vectors.push(shares.iter().map(|s| s / plan.steps as f64).collect());
        }
    }
    let steps = (plan.batches * plan.steps) as f64;
    let expected: Vec<f64> = cells.exact.iter().map(|p| p * steps).collect();
    let p_values = vectors.map(|vectors| hotelling(&vectors, &cells.exact));
    Outcome {
        p_values: p_values.map(|p| if outside { 0.0 } else { p }),
        naive: stats::chi_square(&counts, &expected).map_or(0.0, |(_, _, p)| p),
        accepted: moved as f64 / steps,
    }
}
