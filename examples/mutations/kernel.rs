//! Exact properties of the three chains, by linear algebra in `f64`: the transition matrix of cells of [0, 1],
//! written from the Metropolis rule, without the crate's code.
//!
//! Sums of autocorrelations need no powers of that matrix P. If (1 − P)h = g, the sum of all covariances of g along
//! the chain is 2⟨g, h⟩ − ⟨g, g⟩, in the scalar product weighted by the density.

use crate::target::{Rule, WIDTH, density};

/// Cells of the coarser matrix. The finer one has twice as many, and results are extrapolated from both.
const COARSE: usize = 400;

/// What a chain should measure.
#[derive(Clone, Copy)]
pub struct Truth {
    pub acceptance: f64,
    /// 1 − λ₂, where λ₂ is the second largest eigenvalue.
    pub gap: f64,
    /// The integrated autocorrelation times of x and of whether x is on the left.
    pub times: [f64; 2],
    /// The share of steps from one hump to the other.
    pub crossing: f64,
    /// The expected total variation of a long run's histogram times the root of the steps: recorded plainly,
    /// and by expected values.
    pub variation: [f64; 2],
}

impl Truth {
    /// The exact values, and the largest relative error of the finer matrix.
    pub fn of(rule: &Rule, bins: usize) -> (Self, f64) {
        let [coarse, fine] = [COARSE, 2 * COARSE]
            .map(|cells| Kernel::new(rule.small(), cells).truth(bins).numbers());
        let mut worst = 0_f64;
        let numbers = std::array::from_fn(|k| {
            // The error of the midpoint rule is quadratic in the width of a cell. (Only the gap of the uniform
            // rule, whose eigenvector lives in the outermost cells, has one that is linear.)
            let limit = (4.0 * fine[k] - coarse[k]) / 3.0;
            worst = worst.max((fine[k] / limit - 1.0).abs());
            limit
        });
        (Self::from_numbers(numbers), worst)
    }

    /// In how many steps the influence of the start shrinks to 1/e.
    pub fn relaxation(&self) -> f64 {
        -1.0 / (-self.gap).ln_1p()
    }

    /// Acceptance, gap and crossings of the uniform rule in closed form. Of two proposals' distances from the
    /// middle the smaller one decides; 1 − λ₂ is the mean of f over its largest value; half of the moves cross.
    pub const UNIFORM: [f64; 3] = [1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0];

    fn numbers(self) -> [f64; 7] {
        let ([x, left], [plain, expected]) = (self.times, self.variation);
        [
            self.acceptance,
            self.gap,
            x,
            left,
            self.crossing,
            plain,
            expected,
        ]
    }

    fn from_numbers([acceptance, gap, x, left, crossing, plain, expected]: [f64; 7]) -> Self {
        Self {
            acceptance,
            gap,
            times: [x, left],
            crossing,
            variation: [plain, expected],
        }
    }
}

struct Kernel {
    cells: usize,
    small: f64,
    /// The probabilities of the cells.
    pi: Vec<f64>,
    /// The lower triangle L of LLᵀ = diag(π)(1 − P) + ππᵀ, row by row. The second summand makes the matrix invertible
    /// and does not change the solution for a g of mean 0.
    factor: Vec<f64>,
}

impl Kernel {
    fn new(small: f64, cells: usize) -> Self {
        let mut pi: Vec<f64> = (0..cells)
            .map(|i| density((i as f64 + 0.5) / cells as f64))
            .collect();
        let sum: f64 = pi.iter().sum();
        pi.iter_mut().for_each(|p| *p /= sum);
        let mut this = Self {
            cells,
            small,
            pi,
            factor: Vec::new(),
        };
        this.factor = this.cholesky();
        this
    }

    /// The probability that the proposal from cell i lies in cell j.
    fn proposal(&self, i: usize, j: usize) -> f64 {
        let width = f64::from(WIDTH) * self.cells as f64;
        let reach = (0.5 * width).round() as usize;
        let near = match i.abs_diff(j) {
            d if d < reach => 1.0 / width,
            // Half of the points of cell j are within reach of a point of cell i.
            d if d == reach => 0.5 / width,
            _ => 0.0,
        };
        self.small * near + (1.0 - self.small) / self.cells as f64
    }

    /// The probability of being in cell i and of going to cell j next, or the other way round.
    fn flow(&self, i: usize, j: usize) -> f64 {
        self.proposal(i, j) * self.pi[i].min(self.pi[j])
    }

