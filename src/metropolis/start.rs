//! How a chain finds its first state among draws from another sampler.

use super::standing::Standing;
use super::target_density::TargetDensity;
use super::target_value::{TargetValue, Weighing as _};
use super::{Chain, StateSource};
use crate::estimate::Sum;
use crate::num::{Scaled, happens};
use crate::rejection::Failure;
use crate::tier::sqrt;
use core::convert::Infallible;
use rand_core::{Rng, TryRng};

/// A chain without start-up bias, with the weight that removes it. [`Chain::resample`] returns it.
///
/// Of M candidates y with density p, one becomes the first state, with probability in proportion to w = f(y)/p(y). The
/// mean of all w is the run's weight W. For every k and g, the expectation of W g(X) at the state X after k steps is ∫fg.
/// So over many short runs, the mean of W times the mean of g along the run is unbiased from the first step on, and the
/// mean of W alone is ∫f.
///
/// A run without any candidate of positive weight ([`Failure::BudgetSpent`]) counts as 0 in those means.
#[doc(alias = "sampling_importance_resampling")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Start<X, D = f32> {
    /// The chain, at the chosen state.
    pub chain: Chain<X, D>,
    /// The run's weight W: an unbiased estimate of the normalisation ∫f, if p is normalised. It is on the scale of the
    /// density, so a [`LogDensity`](super::LogDensity) gives its logarithm.
    pub weight: D,
    /// The relative standard error of the weight, estimated from the candidates; [`None`] for a single one. If runs without a
    /// start are likely, it is too large for the mean of all runs. If all weights are equal, it may be up to 4e-4/√(M − 1)
    /// instead of 0.
    pub relative_error: Option<f32>,
    /// How many candidates had a positive density.
    pub positive: u32,
}

/// The candidates so far. It holds one of them, each with probability in proportion to its weight.
struct Candidates<X, D> {
    held: Option<(X, D)>,
    /// The largest density so far. Weights are relative to it, since a logarithm may exceed the range of exponents.
    base: Option<D>,
    /// The sum of the weights and the sum of their squares, in units of 2^exponent and of its square.
    sum: Sum,
    squares: Sum,
    exponent: i32,
    positive: u32,
}

impl<X: Copy, D: TargetDensity> Candidates<X, D> {
    const NONE: Self = Self {
        held: None,
        base: None,
        sum: Sum::ZERO,
        squares: Sum::ZERO,
        exponent: i32::MIN,
        positive: 0,
    };

    /// Takes in a candidate of positive density, and holds it if the word says so.
    fn offer(&mut self, state: X, density: D, pdf: f32, word: u32) {
        let base = self.base_with(density);
        let weight = density.quotient(base).over(Scaled::of(pdf));
        let (_, exponent) = weight.parts();
        if exponent > self.exponent {
            let shrunk = Scaled::ONE
                .raised(self.exponent.saturating_sub(exponent))
                .value();
            self.sum = self.sum.scaled(shrunk);
            self.squares = self.squares.scaled(shrunk).scaled(shrunk);
            self.exponent = exponent;
        }
        let weight = self.in_units(weight);
        self.sum = self.sum.plus(weight);
        self.squares = self.squares.plus(weight * weight);
        self.positive = self.positive.saturating_add(1);
        if happens(weight / self.sum.value(), word) {
            self.held = Some((state, density));
        }
    }

    /// The base, after this density has been met.
    fn base_with(&mut self, density: D) -> D {
        match self.base {
            Some(base) if !density.exceeds(base) => return base,
            Some(base) => {
                let (factor, exponent) = base.quotient(density).parts();
                // The factor is from 1 to 2. A base that rises in many steps must not let the sums overflow, so what they
                // grow goes to the exponent; at least one unit is left.
                let (factor, exponent) = if self.sum.value() >= 2.0 {
                    (0.5 * factor, exponent.saturating_add(1))
                } else {
                    (factor, exponent)
                };
                let times = |sum, factor| Sum::ZERO.plus_multiple(sum, factor);
                self.sum = times(self.sum, factor);
                self.squares = times(times(self.squares, factor), factor);
                self.exponent = self.exponent.saturating_add(exponent);
            }
            None => {}
        }
        self.base = Some(density);
        density
    }

    /// At most 2, and 0 if too small to count.
    fn in_units(&self, weight: Scaled) -> f32 {
        weight.raised(self.exponent.saturating_neg()).value()
    }

    fn start(self, candidates: u32) -> Option<Start<X, D>> {
        let ((state, density), base) = (self.held?, self.base?);
        let count = candidates as f32;
        // The sum is positive: the largest weight is at least one unit.
        let weight = Scaled::of(self.sum.value() / count).raised(self.exponent);
        let relative_error = (candidates > 1).then(|| {
            let mean = self.sum.value() / count;
            let spread = self.squares.value() / count / mean / mean - 1.0;
            sqrt(if spread > 0.0 { spread } else { 0.0 } / (count - 1.0))
        });
        Some(Start {
            chain: Chain::at(state, density),
            weight: base.scaled(weight),
            relative_error,
            positive: self.positive,
        })
    }
}

