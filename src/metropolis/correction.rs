//! What a mutation says of its way there and back, and the acceptance that follows.

use super::Counts;
use super::counts::quotient_of_counts;
use super::weight::{Standing, Weighing as _, Weight};
use crate::num::Scaled as Apart;

/// What becomes of a proposal.
#[derive(Clone, Copy, Debug)]
pub enum Verdict<A> {
    /// Its density or its ratio is none.
    Refused,
    /// There is no way to it.
    Never,
    /// It is accepted with this probability.
    With(A),
}

/// What a correction of any type states.
#[derive(Clone, Copy, Debug)]
pub enum Stated {
    Nothing,
    Counts(Counts),
    Ratio(Ratio),
}

mod sealed {
    use super::{Stated, Verdict, Weight};

    pub trait Judge: Copy {
        /// What becomes of a proposal of density `to` where the chain is at a state of density `from`.
        fn judge<D: Weight>(self, from: D, to: D) -> Verdict<D::Acceptance>;
        fn stated(self) -> Stated;
        /// Of a mixture, which has parts only whose statements its own type can hold.
        fn of(stated: Stated) -> Self;
    }
}
pub(super) use sealed::Judge;

/// The ratio T(x′→x)/T(x→x′) of a proposal: [`Symmetric`], which is 1 and costs nothing, [`Counts`], which are
/// two integers, or a [`Ratio`]. The trait is sealed.
pub trait Correction: Judge {
    /// What a mixture of mutations of this kind and of another one states.
    type With<C: Correction>: Correction;
    /// What a mixture of mutations of this kind and of some with [`Counts`] states.
    type WithCounts: Correction;
}

/// The way back is as likely as the way there: T(x′→x) = T(x→x′).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Symmetric;

impl Judge for Symmetric {
    #[inline]
    fn judge<D: Weight>(self, from: D, to: D) -> Verdict<D::Acceptance> {
        match to.standing() {
            Standing::Positive => Verdict::With(D::accepted(from, to)),
            Standing::Zero => Verdict::Never,
            Standing::Unsound => Verdict::Refused,
        }
    }

    #[inline]
    fn stated(self) -> Stated {
        Stated::Nothing
    }

    #[inline]
    fn of(_: Stated) -> Self {
        Self
    }
}

impl Correction for Symmetric {
    type With<C: Correction> = C;
    type WithCounts = Counts;
}

/// The ratio T(x′→x)/T(x→x′) of a proposal x′.
///
/// Its exponent is set aside, so that neither it nor its product with the densities over- or underflows.
/// Error of the acceptance: 2 ulp, for densities and ratios of any magnitude; of logarithms, see
/// [`LogDensity`](super::LogDensity).
///
/// ```
/// use microwarp::metropolis::{Mutation, Proposal, Ratio};
/// use rand_core::TryRng;
///
/// /// Multiplies by 2 three times as often as it halves.
/// struct Doubling;
///
/// impl Mutation<f32> for Doubling {
///     type Correction = Ratio;
///
///     fn try_propose<R: TryRng + ?Sized>(
///         &self,
///         from: f32,
///         rng: &mut R,
///     ) -> Result<Proposal<f32, Ratio>, R::Error> {
///         // Densities with respect to length: the step back is 2 or 1/2 times as dense as its probability.
///         Ok(if rng.try_next_u32()? >> 30 > 0 {
///             Proposal::new(2.0 * from, Ratio::new(0.75, 0.25 * 2.0))
///         } else {
///             Proposal::new(0.5 * from, Ratio::new(0.25, 0.75 * 0.5))
///         })
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ratio(Way);

#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Way {
    /// A positive ratio.
    Both(Apart),
    /// There is no way back.
    NoReturn,
    Unsound,
}

impl Ratio {
    /// The ratio of 1, of a symmetric proposal.
    pub const ONE: Self = Self(Way::Both(Apart::ONE));

    /// The ratio of two densities: `forward` = T(x→x′), `backward` = T(x′→x), both with respect to the same
    /// measure and up to the same factor.
    ///
    /// Where `backward` is 0 the proposal is never accepted. Densities that are NaN, infinite or negative,
    /// and a `forward` of 0 (then x′ could not have been proposed), have the proposal refused and counted.
    #[must_use]
    #[inline]
    pub fn new(forward: f32, backward: f32) -> Self {
        match (forward.standing(), backward.standing()) {
            (Standing::Positive, Standing::Positive) => {
                Self(Way::Both(Apart::of(backward).over(Apart::of(forward))))
            }
            (Standing::Positive, Standing::Zero) => Self(Way::NoReturn),
            _ => Self(Way::Unsound),
        }
    }

    /// The ratio of two counts up to 2⁶⁴, such as the numerators of a table, correctly rounded but for
    /// quotients within 1e-6 ulp of the middle between two `f32`.
    ///
    /// Counts of 0 are treated as densities of 0 are by [`Ratio::new`], larger ones than 2⁶⁴ as 2⁶⁴.
    #[must_use]
    #[inline]
    pub fn from_counts(forward: u128, backward: u128) -> Self {
        match (forward, backward) {
            (0, _) => Self(Way::Unsound),
            (_, 0) => Self(Way::NoReturn),
            _ => Self(Way::Both(quotient_of_counts(forward, backward))),
        }
    }
}

impl Judge for Ratio {
    #[inline]
    fn judge<D: Weight>(self, from: D, to: D) -> Verdict<D::Acceptance> {
        match (self.0, to.standing()) {
            (Way::Unsound, _) | (_, Standing::Unsound) => Verdict::Refused,
            (Way::NoReturn, _) | (_, Standing::Zero) => Verdict::Never,
            (Way::Both(ratio), Standing::Positive) => {
                Verdict::With(D::accepted_with_ratio(from, to, ratio))
            }
        }
    }

    #[inline]
    fn stated(self) -> Stated {
        Stated::Ratio(self)
    }

    #[inline]
    fn of(stated: Stated) -> Self {
        match stated {
            Stated::Nothing => Self::ONE,
            Stated::Counts(counts) => counts.ratio(),
            Stated::Ratio(ratio) => ratio,
        }
    }
}

impl Correction for Ratio {
    type With<C: Correction> = Self;
    type WithCounts = Self;
}
