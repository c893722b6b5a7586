//! The enumerated transitions of any chain, and what is asked of those of densities: sums, stationarity, detailed
//! balance, eigenvalues; and in what each fails, so that the counter-examples can be asked too.

use super::enumeration::{Driven, Path, TOTAL_BITS, Words, rounded};
use super::known::{Matrix, second};
use super::own::Weighed;
use microwarp::metropolis::{Chain, LogDensity, Mutation, TargetDensity};
use microwarp::tier::Tier;
use num_bigint::BigUint;

/// A density in f64, of which nothing but quotients are known.
pub trait Truth: TargetDensity + Weighed {
    /// `to` over `from`.
    fn ratio(from: Self, to: Self) -> f64;
    /// What the acceptance of a symmetric mutation may be off, in proportion to it.
    fn error(from: Self, to: Self) -> f64;
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
}

impl<T: Tier> Truth for LogDensity<T> {
    fn ratio(from: Self, to: Self) -> f64 {
        (f64::from(to.get()) - f64::from(from.get())).exp()
    }
    fn error(from: Self, to: Self) -> f64 {
        // An ulp, and the difference rounded.
        2.0 * HALF + HALF * (f64::from(to.get()) - f64::from(from.get())).abs()
    }
}

/// The enumerated transitions of a chain, and its weights.
pub struct Enumerated<W: Weighed> {
    pub f: Vec<W>,
    /// Of each state; of one of weight 0, none.
    pub paths: Vec<Vec<Path>>,
    /// How many of 2^64 words the ways there and back of one proposal may differ by and count as equal: the parts
    /// of a fraction that does not divide them. Chains of integers are told of it.
    pub uneven: u64,
}

impl<W: Weighed> Enumerated<W> {
    /// Of paths from elsewhere.
    pub fn of(f: &[W], paths: Vec<Vec<Path>>) -> Self {
        Self {
            f: f.to_vec(),
            paths,
            uneven: 0,
        }
    }

    pub fn new<M: Mutation<usize>>(f: &[W], mutation: &M, words: &Words) -> Self {
        let driven = Driven::new(|i| f[i], mutation, words);
        let paths = |i: usize| match Chain::new(i, |i| f[i]) {
            Ok(_) => driven.paths(i),
            Err(_) => Vec::new(),
        };
        Self::of(f, (0..f.len()).map(paths).collect())
    }

    pub fn states(&self) -> usize {
        self.f.len()
    }

    /// Whether the chain may be there.
    pub fn is_inside(&self, state: usize) -> bool {
        !self.paths[state].is_empty()
    }

    /// Row i and column j, in units of 2^-128.
    pub fn exact(&self, i: usize, j: usize) -> BigUint {
        let mut sum = BigUint::ZERO;
        for path in &self.paths[i] {
            if path.to == j {
                sum += &path.proposals * path.accepted;
            }
            if i == j {
                sum += &path.proposals * ((1_u64 << 32) - path.accepted);
            }
        }
        sum
    }

    /// How many of 2^96 words of the mutation of this kind propose j from i.
    pub fn proposals(&self, kind: u32, i: usize, j: usize) -> BigUint {
        let of = |p: &&Path| p.kind == kind && p.to == j;
        self.paths[i].iter().filter(of).map(|p| &p.proposals).sum()
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

    /// Whether each row sums to 1, exactly, and no state of weight 0 is entered.
    pub fn rows_sum_to_one(&self) -> bool {
        let one = BigUint::from(1_u32) << TOTAL_BITS;
        (0..self.states()).all(|i| {
            let row: Vec<BigUint> = (0..self.states()).map(|j| self.exact(i, j)).collect();
            let stays_out = |j: usize| self.is_inside(j) || row[j] == BigUint::ZERO;
            !self.is_inside(i)
                || (row.iter().sum::<BigUint>() == one && (0..self.states()).all(stays_out))
        })
    }
}

/// What was found.
#[derive(Debug)]
pub struct Report {
    /// Whether each row sums to 1, exactly, and no state of weight 0 is entered.
    pub rows: bool,
    /// Acceptances that are farther off than allowed, of those of all paths: of integers, not the exact number of words.
    pub wrong: [usize; 2],
    /// The largest |fM − f|, over a millionth of the sum of f, or what the steps of 2^-32 allow of integers.
    pub stationary: f64,
    /// The largest |f_i M_ij − f_j M_ji| over what the stated errors allow, or the steps.
    pub balance: f64,
    /// The largest magnitude of an eigenvalue but the first.
    pub second: f64,
}

impl Report {
    pub fn is_stationary(&self) -> bool {
        self.stationary <= 1.0 && self.balance <= 1.0
    }
    /// Whether all is right but, perhaps, that it converges.
    pub fn is_right(&self) -> bool {
        self.rows && self.wrong[0] == 0 && self.is_stationary()
    }
    /// Irreducible and aperiodic, as far as f64 can tell.
    pub fn converges(&self) -> bool {
        self.second <= 1.0 - 1e-9
    }
    pub fn passes(&self) -> bool {
        self.is_right() && self.converges()
    }
}

/// A weight of whose chains the right behaviour is known.
pub trait Examined: Weighed {
    fn examine(chain: &Enumerated<Self>) -> Report;
}

impl<W: Examined> Enumerated<W> {
    pub fn report(&self) -> Report {
        W::examine(self)
    }
}

/// 2^-33, half a step of the decision: to the nearest.
const HALF_STEP: f64 = 0.5 / 4_294_967_296.0;
/// What f64 itself may be off, and the 2^-64 by which the parts of a fraction differ.
const NOISE: f64 = 1e-14;

impl<D: Truth> Enumerated<D> {
    /// Of two states where the chain may be; 0 of others.
    fn of_both(&self, what: fn(D, D) -> f64, i: usize, j: usize) -> f64 {
        match self.is_inside(i) && self.is_inside(j) {
            true => what(self.f[i], self.f[j]),
            false => 0.0,
        }
    }

