//! The cases by their numbers: all subjects at all inputs in every tier. What has no tier is among those of `poly` alone.

use crate::fixed;
use crate::subjects::{self, INPUTS, Out, SUBJECTS};
use microwarp::tier::{Libm, Poly, Tier};

/// The subjects of the first half of a tier: half of their code, of which later ones have more.
const HALF: usize = SUBJECTS.len() * 73 / 99;

/// The numbers of the subjects that have a tier, and behind them zeros; how many there are, and how many in the first half.
const TIERED: ([usize; SUBJECTS.len()], usize, usize) = {
    let (mut numbers, mut count, mut first) = ([0; SUBJECTS.len()], 0, 0);
    let mut subject = 0;
    while subject < SUBJECTS.len() {
        if !SUBJECTS[subject].1 {
            numbers[count] = subject;
            count += 1;
            first += (subject < HALF) as usize;
        }
        subject += 1;
    }
    (numbers, count, first)
};

/// A float tier with its subjects.
pub trait Golden: Tier {
    /// Whether what has no tier is evaluated here, too.
    const ALL: bool;

    /// The first of its cases among all.
    fn first() -> usize {
        if Self::ALL { 0 } else { Poly::cases() }
    }

    /// How many cases there are.
    fn cases() -> usize {
        let subjects = if Self::ALL { SUBJECTS.len() } else { TIERED.1 };
        subjects.saturating_mul(INPUTS)
    }

    /// How many of them are the first half.
    fn cases_of_half() -> usize {
        let subjects = if Self::ALL { HALF } else { TIERED.2 };
        subjects.saturating_mul(INPUTS)
    }
}

impl Golden for Poly {
    const ALL: bool = true;
}

impl Golden for Libm {
    const ALL: bool = false;
}

/// How many cases there are: those of `poly`, those of `libm`, then those of the integer tier.
pub fn cases() -> usize {
    of_floats().saturating_add(fixed::cases())
}

fn of_floats() -> usize {
    Poly::cases().saturating_add(Libm::cases())
}

/// Evaluates one case of any tier into `out`; returns how many words it wrote.
pub fn evaluate(index: usize, out: &mut [u32; 16]) -> usize {
    if let Some(rest) = index.checked_sub(of_floats()) {
        return evaluate_fixed(rest, out);
    }
    match index.checked_sub(Poly::cases()) {
        None => evaluate_of::<Poly>(index, out),
        Some(rest) => evaluate_of::<Libm>(rest, out),
    }
}

/// The cases of one float tier alone.
pub fn evaluate_of<T: Golden>(index: usize, out: &mut [u32; 16]) -> usize {
    case::<T, 0, { usize::MAX }>(index, out)
}

/// The first half of the cases of a tier alone.
pub fn evaluate_first_half<T: Golden>(index: usize, out: &mut [u32; 16]) -> usize {
    case::<T, 0, HALF>(index, out)
}

/// The second half of the cases of a tier alone, counted from its first one.
pub fn evaluate_second_half<T: Golden>(index: usize, out: &mut [u32; 16]) -> usize {
    case::<T, HALF, { usize::MAX }>(index.saturating_add(T::cases_of_half()), out)
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
    let (rest, subject, tier) = match index.checked_sub(Poly::cases()) {
        None => (index, subject::<Poly>(index), Poly::NAME),
        Some(rest) => (rest, subject::<Libm>(rest), Libm::NAME),
    };
    let name = SUBJECTS.get(subject).map_or("", |(name, _)| name);
    (name, rest % INPUTS, tier)
}

/// The number of the subject of a case; none has this number past the last.
fn subject<T: Golden>(index: usize) -> usize {
    let place = index / INPUTS;
    if T::ALL {
        return place;
    }
    let (numbers, count, _) = &TIERED;
    let tiered = numbers.get(..*count).and_then(|all| all.get(place));
    tiered.copied().unwrap_or(usize::MAX)
}

fn case<T: Golden, const FROM: usize, const TO: usize>(index: usize, out: &mut [u32; 16]) -> usize {
    let mut out = Out::new(out);
    subjects::evaluate::<T, FROM, TO>(subject::<T>(index), index % INPUTS, &mut out);
    out.len()
}
