//! Resampling of particles: how many copies of each survive, in integers and in place.
//!
//! A particle filter gives each of its particles a weight, then replaces them by as many of equal weight.
//!
//! 1. [`to_integers`] scales float weights to integers; a filter that has integers begins at the next step.
//! 2. [`systematic`], [`stratified`] or [`residual`] replaces each weight by the number of copies of its particle.
//! 3. [`rearrange`] makes the copies. Particles that survive stay where they are, and the others are overwritten.
//!
//! No step takes memory beyond the weights and the particles, and steps 2 and 3 have no floating-point operation.
//!
//! | | words | copies of a particle that is due x | variance |
//! |---|---|---|---|
//! | [`systematic`] | one in all | ⌊x⌋ or ⌈x⌉ | least as a rule; depends on the order of the particles |
//! | [`residual`] | one in all | ⌊x⌋ or ⌊x⌋ + 1 | as systematic, and depends less on the order |
//! | [`stratified`] | one a copy | less than 2 away from x | never above that of independent choices |
//!
//! ```
//! use microwarp::discrete::resampling::{rearrange, systematic, to_integers};
//! let mut particles = ["left", "ahead", "right", "back"];
//! let mut weights = [0; 4];
//! to_integers(&[0.0, 0.5, 0.25, 0.25], &mut weights)?;
//! systematic(&mut weights, 4, 0x8000_0000)?; // one random word
//! assert_eq!(weights, [0, 2, 1, 1]); // now counts
//! rearrange(&mut weights, &mut particles)?;
//! assert_eq!(particles, ["ahead", "ahead", "right", "back"]);
//! # Ok::<(), microwarp::Error>(())
//! ```

use super::MAX_ENTRIES;
use super::weights::{Scan, check_number};
use crate::error::Error;
use crate::uniform::infallible;
use core::convert::Infallible;
use core::num::NonZeroU64;
use rand_core::{Rng, TryRng};

/// Scales weights to integers for [`systematic`], [`stratified`] and [`residual`]: the largest to 2³¹ or more.
///
/// # Accuracy
/// An integer is the scaled weight rounded down, to 2⁻³¹ of the largest weight or less. A weight below that becomes 0, as
/// one of zero does: many of them get no copies that they are not due.
///
/// # Errors
/// [`Error::NoWeights`], [`Error::TooManyWeights`] above [`MAX_ENTRIES`], [`Error::AllZero`], [`Error::NotATable`] for
/// fewer or more integers than weights; with the index of the weight [`Error::NegativeWeight`] and
/// [`Error::NotFiniteWeight`]. No integer has changed then.
///
/// # Examples
/// ```
/// use microwarp::discrete::resampling::to_integers;
/// let mut integers = [0; 3];
/// to_integers(&[1.0, 0.0, 1e-20], &mut integers)?;
/// assert_eq!(integers, [1 << 31, 0, 0]);
/// # Ok::<(), microwarp::Error>(())
/// ```
pub fn to_integers(weights: &[f32], integers: &mut [u32]) -> Result<(), Error> {
    check_number(weights.len())?;
    if weights.len() != integers.len() {
        return Err(Error::NotATable);
    }
    let unit = Scan::new().over(weights)?.unit()?;
    for (integer, &weight) in integers.iter_mut().zip(weights) {
        *integer = unit.word(weight);
    }
    Ok(())
}

