//! A path of light in a scene of `examples/scene`, the generator of its pixel included: each of the five scenes, and one of a
//! lamp and two surfaces with one ingredient more each time.

use crate::measured::registry::{kernels, loaded, made, ok};
use microwarp::Error;
use microwarp::discrete::Cdf;
use microwarp::tier::Poly;
use microwarp_scene::fog::Fog;
use microwarp_scene::golden::{self, PLAN, Room, Sensor, Shot, Slit, Slivers};
use microwarp_scene::light::Light;
use microwarp_scene::material::{Glossy, Material, Matte, Metal};
use microwarp_scene::scenes::slivers::Evening;
use microwarp_scene::sky::Sky;
use microwarp_scene::source::Owen;
use microwarp_scene::vector::{plus, unit};
use microwarp_scene::{
    Camera, Choice, Clear, Colour, Haze, Kit, Lamp, NoSky, Plan, Power, Quad, Random, Ray, Scene,
    Set, Source, Sphere, View, Walk,
};

/// A pixel, and the seed of its words.
fn pixel(word: u32) -> [u32; 2] {
    let [width, height] = PLAN.size;
    [
        ((word & 0xffff) * width) >> 16,
        ((word >> 16) * height) >> 16,
    ]
}

/// One sample a pixel, from words of a seed.
const fn once(seed: u32) -> Plan {
    Plan {
        samples: 1,
        seed,
        ..PLAN
    }
}

fn view<C: Shot>() -> Result<View<Poly>, Error> {
    C::view(PLAN.size)
}

#[inline(always)]
fn shot<C: Shot>(word: u32) -> [f32; 3] {
    C::pixel::<Poly, Random>(loaded(view::<C>), pixel(word), &once(word))
}

static ONE: Cdf<[u32; 1]> = ok(Cdf::new(&[1.0]));

const CAMERA: Camera = Camera {
    eye: [0.0, -3.0, 1.0],
    target: [0.0, 0.0, 0.5],
    spread: 0.4,
    lens: 0.02,
    blades: 6,
    focus: 3.0,
};

const LAMP: Lamp<Quad> = Lamp {
    shape: Quad::new([-0.5, -0.5, 2.0], [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
    radiance: [9.0; 3],
};

const ROUND: Lamp<Sphere> = Lamp {
    shape: Sphere {
        centre: [0.0, 0.0, 2.0],
        radius: 0.5,
    },
    radiance: [9.0; 3],
};

const MATTE: Matte = Matte([0.5; 3]);
const GLOSSY: Glossy = Glossy {
    ground: [0.3; 3],
    coat: 0.2,
    exponent: 50.0,
};
const METAL: Metal = Metal {
    colour: [0.8; 3],
    roughness: 0.3,
};
const HAZE: Haze = Haze {
    density: 0.1,
    albedo: 0.9,
    asymmetry: 0.5,
};

/// What a scene has of one material.
type Surfaces<M> = ([(&'static [Quad], M); 1], [(Sphere, M); 1]);

/// A ball on a floor below a lamp.
const fn scene<M: Material, L: Light, E: Sky, F: Fog>(
    surfaces: &'static Surfaces<M>,
    lights: &'static [L],
    sky: E,
    fog: F,
) -> Scene<'static, M, L, E, F> {
    Scene {
        quads: &surfaces.0,
        spheres: &surfaces.1,
        lights,
        choice: Choice::of(ONE.view()),
        sky,
        fog,
    }
}

const FLOOR: Quad = Quad::new([-2.0, -2.0, 0.0], [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0]]);
const BALL: Sphere = Sphere {
    centre: [0.0, 0.0, 0.5],
    radius: 0.5,
};

const fn of<M: Copy>(material: M) -> Surfaces<M> {
    ([(&[FLOOR], material)], [(BALL, material)])
}

/// What is sent back along a ray through the pixel's corner, without a camera.
#[inline(always)]
fn ray<S: Source>(
    scene: Scene<'_, impl Material, impl Light, impl Sky, impl Fog>,
    word: u32,
) -> [f32; 3] {
    let [column, row] = pixel(word).map(|i| i as f32 * 0.02 - 0.4);
    let ray = Ray {
        origin: CAMERA.eye,
        direction: unit([column, 1.0, row]),
    };
    scene.follow::<Poly, Power, Colour>(ray, &mut S::of_pixel(&once(word), [0; 2]))
}

fn lens() -> Result<View<Poly>, Error> {
    View::new(CAMERA, PLAN.size)
}

#[inline(always)]
fn through_lens(word: u32) -> [f32; 3] {
    let scene = scene(&const { of(MATTE) }, &[LAMP], NoSky, Clear);
    let mut source = Random::of_pixel(&once(word), [0; 2]);
    scene.sample::<Poly, Power, Colour>(loaded(lens), pixel(word), &mut source)
}

/// The light that the shortest chain finds: one step, from one of two random paths.
#[inline(always)]
fn by_chain(word: u32) -> [f32; 3] {
    let scene = scene(&const { of(MATTE) }, &[LAMP], NoSky, Clear);
    let walk = Walk {
        size: PLAN.size,
        guesses: 1,
        candidates: 2,
        steps: 1,
        seed: word,
    };
    let mut sum = [0.0; 3];
    let splat = |_, light| sum = plus(sum, light);
    let run = scene.metropolis::<Poly, Power, Colour>(loaded(lens), &walk, splat);
    run.map_or([0.0; 3], |_| sum)
}

kernels! {
    "poly_path_room" (word: u32) -> [f32; 3] = shot::<Room>(word), _ = made(view::<Room>);
    "poly_path_fog" (word: u32) -> [f32; 3] = shot::<golden::Fog>(word), _ = made(view::<golden::Fog>);
    "poly_path_slivers" (word: u32) -> [f32; 3] = shot::<Slivers>(word), _ = made(view::<Slivers>);
    "poly_path_slit" (word: u32) -> [f32; 3] = shot::<Slit>(word), _ = made(view::<Slit>);
    "poly_path_sensor" (word: u32) -> [f32; 3] = shot::<Sensor>(word), _ = made(view::<Sensor>);
    "poly_path_plain" (word: u32) -> [f32; 3] =
        ray::<Random>(scene(&const { of(MATTE) }, &[LAMP], NoSky, Clear), word);
    "poly_path_with_lens" (word: u32) -> [f32; 3] = through_lens(word), _ = made(lens);
    "poly_path_with_metropolis" (word: u32) -> [f32; 3] = by_chain(word), _ = made(lens);
    "poly_path_with_sphere" (word: u32) -> [f32; 3] =
        ray::<Random>(scene(&const { of(MATTE) }, &[ROUND], NoSky, Clear), word);
    "poly_path_with_glossy" (word: u32) -> [f32; 3] =
        ray::<Random>(scene(&const { of(GLOSSY) }, &[LAMP], NoSky, Clear), word);
    "poly_path_with_ggx" (word: u32) -> [f32; 3] =
        ray::<Random>(scene(&const { of(METAL) }, &[LAMP], NoSky, Clear), word);
    "poly_path_with_fog" (word: u32) -> [f32; 3] =
        ray::<Random>(scene(&const { of(MATTE) }, &[LAMP], NoSky, HAZE), word);
    "poly_path_with_sky" (word: u32) -> [f32; 3] =
        ray::<Random>(scene(&const { of(MATTE) }, &[LAMP], Evening, Clear), word);
    "poly_path_with_sobol" (word: u32) -> [f32; 3] =
        ray::<Set<Owen>>(scene(&const { of(MATTE) }, &[LAMP], NoSky, Clear), word);
}
