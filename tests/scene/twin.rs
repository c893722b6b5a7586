//! The path tracer of the example `scene` against its twin in `f64`: from the same words both follow the same paths, and
//! their pictures agree. Renderers that are wrong on purpose do not.

use host::mean::Mean;
use host::parallel::{in_parallel, threads};
use host::speed;
use host::twin::{Air, Forgotten, Heaven, Record, Source64, Stuff, Twin};
use microwarp::tier::{Libm, Poly};
use microwarp::uniform::{ByPosition, Canonical};
use microwarp::warp::{
    CosineHemisphere, HenyeyGreenstein, Measured, PhongLobe, SolidAngle, Tent, TruncatedExponential,
};
use microwarp::{Error, Warp};
use microwarp_scene::scenes::{fog, room, sensor, slit, slivers};
use microwarp_scene::vector::{Vector, cross, length};
use microwarp_scene::{
    Camera, Colour, Echo, Fog, Heuristic, Kit, Lamp, Light, Material, Plan, Power, Quad, Ray,
    Scene, Set, Shape, Sky, Source, View,
};
use rand_core::Rng;

/// Columns and rows.
const SIZE: [u32; 2] = [48, 32];

/// The paths of a picture, in both.
struct Beside {
    /// The difference from the twin, over the mean of the twin.
    off: Mean,
    /// The same of paths that are together.
    together: f64,
    /// The part of the paths that are apart by more than 1e-4.
    apart: f64,
}

/// The light of every path by the core and by the twin, all channels together.
fn paths<K: Kit, H: Heuristic, P: Record, M, L, E, F>(
    scene: &Scene<'_, M, L, E, F>,
    camera: Camera,
    twin: &Twin,
    samples: u32,
) -> Vec<[f64; 2]>
where
    M: Material + Sync,
    L: Light + Sync,
    E: Sky + Sync,
    F: Fog + Sync,
{
    let rows: Vec<u32> = (0..SIZE[1]).collect();
    let plan = Plan {
        size: SIZE,
        samples,
        seed: 3,
    };
    let row = |row: &u32| {
        let view = View::<K>::new(camera, SIZE).expect("the camera sees something");
        let mut pairs = Vec::new();
        for column in 0..SIZE[0] {
            let mut words = Set::<ByPosition>::of_pixel(&plan, [column, *row]);
            for sample in 0..samples {
                words.begin(sample);
                let found = scene.sample::<K, H, P>(&view, [column, *row], &mut words);
                words.begin(sample);
                let due = twin.sample::<P>([column, *row], &mut words);
                pairs.push([found.map(f64::from), due].map(|light| light.iter().sum()));
            }
        }
        pairs
    };
    in_parallel(threads(), &rows, row).concat()
}

fn beside(pairs: &[[f64; 2]]) -> Beside {
    let count = pairs.len() as f64;
    let mean = pairs.iter().map(|[_, due]| due).sum::<f64>() / count;
    let agrees = |[found, due]: &&[f64; 2]| (found - due).abs() <= 1e-4 * (due + mean);
    let together: Vec<_> = pairs.iter().filter(agrees).collect();
    Beside {
        off: Mean::of(pairs.iter().map(|[found, due]| (found - due) / mean)),
        apart: 1.0 - together.len() as f64 / count,
        together: together.iter().map(|[found, due]| found - due).sum::<f64>() / mean / count,
    }
}

impl Beside {
    /// What a right picture keeps. Each path agrees to 1e-4, but for one in 2000 that an edge, or the rounding of a decision,
    /// leads elsewhere. The mean of the others is that of the twin to 1e-6. Those that go elsewhere find as much light: the
    /// whole mean is off by no more than six standard errors, and these are small.
    fn passes(&self) -> bool {
        let Self {
            off,
            together,
            apart,
        } = self;
        *apart <= 5e-4
            && together.abs() <= 1e-6
            && off.mean.abs() <= 6.0 * off.error + 1e-6
            && off.error <= 5e-5
    }

    fn print(&self, what: &str) {
        let Self {
            off,
            together,
            apart,
        } = self;
        println!(
            "{what}: {:+.1e} ± {:.1e}, {together:+.1e} together, {apart:.1e} of the paths apart",
            off.mean, off.error
        );
    }
}

fn samples() -> u32 {
    speed::of("samples a pixel beside the twin", 8, 64)
}

