//! Exact weights, and words counted by galloping.

use host::stats::chi_square;
use num_bigint::BigUint;
use rand_pcg::Pcg32;

/// Weights as exact integers, in units of 2⁻¹⁴⁹, and their sum.
pub struct Exact {
    pub weights: Vec<BigUint>,
    pub total: BigUint,
}

impl Exact {
    pub fn of(weights: &[f32]) -> Self {
        let weights: Vec<BigUint> = weights
            .iter()
            .map(|w| {
                let bits = w.to_bits();
                let (field, fraction) = (bits >> 23 & 0xff, bits & 0x7f_ffff);
                match field {
                    0 => BigUint::from(fraction),
                    _ => BigUint::from(fraction | 0x80_0000) << (field - 1),
                }
            })
            .collect();
        let total = weights.iter().sum();
        Self { weights, total }
    }

    /// Whether `count` of 2^bits is within `slack` 2^-32 steps of the weight's part of them.
    pub fn within(&self, index: usize, count: u128, bits: u32, slack: u64) -> bool {
        let have = BigUint::from(count) * &self.total;
        let due = &self.weights[index] << bits;
        let off = if have > due { have - due } else { due - have };
        off << 32_u32 <= &self.total * slack
    }

    /// Whether 2^bits words can be divided so that each entry is within a step of its part and each
    /// positive one has at least one: by the fewest words that each must have.
    pub fn divisible(&self, bits: u32) -> bool {
        let nothing = BigUint::from(0_u32);
        let mut needed = BigUint::from(0_u32);
        for weight in self.weights.iter().filter(|w| **w > nothing) {
            // ceil(due - 1), or 1 where that is less.
            let due = weight << bits;
            let up: BigUint = (&due + &self.total - 1_u32) / &self.total;
            needed += if up > BigUint::from(2_u32) {
                up - 1_u32
            } else {
                1_u32.into()
            };
        }
        needed <= BigUint::from(1_u32) << bits
    }
}

/// The runs of words from `first` to `last` on which `index` is the same, by galloping: each with its index
/// and its length. What is between two words of one index is taken to have that index too.
pub fn runs(first: u64, last: u64, index: impl Fn(u64) -> usize) -> Vec<(usize, u128)> {
    let mut found = Vec::new();
    let mut start = first;
    loop {
        let here = index(start);
        let (mut end, mut step) = (start, 1_u64);
        while step <= last - end && index(end + step) == here {
            end += step;
            step = step.saturating_mul(2);
        }
        while step > 0 {
            if step <= last - end && index(end + step) == here {
                end += step;
            }
            step /= 2;
        }
        found.push((here, u128::from(end - start) + 1));
        if end == last {
            return found;
        }
        start = end + 1;
    }
}

/// How many of the words up to `last` select each of `n` entries, for a selection that goes up with the
/// word.
pub fn counts(n: usize, last: u64, index: impl Fn(u64) -> usize) -> Vec<u128> {
    let mut counts = vec![0; n];
    let mut before = None;
    for (i, count) in runs(0, last, index) {
        assert!(before < Some(i), "the selection is not monotone at {i}");
        counts[i] = count;
        before = Some(i);
    }
    counts
}

/// How many of the 2²⁴ points of the f32 grid select each of `n` entries, one by one.
pub fn grid_counts(n: usize, index: impl Fn(f32) -> usize) -> Vec<u128> {
    let mut counts = vec![0; n];
    for k in 0..1_u64 << 24 {
        counts[index(grid_point(k))] += 1;
    }
    counts
}

pub fn grid_point(k: u64) -> f32 {
    k as f32 / 16_777_216.0
}

/// A whole step, in the 2^-32 of steps that [`Exact::within`] counts in.
pub const STEP: u64 = 1 << 32;

/// The p-value of drawn cells under their probabilities, by chi-square; the objection where one of no probability is drawn.
pub fn p_value(
    cells: &[f64],
    draws: u32,
    seed: u64,
    mut draw: impl FnMut(&mut Pcg32) -> usize,
) -> Result<f64, String> {
    let (mut rng, mut observed) = (Pcg32::new(seed, 5), vec![0; cells.len()]);
    for _ in 0..draws {
        observed[draw(&mut rng)] += 1;
    }
    let expected: Vec<f64> = cells.iter().map(|p| p * f64::from(draws)).collect();
    chi_square(&observed, &expected).map(|(_, _, p)| p)
}
