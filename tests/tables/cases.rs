//! The weights that are counted: the kinds the crate is promised for, at sizes up to 2²⁰.

use host::speed;
use host::stats::chi_square;
use num_bigint::BigUint;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

const MANY: usize = 1 << 20;
const SOME: usize = 1 << 15;

fn geometric(n: usize, low: f64, high: f64) -> Vec<f32> {
    let ratio = (high / low).ln() / (n - 1) as f64;
    (0..n)
        .map(|i| (low * (ratio * i as f64).exp()) as f32)
        .collect()
}

/// Random weights over some decades, a third of them 0, with zeros at the start, in the middle, at the end.
fn random(n: usize, seed: u64, decades: f32) -> Vec<f32> {
    let mut rng = Pcg32::new(seed, 7);
    let mut unit = || rng.next_u32() as f32 / 4_294_967_296.0;
    let mut weights: Vec<f32> = (0..n)
        .map(|_| {
            if unit() < 0.33 {
                0.0
            } else {
                10_f32.powf(decades * (unit() - 0.5))
            }
        })
        .collect();
    for edge in [0, n / 2, n - 1] {
        weights[edge] = 0.0;
    }
    weights
}

fn one_huge(n: usize, at: usize, huge: f32, small: f32) -> Vec<f32> {
    let mut weights = vec![small; n];
    weights[at] = huge;
    weights
}

/// Name and weights of every case; in the quick speed of those that are not large.
pub fn cases() -> Vec<(&'static str, Vec<f32>)> {
    let most = speed::of("largest table", SOME, MANY);
    let mut cases = all();
    cases.retain(|(_, weights)| weights.len() <= most);
    cases
}

fn all() -> Vec<(&'static str, Vec<f32>)> {
    let small = f32::from_bits(1);
    vec![
        ("one", vec![3.0]),
        ("one of three", vec![0.0, 2.5, 0.0]),
        ("a die", vec![1.0; 6]),
        ("equal, 2^20", vec![1.0; MANY]),
        ("equal, 10^6", vec![0.1; 1_000_000]),
        (
            "alternating 0 and 1",
            (0..MANY).map(|i| (i % 2) as f32).collect(),
        ),
        (
            "alternating 1 and 0",
            (0..SOME - 1).map(|i| (1 - i % 2) as f32).collect(),
        ),
        ("geometric, 253", geometric(253, 1e-38, 1e38)),
        ("geometric, 2^20", geometric(MANY, 1e-38, 1e38)),
        ("geometric down", geometric(1000, 1e38, 1e-38)),
        ("geometric, 20 decades", geometric(4096, 1e-10, 1e10)),
        (
            "all there is",
            vec![small, f32::MAX, small, 0.0, f32::MIN_POSITIVE, 1.0],
        ),
        ("two ends", vec![f32::MAX, small]),
        ("the largest only", vec![f32::MAX; 1 << 10]),
        ("the smallest only", vec![small; 77]),
        ("subnormal", (1..500).map(f32::from_bits).collect()),
        ("one huge first", one_huge(SOME, 0, 1e38, 1e-38)),
        ("one huge amid", one_huge(MANY, MANY / 3, 1e38, 1e-38)),
        ("one huge last", one_huge(SOME, SOME - 1, 1e38, 1e-38)),
        ("one large first", one_huge(SOME, 0, 1e6, 1.0)),
        ("one large last", one_huge(100_000, 99_999, 1e4, 0.3)),
        ("random, 10", random(10, 1, 4.0)),
        ("random, 1000", random(1000, 2, 6.0)),
        ("random, 2^20", random(MANY, 3, 3.0)),
        ("random, 60 decades", random(SOME, 4, 60.0)),
        ("sum over 2^24", vec![16_777_216.0, 1000.0, 1.0, 1.0, 1.0]),
        (
            "a hair below a step",
            vec![4_294_967_296.0, 0.9, 4_294_967_296.0, 0.9, 1e9],
        ),
        (
            "tiny among few",
            vec![1.0, 1e-12, 3.0, 1e-13, 5.0, 0.0, 1e-11, 7.0],
        ),
    ]
}

/// Small tables with wild exponents, zeros, ties and neighbours of powers of two.
pub fn wild(seed: u64) -> Vec<f32> {
    let mut rng = Pcg32::new(seed, 11);
    let n = 1 + rng.next_u32() as usize % 24;
    let spread = [1, 8, 33, 36, 64, 254][rng.next_u32() as usize % 6];
    let base = rng.next_u32() % (255 - spread);
    let mut weights: Vec<f32> = (0..n)
        .map(|_| {
            let fraction = match rng.next_u32() % 3 {
                0 => 0,
                1 => 0x7f_ffff,
                _ => rng.next_u32() & 0x7f_ffff,
            };
            let field = base + rng.next_u32() % spread;
            match rng.next_u32() % 5 {
                0 => 0.0,
                _ => f32::from_bits(field << 23 | fraction),
            }
        })
        .collect();
    if weights.iter().all(|w| *w == 0.0) {
        weights[0] = 1.0;
    }
    weights
}

// Exact weights, and words counted by galloping.

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
