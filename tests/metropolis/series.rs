//! Runs of numbers, and their autocorrelations by the definition in f64; a hundred million numbers, whose autocorrelations are as
//! exact as stated, far from 0 too.

use crate::autocorrelation::AUTOCORRELATION;
use crate::exact::{after, assert_stated, stated_error};
use host::speed;
use microwarp::metropolis::Autocorrelation;
use rand_core::Rng;
use rand_pcg::Pcg32;

/// The definition: both sums over the differences from the mean, divided by the same count. Of a run whose
/// numbers are all the same there is none.
pub struct Truth {
    differences: Vec<f64>,
    variance: f64,
}

impl Truth {
    pub fn new(run: &[f32]) -> Self {
        // From a number of the run first: the differences of a run far from 0 then have all their digits, and
        // on the scale of the largest, so that no square underflows.
        let (first, n) = (run.first().map_or(0.0, |&x| f64::from(x)), run.len() as f64);
        let mut differences: Vec<f64> = run.iter().map(|&x| f64::from(x) - first).collect();
        let largest = differences.iter().fold(0.0_f64, |a, d| a.max(d.abs()));
        if largest > 0.0 {
            differences.iter_mut().for_each(|d| *d /= largest);
        }
        // Twice, since the first mean is rounded.
        for _ in 0..2 {
            let mean = differences.iter().sum::<f64>() / n;
            differences.iter_mut().for_each(|d| *d -= mean);
        }
        let variance = if largest > 0.0 {
            differences.iter().map(|d| d * d).sum()
        } else {
            0.0
        };
        Self {
            differences,
            variance,
        }
    }

    pub fn autocorrelation(&self, lag: usize) -> Option<f64> {
        if self.variance == 0.0 || lag >= self.differences.len() {
            return None;
        }
        let pairs = self.differences.iter().zip(&self.differences[lag..]);
        Some(pairs.map(|(a, b)| a * b).sum::<f64>() / self.variance)
    }

    /// Geyer's initial monotone sequence, and how near 0 any of the sums of pairs came that could have ended
    /// it. None where the lags do not reach its end.
    pub fn integrated_time(&self, lags: usize) -> Option<(f64, f64)> {
        let (mut sum, mut least, mut nearest) = (0.0_f64, f64::INFINITY, 1.0_f64);
        for even in (0..lags).step_by(2) {
            let pair = self.autocorrelation(even)? + self.autocorrelation(even + 1)?;
            nearest = nearest.min(pair.abs());
            if pair <= 0.0 {
                let log2 = (self.differences.len() as f64).log2().floor().max(1.0);
                return Some(((2.0 * sum - 1.0).max(1.0 / log2), nearest));
            }
            least = least.min(pair);
            sum += least;
        }
        None
    }
}

pub fn unit(rng: &mut Pcg32) -> f64 {
    (f64::from(rng.next_u32()) + 0.5) / 2f64.powi(32)
}