    /// The densities over the largest.
    fn relative(&self) -> Vec<f64> {
        let row = |i: usize| -> Vec<f64> {
            let states = 0..self.states();
            states.map(|j| self.of_both(D::ratio, i, j)).collect()
        };
        let inside = (0..self.states()).filter(|i| self.is_inside(*i));
        let largest = |r: &Vec<f64>| r.iter().all(|r| *r <= 1.0);
        inside.map(row).find(largest).unwrap()
    }

    /// The exact acceptance of a path, and what the stated errors allow it to be off.
    fn acceptance(&self, i: usize, path: &Path) -> (f64, f64) {
        let there = rounded(&self.proposals(path.kind, i, path.to));
        let back = rounded(&self.proposals(path.kind, path.to, i));
        if back == 0.0 {
            return (0.0, NOISE);
        }
        let a = (self.of_both(D::ratio, i, path.to) * (back / there)).min(1.0);
        // Where the ratio is 1 for another reason than that, the greater error is granted needlessly.
        let asymmetric = if (back / there - 1.0).abs() <= NOISE {
            0.0
        } else {
            3.0 * HALF
        };
        let relative = self.of_both(D::error, i, path.to) + asymmetric;
        (a, relative * a + HALF_STEP + NOISE)
    }
}

impl<D: Truth> Examined for D {
    fn examine(chain: &Enumerated<D>) -> Report {
        let n = chain.states();
        let unit = 2_f64.powi(-(TOTAL_BITS as i32));
        let f = chain.relative();
        let sum: f64 = f.iter().sum();
        let mut report = Report {
            rows: chain.rows_sum_to_one(),
            wrong: [0; 2],
            stationary: 0.0,
            balance: 0.0,
            second: second(&chain.matrix()),
        };
        // NaN counts as infinite.
        let raise =
            |most: &mut f64, x: f64| *most = most.max(if x.is_nan() { f64::INFINITY } else { x });
        let (mut flow, mut allowed) = (vec![vec![0.0; n]; n], vec![vec![0.0; n]; n]);
        for i in 0..n {
            for path in &chain.paths[i] {
                let (a, tolerance) = chain.acceptance(i, path);
                let realised = path.accepted as f64 / 4_294_967_296.0;
                // NaN is wrong as well.
                let right = (realised - a).abs() <= tolerance;
                report.wrong[0] += usize::from(!right);
                report.wrong[1] += 1;
                let t = rounded(&path.proposals) * 2_f64.powi(-96);
                allowed[i][path.to] += f[i] * t * tolerance;
            }
            for (j, flow) in flow[i].iter_mut().enumerate() {
                *flow = f[i] * rounded(&chain.exact(i, j)) * unit;
            }
        }
        for j in 0..n {
            let arriving: f64 = (0..n).map(|i| flow[i][j]).sum();
            let off = (arriving - f[j]).abs();
            raise(&mut report.stationary, off / (1e-6 * sum));
            for i in 0..j {
                let off = (flow[i][j] - flow[j][i]).abs();
                let noise = 1e-300;
                raise(
                    &mut report.balance,
                    off / (allowed[i][j] + allowed[j][i] + noise),
                );
            }
        }
        report
    }
}
