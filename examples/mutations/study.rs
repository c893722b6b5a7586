//! What is measured for one mutation: short runs, as in practice, and a long one that is compared with the exact values.

use crate::kernel::Truth;
use crate::ladder::{Ladder, Time};
use crate::run::{Run, is_left, walk};
use crate::target::BINS;
use crate::target::Rule;
use crate::thinned::Thinned;
use microwarp::Error;
use microwarp::metropolis::{Halves, Transition, split_r_hat};
use rand_pcg::Pcg32;
use support::mean::Mean;
use support::verdict::{ALARM, Outcome, passes};

/// Above this split R̂, chains disagree.
pub const AGREED: f64 = 1.01;
/// The starts of the two chains of a pair, one in each hump.
pub const STARTS: [f32; 2] = [0.1, 0.9];
/// The lengths of the runs.
pub const LENGTHS: [u64; 2] = [10_000, 300_000];
/// The test needs at least this many independent states.
const FEWEST: u64 = 500;
/// The shortest long run.
const LEAST: u64 = 2_000_000;
const BATCHES: u64 = 40;

/// Two runs of one length.
pub struct Pair {
    pub steps: u64,
    pub runs: [Run; 2],
    pub r_hat: f64,
    /// Split R̂ of two chains that both start on the left.
    pub together: f64,
    /// The test of the first run; `None` where it is too short for one.
    pub outcome: Option<Outcome>,
}

/// A run that is long for this mutation.
pub struct Long {
    pub steps: u64,
    pub acceptance: Mean,
    pub crossing: Mean,
    /// The share of time on the left.
    pub left: Mean,
    /// The autocorrelation times of x and of whether it is on the left.
    pub times: [Option<Time>; 2],
    /// Their relative standard error.
    pub spread: f64,
    pub samples: u64,
    pub outcome: Outcome,
}

pub struct Study<'a> {
    pub rule: &'a Rule,
    pub truth: Truth,
    /// How far the finer matrix is from the extrapolated values.
    pub doubt: f64,
    pub pairs: Vec<Pair>,
    pub long: Long,
}

impl Pair {
    fn new(rule: &Rule, truth: &Truth, steps: u64, seed: u64, stream: u64) -> Result<Self, Error> {
        let run = |start, k| Run::new(rule, truth, start, steps, &mut Pcg32::new(seed, stream + k));
        let runs = [run(STARTS[0], 0)?, run(STARTS[1], 1)?];
        let third = run(STARTS[0], 2)?;
        let agree = |a: &Run, b: &Run| -> f64 {
            split_r_hat(&[a.halves, b.halves] as &[Halves]).map_or(f64::NAN, f64::from)
        };
        let thinned = &runs[0].thinned;
        Ok(Self {
            steps,
            r_hat: agree(&runs[0], &runs[1]),
            together: agree(&runs[0], &third),
            outcome: (thinned.samples() >= FEWEST).then(|| thinned.test()),
            runs,
        })
    }
}

impl Long {
    fn new(rule: &Rule, truth: &Truth, relaxations: u64, rng: &mut Pcg32) -> Result<Self, Error> {
        let relaxation = truth.relaxation();
        let steps = ((relaxations as f64 * relaxation) as u64).max(LEAST);
        let batch = steps.div_ceil(BATCHES);
        let apart = (relaxation / 6.0).max(1.0) as u64;
        let [mut x, mut left] = [(); 2].map(|()| Ladder::<128>::new(apart, steps));
        let mut thinned = Thinned::new(truth);
        let mut sums = [const { Vec::new() }; 3];
        let mut counts = [0_u64; 3];
        let mut start = STARTS[0];
        for _ in 0..BATCHES {
            let mut last = start;
            walk(rule, start, batch, rng, |step: &Transition<f32>| {
                last = step.state();
                let (before, now) = (is_left(step.from), is_left(last));
                let events = [step.is_accepted(), before != now, now];
                for (count, event) in counts.iter_mut().zip(events) {
                    *count += u64::from(event);
                }
                x.push(last);
                left.push(if now { 1.0 } else { 0.0 });
                thinned.push(last);
            })?;
            start = last;
            for (sum, count) in sums.iter_mut().zip(&mut counts) {
                sum.push(std::mem::take(count) as f64 / batch as f64);
            }
        }
        let times = [x.time(), left.time()];
        // A time summed over W lags of n numbers has the variance 2(2W + 1)/n, in proportion.
        let window = (6.0 * relaxation / apart as f64).max(1.0);
        let numbers = (steps / apart) as f64;
        let [acceptance, crossing, left] = sums.map(Mean::of);
        Ok(Self {
            steps: batch * BATCHES,
            acceptance,
            crossing,
            left,
            times,
            spread: (2.0 * (2.0 * window + 1.0) / numbers).sqrt(),
            samples: thinned.samples(),
            outcome: thinned.test(),
        })
    }
}

