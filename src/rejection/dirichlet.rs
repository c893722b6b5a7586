//! The Dirichlet distribution.

use super::gamma_density::{of_shares, peak};
use super::gamma_tries::{Part, Tries};
use super::{Accepted, Failure, Rejection, with_budget};
use crate::error::{Error, tried};
use crate::num::{Scaled, above_zero, power_of_two, two_sum};
use crate::tier::Tier;
use core::marker::PhantomData;
use rand_core::TryRng;

/// The least gamma number that is not taken by its logarithm, 2⁻⁸⁰; those of shape 1 and more are larger.
const LEAST: f32 = power_of_two(-80);

/// Dirichlet with a shape for each of N shares: shares of a whole, none of them 0, such as the weights of a mixture or the
/// probabilities of a die that was counted.
///
/// Gamma numbers of these shapes over their sum. Where one is below 2⁻⁸⁰, as of small shapes, all are taken by their logarithms
/// less the largest one, so that no set of shapes makes 0/0.
///
/// # Density
/// Γ(Σα)/ΠΓ(α)·Πxᵅ⁻¹ with respect to all shares but one, where none is negative and their sum is 1 to rounding; else 0. A share
/// of 0 counts as 2⁻¹⁴⁹, and the largest one as what the others leave, whose digits decide where shapes are large. What `f32`
/// does not hold becomes 2⁻¹⁴⁹ or the largest finite number.
///
/// # Domain
/// - Point: N shares above 0, of sum 1 to rounding.
/// - Words a try: one try of a [`Gamma`](super::Gamma) number for each share, until one is rejected. A draw keeps those that were
///   accepted, and its tries are those of all shares together: N at least.
/// - Parameters: N from 1 up, and shapes from 1e-30 to 1e6.
/// - No inverse, as of all [rejection](crate::rejection#no-inverse).
///
/// # Accuracy
/// Gamma numbers and their logarithms have the errors of [`Gamma`](super::Gamma). A share made of them has a
/// relative error of (N + 4 + l) 2⁻²⁴, plus an absolute one of 2⁻¹⁴⁹, where l is by how much its logarithm is below the largest, and
/// 0 where none is taken.
///
/// The pdf has a
/// relative error of 3e-7 + 1.5e-7 N + 2e-10 Σ α|ln(nx/α)|, where n is Σα, or an absolute one of 2⁻¹⁴⁸.
///
/// Both bounds are found, not proven.
///
/// # Cost
/// Efficiency: that of a try of each share, 0.952 at least.
///
/// The default budget of 16 tries a share, for all together, is spent with a probability below 2⁻⁶⁴. One below N is always spent.
///
/// Where one is made for a single draw, the compiler leaves out what its density takes, two thirds of the time, but not as WASM.
///
/// # Examples
/// ```
/// use microwarp::{poly as mw, rejection::Rejection};
/// use rand_pcg::Pcg32;
/// let loaded_die = mw::Dirichlet::new([4.0, 2.0, 0.5])?; // 3, 1 and −½ throws, each with one more by the prior
/// let shares = loaded_die.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!((shares.iter().sum::<f32>() - 1.0).abs() < 1e-6);
/// assert!(loaded_die.pdf(shares) > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # See also
/// - [`Beta`](super::Beta): two shares.
/// - [`warp::Simplex`](crate::warp::Simplex): all shapes 1, by a fixed number of uniforms and with an inverse.
///
/// # Source
/// L. Devroye, "Non-Uniform Random Variate Generation", 1986, <https://doi.org/10.1007/978-1-4613-8643-8>. The forms of the
/// logarithms and of the density are this crate's own.
#[doc(alias = "simplex")]
#[doc(alias = "compositional")]
#[doc(alias = "multinomial")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Dirichlet<T, const N: usize> {
    tries: [Tries; N],
    /// The sum of the shapes, and its rounding error.
    total: (f32, f32),
    peak: Scaled,
    budget: u32,
    tier: PhantomData<T>,
}

