//! Resampled importance sampling in constant memory: one light of many candidates.

use super::total::Total;
use super::word::Word as _;
use crate::error::{Error, finite, positive};
use crate::num::{Long, Scaled};
use crate::uniform::infallible;
use rand_core::{Rng, TryRng};

/// Resampled importance sampling of a stream of candidates: holds one of them, chosen nearly in proportion to a target
/// that need not be normalised, such as the light that a lamp would send here if nothing stood between.
///
/// The estimate of a sum of f over all items is f(item)·[`contribution`](Self::contribution), unbiased for every number
/// of candidates if the target is positive wherever f is not 0. Only this one item is traced to.
///
/// In a hall of 1,000 lamps a shadow ray by eight candidates, drawn by power, stands for 15, at equal error, of those
/// to lamps chosen uniformly.
///
/// # Domain
/// - Targets: finite `f32`, zero or positive. A candidate of target 0 is never held, but it counts.
/// - Densities, those by which the candidates were drawn: positive finite `f32`; for a table its pmf.
/// - Uniforms: one of 64 bits a decision, which is two `u32` of the generator, whatever the candidate.
/// - Candidates: any number. Where a count would leave `u32`, what is counted is first capped at 2³¹ − 1.
///
/// # Accuracy
/// - The quotient of target and density is rounded once, to 2⁻²⁴ of itself, and neither overflows nor vanishes. Sums have
///   64 bits, after any number of candidates. A decision is off by less than 2⁻⁶³, and one of positive weight is always
///   possible.
/// - `contribution` is correctly rounded from the sum, unless it is subnormal; it is finite, and not 0 while an item is held.
/// - The shares of [`combine`](Self::combine) are off by less than 3e-7 of themselves.
///
/// # Cost
/// Memory of one item and 28 bytes, rounded up to the alignment of an item and of 8, each. An offer takes a division of `f32` and two 128-bit products.
///
/// # Examples
/// One of a thousand lamps, by eight candidates from a table of their powers:
/// ```
/// use microwarp::discrete::{Cdf, LightReservoir};
/// use rand_pcg::Pcg32;
/// let powers: [f32; 1000] = std::array::from_fn(|k| 1.0 + (k % 7) as f32);
/// let unshadowed = |k: usize| powers[k] / (1.0 + k as f32);
/// let by_power = Cdf::<[u32; 1000]>::new(&powers)?;
/// let mut rng = Pcg32::new(42, 54);
/// let mut held = LightReservoir::new();
/// for _ in 0..8 {
///     let lamp = by_power.draw(&mut rng);
///     held.offer(lamp.index, unshadowed(lamp.index), lamp.pmf, &mut rng)?;
/// }
/// // One shadow ray goes to this lamp.
/// let light = held.item().map_or(0.0, |&lamp| unshadowed(lamp) * held.contribution());
/// assert!(light > 0.0 && held.count() == 8);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
/// - [`Reservoir`](super::Reservoir): a stream whose weights are the law itself.
/// - [`select_once`](super::select_once): all lamps weighed, in one pass.
///
/// # Source
/// J. Talbot, D. Cline, P. Egbert, "Importance Resampling for Global Illumination", 2005,
/// <https://doi.org/10.2312/EGWR/EGSR05/139-146>; B. Bitterli, C. Wyman, M. Pharr, P. Shirley, A. Lefohn, W. Jarosz,
/// "Spatiotemporal Reservoir Resampling for Real-Time Ray Tracing with Dynamic Direct Lighting", ACM Transactions on
/// Graphics 39(4), 2020: <https://doi.org/10.1145/3386569.3392481>.
#[doc(alias = "importance_resampling")]
#[doc(alias = "many_lights")]
#[doc(alias = "merge")]
#[doc(alias = "restir")]
#[doc(alias = "ris")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LightReservoir<T> {
    /// The item with its target, which is positive.
    held: Option<(T, f32)>,
    /// Of target/density, so that it is the contribution times the target and the count.
    sum: Total,
    count: u32,
}

/// To what counts are capped where their sum would not fit.
const HALF: u32 = u32::MAX >> 1;

