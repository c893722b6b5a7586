//! The formulas over the functions of the `libm` crate.

use super::formulas::formulas;
use libm::{cbrtf, logf as ln, powf, sincosf as sin_cos, sqrtf as sqrt};

formulas!();

/// The exponential distribution of a rate: −ln(1 − u)/rate.
#[inline]
pub fn exponential_of_rate(rate: f32, [u]: [f32; 1]) -> f32 {
    -ln(1.0 - u) / rate
}

/// The unit ball: a direction times the cube root of a uniform.
#[inline]
pub fn ball([u1, u2, u3]: [f32; 3]) -> [f32; 3] {
    let r = cbrtf(u3);
    sphere([u1, u2]).map(|x| r * x)
}

/// The distribution over indices as running sums in `f32`, searched by halving.
pub struct Sums(Vec<f32>);

impl Sums {
    pub fn new(weights: &[f32]) -> Self {
        let running = weights.iter().scan(0.0, |sum, weight| {
            *sum += weight;
            Some(*sum)
        });
        Self(running.collect())
    }

    #[inline]
    pub fn index(&self, [u]: [f32; 1]) -> usize {
        let (total, sums) = self.0.split_last().expect("weights");
        let target = u * total;
        sums.partition_point(|&sum| sum <= target)
    }
}
