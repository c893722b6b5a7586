//! What the tests, the examples and the benches of microwarp share, on the host: the registry of samplers with
//! their exact counterparts, the measures of errors, statistics, generators, contests of speed, the peers'
//! formulas, drawings and command lines. Each exists once, here.
//!
//! What runs on a core, without `std`, is the business of the packages beside this one.

pub mod adversary;
pub mod bench;
pub mod cli;
pub mod contest;
pub mod docs;
pub mod draw;
pub mod errors;
pub mod figures;
pub mod generators;
pub mod mean;
pub mod parallel;
pub mod peers;
pub mod progress;
pub mod registry;
pub mod slope;
pub mod speed;
pub mod stats;
pub mod table;
pub mod truth;
pub mod verdict;
pub mod words;

use std::path::PathBuf;

/// The root of the repository.
pub fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// What `benches/cores` has measured and recorded.
pub const COSTS: &str = include_str!("../../../benches/cores/costs.csv");
