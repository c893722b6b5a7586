//! The trait of what proposes.

use super::hastings_correction::HastingsCorrection;
use rand_core::TryRng;

/// A state that is proposed, and what its mutation says of the way there and back.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Proposal<X, C> {
    /// The state x′.
    pub state: X,
    /// T(x′→x)/T(x→x′).
    pub correction: C,
    /// Which of the mutations of a [`Mixture`](super::Mixture) proposed it; 0 without one.
    pub kind: u32,
}

impl<X, C> Proposal<X, C> {
    /// A proposal of a mutation that is no mixture.
    #[must_use]
    #[inline]
    pub const fn new(state: X, correction: C) -> Self {
        Self {
            state,
            correction,
            kind: 0,
        }
    }

    /// The same proposal of another state, for a mutation that is made of another one.
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
/// To write one of one's own, draw x′ and state the ratio T(x′→x)/T(x→x′): [`Symmetric`](super::Symmetric)
/// where it is always 1, [`HastingsCounts`](super::HastingsCounts) where it is one of two integers, or a
/// [`HastingsRatio`](super::HastingsRatio). Nothing else need be known of T.
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
pub trait Mutation<X> {
    /// What is said of the ratio T(x′→x)/T(x→x′).
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

/// A reference to a mutation is a mutation, so that mixtures can borrow.
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
