//! What the disk and the directions share: a radius turned about the centre, and the angle of a point.

use super::Uniform;
use super::grade::Kernels;

/// The point of this distance from the centre (Q32) in the direction of a phase (Q32 turns), in Q30.
#[inline]
pub(super) fn around<G: Kernels>(radius: u32, phase: u32) -> [i32; 2] {
    let (sin, cos) = G::sincos(phase);
    [G::scaled(radius, cos), G::scaled(radius, sin)]
}

/// The angle of a point in turns, 0 at the origin.
#[inline]
pub(super) fn azimuth<G: Kernels>(x: i32, y: i32) -> Uniform {
    Uniform::from_bits(G::atan2(y, x))
}
