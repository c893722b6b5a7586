//! Autocorrelation times of any length, from the same numbers thinned more and more.

use microwarp::metropolis::Autocorrelation;

/// With fewer numbers than this, an apparent end of correlation is chance.
const LEAST: u64 = 128;

/// [`Autocorrelation`] of the numbers of a run, of every fourth of them, of every sixteenth, and so on.
pub struct Ladder<const LAGS: usize> {
    /// How many numbers are skipped for each one taken, and the autocorrelation of those taken.
    rungs: Vec<(u64, Autocorrelation<LAGS>)>,
    seen: u64,
}

/// An integrated autocorrelation time, with the count and spacing of the numbers it was measured from.
#[derive(Clone, Copy)]
pub struct Time {
    pub steps: f64,
    pub stride: u64,
    pub numbers: u64,
}

impl<const LAGS: usize> Ladder<LAGS> {
    /// For a run of this many steps. The finest rung takes one number in `first`.
    pub fn new(first: u64, steps: u64) -> Self {
        let strides = std::iter::successors(Some(first), |stride| Some(4 * stride));
        let rungs = strides.take_while(|&stride| stride == first || steps / stride >= LEAST);
        Self {
            rungs: rungs
                .map(|stride| (stride, Autocorrelation::new()))
                .collect(),
            seen: 0,
        }
    }

    pub fn push(&mut self, x: f32) {
        self.seen += 1;
        for (stride, health) in &mut self.rungs {
            if self.seen % *stride != 0 {
                break;
            }
            health.push(x);
        }
    }

    /// The time by the finest rung whose lags outlast the correlation; `None` if no rung does, or if all numbers are
    /// equal.
    pub fn time(&self) -> Option<Time> {
        let known = |(stride, health): &(u64, Autocorrelation<LAGS>)| {
            Some(Time {
                steps: *stride as f64 * f64::from(health.integrated_time()?),
                stride: *stride,
                numbers: health.count(),
            })
        };
        self.rungs.iter().find_map(known)
    }
}
