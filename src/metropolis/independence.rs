//! Proposals that do not depend on the state.

use super::coordinates::Coordinates;
use super::{HastingsCorrection, HastingsCounts, HastingsRatio, Mutation, Proposal, Symmetric};
use crate::discrete::{Alias, AliasEntry, Cdf, Storage, Word};
use crate::uniform::Uniforms;
use crate::warp::Warp;
use rand_core::TryRng;

/// A sampler of states whose density is known: any [`Warp`], a [`Cdf`] or [`Alias`] table of indices, the
/// [`UniformStep`] of the unit cube, or [`UniformIndex`](super::UniformIndex).
///
/// It can propose ([`Independence`]) and it can start a chain ([`Chain::search`](super::Chain::search),
/// [`Chain::resample`](super::Chain::resample)).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a source of states of type `{X}`",
    label = "does not draw a `{X}`",
    note = "sources are warps (of points), `Cdf` and `Alias` tables and `UniformIndex` (of `usize`), and `UniformStep` (of `f32` and `[f32; D]`)"
)]
pub trait StateSource<X> {
    /// The form of the Hastings ratio of its proposals: [`HastingsCounts`] for tables, [`HastingsRatio`] otherwise.
    type Correction: HastingsCorrection;

    /// Draws a state.
    ///
    /// # Errors
    /// The generator's own error.
    fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<X, R::Error>;

    /// The density at a state, with respect to the same measure as the target's. It needs to be normalised only if you use
    /// the weight of a [`Start`](super::Start).
    #[must_use]
    fn pdf_of_state(&self, state: X) -> f32;

    /// The Hastings ratio p(`from`)/p(`to`) of a proposal. For two densities it is
    /// `HastingsRatio::new(self.pdf_of_state(to), self.pdf_of_state(from))`.
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

/// Proposes draws from a warp or a table, wherever the chain is: the independence sampler.
///
/// The closer p is to a multiple of f, the more proposals are accepted; all of them if p is proportional to f. The chain
/// never visits states that p never proposes, and never leaves one if started there. Where the tails of f are heavier
/// than those of p, the chain gets stuck for long.
///
/// # Domain
///
/// - States: the points of a warp, or the indices of a table.
/// - Words: those of one draw.
/// - T(x→x′) = p(x′). The Hastings ratio is p(x)/p(x′); for a table it is that of the numerators, as [`HastingsCounts`].
///
/// # Examples
///
/// ```
/// use microwarp::discrete::Cdf;
/// use microwarp::metropolis::{Chain, Independence};
/// use rand_pcg::Pcg32;
/// // Proposals that already have the target density are all accepted.
/// let weights = [9.0, 1.0];
/// let mutation = Independence::new(Cdf::new(&weights)?);
/// let mut chain = Chain::new(0, |i: usize| weights[i])?;
/// for _ in 0..100 {
///     chain.step(|i| weights[i], &mutation, &mut Pcg32::new(1, 1));
/// }
/// assert_eq!(chain.acceptance_rate(), Some(1.0));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`UniformStep`] and [`UniformIndex`](super::UniformIndex), where p is uniform.
/// - [`Mixture`](super::Mixture), to combine it with small steps.
///
/// # Source
///
/// L. Tierney, "Markov Chains for Exploring Posterior Distributions", 1994,
/// [doi:10.1214/aos/1176325750](https://doi.org/10.1214/aos/1176325750).
#[doc(alias = "independence_sampler")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Independence<S> {
    source: S,
}

impl<S> Independence<S> {
    /// Proposes draws from this warp or table.
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

/// Proposes a uniform point of the unit cube: the large step of a chain in primary sample space.
///
/// # Domain
///
/// - States: [0, 1)ᴰ, as `f32` or `[f32; D]`.
/// - Words: one per coordinate. Each coordinate is on the 24-bit grid of canonical uniforms.
/// - T(x→x′) = 1.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Mutation, UniformStep};
/// use rand_pcg::Pcg32;
/// let Ok(proposal) = UniformStep::new().try_propose([0.5; 3], &mut Pcg32::new(1, 1));
/// assert!(proposal.state.iter().all(|x| (0.0..1.0).contains(x)));
/// ```
///
/// # See also
///
/// - [`LargeSmall`](super::LargeSmall), which combines it with small steps.
/// - [`UniformIndex`](super::UniformIndex), the same for indices.
///
/// # Source
///
/// C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the Metropolis Light
/// Transport Algorithm", 2002, [doi:10.1111/1467-8659.t01-1-00703](https://doi.org/10.1111/1467-8659.t01-1-00703).
#[doc(alias = "large_step")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UniformStep;

impl UniformStep {
    /// The step. It has no parameters.
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
