//! Autocorrelation times of any length: the same numbers, more and more thinned.

use microwarp::metropolis::Autocorrelation;

/// With fewer numbers than this, what looks like the end of correlation is chance.
const LEAST: u64 = 128;

/// [`Autocorrelation`] of the numbers of a run, of every fourth of them, of every sixteenth, and so on.
pub struct Ladder<const LAGS: usize> {
    /// How many numbers are passed over for one that is taken, and what is known of those.
    rungs: Vec<(u64, Autocorrelation<LAGS>)>,
    seen: u64,
}

/// An integrated autocorrelation time, and from how many numbers how far apart it was found.
#[derive(Clone, Copy)]
pub struct Time {
    pub steps: f64,
    pub stride: u64,
    pub numbers: u64,
}

impl<const LAGS: usize> Ladder<LAGS> {
    /// For a run of so many steps: takes one number in `first`, and fewer.
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

    /// The time by the finest rung whose lags reach as far as correlation does; `None` where none does, or
    /// where all numbers are the same.
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
