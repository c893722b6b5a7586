//! Pictures by numbers: which scene, in which tier, by which points, as the module of the page takes them.

use crate::golden::{Fog, Room, Sensor, Shot, Slit, Slivers};
use crate::source::{Owen, Strata};
use crate::vector::Vector;
use crate::{Kit, Plan, Random, Set, Source, View};
use microwarp::tier::{Libm, Poly};
use microwarp::uniform::ByPosition;

/// Scenes, tiers and point sets by name, in the order of their numbers.
pub const SCENES: [&str; 5] = [
    Room::NAME,
    Fog::NAME,
    Slivers::NAME,
    Slit::NAME,
    Sensor::NAME,
];
pub const TIERS: [&str; 2] = ["libm", "poly"];
pub const POINTS: [&str; 4] = ["pcg32", "by_position", "strata", "sobol"];

/// The halves of a picture have seeds that follow one another.
pub const HALVES: u32 = 2;

/// The most pixels of a picture, and the most samples of a pixel.
pub const MOST: u32 = 1 << 16;

/// Why there is no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The camera refuses the picture.
    Camera(microwarp::Error),
    /// There is none of this number.
    Scene,
    Tier,
    Points,
    /// A pixel has no sample, or too many.
    Samples,
    /// There is no pixel, or too many.
    Pixels,
}

impl Refusal {
    #[must_use]
    pub const fn message(self) -> &'static str {
        match self {
            Self::Camera(error) => error.message(),
            Self::Scene => "there is no such scene",
            Self::Tier => "there is no such tier",
            Self::Points => "there is no such point set",
            Self::Samples => "a pixel takes 1 to 65536 samples",
            Self::Pixels => "a picture has 1 to 65536 pixels",
        }
    }
}

/// What picture is rendered.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    pub scene: u32,
    pub tier: u32,
    pub points: u32,
    pub plan: Plan,
}

/// Renders a row of a picture.
///
/// # Errors
/// For numbers that nothing has, and for pictures of no size or of too large a one.
// Compiled where it is called: in itself it holds each scene in each tier by each point set.
#[inline]
pub fn row(request: &Request, row: u32, colours: &mut [Vector]) -> Result<(), Refusal> {
    let Plan { size, samples, .. } = request.plan;
    let [width, height] = size.map(u64::from);
    if !(1..=u64::from(MOST)).contains(&width.wrapping_mul(height)) {
        return Err(Refusal::Pixels);
    }
    if !(1..=MOST).contains(&samples) {
        return Err(Refusal::Samples);
    }
    let mut job = Job {
        request,
        row,
        colours,
    };
    match request.scene {
        0 => job.tiers::<Room>(),
        1 => job.tiers::<Fog>(),
        2 => job.tiers::<Slivers>(),
        3 => job.tiers::<Slit>(),
        4 => job.tiers::<Sensor>(),
        _ => Err(Refusal::Scene),
    }
}

/// A row to render, while its types are chosen one after another.
struct Job<'a> {
    request: &'a Request,
    row: u32,
    colours: &'a mut [Vector],
}

impl Job<'_> {
    fn tiers<C: Shot>(&mut self) -> Result<(), Refusal> {
        match self.request.tier {
            0 => self.points::<C, Libm>(),
            1 => self.points::<C, Poly>(),
            _ => Err(Refusal::Tier),
        }
    }

    fn points<C: Shot, K: Kit>(&mut self) -> Result<(), Refusal> {
        let view = C::view::<K>(self.request.plan.size).map_err(Refusal::Camera)?;
        match self.request.points {
            0 => self.pixels::<C, K, Random>(&view),
            1 => self.pixels::<C, K, Set<ByPosition>>(&view),
            2 => self.pixels::<C, K, Set<Strata>>(&view),
            3 => self.pixels::<C, K, Set<Owen>>(&view),
            _ => return Err(Refusal::Points),
        }
        Ok(())
    }

    fn pixels<C: Shot, K: Kit, S: Source>(&mut self, view: &View<K>) {
        for (colour, column) in self.colours.iter_mut().zip(0..) {
            *colour = C::pixel::<K, S>(view, [column, self.row], &self.request.plan);
        }
    }
}
