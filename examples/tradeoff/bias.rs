//! The bias of the cells' probabilities, and after how many samples a chi-square test would detect it.
//!
//! A map is held against the exact one over the grid of explicit uniforms, of 24 or 32 bits. Warps that draw from finer
//! ones (`Warp::sample_words`) are so judged by their map; of their draws the chi-square tests tell.
//! A cell gains what the map carries in across its borders and loses what it carries out; nothing else counts, so
//! uniforms are tried next to the borders, at distances that are spread evenly over all orders of magnitude, each
//! with the weight of what it stands for. Each distance of the grid has a chance known exactly, so the estimate is
//! of the map, its uniforms included, and without bias. What the grid alone puts into a cell too much or too little
//! is added exactly.
//!
//! That gives p − p₀ of every cell, with noise. The sum of (p − p₀)²/p₀ would count the noise. So there are several
//! independent runs, and only products of different runs are summed: their mean is free of noise. The jackknife gives
//! the standard error. A result within three standard errors of 0 counts as no bias, and a bound is stated instead.

use crate::cells;
use crate::power::Power;
use crate::sampler::{Chance, Law, Map, Words};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// Runs whose noise is independent.
const RUNS: usize = 16;
/// A noncentrality within this many standard errors of 0 counts as none. A bound lies as many above the estimate.
const DOUBT: f64 = 3.0;

/// A noncentrality a sample: the sum of (p − p₀)²/p₀ over the cells.
#[derive(Clone, Copy, Debug)]
pub struct Bias {
    pub lambda: f64,
    /// Its standard error.
    pub error: f64,
    pub cells: usize,
}

/// How many samples reveal a bias.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shows {
    After(f64),
    NotBelow(f64),
}

impl Bias {
    /// Of cells whose probabilities are known beside what they should be.
    pub fn exact(entries: &[Chance]) -> Self {
        let terms = entries.iter().map(|e| (e.realised - e.due).powi(2) / e.due);
        Self {
            lambda: terms.sum(),
            error: 0.0,
            cells: entries.len(),
        }
    }

    pub fn shows(&self) -> Shows {
        let needed = Power::of(self.cells - 1).needed();
        if self.lambda > DOUBT * self.error {
            Shows::After(needed / self.lambda)
        } else {
            Shows::NotBelow(needed / (self.lambda.max(0.0) + DOUBT * self.error))
        }
    }
}

/// Estimates the bias of a map of one or two uniforms, with so many uniforms at a border of a cell and run.
pub fn estimate(map: &Map, law: &Law, uniforms: usize, rng: &mut Pcg32) -> Bias {
    let grid = Grid::new(map, law);
    let runs: Vec<Vec<f64>> = (0..RUNS).map(|_| grid.run(uniforms, rng)).collect();
    Bias {
        cells: grid.due.len(),
        ..products(&runs, &grid.due)
    }
}

/// The mean product of two different runs, summed over the cells, and its standard error.
fn products(runs: &[Vec<f64>], due: &[f64]) -> Bias {
    let all: Vec<f64> = (0..due.len())
        .map(|cell| runs.iter().map(|run| run[cell]).sum())
        .collect();
    let (mut squares, mut own) = (0.0, vec![0.0; runs.len()]);
    let mut crossed = vec![0.0; runs.len()];
    for (cell, due) in due.iter().enumerate() {
        squares += all[cell] * all[cell] / due;
        for (k, run) in runs.iter().enumerate() {
            own[k] += run[cell] * run[cell] / due;
            crossed[k] += run[cell] * all[cell] / due;
        }
    }
    let count = runs.len() as f64;
    let mean = |squares: f64, own: f64, count: f64| (squares - own) / (count * (count - 1.0));
    let total: f64 = own.iter().sum();
    let lambda = mean(squares, total, count);
    // Without run k: (S − d)² = S² − 2 S d + d².
    let without = |k: usize| {
        let squares = squares - 2.0 * crossed[k] + own[k];
        mean(squares, total - own[k], count - 1.0)
    };
    let spread = (0..runs.len()).map(|k| (without(k) - lambda).powi(2));
    Bias {
        lambda,
        error: ((count - 1.0) / count * spread.sum::<f64>()).sqrt(),
        cells: due.len(),
    }
}

/// The uniforms of a part of an axis: those from the first to before the last.
#[derive(Clone, Copy)]
struct Part {
    first: u64,
    last: u64,
}

struct Grid<'a> {
    map: &'a Map,
    law: &'a Law,
    axes: Vec<Vec<Part>>,
    /// The probability of each cell by the exact map of exact uniforms, and that by the exact map of the grid.
    due: Vec<f64>,
    gridded: Vec<f64>,
}

