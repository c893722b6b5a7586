//! Pictures by numbers: which scene, in which tier, by which points. The module of the page and the program of the host that
//! it is held against both render by this, so that they differ in nothing but the machine.
#![no_std]
#![forbid(unsafe_code)]

use microwarp::tier::{Libm, Poly};
use microwarp::uniform::ByPosition;
use microwarp_scene::fog::Fog;
use microwarp_scene::light::Light;
use microwarp_scene::material::Material;
use microwarp_scene::scenes;
use microwarp_scene::sky::Sky;
use microwarp_scene::source::{Owen, Strata};
use microwarp_scene::vector::Vector;
use microwarp_scene::{
    Camera, Colour, Echo, Film, Kit, Plan, Power, Random, Scene, Set, Source, View,
};

/// Scenes, tiers and point sets by name, in the order of their numbers.
pub const SCENES: [&str; 5] = ["room", "fog", "slivers", "slit", "sensor"];
pub const TIERS: [&str; 2] = ["libm", "poly"];
pub const POINTS: [&str; 4] = ["random", "position", "strata", "sobol"];

/// The pictures that the host hashes: one of each seed for every scene, tier and point set.
pub const HOST: Plan = Plan {
    size: [144, 96],
    samples: 4,
    seed: 42,
};

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

/// What picture is rendered, by the numbers of its choices.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    pub scene: u32,
    pub tier: u32,
    pub points: u32,
    pub plan: Plan,
}

/// Renders a row of a picture.
///
/// # Errors
/// For numbers that nothing has, and for pictures of no size or of too large a one.
pub fn row(choice: &Choice, row: u32, colours: &mut [Vector]) -> Result<(), Refusal> {
    let Plan { size, samples, .. } = choice.plan;
    let [width, height] = size.map(u64::from);
    if !(1..=u64::from(MOST)).contains(&width.wrapping_mul(height)) {
        return Err(Refusal::Pixels);
    }
    if !(1..=MOST).contains(&samples) {
        return Err(Refusal::Samples);
    }
    let mut job = Job {
        choice,
        row,
        colours,
    };
    match choice.scene {
        0 => job.tiers::<Colour, _, _, _, _>(&scenes::room::SCENE, scenes::room::CAMERA),
        1 => job.tiers::<Colour, _, _, _, _>(&scenes::fog::SCENE, scenes::fog::CAMERA),
        2 => job.tiers::<Colour, _, _, _, _>(&scenes::slivers::SCENE, scenes::slivers::CAMERA),
        3 => job.tiers::<Colour, _, _, _, _>(&scenes::slit::SCENE, scenes::slit::CAMERA),
        4 => job.tiers::<Echo, _, _, _, _>(&scenes::sensor::SCENE, scenes::sensor::CAMERA),
        _ => Err(Refusal::Scene),
    }
}

/// A row to render, while its types are chosen one after another.
struct Job<'a> {
    choice: &'a Choice,
    row: u32,
    colours: &'a mut [Vector],
}

impl Job<'_> {
    fn tiers<P: Film, M: Material, L: Light, E: Sky, F: Fog>(
        &mut self,
        scene: &Scene<'_, M, L, E, F>,
        camera: Camera,
    ) -> Result<(), Refusal> {
        match self.choice.tier {
            0 => self.points::<Libm, P, _, _, _, _>(scene, camera),
            1 => self.points::<Poly, P, _, _, _, _>(scene, camera),
            _ => Err(Refusal::Tier),
        }
    }

    fn points<K: Kit, P: Film, M: Material, L: Light, E: Sky, F: Fog>(
        &mut self,
        scene: &Scene<'_, M, L, E, F>,
        camera: Camera,
    ) -> Result<(), Refusal> {
        let view = View::<K>::new(camera, self.choice.plan.size).map_err(Refusal::Camera)?;
        match self.choice.points {
            0 => self.pixels::<K, P, Random, _, _, _, _>(scene, &view),
            1 => self.pixels::<K, P, Set<ByPosition>, _, _, _, _>(scene, &view),
            2 => self.pixels::<K, P, Set<Strata>, _, _, _, _>(scene, &view),
            3 => self.pixels::<K, P, Set<Owen>, _, _, _, _>(scene, &view),
            _ => return Err(Refusal::Points),
        }
        Ok(())
    }

    fn pixels<K: Kit, P: Film, S: Source, M: Material, L: Light, E: Sky, F: Fog>(
        &mut self,
        scene: &Scene<'_, M, L, E, F>,
        view: &View<K>,
    ) {
        for (colour, column) in self.colours.iter_mut().zip(0..) {
            *colour = scene.pixel::<K, Power, P, S>(view, [column, self.row], &self.choice.plan);
        }
    }
}
