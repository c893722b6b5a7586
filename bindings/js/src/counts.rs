//! Counts of successes and integers about a centre: by a table, or by rejection.

use crate::buffers::Buffers;
use crate::laws::written;
use microwarp::discrete::{Binomial, DiscreteGaussian, DiscreteLaplace};
use microwarp::poly::BinomialRejection;

/// Writes a law by its kind: of so many trials a table of probability p (0), one by rejection (1), a table of probability part/whole (2);
/// a Gaussian of a centre and a scale (3); a Laplace law of a scale (4), or of the scale part/whole.
///
/// # Safety
/// As for `law`.
pub unsafe fn made(kind: u32, place: *mut u32, parameters: *const f32, given: [u32; 3]) -> i32 {
    let [trials, part, whole] = given;
    // SAFETY: as the caller says.
    unsafe {
        let [a, b] = [*parameters, *parameters.add(1)];
        match kind {
            0 => written(Binomial::new(trials, a), place.cast()),
            1 => written(BinomialRejection::new(trials, a), place.cast()),
            2 => written(Binomial::from_ratio(trials, part, whole), place.cast()),
            3 => written(DiscreteGaussian::new(a, b), place.cast()),
            4 => written(DiscreteLaplace::new(a), place.cast()),
            _ => written(DiscreteLaplace::from_ratio(part, whole), place.cast()),
        }
    }
}

/// Puts out the counts of words in the input (0), or the bits of the probabilities of counts (1), `count` of them; draws `random`
/// words first. By rejection it is one count of two words, and 0 where they are rejected.
///
/// # Safety
/// `made` has written the law by this kind, where it made a table of a ratio by 0 or 4.
pub unsafe fn asked(
    kind: u32,
    what: u32,
    law: *const u32,
    buffers: &mut Buffers,
    count: usize,
    random: usize,
) -> u32 {
    buffers.random(random);
    let words = what == 0;
    // SAFETY: as the caller says.
    unsafe {
        match kind {
            0 => {
                let law = &*law.cast::<Binomial>();
                each(
                    buffers,
                    count,
                    words,
                    |word| law.count(word),
                    |of| law.pmf(of),
                );
            }
            1 => return tried(&*law.cast(), words, buffers),
            3 => {
                let law = &*law.cast::<DiscreteGaussian>();
                let integer = |word| law.integer(word) as u32;
                each(buffers, count, words, integer, |of| law.pmf(of as i32));
            }
            _ => {
                let law = &*law.cast::<DiscreteLaplace>();
                let integer = |word| law.integer(word) as u32;
                each(buffers, count, words, integer, |of| law.pmf(of as i32));
            }
        }
    }
    1
}

fn each(
    buffers: &mut Buffers,
    count: usize,
    words: bool,
    number: impl Fn(u32) -> u32,
    pmf: impl Fn(u32) -> f32,
) {
    for (&from, to) in buffers.input.iter().zip(&mut buffers.output).take(count) {
        *to = if words {
            number(from)
        } else {
            pmf(from).to_bits()
        };
    }
}

fn tried(law: &BinomialRejection, words: bool, buffers: &mut Buffers) -> u32 {
    let ([first, second, ..], [to, ..]) = (&buffers.input, &mut buffers.output);
    let found = if words {
        law.attempt([*first, *second])
    } else {
        Some(law.pmf(*first).to_bits())
    };
    if let Some(found) = found {
        *to = found;
    }
    found.is_some().into()
}
