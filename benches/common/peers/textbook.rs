//! The formulas as they stand in books, over the functions of the `libm` crate.

use libm::{cbrtf, logf, powf, sincosf, sqrtf};
use std::f32::consts::TAU;

/// The unit disk: radius √u₁, angle 2πu₂.
#[inline]
pub fn disk([u1, u2]: [f32; 2]) -> [f32; 2] {
    let r = sqrtf(u1);
    let (s, c) = sincosf(TAU * u2);
    [r * c, r * s]
}

/// The unit circle: angle 2πu.
#[inline]
pub fn circle([u]: [f32; 1]) -> [f32; 2] {
    let (s, c) = sincosf(TAU * u);
    [c, s]
}

/// The direction of height z, 2πu about the axis.
#[inline]
fn at_height(z: f32, u: f32) -> [f32; 3] {
    let r = sqrtf(1.0 - z * z);
    let (s, c) = sincosf(TAU * u);
    [r * c, r * s, z]
}

/// The unit sphere: z = 1 − 2u₁.
#[inline]
pub fn sphere([u1, u2]: [f32; 2]) -> [f32; 3] {
    at_height(1.0 - 2.0 * u1, u2)
}

/// The upper half of it: z = u₁.
#[inline]
pub fn hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
    at_height(u1, u2)
}

/// In proportion to the cosine: a point of the disk, lifted to √(1 − u₁).
#[inline]
pub fn cosine_hemisphere([u1, u2]: [f32; 2]) -> [f32; 3] {
    let [x, y] = disk([u1, u2]);
    [x, y, sqrtf(1.0 - u1)]
}

/// In proportion to the nth power of the cosine, of `exponent` 1/(n + 1): z = u₁^(1/(n + 1)).
#[inline]
pub fn lobe(exponent: f32, [u1, u2]: [f32; 2]) -> [f32; 3] {
    at_height(powf(u1, exponent), u2)
}

/// The exponential distribution of mean 1: −ln(1 − u).
#[inline]
pub fn exponential([u]: [f32; 1]) -> f32 {
    -logf(1.0 - u)
}

/// The exponential distribution of a rate: −ln(1 − u)/rate.
#[inline]
pub fn exponential_of_rate(rate: f32, [u]: [f32; 1]) -> f32 {
    -logf(1.0 - u) / rate
}

/// Two standard normals, by Box and Muller.
#[inline]
pub fn normal_pair([u1, u2]: [f32; 2]) -> [f32; 2] {
    let r = sqrtf(-2.0 * logf(1.0 - u1));
    let (s, c) = sincosf(TAU * u2);
    [r * c, r * s]
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
