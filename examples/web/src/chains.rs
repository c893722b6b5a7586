//! Metropolis chains: over a density of the unit square, and over integer weights.

use crate::run::{Draw, Visit};
use crate::shared::Refusal;
use crate::subject::Parameters;
use microwarp::metropolis::{
    Chain, Health, LargeSmall, Mixture, NormalStep, UniformIndex, Wrapped,
};
use microwarp::tier::Tier;
use rand_core::Rng;

/// How many lags the autocorrelation is followed.
const LAGS: usize = 256;

/// What a chain reports: its acceptance rate, the integrated autocorrelation time of the first coordinate or of the
/// state's number (0 where the lags do not reach that far).
fn tell(rate: Option<f32>, health: &Health<LAGS>, report: &mut [f64; 16]) {
    let [acceptance, time, ..] = report;
    *acceptance = rate.unwrap_or(0.0).into();
    *time = health.integrated_time().unwrap_or(0.0).into();
}

/// Three hills on the unit square without borders: small normal steps, now and then a large one.
pub fn of_density<T: Tier, V: Visit>(p: &Parameters, v: &mut V) -> Result<(), Refusal> {
    let &[deviation, large, ..] = p;
    let small = Wrapped::new(NormalStep::<_, T>::new([deviation; 2])?);
    let chain = Chain::new([0.0; 2], hills::<T>)?;
    v.take(Hills::<T> {
        chain,
        mutation: Mixture::large_small(large, small)?,
        health: Health::new(),
    })
}

/// e^(3 (cos 2π(x + y) + cos 2π(x − 2y) − 2)), whose period is 1 in both coordinates.
fn hills<T: Tier>([x, y]: [f32; 2]) -> f32 {
    let (_, first) = T::sincos_turns(x + y);
    let (_, second) = T::sincos_turns(x - 2.0 * y);
    T::exp(3.0 * (first + second - 2.0))
}

struct Hills<T: Tier> {
    chain: Chain<[f32; 2]>,
    mutation: LargeSmall<Wrapped<NormalStep<[f32; 2], T>>>,
    health: Health<LAGS>,
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

/// Six states of integer weights; a proposal is any of them.
pub fn of_integers<V: Visit>(p: &Parameters, v: &mut V) -> Result<(), Refusal> {
    let &[a, b, c, d, e, f, ..] = p;
    let weights = [a, b, c, d, e, f].map(|weight| weight as u32);
    // A chain begins where it may be: at the heaviest state.
    let heaviest = (0..6).max_by_key(|&state| weight(&weights, state));
    v.take(States {
        chain: Chain::new(heaviest.unwrap_or(0), |state| weight(&weights, state))?,
        mutation: UniformIndex::new(6)?,
        weights,
        health: Health::new(),
    })
}

fn weight(weights: &[u32; 6], state: usize) -> u32 {
    weights.get(state).copied().unwrap_or(0)
}

struct States {
    chain: Chain<usize, u32>,
    mutation: UniformIndex,
    weights: [u32; 6],
    health: Health<LAGS>,
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