    fn cholesky(&self) -> Vec<f64> {
        let n = self.cells;
        let mut lower = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..=i {
                let entry = if i == j {
                    (0..n).filter(|&k| k != i).map(|k| self.flow(i, k)).sum()
                } else {
                    -self.flow(i, j)
                };
                let (above, own) = lower.split_at(i * n);
                let other = if i == j { own } else { &above[j * n..] };
                let rest = entry + self.pi[i] * self.pi[j] - dot(&own[..j], &other[..j]);
                lower[i * n + j] = if i == j {
                    rest.sqrt()
                } else {
                    rest / lower[j * n + j]
                };
            }
        }
        lower
    }

    /// The h of mean 0 with (1 − P)h = g, where g has mean 0.
    fn solve(&self, g: &[f64]) -> Vec<f64> {
        let n = self.cells;
        let mut h: Vec<f64> = g.iter().zip(&self.pi).map(|(g, p)| g * p).collect();
        for i in 0..n {
            let row = &self.factor[i * n..][..n];
            h[i] = (h[i] - dot(&row[..i], &h[..i])) / row[i];
        }
        for i in (0..n).rev() {
            let row = &self.factor[i * n..][..n];
            h[i] /= row[i];
            let value = h[i];
            for (h, l) in h[..i].iter_mut().zip(row) {
                *h -= l * value;
            }
        }
        h
    }

    /// The scalar product in which P is symmetric.
    fn product(&self, g: &[f64], h: &[f64]) -> f64 {
        g.iter()
            .zip(h)
            .zip(&self.pi)
            .map(|((g, h), p)| g * h * p)
            .sum()
    }

    /// A function of x, minus its mean.
    fn centred(&self, of: impl Fn(f64) -> f64) -> Vec<f64> {
        let place = |i| (i as f64 + 0.5) / self.cells as f64;
        let g: Vec<f64> = (0..self.cells).map(|i| of(place(i))).collect();
        let mean = self.product(&g, &vec![1.0; self.cells]);
        g.iter().map(|g| g - mean).collect()
    }

    /// The smallest eigenvalue of 1 − P except the 0 of constants, by inverse iteration.
    fn gap(&self) -> f64 {
        // Neither even nor odd about the middle, so that it has a part along every eigenvector.
        let mut v = self.centred(|x| (7.0 * x).sin() + x);
        let mut gap = f64::INFINITY;
        for _ in 0..500 {
            let w = self.solve(&v);
            let size = self.product(&w, &w);
            let next = self.product(&v, &w) / size;
            let settled = (gap / next - 1.0).abs() < 1e-10;
            gap = next;
            v = w.iter().map(|w| w / size.sqrt()).collect();
            if settled {
                break;
            }
        }
        gap
    }

    /// The variance of the mean of g over n steps, times n: recorded plainly, and by expected values.
    fn variances(&self, g: &[f64]) -> [f64; 2] {
        let h = self.solve(g);
        let plain = 2.0 * self.product(g, &h) - self.product(g, g);
        // Recording plainly adds the noise of the decision, which the chain's later way depends on too.
        let mut decision = 0.0;
        for i in 0..self.cells {
            for j in 0..i {
                let (more, less) = (self.pi[i].max(self.pi[j]), self.pi[i].min(self.pi[j]));
                let (dg, dh) = (g[i] - g[j], h[i] - h[j]);
                let spread = self.flow(i, j) * (1.0 - less / more);
                decision += spread * dg * (2.0 * dh - dg);
            }
        }
        [plain, plain - decision]
    }

    fn truth(&self, bins: usize) -> Truth {
        let time = |g: &[f64]| 2.0 * self.product(g, &self.solve(g)) / self.product(g, g) - 1.0;
        let left = |x| if x < 0.5 { 1.0 } else { 0.0 };
        let n = self.cells;
        let mut variation = [0.0; 2];
        for bin in 0..bins {
            let inside = |x: f64| {
                if (x * bins as f64) as usize == bin {
                    1.0
                } else {
                    0.0
                }
            };
            let variances = self.variances(&self.centred(inside));
            for (sum, variance) in variation.iter_mut().zip(variances) {
                // Half the mean size of a normal error.
                *sum += (variance / std::f64::consts::TAU).sqrt();
            }
        }
        let pairs = |rows: std::ops::Range<usize>, columns: std::ops::Range<usize>| -> f64 {
            let row = |i: usize| columns.clone().map(|j| self.flow(i, j)).sum::<f64>();
            rows.map(row).sum()
        };
        Truth {
            acceptance: pairs(0..n, 0..n),
            gap: self.gap(),
            times: [time(&self.centred(|x| x)), time(&self.centred(left))],
            crossing: 2.0 * pairs(0..n / 2, n / 2..n),
            variation,
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    // Four independent sums, since each addition would wait for the one before.
    let (a4, b4) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a4
        .remainder()
        .iter()
        .zip(b4.remainder())
        .map(|(a, b)| a * b)
        .sum();
    let mut sums = [0.0; 4];
    for (a, b) in a4.zip(b4) {
        (0..4).for_each(|k| sums[k] += a[k] * b[k]);
    }
    sums.iter().sum::<f64>() + rest
}
