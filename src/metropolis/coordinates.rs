//! Points of one or more coordinates.

use crate::uniform::Uniforms;

/// A point of ℝᴰ or of the unit cube: an `f32` or an array `[f32; D]`. The trait is sealed.
#[diagnostic::on_unimplemented(
    message = "a point is an `f32` or an array `[f32; D]`, not `{Self}`",
    label = "not a point"
)]
pub trait Coordinates: Uniforms {
    /// The coordinates in order.
    #[must_use]
    fn as_slice(&self) -> &[f32];

    /// The coordinates in order, mutable.
    #[must_use]
    fn as_mut_slice(&mut self) -> &mut [f32];
}

impl Coordinates for f32 {
    #[inline]
    fn as_slice(&self) -> &[f32] {
        core::slice::from_ref(self)
    }

    #[inline]
    fn as_mut_slice(&mut self) -> &mut [f32] {
        core::slice::from_mut(self)
    }
}

impl<const N: usize> Coordinates for [f32; N] {
    #[inline]
    fn as_slice(&self) -> &[f32] {
        self
    }

    #[inline]
    fn as_mut_slice(&mut self) -> &mut [f32] {
        self
    }
}
