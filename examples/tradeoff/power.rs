//! The power of a chi-square test: the noncentrality at which it rejects, and the one it rules out if it does not.

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};
use std::collections::BTreeMap;
use std::sync::Mutex;

/// The level of the test that is to show a bias.
pub const LEVEL: f64 = 0.01;

/// The test with so many degrees of freedom.
#[derive(Clone, Copy, Debug)]
pub struct Power(usize);

impl Power {
    pub fn of(freedom: usize) -> Self {
        Self(freedom)
    }

    fn law(self, more: usize) -> ChiSquared {
        ChiSquared::new((self.0 + more) as f64).expect("degrees of freedom")
    }

    /// The chance that chi-square exceeds a value: central ones of more degrees of freedom, as many as twice a Poisson
    /// number of half the noncentrality as its mean.
    pub fn exceeds(self, value: f64, noncentrality: f64) -> f64 {
        let mean = 0.5 * noncentrality;
        let reach = 10.0 * mean.sqrt() + 20.0;
        let (from, to) = ((mean - reach).max(0.0) as usize, (mean + reach) as usize);
        let mut total = 0.0;
        for j in from..=to {
            let count = j as f64;
            let weight = if mean == 0.0 {
                f64::from(u8::from(j == 0))
            } else {
                (count * mean.ln() - mean - libm::lgamma(count + 1.0)).exp()
            };
            // Terms that cannot be seen cost as much as others.
            if weight > 1e-15 {
                total += weight * self.law(2 * j).sf(value);
            }
        }
        total
    }

    /// The noncentrality with which chi-square exceeds a value with a chance; 0 if it does without.
    fn with_chance(self, value: f64, chance: f64) -> f64 {
        let (mut low, mut high) = (0.0, 16.0);
        while self.exceeds(value, high) < chance {
            high *= 2.0;
        }
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if self.exceeds(value, middle) < chance {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The noncentrality with which the test rejects one time in two.
    pub fn needed(self) -> f64 {
        static KNOWN: Mutex<BTreeMap<usize, f64>> = Mutex::new(BTreeMap::new());
        let known = |map: &BTreeMap<usize, f64>| map.get(&self.0).copied();
        if let Some(needed) = known(&KNOWN.lock().expect("no thread has panicked")) {
            return needed;
        }
        let critical = self.law(0).inverse_cdf(1.0 - LEVEL);
        let needed = self.with_chance(critical, 0.5);
        KNOWN
            .lock()
            .expect("no thread has panicked")
            .insert(self.0, needed);
        needed
    }

    /// The noncentrality that a value rules out: it would have been exceeded in all but one of a hundred cases.
    ///
    /// By the normal law of the same mean and variance, as there are hundreds of degrees of freedom: of k and ν these
    /// are k + ν and 2(k + 2ν). What is solved for ν is quadratic.
    pub fn ruled_out(self, value: f64) -> f64 {
        let k = self.0 as f64;
        let z2 = Normal::standard().inverse_cdf(1.0 - LEVEL).powi(2);
        // (k + ν − value)² = 2 z² (k + 2ν), the larger root.
        let (half, rest) = (k - value - 2.0 * z2, (k - value).powi(2) - 2.0 * z2 * k);
        -half + (half * half - rest).sqrt()
    }
}
