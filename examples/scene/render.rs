//! A picture by several threads, row by row, whatever its scene, tier and points are.

use crate::kits::{FourPercent, Textbook};
use host::twin::{Air, Forgotten, Heaven, Record, Source64, Stuff, Twin};
use microwarp::fixed::{Coarse, Fine};
use microwarp::tier::{Libm, Poly};
use microwarp::uniform::ByPosition;
use microwarp_scene::fog::Fog;
use microwarp_scene::light::Light;
use microwarp_scene::material::Material;
use microwarp_scene::path::Heuristic;
use microwarp_scene::sky::Sky;
use microwarp_scene::source::{Owen, Shared, Strata};
use microwarp_scene::{Camera, Integers, Kit, Power, Random, Scene, Set, Source, View, Walk};
use std::marker::PhantomData;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tier {
    Poly,
    Libm,
    /// The tier `poly` without the weights of multiple importance sampling: light that two techniques find counts twice.
    Forgotten,
}

/// What single paths are followed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    Libm,
    Poly,
    /// The integer tier, where it has the sampler.
    Fine,
    Coarse,
    /// Formulas of textbooks with functions of three digits.
    Textbook,
    /// Densities that are 4 % off.
    FourPercent,
    /// The twin in `f64`.
    Twin,
}

impl By {
    pub const fn name(self) -> &'static str {
        match self {
            Self::Libm => "libm",
            Self::Poly => "poly",
            Self::Fine => "fixed",
            Self::Coarse => "fixed::coarse",
            Self::Textbook => "control: three digits",
            Self::FourPercent => "control: 4 % off",
            Self::Twin => "twin",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointSet {
    Random,
    ByPosition,
    Strata,
    Sobol,
    /// One set for all pixels.
    Screen,
}

impl Tier {
    pub const fn name(self) -> &'static str {
        match self {
            Self::Poly => "poly",
            Self::Libm => "libm",
            Self::Forgotten => "poly, weights forgotten",
        }
    }
}

impl PointSet {
    pub const fn name(self) -> &'static str {
        match self {
            Self::Random => "PCG32",
            Self::ByPosition => "by position",
            Self::Strata => "strata",
            Self::Sobol => "Sobol'",
            Self::Screen => "Sobol', one set for all pixels",
        }
    }
}

/// What a picture is rendered by.
#[derive(Clone, Copy)]
pub struct Plan {
    pub tier: Tier,
    pub points: PointSet,
    pub size: [u32; 2],
    pub samples: u32,
    pub seed: u32,
}

impl Plan {
    fn core(&self) -> microwarp_scene::Plan {
        microwarp_scene::Plan {
            size: self.size,
            samples: self.samples,
            seed: self.seed,
        }
    }
}

/// Pixels, row by row.
pub type Pixels = Vec<[f64; 3]>;

/// A scene that has forgotten its type.
pub trait Render: Sync {
    fn row(&self, plan: &Plan, row: u32) -> Pixels;
    /// The picture of a chain of paths, in the tier `poly`.
    fn chain(&self, walk: &Walk) -> Pixels;

    /// The light of each path of a pixel from points by position.
    fn paths(&self, by: By, plan: &Plan, pixel: [u32; 2]) -> Pixels;
}

/// A scene with its camera and the film that is in it.
pub struct Take<S, P> {
    scene: S,
    camera: Camera,
    film: PhantomData<fn() -> P>,
}

impl<S, P> Take<S, P> {
    pub fn new(scene: S, camera: Camera) -> Self {
        let film = PhantomData;
        Self {
            scene,
            camera,
            film,
        }
    }
}

