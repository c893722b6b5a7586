//! What runs on cores: the warps of every tier, listed once, and the golden bits.
//!
//! `warps.rs` and `fixed_warps.rs` list the warps. What is made of them elsewhere (costs, benches, the page) takes the
//! lists alone, without the feature `cases`.
//!
//! The golden bits are every public function of microwarp evaluated on fixed inputs, on any target. The host, the WASM
//! module and firmware all run this very code and compare what it yields with `golden.csv`. A case is one subject (a
//! warp with its parameters, or an elementary function) at one input; it yields up to 16 words, the bits of `f32`s or
//! plain integers. What a NaN's bits are differs between machines, so every NaN yields the same word.
#![no_std]

#[macro_use]
mod warps;
#[macro_use]
mod fixed_warps;

#[cfg(feature = "cases")]
mod cases;
#[cfg(feature = "cases")]
mod chains;
#[cfg(feature = "cases")]
mod fixed;
#[cfg(feature = "cases")]
mod integers;
#[cfg(feature = "cases")]
mod subjects;

#[cfg(feature = "cases")]
pub use cases::*;
#[cfg(feature = "cases")]
pub use subjects::{INPUTS, Out};
