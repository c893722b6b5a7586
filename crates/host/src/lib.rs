//! What the tests, the examples and the benches of microwarp share, on the host. Each exists once, here.
//!
//! - What there is and what it should do: `registry`, `truth`, `twin` of the path tracer, and `peers`, the formulas of others.
//! - What is stated: `docs` reads, holds and writes the figures of the documentation.
//! - What is measured: `errors` of numbers, `figures` of a warp, `moved` points, the `adversary` that searches for the worst; `stats`,
//!   `mean` of samples; `contest` and `bench` of times; `counts`, what was counted on cores; `trade`, error and time beside peers.
//! - What it is fed with: `generators`, and `words` of the integer tier.
//! - How it runs and shows: `parallel`, `progress`, `cli`, `table`, `draw`.
//! - What keeps the repository: `upkeep`, with the programs `regenerate` and `linked`.
//!
//! What runs on a core, without `std`, is the business of the packages beside this one.

#![allow(
    clippy::duplicate_mod,
    reason = "the truths are one text over two kinds of numbers"
)]

pub mod adversary;
pub mod bench;
pub mod cli;
pub mod contest;
pub mod counts;
pub mod docs;
pub mod draw;
pub mod errors;
pub mod figures;
pub mod generators;
pub mod mean;
pub mod moved;
pub mod parallel;
pub mod peers;
pub mod registry;
pub mod speed;
pub mod stats;
pub mod trade;
pub mod truth;
pub mod twin;
pub mod upkeep;
pub mod words;

use std::path::PathBuf;

/// The root of the repository.
pub fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}
