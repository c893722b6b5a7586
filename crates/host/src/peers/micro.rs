//! The formulas over the functions of micromath.

use super::formulas::formulas;
use micromath::F32;

#[inline]
fn sqrt(x: f32) -> f32 {
    F32(x).sqrt().0
}

#[inline]
fn sin_cos(x: f32) -> (f32, f32) {
    let (s, c) = F32(x).sin_cos();
    (s.0, c.0)
}

#[inline]
fn ln(x: f32) -> f32 {
    F32(x).ln().0
}

#[inline]
fn powf(x: f32, y: f32) -> f32 {
    F32(x).powf(F32(y)).0
}

formulas!();
