//! Random walks in ℝᴰ, and in the unit cube with periodic boundaries.

use super::coordinates::Coordinates;
use super::step_law::{BoxStep, LogUniformStep, NormalStep, StepLaw};
use super::{Mutation, Proposal, Symmetric};
use crate::num::nearest;
use crate::tier::Tier;
use crate::uniform::{Uniforms as _, grid_from_word};
use rand_core::TryRng;

/// Combines each coordinate, by `sum`, with a step along it that takes one word.
#[inline]
fn displaced<X, L, R>(
    law: &L,
    from: X,
    rng: &mut R,
    sum: impl Fn(f32, f32) -> f32,
) -> Result<X, R::Error>
where
    X: Coordinates,
    L: StepLaw<X>,
    R: TryRng + ?Sized,
{
    let mut to = from;
    for (axis, x) in to.as_mut_slice().iter_mut().enumerate() {
        *x = sum(*x, law.displacement(axis, rng.try_next_u32()?));
    }
    Ok(to)
}

/// x plus a step along each coordinate, or x itself if the sum leaves the range of `f32`.
#[inline]
fn walked<X, L, R>(law: &L, from: X, rng: &mut R) -> Result<Proposal<X, Symmetric>, R::Error>
where
    X: Coordinates,
    L: StepLaw<X>,
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
    [T] LogUniformStep<T>;
}

/// Proposes x plus a step of your own distribution along each coordinate: a random walk in ℝᴰ.
///
/// # Domain
///
/// - States: ℝᴰ, as `f32` or `[f32; D]`. A step that would leave the range of `f32` proposes x itself.
/// - Words: one per coordinate.
/// - T(x→x′) = T(x′→x), up to the rounding of x + step.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{StepLaw, Mutation, RandomWalk};
/// use rand_pcg::Pcg32;
///
/// /// A quarter up or down.
/// struct Quarter;
///
/// impl StepLaw<f32> for Quarter {
///     fn displacement(&self, _: usize, word: u32) -> f32 {
///         if word >> 31 == 0 { 0.25 } else { -0.25 }
///     }
/// }
///
/// let Ok(proposal) = RandomWalk::new(Quarter).try_propose(1.0, &mut Pcg32::new(1, 1));
/// assert!(proposal.state == 0.75 || proposal.state == 1.25);
/// ```
///
/// # See also
///
/// - [`BoxStep`], [`NormalStep`], [`LogUniformStep`]: these are random walks as they are.
/// - [`WrappedWalk`], the same in the unit cube.
#[doc(alias = "gaussian_proposal")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RandomWalk<L> {
    law: L,
}

impl<L> RandomWalk<L> {
    /// Walks by steps of this distribution.
    #[must_use]
    #[inline]
    pub const fn new(law: L) -> Self {
        Self { law }
    }

    /// The distribution of the steps.
    #[must_use]
    #[inline]
    pub const fn law(&self) -> &L {
        &self.law
    }
}

impl<X: Coordinates, L: StepLaw<X>> Mutation<X> for RandomWalk<L> {
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

/// 2²⁴, the number of grid points.
const POINTS: f32 = 16_777_216.0;

/// The sum of a uniform and a step, modulo 1: a point of the 24-bit grid of canonical uniforms in [0, 1), for any input.
///
/// The uniform is cut to its leading 24 bits, after
/// [`Uniforms::canonical`](crate::uniform::Uniforms::canonical) has brought it into range. The step is rounded to the
/// nearest multiple of 2⁻²⁴, halves away from 0; NaN and infinite steps count as 0. So the sum is exact, and a step and its
/// negative undo each other.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::wrapping_add;
/// assert_eq!(wrapping_add(0.75, 0.5), 0.25);
/// assert_eq!(wrapping_add(0.0, -1e-10), 0.0);
/// assert_eq!(wrapping_add(0.25, -1000.5), 0.75);
/// ```
#[doc(alias = "modulo")]
#[must_use]
#[inline]
pub fn wrapping_add(uniform: f32, step: f32) -> f32 {
    let place = (uniform.canonical().get() * POINTS) as u32;
    let size = step.abs();
    // From 2²³ up there is no fraction; infinity and NaN take this way too.
    let fraction = if size < 8_388_608.0 {
        size - (size as u32) as f32
    } else {
        0.0
    };
    let steps = nearest(fraction * POINTS);
    let sum = if step < 0.0 {
        place.wrapping_sub(steps)
    } else {
        place.wrapping_add(steps)
    };
    // The upper bits are whole turns.
    grid_from_word(sum.wrapping_shl(8))
}

/// Proposes a random walk in the unit cube: a point that leaves it on one side comes back in on the other.
///
/// Each coordinate moves by [`wrapping_add`].
///
/// # Domain
///
/// - States: the unit cube [0, 1)ᴰ, as `f32` or `[f32; D]`, on the 24-bit grid of canonical uniforms. A start off the
///   grid moves onto it with the first accepted step.
/// - Words: one per coordinate.
/// - T(x→x′) = T(x′→x) exactly. A step below 2⁻²⁵ does not move the point.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{BoxStep, Mutation, WrappedWalk};
/// use rand_pcg::Pcg32;
/// let step = WrappedWalk::new(BoxStep::new([0.1; 3])?);
/// let Ok(proposal) = step.try_propose([0.99, 0.5, 0.0], &mut Pcg32::new(1, 1));
/// assert!(proposal.state.iter().all(|x| (0.0..1.0).contains(x)));
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`RandomWalk`], for ℝᴰ.
/// - [`LargeSmall`](super::LargeSmall), to combine it with large steps.
///
/// # Source
///
/// C. Kelemen, L. Szirmay-Kalos, G. Antal, F. Csonka, "A Simple and Robust Mutation Strategy for the Metropolis Light
/// Transport Algorithm", 2002, [doi:10.1111/1467-8659.t01-1-00703](https://doi.org/10.1111/1467-8659.t01-1-00703).
#[doc(alias = "small_step")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WrappedWalk<L> {
    law: L,
}

impl<L> WrappedWalk<L> {
    /// Walks by steps of this distribution, modulo 1.
    #[must_use]
    #[inline]
    pub const fn new(law: L) -> Self {
        Self { law }
    }

    /// The distribution of the steps.
    #[must_use]
    #[inline]
    pub const fn law(&self) -> &L {
        &self.law
    }
}

impl<X: Coordinates, L: StepLaw<X>> Mutation<X> for WrappedWalk<L> {
    type Correction = Symmetric;

    #[inline]
    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: X,
        rng: &mut R,
    ) -> Result<Proposal<X, Symmetric>, R::Error> {
        let to = displaced(&self.law, from, rng, wrapping_add)?;
        Ok(Proposal::new(to, Symmetric))
    }
}
