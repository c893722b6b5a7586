//! One selection straight from a slice of weights, in one pass and without a table.

use super::selection::Selection;
use super::total::Total;
use super::word::Word as _;
use crate::error::Error;
use crate::uniform::{LARGEST, Uniforms};

/// Selects an index with probability proportional to its weight, in one pass and without a table: for weights
/// that change with every selection.
///
/// # Domain
/// - Weights: any number of finite `f32`, zero or positive, not all zero. A weight of zero is never selected.
/// - Uniforms: one, as 32 bits; [`select_once_uniform`] takes an `f32`.
///
/// # Accuracy
/// - The same bits select the same index as in a [`Cdf`](super::Cdf) of `u32`, as long as no positive weight is
///   below 2⁻³² of the sum.
/// - The probability differs from weight/total by less than 2⁻³² (from the 24-bit grid of an `f32` by less than
///   2⁻²⁴) plus the rounding of the 64-bit sum: 2⁻⁶³ a weight, 2⁻⁴³ for a million.
/// - A weight far below such a step is either never selected, or more often than its pmf says. Where that
///   matters, take a `Cdf` of `u64`.
/// - The pmf is weight/sum, correctly rounded unless subnormal, and never 0.
///
/// # Cost
/// Two 64-bit additions and one product a weight, and one division in all. No memory.
///
/// # Errors
/// [`Error::NoWeights`], [`Error::AllZero`]; with the index of the weight [`Error::NegativeWeight`] and
/// [`Error::NotFiniteWeight`].
///
/// # Examples
/// ```
/// use microwarp::discrete::select_once;
/// let chosen = select_once(&[1.0, 0.0, 3.0], 0x8000_0000)?;
/// assert_eq!((chosen.index, chosen.pmf), (2, 0.75));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Cdf`](super::Cdf), [`Alias`](super::Alias): for many selections from the same weights.
/// - [`Reservoir`](super::Reservoir): for a stream, whose weights need not be in a slice.
///
/// # Source
/// L. Devroye, *Non-Uniform Random Variate Generation*, Springer, 1986, chapter III.2 (inversion by sequential
/// search): <http://luc.devroye.org/rnbookindex.html>.
#[doc(alias = "categorical")]
#[doc(alias = "roulette_wheel")]
#[doc(alias = "sample_discrete")]
#[doc(alias = "weighted_choice")]
#[inline]
pub fn select_once(weights: &[f32], bits: u32) -> Result<Selection, Error> {
    pass(weights, (bits, 0.0), 32)
}

/// Selects an index as [`select_once`] does, by any `f32`, which is first brought into [0, 1) by the rule of
/// [`Uniforms::canonical`].
///
/// # Errors
/// Those of [`select_once`].
///
/// # Examples
/// ```
/// use microwarp::discrete::{select_once, select_once_uniform};
/// assert_eq!(select_once_uniform(&[1.0, 2.0], 0.5)?.index, select_once(&[1.0, 2.0], 1 << 31)?.index);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[inline]
pub fn select_once_uniform(weights: &[f32], u: f32) -> Result<Selection, Error> {
    pass(weights, u32::from_uniform(u.canonical()), 24)
}

/// Selects by a word of so many random bits, and the fraction below it.
///
/// The sum grows with each weight, and so does the point that the uniform marks on it. A second place in the slice
/// follows that point, and stands at the selected entry when the last weight has been read.
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
        // Both places add the same sums, so the one behind cannot overtake.
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
    Ok(Selection {
        index,
        pmf: own.ratio(total),
        leftover: if leftover < 1.0 { leftover } else { LARGEST },
        leftover_bits: bits.saturating_sub(own.halvings(total)),
    })
}

fn weigh(index: usize, weight: f32) -> Result<Total, Error> {
    Total::of(weight, 0).map_err(|error| match error {
        Error::Negative(_) => Error::NegativeWeight(index),
        _ => Error::NotFiniteWeight(index),
    })
}
