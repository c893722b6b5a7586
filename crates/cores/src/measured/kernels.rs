//! The registry of measured functions. The names stand in these files, and those of warps in the lists of
//! `crates/list/src`, as string literals, each once; the runner reads them from there.
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
mod lots;
mod paths;
mod peers;
mod primitives;
mod rejection;
mod tables;

use crate::measured::count::Entry;

/// The entries in several lists.
pub static REGISTRY: [&[Entry]; 15] = [
    chains::ENTRIES,
    float::POLY,
    float::LIBM,
    generator::ENTRIES,
    integer::FINE,
    integer::COARSE,
    integer::COMPACT,
    integer::PLAIN,
    lots::ENTRIES,
    paths::ENTRIES,
    peers::ENTRIES,
    primitives::ENTRIES,
    rejection::ENTRIES,
    tables::ENTRIES,
    tables::RESAMPLING,
];

/// Warps whose parameters are varied, and nothing for those that have none.
pub static VARIED: [&[&[Option<Entry>]]; 6] = [
    float::POLY_VARIED,
    float::LIBM_VARIED,
    integer::FINE_VARIED,
    integer::COARSE_VARIED,
    integer::COMPACT_VARIED,
    integer::PLAIN_VARIED,
];

/// The one that a measurement has left.
pub fn entry() -> Option<&'static Entry> {
    let varied = VARIED.iter().copied().flatten();
    let varied = varied.copied().flatten().flatten();
    REGISTRY.iter().copied().flatten().chain(varied).next()
}
