//! The measurement as WASM: the host counts, paints and drives the calls through these exports.
//!
//! The order of calls is that of `count::measure`.

use crate::measured::count::{self, CALLS, CHUNKS, Entry, NO_HASH};
use crate::measured::kernels;
use core::hint::black_box;

fn entry() -> Option<&'static Entry> {
    black_box(kernels::entry())
}

/// How many chunks of calls there are to run.
#[unsafe(no_mangle)]
pub extern "C" fn cores_chunks() -> u32 {
    CHUNKS
}

/// How many calls a chunk has.
#[unsafe(no_mangle)]
pub extern "C" fn cores_calls() -> u32 {
    CALLS as u32
}

/// Runs once before all calls.
#[unsafe(no_mangle)]
pub extern "C" fn cores_prepare() {
    if let Some(entry) = entry() {
        (entry.prepare)();
    }
}

/// Makes the inputs of a chunk.
#[unsafe(no_mangle)]
pub extern "C" fn cores_refill(chunk: u32) {
    if let Some(entry) = entry() {
        count::refill(entry, chunk);
    }
}

/// Runs a chunk of calls: of the empty kernel for 0, of the other for 1.
#[unsafe(no_mangle)]
pub extern "C" fn cores_run(which: u32) {
    if let Some(entry) = entry() {
        let kernel = if which == 0 {
            entry.empty
        } else {
            entry.kernel
        };
        count::run(entry, kernel);
    }
}

/// Goes on with a hash over what a chunk wrote; 0 begins one.
#[unsafe(no_mangle)]
pub extern "C" fn cores_hash(hash: u32) -> u32 {
    let hash = if hash == 0 { NO_HASH } else { hash };
    entry().map_or(0, |entry| count::hashed(entry, hash))
}