fn agrees<P: Record, M, L, E, F>(name: &str, scene: &Scene<'_, M, L, E, F>, camera: Camera)
where
    M: Material + Sync,
    L: Light + Sync,
    E: Sky + Sync,
    F: Fog + Sync,
    Stuff: From<M>,
    Source64: From<L>,
    Heaven: From<E>,
    Air: From<F>,
{
    let twin = Twin::new(scene, camera, SIZE);
    let both = [
        paths::<Poly, Power, P, _, _, _, _>(scene, camera, &twin, samples()),
        paths::<Libm, Power, P, _, _, _, _>(scene, camera, &twin, samples()),
    ];
    for (tier, pairs) in ["poly", "libm"].into_iter().zip(&both) {
        let beside = beside(pairs);
        beside.print(&format!("{name}, {tier}"));
        assert!(beside.passes(), "{name}, {tier}: the twin differs");
    }
}

#[test]
fn both_tiers_follow_the_paths_of_the_twin() {
    agrees::<Colour, _, _, _, _>("room", &room::SCENE, room::CAMERA);
    agrees::<Colour, _, _, _, _>("fog", &fog::SCENE, fog::CAMERA);
    agrees::<Colour, _, _, _, _>("slivers", &slivers::SCENE, slivers::CAMERA);
    agrees::<Colour, _, _, _, _>("slit", &slit::SCENE, slit::CAMERA);
    agrees::<Echo, _, _, _, _>("sensor", &sensor::SCENE, sensor::CAMERA);
}

/// A panel whose density is that of its area.
#[derive(Clone, Copy)]
struct ByArea(Lamp<Quad>);

impl Shape for ByArea {
    fn hit(&self, ray: Ray, within: f32) -> Option<f32> {
        self.0.shape.hit(ray, within)
    }

    fn normal(&self, place: Vector) -> Vector {
        self.0.shape.normal(place)
    }

    fn draw<K: Kit>(&self, from: Vector, words: &mut impl Rng) -> Option<(Vector, f32)> {
        let (direction, _) = self.0.shape.draw::<K>(from, words)?;
        Some((direction, self.pdf::<K>(from, direction)))
    }

    fn pdf<K: Kit>(&self, _: Vector, _: Vector) -> f32 {
        let [x, y] = self.0.shape.edges();
        1.0 / length(cross(x, y))
    }
}

impl Light for ByArea {
    type Shape = Self;

    fn shape(&self) -> &Self {
        self
    }

    fn radiance(&self) -> Vector {
        self.0.radiance
    }

    fn middle(&self) -> Vector {
        self.0.middle()
    }
}

/// Lambert's law with the density of the disk below it, which has no cosine, or with roots that are 4 % too large.
#[derive(Clone, Copy)]
struct Wrong<const ROOTS: bool>;

impl<const ROOTS: bool> Measured for Wrong<ROOTS> {
    type Measure = SolidAngle;
}

impl<const ROOTS: bool> Warp for Wrong<ROOTS> {
    type Uniforms = [f32; 2];
    type Point = Vector;
    type Density = f32;

    fn sample_canonical(&self, u: Canonical<[f32; 2]>) -> Vector {
        let [x, y, z] = CosineHemisphere::<Poly>::new().sample(u.get());
        if ROOTS {
            let [x, y] = [x, y].map(|c| 1.04 * c);
            [x, y, (1.0 - x * x - y * y).max(1e-4).sqrt()]
        } else {
            [x, y, z]
        }
    }

    fn pdf(&self, direction: Vector) -> f32 {
        let density = CosineHemisphere::<Poly>::new().pdf(direction);
        if ROOTS {
            density
        } else {
            std::f32::consts::FRAC_1_PI
        }
    }
}

/// The tier `poly` but for that.
struct WrongKit<const ROOTS: bool>;

impl<const ROOTS: bool> Kit for WrongKit<ROOTS> {
    type Tier = Poly;
    type Cosine = Wrong<ROOTS>;
    type Gloss = PhongLobe<Poly>;
    type Phase = HenyeyGreenstein<Poly>;
    type Free = TruncatedExponential<Poly>;
    type Filter = Tent;

    fn cosine() -> Wrong<ROOTS> {
        Wrong
    }

    fn gloss(exponent: f32) -> Result<Self::Gloss, Error> {
        Poly::gloss(exponent)
    }

    fn phase(asymmetry: f32) -> Result<Self::Phase, Error> {
        Poly::phase(asymmetry)
    }

    fn free(rate: f32, length: f32) -> Result<Self::Free, Error> {
        Poly::free(rate, length)
    }

    fn filter(radius: f32) -> Result<Tent, Error> {
        Poly::filter(radius)
    }
}

#[test]
fn what_is_wrong_on_purpose_leaves_the_twin() {
    let (scene, camera, samples) = (&room::SCENE, room::CAMERA, 4 * samples());
    let twin = Twin::new(scene, camera, SIZE);
    let lights = [0, 1].map(|i| ByArea(scene.lights[i]));
    let by_area = Scene {
        quads: scene.quads,
        spheres: scene.spheres,
        lights: &lights,
        choice: scene.choice,
        sky: scene.sky,
        fog: scene.fog,
    };
    let wrong = [
        (
            "weights forgotten",
            paths::<Poly, Forgotten, Colour, _, _, _, _>(scene, camera, &twin, samples),
        ),
        (
            "density of area",
            paths::<Poly, Power, Colour, _, _, _, _>(&by_area, camera, &twin, samples),
        ),
        (
            "no cosine",
            paths::<WrongKit<false>, Power, Colour, _, _, _, _>(scene, camera, &twin, samples),
        ),
        (
            "4 %",
            paths::<WrongKit<true>, Power, Colour, _, _, _, _>(scene, camera, &twin, samples),
        ),
    ];
    for (what, pairs) in &wrong {
        let beside = beside(pairs);
        beside.print(what);
        assert!(!beside.passes(), "{what} passes");
        // By the mean alone, too, and by far.
        assert!(
            beside.off.mean.abs() > 6.0 * beside.off.error + 5e-6,
            "{what}"
        );
        assert!(beside.apart > 0.1, "{what}");
    }
}