/// The product of the peaks of all shapes.
#[allow(clippy::inline_always, reason = "what is not used is not computed")]
#[cfg_attr(not(target_family = "wasm"), inline(always))]
const fn peaks(mut shapes: &[f32]) -> Scaled {
    let mut product = Scaled::ONE;
    while let [shape, others @ ..] = shapes {
        product = product.times(peak(*shape));
        shapes = others;
    }
    product
}

impl<T: Tier, const N: usize> Dirichlet<T, N> {
    /// The default budget. A true random generator spends it with a probability below 2⁻⁶⁴.
    #[expect(clippy::cast_possible_truncation, reason = "shares are few")]
    pub const BUDGET: u32 = 16_u32.saturating_mul(N as u32);

    with_budget!(const);

    /// Dirichlet with these shapes, each over their sum the mean of its share.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::OutOfRange`] for a shape
    /// below 1e-30 or above 1e6.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub const fn new(shapes: [f32; N]) -> Result<Self, Error> {
        const { assert!(N > 0, "a whole has a share") };
        let mut tries = [Tries::NONE; N];
        let mut total = (0.0, 0.0);
        let (mut to, mut from): (&mut [Tries], &[f32]) = (&mut tries, &shapes);
        while let ([slot, others @ ..], [shape, more @ ..]) = (to, from) {
            *slot = tried!(Tries::new(*shape));
            let (near, dropped) = two_sum(total.0, *shape);
            total = (near, total.1 + dropped);
            (to, from) = (others, more);
        }
        Ok(Self {
            tries,
            total,
            peak: peaks(&shapes).over(peak(total.0)),
            budget: Self::BUDGET,
            tier: PhantomData,
        })
    }

    /// The shapes.
    #[must_use]
    pub fn shapes(&self) -> [f32; N] {
        self.tries.map(|tries| tries.shape())
    }

    /// The density at these shares. It is never 0 at drawn ones, up to N = 16384; beyond, what `f32` rounds of their sum may be
    /// more than the largest share.
    #[must_use]
    pub fn pdf(&self, shares: [f32; N]) -> f32 {
        let shapes = self.tries.iter().map(Tries::shape);
        of_shares(shares, shapes, self.total, self.peak)
    }

    /// The shares of these parts.
    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn shared(parts: [Part; N]) -> [f32; N] {
        let mut values = parts.map(|part| part.times(1.0));
        if values.iter().any(|value| *value < LEAST) {
            values = parts.map(Part::ln::<T>);
            let largest = values.iter().fold(f32::MIN, |most, x| most.max(*x));
            values = values.map(|value| T::exp(value - largest));
        }
        let sum = values.iter().sum::<f32>();
        values.map(|value| above_zero(value / sum))
    }
}

impl<T: Tier, const N: usize> Rejection for Dirichlet<T, N> {
    type Point = [f32; N];

    #[inline]
    fn budget(&self) -> u32 {
        self.budget
    }

    #[inline]
    fn try_once<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Option<[f32; N]>, Failure<R::Error>> {
        let mut parts = [Part::of(0.0); N];
        for (slot, tries) in parts.iter_mut().zip(&self.tries) {
            let word = || rng.try_next_u32().map_err(Failure::Generator);
            match tries.attempt::<T, _>(word)? {
                Some(part) => *slot = part,
                None => return Ok(None),
            }
        }
        Ok(Some(Self::shared(parts)))
    }

    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_draw<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<[f32; N]>, Failure<R::Error>> {
        let (mut parts, mut count) = ([Part::of(0.0); N], 0_u32);
        for (slot, tries) in parts.iter_mut().zip(&self.tries) {
            *slot = loop {
                if count >= self.budget {
                    return Err(Failure::BudgetSpent { tries: self.budget });
                }
                count = count.wrapping_add(1);
                let word = || rng.try_next_u32().map_err(Failure::Generator);
                if let Some(part) = tries.attempt::<T, _>(word)? {
                    break part;
                }
            };
        }
        Ok(Accepted {
            point: Self::shared(parts),
            tries: count,
        })
    }
}
