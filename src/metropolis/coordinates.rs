//! Points whose coordinates can be counted off: one number, or an array of them.

use crate::uniform::Uniforms;

/// A point of ℝᴰ or of the unit cube: an `f32`, or an array of them, just as the uniforms of a warp are.
///
/// The trait is sealed.
pub trait Coordinates: Uniforms {
    /// The coordinates in order.
    #[must_use]
    fn as_slice(&self) -> &[f32];

    /// The coordinates in order, to be changed.
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