/// Systematic resampling: replaces each weight by its number of copies. Points at equal distances, shifted by one
/// random word, are counted within the share of each weight.
///
/// # Domain
/// - Weights: up to [`MAX_ENTRIES`] integers, zero or positive, not all zero.
/// - Copies: any number up to [`MAX_ENTRIES`]; as many as there are weights keeps the number of particles.
/// - Uniforms: one word.
///
/// # Accuracy
/// The counts add up to `copies`. A weight w of the sum W is due x = copies·w/W, and gets ⌊x⌋ or ⌈x⌉. Over all words it
/// gets x on average, to within 2⁻³¹. A weight of zero gets none.
///
/// # Errors
/// [`Error::NoWeights`], [`Error::TooManyWeights`], [`Error::AllZero`], [`Error::TooLarge`] for too many copies. No
/// weight has changed then.
///
/// # Examples
/// ```
/// use microwarp::discrete::resampling::systematic;
/// let mut weights = [3, 0, 1];
/// systematic(&mut weights, 8, 0x1234_5678)?;
/// assert_eq!(weights, [6, 0, 2]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`rearrange`] makes the copies.
/// - [`Cdf`](super::Cdf), [`select_once`](super::select_once): independent choices.
///
/// # Source
/// G. Kitagawa, "Monte Carlo Filter and Smoother for Non-Gaussian Nonlinear State Space Models", 1996,
/// <https://doi.org/10.1080/10618600.1996.10474692>.
#[doc(alias = "particle_filter")]
#[doc(alias = "bootstrap_filter")]
pub fn systematic(weights: &mut [u32], copies: u32, word: u32) -> Result<(), Error> {
    let total = total(weights, copies)?;
    let offset = part(total, word);
    let Ok(()) = share::<Infallible>(weights, total, copies, |due| (0, due), || Ok(offset));
    Ok(())
}

/// Residual resampling: replaces each weight by its number of copies. A weight that is due x gets ⌊x⌋, and the copies
/// that are left go to the fractions by [`systematic`] resampling.
///
/// Which particles get the copies that are left depends on the fractions alone, not on the whole parts between them.
/// Draws by others choose them independently, which has a larger variance.
///
/// # Domain
/// As for [`systematic`]; one word.
///
/// # Accuracy
/// The counts add up to `copies`. Each is ⌊x⌋ or ⌊x⌋ + 1, ⌊x⌋ where x is whole, and x on average to within 2⁻³¹.
///
/// # Cost
/// One 64-bit division a weight.
///
/// # Errors
/// Those of [`systematic`].
///
/// # Examples
/// ```
/// use microwarp::discrete::resampling::residual;
/// let mut weights = [5, 2, 1];
/// residual(&mut weights, 4, 0x4000_0000)?; // due 2.5, 1 and 0.5
/// assert_eq!(weights, [3, 1, 0]);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// [`rearrange`] makes the copies.
///
/// # Source
/// J. S. Liu and R. Chen, "Sequential Monte Carlo Methods for Dynamic Systems", 1998,
/// <https://doi.org/10.1080/01621459.1998.10473765>.
pub fn residual(weights: &mut [u32], copies: u32, word: u32) -> Result<(), Error> {
    let total = total(weights, copies)?;
    let offset = part(total, word);
    let Ok(()) = share::<Infallible>(
        weights,
        total,
        copies,
        |due| (due / total, due % total),
        || Ok(offset),
    );
    Ok(())
}

/// Stratified resampling: replaces each weight by its number of copies. One random point of each of `copies` equal
/// parts of [0, 1) is counted within the share of each weight.
///
/// # Domain
/// As for [`systematic`], but one word a copy.
///
/// # Accuracy
/// The counts add up to `copies`. Each is less than 2 away from what is due, x, and x on average to within 2⁻³¹.
///
/// # Errors
/// Those of [`systematic`]; no word has been drawn then.
///
/// # Examples
/// ```
/// use microwarp::discrete::resampling::stratified;
/// let mut weights = [3, 0, 1];
/// stratified(&mut weights, 8, &mut rand_pcg::Pcg32::new(1, 1))?;
/// assert_eq!(weights.iter().sum::<u32>(), 8);
/// assert_eq!(weights[1], 0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// [`rearrange`] makes the copies.
///
/// # Source
/// R. Douc and O. Cappé, "Comparison of Resampling Schemes for Particle Filtering", 2005,
/// <https://doi.org/10.1109/ISPA.2005.195385>.
#[inline]
pub fn stratified<R: Rng + ?Sized>(
    weights: &mut [u32],
    copies: u32,
    rng: &mut R,
) -> Result<(), Error> {
    infallible(try_stratified(weights, copies, rng))
}

/// [`stratified`], with a generator that can fail.
///
/// # Errors
/// The outer error is the generator's; some weights are counts then. The inner one is that of [`stratified`].
#[inline]
pub fn try_stratified<R: TryRng + ?Sized>(
    weights: &mut [u32],
    copies: u32,
    rng: &mut R,
) -> Result<Result<(), Error>, R::Error> {
    let total = match total(weights, copies) {
        Ok(total) => total,
        Err(error) => return Ok(Err(error)),
    };
    share(
        weights,
        total,
        copies,
        |due| (0, due),
        || Ok(part(total, rng.try_next_u32()?)),
    )?;
    Ok(Ok(()))
}

