//! The world: a rover on a lawn, beacons that it hears, and a dock that it looks for. The simulation draws from
//! this model, and the tracker guesses by it.

use microwarp::discrete::Cdf;
use microwarp::tier::{Poly, Tier as _};
use microwarp::{Error, Warp, poly as mw};
use rand_pcg::Pcg32;

/// Metres.
pub type Place = [f32; 2];

/// The rover's position, and its velocity per tick.
#[derive(Clone, Copy)]
pub struct Pose {
    pub place: Place,
    pub velocity: Place,
}

/// What answers a ping. The rover knows where the beacons are, and has to find the dock.
pub const BEACONS: [Place; 3] = [[-20.0, -15.0], [20.0, -15.0], [0.0, 20.0]];
pub const DOCK: Place = [9.0, -4.0];

/// The standard deviation of a direct range, in metres.
pub const RANGE_DEVIATION: f32 = 0.3;

/// What the rover does in a tick: it goes on, turns left, turns right or brakes. Built by the compiler, kept in flash.
const MODES: Cdf<[u32; 4]> = table(Cdf::from_integers(&[12, 3, 3, 1]));
/// Cosine and sine of each mode's turn, times what it leaves of the speed.
const TURNS: [[f32; 2]; 4] = [[1.0, 0.0], [0.92, 0.38], [0.92, -0.38], [0.5, 0.0]];
/// One range in ten is that of an echo, which comes by a detour.
const STRAIGHT_OR_ECHO: Cdf<[u32; 2]> = table(Cdf::from_integers(&[9, 1]));

const fn table<const N: usize>(checked: Result<Cdf<[u32; N]>, Error>) -> Cdf<[u32; N]> {
    match checked {
        Ok(table) => table,
        // In a constant this is an error of the compiler's.
        Err(_) => panic!("bad weights"),
    }
}

/// Its distributions.
#[derive(Clone, Copy, defmt::Format)]
pub struct World {
    /// Where and how fast the rover is at first, in units of 3 m and of 1 m a tick.
    pub start: mw::Disk,
    /// What the ground adds to the velocity in a tick.
    pub ground: mw::NormalPair,
    /// The error of a range.
    pub noise: mw::Normal,
    /// The detour of an echo.
    pub detour: mw::Exponential,
}

impl World {
    /// # Errors
    /// None: the parameters are constants.
    pub fn new() -> Result<Self, Error> {
        Ok(Self {
            start: mw::Disk::new(),
            ground: mw::NormalPair::new([0.0; 2], 0.08)?,
            noise: mw::Normal::new(0.0, RANGE_DEVIATION)?,
            detour: mw::Exponential::from_rate(1.0 / 6.0)?,
        })
    }

    /// A pose to begin with.
    pub fn begin(&self, rng: &mut Pcg32) -> Pose {
        Pose {
            place: self.start.draw(rng).map(|x| 3.0 * x),
            velocity: self.start.draw(rng),
        }
    }

    /// The pose a tick later.
    pub fn go(
        &self,
        Pose {
            place: [x, y],
            velocity: [u, v],
        }: Pose,
        rng: &mut Pcg32,
    ) -> Pose {
        let [cos, sin] = TURNS[MODES.draw_index(rng)];
        let [du, dv] = self.ground.draw(rng);
        let velocity @ [u, v] = [cos * u - sin * v + du, sin * u + cos * v + dv];
        Pose {
            place: [x + u, y + v],
            velocity,
        }
    }

    /// The range measured by a ping.
    pub fn range(&self, from: Place, to: Place, rng: &mut Pcg32) -> f32 {
        let straight = distance(from, to) + self.noise.draw(rng);
        match STRAIGHT_OR_ECHO.draw_index(rng) {
            0 => straight,
            _ => straight + self.detour.draw(rng),
        }
    }
}

pub fn distance([x, y]: Place, [u, v]: Place) -> f32 {
    Poly::sqrt((x - u) * (x - u) + (y - v) * (y - v))
}
