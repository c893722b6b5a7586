//! The test of a chain's states: thinned until they are independent, and compared with the target's bins.

use crate::kernel::Truth;
use crate::target::{BINS, bin, probabilities};
use support::stats;
use support::verdict::Outcome;

/// After this many relaxation times a state counts as independent of the one before: the dependence left is e⁻⁸.
const APART: f64 = 8.0;

/// A histogram of every n-th state.
pub struct Thinned {
    stride: u64,
    seen: u64,
    counts: Vec<u64>,
}

impl Thinned {
    pub fn new(truth: &Truth) -> Self {
        Self {
            stride: (APART * truth.relaxation()).ceil() as u64,
            seen: 0,
            counts: vec![0; BINS],
        }
    }

    pub fn push(&mut self, x: f32) {
        self.seen += 1;
        if self.seen % self.stride == 0 {
            self.counts[bin(x)] += 1;
        }
    }

    pub fn samples(&self) -> u64 {
        self.counts.iter().sum()
    }

    pub fn test(&self) -> Outcome {
        let samples = self.samples() as f64;
        let expected: Vec<f64> = probabilities(BINS).iter().map(|p| p * samples).collect();
        stats::chi_square(&self.counts, &expected)
    }
}
