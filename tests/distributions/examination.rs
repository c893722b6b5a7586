//! One entry under examination: what is expected of its samples, and what a run of them gave.
//!
//! Cells are a grid in the unit square (or cube) of the entry's chart; what they should hold comes from the warp's
//! own density by quadrature. Which entries are examined, and how often, is not said here.

use crate::moments::{self, Coordinates, moments};
use crate::report::Report;
use host::registry::{Domain, Entry, Measure};
use host::stats::{self, Axis};
use host::truth::Point;
use rand_pcg::Pcg32;

/// How far the integral of a density may be from 1. The worst of the registry is off by 1.8e-7, which is
/// three roundings of an `f32`.
const INTEGRAL: f64 = 1e-6;

/// Samples are drawn by so many.
const CHUNK: usize = 1 << 14;

/// What is expected of an entry.
pub struct Examination<'a> {
    entry: &'a Entry,
    /// Samples of a run.
    pub samples: usize,
    axes: [Axis; 3],
    /// The probability of each cell, row by row.
    cells: Vec<f64>,
    /// The integral of the density.
    pub integral: f64,
    coordinates: Coordinates,
    centre: Point,
    spread: Point,
    /// The exact mean of each moment in standardised coordinates.
    means: Vec<f64>,
    /// By how much each coordinate of a sample may be wrong: a few ulp of its extent.
    rounding: Point,
}

fn wide(x: [f32; 3]) -> Point {
    x.map(f64::from)
}

impl<'a> Examination<'a> {
    /// Lays out the cells and computes what is expected of (at most) `samples` samples.
    pub fn new(entry: &'a Entry, samples: usize) -> Self {
        let line = entry.domain == Domain::Line;
        let (samples, axes) = if line {
            let (cells, samples) = stats::resolve(entry, samples);
            let axis = Axis::new(cells, |u| stats::between_floats(entry, u));
            (samples, [axis, Axis::none(), Axis::none()])
        } else if moments::axes(entry.domain) == 3 {
            (samples, [15, 13, 11].map(|cells| Axis::new(cells, |u| u)))
        } else {
            // In the plane and over directions the cells are so wide beside the rounding of a point
            // (at most 1e-5 of the unit square, in the tile of 1e-3) that it needs no care.
            let [first, second] = [63, 31].map(|cells| Axis::new(cells, |u| u));
            (samples, [first, second, Axis::none()])
        };
        let mut this = Self {
            entry,
            samples,
            cells: vec![0.0; axes.iter().map(Axis::cells).product()],
            axes,
            integral: 0.0,
            coordinates: Coordinates::Point,
            centre: [0.0; 3],
            spread: [1.0; 3],
            means: Vec::new(),
            rounding: [0.0; 3],
        };
        let nodes = this.integrate(match moments::axes(entry.domain) {
            1 => 20,
            2 => 12,
            _ => 6,
        });
        this.choose_rounding(&nodes);
        this.choose_coordinates(&nodes);
        this
    }

    /// Integrates the density over each cell: the integral over the cell of the warp's density divided
    /// by the chart's. Returns the nodes as (point, place in the chart, probability).
    fn integrate(&mut self, grades: i32) -> Vec<(Point, Point, f64)> {
        let [first, second] = [self.axes[0].nodes(grades), self.axes[1].nodes(0)];
        let third = match self.axes[2].count() {
            // No such axis.
            1 => vec![(0, 0.0, 1.0)],
            _ => self.axes[2].nodes(0),
        };
        let mut nodes = Vec::with_capacity(first.len() * second.len() * third.len());
        for &(i, u, across) in &first {
            for &(j, v, along) in &second {
                for &(k, w, up) in &third {
                    let rounded = self.entry.chart.sample([u, v, w, 0.0]).map(|c| c as f32);
                    let x = wide(rounded);
                    // Both at the rounded point, so that its rounding cancels.
                    let ratio = f64::from(self.entry.warp.pdf(rounded)) / self.entry.chart.pdf(x);
                    let probability = across * along * up * ratio;
                    let cell = self.cell([i, j, k]);
                    self.cells[cell] += probability;
                    self.integral += probability;
                    nodes.push((x, [u, v, w], probability));
                }
            }
        }
        nodes
    }

