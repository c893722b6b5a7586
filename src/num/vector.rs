//! Vectors of three coordinates.

use super::clamp;
use core::ops::RangeInclusive;

#[inline]
pub(crate) fn dot(p: [f32; 3], q: [f32; 3]) -> f32 {
    let ([a, b, c], [d, e, f]) = (p, q);
    a * d + b * e + c * f
}

#[inline]
pub(crate) fn cross(p: [f32; 3], q: [f32; 3]) -> [f32; 3] {
    let ([a, b, c], [d, e, f]) = (p, q);
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

#[inline]
pub(crate) fn plus(p: [f32; 3], q: [f32; 3]) -> [f32; 3] {
    let ([a, b, c], [d, e, f]) = (p, q);
    [a + d, b + e, c + f]
}

#[inline]
pub(crate) fn minus(p: [f32; 3], q: [f32; 3]) -> [f32; 3] {
    let ([a, b, c], [d, e, f]) = (p, q);
    [a - d, b - e, c - f]
}

#[inline]
pub(crate) fn times(p: [f32; 3], by: f32) -> [f32; 3] {
    p.map(|x| x * by)
}

/// The sum of the magnitudes.
#[inline]
pub(crate) fn span([x, y, z]: [f32; 3]) -> f32 {
    x.abs() + y.abs() + z.abs()
}

/// Whether the processor is a large one, for which time counts before size.
const LARGE: bool = cfg!(target_pointer_width = "64");

/// A copy for a rare call. What is passed by reference lies in memory from the start, where a large processor waits for two stores
/// before it loads both; on small ones copies would only take code.
#[inline]
pub(crate) fn copied(vector: [f32; 3]) -> [f32; 3] {
    if LARGE {
        let [x, y, z] = vector;
        [x, y, z]
    } else {
        vector
    }
}

/// A power of two near the largest of these numbers.
pub(crate) fn magnitude<const N: usize>(numbers: [f32; N]) -> f32 {
    let mut largest = f32::MIN_POSITIVE;
    for x in &numbers {
        largest = clamp(x.abs(), largest, f32::MAX);
    }
    f32::from_bits(largest.to_bits() & 0x7f80_0000)
}

/// 2⁻⁶⁰ and its reciprocal: a vector of a square between these has the same direction, to the bit, as one that is scaled
/// before.
const ORDINARY: RangeInclusive<f32> = 8.673_617_4e-19..=1_152_921_504_606_846_976.0;

/// Whether a vector of this square goes without a scale. Small processors have one way for all.
#[inline]
pub(crate) fn is_ordinary(square: f32) -> bool {
    LARGE && ORDINARY.contains(&square)
}

/// A power of two near the largest coordinate, and the point divided by it, whose squares neither overflow nor
/// underflow.
pub(crate) fn scaled(point: [f32; 3]) -> (f32, [f32; 3]) {
    let scale = magnitude(point);
    // Exact, as is a quotient.
    (scale, times(point, 1.0 / scale))
}
