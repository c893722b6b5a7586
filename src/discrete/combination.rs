//! Reservoirs of several places or times together, without bias.

use super::light_reservoir::{LightReservoir, weighed};
use super::total::Total;
use super::word::Word as _;
use crate::uniform::infallible;
use rand_core::{Rng, TryRng};

/// By what [`LightReservoir::combine`] makes up for items that some sources cannot hold.
///
/// Each is unbiased. The number of all candidates is not where a source is blind to an item that another one holds: the picture
/// darkens there. Nor is the number of candidates of those sources that happen to hold something.
///
/// # Source
/// B. Bitterli and others, 2020, as for [`LightReservoir`]; D. Lin, M. Kettunen, B. Bitterli, J. Pantaleoni, C. Yuksel,
/// C. Wyman, "Generalized Resampled Importance Sampling", ACM Transactions on Graphics 41(4), 2022:
/// <https://doi.org/10.1145/3528223.3530158>.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Normaliser {
    /// The candidates of the sources that could hold what was chosen. Two targets a source; noisy where the targets differ.
    Support,
    /// The balance heuristic over all sources, with the least noise. For n sources n targets each.
    Balance,
    /// The balance heuristic of each source with the one of this place. Some three targets a source, for nearly the noise of
    /// `Balance`, which it is where this place has no candidates.
    Pairwise,
}

impl<T: Clone> LightReservoir<T> {
    /// One reservoir of the candidates of several places or times, for the place of the source `here`. Draws two `u32` a source.
    ///
    /// `target(k, item)` is the target of the source k at an item. NaN and what is below 0 count as 0, infinity as the largest `f32`. The
    /// place may have no source: then `here` is an index of its own, and every item with a positive target here must
    /// have one in a source. Counts are first capped so that their sum fits, at 2²⁹ − 1 or more for up to seven sources.
    ///
    /// # Examples
    /// Of two places the second is blind to lamp 0. The estimate is of the light that both lamps send to the first, which is 5:
    /// ```
    /// use microwarp::discrete::{LightReservoir, Normaliser};
    /// use microwarp::uniform::up_to;
    /// use rand_pcg::Pcg32;
    /// let targets = |place: usize, &lamp: &usize| [[2.0, 3.0], [0.0, 1.0]][place][lamp];
    /// let (mut rng, mut sum) = (Pcg32::new(42, 54), 0.0);
    /// for _ in 0..10_000 {
    ///     let mut sources = [LightReservoir::new(); 2];
    ///     for (place, source) in sources.iter_mut().enumerate() {
    ///         let lamp = up_to(1, &mut rng) as usize;
    ///         source.offer(lamp, targets(place, &lamp), 0.5, &mut rng)?;
    ///     }
    ///     let both = LightReservoir::combine(&sources, 0, Normaliser::Balance, targets, &mut rng);
    ///     sum += both.target() * both.contribution();
    /// }
    /// assert!((sum / 10_000.0 - 5.0_f32).abs() < 0.1);
    /// # Ok::<(), microwarp::Error>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn combine<R: Rng + ?Sized>(
        sources: &[Self],
        here: usize,
        by: Normaliser,
        target: impl FnMut(usize, &T) -> f32,
        rng: &mut R,
    ) -> Self {
        infallible(Self::try_combine(sources, here, by, target, rng))
    }

    /// One reservoir of several places or times, with a generator that can fail. Draws two `u32` a source.
    ///
    /// # Errors
    /// The generator's own error.
    pub fn try_combine<R: TryRng + ?Sized>(
        sources: &[Self],
        here: usize,
        by: Normaliser,
        mut target: impl FnMut(usize, &T) -> f32,
        rng: &mut R,
    ) -> Result<Self, R::Error> {
        let mut target = |place, item: &T| limited(target(place, item));
        let room = u32::MAX
            .checked_shr(usize::BITS.wrapping_sub(sources.len().leading_zeros()))
            .unwrap_or(0);
        let counts = || sources.iter().map(|source| source.count().min(room));
        let all = counts().fold(0, u32::wrapping_add);
        let own = counts().nth(here).unwrap_or(0);
        let mut whole = Self::new();
        for (k, source) in sources.iter().enumerate() {
            let bits = u64::try_draw(rng)?;
            let mut source = source.clone();
            source.cap(room);
            let Some(item) = source.item() else {
                whole.absorb_share(source, 0.0, Total::ZERO, bits);
                continue;
            };
            let target_here = target(here, item);
            let mut target = |place| {
                if place == here {
                    target_here
                } else {
                    target(place, item)
                }
            };
            let share = if target_here == 0.0 || matches!(by, Normaliser::Support) {
                Total::ONE
            } else if matches!(by, Normaliser::Balance) || own == 0 {
                let (mut ours, mut sum) = (Total::ZERO, Total::ZERO);
                for (place, count) in counts().enumerate() {
                    let there = target(place);
                    sum = sum.plus(weighed(count, there));
                    if place == k {
                        ours = weighed(all, there);
                    }
                }
                ours.part(sum)
            } else {
                // Each other place is weighed against this one as if it had the candidates of all.
                let others = all.wrapping_sub(own);
                let this = weighed(own, target_here);
                if k == here {
                    let mut sum = Total::of_count(own);
                    for (place, count) in counts().enumerate().filter(|(place, _)| *place != here) {
                        let there = weighed(others, target(place));
                        sum = sum.plus(Total::of_count(count).times(this.part(this.plus(there))));
                    }
                    sum.part(Total::of_count(own))
                } else {
                    let there = weighed(others, target(k));
                    there.part(this.plus(there))
                }
            };
            whole.absorb_share(source, target_here, share, bits);
        }
        if let (Normaliser::Support, Some(item)) = (by, whole.item()) {
            let could = counts().enumerate().filter(|(k, _)| target(*k, item) > 0.0);
            let could = could.fold(0, |sum: u32, (_, count)| sum.wrapping_add(count));
            whole.normalise(could);
        }
        Ok(whole)
    }
}

/// A target as a finite number from 0 up.
fn limited(target: f32) -> f32 {
    if target > 0.0 {
        target.min(f32::MAX)
    } else {
        0.0
    }
}