impl<'a> Grid<'a> {
    fn new(map: &'a Map, law: &'a Law) -> Self {
        let all = 1_u64 << map.bits;
        let parts = |&parts: &usize| {
            let start = |part: usize| (all * part as u64).div_ceil(parts as u64);
            let part = |part| Part {
                first: start(part),
                last: start(part + 1),
            };
            (0..parts).map(part).collect::<Vec<_>>()
        };
        let axes: Vec<_> = cells::grid(law.axes).iter().map(parts).collect();
        let share = |part: &Part| (part.last - part.first) as f64 / all as f64;
        let gridded = axes.iter().fold(vec![1.0], |shares: Vec<f64>, axis| {
            let of = |before: &f64| {
                axis.iter()
                    .map(|part| before * share(part))
                    .collect::<Vec<_>>()
            };
            shares.iter().flat_map(of).collect()
        });
        let cells = cells::count(law.axes);
        Self {
            map,
            law,
            axes,
            due: vec![1.0 / cells as f64; cells],
            gridded,
        }
    }

    /// Where a map brings the uniforms with these numbers, in parts of each axis.
    fn arrival(&self, numbers: [u64; 2]) -> [usize; 2] {
        let word = |number: u64| (number << (32 - self.map.bits)) as u32;
        let words: Words = [word(numbers[0]), word(numbers[1]), 0, 0];
        let u = self.law.truth.invert((self.map.at)(words).0);
        std::array::from_fn(|axis| {
            self.axes
                .get(axis)
                .map_or(0, |parts| cells::part(u[axis], parts.len()))
        })
    }

    /// p − p₀ of every cell, with noise.
    fn run(&self, uniforms: usize, rng: &mut Pcg32) -> Vec<f64> {
        let mut gain: Vec<f64> = self
            .gridded
            .iter()
            .zip(&self.due)
            .map(|(p, due)| p - due)
            .collect();
        let second = self.axes.get(1).map_or(1, Vec::len);
        for axis in 0..self.axes.len() {
            for cell in 0..self.due.len() {
                let place = [cell / second, cell % second];
                for upper in [false, true] {
                    self.border(axis, place, upper, uniforms, rng, &mut gain);
                }
            }
        }
        gain
    }

    /// What comes of the half of a cell next to its lower or upper border of an axis.
    ///
    /// A point changes its part of the first axis where it has come to in the second, and its part of the second
    /// where it was in the first: so both changes together are the whole one, and each is found next to a border
    /// of its own axis.
    fn border(
        &self,
        axis: usize,
        place: [usize; 2],
        upper: bool,
        uniforms: usize,
        rng: &mut Pcg32,
        gain: &mut [f64],
    ) {
        let part = self.axes[axis][place[axis]];
        let middle = part.first.midpoint(part.last);
        let half = if upper {
            part.last - middle
        } else {
            middle - part.first
        };
        let other = self.axes.get(1 - axis).map(|parts| parts[place[1 - axis]]);
        let breadth = other.map_or(1, |other| other.last - other.first);
        let (log, all) = (((half + 1) as f64).ln(), (1_u64 << self.map.bits) as f64);
        let second = self.axes.get(1).map_or(1, Vec::len);
        let first_stratum = unit(rng);
        for k in 0..uniforms {
            // Of a distance the chance is that of its bracket of [1, half + 1) on a logarithmic scale.
            let t = (k as f64 + unit(rng)) / uniforms as f64;
            let distance = (((t * log).exp() as u64).max(1) - 1).min(half - 1);
            let chance = ((distance + 2) as f64 / (distance + 1) as f64).ln() / log;
            let number = if upper {
                part.last - 1 - distance
            } else {
                part.first + distance
            };
            // Along the border evenly, in no step with the distance.
            let along = (first_stratum + 0.618_033_988_749_895 * k as f64).fract();
            let across = other.map_or(0, |other| {
                other.first + ((along * breadth as f64) as u64).min(breadth - 1)
            });
            let numbers = if axis == 0 {
                [number, across]
            } else {
                [across, number]
            };
            let arrival = self.arrival(numbers);
            if arrival[axis] != place[axis] {
                let mut weight = breadth as f64 / all / (chance * uniforms as f64);
                if self.axes.len() > 1 {
                    weight /= all;
                }
                // Of the first axis with the second as it has become, of the second with the first as it was.
                let index = |[a, b]: [usize; 2]| a * second + b;
                let (from, to) = if axis == 0 {
                    ([place[0], arrival[1]], arrival)
                } else {
                    (place, [place[0], arrival[1]])
                };
                gain[index(from)] -= weight;
                gain[index(to)] += weight;
            }
        }
    }
}

/// A number in [0, 1).
fn unit(rng: &mut Pcg32) -> f64 {
    f64::from(rng.next_u32()) / 4_294_967_296.0
}

/// The number of half cells next to a border, in all runs.
pub fn borders(axes: usize) -> usize {
    RUNS * 2 * axes * cells::count(axes)
}
