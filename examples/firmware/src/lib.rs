//! Firmware that finds out where it is, and where its dock is.
//!
//! A rover drives over a lawn and hears how far away three beacons are. A particle filter ([`tracker`]) tells where
//! it is, and from that and from the dock's own answers a Metropolis chain ([`dock`]) tells where the dock is. The
//! chain takes its steps in bursts, with a reset after each: what it needs is [`kept`] in RAM. The lawn is simulated
//! ([`world`], [`journey`]), so the truth is known, and the application holds itself to it.
#![cfg_attr(not(test), no_std)]

#[cfg(not(test))]
pub mod board;
pub mod dock;
#[cfg(not(test))]
pub mod golden;
pub mod journey;
pub mod kept;
#[cfg(not(test))]
pub mod scene;
pub mod tracker;
pub mod world;
#[cfg(test)]
mod worlds;

/// How far off the tracker may be, root mean square over a journey, in metres.
pub const TRACK_BOUND: f32 = 1.0;
/// How far from the dock the chain's mean place may be, in metres.
pub const DOCK_BOUND: f32 = 1.0;
/// Steps of the chain in a burst.
pub const STEPS: u16 = 500;
