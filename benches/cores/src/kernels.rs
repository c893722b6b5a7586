//! The registry of what is measured. The names stand in these files as string literals, each name once, and are
//! read from them by the runner.
#![allow(
    dead_code,
    unused_imports,
    unused_macros,
    unused_variables,
    reason = "a measurement compiles one line and leaves the others out"
)]

mod chains;
mod float;
mod generator;
mod integer;
mod peers;
mod primitives;
mod rejection;
mod tables;

use crate::count::Entry;

/// The entries in several lists.
pub static REGISTRY: [&[Entry]; 8] = [
    chains::ENTRIES,
    float::ENTRIES,
    generator::ENTRIES,
    integer::ENTRIES,
    peers::ENTRIES,
    primitives::ENTRIES,
    rejection::ENTRIES,
    tables::ENTRIES,
];
