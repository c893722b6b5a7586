//! Autocorrelation along a chain, its integrated time, and the effective sample size.

use crate::estimate::{Scale, Sum, Tally};
use crate::tier::sqrt;

/// The autocorrelation of a number along a chain, with the integrated autocorrelation time and the effective sample size.
///
/// After each step, push a number that depends on the state: a coordinate, an indicator, the logarithm of the density.
/// Different functions of one chain can have different times.
///
/// # Domain
///
/// Any finite numbers. NaN and infinite ones are refused and counted. Autocorrelations lie in [−1, 1]; unknown results are
/// [`None`]. If correlation outlasts the lags, the time is [`None`]: push, say, every 10th state, and multiply by 10.
///
/// # Accuracy
///
/// The stated errors are the largest found, plus a tenth.
///
/// - Error of an autocorrelation: 4.4e-7, in short runs, where a rounding weighs most; with a margin of 1.3.
/// - Error in long runs: 9.7e-8, in one of 10⁸ numbers whose mean is 1000 standard deviations, and in runs of 3·10⁶ at up
///   to 10⁶.
///
/// # Cost
///
/// Memory: 16 bytes per lag and 40 more. A push takes a few operations per lag, and about seven times as many when the
/// count reaches a power of two.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{BoxStep, Chain, Autocorrelation};
/// use rand_pcg::Pcg32;
/// let f = |x: f32| 1.0 / (1.0 + x.powi(4));
/// let (mut chain, mut rng) = (Chain::new(0.0, f)?, Pcg32::new(1, 1));
/// let (step, mut health) = (BoxStep::new(4.0)?, Autocorrelation::<64>::new());
/// for _ in 0..10_000 {
///     health.push(chain.step(f, &step, &mut rng).state());
/// }
/// let time = health.integrated_time().ok_or(microwarp::Error::OutOfRange(0))?;
/// assert!(time > 2.0 && time < 20.0);
/// # Ok::<(), microwarp::Error>(())
/// ```
///
/// # See also
///
/// - [`split_r_hat`](super::split_r_hat()), which compares several runs, and [`Draws`](super::Draws), which keeps them.
///
/// # Source
///
/// C. J. Geyer, "Practical Markov Chain Monte Carlo", 1992,
/// [doi:10.1214/ss/1177011137](https://doi.org/10.1214/ss/1177011137).
#[doc(alias = "acf")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Autocorrelation<const LAGS: usize> {
    tally: Tally,
    scale: Scale,
    /// A number near the mean; this and all that follows is on the scale.
    centre: f32,
    /// The first numbers, in order.
    first: [f32; LAGS],
    /// The last ones, the latest first.
    last: [f32; LAGS],
    /// The sum of the differences from the centre.
    sum: Sum,
    /// The sum of their squares.
    squares: Sum,
    /// The sums of their products with the difference one step before, two steps, and so on.
    products: [Sum; LAGS],
}

impl<const LAGS: usize> Default for Autocorrelation<LAGS> {
    #[inline]
    fn default() -> Self {
        Self::new()
    }
}

impl<const LAGS: usize> Autocorrelation<LAGS> {
    /// No numbers yet.
    #[must_use]
    #[inline]
    pub const fn new() -> Self {
        Self {
            tally: Tally::NOTHING,
            scale: Scale::FINEST,
            centre: 0.0,
            first: [0.0; LAGS],
            last: [0.0; LAGS],
            sum: Sum::ZERO,
            squares: Sum::ZERO,
            products: [Sum::ZERO; LAGS],
        }
    }

    /// Takes in the number of one step; refuses NaN and infinity.
    #[inline]
    pub fn push(&mut self, x: f32) {
        let before = self.count();
        if !self.tally.admits(x.is_finite()) {
            return;
        }
        if !self.scale.holds(x) {
            self.rescale(Scale::of(x));
        }
        let x = self.scale.apply(x);
        if before == 0 {
            self.centre = x;
        }
        let centre = self.centre;
        let difference = x - centre;
        self.sum = self.sum.plus(difference);
        self.squares = self.squares.plus(difference * difference);
        let mut moved = x;
        let lags = self.last.iter_mut().zip(&mut self.products);
        for (slot, product) in lags.take(as_lags(before)) {
            *product = product.plus(difference * (*slot - centre));
            core::mem::swap(slot, &mut moved);
        }
        // While `last` is not full, the earliest number moves to the next free place.
        if let Some(slot) = self.last.get_mut(as_lags(before)) {
            *slot = moved;
        }
        if let Some(slot) = self.first.get_mut(as_lags(before)) {
            *slot = x;
        }
        if self.count().is_power_of_two() {
            self.recentre();
        }
    }

    /// How many numbers were taken in.
    #[must_use]
    #[inline]
    pub const fn count(&self) -> u64 {
        self.tally.count()
    }

    /// How many numbers were refused because they were NaN or infinite.
    #[must_use]
    #[inline]
    pub const fn refused(&self) -> u64 {
        self.tally.refused()
    }

    /// The autocorrelation at a lag from 0, where it is 1, to LAGS.
    ///
    /// It is the mean product of differences from the mean, `lag` steps apart, over the variance; both sums are divided by
    /// the same count. [`None`] beyond the lags, with fewer than `lag` + 1 numbers, and if all numbers are equal.
    #[must_use]
    pub fn at_lag(&self, lag: usize) -> Option<f32> {
        self.autocorrelations()?.nth(lag)
    }