impl<M, L, E, F, P> Take<Scene<'_, M, L, E, F>, P>
where
    M: Material,
    L: Light,
    E: Sky,
    F: Fog,
    P: Record,
{
    fn row_by<K: Kit, H: Heuristic, S: Source>(&self, plan: &Plan, row: u32) -> Pixels {
        let view = View::<K>::new(self.camera, plan.size).expect("the camera sees something");
        let [width, _] = plan.size;
        let core = plan.core();
        let pixel = |column| {
            let light = self.scene.pixel::<K, H, P, S>(&view, [column, row], &core);
            light.map(f64::from)
        };
        (0..width).map(pixel).collect()
    }

    /// The light of each path of a pixel by whatever follows one.
    fn each(
        plan: &Plan,
        pixel: [u32; 2],
        mut follow: impl FnMut(&mut Set<ByPosition>) -> [f64; 3],
    ) -> Pixels {
        let mut source = Set::<ByPosition>::of_pixel(&plan.core(), pixel);
        let path = |sample| {
            source.begin(sample);
            follow(&mut source)
        };
        (0..plan.samples).map(path).collect()
    }

    fn each_by<K: Kit>(&self, plan: &Plan, pixel: [u32; 2]) -> Pixels {
        let view = View::<K>::new(self.camera, plan.size).expect("the camera sees something");
        Self::each(plan, pixel, |source| {
            let light = self.scene.sample::<K, Power, P>(&view, pixel, source);
            light.map(f64::from)
        })
    }

    fn row_in<K: Kit, H: Heuristic>(&self, plan: &Plan, row: u32) -> Pixels {
        match plan.points {
            PointSet::Random => self.row_by::<K, H, Random>(plan, row),
            PointSet::ByPosition => self.row_by::<K, H, Set<ByPosition>>(plan, row),
            PointSet::Strata => self.row_by::<K, H, Set<Strata>>(plan, row),
            PointSet::Sobol => self.row_by::<K, H, Set<Owen>>(plan, row),
            PointSet::Screen => self.row_by::<K, H, Set<Shared>>(plan, row),
        }
    }
}

impl<M, L, E, F, P> Render for Take<Scene<'_, M, L, E, F>, P>
where
    M: Material + Sync,
    L: Light + Sync,
    E: Sky + Sync,
    F: Fog + Sync,
    P: Record,
    Stuff: From<M>,
    Source64: From<L>,
    Heaven: From<E>,
    Air: From<F>,
{
    fn row(&self, plan: &Plan, row: u32) -> Pixels {
        match plan.tier {
            Tier::Poly => self.row_in::<Poly, Power>(plan, row),
            Tier::Libm => self.row_in::<Libm, Power>(plan, row),
            Tier::Forgotten => self.row_by::<Poly, Forgotten, Random>(plan, row),
        }
    }

    fn chain(&self, walk: &Walk) -> Pixels {
        let view = View::<Poly>::new(self.camera, walk.size).expect("the camera sees something");
        let [width, height] = walk.size.map(|n| n as usize);
        let mut pixels = vec![[0.0; 3]; width * height];
        let run = self
            .scene
            .metropolis::<Poly, Power, P>(&view, walk, |[x, y], light| {
                let pixel = &mut pixels[y as usize * width + x as usize];
                (0..3).for_each(|k| pixel[k] += f64::from(light[k]));
            });
        run.expect("the picture has pixels");
        pixels
    }

    fn paths(&self, by: By, plan: &Plan, pixel: [u32; 2]) -> Pixels {
        match by {
            By::Libm => self.each_by::<Libm>(plan, pixel),
            By::Poly => self.each_by::<Poly>(plan, pixel),
            By::Fine => self.each_by::<Integers<Fine>>(plan, pixel),
            By::Coarse => self.each_by::<Integers<Coarse>>(plan, pixel),
            By::Textbook => self.each_by::<Textbook>(plan, pixel),
            By::FourPercent => self.each_by::<FourPercent>(plan, pixel),
            By::Twin => {
                let twin = Twin::new(&self.scene, self.camera, plan.size);
                Self::each(plan, pixel, |source| twin.sample::<P>(pixel, source))
            }
        }
    }
}

/// Renders; `done` hears of every row.
pub fn picture(scene: &dyn Render, plan: &Plan, done: impl Fn() + Sync) -> Pixels {
    let [_, height] = plan.size;
    let rows: Vec<u32> = (0..height).collect();
    let job = |row: &u32| {
        let pixels = scene.row(plan, *row);
        done();
        pixels
    };
    host::parallel::in_parallel(host::parallel::threads(), &rows, job).concat()
}
