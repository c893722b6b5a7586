//! The golden bits: every public function of microwarp evaluated on fixed inputs, on any target.
//!
//! The host, the WASM module and firmware all run this very code and compare what it yields with
//! `golden.csv`. A case is one subject (a warp with its parameters, or an elementary function) at one
//! input; it yields up to 16 words, the bits of `f32`s or plain integers. What a NaN's bits are differs
//! between machines, so every NaN yields the same word.
#![no_std]

mod chains;
mod integers;
mod subjects;

use microwarp::tier::{Libm, Poly, Tier};
pub use subjects::{INPUTS, Out, SUBJECTS};

/// How many cases one tier has.
pub fn cases_of_tier() -> usize {
    SUBJECTS.len().saturating_mul(INPUTS)
}

/// How many cases there are: those of `poly`, then those of `libm`.
pub fn cases() -> usize {
    cases_of_tier().saturating_mul(2)
}

/// Evaluates one case of either tier into `out`; returns how many words it wrote.
pub fn evaluate(index: usize, out: &mut [u32; 16]) -> usize {
    match index.checked_sub(cases_of_tier()) {
        None => evaluate_poly(index, out),
        Some(rest) => evaluate_libm(rest, out),
    }
}

/// The cases of the `poly` tier alone.
pub fn evaluate_poly(index: usize, out: &mut [u32; 16]) -> usize {
    case::<Poly>(index, out)
}

/// The cases of the `libm` tier alone.
pub fn evaluate_libm(index: usize, out: &mut [u32; 16]) -> usize {
    case::<Libm>(index, out)
}

/// The subject, the input and the tier of a case.
pub fn describe(index: usize) -> (&'static str, usize, &'static str) {
    let (rest, tier) = match index.checked_sub(cases_of_tier()) {
        None => (index, Poly::NAME),
        Some(rest) => (rest, Libm::NAME),
    };
    let name = SUBJECTS.get(rest / INPUTS).copied().unwrap_or("");
    (name, rest % INPUTS, tier)
}

fn case<T: Tier>(index: usize, out: &mut [u32; 16]) -> usize {
    let mut out = Out::new(out);
    subjects::evaluate::<T>(index / INPUTS, index % INPUTS, &mut out);
    out.len()
}
