//! The beta distribution.

use super::gamma_tries::is_shape;
use super::{Accepted, Dirichlet, Failure, Rejection};
use crate::error::{Error, tried};
use crate::tier::Tier;
use rand_core::TryRng;

/// Beta with two shapes a and b: a share of a whole and its rest, such as a probability after a − 1 successes and b − 1 failures.
///
/// Both x and 1 − x are given, each with digits of its own: 1 − x of a share near 1 cannot be had from x. It is the
/// [`Dirichlet`] distribution of two shares.
///
/// # Density
/// xᵃ⁻¹(1 − x)ᵇ⁻¹Γ(a + b)/(Γ(a)Γ(b)), where neither share is negative and their sum is 1 to rounding; else 0. The smaller of
/// the two decides, and 0 counts as 2⁻¹⁴⁹. What `f32` does not hold becomes 2⁻¹⁴⁹ or the largest finite number.
///
/// # Domain
/// - Point: x and 1 − x, above 0.
/// - Words a try: those of two shares, see [`Dirichlet`].
/// - Parameters: two shapes from 1e-30 to 1e6.
/// - No inverse, as of all [rejection](crate::rejection#no-inverse).
///
/// # Accuracy
/// That of [`Dirichlet`].
///
/// # Cost
/// Efficiency: that of a try of each share, 0.952 at least.
///
/// The default budget of 32 tries for both shares together is spent with a probability below 2⁻⁶⁴.
///
/// Where one is made for a single draw, as with odds that change each time, the compiler leaves out what its density takes, but not
/// as WASM.
///
/// # Examples
/// ```
/// use microwarp::{constant, poly as mw, rejection::Rejection};
/// use rand_pcg::Pcg32;
/// const CONVERSION: mw::Beta = constant!(mw::Beta::new(4.0, 98.0)); // 3 of 100 visitors bought
/// let [bought, left] = CONVERSION.draw(&mut Pcg32::new(1, 1))?.point;
/// assert!(bought > 0.0 && bought < 0.2 && left > 0.8);
/// assert!(CONVERSION.pdf([bought, left]) > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # See also
/// - [`Dirichlet`]: more shares than two.
/// - [`warp::Power`](crate::warp::Power): shape b of 1, by one uniform and with an inverse.
///
/// # Source
/// That of [`Dirichlet`].
#[doc(alias = "proportion")]
#[doc(alias = "thompson_sampling")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Beta<T> {
    shares: Dirichlet<T, 2>,
}

impl<T: Tier> Beta<T> {
    /// The default budget. A true random generator spends it with a probability below 2⁻⁶⁴.
    pub const BUDGET: u32 = Dirichlet::<T, 2>::BUDGET;

    /// Beta with these shapes; its mean is a/(a + b).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for NaN or infinity, [`Error::NotPositive`] for 0 or less, [`Error::OutOfRange`] for a shape
    /// below 1e-30 or above 1e6.
    #[allow(clippy::inline_always, reason = "what is not used is not computed")]
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub const fn new(a: f32, b: f32) -> Result<Self, Error> {
        // Both are one parameter there.
        let place = if is_shape(a) { 1 } else { 0 };
        let shares = tried!(Dirichlet::new([a, b]), at place);
        Ok(Self { shares })
    }

    /// The same sampler with at most `budget` tries a point; one of 1 is always spent.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a budget of 0.
    pub const fn with_budget(self, budget: u32) -> Result<Self, Error> {
        let shares = tried!(self.shares.with_budget(budget));
        Ok(Self { shares })
    }

    /// The two shapes.
    #[must_use]
    pub fn shapes(&self) -> [f32; 2] {
        self.shares.shapes()
    }

    /// The density at x, given with 1 − x. It is never 0 at a drawn point.
    #[must_use]
    pub fn pdf(&self, shares: [f32; 2]) -> f32 {
        self.shares.pdf(shares)
    }
}

impl<T: Tier> Rejection for Beta<T> {
    type Point = [f32; 2];

    #[inline]
    fn budget(&self) -> u32 {
        self.shares.budget()
    }

    #[inline]
    fn try_once<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Option<[f32; 2]>, Failure<R::Error>> {
        self.shares.try_once(rng)
    }

    #[allow(clippy::inline_always, reason = "breaks a false dependency")]
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn try_draw<R: TryRng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Result<Accepted<[f32; 2]>, Failure<R::Error>> {
        self.shares.try_draw(rng)
    }
}
