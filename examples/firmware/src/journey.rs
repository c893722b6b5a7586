//! The simulated journey: the truth, the tracker that does not know it, and how far apart the two are.

use crate::dock::Answer;
use crate::tracker::Tracker;
use crate::world::{BEACONS, DOCK, World, distance};
use microwarp::Error;
use microwarp::estimate::Moments;
use microwarp::tier::Tier as _;
use rand_pcg::Pcg32;

const TICKS: usize = 64;
/// The tracker has this long to find out how fast the rover is.
const WARM_UP: usize = 16;
/// At this tick a beacon says that the rover is inside it, which is nonsense.
const NONSENSE: usize = 40;

/// How many times the dock answers.
pub const ANSWERS: usize = TICKS / 2;

/// The outcome of a journey.
pub struct Journey {
    /// What the dock answered.
    pub answers: [Answer; ANSWERS],
    /// How far off the tracker was, root mean square over the ticks after the warm-up, in metres.
    pub error: f32,
    /// How many ranges the tracker refused.
    pub refused: u32,
}

/// A journey in the world of this seed. A deaf tracker is the control: it only guesses. Each `refusal` is told, with
/// its tick and its range.
///
/// # Errors
/// None: the parameters are constants.
#[inline(never)] // The tracker leaves the stack with it.
pub fn travel(
    world: &World,
    seed: u64,
    deaf: bool,
    refusal: fn(usize, f32, Error),
) -> Result<Journey, Error> {
    // The world's chance is not the tracker's.
    let (mut nature, mut rng) = (Pcg32::new(seed, 1), Pcg32::new(seed, 2));
    let mut rover = world.begin(&mut nature);
    let mut tracker = Tracker::new(world, &mut rng);
    let mut answers = [([0.0; 2], 0.0); ANSWERS];
    let mut squares = Moments::new();
    let mut refused = 0;
    for tick in 0..TICKS {
        rover = world.go(rover, &mut nature);
        tracker.predict(world, &mut rng);
        for (which, beacon) in BEACONS.into_iter().enumerate() {
            let mut range = world.range(rover.place, beacon, &mut nature);
            if tick == NONSENSE && which == 0 {
                range = 0.0;
            }
            if deaf {
                continue;
            }
            if let Err(error) = tracker.correct(beacon, range, &mut rng) {
                refused += 1;
                refusal(tick, range, error);
            }
        }
        let place = tracker.place();
        let range = world.range(rover.place, DOCK, &mut nature);
        if tick % 2 == 1 {
            answers[tick / 2] = (place, range);
        }
        if tick >= WARM_UP {
            let off = distance(rover.place, place);
            squares.push(off * off);
        }
    }
    Ok(Journey {
        answers,
        error: squares
            .mean()
            .map_or(f32::INFINITY, microwarp::tier::Poly::sqrt),
        refused,
    })
}
