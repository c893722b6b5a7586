//! Whether chains agree: the potential scale reduction.

use crate::estimate::Moments;
use crate::tier::sqrt;

/// A run in two halves, so that it can be compared with itself too.
///
/// How long a half is has to be said beforehand, since memory is fixed.
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

    /// The moments of the first half, and of what came after.
    #[must_use]
    #[inline]
    pub const fn parts(&self) -> &[Moments; 2] {
        &self.parts
    }
}

/// R̂ of sequences that should have the same distribution: the root of (n−1)/n + V/W, where V is the variance
/// of their means and W the mean of their variances.
///
/// It is about 1 where the means differ by no more than they should, and above where each sequence has seen
/// a part only. n is the count of the shortest.
///
/// - Range: at least 0, and beyond `f32` the largest one. [`None`] below two sequences, below two numbers in
///   one of them, and where no number differs from another.
/// - Errors, the largest found and a tenth: of runs of any magnitude, subnormal ones included.
///
/// | error | `f32` |
/// |---|--:|
/// | mean up to 10⁶ deviations, relative | 3.5e-7 |
///
/// Source: A. Gelman, D. B. Rubin, "Inference from Iterative Simulation Using Multiple Sequences", 1992.
#[must_use]
pub fn r_hat<'a>(sequences: impl Iterator<Item = &'a Moments> + Clone) -> Option<f32> {
    // Means are told apart from a common centre: far from 0 they would differ by less than their rounding.
    let first = sequences.clone().next()?;
    let scale = (sequences.clone()).fold(first.scale(), |scale, s| scale.joined(s.scale()));
    let centre = first.centre_on(scale);
    let mut means = Moments::new();
    let (mut shortest, mut largest) = (u64::MAX, 0.0);
    for sequence in sequences.clone() {
        let (mean, deviation) = sequence.seen_from(scale, centre)?;
        means.push(mean);
        shortest = shortest.min(sequence.count());
        largest = if deviation > largest {
            deviation
        } else {
            largest
        };
    }
    let between = means.std_dev()?;
    if largest == 0.0 {
        return (between > 0.0).then_some(f32::MAX);
    }
    // Deviations of at most 1, so that the largest has a square.
    let mut within = Moments::new();
    for sequence in sequences {
        let (_, deviation) = sequence.seen_from(scale, centre)?;
        let deviation = deviation / largest;
        within.push(deviation * deviation);
    }
    let ratio = between / largest / sqrt(within.mean()?);
    let count = shortest as f32;
    // Where the square would overflow the other term is none.
    let r = if ratio < 1e9 {
        sqrt((count - 1.0) / count + ratio * ratio)
    } else {
        ratio
    };
    Some(if r <= f32::MAX { r } else { f32::MAX })
}

/// Split R̂ of any number of runs, from one: [`r_hat`] of all their halves. A run that drifts is told from
/// one that does not, even alone.
///
/// Values above 1.01 say that the runs are too short, or that they have not all been everywhere.
///
/// - Range: as of [`r_hat`].
///
/// Sources: A. Gelman et al., "Bayesian Data Analysis", 3rd edition, 2013, for the halves; A. Vehtari et al.,
/// "Rank-Normalization, Folding, and Localization: An Improved R̂ for Assessing Convergence of MCMC", 2021,
/// for 1.01.
#[must_use]
pub fn split_r_hat(runs: &[Halves]) -> Option<f32> {
    r_hat(runs.iter().flat_map(Halves::parts))
}
