//! Tracks the rover: a particle filter.

use crate::world::{Place, Pose, RANGE_DEVIATION, World, distance};
use microwarp::Error;
use microwarp::discrete::resampling::{rearrange, systematic, to_integers};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// How many guesses there are.
pub const PARTICLES: usize = 128;

/// Guesses of the rover's pose, each as good as any other.
pub struct Tracker {
    particles: [Pose; PARTICLES],
}

impl Tracker {
    /// Guesses of where a journey begins.
    pub fn new(world: &World, rng: &mut Pcg32) -> Self {
        Self {
            particles: core::array::from_fn(|_| world.begin(rng)),
        }
    }

    /// Every guess moves as the rover may have moved.
    pub fn predict(&mut self, world: &World, rng: &mut Pcg32) {
        for particle in &mut self.particles {
            *particle = world.go(*particle, rng);
        }
    }

    /// Resamples: guesses that agree with a range multiply, and others die out.
    ///
    /// # Errors
    /// [`Error::AllZero`] if the range agrees with no guess at all; nothing has changed then.
    pub fn correct(&mut self, beacon: Place, range: f32, rng: &mut Pcg32) -> Result<(), Error> {
        let weights = self
            .particles
            .each_ref()
            .map(|pose| agreement(range - distance(pose.place, beacon)));
        let mut counts = [0; PARTICLES];
        to_integers(&weights, &mut counts)?;
        systematic(&mut counts, PARTICLES as u32, rng.next_u32())?;
        rearrange(&mut counts, &mut self.particles)
    }

    /// The mean of the guesses.
    pub fn place(&self) -> Place {
        let [x, y] = self.particles.iter().fold([0.0; 2], |[x, y], particle| {
            [x + particle.place[0], y + particle.place[1]]
        });
        [x, y].map(|sum| sum / PARTICLES as f32)
    }
}

/// How well a guess explains a range that is too long by this: straight, much as a normal density would have it
/// but 0 from six deviations on (the guesses are too few to be as strict as the beacon); or as an echo, which may be
/// as late as it likes, but not early.
fn agreement(excess: f32) -> f32 {
    let z = excess / (6.0 * RANGE_DEVIATION);
    let bump = (1.0 - z * z).max(0.0);
    let fourth = bump * bump * bump * bump;
    fourth * fourth + if excess > 0.0 { 0.01 } else { 0.0 }
}
