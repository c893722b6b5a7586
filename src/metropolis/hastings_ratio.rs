//! The Hastings ratio T(x′→x)/T(x→x′) of a proposal, as a number and as two integers.

use super::standing::Standing;
use crate::num::{Scaled, remainder};

/// The Hastings ratio T(x′→x)/T(x→x′) of a proposal x′, as a number.
///
/// Its exponent is kept apart, so neither the ratio nor its product with the densities overflows or underflows.
///
/// # Accuracy
///
/// The acceptance is within 2.5 ulp (units in the last place) for densities and ratios of any magnitude: it is rounded three
/// times, and the first two roundings may make an ulp each. For logarithms, see [`LogDensity`](super::LogDensity).
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Mutation, Proposal, HastingsRatio};
/// use rand_core::TryRng;
///
/// /// Multiplies by 2 three times as often as it halves.
/// struct Doubling;
///
/// impl Mutation<f32> for Doubling {
///     type Correction = HastingsRatio;
///
///     fn try_propose<R: TryRng + ?Sized>(
///         &self,
///         from: f32,
///         rng: &mut R,
///     ) -> Result<Proposal<f32, HastingsRatio>, R::Error> {
///         // Densities with respect to length: the step back is 2 or 1/2 times as dense as its probability.
///         Ok(if rng.try_next_u32()? >> 30 > 0 {
///             Proposal::new(2.0 * from, HastingsRatio::new(0.75, 0.25 * 2.0))
///         } else {
///             Proposal::new(0.5 * from, HastingsRatio::new(0.25, 0.75 * 0.5))
///         })
///     }
/// }
/// ```
///
/// # See also
///
/// - [`Symmetric`](super::Symmetric), where the ratio is always 1.
/// - [`HastingsCounts`], where T consists of integers.
#[doc(alias = "proposal_ratio")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HastingsRatio {
    /// Zero if there is no way back, unsound if this is not a valid ratio.
    pub(super) standing: Standing,
    /// The ratio where it is positive.
    pub(super) value: Scaled,
}

impl HastingsRatio {
    /// The ratio of a symmetric proposal: 1.
    pub const ONE: Self = Self::positive(Scaled::ONE);

    const fn positive(value: Scaled) -> Self {
        Self {
            standing: Standing::Positive,
            value,
        }
    }

    const fn without_value(standing: Standing) -> Self {
        Self {
            standing,
            value: Scaled::ONE,
        }
    }

    /// The ratio of two densities, `forward` = T(x→x′) and `backward` = T(x′→x), with respect to the same measure and up to
    /// the same factor.
    ///
    /// If `backward` is 0, the proposal is never accepted. If a density is NaN, infinite or negative, or `forward` is 0 (so
    /// that x′ could not have been proposed), the proposal is refused and counted.
    #[must_use]
    #[inline]
    pub const fn new(forward: f32, backward: f32) -> Self {
        match (
            Standing::of_density(forward),
            Standing::of_density(backward),
        ) {
            (Standing::Positive, Standing::Positive) => {
                Self::positive(Scaled::of(backward).over(Scaled::of(forward)))
            }
            (Standing::Positive, Standing::Zero) => Self::without_value(Standing::Zero),
            _ => Self::without_value(Standing::Unsound),
        }
    }

    /// The ratio of two counts up to 2⁶⁴, such as the numerators of a table.
    ///
    /// It is correctly rounded, except for quotients within 1e-6 ulp of the midpoint between two `f32`. A count of 0 acts
    /// like a density of 0 in [`HastingsRatio::new`]; a count above 2⁶⁴ counts as 2⁶⁴.
    #[must_use]
    #[inline]
    pub const fn from_counts(forward: u128, backward: u128) -> Self {
        HastingsCounts::new(forward, backward).ratio()
    }

    /// Of two moves that are independent.
    #[inline]
    pub(super) const fn times(self, other: Self) -> Self {
        Self {
            standing: self.standing.and(other.standing),
            value: self.value.times(other.value),
        }
    }
}

/// The Hastings ratio T(x′→x)/T(x→x′) of a proposal x′ as two integers, such as the numerators of a table.
///
/// A chain of integer weights takes them as they are: its acceptance is exact, and no floating-point operation takes
/// place. A chain of a [`TargetDensity`](super::TargetDensity) divides them like [`HastingsRatio::from_counts`].
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Chain, HastingsCounts, Mutation, Proposal};
/// use rand_core::TryRng;
/// use rand_pcg::Pcg32;
///
/// /// Up one place of ten in three cases out of four, else down, in a circle.
/// struct Upwards;
///
/// impl Mutation<u32> for Upwards {
///     type Correction = HastingsCounts;
///
///     fn try_propose<R: TryRng + ?Sized>(
///         &self,
///         from: u32,
///         rng: &mut R,
///     ) -> Result<Proposal<u32, HastingsCounts>, R::Error> {
///         Ok(if rng.try_next_u32()? >> 30 > 0 {
///             Proposal::new((from + 1) % 10, HastingsCounts::new(3, 1))
///         } else {
///             Proposal::new((from + 9) % 10, HastingsCounts::new(1, 3))
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
///
/// # See also
///
/// - [`HastingsRatio`], where T is not an integer.
/// - [`Chance`](super::Chance), the exact acceptance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HastingsCounts {
    /// The ratio is backward·2^raised/forward; both are at most 2⁶⁴.
    pub(super) forward: u128,
    pub(super) backward: u128,
    pub(super) raised: i32,
}

