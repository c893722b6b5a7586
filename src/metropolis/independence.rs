//! Proposals that do not depend on where the chain is.

use super::coordinates::Coordinates;
use super::{HastingsCorrection, HastingsCounts, HastingsRatio, Mutation, Proposal, Symmetric};
use crate::discrete::{Alias, AliasEntry, Cdf, Storage, Word};
use crate::uniform::Uniforms;
use crate::warp::Warp;
use rand_core::TryRng;

/// Another sampler of the chain's states, whose density is known: any [`Warp`], a [`Cdf`] or [`Alias`] table
/// of indices, the [`UniformStep`] of the unit cube, the [`UniformIndex`](super::UniformIndex).
///
/// It can propose ([`Independence`]) and it can start a chain ([`Chain::search`](super::Chain::search),
/// [`Chain::resample`](super::Chain::resample)).
pub trait StateSource<X> {
    /// What its proposals state: a [`HastingsRatio`], or [`HastingsCounts`] of a table.
    type Correction: HastingsCorrection;

    /// Draws a state.
    ///
    /// # Errors
    /// The generator's own error.
    fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<X, R::Error>;

    /// The density at a state, with respect to the measure that the target's density is meant for; not
    /// necessarily normalised if no weight is to be read off a start.
    #[must_use]
    fn pdf_of_state(&self, state: X) -> f32;

    /// p(`from`)/p(`to`), the ratio of a proposal: of two densities, `HastingsRatio::new(self.pdf_of_state(to),
    /// self.pdf_of_state(from))`.
    #[must_use]
    fn ratio_of_states(&self, from: X, to: X) -> Self::Correction;
}

impl<W: Warp<Density = f32>> StateSource<W::Point> for W {
    type Correction = HastingsRatio;

    #[inline]
    fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<W::Point, R::Error> {
        self.try_draw(rng)
    }

    #[inline]
    fn pdf_of_state(&self, state: W::Point) -> f32 {
        self.pdf(state)
    }

    #[inline]
    fn ratio_of_states(&self, from: W::Point, to: W::Point) -> HastingsRatio {
        HastingsRatio::new(self.pdf(to), self.pdf(from))
    }
}

macro_rules! tables {
    ($($table:ident of $item:ty;)*) => {$(
        impl<W: Word, S: Storage<Item = $item>> StateSource<usize> for $table<S> {
            type Correction = HastingsCounts;

            #[inline]
            fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<usize, R::Error> {
                self.try_draw_index(rng)
            }

            #[inline]
            fn pdf_of_state(&self, state: usize) -> f32 {
                self.pmf(state)
            }

            #[inline]
            fn ratio_of_states(&self, from: usize, to: usize) -> HastingsCounts {
                HastingsCounts::new(self.numerator(to).into(), self.numerator(from).into())
            }
        }
    )*};
}

tables! {
    Cdf of W;
    Alias of AliasEntry<W>;
}

/// Proposes draws of another sampler, wherever the chain is.
///
/// - States: the points of a warp, the indices of a table.
/// - Words: those of the draw.
/// - T(x→x′) = p(x′); the ratio is p(x)/p(x′). Of a table it is that of the numerators, as [`HastingsCounts`].
///
/// The nearer p comes to a multiple of f, the more is accepted; where it is one, all. States that p never
/// proposes, the chain never visits; started at one, it never leaves it. Tails of f heavier than those of p
/// hold the chain for long.
///
/// Source: L. Tierney, "Markov Chains for Exploring Posterior Distributions", 1994.
///
/// ```
/// use microwarp::discrete::Cdf;
/// use microwarp::metropolis::{Chain, Independence};
/// use rand_pcg::Pcg32;
/// // Proposals that already have the density asked for are all accepted.
/// let weights = [9.0, 1.0];
/// let mutation = Independence::new(Cdf::new(&weights)?);
/// let mut chain = Chain::new(0, |i: usize| weights[i])?;
/// for _ in 0..100 {
///     chain.step(|i| weights[i], &mutation, &mut Pcg32::new(1, 1));
/// }
/// assert_eq!(chain.acceptance_rate(), Some(1.0));
/// # Ok::<(), microwarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Independence<S> {
    source: S,
}

impl<S> Independence<S> {
    /// Proposes the draws of this warp or table.
    #[must_use]
    #[inline]
    pub const fn new(source: S) -> Self {
        Self { source }
    }

    /// The warp or table that proposes.
    #[must_use]
    #[inline]
    pub const fn source(&self) -> &S {
        &self.source
    }
}

impl<X: Copy, S: StateSource<X>> Mutation<X> for Independence<S> {
    type Correction = S::Correction;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, S::Correction>, R::Error> {
        let to = self.source.try_draw_state(rng)?;
        Ok(Proposal::new(to, self.source.ratio_of_states(from, to)))
    }
}

/// Proposes any point of the unit cube: the large step of a chain in primary sample space.
///
/// - States: [0, 1)ᴰ, as `f32` or `[f32; D]`.
/// - Words: one a coordinate. Each coordinate is on the 24-bit grid of canonical uniforms.
/// - T(x→x′) = 1.
///
/// Source: C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the
/// Metropolis Light Transport Algorithm", 2002.
///
/// ```
/// use microwarp::metropolis::{Mutation, UniformStep};
/// use rand_pcg::Pcg32;
/// let Ok(proposal) = UniformStep::new().try_propose([0.5; 3], &mut Pcg32::new(1, 1));
/// assert!(proposal.state.iter().all(|x| (0.0..1.0).contains(x)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UniformStep;

impl UniformStep {
    /// The one there is.
    #[must_use]
    #[inline]
    pub const fn new() -> Self {
        Self
    }
}

impl<X: Coordinates> StateSource<X> for UniformStep {
    type Correction = HastingsRatio;

    #[inline]
    fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<X, R::Error> {
        Ok(<X as Uniforms>::try_draw(rng)?.get())
    }

    #[inline]
    fn pdf_of_state(&self, state: X) -> f32 {
        let inside = state.as_slice().iter().all(|x| (0.0..1.0).contains(x));
        if inside { 1.0 } else { 0.0 }
    }

    #[inline]
    fn ratio_of_states(&self, from: X, to: X) -> HastingsRatio {
        HastingsRatio::new(self.pdf_of_state(to), self.pdf_of_state(from))
    }
}

impl<X: Coordinates> Mutation<X> for UniformStep {
    type Correction = Symmetric;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        _: X,
        rng: &mut R,
    ) -> Result<Proposal<X, Symmetric>, R::Error> {
        Ok(Proposal::new(self.try_draw_state(rng)?, Symmetric))
    }
}