impl<T> Default for LightReservoir<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T> LightReservoir<T> {
    /// An empty reservoir.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            held: None,
            sum: Total::ZERO,
            count: 0,
        }
    }

    /// Offers a candidate with a uniform of 64 bits. Returns whether the reservoir took it.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for either number, [`Error::Negative`] for the target, [`Error::NotPositive`] for the density. The reservoir
    /// is unchanged after an error, and has not counted the candidate.
    pub fn offer_with(
        &mut self,
        item: T,
        target: f32,
        density: f32,
        bits: u64,
    ) -> Result<bool, Error> {
        finite(target, 1)?;
        if target < 0.0 {
            return Err(Error::Negative(1));
        }
        positive(density, 2)?;
        if self.count == u32::MAX {
            self.cap(HALF);
        }
        self.count = self.count.wrapping_add(1);
        if target == 0.0 {
            return Ok(false);
        }
        let weight = Total::of_scaled(Scaled::of(target).over(Scaled::of(density)));
        Ok(self.take(item, target, weight, bits))
    }

    /// Offers a candidate. Returns whether the reservoir took it. Draws two `u32`.
    ///
    /// # Errors
    /// Those of [`LightReservoir::offer_with`]; the two `u32` have been drawn all the same.
    #[inline]
    pub fn offer<R: Rng + ?Sized>(
        &mut self,
        item: T,
        target: f32,
        density: f32,
        rng: &mut R,
    ) -> Result<bool, Error> {
        infallible(self.try_offer(item, target, density, rng))
    }

    /// Offers a candidate, with a generator that can fail. Draws two `u32`.
    ///
    /// # Errors
    /// The outer error is the generator's, the inner one that of [`LightReservoir::offer_with`]. The reservoir is
    /// unchanged after either.
    #[inline]
    pub fn try_offer<R: TryRng + ?Sized>(
        &mut self,
        item: T,
        target: f32,
        density: f32,
        rng: &mut R,
    ) -> Result<Result<bool, Error>, R::Error> {
        let bits = u64::try_draw(rng)?;
        Ok(self.offer_with(item, target, density, bits))
    }

    /// Merges the reservoir of another place, or of another time, with a uniform of 64 bits. Returns whether its item was taken.
    ///
    /// `target` is that of its item **here**, anew. For a part of one stream with one target it is the item's own
    /// [`target`](Self::target), and then the merger is exact. Elsewhere the contribution is unbiased only if the items of both have
    /// positive targets in both; [`combine`](Self::combine) is, in any case.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Negative`] for the target. The reservoir is unchanged after an error.
    pub fn absorb_with(&mut self, other: Self, target: f32, bits: u64) -> Result<bool, Error> {
        Total::of(target, 1)?;
        Ok(self.absorb_share(other, target, Total::ONE, bits))
    }

    /// Merges the reservoir of another place, or of another time, as [`absorb_with`](Self::absorb_with) does. Draws two `u32`.
    ///
    /// # Errors
    /// Those of [`LightReservoir::absorb_with`]; the two `u32` have been drawn all the same.
    #[inline]
    pub fn absorb<R: Rng + ?Sized>(
        &mut self,
        other: Self,
        target: f32,
        rng: &mut R,
    ) -> Result<bool, Error> {
        infallible(self.try_absorb(other, target, rng))
    }

    /// Merges the reservoir of another place, or of another time, with a generator that can fail. Draws two `u32`.
    ///
    /// # Errors
    /// The outer error is the generator's, the inner one that of [`LightReservoir::absorb_with`]. The reservoir is
    /// unchanged after either.
    #[inline]
    pub fn try_absorb<R: TryRng + ?Sized>(
        &mut self,
        other: Self,
        target: f32,
        rng: &mut R,
    ) -> Result<Result<bool, Error>, R::Error> {
        let bits = u64::try_draw(rng)?;
        Ok(self.absorb_with(other, target, bits))
    }

    /// Merges a reservoir whose item has this target here, and this share in place of that of its candidates.
    pub(super) fn absorb_share(
        &mut self,
        mut other: Self,
        target: f32,
        share: Total,
        bits: u64,
    ) -> bool {
        self.count_with(&mut other);
        match other.held {
            Some((item, own)) if target > 0.0 && !share.is_zero() => {
                let here = Scaled::of(target).over(Scaled::of(own));
                let mass = other.sum.times(Total::of_scaled(here));
                let mass = if share == Total::ONE {
                    mass
                } else {
                    mass.times(share)
                };
                self.take(item, target, mass, bits)
            }
            _ => false,
        }
    }

    /// Counts the candidates of another reservoir. Where the sum would not fit, both are capped.
    fn count_with(&mut self, other: &mut Self) {
        if self.count.checked_add(other.count).is_none() {
            self.cap(HALF);
            other.cap(HALF);
        }
        self.count = self.count.wrapping_add(other.count);
    }

    fn take(&mut self, item: T, target: f32, mass: Total, bits: u64) -> bool {
        let taken = self.sum.grow(mass, bits);
        if taken {
            self.held = Some((item, target));
        }
        taken
    }

    /// Lets the reservoir count for no more than so many candidates when it is merged, so that what is new outweighs an
    /// old history. Its contribution stays. 0 empties it.
    pub fn cap(&mut self, limit: u32) {
        if self.count > limit {
            self.rescale(limit, self.count);
            self.count = limit;
        }
    }

    /// Divides by so many candidates in place of [`count`](Self::count), which stays: by those, for instance, of the
    /// sources that could hold this item. Once, after all mergers: a second call divides again. 0 lets go of the item.
    pub fn normalise(&mut self, candidates: u32) {
        if self.count > 0 {
            self.rescale(self.count, candidates);
        }
    }

    /// Multiplies the sum by a quotient, and lets go of the item where one number is 0.
    fn rescale(&mut self, by: u32, over: u32) {
        if by == 0 || over == 0 {
            (self.held, self.sum) = (None, Total::ZERO);
        } else if by != over {
            let [by, over] = [by, over].map(|n| Long::of(n.into(), 64));
            self.sum = self.sum.times(Total::of_long(by.over(over)));
        }
    }

    /// The item held; `None` before the first of positive target.
    #[must_use]
    pub const fn item(&self) -> Option<&T> {
        match &self.held {
            Some((item, _)) => Some(item),
            None => None,
        }
    }

    /// The target of the item held, by which it was chosen; 0 while nothing is held.
    #[must_use]
    pub const fn target(&self) -> f32 {
        match self.held {
            Some((_, target)) => target,
            None => 0.0,
        }
    }

    /// How many candidates were offered, those of target 0 among them.
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// By what to multiply f of the item held, in place of 1/density: the sum of the weights over target and count. 0
    /// while nothing is held, positive and finite afterwards.
    #[must_use]
    pub fn contribution(&self) -> f32 {
        match self.held {
            Some((_, target)) => self.sum.over(weighed(self.count, target)),
            None => 0.0,
        }
    }
}

/// A target times a number of candidates.
pub(super) fn weighed(count: u32, target: f32) -> Total {
    match Total::of(target, 0) {
        Ok(target) => Total::of_count(count).times(target),
        Err(_) => Total::ZERO,
    }
}
