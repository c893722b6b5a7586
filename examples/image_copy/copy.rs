//! A chain over the pixels, and the copies of the picture that its different recordings make.

use microwarp::metropolis::{Chain, Start, Transition, UniformIndex};
use microwarp::rejection::Failure;
use rand_pcg::Pcg32;

/// What is recorded of a step.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Recording {
    /// The state after the step.
    Plain,
    /// Both states, with weights 1 − a and a.
    Weighted,
    /// The state after the step, if it was accepted. Wrong.
    AcceptedOnly,
    /// The state proposed, as if it had always been accepted. Wrong.
    EveryProposal,
}

pub const RECORDINGS: [Recording; 4] = [
    Recording::Plain,
    Recording::Weighted,
    Recording::AcceptedOnly,
    Recording::EveryProposal,
];

impl Recording {
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Weighted => "weighted",
            Self::AcceptedOnly => "accepted moves only",
            Self::EveryProposal => "always accepting",
        }
    }
}

/// The error of a copy.
#[derive(Clone, Copy)]
pub struct Errors {
    /// Root mean square over the pixels, relative to the picture's mean.
    pub rmse: f64,
    /// Total variation between the two as distributions.
    pub variation: f64,
}

/// The state of a run after some of its steps.
pub struct Snapshot {
    /// For each recording, each pixel's share of it.
    pub shares: [Vec<f64>; 4],
    pub acceptance: f64,
    /// The mean brightness estimated from the proposals.
    pub mean: f64,
}

pub struct Run<'a> {
    luminance: &'a [f32],
    mutation: UniformIndex,
    pub start: Start<usize>,
    chain: Chain<usize>,
    rng: Pcg32,
    visits: Vec<u32>,
    weights: Vec<f64>,
    arrivals: Vec<u32>,
    proposals: Vec<u32>,
    proposed: f64,
}

/// How many pixels the first state is chosen from.
pub const CANDIDATES: u32 = 1000;

impl<'a> Run<'a> {
    pub fn new(luminance: &'a [f32], mut rng: Pcg32) -> Result<Self, Failure> {
        let pixels = luminance.len();
        let mutation = UniformIndex::new(pixels as u32).map_err(|_| Failure::ProposalDensity)?;
        let start = Chain::resample(|i: usize| luminance[i], &mutation, CANDIDATES, &mut rng)?;
        Ok(Self {
            luminance,
            mutation,
            chain: start.chain,
            start,
            rng,
            visits: vec![0; pixels],
            weights: vec![0.0; pixels],
            arrivals: vec![0; pixels],
            proposals: vec![0; pixels],
            proposed: 0.0,
        })
    }

    /// Continues until the chain has taken this many steps.
    pub fn advance_to(&mut self, steps: u64) {
        while self.chain.steps() < steps {
            let target = |i: usize| self.luminance[i];
            let step = self.chain.step(target, &self.mutation, &mut self.rng);
            self.record(&step);
        }
    }

    fn record(&mut self, step: &Transition<usize>) {
        self.visits[step.state()] += 1;
        for (pixel, weight) in step.recorded() {
            self.weights[pixel] += f64::from(weight);
        }
        self.arrivals[step.state()] += u32::from(step.is_accepted());
        self.proposals[step.proposed] += 1;
        self.proposed += f64::from(step.proposed_density);
    }

    pub fn snapshot(&self) -> Snapshot {
        let steps = self.chain.steps() as f64;
        let counted =
            |counts: &[u32], all: f64| counts.iter().map(|&n| f64::from(n) / all).collect();
        Snapshot {
            shares: [
                counted(&self.visits, steps),
                self.weights.iter().map(|w| w / steps).collect(),
                counted(&self.arrivals, self.chain.accepted() as f64),
                counted(&self.proposals, steps),
            ],
            acceptance: self.chain.accepted() as f64 / steps,
            mean: self.proposed / steps,
        }
    }
}

/// The errors of these shares.
pub fn errors(shares: &[f64], exact: &[f64]) -> Errors {
    let off = || shares.iter().zip(exact).map(|(s, p)| s - p);
    let squares: f64 = off().map(|d| d * d).sum();
    Errors {
        rmse: (squares * exact.len() as f64).sqrt(),
        variation: 0.5 * off().map(f64::abs).sum::<f64>(),
    }
}
