//! The cases by their numbers: all subjects at all inputs in every tier.

use crate::fixed;
use crate::subjects::{self, INPUTS, Out, SUBJECTS};
use microwarp::tier::{Libm, Poly, Tier};

/// The subjects of the first half of a tier.
const HALF: usize = SUBJECTS.len() / 2;

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
    case::<Poly, 0, { usize::MAX }>(index, out)
}

/// The cases of the `libm` tier alone.
pub fn evaluate_libm(index: usize, out: &mut [u32; 16]) -> usize {
    case::<Libm, 0, { usize::MAX }>(index, out)
}

/// How many of the cases of a tier are its first half.
pub fn cases_of_half() -> usize {
    HALF.saturating_mul(INPUTS)
}

/// The first half of the cases of a tier alone.
pub fn evaluate_first_half<T: Tier>(index: usize, out: &mut [u32; 16]) -> usize {
    case::<T, 0, HALF>(index, out)
}

/// The second half of the cases of a tier alone, counted from its first one.
pub fn evaluate_second_half<T: Tier>(index: usize, out: &mut [u32; 16]) -> usize {
    case::<T, HALF, { usize::MAX }>(index.saturating_add(cases_of_half()), out)
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

fn case<T: Tier, const FROM: usize, const TO: usize>(index: usize, out: &mut [u32; 16]) -> usize {
    let mut out = Out::new(out);
    subjects::evaluate::<T, FROM, TO>(index / INPUTS, index % INPUTS, &mut out);
    out.len()
}
