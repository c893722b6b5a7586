//! What is asked of a transition matrix: sums, stationarity, detailed balance, eigenvalues; and in what each
//! fails, so that the counter-examples can be asked too.

use super::enumeration::{Driven, Path, TOTAL_BITS, Weighed, Words, exact, proposals, rounded};
use super::spectrum::{Matrix, second_by_powers, second_by_rotations};
use microwarp::metropolis::{Density, LogDensity, Mutation};
use microwarp::tier::Tier;
use num_bigint::BigUint;

/// A density in f64, of which nothing but quotients are known.
pub trait Truth: Density + Weighed<Acceptance = f32> {
    /// `to` over `from`.
    fn ratio(from: Self, to: Self) -> f64;
    /// What the acceptance of a symmetric mutation may be off, in proportion to it.
    fn error(from: Self, to: Self) -> f64;
    fn is_positive(self) -> bool;
}

/// Half an ulp, and the largest ulp, in proportion to a number.
const HALF: f64 = 1.0 / 16_777_216.0;

impl Truth for f32 {
    fn ratio(from: Self, to: Self) -> f64 {
        f64::from(to) / f64::from(from)
    }
    fn error(_: Self, _: Self) -> f64 {
        HALF
    }
    fn is_positive(self) -> bool {
        self > 0.0
    }
}

impl<T: Tier> Truth for LogDensity<T> {
    fn ratio(from: Self, to: Self) -> f64 {
        (f64::from(to.get()) - f64::from(from.get())).exp()
    }
    fn error(from: Self, to: Self) -> f64 {
        // An ulp, and the difference rounded.
        2.0 * HALF + HALF * (f64::from(to.get()) - f64::from(from.get())).abs()
    }
    fn is_positive(self) -> bool {
        self.get() > f32::NEG_INFINITY
    }
}

/// The enumerated transitions of a chain, and the truth about its target.
pub struct Enumerated {
    /// Of each state; of one of density 0, none.
    pub paths: Vec<Vec<Path>>,
    /// The densities over the largest.
    pub f: Vec<f64>,
    ratio: Matrix,
    error: Matrix,
}

/// What was found.
#[derive(Debug)]
pub struct Report {
    /// Whether each row sums to 1, exactly, and no state of density 0 is entered.
    pub rows: bool,
    /// |fM − f| over the sum of f, largest.
    pub stationary: f64,
    /// |fM − f| over f, largest where f is 2^-32 of the largest or more.
    pub per_state: f64,
    /// |f_i M_ij − f_j M_ji| over what the stated errors allow, largest.
    pub balance: f64,
    /// The difference of an acceptance from the exact one over what the stated errors allow, largest.
    pub acceptance: f64,
    /// The largest magnitude of an eigenvalue but the first: by rotations, by powers.
    pub second: [f64; 2],
}

impl Report {
    pub fn is_stationary(&self) -> bool {
        self.rows && self.stationary <= 1e-6
    }
    pub fn is_balanced(&self) -> bool {
        self.balance <= 1.0 && self.acceptance <= 1.0
    }
    /// Irreducible and aperiodic, as far as f64 can tell.
    pub fn converges(&self) -> bool {
        self.second.iter().all(|s| *s <= 1.0 - 1e-9)
    }
    pub fn passes(&self) -> bool {
        self.is_stationary() && self.is_balanced() && self.converges()
    }
}

/// 2^-33, half a step of the decision: to the nearest.
const HALF_STEP: f64 = 0.5 / 4_294_967_296.0;
/// What f64 itself may be off, and the 2^-64 by which the parts of a fraction differ.
const NOISE: f64 = 1e-14;

impl Enumerated {
    pub fn new<D: Truth, M: Mutation<usize>>(f: &[D], mutation: &M, words: &Words) -> Self {
        let driven = Driven {
            target: |i: usize| f[i],
            mutation,
            words,
        };
        let paths = (0..f.len())
            .map(|i| match f[i].is_positive() {
                true => driven.paths(i),
                false => Vec::new(),
            })
            .collect();
        let of = |what: fn(D, D) -> f64, i: usize, j: usize| {
            let both = f[i].is_positive() && f[j].is_positive();
            if both { what(f[i], f[j]) } else { 0.0 }
        };
        let matrix = |what: fn(D, D) -> f64| -> Matrix {
            let row = |i| (0..f.len()).map(|j| of(what, i, j)).collect();
            (0..f.len()).map(row).collect()
        };
        let ratio = matrix(D::ratio);
        let largest = |i: &usize| f[*i].is_positive() && ratio[*i].iter().all(|r| *r <= 1.0);
        let top = (0..f.len()).find(largest).unwrap();
        Self {
            f: ratio[top].clone(),
            paths,
            ratio,
            error: matrix(D::error),
        }
    }

