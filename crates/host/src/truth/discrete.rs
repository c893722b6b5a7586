//! Exact counterparts of the tabulated densities, from the weights or from the exact probabilities of a table.

use super::{PI, Point, Real, TAU, Truth, Uniforms, complements, index, real, reals, turn};

/// The edges of equal cells, which are `f32` by definition: as the documentation of
/// `PiecewiseConstant1d` gives them, operation by operation.
fn edges([low, high]: [f32; 2], count: usize) -> Vec<Real> {
    let edge = |j: usize| {
        let t = j as f32 / count as f32;
        Real::from((1.0 - t) * low + t * high)
    };
    (0..=count).map(edge).collect()
}

/// A density that is constant between edges.
pub struct Histogram {
    edges: Vec<Real>,
    densities: Vec<Real>,
    /// The CDF at the upper edge of each cell.
    ends: Vec<Real>,
    last: usize,
}

impl Histogram {
    /// Nothing where all weights are zero.
    pub fn new(weights: &[Real], range: [f32; 2]) -> Option<Self> {
        let edges = edges(range, weights.len());
        let total: Real = weights.iter().sum();
        let last = weights.iter().rposition(|w| *w > 0.0)?;
        let mut sum = real(0.0);
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

    fn start(&self, cell: usize) -> Real {
        if cell > 0 {
            self.ends[cell - 1]
        } else {
            real(0.0)
        }
    }

    /// The cell of a uniform; one of positive weight.
    fn select(&self, u: Real) -> usize {
        self.ends.partition_point(|end| *end <= u).min(self.last)
    }

    fn quantile(&self, u: Real) -> Real {
        let i = self.select(u);
        let share = (u - self.start(i)) / (self.ends[i] - self.start(i));
        self.edges[i] + share * (self.edges[i + 1] - self.edges[i])
    }

    /// The cell of a point. An edge between a cell and one of weight zero above it counts to the former,
    /// so that a quantile that is rounded onto it still has a density here.
    fn cell(&self, x: Real) -> usize {
        let above = self.edges.partition_point(|edge| *edge <= x);
        let i = above.saturating_sub(1).min(self.densities.len() - 1);
        let shared = i > 0 && self.densities[i] == 0.0 && x == self.edges[i];
        i - usize::from(shared)
    }

    fn pdf(&self, x: Real) -> Real {
        if (self.edges[0]..=self.edges[self.densities.len()]).contains(&x) {
            self.densities[self.cell(x)]
        } else {
            real(0.0)
        }
    }

    fn cdf(&self, x: Real) -> Real {
        let i = self.cell(x);
        let share = (x - self.edges[i]) / (self.edges[i + 1] - self.edges[i]);
        self.start(i) + share * (self.ends[i] - self.start(i))
    }
}

/// A density that is linear between edges: a cell by its probability, then a place by the weights at its ends.
pub struct Polyline {
    cells: Histogram,
    weights: Vec<Real>,
}

impl Polyline {
    /// Of the probabilities of the cells, or numbers in proportion, and the weights of the edges.
    pub fn new(cells: &[f64], range: [f32; 2], weights: &[f32]) -> Self {
        let cells = Histogram::new(&reals(cells), range).expect("a positive area");
        let weights = weights.iter().map(|w| Real::from(*w)).collect();
        Self { cells, weights }
    }

    fn ends(&self, cell: usize) -> [Real; 2] {
        [self.weights[cell], self.weights[cell + 1]]
    }

