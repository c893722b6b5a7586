//! What is asked of the transition matrix of a chain of integer weights: the exact number of accepting words on
//! every path, stationarity and detailed balance to the steps of 2^-32, eigenvalues.

use super::enumeration::{Driven, Path, TOTAL_BITS, Words, exact, proposals, rounded};
use super::integer_chances::ceiling;
use super::spectrum::{Matrix, second_by_powers, second_by_rotations};
use microwarp::metropolis::{Chance, Mutation};
use num_bigint::BigUint;

/// The enumerated transitions of a chain, and its weights.
pub struct Enumerated {
    pub f: Vec<u32>,
    /// With the words that each acceptance says.
    pub paths: Vec<Vec<Path<u64>>>,
    /// How many of 2^64 words the ways there and back of one proposal may differ by and count as equal: the parts
    /// of a fraction that does not divide them.
    pub uneven: u64,
}

/// What was found, each in the units that the steps of 2^-32 allow.
#[derive(Debug)]
pub struct Report {
    /// Whether each row sums to 1, exactly, and no state of weight 0 is entered.
    pub rows: bool,
    /// Acceptances that are not the exact number of words, of those of all paths.
    pub wrong: [usize; 2],
    /// The largest |fM − f|, and of |f_i M_ij − f_j M_ji|, over what the steps allow.
    pub stationary: f64,
    pub balance: f64,
    /// The largest magnitude of an eigenvalue but the first: by rotations, by powers.
    pub second: [f64; 2],
}

impl Report {
    pub fn passes(&self) -> bool {
        let right = self.rows && self.wrong[0] == 0 && self.is_stationary();
        right && self.converges() && (self.second[0] - self.second[1]).abs() <= 1e-6
    }
    pub fn is_stationary(&self) -> bool {
        self.stationary <= 1.0 && self.balance <= 1.0
    }
    pub fn converges(&self) -> bool {
        self.second.iter().all(|s| *s <= 1.0 - 1e-9)
    }
}

/// A quotient of large numbers, of which the divisor may be 0.
fn over(x: &BigUint, y: &BigUint) -> f64 {
    match *x == BigUint::ZERO {
        true => 0.0,
        false => rounded(x) / rounded(y),
    }
}

fn difference(x: BigUint, y: BigUint) -> BigUint {
    if x > y { x - y } else { y - x }
}

impl Enumerated {
    /// Of paths from elsewhere.
    pub fn of(f: &[u32], paths: Vec<Vec<Path<u64>>>) -> Self {
        Self {
            f: f.to_vec(),
            paths,
            uneven: 0,
        }
    }

    pub fn new<M: Mutation<usize>>(f: &[u32], mutation: &M, words: &Words) -> Self {
        let target = |i: usize| f[i];
        let driven = Driven {
            target,
            mutation,
            words,
        };
        let said = |path: Path<Chance>| path.saying(|chance| chance.words());
        let paths = |i: usize| match f[i] {
            0 => Vec::new(),
            _ => driven.paths(i).into_iter().map(said).collect(),
        };
        let paths = (0..f.len()).map(paths).collect();
        Self::of(f, paths)
    }

    pub fn exact(&self, i: usize, j: usize) -> BigUint {
        exact(&self.paths, i, j)
    }

    pub fn proposals(&self, kind: u32, i: usize, j: usize) -> BigUint {
        proposals(&self.paths, kind, i, j)
    }

    pub fn matrix(&self) -> Matrix {
        let inside: Vec<usize> = (0..self.f.len()).filter(|i| self.f[*i] > 0).collect();
        let unit = 2_f64.powi(-(TOTAL_BITS as i32));
        let row = |i: &usize| {
            let entry = |j: &usize| rounded(&self.exact(*i, *j)) * unit;
            inside.iter().map(entry).collect()
        };
        inside.iter().map(row).collect()
    }

    /// The words that must accept a path: its ways there and back are those that were counted.
    fn due(&self, i: usize, path: &Path<u64>) -> u64 {
        let there = self.proposals(path.kind, i, path.to);
        let back = self.proposals(path.kind, path.to, i);
        let uneven = BigUint::from(self.uneven) << 32_u32;
        let (there, back) = match difference(there.clone(), back.clone()) <= uneven {
            true => (BigUint::from(1_u32), BigUint::from(1_u32)),
            false => (there, back),
        };
        ceiling(back * self.f[path.to], &(there * self.f[i]))
    }

    pub fn report(&self) -> Report {
        let n = self.f.len();
        let one = BigUint::from(1_u32) << TOTAL_BITS;
        let (mut rows, mut wrong) = (true, [0, 0]);
        for i in (0..n).filter(|i| self.f[*i] > 0) {
            let row: Vec<BigUint> = (0..n).map(|j| self.exact(i, j)).collect();
            rows &= row.iter().sum::<BigUint>() == one;
            rows &= (0..n).all(|j| self.f[j] > 0 || row[j] == BigUint::ZERO);
            for path in &self.paths[i] {
                let due = self.due(i, path);
                let right = path.accepted == due && path.acceptance == due;
                wrong[0] += usize::from(!right);
                wrong[1] += 1;
            }
        }
        // The flow from i to j, in units of 2^-128, and what may be off: less than a word of 2^32 of what is
        // proposed either way, and the uneven parts.
        let flow = |i: usize, j: usize| self.exact(i, j) * self.f[i];
        let granted = |i: usize, j: usize| {
            let proposed = |i: usize, j: usize| -> BigUint {
                let to = self.paths[i].iter().filter(|p| p.to == j);
                to.map(|p| &p.proposals).sum()
            };
            let uneven = BigUint::from(self.uneven) << 64_u32;
            (proposed(i, j) + &uneven) * self.f[i] + (proposed(j, i) + &uneven) * self.f[j]
        };
        let (mut stationary, mut balance) = (0.0_f64, 0.0_f64);
        for j in 0..n {
            let arriving: BigUint = (0..n).map(|i| flow(i, j)).sum();
            let allowed: BigUint = (0..n).filter(|i| *i != j).map(|i| granted(i, j)).sum();
            let off = difference(arriving, &one * self.f[j]);
            stationary = stationary.max(over(&off, &allowed));
            for i in 0..j {
                let off = difference(flow(i, j), flow(j, i));
                balance = balance.max(over(&off, &granted(i, j)));
            }
        }
        let matrix = self.matrix();
        Report {
            rows,
            wrong,
            stationary,
            balance,
            second: [second_by_rotations(&matrix), second_by_powers(&matrix)],
        }
    }
}