/// Makes copies of particles in place: those with a count of 0 are overwritten by those with more than 1. All counts
/// are 1 then.
///
/// A particle that survives stays where it is. One pass, and one clone for each particle that is overwritten.
///
/// # Errors
/// [`Error::NotATable`] where the counts are not as many as the particles, or do not add up to their number. Nothing has
/// changed then.
///
/// # Examples
/// ```
/// use microwarp::discrete::resampling::rearrange;
/// let mut particles = ['a', 'b', 'c', 'd'];
/// rearrange(&mut [0, 3, 0, 1], &mut particles)?;
/// assert_eq!(particles, ['b', 'b', 'b', 'd']);
/// # Ok::<(), microwarp::Error>(())
/// ```
pub fn rearrange<P: Clone>(counts: &mut [u32], particles: &mut [P]) -> Result<(), Error> {
    let sum: u64 = counts
        .iter()
        .fold(0, |sum, &count| sum.wrapping_add(count.into()));
    if counts.len() != particles.len() || u64::try_from(particles.len()) != Ok(sum) {
        return Err(Error::NotATable);
    }
    let mut donor = 0_usize;
    for slot in 0..counts.len() {
        if counts.get(slot) != Some(&0) {
            continue;
        }
        // There is a donor as long as a slot is empty, because the counts add up to the slots.
        while counts.get(donor).is_some_and(|&count| count < 2) {
            donor = donor.wrapping_add(1);
        }
        let copy = particles.get(donor).cloned();
        if let (Some(copy), Some(to)) = (copy, particles.get_mut(slot)) {
            *to = copy;
        }
        for (at, count) in [(slot, 1), (donor, u32::MAX)] {
            if let Some(counted) = counts.get_mut(at) {
                *counted = counted.wrapping_add(count);
            }
        }
    }
    Ok(())
}

/// The sum of the weights: below 2⁵⁶.
fn total(weights: &[u32], copies: u32) -> Result<NonZeroU64, Error> {
    check_number(weights.len())?;
    if copies as usize > MAX_ENTRIES {
        return Err(Error::TooLarge(1));
    }
    let sum = weights
        .iter()
        .fold(0_u64, |sum, &w| sum.wrapping_add(w.into()));
    NonZeroU64::new(sum).ok_or(Error::AllZero)
}

/// `total` times the fraction that a word is of all words, rounded down.
fn part(total: NonZeroU64, word: u32) -> u64 {
    let (total, word) = (total.get(), u64::from(word));
    let low = (total & u64::from(u32::MAX)).wrapping_mul(word) >> 32;
    (total >> 32).wrapping_mul(word).wrapping_add(low)
}

/// Replaces weights by counts. `split` says how many copies a weight gets at once, of the share it is due, and what is
/// left of the share. What is left is laid end to end, and copies go to where points fall: one in each stretch of
/// length `total`, so far from its start as `next` says.
#[inline]
fn share<E>(
    weights: &mut [u32],
    total: NonZeroU64,
    copies: u32,
    split: impl Fn(u64) -> (u64, u64),
    mut next: impl FnMut() -> Result<u64, E>,
) -> Result<(), E> {
    let mut left = copies;
    let mut offset = if left > 0 { next()? } else { 0 };
    // From the end of the last share to the next point. Shares are below 2⁵⁶, so that nothing overflows.
    let mut ahead = offset;
    for weight in weights {
        let (mut count, due) = split(u64::from(*weight).wrapping_mul(copies.into()));
        left = left.wrapping_sub(count as u32);
        while ahead < due && left > 0 {
            count = count.wrapping_add(1);
            left = left.wrapping_sub(1);
            if left > 0 {
                let other = next()?;
                ahead = ahead
                    .wrapping_add(total.get())
                    .wrapping_sub(offset)
                    .wrapping_add(other);
                offset = other;
            }
        }
        ahead = ahead.saturating_sub(due);
        *weight = count as u32;
    }
    Ok(())
}
