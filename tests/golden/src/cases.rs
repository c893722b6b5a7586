//! The cases by their numbers: all subjects at all inputs in every tier.

use crate::fixed;
use crate::subjects::{self, INPUTS, Out, SUBJECTS};
use microwarp::tier::{Libm, Poly, Tier};

/// How many cases one tier has.
pub fn cases_of_tier() -> usize {
    SUBJECTS.len().saturating_mul(INPUTS)
}

/// How many cases there are: those of `poly`, those of `libm`, then those of the integer tier.
pub fn cases() -> usize {
    of_floats().saturating_add(fixed::cases())
}

fn of_floats() -> usize {
    cases_of_tier().saturating_mul(2)
}

/// Evaluates one case of any tier into `out`; returns how many words it wrote.
pub fn evaluate(index: usize, out: &mut [u32; 16]) -> usize {
    if let Some(rest) = index.checked_sub(of_floats()) {
        return evaluate_fixed(rest, out);
    }
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

/// The cases of the integer tier alone.
pub fn evaluate_fixed(index: usize, out: &mut [u32; 16]) -> usize {
    let mut out = Out::new(out);
    fixed::evaluate(index, &mut out);
    out.len()
}

/// The subject, the input and the tier or grade of a case.
pub fn describe(index: usize) -> (&'static str, usize, &'static str) {
    if let Some(rest) = index.checked_sub(of_floats()) {
        return fixed::describe(rest);
    }
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