    fn cell(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.axes[1].cells() + j) * self.axes[2].cells() + k
    }

    fn choose_rounding(&mut self, nodes: &[(Point, Point, f64)]) {
        let extent = |k: usize| nodes.iter().map(|n| n.0[k].abs()).fold(0.0, f64::max);
        let size = match self.entry.measure {
            Measure::UlpOf(size) => [size, 0.0, 0.0],
            Measure::UlpAbove(size) => [size, 0.0, 0.0],
            Measure::UlpFrom(mean, least) => [mean.abs().max(least), 0.0, 0.0],
            // Relative to each sample; see `strays`.
            Measure::Ulp => [0.0; 3],
            Measure::From([a, b]) => [a.abs(), b.abs(), 0.0],
            Measure::Length(_) => [extent(0), extent(1), extent(2)],
        };
        self.rounding = size.map(|s| 4.0 * f64::from(f32::EPSILON) * s);
    }

    fn choose_coordinates(&mut self, nodes: &[(Point, Point, f64)]) {
        if self.entry.domain == Domain::Directions {
            let (low, high) = nodes.iter().fold((1.0, -1.0), |(low, high), n| {
                (n.0[2].min(low), n.0[2].max(high))
            });
            // z in fewer than some 1e4 steps of f32 has moments that rounding changes.
            if high - low < 1e-3 {
                self.coordinates = Coordinates::Complement;
            }
        }
        let skewness = self.standardise(nodes);
        // The first term of Edgeworth's series at the threshold of some 6.5 standard deviations: where
        // it is not small, the mean of that many samples is not yet normal there.
        let correction = skewness * 6.5f64.powi(3) / (6.0 * (self.samples as f64).sqrt());
        // Nor do the nodes resolve a jump.
        if correction > 0.25 || self.entry.jumps {
            self.coordinates = Coordinates::Quantile;
            self.standardise(nodes);
        }
    }

    /// Computes centre, spread and exact moments; returns the largest skewness of what is averaged.
    fn standardise(&mut self, nodes: &[(Point, Point, f64)]) -> f64 {
        let coordinates = self.coordinates;
        let mut centre = [0.0; 3];
        for &(x, u, p) in nodes {
            let at = coordinates.of(x, u);
            centre = std::array::from_fn(|k| centre[k] + p * at[k]);
        }
        let mut squares = [0.0; 3];
        for &(x, u, p) in nodes {
            let off = coordinates.of(x, u);
            squares = std::array::from_fn(|k| squares[k] + p * (off[k] - centre[k]).powi(2));
        }
        (self.centre, self.spread) = (centre, squares.map(f64::sqrt));
        let moments = moments(self.entry.domain);
        // Of each moment's value, its square and its cube; of standardised points no digits are lost below.
        let mut sums = vec![[0.0; 3]; moments.len()];
        for &(x, u, p) in nodes {
            let t = self.standard(x, u);
            for (sums, moment) in sums.iter_mut().zip(&moments) {
                let value = moment.of(&t);
                let square = value * value;
                *sums = [
                    sums[0] + p * value,
                    sums[1] + p * square,
                    sums[2] + p * square * value,
                ];
            }
        }
        self.means = sums.iter().map(|[mean, ..]| *mean).collect();
        let skewness = sums.iter().map(|&[mean, square, cube]| {
            let variance = square - mean * mean;
            let third = cube - mean * (3.0 * square - 2.0 * mean * mean);
            third.abs() / variance.powf(1.5)
        });
        skewness.fold(0.0, f64::max)
    }

    fn standard(&self, x: Point, u: Point) -> Point {
        let y = self.coordinates.of(x, u);
        std::array::from_fn(|k| (y[k] - self.centre[k]) / self.spread[k])
    }

    /// Whether chart coordinates outside the unit square, or NaN, are more than the point's rounding.
    fn strays(&self, x: Point, u: [f64; 3]) -> bool {
        let invert = |x| self.entry.chart.invert(x);
        let at = invert(x);
        let mut slack = [1e-12; 3];
        for k in 0..3 {
            let mut near = x;
            near[k] += self.rounding[k].max(f64::from(f32::EPSILON) * x[k].abs());
            for (slack, (moved, at)) in slack.iter_mut().zip(invert(near).into_iter().zip(at)) {
                *slack += (moved - at).abs();
            }
        }
        let inside = (0..3).all(|i| u[i] >= -slack[i] && u[i] <= 1.0 + slack[i]);
        !inside
    }

    /// Draws the samples through `Warp::fill` and tests them.
    pub fn run(&self, seed: u64) -> Report {
        let mut rng = Pcg32::new(seed, seed);
        let moments = moments(self.entry.domain);
        let mut tally = [0, 1, 2].map(|i: usize| vec![0_u64; self.axes[i].count()]);
        let mut observed = vec![0_u64; self.cells.len()];
        let mut sums = vec![(0.0, 0.0); moments.len()];
        let mut faults = Vec::new();
        let mut left = self.samples;
        while left > 0 {
            let points = self.entry.warp.fill(&mut rng, left.min(CHUNK));
            left -= points.len();
            for (i, &point) in points.iter().enumerate() {
                let x = wide(point);
                let [u, v, w, _] = self.entry.chart.invert(x);
                let inside = [u, v, w].iter().all(|u| (0.0..=1.0).contains(u));
                if !inside && self.strays(x, [u, v, w]) {
                    faults.push(format!(
                        "{point:?} lies outside the domain, at ({u}, {v}, {w})"
                    ));
                }
                let seen = i % 64 > 0 || self.entry.warp.pdf(point) > 0.0;
                if !seen {
                    faults.push(format!(
                        "{point:?} has density {}",
                        self.entry.warp.pdf(point)
                    ));
                }
                let found: [usize; 3] = std::array::from_fn(|k| self.axes[k].find([u, v, w][k]));
                for (tally, found) in tally.iter_mut().zip(found) {
                    tally[found] += 1;
                }
                observed[self.cell(std::array::from_fn(|k| found[k] / self.axes[k].fine))] += 1;
                let t = self.standard(x, [u, v, w]);
                for ((sum, moment), mean) in sums.iter_mut().zip(&moments).zip(&self.means) {
                    let off = moment.of(&t) - mean;
                    *sum = (sum.0 + off, sum.1 + off * off);
                }
            }
            if !faults.is_empty() {
                // The rest would say the same; what is left of the tests is of no account.
                faults.truncate(4);
                break;
            }
        }
        self.judge(&observed, &tally, &sums, faults)
    }

    fn judge(
        &self,
        observed: &[u64],
        tally: &[Vec<u64>; 3],
        sums: &[(f64, f64)],
        mut faults: Vec<String>,
    ) -> Report {
        let n = self.samples as f64;
        let normal = (self.integral - 1.0).abs() <= INTEGRAL;
        if !normal {
            faults.push(format!("the density integrates to {}", self.integral));
        }
        let expected: Vec<f64> = self.cells.iter().map(|p| n * p).collect();
        let (chi2, dof, p) = stats::chi_square(observed, &expected).unwrap_or_else(|fault| {
            faults.push(fault);
            (f64::NAN, 0, f64::NAN)
        });
        let mut tests = vec![("chi-square".to_string(), p)];
        for (axis, tally) in self
            .axes
            .iter()
            .zip(tally)
            .filter(|(axis, _)| axis.count() > 1)
        {
            let (mut below, mut distance) = (0, 0.0_f64);
            for (count, border) in tally.iter().zip(&axis.borders[1..]) {
                below += count;
                distance = distance.max((below as f64 / n - border).abs());
            }
            tests.push(("distance".to_string(), stats::kolmogorov(distance, n)));
        }
        for (moment, (sum, squares)) in moments(self.entry.domain).into_iter().zip(sums) {
            let (mean, square) = (sum / n, squares / n);
            let error = ((square - mean * mean) / n).sqrt();
            tests.push((moment.name(), stats::two_sided(mean / error)));
        }
        Report {
            chi2,
            dof,
            tests,
            faults,
        }
    }
}
