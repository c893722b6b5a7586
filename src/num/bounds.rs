//! Functions that bring a number into a range, each with a rule for NaN.

/// The largest `f32` below 1, which is also the last point of the 24-bit grid: 1 − 2⁻²⁴.
pub const LARGEST: f32 = 1.0 - f32::EPSILON / 2.0;

/// The smallest positive `f32`, 2⁻¹⁴⁹. A uniform of 0 counts as this where a map is infinite, or its density 0, at 0.
pub const SMALLEST: f32 = f32::from_bits(1);

/// Whether the processor has vectors, for which some loops and choices are written.
pub(crate) const VECTORS: bool = cfg!(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_feature = "simd128"
));

/// Brings a number into [0, 1) by the rule for uniforms: NaN and numbers below 0 become 0, numbers from 1 up become
/// [`LARGEST`].
#[inline]
pub(crate) fn into_unit(u: f32) -> f32 {
    if VECTORS {
        // The vector instructions `max` and `min`: NaN fails the first comparison, and no f32 lies between the largest
        // uniform and 1.
        let u = if u > 0.0 { u } else { 0.0 };
        if u < LARGEST { u } else { LARGEST }
    } else if u >= 1.0 {
        LARGEST
    } else if u > 0.0 {
        u
    } else {
        // NaN fails both comparisons.
        0.0
    }
}

/// Brings the density of a point inside the domain into the positive finite range: underflow becomes 2⁻¹⁴⁹ and overflow
/// the largest `f32`. So a sample never has density 0, and nothing is divided by 0.
#[inline]
pub(crate) fn representable(density: f32) -> f32 {
    if density > f32::MAX {
        f32::MAX
    } else if density >= SMALLEST {
        density
    } else {
        SMALLEST
    }
}

/// The uniform, or 2⁻¹⁴⁹ in place of 0, for maps that are infinite or of density 0 there.
#[inline]
pub(crate) fn above_zero(u: f32) -> f32 {
    if u > 0.0 { u } else { SMALLEST }
}

/// The probability beyond the point of a uniform in [0, 1), on the nearer side: at most 1/2, and 2⁻¹⁴⁹ for 0.
#[inline]
pub(crate) fn tail(u: f32) -> f32 {
    if u < 0.5 { above_zero(u) } else { 1.0 - u }
}

/// `x`, or the nearer bound where it lies outside; `low` for NaN.
#[inline]
pub(crate) const fn clamp(x: f32, low: f32, high: f32) -> f32 {
    if x >= high {
        high
    } else if x > low {
        x
    } else {
        low
    }
}

/// The nearest finite number; NaN becomes the largest.
#[inline]
pub(crate) fn saturated(x: f32) -> f32 {
    if x.is_nan() {
        f32::MAX
    } else {
        x.clamp(-f32::MAX, f32::MAX)
    }
}
