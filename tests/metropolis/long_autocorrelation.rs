//! A hundred million numbers: autocorrelations as exact as stated, far from 0 too.

use crate::autocorrelation::AUTOCORRELATION;
use crate::exact::{after, assert_stated, stated_error};
use host::speed;
use microwarp::metropolis::Autocorrelation;
use rand_core::Rng;
use rand_pcg::Pcg32;

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
