//! The same formulas over the functions of micromath.

use micromath::F32;
use std::f32::consts::TAU;

#[inline]
fn sqrt(x: f32) -> f32 {
    F32(x).sqrt().0
}

#[inline]
fn sin_cos(x: f32) -> (f32, f32) {
    let (s, c) = F32(x).sin_cos();
    (s.0, c.0)
}

/// The unit disk: radius √u₁, angle 2πu₂.
#[inline]
pub fn disk([u1, u2]: [f32; 2]) -> [f32; 2] {
    let r = sqrt(u1);
    let (s, c) = sin_cos(TAU * u2);
    [r * c, r * s]
}

/// The unit circle: angle 2πu.
#[inline]
pub fn circle([u]: [f32; 1]) -> [f32; 2] {
    let (s, c) = sin_cos(TAU * u);
    [c, s]
}

/// The direction of height z, 2πu about the axis.
#[inline]
fn at_height(z: f32, u: f32) -> [f32; 3] {
    let r = sqrt(1.0 - z * z);
    let (s, c) = sin_cos(TAU * u);
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
    [x, y, sqrt(1.0 - u1)]
}

/// In proportion to the nth power of the cosine, of `exponent` 1/(n + 1): z = u₁^(1/(n + 1)).
#[inline]
pub fn lobe(exponent: f32, [u1, u2]: [f32; 2]) -> [f32; 3] {
    at_height(F32(u1).powf(F32(exponent)).0, u2)
}

/// The exponential distribution of mean 1: −ln(1 − u).
#[inline]
pub fn exponential([u]: [f32; 1]) -> f32 {
    -F32(1.0 - u).ln().0
}

/// Two standard normals, by Box and Muller.
#[inline]
pub fn normal_pair([u1, u2]: [f32; 2]) -> [f32; 2] {
    let r = sqrt(-2.0 * F32(1.0 - u1).ln().0);
    let (s, c) = sin_cos(TAU * u2);
    [r * c, r * s]
}
