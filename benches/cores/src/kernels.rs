//! The registry of measured functions. The names stand in these files, and those of warps in the lists of
//! `tests/golden/src`, as string literals, each once; the runner reads them from there.
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
mod paths;
mod peers;
mod points;
mod primitives;
mod rejection;
mod tables;

use crate::count::Entry;

/// The entries in several lists.
pub static REGISTRY: [&[Entry]; 16] = [
    chains::ENTRIES,
    float::POLY,
    float::LIBM,
    generator::ENTRIES,
    generator::OTHERS,
    integer::FINE,
    integer::COARSE,
    integer::COMPACT,
    integer::PLAIN,
    paths::ENTRIES,
    peers::ENTRIES,
    points::ENTRIES,
    primitives::ENTRIES,
    rejection::ENTRIES,
    tables::ENTRIES,
    tables::RESAMPLING,
];
