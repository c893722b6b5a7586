//! The integer tier: its kernels keep the errors their documentation states, and its laws hold.
//!
//! Kernels are tried over one of every 16 of the 2³² words and at all edges, in the quick speed over one of every 2048;
//! with `MICROWARP_FULL=all` in the environment over every word there is, which takes half an hour. Overflow checks are on, so a sweep that comes to
//! its end is the proof that no plain operator overflows.

mod cases;
mod composed;
mod controls;
mod distributions;
mod edges;
mod figures;
mod inputs;
mod kernels;
mod laws;
mod rim;
mod rising;
mod shapes;
mod wrong_maps;
