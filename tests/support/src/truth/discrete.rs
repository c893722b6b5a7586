//! Exact counterparts of the piecewise-constant densities, from the weights and not from a table.

use super::{Point, Truth, Uniforms};

/// The edges of equal cells, which are `f32` by definition: as the documentation of
/// `PiecewiseConstant1d` gives them, operation by operation.
pub fn edges([low, high]: [f32; 2], count: usize) -> Vec<f64> {
    let edge = |j: usize| {
        let t = j as f32 / count as f32;
        f64::from((1.0 - t) * low + t * high)
    };
    (0..=count).map(edge).collect()
}

/// A density that is constant between edges.
pub struct Histogram {
    edges: Vec<f64>,
    densities: Vec<f64>,
    /// The CDF at the upper edge of each cell.
    ends: Vec<f64>,
    last: usize,
}

impl Histogram {
    /// Nothing where all weights are zero.
    pub fn new(weights: &[f64], range: [f32; 2]) -> Option<Self> {
        let edges = edges(range, weights.len());
        let total: f64 = weights.iter().sum();
        let last = weights.iter().rposition(|w| *w > 0.0)?;
        let mut sum = 0.0;
        let ends = weights.iter().map(|w| {
            sum += w;
            sum / total
        });
        let ends = ends.collect();
        let widths = edges.windows(2).map(|e| e[1] - e[0]);
        let densities = weights.iter().zip(widths).map(|(w, l)| w / total / l);
        Some(Self {
            densities: densities.collect(),
            edges,
            ends,
            last,
        })
    }

    fn start(&self, cell: usize) -> f64 {
        if cell > 0 { self.ends[cell - 1] } else { 0.0 }
    }

    /// The cell of a uniform; one of positive weight.
    fn select(&self, u: f64) -> usize {
        self.ends.partition_point(|end| *end <= u).min(self.last)
    }

    fn quantile(&self, u: f64) -> f64 {
        let i = self.select(u);
        let share = (u - self.start(i)) / (self.ends[i] - self.start(i));
        self.edges[i] + share * (self.edges[i + 1] - self.edges[i])
    }

    /// The cell of a point. An edge between a cell and one of weight zero above it counts to the former,
    /// so that a quantile that is rounded onto it still has a density here.
    fn cell(&self, x: f64) -> usize {
        let above = self.edges.partition_point(|edge| *edge <= x);
        let i = above.saturating_sub(1).min(self.densities.len() - 1);
        let shared = i > 0 && self.densities[i] == 0.0 && x == self.edges[i];
        i - usize::from(shared)
    }

    fn pdf(&self, x: f64) -> f64 {
        if (self.edges[0]..=self.edges[self.densities.len()]).contains(&x) {
            self.densities[self.cell(x)]
        } else {
            0.0
        }
    }

    fn cdf(&self, x: f64) -> f64 {
        let i = self.cell(x);
        let share = (x - self.edges[i]) / (self.edges[i + 1] - self.edges[i]);
        self.start(i) + share * (self.ends[i] - self.start(i))
    }
}

impl Truth for Histogram {
    fn sample(&self, u: Uniforms) -> Point {
        [self.quantile(u[0]), 0.0, 0.0]
    }
    fn pdf(&self, x: Point) -> f64 {
        self.pdf(x[0])
    }
    fn invert(&self, x: Point) -> Uniforms {
        [self.cdf(x[0]), 0.0, 0.0, 0.0]
    }
}

/// A density that is constant on the cells of a grid: a row by its sum, then a column of the row.
pub struct Picture {
    marginal: Histogram,
    /// Nothing for a row of zeros.
    rows: Vec<Option<Histogram>>,
}

impl Picture {
    pub fn new(weights: &[f32], columns: usize, u: [f32; 2], v: [f32; 2]) -> Self {
        let weights: Vec<f64> = weights.iter().map(|w| f64::from(*w)).collect();
        let rows = || weights.chunks_exact(columns);
        let sums: Vec<f64> = rows().map(|row| row.iter().sum()).collect();
        let rows = rows().map(|row| Histogram::new(row, u)).collect();
        Self::of(Histogram::new(&sums, v).expect("a positive weight"), rows)
    }

    /// Of a distribution of the rows, and one in each of them.
    pub fn of(marginal: Histogram, rows: Vec<Option<Histogram>>) -> Self {
        Self { marginal, rows }
    }
}

impl Truth for Picture {
    fn sample(&self, u: Uniforms) -> Point {
        let row = self.rows[self.marginal.select(u[1])].as_ref();
        let x = row.expect("a row of positive weight").quantile(u[0]);
        [x, self.marginal.quantile(u[1]), 0.0]
    }
    fn pdf(&self, x: Point) -> f64 {
        let row = self.rows[self.marginal.cell(x[1])].as_ref();
        self.marginal.pdf(x[1]) * row.map_or(0.0, |row| row.pdf(x[0]))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let row = self.rows[self.marginal.cell(x[1])].as_ref();
        let u = row.map_or(0.0, |row| row.cdf(x[0]));
        [u, self.marginal.cdf(x[1]), 0.0, 0.0]
    }
}
