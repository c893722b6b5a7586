//! The warps of the integer tier keep what their documentation promises.
//!
//! Overflow checks are on, so that a sweep that comes to its end is also the proof that nothing overflows.

mod bilinear;
mod directions;
mod exponential;
mod families;
mod figures;
mod float;
mod interval;
mod normal;
mod parameters;
mod tent;
mod triangle;
mod triangle_on;
mod truncated;
