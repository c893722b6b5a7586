//! One selection straight over a slice of weights, in one pass and without a table.

use super::selection::Selection;
use super::total::{Total, WHOLE};
use super::word::Word as _;
use crate::error::Error;
use crate::uniform::{LARGEST, Uniforms};

/// Selects an index with probability proportional to its weight, in one pass over the weights: for weights
/// that change with every selection.
///
/// Each weight in turn takes the place of what was selected so far with probability weight/(sum so far),
/// and the uniform is rescaled to the side it fell on: so one uniform serves the whole pass.
///
/// - Uniforms: one, 32 bits; [`select_once_uniform`] takes an `f32`.
/// - Weights: any number of finite `f32`, zero or positive, not all zero. Zero is never selected.
/// - The probability differs from weight/total by less than 2⁻³² (from the 24-bit grid by less than
///   2⁻²⁴) and the rounding of 64-bit fractions, which a million weights bring to 2⁻⁴³. A weight below half
///   a step may not be reached: see [`Cdf`](super::Cdf) of `u64` where that matters.
/// - pmf: the last weight over the sum, rounded to nearest; never 0.
/// - Time: two 128-bit divisions a weight.
///
/// Source: M. T. Chao, "A General Purpose Unequal Probability Sampling Plan", 1982; M. Pharr, W. Jakob and
/// G. Humphreys, "Physically Based Rendering", 2023 (the rescaled uniform).
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
    pass(weights, bits, 32)
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
    pass(weights, u32::from_uniform(u.canonical()).0, 24)
}

fn pass(weights: &[f32], word: u32, bits: u32) -> Result<Selection, Error> {
    if weights.is_empty() {
        return Err(Error::NoWeights);
    }
    let mut total = Total::ZERO;
    let mut chosen = (0, Total::ZERO);
    // The middle of the step, so that weights far below one are not selected by the word 0.
    let mut u = u64::from_bits(word) | 1 << 31;
    for (index, &weight) in weights.iter().enumerate() {
        let weight = Total::of(weight).map_err(|error| match error {
            Error::Negative => Error::NegativeWeight(index),
            _ => Error::NotFiniteWeight(index),
        })?;
        if weight.is_zero() {
            continue;
        }
        total = total.plus(weight);
        let share = weight.share_of(total);
        let taken = u128::from(u) < share;
        // Where the whole share is taken, the first weight's, u stays as it is.
        let (offset, width) = if taken {
            (u128::from(u), share)
        } else {
            (u128::from(u).wrapping_sub(share), WHOLE.wrapping_sub(share))
        };
        u = (offset << 64).checked_div(width).unwrap_or(0) as u64;
        if taken {
            chosen = (index, weight);
        }
    }
    let (index, weight) = chosen;
    if weight.is_zero() {
        return Err(Error::AllZero);
    }
    let leftover = u as f32 * u64::STEP;
    let pmf = weight.ratio(total);
    // The exponent of the pmf is log2 of it, rounded down.
    let spent = 127_u32.saturating_sub(pmf.to_bits() >> 23);
    Ok(Selection {
        index,
        pmf,
        leftover: if leftover < 1.0 { leftover } else { LARGEST },
        leftover_bits: bits.saturating_sub(spent),
    })
}
