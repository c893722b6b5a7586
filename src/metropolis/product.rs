//! Products: states of several parts, each with a mutation of its own.

use super::hastings_correction::{Hastings, HastingsCorrection, Stated as _};
use super::mixture::joined;
use super::{Mutation, Proposal, StateSource};
use rand_core::TryRng;

/// Proposes for a state of two to four parts, `(A, B, ..)`, by a mutation for each part.
///
/// All parts change in one step, which is accepted or rejected as a whole.
///
/// A product of warps, tables or [`UniformStep`](super::UniformStep)s is also a [`StateSource`], whose parts are independent:
/// it starts a chain ([`Chain::resample`](super::Chain::resample)), and it proposes as
/// [`Independence`](super::Independence).
///
/// # Domain
///
/// - States: tuples of what the mutations propose. Parts that are tuples take a product within the product.
/// - Words: those of the first part, then those of the next.
/// - T(x→x′) and the density of a source are the products over the parts. A source whose density leaves the range of `f32`
///   starts no chain.
/// - Hastings ratio: the product of those of the parts. A product of symmetric mutations is symmetric.
///   [`HastingsCounts`](super::HastingsCounts) are multiplied exactly up to 2⁶⁴, as of two tables of 32-bit words. Beyond
///   that each product loses less than 2⁻⁶³ of itself, so the acceptance is off by less than 2⁻⁶³ of itself for each part
///   beyond the first, in any order, before it is rounded up to a word.
/// - [`Proposal::kind`](super::Proposal::kind) is that of the first part.
///
/// # Accuracy
///
/// Each [`HastingsRatio`](super::HastingsRatio) beyond the first adds at most 2 ulp (units in the last place) to the error of
/// the acceptance, and each factor of a density beyond the first at most 1 ulp to its own: its own rounding where it has one,
/// and that of a product.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{BoxStep, Chain, Mixture, Product, UniformIndex, UniformStep, WrappedWalk};
/// use rand_pcg::Pcg32;
///
/// // One of three lamps, and the uniforms of a direction.
/// let f = |(lamp, [u, v]): (usize, [f32; 2])| [3.0, 1.0, 2.0][lamp] * u * v;
/// let (lamp, small) = (UniformIndex::new(3)?, WrappedWalk::new(BoxStep::new([0.1; 2])?));
/// let anew = Product::new((lamp, UniformStep::new()));
/// let mutation = Mixture::new((anew, Product::new((lamp, small))), &[0.1, 0.9])?;
///
/// let mut rng = Pcg32::new(42, 54);
/// let mut chain = Chain::new((0, [0.5; 2]), f)?;
/// let mut first = 0.0;
/// for _ in 0..10_000 {
///     for ((lamp, _), share) in chain.step(f, &mutation, &mut rng).recorded() {
///         first += if lamp == 0 { share } else { 0.0 };
///     }
/// }
/// assert!((first / 10_000.0 - 0.5).abs() < 0.05);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`Mixture`](super::Mixture), which takes one of several mutations at a time.
/// - [`Subset`](super::Subset), which changes some coordinates of a point.
/// - [`warp::Product`](crate::warp::Product), of warps.
///
/// # Source
///
/// W. K. Hastings, "Monte Carlo Sampling Methods Using Markov Chains and Their Applications", 1970,
/// [doi:10.1093/biomet/57.1.97](https://doi.org/10.1093/biomet/57.1.97).
#[doc(alias = "tuple")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Product<M> {
    parts: M,
}

impl<M> Product<M> {
    /// A mutation, or a source, for each part: a tuple of two to four. Pass one that is not `Copy` by reference.
    #[must_use]
    #[inline]
    pub const fn new(parts: M) -> Self {
        Self { parts }
    }

    /// The mutations, or sources, in the order of the parts.
    #[must_use]
    #[inline]
    pub const fn parts(&self) -> &M {
        &self.parts
    }
}

macro_rules! tuples {
    ($($($state:ident $part:ident $index:tt),+;)*) => {$(
        impl<$($state: Copy, $part: Mutation<$state>),+> Mutation<($($state,)+)> for Product<($($part,)+)> {
            type Correction = joined!($($part::Correction),+);

            #[inline]
            fn try_propose<R: TryRng + ?Sized>(
                &self,
                from: ($($state,)+),
                rng: &mut R,
            ) -> Result<Proposal<($($state,)+), Self::Correction>, R::Error> {
                let parts = ($(self.parts.$index.try_propose(from.$index, rng)?,)+);
                let ratio = Hastings::One$(.times(parts.$index.correction.hastings()))+;
                Ok(Proposal {
                    state: ($(parts.$index.state,)+),
                    correction: Self::Correction::of(ratio),
                    kind: parts.0.kind,
                })
            }
        }

        impl<$($state: Copy, $part: StateSource<$state>),+> StateSource<($($state,)+)> for Product<($($part,)+)> {
            type Correction = joined!($($part::Correction),+);

            #[inline]
            fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<($($state,)+), R::Error> {
                Ok(($(self.parts.$index.try_draw_state(rng)?,)+))
            }

            #[inline]
            fn pdf_of_state(&self, state: ($($state,)+)) -> f32 {
                1.0 $(* self.parts.$index.pdf_of_state(state.$index))+
            }

            #[inline]
            fn ratio_of_states(&self, from: ($($state,)+), to: ($($state,)+)) -> Self::Correction {
                let ratio = Hastings::One$(.times(self.parts.$index.ratio_of_states(from.$index, to.$index).hastings()))+;
                Self::Correction::of(ratio)
            }
        }
    )*};
}

tuples! {
    X A 0, Y B 1;
    X A 0, Y B 1, Z C 2;
    X A 0, Y B 1, Z C 2, V E 3;
}