    /// The cell of a point, and the parts of it below and above.
    fn place(&self, x: Real) -> (usize, Real, Real) {
        let i = self.cells.cell(x);
        let [low, high] = [self.cells.edges[i], self.cells.edges[i + 1]];
        (i, (x - low) / (high - low), (high - x) / (high - low))
    }
}

impl Truth for Polyline {
    fn sample(&self, u: Uniforms) -> Point {
        let cells = &self.cells;
        let i = cells.select(u[0]);
        let mass = cells.ends[i] - cells.start(i);
        let (below, above) = (
            (u[0] - cells.start(i)) / mass,
            (cells.ends[i] - u[0]) / mass,
        );
        let [a, b] = self.ends(i);
        // The root of the quadratic that does not cancel, with the larger weight 1.
        let (a, b) = (a / a.max(b), b / a.max(b));
        let t = below * (a + b) / (a + (above * a * a + below * b * b).sqrt());
        // Nothing at the vertex itself where its weight is 0.
        let t = if t.is_nan() { real(0.0) } else { t };
        let [low, high] = [cells.edges[i], cells.edges[i + 1]];
        [low + t * (high - low), real(0.0), real(0.0)]
    }
    fn pdf(&self, x: Point) -> Real {
        let cells = &self.cells;
        if !(cells.edges[0]..=cells.edges[cells.densities.len()]).contains(&x[0]) {
            return real(0.0);
        }
        let (i, below, above) = self.place(x[0]);
        if cells.densities[i] == 0.0 {
            return real(0.0);
        }
        let [a, b] = self.ends(i);
        cells.densities[i] * 2.0 * (above * a + below * b) / (a + b)
    }
    fn invert(&self, x: Point) -> Uniforms {
        let (i, below, above) = self.place(x[0]);
        let [a, b] = self.ends(i);
        let share = if a + b > 0.0 {
            below * (a * (1.0 + above) + b * below) / (a + b)
        } else {
            real(0.0)
        };
        let (start, end) = (self.cells.start(i), self.cells.ends[i]);
        [
            start + share * (end - start),
            real(0.0),
            real(0.0),
            real(0.0),
        ]
    }
}

impl Truth for Histogram {
    fn sample(&self, u: Uniforms) -> Point {
        [self.quantile(u[0]), real(0.0), real(0.0)]
    }
    fn pdf(&self, x: Point) -> Real {
        self.pdf(x[0])
    }
    fn invert(&self, x: Point) -> Uniforms {
        [self.cdf(x[0]), real(0.0), real(0.0), real(0.0)]
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
        let weights: Vec<Real> = weights.iter().map(|w| Real::from(*w)).collect();
        let rows = || weights.chunks_exact(columns);
        let sums: Vec<Real> = rows().map(|row| row.iter().sum()).collect();
        let rows = rows().map(|row| Histogram::new(row, u)).collect();
        Self {
            marginal: Histogram::new(&sums, v).expect("a positive weight"),
            rows,
        }
    }

    /// Of a distribution of the rows, and one in each of them, each over its range.
    pub fn of((marginal, v): (&[f64], [f32; 2]), (rows, u): (&[Vec<f64>], [f32; 2])) -> Self {
        let rows = rows.iter().map(|row| Histogram::new(&reals(row), u));
        Self {
            marginal: Histogram::new(&reals(marginal), v).expect("a positive weight"),
            rows: rows.collect(),
        }
    }
}

impl Truth for Picture {
    fn sample(&self, u: Uniforms) -> Point {
        let row = self.rows[self.marginal.select(u[1])].as_ref();
        let x = row.expect("a row of positive weight").quantile(u[0]);
        [x, self.marginal.quantile(u[1]), real(0.0)]
    }
    fn pdf(&self, x: Point) -> Real {
        let row = self.rows[self.marginal.cell(x[1])].as_ref();
        self.marginal.pdf(x[1]) * row.map_or(real(0.0), |row| row.pdf(x[0]))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let row = self.rows[self.marginal.cell(x[1])].as_ref();
        let u = row.map_or(real(0.0), |row| row.cdf(x[0]));
        [u, self.marginal.cdf(x[1]), real(0.0), real(0.0)]
    }
}

/// A picture of all directions by latitude and longitude: a row, a column of the row, and a direction that is uniform in
/// solid angle within the pixel.
pub struct Sky {
    /// The rows over [0, 1], of which only the probabilities count.
    marginal: Histogram,
    rows: Vec<Option<Histogram>>,
}

/// How far a direction keeps from the edges of its pixel, so that `f64` finds the pixel again.
const INSIDE: f64 = 1e-10;

impl Sky {
    /// Of the probabilities of rows, and of columns in each of them.
    pub fn of(marginal: &[f64], rows: &[Vec<f64>]) -> Self {
        let Picture { marginal, rows } = Picture::of((marginal, [0.0, 1.0]), (rows, [0.0, 1.0]));
        Self { marginal, rows }
    }

