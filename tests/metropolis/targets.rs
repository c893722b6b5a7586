//! Continuous targets: every chain has the distribution that it should, in plain states and in weighted ones. The counts of
//! correlated states are judged without assuming that they are independent.
//!
//! # The statistic
//! Many batches are run that share nothing: each has its own chain, its own generator and its own start. The
//! shares of a batch in the cells are a vector, and the vectors of the batches are independent and alike,
//! whatever the correlation along a chain and whether plain states or weights were recorded. If the chain is
//! right, and the start forgotten or drawn from the target itself, their expectation is the vector of the
//! exact probabilities. Hotelling's T² asks just this, with the covariance that the batches themselves
//! show; for normal vectors its law is that of F, exactly, and the mean of hundreds of vectors is normal
//! enough. (`p_values_of_right_chains_are_uniform` calibrates it.) It is the chi-square test at the effective sample
//! size, with the effective sample size of every contrast between cells measured instead of assumed.

use crate::densities::Cells;
use crate::subjects;
use host::stats::{Family, p_value_of_uniforms};
use host::{speed, stats};
use microwarp::metropolis::Transition;
use rand_pcg::Pcg32;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

/// What is judged of chains.
pub static FAMILY: Family = Family::of(80);

/// The p-value of Hotelling's T² of the batches' shares in the cells against the exact probabilities.
///
/// The last cell is left out, since the shares sum to 1. Cells that do not vary, or only as others do, make
/// a p-value of 0: a right chain has none.
pub fn hotelling(batches: &[Vec<f64>], exact: &[f64]) -> f64 {
    let (k, d) = (batches.len(), exact.len() - 1);
    assert!(k > 4 * d, "{k} batches for {d} cells");
    let mean: Vec<f64> = (0..d)
        .map(|c| batches.iter().map(|b| b[c]).sum::<f64>() / k as f64)
        .collect();
    let covariance = |a: usize, b: usize| {
        let products = batches.iter().map(|x| (x[a] - mean[a]) * (x[b] - mean[b]));
        products.sum::<f64>() / (k - 1) as f64
    };
    // By Cholesky: T² = k |y|², where L y is the deviation and L Lᵀ the covariance.
    let mut lower = vec![vec![0.0; d]; d];
    let mut squares = 0.0;
    let mut y = vec![0.0; d];
    for row in 0..d {
        for column in 0..row {
            let inner: f64 = (0..column).map(|i| lower[row][i] * lower[column][i]).sum();
            lower[row][column] = (covariance(row, column) - inner) / lower[column][column];
        }
        let variance = covariance(row, row);
        let pivot = variance - lower[row].iter().map(|x| x * x).sum::<f64>();
        // Written so that NaN returns as well.
        let some = pivot > 1e-12 * variance;
        if !some {
            return 0.0;
        }
        lower[row][row] = pivot.sqrt();
        let inner: f64 = (0..row).map(|i| lower[row][i] * y[i]).sum();
        y[row] = (mean[row] - exact[row] - inner) / lower[row][row];
        squares += y[row] * y[row];
    }
    let (k, d) = (k as f64, d as f64);
    let f = k * squares * (k - d) / (d * (k - 1.0));
    FisherSnedecor::new(d, k - d).unwrap().sf(f)
}

#[test]
fn chains_have_the_distribution_of_their_target() {
    for (subject, seed) in subjects::all().into_iter().zip(500..) {
        let (Plan { batches, steps, .. }, outcome) = (subject.plan, subject.run(seed));
        let accepted = outcome.accepted;
        println!(
            "{}: {batches} batches of {steps} steps, accepted {accepted:.3}",
            subject.name
        );
        FAMILY.assert_passes(subject.name, &outcome.p_values);
    }
}

/// The p-values of many seeds are uniform, for batches shorter than those that are judged.
#[test]
fn p_values_of_right_chains_are_uniform() {
    let short = Plan {
        steps: 600,
        burn_in: 200,
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
    for (way, name) in ["plain", "weighted"].into_iter().enumerate() {
        let p_values = of(way);
        let below = |bound: f64| p_values.iter().filter(|p| **p < bound).count();
        println!(
            "{name}: {} below 0.5, {} below 0.05",
            below(0.5),
            below(0.05)
        );
        FAMILY.assert_passes(name, &[p_value_of_uniforms(&mut p_values.clone())]);
    }
    // The control: as if every state were independent of the one before.
    let mut naive: Vec<f64> = runs.iter().map(|outcome| outcome.naive).collect();
    FAMILY.assert_rejected("correlated states", &[p_value_of_uniforms(&mut naive)]);
}

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
        steps: 1500,
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
