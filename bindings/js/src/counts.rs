//! Counts of successes, of laws in memory of the caller: by a table, or by rejection.

use crate::buffers::Buffers;
use crate::parts::{NOT_LINKED, linked};
use microwarp::Error;
use microwarp::discrete::Binomial;
use microwarp::poly::BinomialRejection;

const COUNTS: bool = linked("counts");

/// The JavaScript side has so much room for one.
const WORDS: usize = 192;

/// Writes a law to its place. How many words it has as a negative number, or the code of the refusal.
///
/// # Safety
/// There is room for [`WORDS`].
unsafe fn written<L>(law: Result<L, Error>, place: *mut L) -> i32 {
    const { assert!(size_of::<L>() <= 4 * WORDS && align_of::<L>() <= 16) };
    match law {
        Ok(law) => {
            // SAFETY: as the caller says.
            unsafe { place.write(law) };
            const { -(size_of::<L>().div_ceil(4) as i32) }
        }
        Err(refusal) => refusal.code().into(),
    }
}

/// Writes a law of so many trials to its place: a table of probability p (0), one by rejection (1), a table of probability
/// part/whole (2). As [`written`] returns.
///
/// # Safety
/// There is room for [`WORDS`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn binomial(
    place: *mut u32,
    kind: u32,
    trials: u32,
    p: f32,
    part: u32,
    whole: u32,
) -> i32 {
    if !COUNTS {
        return NOT_LINKED as i32;
    }
    // SAFETY: as the caller says.
    unsafe {
        match kind {
            0 => written(Binomial::new(trials, p), place.cast()),
            1 => written(BinomialRejection::new(trials, p), place.cast()),
            _ => written(Binomial::from_ratio(trials, part, whole), place.cast()),
        }
    }
}

/// Puts out the counts of words in the input (0), or the bits of the probabilities of counts (1), `count` of them; draws `random`
/// words first. By rejection it is one count of two words, and 0 where they are rejected.
///
/// # Safety
/// `binomial` has written the law, by kind 0 or 2 where it is 0, and else by 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn counted(
    kind: u32,
    what: u32,
    law: *const u32,
    buffers: &mut Buffers,
    count: usize,
    random: usize,
) -> u32 {
    if !COUNTS {
        return 0;
    }
    buffers.random(random);
    if kind == 0 {
        // SAFETY: as the caller says.
        let law = unsafe { &*law.cast::<Binomial>() };
        for (&from, to) in buffers.input.iter().zip(&mut buffers.output).take(count) {
            *to = match what {
                0 => law.count(from),
                _ => law.pmf(from).to_bits(),
            };
        }
        return 1;
    }
    // SAFETY: as the caller says.
    let law = unsafe { &*law.cast::<BinomialRejection>() };
    let ([first, second, ..], [to, ..]) = (&buffers.input, &mut buffers.output);
    let found = match what {
        0 => law.attempt([*first, *second]),
        _ => Some(law.pmf(*first).to_bits()),
    };
    if let Some(found) = found {
        *to = found;
    }
    found.is_some().into()
}
