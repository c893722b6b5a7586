//! The integer tier: its kernels keep the errors their documentation states, and its warps what theirs promises.
//!
//! Overflow checks are on, so that a sweep that comes to its end is also the proof that no plain operator overflows.

mod kernels;
mod raw;
mod warps;
