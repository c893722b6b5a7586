//! Finds the dock: a Metropolis chain over its possible positions.

use crate::world::{Place, distance};
use microwarp::metropolis::{Chain, Independence, Mixture, Mutation};
use microwarp::rejection::Failure;
use microwarp::{Error, poly as mw, warp::Aabb};
use rand_pcg::Pcg32;

/// An answer of the dock: where the rover thought it was, and how far away the dock seemed.
pub type Answer = (Place, f32);

/// A chain whose density at a place is how likely the answers are if the dock is there.
pub type Search = Chain<Place, mw::LogDensity>;

/// The standard deviation of a range measured from an estimated position.
const DEVIATION: f32 = 0.5;

/// How likely the answers are if the dock is there. A range that is off by more than some deviations does not matter
/// more than they do: it is that of an echo, which is common if it is too long and rare if it is too short.
pub fn target(answers: &[Answer]) -> impl Fn(Place) -> mw::LogDensity {
    move |dock| {
        let squares = answers.iter().map(|&(place, range)| {
            let z = (range - distance(place, dock)) / DEVIATION;
            (z * z).min(if z > 0.0 { 9.0 } else { 25.0 })
        });
        mw::LogDensity::new(-0.5 * squares.sum::<f32>())
    }
}

/// The lawn: before anything is heard, the dock is as likely anywhere on it.
fn lawn() -> Result<Aabb<2>, Error> {
    Aabb::new([-25.0; 2], [25.0; 2])
}

/// Small steps, and sometimes a leap to anywhere on the lawn.
///
/// # Errors
/// None: the parameters are constants.
pub fn mutation() -> Result<impl Mutation<Place> + defmt::Format, Error> {
    let small = mw::NormalStep::new([0.5; 2])?;
    let leap = Independence::new(lawn()?);
    Mixture::new((small, leap), &[0.8, 0.2])
}

/// A chain that starts at one of many places of the lawn, chosen by how likely each makes the answers.
///
/// # Errors
/// [`Failure::BudgetSpent`] if none of them is possible.
pub fn start(answers: &[Answer], rng: &mut Pcg32) -> Result<Search, Failure> {
    let lawn = lawn().map_err(|_| Failure::ProposalDensity)?;
    Ok(Chain::resample(target(answers), &lawn, 300, rng)?.chain)
}

/// Takes steps, and returns the mean of the positions on the way.
///
/// # Errors
/// As [`mutation`].
pub fn advance(
    chain: &mut Search,
    answers: &[Answer],
    steps: u16,
    rng: &mut Pcg32,
) -> Result<Place, Error> {
    let (target, mutation) = (target(answers), mutation()?);
    let mut sum = [0.0; 2];
    for _ in 0..steps {
        let [x, y] = chain.step(&target, &mutation, rng).state();
        sum = [sum[0] + x, sum[1] + y];
    }
    Ok(sum.map(|sum| sum / f32::from(steps)))
}
