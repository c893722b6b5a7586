//! The way there and back as two integers.

use super::Ratio;
use super::correction::{Correction, Judge, Stated, Verdict};
use super::weight::{Standing, Weight};
use crate::num::{Scaled as Apart, remainder};

/// The ratio T(x′→x)/T(x→x′) of a proposal x′ as two integers, such as the numerators of a table.
///
/// A chain of integer weights takes them as they are: its acceptance is exact, and no floating-point operation
/// takes place. A chain of a [`Density`](super::Density) divides them, as [`Ratio::from_counts`] does.
///
/// ```
/// use microwarp::metropolis::{Chain, Counts, Mutation, Proposal};
/// use rand_core::TryRng;
/// use rand_pcg::Pcg32;
///
/// /// Up one place of ten in three cases out of four, else down, in a circle.
/// struct Upwards;
///
/// impl Mutation<u32> for Upwards {
///     type Correction = Counts;
///
///     fn try_propose<R: TryRng + ?Sized>(
///         &self,
///         from: u32,
///         rng: &mut R,
///     ) -> Result<Proposal<u32, Counts>, R::Error> {
///         Ok(if rng.try_next_u32()? >> 30 > 0 {
///             Proposal::new((from + 1) % 10, Counts::new(3, 1))
///         } else {
///             Proposal::new((from + 9) % 10, Counts::new(1, 3))
///         })
///     }
/// }
///
/// let weight = |place: u32| place; // a u32: no float from here on
/// let mut chain = Chain::new(5, weight)?;
/// let step = chain.step(weight, &Upwards, &mut Pcg32::new(1, 1));
/// let words = if step.proposed == 6 { (6_u64 << 32).div_ceil(5 * 3) } else { 1 << 32 };
/// assert_eq!(step.acceptance.words(), words);
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Counts {
    forward: u128,
    backward: u128,
}

impl Counts {
    /// Those of a symmetric proposal.
    pub const EQUAL: Self = Self::new(1, 1);

    /// T(x→x′) and T(x′→x), both up to the same factor.
    ///
    /// Where `backward` is 0 the proposal is never accepted; one of `forward` 0, which could not have been made,
    /// is refused. A count above 2⁶⁴ counts as 2⁶⁴.
    #[must_use]
    #[inline]
    pub const fn new(forward: u128, backward: u128) -> Self {
        Self {
            forward: at_most(forward),
            backward: at_most(backward),
        }
    }

    /// The ratio in floating point.
    #[must_use]
    #[inline]
    pub fn ratio(self) -> Ratio {
        Ratio::from_counts(self.forward, self.backward)
    }
}

/// All the words of the widest table, 2⁶⁴.
const MOST: u128 = 1 << 64;

#[inline]
const fn at_most(count: u128) -> u128 {
    if count < MOST { count } else { MOST }
}

impl Judge for Counts {
    #[inline]
    fn judge<D: Weight>(self, from: D, to: D) -> Verdict<D::Acceptance> {
        match (self.forward, self.backward, to.standing()) {
            (0, _, _) | (_, _, Standing::Unsound) => Verdict::Refused,
            (_, 0, _) | (_, _, Standing::Zero) => Verdict::Never,
            (forward, backward, Standing::Positive) => {
                Verdict::With(D::accepted_with_counts(from, to, forward, backward))
            }
        }
    }

    #[inline]
    fn stated(self) -> Stated {
        Stated::Counts(self)
    }

    #[inline]
    fn of(stated: Stated) -> Self {
        match stated {
            Stated::Counts(counts) => counts,
            _ => Self::EQUAL,
        }
    }
}

impl Correction for Counts {
    type With<C: Correction> = C::WithCounts;
    type WithCounts = Self;
}

/// backward/forward, of counts from 1 to 2⁶⁴, correctly rounded but next to the middle of two `f32`.
#[inline]
pub(super) fn quotient_of_counts(forward: u128, backward: u128) -> Apart {
    if forward == backward {
        return Apart::ONE;
    }
    let (there, back) = (Digits::of(forward), Digits::of(backward));
    let quotient = back.high / there.high;
    let rest = remainder(back.high, quotient, there.high) + back.low;
    let rounded = quotient + (rest - quotient * there.low) / there.high;
    let exponent = back.exponent.wrapping_sub(there.exponent);
    Apart::of(rounded).raised(exponent)
}

/// The leading 48 bits of a number: (high + low) 2^exponent.
struct Digits {
    /// From 1 to 2, of 24 bits.
    high: f32,
    /// The 24 bits that follow.
    low: f32,
    exponent: i32,
}

impl Digits {
    /// Of a number that is not 0.
    #[inline]
    #[expect(clippy::cast_possible_wrap, reason = "there are 64 bits")]
    fn of(count: u128) -> Self {
        /// 2⁻²³, the last place of the high part.
        const PLACE: f32 = f32::EPSILON;
        let Ok(count) = u64::try_from(count) else {
            return Self {
                high: 1.0,
                low: 0.0,
                exponent: 64,
            };
        };
        let zeros = count.leading_zeros();
        let bits = count.wrapping_shl(zeros);
        let (high, low) = ((bits >> 40) as u32, (bits >> 16) as u32 & 0x00ff_ffff);
        Self {
            high: high as f32 * PLACE,
            low: low as f32 * (PLACE * PLACE * 0.5),
            exponent: 63_i32.wrapping_sub(zeros as i32),
        }
    }
}