impl<'a> Study<'a> {
    pub fn new(rule: &'a Rule, relaxations: u64, seed: u64, stream: u64) -> Result<Self, Error> {
        let (truth, doubt) = Truth::of(rule, BINS);
        let pair = |k: usize| Pair::new(rule, &truth, LENGTHS[k], seed, stream + 10 * k as u64);
        Ok(Self {
            pairs: vec![pair(0)?, pair(1)?],
            long: Long::new(
                rule,
                &truth,
                relaxations,
                &mut Pcg32::new(seed, stream + 50),
            )?,
            rule,
            truth,
            doubt,
        })
    }

    /// Whether a run is long enough to compare its states with the target.
    pub fn is_long(&self, steps: u64) -> bool {
        steps as f64 >= 100.0 * self.truth.relaxation()
    }

    /// What disagrees with the exact values.
    pub fn complaints(&self) -> Vec<String> {
        let (name, truth, long) = (self.rule.name(), &self.truth, &self.long);
        let mut complaints = Vec::new();
        let mut hold = |right: bool, what: String| {
            if !right {
                complaints.push(format!("{name}: {what}"));
            }
        };
        let doubt = self.doubt;
        hold(
            doubt <= 0.005,
            format!("the two matrices are {doubt:.1e} apart"),
        );
        if self.rule.small() == 0.0 {
            let found = [truth.acceptance, truth.gap, truth.crossing];
            let off = (0..3).map(|k| (found[k] / Truth::UNIFORM[k] - 1.0).abs());
            let most = off.fold(0.0, f64::max);
            hold(
                most <= 0.005,
                format!("the matrices are {most:.1e} off the closed form"),
            );
        }
        let means = [
            ("acceptance", long.acceptance, truth.acceptance),
            ("crossings", long.crossing, truth.crossing),
            ("time on the left", long.left, 0.5),
        ];
        for (what, mean, exact) in means {
            let off = mean.deviation(exact);
            hold(
                mean.p(exact) >= ALARM,
                format!("{what} off by {off:+.1} standard errors"),
            );
        }
        for (time, exact) in long.times.iter().zip(truth.times) {
            let ratio = time.map_or(f64::NAN, |time| time.steps / exact);
            // Of correlation that decays as e^(−t/T), every k-th state tells a time (k/2T) coth(k/2T) as long.
            let stride = time.map_or(f64::NAN, |time| time.stride as f64);
            let coarse = (stride / truth.relaxation()).powi(2) / 12.0;
            hold(
                ratio.ln().abs() <= 6.0 * long.spread + coarse + doubt,
                format!("an autocorrelation time {ratio:.3} times the true one"),
            );
        }
        hold(
            passes(&long.outcome),
            format!("the long run: {:?}", long.outcome),
        );
        for pair in self.pairs.iter().filter(|pair| self.is_long(pair.steps)) {
            let tested = pair.outcome.as_ref().is_none_or(passes);
            hold(tested, format!("{} steps: {:?}", pair.steps, pair.outcome));
        }
        if let Some(pair) = self.pairs.last().filter(|pair| self.is_long(pair.steps)) {
            let tested = pair.outcome.is_some() && pair.r_hat <= AGREED;
            hold(tested, format!("split R̂ {:.4}, or no test", pair.r_hat));
        }
        complaints
    }
}
