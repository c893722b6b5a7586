//! The target and the three mutations: two humps, with a valley of density 0 between them.

use microwarp::Error;
use microwarp::metropolis::{BoxStep, Mixture, Mutation, Proposal, Symmetric, UniformStep};
use rand_core::TryRng;

/// Bins of a histogram.
pub const BINS: usize = 40;

pub fn bin(x: f32) -> usize {
    ((x * BINS as f32) as usize).min(BINS - 1)
}

/// Width of the box step.
pub const WIDTH: f32 = 0.1;
/// How often the mixture takes the box step.
pub const SMALL: f64 = 0.9;

/// The density, up to a factor.
pub fn target(x: f32) -> f32 {
    if (0.0..=1.0).contains(&x) {
        (x - 0.5) * (x - 0.5)
    } else {
        0.0
    }
}

/// The density itself.
pub fn density(x: f64) -> f64 {
    12.0 * (x - 0.5).powi(2)
}

/// The exact probability of each of n equal bins.
pub fn probabilities(bins: usize) -> Vec<f64> {
    let below = |i: usize| 4.0 * (i as f64 / bins as f64 - 0.5).powi(3);
    (0..bins).map(|i| below(i + 1) - below(i)).collect()
}

pub enum Rule {
    Uniform(UniformStep),
    Box(BoxStep<f32>),
    Mixture(Mixture<(BoxStep<f32>, UniformStep), 2>),
}

impl Rule {
    pub fn all() -> Result<[Self; 3], Error> {
        let small = BoxStep::new(WIDTH)?;
        let weights = [SMALL as f32, (1.0 - SMALL) as f32];
        let mixture = Mixture::new((small, UniformStep::new()), &weights)?;
        Ok([
            Self::Uniform(UniformStep::new()),
            Self::Box(small),
            Self::Mixture(mixture),
        ])
    }

    pub fn name(&self) -> &'static str {
        match self {
            Self::Uniform(_) => "uniform",
            Self::Box(_) => "box 0.1",
            Self::Mixture(_) => "mixture",
        }
    }

    pub fn caption(&self) -> &'static str {
        match self {
            Self::Uniform(_) => "anywhere in [0, 1]",
            Self::Box(_) => "x ± 0.05 at most",
            Self::Mixture(_) => "90 % box, 10 % uniform",
        }
    }

    /// The share of box steps.
    pub fn small(&self) -> f64 {
        match self {
            Self::Uniform(_) => 0.0,
            Self::Box(_) => 1.0,
            Self::Mixture(_) => SMALL,
        }
    }
}

impl Mutation<f32> for Rule {
    type Correction = Symmetric;

    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: f32,
        rng: &mut R,
    ) -> Result<Proposal<f32, Symmetric>, R::Error> {
        match self {
            Self::Uniform(step) => step.try_propose(from, rng),
            Self::Box(step) => step.try_propose(from, rng),
            Self::Mixture(mixture) => mixture.try_propose(from, rng),
        }
    }
}
