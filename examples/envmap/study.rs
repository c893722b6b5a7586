//! What is measured for one table, and whether it samples the picture's distribution.

use microwarp::discrete::{Grid, PiecewiseConstant2d, Storage, Word};
use microwarp::{Error, Warp};
use rand_pcg::Pcg32;
use std::time::Instant;
use support::stats;
use support::verdict::{Outcome, passes};

/// Azimuth and polar angle in turns, as `Spherical` has them.
pub const RANGE: [[f32; 2]; 2] = [[0.0, 1.0], [0.0, 0.5]];

/// The picture's own probabilities, computed without any table.
#[derive(Clone)]
pub struct Truth {
    /// Columns, rows.
    pub shape: [usize; 2],
    pub probabilities: Vec<f64>,
}

impl Truth {
    pub fn new(weights: &[f32], shape: [usize; 2]) -> Self {
        let sum: f64 = weights.iter().map(|&w| f64::from(w)).sum();
        Self {
            shape,
            probabilities: weights.iter().map(|&w| f64::from(w) / sum).collect(),
        }
    }

    pub fn expected(&self, samples: usize) -> Vec<f64> {
        let counts = self.probabilities.iter().map(|p| p * samples as f64);
        counts.collect()
    }

    /// The cell of a point, without asking the table. Numbers of cells are powers of two and ranges are
    /// as well, so this is exact.
    pub fn cell(&self, [phi, theta]: [f32; 2]) -> usize {
        let [columns, rows] = self.shape;
        (2.0 * theta * rows as f32) as usize * columns + (phi * columns as f32) as usize
    }

    pub fn middle(&self, cell: usize) -> [f32; 2] {
        let [columns, rows] = self.shape;
        let (column, row) = ((cell % columns) as f32, (cell / columns) as f32);
        [
            (column + 0.5) / columns as f32,
            0.5 * (row + 0.5) / rows as f32,
        ]
    }

    pub fn brightest(&self) -> usize {
        let cells = 0..self.probabilities.len();
        cells
            .max_by(|&a, &b| self.probabilities[a].total_cmp(&self.probabilities[b]))
            .unwrap_or(0)
    }

    pub fn histogram(&self, points: impl IntoIterator<Item = [f32; 2]>) -> Vec<u64> {
        let mut histogram = vec![0; self.probabilities.len()];
        points
            .into_iter()
            .for_each(|point| histogram[self.cell(point)] += 1);
        histogram
    }

    /// The chi-square test of a histogram; cells expecting fewer than 5 are pooled, and a sample in a
    /// black one is an error.
    pub fn test(&self, histogram: &[u64]) -> Outcome {
        let samples: u64 = histogram.iter().sum();
        stats::chi_square(histogram, &self.expected(samples as usize))
    }
}

pub struct Study {
    pub name: &'static str,
    pub shape: [usize; 2],
    /// Bytes of words, and of the value that refers to them or holds them.
    pub bytes: [usize; 2],
    /// Seconds; `None` if the compiler built it.
    pub build: Option<f64>,
    pub samples_a_second: f64,
    pub outcome: Outcome,
    /// The density per steradian in the middle of the brightest texel.
    pub peak: f64,
    /// The largest error of a density, relative to that of the picture, over all cells.
    pub worst: f64,
    pub histogram: Vec<u64>,
    pub complaints: Vec<String>,
}

/// The density per steradian at a point, from one per square of a turn.
pub fn per_steradian(density: f32, theta: f32) -> f64 {
    let turn = std::f64::consts::TAU;
    f64::from(density) / (turn * turn * (turn * f64::from(theta)).sin())
}

impl Study {
    pub fn new<W, M, C>(
        name: &'static str,
        table: &PiecewiseConstant2d<M, C>,
        truth: &Truth,
        samples: usize,
        rng: &mut Pcg32,
    ) -> Self
    where
        W: Word,
        M: Storage<Item = W>,
        C: Grid<Item = W>,
    {
        let mut points = vec![[0.0; 2]; samples];
        let start = Instant::now();
        table.fill(rng, &mut points);
        let samples_a_second = samples as f64 / start.elapsed().as_secs_f64();

        let width = truth.shape[0];
        let mut complaints = Vec::new();
        let strange = points.iter().filter(|&&point| {
            let [column, row] = table.cell(point);
            row * width + column != truth.cell(point) || table.pdf(point) <= 0.0
        });
        match strange.count() {
            0 => {}
            n => complaints.push(format!(
                "{name}: {n} samples of density 0 or in a wrong cell"
            )),
        }
        let (mut worst, area) = (0_f64, 0.5 / truth.probabilities.len() as f64);
        for (cell, &p) in truth.probabilities.iter().enumerate() {
            let density = f64::from(table.pdf(truth.middle(cell)));
            if (density > 0.0) != (p > 0.0) {
                complaints.push(format!("{name}: density {density} in a cell of {p}"));
            } else if p > 0.0 {
                worst = worst.max((density * area / p - 1.0).abs());
            }
        }
        let histogram = truth.histogram(points);
        let outcome = truth.test(&histogram);
        if !passes(&outcome) {
            complaints.push(format!(
                "{name}: samples do not follow the picture, {outcome:?}"
            ));
        }
        let middle = truth.middle(truth.brightest());
        let (rows, cells) = table.as_words();
        Self {
            name,
            shape: table.shape(),
            bytes: [size_of_val(rows) + size_of_val(cells), size_of_val(table)],
            build: None,
            samples_a_second,
            outcome,
            peak: per_steradian(table.pdf(middle), middle[1]),
            worst,
            histogram,
            complaints,
        }
    }
}

/// Builds tables in memory of their own, so that one can be built again and timed.
pub struct Memory<W> {
    rows: Vec<W>,
    cells: Vec<W>,
}

macro_rules! memory {
    ($word:ident) => {
        impl Memory<$word> {
            pub fn new([columns, rows]: [usize; 2]) -> Self {
                Self {
                    rows: vec![0; rows],
                    cells: vec![0; rows * columns],
                }
            }

            pub fn build(
                &mut self,
                weights: &[f32],
                shape: [usize; 2],
            ) -> Result<PiecewiseConstant2d<&[$word], &[$word]>, Error> {
                let [u, v] = RANGE;
                PiecewiseConstant2d::<&[$word], &[$word]>::new_in(
                    weights,
                    shape,
                    u,
                    v,
                    &mut self.rows,
                    &mut self.cells,
                )
            }

            /// The seconds that building takes, the shortest of some times.
            pub fn time(&mut self, weights: &[f32], shape: [usize; 2]) -> Result<f64, Error> {
                let mut shortest = f64::INFINITY;
                for _ in 0..9 {
                    let start = Instant::now();
                    std::hint::black_box(self.build(weights, shape)?);
                    shortest = shortest.min(start.elapsed().as_secs_f64());
                }
                Ok(shortest)
            }
        }
    };
}

memory!(u32);
memory!(u64);