impl HastingsCounts {
    /// The counts of a symmetric proposal.
    pub const EQUAL: Self = Self::new(1, 1);

    /// T(x→x′) and T(x′→x), both up to the same factor.
    ///
    /// If `backward` is 0, the proposal is never accepted. If `forward` is 0, it could not have been made and is refused. A
    /// count above 2⁶⁴ counts as 2⁶⁴.
    #[must_use]
    #[inline]
    pub const fn new(forward: u128, backward: u128) -> Self {
        Self {
            forward: at_most(forward),
            backward: at_most(backward),
            raised: 0,
        }
    }

    /// T(x→x′), at most 2⁶⁴. Of a [`Product`](super::Product) beyond that, both counts lose the same low bits here, but not
    /// in the acceptance.
    #[must_use]
    #[inline]
    pub const fn forward(self) -> u128 {
        let above = if self.raised > 0 { self.raised } else { 0 };
        lowered(self.forward, above.unsigned_abs())
    }

    /// T(x′→x), at most 2⁶⁴, likewise.
    #[must_use]
    #[inline]
    pub const fn backward(self) -> u128 {
        let above = if self.raised < 0 { self.raised } else { 0 };
        lowered(self.backward, above.unsigned_abs())
    }

    /// The ratio in floating point.
    #[must_use]
    #[inline]
    pub const fn ratio(self) -> HastingsRatio {
        match self.way() {
            Standing::Positive => HastingsRatio::positive(self.quotient()),
            standing => HastingsRatio::without_value(standing),
        }
    }

    /// Zero if there is no way back, unsound if there was no way to the proposal.
    #[inline]
    pub(super) const fn way(self) -> Standing {
        match (self.forward, self.backward) {
            (0, _) => Standing::Unsound,
            (_, 0) => Standing::Zero,
            _ => Standing::Positive,
        }
    }

    /// Of two moves that are independent: exact while the products are at most 2⁶⁴. Beyond that each of the two keeps its own
    /// 64 leading bits, so that it loses less than 2⁻⁶³ of itself, however many moves follow.
    #[inline]
    pub(super) const fn times(self, other: Self) -> Self {
        let (forward, down) = leading(self.forward.saturating_mul(other.forward));
        let (backward, up) = leading(self.backward.saturating_mul(other.backward));
        let raised = self.raised.saturating_add(other.raised);
        Self {
            forward,
            backward,
            raised: raised
                .saturating_add_unsigned(up)
                .saturating_sub_unsigned(down),
        }
    }

    /// backward/forward, both positive. Correctly rounded, except next to the midpoint between two `f32`.
    #[inline]
    pub(super) const fn quotient(self) -> Scaled {
        if self.forward == self.backward {
            return Scaled::ONE.raised(self.raised);
        }
        let (there, back) = (Digits::of(self.forward), Digits::of(self.backward));
        let quotient = back.high / there.high;
        let rest = remainder(back.high, quotient, there.high) + back.low;
        let rounded = quotient + (rest - quotient * there.low) / there.high;
        let exponent = back.exponent.wrapping_sub(there.exponent);
        Scaled::of(rounded).raised(exponent.saturating_add(self.raised))
    }
}

/// All the words of the widest table, 2⁶⁴.
const MOST: u128 = 1 << 64;

#[inline]
const fn at_most(count: u128) -> u128 {
    if count < MOST { count } else { MOST }
}

/// A count without some of its low bits; 0 only if it was.
#[inline]
const fn lowered(count: u128, by: u32) -> u128 {
    let rest = if by < 128 { count.wrapping_shr(by) } else { 0 };
    if rest == 0 && count > 0 { 1 } else { rest }
}

/// A number's 64 leading bits, if it is above 2⁶⁴, and how many are gone.
#[inline]
const fn leading(number: u128) -> (u128, u32) {
    if number <= MOST {
        return (number, 0);
    }
    let by = 64_u32.wrapping_sub(number.leading_zeros());
    (number.wrapping_shr(by), by)
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
    const fn of(count: u128) -> Self {
        /// 2⁻²³, the last place of the high part.
        const PLACE: f32 = f32::EPSILON;
        if count >> 64 != 0 {
            return Self {
                high: 1.0,
                low: 0.0,
                exponent: 64,
            };
        }
        let count = count as u64;
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
