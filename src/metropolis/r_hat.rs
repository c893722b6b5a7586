//! R̂, the potential scale reduction: whether chains agree.

use crate::estimate::Moments;
use crate::tier::sqrt;

/// A run in two halves, for [`split_r_hat`].
///
/// Memory is fixed, so you state beforehand how long a half is.
///
/// # Examples
///
/// ```
/// use microwarp::metropolis::{Chain, Halves, UniformStep, split_r_hat};
/// use rand_pcg::Pcg32;
/// let f = |x: f32| 1.0 + x;
/// let mut runs = [Halves::new(5000); 2];
/// for (seed, run) in (0..).zip(&mut runs) {
///     let (mut chain, mut rng) = (Chain::new(0.5, f)?, Pcg32::new(seed, 1));
///     for _ in 0..10_000 {
///         run.push(chain.step(f, &UniformStep::new(), &mut rng).state());
///     }
/// }
/// assert!(split_r_hat(&runs).is_some_and(|r| r < 1.01));
/// # Ok::<(), microwarp::Error>(())
/// ```
#[doc(alias = "split_chain")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Halves {
    half: u64,
    /// The first half of the run, then the rest.
    parts: [Moments; 2],
}

impl Halves {
    /// A run whose first `half` numbers make the first half.
    #[must_use]
    #[inline]
    pub const fn new(half: u64) -> Self {
        Self {
            half,
            parts: [Moments::new(); 2],
        }
    }

    /// Takes in the number of one step; refuses NaN and infinity.
    #[inline]
    pub fn push(&mut self, x: f32) {
        let [first, second] = &mut self.parts;
        if first.count() < self.half {
            first.push(x);
        } else {
            second.push(x);
        }
    }

    /// How many numbers make the first half.
    #[must_use]
    #[inline]
    pub const fn half(&self) -> u64 {
        self.half
    }

    /// The moments of the first half, and of the numbers after it.
    #[must_use]
    #[inline]
    pub const fn parts(&self) -> &[Moments; 2] {
        &self.parts
    }
}

/// R̂, the potential scale reduction factor of Gelman and Rubin: whether sequences have the same distribution.
///
/// It is the root of (n−1)/n + V/W, where V is the variance of the sequences' means, W the mean of their variances, and n
/// the count of the shortest. It is about 1 if the means differ no more than they should, and larger if each sequence has
/// seen only a part of the distribution.
///
/// # Domain
///
/// R̂ is at least 0; beyond the range of `f32` it is the largest `f32`. [`None`] for fewer than two sequences, for a
/// sequence of fewer than two numbers, and if all numbers are equal.
///
/// # Accuracy
///
/// Found, not proven: 1.3 times the largest error of a search of minutes, in runs of any length and magnitude, subnormal
/// numbers included.
///
/// | error | `f32` | kind |
/// |---|--:|---|
/// | mean up to 10⁶ deviations, relative | 6.4e-7 | found |
///
/// # See also
///
/// - [`split_r_hat`], which also detects a run that drifts.
/// - [`Autocorrelation`](super::Autocorrelation), which judges a single run.
///
/// # Source
///
/// A. Gelman, D. B. Rubin, "Inference from Iterative Simulation Using Multiple Sequences", 1992,
/// [doi:10.1214/ss/1177011136](https://doi.org/10.1214/ss/1177011136).
#[doc(alias = "convergence")]
#[must_use]
pub fn r_hat<'a>(sequences: impl Iterator<Item = &'a Moments> + Clone) -> Option<f32> {
    r_hat_of(sequences.copied())
}

/// The same of moments that are made anew at each of four passes.
pub(super) fn r_hat_of(sequences: impl Iterator<Item = Moments> + Clone) -> Option<f32> {
    // Take means from a common centre: far from 0 they could differ by less than their rounding.
    let first = sequences.clone().next()?;
    let scale = (sequences.clone()).fold(first.scale(), |scale, s| scale.joined(s.scale()));
    let centre = first.centre_on(scale);
    let mut means = Moments::new();
    let (mut shortest, mut largest) = (u64::MAX, 0.0);
    for sequence in sequences.clone() {
        let (mean, std_dev) = sequence.seen_from(scale, centre)?;
        means.push(mean);
        shortest = shortest.min(sequence.count());
        largest = if std_dev > largest { std_dev } else { largest };
    }
    let between = means.std_dev()?;
    if largest == 0.0 {
        return (between > 0.0).then_some(f32::MAX);
    }
    // Scaled to at most 1, so that no square overflows.
    let mut within = Moments::new();
    for sequence in sequences {
        let (_, std_dev) = sequence.seen_from(scale, centre)?;
        let std_dev = std_dev / largest;
        within.push(std_dev * std_dev);
    }
    let ratio = between / largest / sqrt(within.mean()?);
    let count = shortest as f32;
    // Where the square would overflow, the other term does not count.
    let r = if ratio < 1e9 {
        sqrt((count - 1.0) / count + ratio * ratio)
    } else {
        ratio
    };
    Some(if r <= f32::MAX { r } else { f32::MAX })
}

/// Split R̂ of one or more runs: the [`r_hat`] of all their halves. It detects a run that drifts, even a single one.
///
/// A value above 1.01 says that the runs are too short, or that some have not been everywhere. It compares means only:
/// runs with equal means and unequal spreads pass. To see these, push |x − m| to further [`Halves`], for a number m near the
/// median, as the burn-in has shown it. Its domain is that of [`r_hat`].
///
/// # See also
///
/// - [`Draws`](super::Draws), which ranks draws kept in memory, and so serves any distribution.
///
/// # Source
///
/// A. Gelman et al., "Bayesian Data Analysis", 3rd edition, 2013, for the halves; A. Vehtari, A. Gelman, D. Simpson,
/// B. Carpenter, P.-C. Bürkner, "Rank-Normalization, Folding, and Localization: An Improved R̂ for Assessing Convergence of
/// MCMC", 2021, [doi:10.1214/20-BA1221](https://doi.org/10.1214/20-BA1221), for the limit of 1.01.
#[doc(alias = "convergence")]
#[must_use]
pub fn split_r_hat(runs: &[Halves]) -> Option<f32> {
    r_hat(runs.iter().flat_map(Halves::parts))
}