/// A normal number, by Box and Muller in f64.
pub fn normal(rng: &mut Pcg32) -> f64 {
    let (u, v) = (unit(rng), unit(rng));
    (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
}

/// A stationary autoregression: x′ = ρx + noise, with variance 1 and autocorrelations ρᵏ.
pub fn autoregression(rho: f64, n: usize, rng: &mut Pcg32) -> Vec<f64> {
    let mut x = normal(rng);
    let spread = (1.0 - rho * rho).sqrt();
    (0..n)
        .map(|_| {
            let now = x;
            x = rho * x + spread * normal(rng);
            now
        })
        .collect()
}

/// The kinds of runs that are tried, of deviations about 1.
pub const SHAPES: usize = 9;

pub fn shaped(shape: usize, n: usize, rng: &mut Pcg32) -> Vec<f64> {
    let noise = |rng: &mut Pcg32| normal(rng);
    match shape {
        0 => (0..n).map(|_| noise(rng)).collect(),
        1 => autoregression(0.9, n, rng),
        2 => autoregression(-0.8, n, rng),
        // A random walk, which has no mean.
        3 => {
            let mut x = 0.0;
            (0..n)
                .map(|_| {
                    x += noise(rng) / (n as f64).sqrt();
                    x
                })
                .collect()
        }
        4 => (0..n)
            .map(|i| if i % 2 == 0 { 1.0 } else { -1.0 })
            .collect(),
        // A chain that stays most of the time.
        5 => {
            let mut x = noise(rng);
            (0..n)
                .map(|_| {
                    if unit(rng) < 0.1 {
                        x = noise(rng);
                    }
                    x
                })
                .collect()
        }
        // A drift.
        6 => (0..n)
            .map(|i| i as f64 / n as f64 + 0.01 * noise(rng))
            .collect(),
        // The first is far away, and so is the first centre.
        7 => (0..n)
            .map(|i| if i == 0 { 300.0 } else { noise(rng) })
            .collect(),
        // A late outlier.
        _ => (0..n)
            .map(|i| if i + 1 == n { -300.0 } else { noise(rng) })
            .collect(),
    }
}

const LAGS: usize = 3;

/// Sums in f64 about a number near the mean, a million terms at a time.
#[derive(Default)]
struct Sums {
    blocks: [f64; LAGS + 1],
    products: [f64; LAGS + 1],
    sum: f64,
    count: u64,
    first: Vec<f64>,
    last: [f64; LAGS],
}

impl Sums {
    fn push(&mut self, d: f64) {
        self.blocks[0] += d * d;
        for lag in 1..=LAGS.min(self.count as usize) {
            self.blocks[lag] += d * self.last[lag - 1];
        }
        self.last.copy_within(0..LAGS - 1, 1);
        self.last[0] = d;
        if self.first.len() < LAGS {
            self.first.push(d);
        }
        self.sum += d;
        self.count += 1;
        if self.count % 1_000_000 == 0 {
            for (product, block) in self.products.iter_mut().zip(&mut self.blocks) {
                *product += std::mem::take(block);
            }
        }
    }

    /// Σ(d − m)(d′ − m), m being the mean.
    fn covariance(&self, lag: usize) -> f64 {
        let n = self.count as f64;
        let mean = self.sum / n;
        let ends: f64 = self.first[..lag].iter().chain(&self.last[..lag]).sum();
        self.products[lag] + self.blocks[lag] - mean * (2.0 * self.sum - ends)
            + (n - lag as f64) * mean * mean
    }
}

/// Runs of a correlated walk of deviation about 1 that drifts by as much, at a mean: the largest error.
fn worst(mean: f64, count: u64) -> f64 {
    let mut rng = Pcg32::new(0x10e8, 54);
    let (mut health, mut sums) = (Autocorrelation::<LAGS>::new(), Sums::default());
    let (mut x, mut worst) = (0.0_f64, 0.0_f64);
    for i in 0..count {
        x = 0.7 * x + f64::from(rng.next_u32()) * 2f64.powi(-32) - 0.5;
        let drift = i as f64 / count as f64;
        let number = (mean + 2.5 * x + drift) as f32;
        health.push(number);
        sums.push(f64::from(number) - mean);
        if (i + 1) % (count / 50) == 0 || (i + 1).is_power_of_two() && i > 1000 {
            for lag in 0..=LAGS {
                let got = f64::from(health.at_lag(lag).unwrap());
                let error = (got - sums.covariance(lag) / sums.covariance(0)).abs();
                assert!(!error.is_nan());
                worst = worst.max(error);
            }
        }
    }
    println!("{count} numbers, mean of {mean} deviations: {worst:.2e}");
    worst
}

#[test]
fn a_hundred_million_numbers_keep_the_stated_error() {
    let [most, some] = speed::of("numbers", [3_000_000, 300_000], [100_000_000, 3_000_000]);
    let mut largest = worst(1000.0, most);
    for mean in [0.0, 100.0, 1e6] {
        largest = largest.max(worst(mean, some));
    }
    let stated = after(AUTOCORRELATION, "Error in long runs: ");
    assert_stated("autocorrelation of long runs", largest, stated);
}

/// Plain sums in f32, about the first number: what the two floats and the centre are for.
#[test]
fn plain_sums_do_not_keep_the_stated_error() {
    let mut rng = Pcg32::new(0x10e9, 54);
    let (mut sums, mut x) = (Sums::default(), 0.0_f64);
    let [mut sum, mut squares, mut products, mut before] = [0.0_f32; 4];
    let n = speed::of("numbers of the control", 5_000_000, 20_000_000);
    for i in 0..n {
        x = 0.7 * x + f64::from(rng.next_u32()) * 2f64.powi(-32) - 0.5;
        let number = (3.0 + 2.5 * x) as f32;
        sums.push(f64::from(number) - 3.0);
        let d = number - 3.0;
        sum += d;
        squares += d * d;
        products += if i == 0 { 0.0 } else { d * before };
        before = d;
    }
    let mean = sum / n as f32;
    let rho = (products - mean * sum) / (squares - mean * sum);
    let error = (f64::from(rho) - sums.covariance(1) / sums.covariance(0)).abs();
    println!("plain sums of {n} numbers: {error:.2e}");
    assert!(error > 10.0 * stated_error(AUTOCORRELATION), "{error:e}");
}
