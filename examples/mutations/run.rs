//! One chain, and everything tallied along it.

use crate::kernel::Truth;
use crate::ladder::Ladder;
use crate::target::{BINS, Rule, bin, probabilities, target};
use crate::thinned::Thinned;
use microwarp::Error;
use microwarp::metropolis::{Chain, Halves, Transition};
use rand_pcg::Pcg32;

/// How many states of a run are kept for the picture.
const KEPT: u64 = 2500;

pub struct Run {
    pub acceptance: f64,
    /// The histogram of the states, recorded plainly and by expected values, as shares.
    pub plain: Vec<f64>,
    pub expected: Vec<f64>,
    /// The autocorrelation of x, and of whether it is on the left.
    pub x: Ladder<64>,
    pub left: Ladder<64>,
    pub halves: Halves,
    pub thinned: Thinned,
    /// How often the chain went from one hump to the other.
    pub crossings: u64,
    /// Some states in order, evenly spaced.
    pub trace: Vec<f32>,
}

pub fn is_left(x: f32) -> bool {
    x < 0.5
}

/// Takes steps, passes each to `see`, and returns the acceptance rate.
pub fn walk(
    rule: &Rule,
    start: f32,
    steps: u64,
    rng: &mut Pcg32,
    mut see: impl FnMut(&Transition<f32>),
) -> Result<f64, Error> {
    let mut chain = Chain::new(start, target)?;
    for _ in 0..steps {
        see(&chain.step(target, rule, rng));
    }
    Ok(chain.accepted() as f64 / steps as f64)
}

impl Run {
    pub fn new(
        rule: &Rule,
        truth: &Truth,
        start: f32,
        steps: u64,
        rng: &mut Pcg32,
    ) -> Result<Self, Error> {
        let mut this = Self {
            acceptance: 0.0,
            plain: vec![0.0; BINS],
            expected: vec![0.0; BINS],
            x: Ladder::new(1, steps),
            left: Ladder::new(1, steps),
            halves: Halves::new(steps / 2),
            thinned: Thinned::new(truth),
            crossings: 0,
            trace: Vec::new(),
        };
        let (share, mut taken) = (1.0 / steps as f64, 0);
        this.acceptance = walk(rule, start, steps, rng, |step| {
            this.tally(step, share);
            // The k-th state kept is the one after k/KEPT of the run.
            if taken * KEPT >= this.trace.len() as u64 * steps {
                this.trace.push(step.state());
            }
            taken += 1;
        })?;
        Ok(this)
    }

    fn tally(&mut self, step: &Transition<f32>, share: f64) {
        let x = step.state();
        self.plain[bin(x)] += share;
        for (x, weight) in step.recorded() {
            // Proposals outside [0, 1] have weight 0 and no bin.
            if weight > 0.0 {
                self.expected[bin(x)] += share * f64::from(weight);
            }
        }
        self.x.push(x);
        self.left.push(if is_left(x) { 1.0 } else { 0.0 });
        self.halves.push(x);
        self.thinned.push(x);
        self.crossings += u64::from(is_left(step.from) != is_left(x));
    }

    /// The share of time in the left hump.
    pub fn left_share(&self) -> f64 {
        self.plain[..BINS / 2].iter().sum()
    }
}

/// The total variation distance of a histogram from the target.
pub fn variation(shares: &[f64]) -> f64 {
    let exact = probabilities(shares.len());
    let off = shares.iter().zip(exact).map(|(s, p)| (s - p).abs());
    0.5 * off.sum::<f64>()
}
