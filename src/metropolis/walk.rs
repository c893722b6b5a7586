//! Walks in ℝᴰ.

use super::coordinates::Coordinates;
use super::displacement::{BoxStep, Displacement, ExponentialStep, NormalStep};
use super::{Mutation, Proposal, Symmetric};
use crate::tier::Tier;
use rand_core::TryRng;

/// Each coordinate with the step along it, of one word, put together by `sum`.
#[inline]
pub(super) fn displaced<X, L, R>(
    law: &L,
    from: X,
    rng: &mut R,
    sum: impl Fn(f32, f32) -> f32,
) -> Result<X, R::Error>
where
    X: Coordinates,
    L: Displacement<X>,
    R: TryRng + ?Sized,
{
    let mut to = from;
    for (axis, x) in to.as_mut_slice().iter_mut().enumerate() {
        *x = sum(*x, law.displacement(axis, rng.try_next_u32()?));
    }
    Ok(to)
}

/// x plus a step along each coordinate, or x itself where that leaves the range of `f32`.
#[inline]
fn walked<X, L, R>(law: &L, from: X, rng: &mut R) -> Result<Proposal<X, Symmetric>, R::Error>
where
    X: Coordinates,
    L: Displacement<X>,
    R: TryRng + ?Sized,
{
    let to = displaced(law, from, rng, |x, step| x + step)?;
    let inside = to.as_slice().iter().all(|x| x.is_finite());
    Ok(Proposal::new(if inside { to } else { from }, Symmetric))
}

macro_rules! walks {
    ($([$($tier:ident)?] $name:ty;)*) => {$(
        impl<X: Coordinates, $($tier: Tier)?> Mutation<X> for $name {
            type Correction = Symmetric;

            #[inline]
            fn try_propose<R: TryRng + ?Sized>(
                &self,
                from: X,
                rng: &mut R,
            ) -> Result<Proposal<X, Symmetric>, R::Error> {
                walked(self, from, rng)
            }
        }
    )*};
}

walks! {
    [] BoxStep<X>;
    [T] NormalStep<X, T>;
    [T] ExponentialStep<T>;
}

/// Proposes x plus a step of a law of one's own, along each coordinate.
///
/// - States: ℝᴰ, as `f32` or `[f32; D]`.
/// - Words: one a coordinate.
/// - T(x→x′) = T(x′→x), but for the rounding of x + step.
/// - A proposal beyond the range of `f32` stays at x instead.
///
/// ```
/// use microwarp::metropolis::{Displacement, Mutation, Walk};
/// use rand_pcg::Pcg32;
///
/// /// A quarter up or down.
/// struct Quarter;
///
/// impl Displacement<f32> for Quarter {
///     fn displacement(&self, _: usize, word: u32) -> f32 {
///         if word >> 31 == 0 { 0.25 } else { -0.25 }
///     }
/// }
///
/// let Ok(proposal) = Walk::new(Quarter).try_propose(1.0, &mut Pcg32::new(1, 1));
/// assert!(proposal.state == 0.75 || proposal.state == 1.25);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Walk<L> {
    law: L,
}

impl<L> Walk<L> {
    /// The steps of this law.
    #[must_use]
    #[inline]
    pub const fn new(law: L) -> Self {
        Self { law }
    }
}

impl<X: Coordinates, L: Displacement<X>> Mutation<X> for Walk<L> {
    type Correction = Symmetric;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, Symmetric>, R::Error> {
        walked(&self.law, from, rng)
    }
}
