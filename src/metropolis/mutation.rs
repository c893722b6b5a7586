//! The trait of mutations, which propose states.

use super::hastings_correction::HastingsCorrection;
use rand_core::TryRng;

/// A proposed state, and the Hastings ratio of the move to it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Proposal<X, C> {
    /// The state x′.
    pub state: X,
    /// The Hastings ratio T(x′→x)/T(x→x′).
    pub correction: C,
    /// The index of the mutation of a [`Mixture`](super::Mixture) that proposed it; 0 without a mixture.
    pub kind: u32,
}

impl<X, C> Proposal<X, C> {
    /// The proposal of a mutation that is not a mixture.
    #[must_use]
    #[inline]
    pub const fn new(state: X, correction: C) -> Self {
        Self {
            state,
            correction,
            kind: 0,
        }
    }

    /// The same proposal with another state, for a mutation that wraps another one.
    #[must_use]
    #[inline]
    pub fn map<Y>(self, state: impl FnOnce(X) -> Y) -> Proposal<Y, C> {
        Proposal {
            state: state(self.state),
            correction: self.correction,
            kind: self.kind,
        }
    }
}

/// A rule by which a chain at x proposes a state x′, with probability (density) T(x→x′).
///
/// To write your own, draw x′ and state the Hastings ratio T(x′→x)/T(x→x′): [`Symmetric`](super::Symmetric) if it is
/// always 1, [`HastingsCounts`](super::HastingsCounts) if it is a ratio of integers, and a
/// [`HastingsRatio`](super::HastingsRatio) otherwise. Nothing else about T is needed.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Chain, Mutation, Proposal, Symmetric};
/// use rand_core::TryRng;
/// use rand_pcg::Pcg32;
///
/// /// One place up or down among ten, in a circle.
/// struct Neighbour;
///
/// impl Mutation<u32> for Neighbour {
///     type Correction = Symmetric;
///
///     fn try_propose<R: TryRng + ?Sized>(
///         &self,
///         from: u32,
///         rng: &mut R,
///     ) -> Result<Proposal<u32, Symmetric>, R::Error> {
///         let by = if rng.try_next_u32()? >> 31 == 0 { 1 } else { 9 };
///         Ok(Proposal::new((from + by) % 10, Symmetric))
///     }
/// }
///
/// let weight = |place: u32| place as f32;
/// let mut chain = Chain::new(5, weight)?;
/// let step = chain.step(weight, &Neighbour, &mut Pcg32::new(1, 1));
/// assert!(step.proposed == 4 || step.proposed == 6);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [The mutations of this crate](crate::metropolis#which-mutation).
/// - [`StepLaw`](super::StepLaw), a shorter way to write a symmetric step along each coordinate.
#[doc(alias = "transition_kernel")]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a mutation of states of type `{X}`",
    label = "does not propose a `{X}`",
    note = "a warp or a table proposes as `Independence::new(..)`, and a `StepLaw` as `RandomWalk::new(..)`",
    note = "steps take points as they are, `f32` or `[f32; D]`, of as many coordinates as their parameters"
)]
pub trait Mutation<X> {
    /// The form in which the mutation states its Hastings ratio.
    type Correction: HastingsCorrection;

    /// Proposes a state.
    ///
    /// # Errors
    /// The generator's own error.
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, Self::Correction>, R::Error>;
}

/// A reference to a mutation is a mutation, so mixtures can borrow.
impl<X, M: Mutation<X> + ?Sized> Mutation<X> for &M {
    type Correction = M::Correction;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, Self::Correction>, R::Error> {
        (**self).try_propose(from, rng)
    }
}