    /// The integrated autocorrelation time, 1 + 2Σρₖ: how many steps are worth one independent sample.
    ///
    /// This is the initial monotone sequence estimator. The sum ends at the first pair ρ₂ₘ + ρ₂ₘ₊₁ that is not positive, and
    /// each pair counts at most as much as the one before. (The true pairs of a reversible chain, which one mutation or a
    /// mixture makes, are positive and decrease.) It takes at least 3 lags, and an odd number uses them all. The result is at
    /// least 1/⌊log₂ n⌋.
    ///
    /// [`None`] if the lags are too few (the autocorrelation at the largest lag is then still positive), and if no
    /// autocorrelation is known.
    #[must_use]
    pub fn integrated_time(&self) -> Option<f32> {
        let mut time = -1.0;
        let mut before = f32::MAX;
        let mut autocorrelations = self.autocorrelations()?;
        loop {
            let pair = autocorrelations.next()? + autocorrelations.next()?;
            if pair <= 0.0 {
                break;
            }
            before = if pair < before { pair } else { before };
            time += 2.0 * before;
        }
        let log2 = 63_u32.saturating_sub(self.count().leading_zeros());
        let least = 1.0 / log2.max(1) as f32;
        Some(if time > least { time } else { least })
    }

    /// The effective sample size: how many independent samples would estimate the mean with the same error.
    ///
    /// [`None`] if [`Autocorrelation::integrated_time`] is.
    #[must_use]
    pub fn effective_sample_size(&self) -> Option<f32> {
        Some(self.count() as f32 / self.integrated_time()?)
    }

    /// The standard error of the mean: the standard deviation over the root of the effective sample size.
    ///
    /// [`None`] if [`Autocorrelation::integrated_time`] is.
    #[doc(alias = "mcse")]
    #[must_use]
    pub fn standard_error(&self) -> Option<f32> {
        let size = self.effective_sample_size()?;
        let count = self.count() as f32;
        let squares = self.about(self.sum.value() / count).next()?.value();
        Some(self.scale.undo(sqrt(squares / (count - 1.0) / size)))
    }

    /// The autocorrelations from lag 0 on, as far as they are known.
    fn autocorrelations(&self) -> Option<impl Iterator<Item = f32>> {
        let to_mean = self.sum.value() / self.count() as f32;
        let variance = self.about(to_mean).next()?.value();
        let of_variance = move |sum: Sum| (sum.value() / variance).clamp(-1.0, 1.0);
        (variance > 0.0).then(|| self.about(to_mean).map(of_variance))
    }

    /// The sums of products from lag 0 on, about a centre farther up by `step`; as far as numbers are that many steps apart.
    fn about(&self, step: f32) -> impl Iterator<Item = Sum> {
        let mut moving = self.moving(step);
        let sums = [&self.squares].into_iter().chain(&self.products);
        sums.zip(farther(&self.first, &self.last))
            .take(as_lags(self.count()))
            .map(move |(sum, ends)| moving.next(*sum, ends))
    }

    fn moving(&self, step: f32) -> Moving {
        Moving {
            centre: self.centre,
            step,
            sum: self.sum,
            ends: Sum::ZERO,
            pairs: self.count(),
        }
    }

    /// Moves the centre to the mean.
    #[cold]
    fn recentre(&mut self) {
        // Far from 0 the centre is rounded, so this step may differ from the one to the mean.
        let centre = self.centre + self.sum.value() / self.count() as f32;
        let step = centre - self.centre;
        let mut moving = self.moving(step);
        let sums = [&mut self.squares].into_iter().chain(&mut self.products);
        for (sum, ends) in sums.zip(farther(&self.first, &self.last)) {
            // A lag beyond the count has no products, whatever the centre.
            *sum = if moving.pairs > 0 {
                moving.next(*sum, ends)
            } else {
                Sum::ZERO
            };
        }
        self.sum = self.sum.plus_multiple(Sum::of_count(self.count()), -step);
        self.centre = centre;
    }

    #[cold]
    fn rescale(&mut self, coarser: Scale) {
        let factor = self.scale.shrinking_to(coarser);
        self.scale = coarser;
        self.centre *= factor;
        for x in self.first.iter_mut().chain(&mut self.last) {
            *x *= factor;
        }
        self.sum = self.sum.scaled(factor);
        for sum in self.products.iter_mut().chain([&mut self.squares]) {
            *sum = sum.scaled(factor).scaled(factor);
        }
    }
}

/// Moves sums of products to another centre, lag by lag from 0 on.
struct Moving {
    centre: f32,
    step: f32,
    /// The sum of all differences from the centre.
    sum: Sum,
    /// The sum of the differences of the first numbers, as many as the lag, and of the last.
    ends: Sum,
    /// How many pairs of numbers are the lag apart.
    pairs: u64,
}

impl Moving {
    /// The sum at this lag; `ends` is what one more lag leaves out at either end.
    #[inline]
    fn next(&mut self, products: Sum, ends: Option<(&f32, &f32)>) -> Sum {
        // Σ(d − s)(d′ − s) = Σdd′ − s(Σd + Σd′) + (n − k)s². Both sums are over all but the first or the last k.
        let moved = products
            .plus_multiple(self.sum, -2.0 * self.step)
            .plus(self.step * self.ends.value())
            .plus(self.pairs as f32 * self.step * self.step);
        if let Some((first, last)) = ends {
            self.ends = self.ends.plus(first - self.centre).plus(last - self.centre);
        }
        self.pairs = self.pairs.saturating_sub(1);
        moved
    }
}

/// The numbers at both ends, in the order in which greater lags leave them out; [`None`] beyond the last lag.
#[inline]
fn farther<'a>(
    first: &'a [f32],
    last: &'a [f32],
) -> impl Iterator<Item = Option<(&'a f32, &'a f32)>> {
    first.iter().zip(last).map(Some).chain([None])
}

/// A count of numbers, where only those up to the lags matter.
#[inline]
fn as_lags(count: u64) -> usize {
    count.try_into().unwrap_or(usize::MAX)
}
