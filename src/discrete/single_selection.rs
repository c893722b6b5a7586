//! One selection straight over a slice of weights, in one pass and without a table.

use super::selection::Selection;
use super::total::Total;
use super::word::Word as _;
use crate::error::Error;
use crate::uniform::{LARGEST, Uniforms};

/// Selects an index with probability proportional to its weight, in one pass over the weights: for weights
/// that change with every selection.
///
/// The sum grows with each weight, and with it the point that the uniform marks on it; a second place in
/// the slice follows that point, and is at the selected entry when the last weight has been read.
///
/// - Uniforms: one, 32 bits; [`select_once_uniform`] takes an `f32`.
/// - Weights: any number of finite `f32`, zero or positive, not all zero. Zero is never selected.
/// - The same bits select the same entry as in a [`Cdf`](super::Cdf) of the same weights, as long as no
///   weight is below a step. The probability differs from weight/total by less than 2⁻³² (from the 24-bit
///   grid by less than 2⁻²⁴), and by what sums of 64 bits drop: 2⁻⁶³ a weight, 2⁻⁴³ for a million. A weight
///   far below a step is either not reached or, by the one bit string that falls on it, more often than
///   its pmf says: where that matters, take a `Cdf` of `u64`.
/// - pmf: the weight over the sum, correctly rounded unless subnormal; never 0.
/// - Time: two additions and a product of 64 bits a weight, one division in all.
///
/// Source: L. Devroye, "Non-Uniform Random Variate Generation", 1986.
///
/// # Errors
/// [`Error::NoWeights`], [`Error::NegativeWeight`] and [`Error::NotFiniteWeight`] with the index,
/// [`Error::AllZero`].
///
/// ```
/// use microwarp::discrete::select_once;
/// let chosen = select_once(&[1.0, 0.0, 3.0], 0x8000_0000)?;
/// assert_eq!((chosen.index, chosen.pmf), (2, 0.75));
/// # Ok::<(), microwarp::Error>(())
/// ```
#[inline]
pub fn select_once(weights: &[f32], bits: u32) -> Result<Selection, Error> {
    pass(weights, (bits, 0.0), 32)
}

/// [`select_once`] by any `f32`, brought into [0, 1) by the rule of [`Uniforms::canonical`] first.
///
/// # Errors
/// As [`select_once`].
///
/// ```
/// use microwarp::discrete::{select_once, select_once_uniform};
/// assert_eq!(select_once_uniform(&[1.0, 2.0], 0.5)?.index, select_once(&[1.0, 2.0], 1 << 31)?.index);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[inline]
pub fn select_once_uniform(weights: &[f32], u: f32) -> Result<Selection, Error> {
    pass(weights, u32::from_uniform(u.canonical()), 24)
}

/// By a word, and what lies below it, of so many random bits.
fn pass(weights: &[f32], (word, fraction): (u32, f32), bits: u32) -> Result<Selection, Error> {
    let mut behind = weights.iter().enumerate();
    let (mut index, mut own) = match behind.next() {
        Some((index, &weight)) => (index, weigh(index, weight)?),
        None => return Err(Error::NoWeights),
    };
    // The sums before and with the entry behind.
    let (mut below, mut end) = (Total::ZERO, own);
    let mut total = Total::ZERO;
    for (ahead, &weight) in weights.iter().enumerate() {
        total = total.plus(weigh(ahead, weight)?);
        // The sums behind are those ahead were, so the place behind cannot overtake.
        while total.reaches(word, end) {
            let Some((next, &weight)) = behind.next() else {
                break;
            };
            (index, own) = (next, weigh(next, weight)?);
            (below, end) = (end, end.plus(own));
        }
    }
    if total.is_zero() {
        return Err(Error::AllZero);
    }
    let leftover = total.place(word, fraction, below, own);
    let pmf = own.ratio(total);
    // The exponent of the pmf is log2 of it, rounded down.
    let spent = 127_u32.saturating_sub(pmf.to_bits() >> 23);
    Ok(Selection {
        index,
        pmf,
        leftover: if leftover < 1.0 { leftover } else { LARGEST },
        leftover_bits: bits.saturating_sub(spent),
    })
}

fn weigh(index: usize, weight: f32) -> Result<Total, Error> {
    Total::of(weight).map_err(|error| match error {
        Error::Negative => Error::NegativeWeight(index),
        _ => Error::NotFiniteWeight(index),
    })
}
