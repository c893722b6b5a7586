//! Metropolis chains: over a density of the unit square, and over integer weights.

use crate::run::Draw;
use crate::shared::Refusal;
use crate::subject::subjects;
use microwarp::Error;
use microwarp::metropolis::{
    Autocorrelation, Chain, LargeSmall, Mixture, NormalStep, UniformIndex, WrappedWalk,
};
use microwarp::tier::Tier;
use rand_core::Rng;

/// The number of lags of the autocorrelation.
const LAGS: usize = 256;

/// What a chain reports: its acceptance rate, the integrated autocorrelation time of the first coordinate or of the
/// state's number (0 where the lags do not reach that far).
fn tell(rate: Option<f32>, health: &Autocorrelation<LAGS>, report: &mut [f64; 16]) {
    let [acceptance, time, ..] = report;
    *acceptance = rate.unwrap_or(0.0).into();
    *time = health.integrated_time().unwrap_or(0.0).into();
}

subjects! {
    OF_DENSITY of_density[T: Tier,] "chains" "libm poly":
    Chain: plane 0: Chain(step_deviation: 0.1 in 0..0.5 by 0.005, share_of_large_steps: 0.2 in 0..1)
        => Hills::<T>::new(step_deviation, share_of_large_steps),
}

subjects! {
    OF_INTEGERS of_integers[] "chains" "exact":
    Chain: bars 0: IntegerChain(
        weight_0: 9 in 0..40 by 1, weight_1: 1 in 0..40 by 1, weight_2: 0 in 0..40 by 1,
        weight_3: 30 in 0..40 by 1, weight_4: 4 in 0..40 by 1, weight_5: 12 in 0..40 by 1
    ) => States::new([weight_0, weight_1, weight_2, weight_3, weight_4, weight_5]),
}

/// e^(3 (cos 2π(x + y) + cos 2π(x − 2y) − 2)), whose period is 1 in both coordinates.
fn hills<T: Tier>([x, y]: [f32; 2]) -> f32 {
    let (_, first) = T::sincos_turns(x + y);
    let (_, second) = T::sincos_turns(x - 2.0 * y);
    T::exp(3.0 * (first + second - 2.0))
}

struct Hills<T: Tier> {
    chain: Chain<[f32; 2]>,
    mutation: LargeSmall<WrappedWalk<NormalStep<[f32; 2], T>>>,
    health: Autocorrelation<LAGS>,
}

impl<T: Tier> Hills<T> {
    /// Three hills on the unit square without borders: small normal steps, now and then a large one.
    fn new(deviation: f32, large: f32) -> Result<Self, Error> {
        let small = WrappedWalk::new(NormalStep::<_, T>::new([deviation; 2])?);
        Ok(Self {
            chain: Chain::new([0.0; 2], hills::<T>)?,
            mutation: Mixture::large_small(large, small)?,
            health: Autocorrelation::new(),
        })
    }
}

impl<T: Tier> Draw for Hills<T> {
    type Point = [f32; 2];

    #[inline]
    fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<[f32; 2], Refusal> {
        Ok(self.chain.step(hills::<T>, &self.mutation, rng).state())
    }

    fn watch(&mut self, [x, _]: [f32; 2]) {
        self.health.push(x);
    }

    fn density(&self, point: [f32; 2]) -> f64 {
        hills::<T>(point).into()
    }

    fn report(&self, report: &mut [f64; 16]) {
        tell(self.chain.acceptance_rate(), &self.health, report);
    }
}

fn weight(weights: &[u32; 6], state: usize) -> u32 {
    weights.get(state).copied().unwrap_or(0)
}

struct States {
    chain: Chain<usize, u32>,
    mutation: UniformIndex,
    weights: [u32; 6],
    health: Autocorrelation<LAGS>,
}

impl States {
    /// Six states of integer weights; a proposal is any of them.
    fn new(weights: [f32; 6]) -> Result<Self, Error> {
        let weights = weights.map(|weight| weight as u32);
        // The chain starts at the heaviest state, where it may be.
        let heaviest = (0..6).max_by_key(|&state| weight(&weights, state));
        Ok(Self {
            chain: Chain::new(heaviest.unwrap_or(0), |state| weight(&weights, state))?,
            mutation: UniformIndex::new(6)?,
            weights,
            health: Autocorrelation::new(),
        })
    }
}

impl Draw for States {
    type Point = usize;

    #[inline]
    fn draw<R: Rng>(&mut self, rng: &mut R) -> Result<usize, Refusal> {
        let weights = &self.weights;
        let target = |state| weight(weights, state);
        Ok(self.chain.step(target, &self.mutation, rng).state())
    }

    fn watch(&mut self, state: usize) {
        self.health.push(state as f32);
    }

    fn density(&self, state: usize) -> f64 {
        weight(&self.weights, state).into()
    }

    fn report(&self, report: &mut [f64; 16]) {
        tell(self.chain.acceptance_rate(), &self.health, report);
    }
}