    /// The largest probability, of a row or of a column within a row, of what is nearer to an edge than so many turns and,
    /// at the edge with q = 1 - |cos θ|, than a part of q that falls linearly from one value at the pole to half of it.
    pub fn beside(&self, turns: Real, part: Real) -> Real {
        let densities = self.rows.iter().flatten().flat_map(|row| &row.densities);
        let along = densities.map(|density| density * turns);
        let down = (0..self.rows.len()).map(|row| {
            let mass = self.marginal.ends[row] - self.marginal.start(row);
            let q = self.edges(row).map(|theta| {
                let [down, up] = Self::complements(theta);
                down.min(up)
            });
            let margin = q.map(|q| q * part * (1.0 - 0.5 * q));
            mass * (margin[0].max(margin[1]) / self.drop(row)).min(1.0)
        });
        along.chain(down).fold(real(0.0), Real::max)
    }

    /// The polar angles of a row's edges.
    fn edges(&self, row: usize) -> [Real; 2] {
        let rows = Real::from(self.rows.len() as u32);
        [row, row + 1].map(|j| PI * Real::from(j as u32) / rows)
    }

    /// 1 - cos θ and 1 + cos θ of an angle.
    fn complements(theta: Real) -> [Real; 2] {
        [
            2.0 * (0.5 * theta).sin().powi(2),
            2.0 * (0.5 * theta).cos().powi(2),
        ]
    }

    /// By how much the cosine falls in a row.
    fn drop(&self, row: usize) -> Real {
        let [a, b] = self.edges(row);
        2.0 * (0.5 * (a + b)).sin() * (0.5 * (b - a)).sin()
    }

    /// The row of a direction, and the part of its solid angle that lies above.
    fn row(&self, x: Point) -> (usize, Real) {
        let (down, up) = complements(x);
        let theta = 2.0 * down.sqrt().atan2(up.sqrt());
        let row = index(theta / PI * Real::from(self.rows.len() as u32));
        let row = row.min(self.rows.len() - 1);
        let [[from_down, from_up], _] = self.edges(row).map(Self::complements);
        let part = if down < up {
            down - from_down
        } else {
            from_up - up
        };
        (row, part / self.drop(row))
    }
}

impl Truth for Sky {
    fn sample(&self, u: Uniforms) -> Point {
        let inside = |share: Real| share.clamp(INSIDE, 1.0 - INSIDE);
        let share = |cells: &Histogram, i: usize, u: Real| {
            inside((u - cells.start(i)) / (cells.ends[i] - cells.start(i)))
        };
        let row = self.marginal.select(u[1]);
        let exact = (u[1] - self.marginal.start(row))
            / (self.marginal.ends[row] - self.marginal.start(row));
        // A pole is no edge.
        let part = match (row == 0, row + 1 == self.rows.len()) {
            (true, true) => exact,
            (true, _) => exact.min(1.0 - INSIDE),
            (_, true) => exact.max(INSIDE),
            _ => inside(exact),
        };
        let columns = self.rows[row].as_ref().expect("a row of positive weight");
        let column = columns.select(u[0]);
        let along = share(columns, column, u[0]);
        let [low, high] = [columns.edges[column], columns.edges[column + 1]];
        let phi = TAU * (low + along * (high - low));
        let [above, below] = self.edges(row).map(Self::complements);
        let [down, up] = [0, 1].map(|k| above[k] + part * (below[k] - above[k]));
        let sine = (down * up).sqrt();
        let z = if down < up { 1.0 - down } else { up - 1.0 };
        [sine * phi.cos(), sine * phi.sin(), z]
    }
    fn pdf(&self, x: Point) -> Real {
        let (row, _) = self.row(x);
        let mass = self.marginal.ends[row] - self.marginal.start(row);
        let columns = self.rows[row].as_ref();
        let along = columns.map_or(real(0.0), |columns| columns.pdf(turn(x[0], x[1])));
        mass * along / (TAU * self.drop(row))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let (row, part) = self.row(x);
        let (start, end) = (self.marginal.start(row), self.marginal.ends[row]);
        let columns = self.rows[row].as_ref();
        let along = columns.map_or(real(0.0), |columns| columns.cdf(turn(x[0], x[1])));
        [along, start + part * (end - start), real(0.0), real(0.0)]
    }
}