    pub fn states(&self) -> usize {
        self.f.len()
    }

    /// Whether the chain may be there.
    fn is_inside(&self, state: usize) -> bool {
        !self.paths[state].is_empty()
    }

    /// Row i and column j, in units of 2^-128.
    pub fn exact(&self, i: usize, j: usize) -> BigUint {
        exact(&self.paths, i, j)
    }

    /// How many of 2^96 words of the mutation of this kind propose j from i.
    pub fn proposals(&self, kind: u32, i: usize, j: usize) -> BigUint {
        proposals(&self.paths, kind, i, j)
    }

    /// The matrix of the states that the chain may be in.
    pub fn matrix(&self) -> Matrix {
        let inside: Vec<usize> = (0..self.states()).filter(|i| self.is_inside(*i)).collect();
        let unit = 2_f64.powi(-(TOTAL_BITS as i32));
        let row = |i: &usize| {
            let entry = |j: &usize| rounded(&self.exact(*i, *j)) * unit;
            inside.iter().map(entry).collect()
        };
        inside.iter().map(row).collect()
    }

    fn rows_sum_to_one(&self) -> bool {
        let one = BigUint::from(1_u32) << TOTAL_BITS;
        (0..self.states()).all(|i| {
            let row: Vec<BigUint> = (0..self.states()).map(|j| self.exact(i, j)).collect();
            let stays_out = |j: usize| self.is_inside(j) || row[j] == BigUint::ZERO;
            !self.is_inside(i)
                || (row.iter().sum::<BigUint>() == one && (0..self.states()).all(stays_out))
        })
    }

    /// The exact acceptance of a path, and what the stated errors allow it to be off.
    fn acceptance(&self, i: usize, path: &Path) -> (f64, f64) {
        let there = rounded(&self.proposals(path.kind, i, path.to));
        let back = rounded(&self.proposals(path.kind, path.to, i));
        if back == 0.0 {
            return (0.0, NOISE);
        }
        let a = (self.ratio[i][path.to] * (back / there)).min(1.0);
        // Where the ratio is 1 for another reason than that, the greater error is granted needlessly.
        let asymmetric = if (back / there - 1.0).abs() <= NOISE {
            0.0
        } else {
            3.0 * HALF
        };
        let relative = self.error[i][path.to] + asymmetric;
        (a, relative * a + HALF_STEP + NOISE)
    }

    pub fn report(&self) -> Report {
        let n = self.states();
        let unit = 2_f64.powi(-(TOTAL_BITS as i32));
        let sum: f64 = self.f.iter().sum();
        let mut report = Report {
            rows: self.rows_sum_to_one(),
            stationary: 0.0,
            per_state: 0.0,
            balance: 0.0,
            acceptance: 0.0,
            second: [0.0; 2],
        };
        // NaN counts as infinite.
        let raise =
            |most: &mut f64, x: f64| *most = most.max(if x.is_nan() { f64::INFINITY } else { x });
        let (mut flow, mut allowed) = (vec![vec![0.0; n]; n], vec![vec![0.0; n]; n]);
        for i in 0..n {
            for path in &self.paths[i] {
                let (a, tolerance) = self.acceptance(i, path);
                let realised = path.accepted as f64 / 4_294_967_296.0;
                raise(&mut report.acceptance, (realised - a).abs() / tolerance);
                let t = rounded(&path.proposals) * 2_f64.powi(-96);
                allowed[i][path.to] += self.f[i] * t * tolerance;
            }
            for (j, flow) in flow[i].iter_mut().enumerate() {
                *flow = self.f[i] * rounded(&self.exact(i, j)) * unit;
            }
        }
        for j in 0..n {
            let arriving: f64 = (0..n).map(|i| flow[i][j]).sum();
            let off = (arriving - self.f[j]).abs();
            raise(&mut report.stationary, off / sum);
            if self.f[j] >= 2_f64.powi(-32) {
                raise(&mut report.per_state, off / self.f[j]);
            }
            for i in 0..j {
                let off = (flow[i][j] - flow[j][i]).abs();
                let noise = 1e-300;
                raise(
                    &mut report.balance,
                    off / (allowed[i][j] + allowed[j][i] + noise),
                );
            }
        }
        let matrix = self.matrix();
        report.second = [second_by_rotations(&matrix), second_by_powers(&matrix)];
        report
    }
}
