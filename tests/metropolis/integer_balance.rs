//! What is asked of the transition matrix of a chain of integer weights: the exact number of accepting words on
//! every path, stationarity and detailed balance to the steps of 2^-32, eigenvalues.

use super::balance::Enumerated;
use super::enumeration::{Path, TOTAL_BITS, rounded};
use super::integer_chances::ceiling;
use num_bigint::BigUint;

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

impl Enumerated<u32> {
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
        let mut wrong = [0, 0];
        for i in 0..n {
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
        Report {
            rows: self.rows_sum_to_one(),
            wrong,
            stationary,
            balance,
            second: self.second(),
        }
    }
}
