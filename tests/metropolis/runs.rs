//! How a chain is run for its evidence: batches, what they record, and the autocorrelation times.

use crate::densities::Cells;
use crate::diagnosis::variance;
use crate::series::Truth;
use crate::targets;
use host::speed;
use host::stats;
use microwarp::metropolis::{Autocorrelation, Transition};
use rand_pcg::Pcg32;

/// How much is run.
#[derive(Clone, Copy)]
pub struct Plan {
    pub batches: usize,
    /// Steps of a batch that count.
    pub steps: usize,
    /// Steps before.
    pub burn_in: usize,
    /// The autocorrelation is measured on every so many steps.
    pub stride: usize,
    /// Autocorrelation times between states that are taken as independent; 0 for the last one of each batch.
    pub apart: f64,
    /// Steps of the run by which autocorrelation times are taken.
    pub pilot: usize,
}

/// The full plan. Its burn-in leaves little: correlations fall as e^(−2t/τ) where a single relaxation dominates.
pub const FULL: Plan = Plan {
    batches: 256,
    steps: 8000,
    burn_in: 1000,
    stride: 1,
    apart: 10.0,
    pilot: 64_000,
};

/// The plan of the speed. Fewer batches tell a cell's own time less well: states are taken farther apart then.
pub fn plan() -> Plan {
    let quick = Plan {
        batches: 128,
        steps: 3000,
        apart: 15.0,
        ..FULL
    };
    if speed::full() { FULL } else { quick }
}

/// What came of the batches of one chain.
pub struct Outcome {
    /// The p-values of plain states, of weighted ones, and of states far apart.
    pub p_values: [f64; 3],
    /// The integrated autocorrelation times of the two watched functions, in steps, by `Autocorrelation`.
    pub times: [f64; 2],
    /// The same, computed in f64.
    pub exact_times: [f64; 2],
    /// That of the first, from the spread of the batches.
    pub batch_time: f64,
    /// The largest of a fine cell, from the spread of the batches.
    pub cell_time: f64,
    /// Steps between states that were taken as independent.
    pub thin: usize,
    /// The share of steps that moved.
    pub accepted: f64,
}

/// Lags of `Autocorrelation`.
const LAGS: usize = 128;

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

    fn state(&self) -> X {
        self.recorded[usize::from(self.accepted)].0
    }
}

/// A chain about to be stepped, its types erased but for that of its states.
pub type Walk<X> = Box<dyn FnMut(&mut Pcg32) -> Seen<X>>;
pub type Start<X> = dyn Fn(&mut Pcg32) -> Walk<X>;

/// Runs batches of what `start` makes.
pub fn run<X: Copy>(plan: &Plan, cells: &Cells<X>, start: &Start<X>, seed: u64) -> Outcome {
    let [times, exact_times] = pilot(plan, cells, start, seed);
    let far = (plan.apart * times[0].max(times[1])).ceil() as usize;
    let thin = if far == 0 { plan.steps } else { far };
    let mut vectors = [Vec::new(), Vec::new()];
    let mut fine_vectors = Vec::new();
    let mut means = Vec::new();
    let mut fine = vec![0_u64; cells.exact[1].len()];
    let (mut outside, mut moved, mut taken) = (false, 0_u64, 0_u64);
    for batch in 0..plan.batches {
        let mut rng = Pcg32::new(seed, 2 * batch as u64 + 1);
        let mut walk = start(&mut rng);
        for _ in 0..plan.burn_in {
            walk(&mut rng);
        }
        let mut shares = [(); 2].map(|()| vec![0.0; cells.exact[0].len()]);
        let mut fine_shares = vec![0.0; fine.len()];
        let mut sum = 0.0;
        let mut here = None;
        for i in 1..=plan.steps {
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
                    Some([cell, _]) => shares[1][cell] += f64::from(weight),
                    None => outside |= weight != 0.0,
                }
            }
            here = if step.accepted { to } else { from };
            moved += u64::from(step.accepted);
            match here {
                Some([coarse, cell]) => {
                    shares[0][coarse] += 1.0;
                    fine_shares[cell] += 1.0 / plan.steps as f64;
                }
                None => outside = true,
            }
            if i % thin == 0 {
                if let Some([_, cell]) = here {
                    fine[cell] += 1;
                    taken += 1;
                }
            }
            sum += f64::from((cells.watched)(step.state())[0]);
        }
        fine_vectors.push(fine_shares);
        means.push(sum / plan.steps as f64);
        for (vectors, shares) in vectors.iter_mut().zip(shares) {
            vectors.push(shares.iter().map(|s| s / plan.steps as f64).collect());
        }
    }
    let expected: Vec<f64> = cells.exact[1].iter().map(|p| p * taken as f64).collect();
    let far_apart = stats::chi_square(&fine, &expected).map_or(0.0, |(_, _, p)| p);
    let plain = targets::hotelling(&vectors[0], &cells.exact[0]);
    let weighted = targets::hotelling(&vectors[1], &cells.exact[0]);
    let p_values = [plain, weighted, far_apart].map(|p| if outside { 0.0 } else { p });
    let steps = plan.steps as f64;
    let of_cells = cells.exact[1].iter().enumerate().map(|(c, p)| {
        let shares: Vec<f64> = fine_vectors.iter().map(|v: &Vec<f64>| v[c]).collect();
        steps * variance(&shares) / (p * (1.0 - p))
    });
    Outcome {
        p_values,
        times,
        exact_times,
        batch_time: 12.0 * steps * variance(&means),
        cell_time: of_cells.fold(0.0, f64::max),
        thin,
        accepted: moved as f64 / (plan.batches as f64 * steps),
    }
}

/// The integrated times of the two watched functions, by `Autocorrelation` and in f64.
fn pilot<X: Copy>(plan: &Plan, cells: &Cells<X>, start: &Start<X>, seed: u64) -> [[f64; 2]; 2] {
    if plan.apart == 0.0 {
        return [[0.0; 2]; 2];
    }
    let mut rng = Pcg32::new(seed, 0);
    let mut walk = start(&mut rng);
    for _ in 0..plan.burn_in {
        walk(&mut rng);
    }
    let mut health = [Autocorrelation::<LAGS>::new(); 2];
    let mut numbers = [Vec::new(), Vec::new()];
    for _ in 0..plan.pilot / plan.stride {
        let mut state = walk(&mut rng).state();
        for _ in 1..plan.stride {
            state = walk(&mut rng).state();
        }
        let watched = (cells.watched)(state);
        for ((health, numbers), x) in health.iter_mut().zip(&mut numbers).zip(watched) {
            health.push(x);
            numbers.push(x);
        }
    }
    let stride = plan.stride as f64;
    // Where no time is known it is long, or the walk stands still: states are taken far apart then. Of right
    // chains it has to be known, or it would not agree with that in f64.
    let times = health.map(|h| stride * h.integrated_time().map_or(LAGS as f64, f64::from));
    let exact = |run: Vec<f32>| match Truth::new(&run).integrated_time(LAGS - 1) {
        Some((time, _)) => stride * time,
        // The correlation outlasts the lags.
        None => f64::NAN,
    };
    [times, numbers.map(exact)]
}