impl<X: Copy, D: TargetValue> Chain<X, D> {
    /// Starts a chain at the first state drawn from `source` whose density is positive, within `budget` draws.
    ///
    /// The density may rarely visit such a start, so let the chain burn in. It takes the words of the draws.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if no state had a positive density, [`Failure::Generator`] if the generator failed.
    #[inline]
    pub fn try_search<S, R>(
        mut target: impl FnMut(X) -> D,
        source: &S,
        budget: u32,
        rng: &mut R,
    ) -> Result<Self, Failure<R::Error>>
    where
        S: StateSource<X>,
        R: TryRng + ?Sized,
    {
        for _ in 0..budget {
            let state = source.try_draw_state(rng).map_err(Failure::Generator)?;
            let density = target(state);
            if density.standing() == Standing::Positive {
                return Ok(Self::at(state, density));
            }
        }
        Err(Failure::BudgetSpent { tries: budget })
    }

    /// Starts a chain at the first state drawn from `source` whose density is positive, within `budget` draws.
    ///
    /// The density may rarely visit such a start, so let the chain burn in. It takes the words of the draws.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if no state had a positive density.
    ///
    /// # Examples
    ///
    /// ```
    /// use microwarp::metropolis::{Chain, UniformStep};
    /// use rand_pcg::Pcg32;
    /// let spot = |x: f32| if (0.7..0.8).contains(&x) { 1.0 } else { 0.0 };
    /// assert!(Chain::new(0.5, spot).is_err());
    /// let chain = Chain::search(spot, &UniformStep::new(), 1000, &mut Pcg32::new(1, 1))?;
    /// assert!((0.7..0.8).contains(&chain.state()));
    /// # Ok::<(), microwarp::rejection::Failure>(())
    /// ```
    #[inline]
    pub fn search<S, R>(
        target: impl FnMut(X) -> D,
        source: &S,
        budget: u32,
        rng: &mut R,
    ) -> Result<Self, Failure<Infallible>>
    where
        S: StateSource<X>,
        R: Rng + ?Sized,
    {
        Self::try_search(target, source, budget, rng)
    }
}

impl<X: Copy, D: TargetDensity> Chain<X, D> {
    /// Starts a chain at one of `candidates` states drawn from `source`, with the weight that removes the start-up bias: see
    /// [`Start`].
    ///
    /// It keeps one candidate and two sums in memory, and takes the words of each draw and one more per candidate. A candidate
    /// whose density is NaN, infinite or negative counts as one of density 0.
    ///
    /// # Accuracy
    ///
    /// The relative error of the weight is that of the quotients f/p, plus 3e-7. For a logarithm that is the absolute error,
    /// plus its own rounding. Beyond the range of `f32` the weight is the nearest positive one. The probabilities are realised
    /// in steps of 2⁻³² per candidate.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if no candidate has a positive density, [`Failure::ProposalDensity`] if the source's own density
    /// at a state it drew is not positive and finite, [`Failure::Generator`] if the generator failed.
    ///
    /// # Source
    ///
    /// E. Veach, L. J. Guibas, "Metropolis Light Transport", 1997,
    /// [doi:10.1145/258734.258775](https://doi.org/10.1145/258734.258775).
    #[inline]
    pub fn try_resample<S, R>(
        mut target: impl FnMut(X) -> D,
        source: &S,
        candidates: u32,
        rng: &mut R,
    ) -> Result<Start<X, D>, Failure<R::Error>>
    where
        S: StateSource<X>,
        R: TryRng + ?Sized,
    {
        let mut seen = Candidates::NONE;
        for _ in 0..candidates {
            let state = source.try_draw_state(rng).map_err(Failure::Generator)?;
            let word = rng.try_next_u32().map_err(Failure::Generator)?;
            let pdf = source.pdf_of_state(state);
            if pdf.standing() != Standing::Positive {
                return Err(Failure::ProposalDensity);
            }
            let density = target(state);
            if density.standing() == Standing::Positive {
                seen.offer(state, density, pdf, word);
            }
        }
        seen.start(candidates)
            .ok_or(Failure::BudgetSpent { tries: candidates })
    }

    /// Starts a chain at one of `candidates` states drawn from `source`, with the weight that removes the start-up bias: see
    /// [`Start`], and [`try_resample`](Self::try_resample) for its accuracy.
    ///
    /// # Errors
    /// [`Failure::BudgetSpent`] if no candidate has a positive density, [`Failure::ProposalDensity`] if the source's own density
    /// at a state it drew is not positive and finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use microwarp::metropolis::{Chain, UniformStep};
    /// use rand_pcg::Pcg32;
    /// let f = |x: f32| (x - 0.5) * (x - 0.5); // whose integral over [0, 1) is 1/12
    /// let start = Chain::resample(f, &UniformStep::new(), 1000, &mut Pcg32::new(1, 1))?;
    /// let error = start.relative_error.unwrap_or(1.0);
    /// assert!((start.weight * 12.0 - 1.0).abs() < 4.0 * error);
    /// # Ok::<(), microwarp::rejection::Failure>(())
    /// ```
    #[inline]
    pub fn resample<S, R>(
        target: impl FnMut(X) -> D,
        source: &S,
        candidates: u32,
        rng: &mut R,
    ) -> Result<Start<X, D>, Failure<Infallible>>
    where
        S: StateSource<X>,
        R: Rng + ?Sized,
    {
        Self::try_resample(target, source, candidates, rng)
    }
}
