//! Every sampler of microwarp behind plain exports that take and return numbers.
//!
//! This file has the exports and the memory that the page and the module share. `float`, `integer`, `tables`, `rejected`
//! and `chains` have a list of subjects each; `run` samples and times them, and `source` supplies the words. The panic
//! handler calls an import. A module without reachable panics needs no import, and the page and its test check that.
#![no_std]
#![allow(unsafe_code)]

mod chains;
mod float;
mod integer;
mod numbers;
mod rejected;
mod run;
mod shared;
mod source;
mod subject;
mod tables;
mod visit;

use run::{Samples, Timing};
use shared::{Shared, shared};
use visit::{LISTS, visit};

microwarp_list::import_panic!();

/// A sentence and the bounds of each type from the crate's documentation, as JSON.
static DOCUMENTED: &str = include_str!(concat!(env!("OUT_DIR"), "/documented.json"));

/// Where the memory is that both sides use; its layout is that of [`Shared`].
#[unsafe(no_mangle)]
pub extern "C" fn shared_memory() -> *const Shared {
    &raw const *shared()
}

/// What a list of subjects tells of them, in JSON but for a comma behind the last of several; there are so many lists
/// until one is empty.
fn told(list: usize) -> &'static str {
    LISTS.get(list).copied().unwrap_or("")
}

/// Where the text of a list is.
#[unsafe(no_mangle)]
pub extern "C" fn subjects(list: usize) -> *const u8 {
    told(list).as_ptr()
}

/// How many bytes that has.
#[unsafe(no_mangle)]
pub extern "C" fn subjects_length(list: usize) -> usize {
    told(list).len()
}

/// The documentation, as JSON.
#[unsafe(no_mangle)]
pub extern "C" fn documented() -> *const u8 {
    DOCUMENTED.as_ptr()
}

/// How many bytes that has.
#[unsafe(no_mangle)]
pub extern "C" fn documented_length() -> usize {
    DOCUMENTED.len()
}

/// Draws `count` points of a subject of a list in a tier with the parameters in the shared memory, from random words (source
/// 0), stratified ones (1) or ones of low discrepancy (2) along the first `dimensions`. Returns 0, or how many bytes
/// of the text say why not.
#[unsafe(no_mangle)]
pub extern "C" fn sample(
    list: u32,
    subject: u32,
    tier: u32,
    source: u32,
    dimensions: u32,
    count: u32,
    seed: u32,
) -> usize {
    let shared = shared();
    shared.report = [0.0; 16];
    let parameters = shared.parameters;
    let words = source::Words::new(source, dimensions, count, seed);
    let mut samples = Samples::new(words, count, shared);
    match visit(list, subject, tier, &parameters, &mut samples) {
        Ok(()) => 0,
        Err(refusal) => refusal.write(&mut shared.text),
    }
}

/// Draws `count` points from PCG32 and keeps none, for the page to look at its clock before and after. Returns the
/// exclusive or of their bits, so that none can be left out.
#[unsafe(no_mangle)]
pub extern "C" fn time(list: u32, subject: u32, tier: u32, count: u32, seed: u32) -> u32 {
    let parameters = shared().parameters;
    let mut timing = Timing::new(count, seed);
    match visit(list, subject, tier, &parameters, &mut timing) {
        Ok(()) => timing.bits(),
        Err(_) => 0,
    }
}

/// Draws `count` words from PCG32 and keeps none: what the generator alone takes.
#[unsafe(no_mangle)]
pub extern "C" fn time_words(count: u32, seed: u32) -> u32 {
    run::words(count, seed)
}

/// How many golden cases there are.
#[unsafe(no_mangle)]
pub extern "C" fn golden_cases() -> usize {
    microwarp_list::cases()
}

/// Evaluates one golden case into the words of the shared memory; returns how many.
#[unsafe(no_mangle)]
pub extern "C" fn golden_evaluate(index: usize) -> usize {
    microwarp_list::evaluate(index, &mut shared().golden)
}
