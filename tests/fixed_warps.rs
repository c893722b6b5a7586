//! The warps of the integer tier keep what their documentation promises.
//!
//! Overflow checks are on, so that a sweep that comes to its end is also the proof that nothing overflows.

#[allow(dead_code, reason = "floats have more kinds of parameters")]
mod adversary;
#[path = "fixed_warps/directions.rs"]
mod directions;
#[path = "fixed_warps/exponential.rs"]
mod exponential;
#[path = "fixed_warps/families/mod.rs"]
mod families;
#[path = "fixed_warps/figures.rs"]
mod figures;
#[path = "fixed_warps/float.rs"]
mod float;
#[path = "fixed_warps/interval.rs"]
mod interval;
#[path = "fixed_warps/normal.rs"]
mod normal;
#[path = "fixed_warps/tent.rs"]
mod tent;
#[path = "fixed_warps/triangle.rs"]
mod triangle;
#[path = "fixed_warps/triangle_on.rs"]
mod triangle_on;
#[path = "fixed_warps/truncated.rs"]
mod truncated;
