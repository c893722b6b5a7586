//! The path tracer of the example `scene` against what is known of light: energy is kept, lamps shine as their closed forms
//! say, and every way to sample finds the same. What is wrong on purpose is found out.

use host::mean::Mean;
use host::speed;
use host::twin::Forgotten;
use microwarp::constant;
use microwarp::discrete::{Cdf, LatLongMap};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::uniform::{ByPosition, Points, Sobol, grid};
use microwarp_scene::fog::{HazeLobe, Scattered};
use microwarp_scene::material::{Any, Glossy, Matte, Metal};
use microwarp_scene::scenes::{fog, room, sensor, slit, slivers};
use microwarp_scene::sky::{COLUMNS, ROWS, Table};
use microwarp_scene::source::{OfPixel, Owen, Strata};
use microwarp_scene::vector::{Vector, cross, dot, length, minus, plus, scaled, unit};
use microwarp_scene::{
    Balance, Camera, Choice, Clear, Colour, Echo, Film, Fog, Haze, Heuristic, Kit, Lamp, Light,
    LightOnly, LobeOnly, Material, NoSky, Plan, Power, Quad, Random, Ray, Scene, Set, Shape, Sky,
    Source, Sphere, View,
};
use rand_core::{Rng, TryRng};
use std::convert::Infallible;
use std::f64::consts::PI;
use std::marker::PhantomData;

static ONE: Cdf<[u32; 1]> = constant!(Cdf::new(&[1.0]));

const FLOOR: Quad = Quad::new([-4.0, -4.0, 0.0], [[8.0, 0.0, 0.0], [0.0, 8.0, 0.0]]);

/// A ray from above to a place on the floor, past what hangs over it.
fn down_to([x, y]: [f32; 2]) -> Ray {
    Ray {
        origin: [x, y, 0.3],
        direction: [0.0, 0.0, -1.0],
    }
}

/// A sky of the same radiance everywhere.
#[derive(Clone, Copy)]
struct Dome(f32);

struct Even<T>(PhantomData<T>);

impl<T: Tier> Even<T> {
    const TABLE: Table<T> = constant!(LatLongMap::new(&[[1.0; COLUMNS]; ROWS]));
}

impl Sky for Dome {
    fn radiance(&self, _: Vector) -> Vector {
        [self.0; 3]
    }

    fn table<T: Tier>(&self) -> Option<&Table<T>> {
        (self.0 > 0.0).then_some(&Even::<T>::TABLE)
    }
}

/// Pixels in a row, of so many samples.
const fn in_a_row(seed: u32, samples: u32) -> Plan {
    Plan {
        size: [u32::MAX, 1],
        samples,
        seed,
    }
}

/// The mean of what paths along a ray find, in the first channel.
fn along<K: Kit, H: Heuristic, M: Material, L: Light, E: Sky, F: Fog>(
    scene: &Scene<'_, M, L, E, F>,
    ray: Ray,
    paths: u32,
) -> Mean {
    let mut words = Random::of_pixel(&in_a_row(7, paths), [0; 2]);
    Mean::of((0..paths).map(|i| {
        words.begin(i);
        let [light, _, _] = scene.follow::<K, H, Colour>(ray, &mut words);
        f64::from(light)
    }))
}

/// The same from Sobol' points.
fn evenly<K: Kit, H: Heuristic, M: Material, L: Light, E: Sky, F: Fog>(
    scene: &Scene<'_, M, L, E, F>,
    ray: Ray,
    paths: u32,
) -> f64 {
    let mut words = Set::<Owen>::of_pixel(&in_a_row(7, paths), [0; 2]);
    let light = (0..paths).map(|i| {
        words.begin(i);
        f64::from(scene.follow::<K, H, Colour>(ray, &mut words)[0])
    });
    light.sum::<f64>() / f64::from(paths)
}

/// Standard errors by which means may be off: the chance is 6e-7 for each.
const FAR_OFF: f64 = 5.0;

fn agrees(mean: Mean, truth: f64) -> bool {
    mean.deviation(truth).abs() <= FAR_OFF
}

fn assert_agrees(what: &str, mean: Mean, truth: f64) {
    let off = mean.deviation(truth);
    println!(
        "{what}: {:.6} ± {:.6}, not {truth:.6}: {off:+.1} σ",
        mean.mean, mean.error
    );
    assert!(
        agrees(mean, truth),
        "{what}: {} is {off:+.1} σ off {truth}",
        mean.mean
    );
    // Otherwise nothing could be found out.
    assert!(
        mean.error < 0.01 * truth,
        "{what}: an error of {}",
        mean.error
    );
}

/// Each kit and heuristic finds the truth.
macro_rules! assert_agree {
    ($truth:ident == along $of:tt; $($what:literal: $kit:ty, $heuristic:ty;)+) => {$(
        assert_agrees($what, along::<$kit, $heuristic, _, _, _, _>$of, $truth);
    )+};
}

pub fn lit_by<L: Light>(lights: &[L]) -> Scene<'_, Matte, L, NoSky, Clear> {
    Scene {
        quads: &[(&[FLOOR], Matte([0.5; 3]))],
        spheres: &[],
        lights,
        choice: Choice::of(ONE.view()),
        sky: NoSky,
        fog: Clear,
    }
}

/// A ball of any stuff below an even sky.
fn furnace<M: Material, F: Fog>(
    spheres: &[(Sphere, M)],
    fog: F,
) -> Scene<'_, M, Lamp<Sphere>, Dome, F> {
    Scene {
        quads: &[],
        spheres,
        lights: &[],
        choice: Choice::of(ONE.view()),
        sky: Dome(1.0),
        fog,
    }
}

const BALL: Sphere = Sphere {
    centre: [0.0, 0.0, 1.0],
    radius: 0.5,
};

/// A ray to the ball that meets it where the angle to its normal has this sine.
fn towards_ball(sine: f32) -> Ray {
    Ray {
        origin: [0.5 * sine, -3.0, 1.0],
        direction: [0.0, 1.0, 0.0],
    }
}

fn energy_is_kept<K: Kit>() {
    let paths = speed::of("paths of the furnace", 1 << 14, 1 << 18);
    let white = Matte([1.0; 3]);
    let glossy = Glossy {
        ground: [0.6; 3],
        coat: 0.4,
        exponent: 20.0,
    };
    let kept = |what: &str, found: f64| {
        println!("{what}: {found:.6}");
        assert!((found - 1.0).abs() <= 1e-3, "{what}: {found}");
    };
    let balls = [(BALL, white)];
    for sine in [0.0, 0.7, 0.99] {
        let (scene, ray) = (furnace(&balls, Clear), towards_ball(sine));
        kept("matte", evenly::<K, Power, _, _, _, _>(&scene, ray, paths));
        kept(
            "matte, balance",
            evenly::<K, Balance, _, _, _, _>(&scene, ray, paths),
        );
        kept(
            "matte, lobes",
            evenly::<K, LobeOnly, _, _, _, _>(&scene, ray, paths),
        );
        let twice = evenly::<K, Forgotten, _, _, _, _>(&scene, ray, paths);
        assert!((twice - 1.0).abs() > 0.5, "{twice} without weights");
    }
    // Head on the lobe is above the horizon and its albedo is that of the coat.
    let balls = [(BALL, glossy)];
    let scene = furnace(&balls, Clear);
    kept(
        "glossy",
        evenly::<K, Power, _, _, _, _>(&scene, towards_ball(0.0), paths),
    );
    // Roulette adds noise to longer paths.
    let paths = 4 * paths;
    // Light goes back and forth between ball and floor, and what is left after the last bounce is less than the tolerance.
    let balls = [(
        Sphere {
            radius: 0.35,
            ..BALL
        },
        white,
    )];
    let scene = Scene {
        quads: &[(&[FLOOR], white)],
        ..furnace(&balls, Clear)
    };
    let ray = Ray {
        origin: [0.0, -3.0, 0.8],
        direction: [0.0, 1.0, 0.0],
    };
    kept(
        "ball on a floor",
        evenly::<K, Power, _, _, _, _>(&scene, ray, paths),
    );
    // Fog that absorbs nothing, of a depth of 0.4 from end to end.
    let haze = Haze {
        density: 0.004,
        albedo: 1.0,
        asymmetry: 0.6,
    };
    let balls = [(BALL, white)];
    let scene = furnace(&balls, haze);
    kept(
        "fog",
        evenly::<K, Power, _, _, _, _>(&scene, towards_ball(0.3), paths),
    );
    let loses = Haze {
        albedo: 0.9,
        ..haze
    };
    let found = evenly::<K, Power, _, _, _, _>(&furnace(&balls, loses), towards_ball(0.3), paths);
    assert!(found < 0.99, "{found} in fog that absorbs");
}

#[test]
fn a_white_furnace_keeps_its_energy() {
    energy_is_kept::<Poly>();
    energy_is_kept::<Libm>();
}

/// The albedo of white GGX metal for a view, by the formulas of textbooks and the midpoint rule over directions of light.
fn albedo(alpha: f64, sine: f64) -> f64 {
    let view = [sine, 0.0, (1.0 - sine * sine).sqrt()];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let lambda = |w: [f64; 3]| {
        let tan2 = (1.0 - w[2] * w[2]) / (w[2] * w[2]);
        0.5 * ((1.0 + alpha * alpha * tan2).sqrt() - 1.0)
    };
    let n = 500;
    let mut sum = 0.0;
    for i in 0..n {
        let z = (f64::from(i) + 0.5) / f64::from(n);
        let flat = (1.0 - z * z).sqrt();
        for j in 0..n {
            let phi = 2.0 * PI * (f64::from(j) + 0.5) / f64::from(n);
            let light = [flat * phi.cos(), flat * phi.sin(), z];
            let half: [f64; 3] = std::array::from_fn(|k| view[k] + light[k]);
            let half = half.map(|c| c / dot(half, half).sqrt());
            let cos2 = half[2] * half[2];
            let d = alpha * alpha / (PI * (cos2 * (alpha * alpha - 1.0) + 1.0).powi(2));
            sum += d / (4.0 * view[2]) / (1.0 + lambda(view) + lambda(light));
        }
    }
    sum * 2.0 * PI / f64::from(n * n)
}

#[test]
fn rough_metal_has_the_albedo_of_its_formulas() {
    let paths = speed::of("paths to metal", 1 << 14, 1 << 18);
    for roughness in [0.25, 0.5, 1.0] {
        let colour = [1.0; 3];
        let balls = [(BALL, Any::Metal(Metal { colour, roughness }))];
        for sine in [0.1_f32, 0.7, 0.95] {
            let truth = albedo(f64::from(roughness), f64::from(sine));
            let found = evenly::<Poly, Power, _, _, _, _>(
                &furnace(&balls, Clear),
                towards_ball(sine),
                paths,
            );
            println!("roughness {roughness}, sine {sine}: {found:.5}, not {truth:.5}");
            assert!(
                (found - truth).abs() <= 1e-3,
                "{roughness}, {sine}: {found} is not {truth}"
            );
        }
    }
    // Another roughness is told apart.
    assert!((albedo(0.5, 0.7) - albedo(0.6, 0.7)).abs() > 5e-3);
}

/// Lambert's irradiance of a polygon whose corners are seen from a place on the floor, of radiance 1.
fn lambert(corners: [[f64; 3]; 4]) -> f64 {
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        v.map(|c| c / length)
    };
    let corners = corners.map(unit);
    let side = |i: usize| {
        let ([a, b, c], [x, y, z]) = (corners[i], corners[(i + 1) % 4]);
        let cross = [b * z - c * y, c * x - a * z, a * y - b * x];
        let sine = cross.iter().map(|c| c * c).sum::<f64>().sqrt();
        sine.atan2(a * x + b * y + c * z) * cross[2] / sine
    };
    0.5 * (0..4).map(side).sum::<f64>().abs()
}

pub const PANEL: Quad = Quad::new([-0.6, 0.4, 1.1], [[0.1, 0.9, 0.3], [1.3, 0.0, 0.0]]);

fn panel_truth([x, y]: [f32; 2]) -> f64 {
    let ([ex, ey], corner) = (PANEL.edges(), PANEL.corner());
    let corners = [
        corner,
        plus(corner, ex),
        plus(corner, plus(ex, ey)),
        plus(corner, ey),
    ];
    let seen = corners.map(|c| minus(c, [x, y, 0.0]).map(f64::from));
    0.5 / PI * lambert(seen)
}

/// A quadrilateral that is sampled by area, with the density of that per steradian or, wrongly, per square metre.
#[derive(Clone, Copy)]
struct ByArea<const RIGHT: bool>(Quad);

impl<const RIGHT: bool> Shape for ByArea<RIGHT> {
    fn hit(&self, ray: Ray, within: f32) -> Option<f32> {
        self.0.hit(ray, within)
    }

    fn normal(&self, place: Vector) -> Vector {
        self.0.normal(place)
    }

    fn draw<K: Kit>(&self, from: Vector, words: &mut impl Rng) -> Option<(Vector, f32)> {
        let [ex, ey] = self.0.edges();
        let there = plus(scaled(ex, grid(words)), scaled(ey, grid(words)));
        let direction = unit(minus(plus(self.0.corner(), there), from));
        Some((direction, self.pdf::<K>(from, direction)))
    }

    fn pdf<K: Kit>(&self, from: Vector, direction: Vector) -> f32 {
        let [ex, ey] = self.0.edges();
        let normal = cross(ex, ey);
        let area = length(normal);
        let origin = from;
        let way = self.0.hit(Ray { origin, direction }, 100.0).unwrap_or(0.0);
        let jacobian = way * way / dot(scaled(normal, 1.0 / area), direction).abs();
        if RIGHT { jacobian / area } else { 1.0 / area }
    }
}

impl<const RIGHT: bool> Light for ByArea<RIGHT> {
    type Shape = Self;

    fn shape(&self) -> &Self {
        self
    }

    fn radiance(&self) -> Vector {
        [1.0; 3]
    }

    fn middle(&self) -> Vector {
        self.0.corner()
    }
}

#[test]
fn a_panel_shines_as_lambert_says() {
    let paths = speed::of("paths to a panel", 40_000, 1_000_000);
    for place in [[0.0, 0.0], [0.5, 1.0], [-1.5, 2.0]] {
        let (ray, truth) = (down_to(place), panel_truth(place));
        let lights = [Lamp {
            shape: PANEL,
            radiance: [1.0; 3],
        }];
        let scene = lit_by(&lights);
        assert_agree! {
            truth == along(&scene, ray, paths);
            "power": Poly, Power;
            "libm": Libm, Power;
            "balance": Poly, Balance;
            "light": Poly, LightOnly;
        }
        let mean = along::<Poly, LobeOnly, _, _, _, _>(&scene, ray, 10 * paths);
        assert_agrees("lobe", mean, truth);
        // By area, which is right with its Jacobian.
        let lights = [ByArea::<true>(PANEL)];
        let mean = along::<Poly, Power, _, _, _, _>(&lit_by(&lights), ray, paths);
        assert_agrees("area", mean, truth);
        // Wrong on purpose.
        let lights = [ByArea::<false>(PANEL)];
        let mean = along::<Poly, LightOnly, _, _, _, _>(&lit_by(&lights), ray, paths);
        assert!(
            !agrees(mean, truth),
            "{} passes without a Jacobian",
            mean.mean
        );
        let mean = along::<Poly, Power, _, _, _, _>(&lit_by(&lights), ray, paths);
        assert!(
            !agrees(mean, truth),
            "{} passes with a density of area",
            mean.mean
        );
        let mean = along::<Poly, Forgotten, _, _, _, _>(&scene, ray, paths);
        assert!(!agrees(mean, truth), "{} passes without weights", mean.mean);
    }
}

#[test]
fn a_ball_of_light_shines_as_its_closed_form_says() {
    let paths = speed::of("paths to a ball", 40_000, 1_000_000);
    for (centre, radius) in [
        ([0.3, 0.4, 2.0], 0.5),
        ([1.5, 0.0, 1.0], 0.2),
        ([0.0, 0.0, 1.0], 0.6),
    ] {
        let lights = [Lamp {
            shape: Sphere { centre, radius },
            radiance: [1.0; 3],
        }];
        let [x, y, z] = centre.map(f64::from);
        let square = x * x + y * y + z * z;
        let truth = 0.5 * f64::from(radius).powi(2) / square * z / square.sqrt();
        let (scene, ray) = (lit_by(&lights), down_to([0.0, 0.0]));
        assert_agree! {
            truth == along(&scene, ray, paths);
            "power": Poly, Power;
            "light": Libm, LightOnly;
        }
        let mean = along::<Poly, Forgotten, _, _, _, _>(&scene, ray, paths);
        assert!(!agrees(mean, truth), "{} passes without weights", mean.mean);
        let mean = along::<Poly, Power, _, _, _, _>(&scene, ray, paths);
        assert!(!agrees(mean, truth * 1.05), "5 % pass");
    }
}

/// The light of a lamp of radiance 1 that fog scatters once into a ray, over the albedo: Simpson's rule along the ray, midpoints
/// over the directions to the lamp.
fn scattered_once(ray: Ray, way: f64, lamp: Sphere, haze: Haze) -> f64 {
    let [density, g] = [haze.density, haze.asymmetry].map(f64::from);
    let at = |t: f64| {
        let to: [f64; 3] = std::array::from_fn(|k| {
            f64::from(lamp.centre[k]) - f64::from(ray.origin[k]) - t * f64::from(ray.direction[k])
        });
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let square = dot(to, to);
        let (distance, radius) = (square.sqrt(), f64::from(lamp.radius));
        let axis = to.map(|c| c / distance);
        let forward = dot(axis, ray.direction.map(f64::from));
        let sideways = (1.0 - forward * forward).max(0.0).sqrt();
        let rim = 1.0 - (1.0 - radius * radius / square).sqrt();
        let n = 24;
        let mut sum = 0.0;
        for i in 0..n {
            let cos = 1.0 - rim * (f64::from(i) + 0.5) / f64::from(n);
            let sin = (1.0 - cos * cos).sqrt();
            let near = distance * cos - (radius * radius - square * sin * sin).sqrt();
            for j in 0..n {
                let turn = 2.0 * PI * (f64::from(j) + 0.5) / f64::from(n);
                let cosine = forward * cos + sideways * sin * turn.cos();
                let phase = (1.0 - g * g) / (4.0 * PI * (1.0 + g * g - 2.0 * g * cosine).powf(1.5));
                sum += phase * (-density * near).exp();
            }
        }
        density * (-density * t).exp() * 2.0 * PI * rim * sum / f64::from(n * n)
    };
    let steps = 2000;
    let h = way / f64::from(steps);
    let weight = |i| match i {
        i if i == 0 || i == steps => 1.0,
        i if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=steps)
        .map(|i| weight(i) * at(h * f64::from(i)))
        .sum::<f64>()
        * h
        / 3.0
}

/// Fog whose places are drawn by two laws and weighed by one of them.
#[derive(Clone, Copy)]
struct Unweighed(Haze);

impl Fog for Unweighed {
    fn passed<K: Kit>(&self, way: f32) -> f32 {
        self.0.passed::<K>(way)
    }

    fn scattered<K: Kit, L: Light>(
        &self,
        ray: Ray,
        way: f32,
        lights: (&[L], &Choice<'_>),
        words: &mut impl Rng,
    ) -> Option<Scattered> {
        let there = self.0.scattered::<K, L>(ray, way, lights, words)?;
        let weight = self.0.albedo;
        Some(Scattered { weight, ..there })
    }

    type Lobe<K: Kit> = HazeLobe<K>;

    fn phase<K: Kit>(&self, direction: Vector) -> Option<HazeLobe<K>> {
        self.0.phase::<K>(direction)
    }
}

#[test]
fn fog_scatters_as_a_quadrature_says() {
    let paths = speed::of("paths through fog", 60_000, 1_000_000);
    let ray = Ray {
        origin: [0.0, -3.0, 1.0],
        direction: [0.0, 1.0, 0.0],
    };
    let lamp = Sphere {
        centre: [0.3, 0.5, 1.4],
        radius: 0.1,
    };
    let lights = [Lamp {
        shape: lamp,
        radiance: [1.0; 3],
    }];
    // A black wall is the end of the ray.
    let wall = Quad::new([-9.0, 3.0, -9.0], [[18.0, 0.0, 0.0], [0.0, 0.0, 18.0]]);
    for asymmetry in [0.0, 0.6] {
        // Of so small an albedo that nothing is scattered twice, but for a part in ten thousand.
        let haze = Haze {
            density: 0.2,
            albedo: 1e-4,
            asymmetry,
        };
        let truth = 1e-4 * scattered_once(ray, 6.0, lamp, haze);
        let quads: &[(&[Quad], Matte)] = &[(&[wall], Matte([0.0; 3]))];
        let scene = Scene {
            quads,
            spheres: &[],
            lights: &lights,
            choice: Choice::of(ONE.view()),
            sky: NoSky,
            fog: haze,
        };
        assert_agree! {
            truth == along(&scene, ray, paths);
            "fog": Poly, Power;
            "fog, libm": Libm, LightOnly;
        }
        let wrong = Scene {
            quads,
            spheres: &[],
            lights: &lights,
            choice: Choice::of(ONE.view()),
            sky: NoSky,
            fog: Unweighed(haze),
        };
        let mean = along::<Poly, Power, _, _, _, _>(&wrong, ray, paths);
        assert!(
            !agrees(mean, truth),
            "{} passes with the weight of one law",
            mean.mean
        );
    }
}

/// The mean of all pixels of a picture, one path each from places all over it.
fn picture<K: Kit, H: Heuristic, S: Source, P: Film, M: Material, L: Light, E: Sky, F: Fog>(
    (scene, camera): (&Scene<'_, M, L, E, F>, Camera),
    side: u32,
) -> Mean {
    let view = View::<K>::new(camera, [side, side]).unwrap();
    Mean::of((0..side * side).map(|pixel| {
        let mut words = S::of_pixel(&in_a_row(3, 1), [pixel, 0]);
        words.begin(0);
        let light = scene.sample::<K, H, P>(&view, [pixel % side, pixel / side], &mut words);
        assert!(
            light.iter().all(|c| *c >= 0.0 && c.is_finite()),
            "{light:?} at {pixel}"
        );
        light.iter().map(|c| f64::from(*c)).sum()
    }))
}

/// How many standard errors of both two means are apart.
fn apart(a: Mean, b: Mean) -> f64 {
    ((a.mean - b.mean) / a.error.hypot(b.error)).abs()
}

#[test]
fn light_only_lobe_only_and_both_agree_in_the_room() {
    let side = speed::of("columns of the room", 160, 700);
    let room = (&room::SCENE, room::CAMERA);
    let both = picture::<Poly, Power, Random, Colour, _, _, _, _>(room, side);
    let others = [
        picture::<Poly, Balance, Set<ByPosition>, Colour, _, _, _, _>(room, side),
        picture::<Libm, LightOnly, Set<Strata>, Colour, _, _, _, _>(room, side),
        picture::<Poly, LobeOnly, Set<Owen>, Colour, _, _, _, _>(room, side),
    ];
    for other in others {
        println!(
            "{:.4} ± {:.4}, {:.4} ± {:.4}",
            both.mean, both.error, other.mean, other.error
        );
        assert!(
            apart(both, other) <= FAR_OFF,
            "{} is not {}",
            both.mean,
            other.mean
        );
    }
    let wrong = picture::<Poly, Forgotten, Random, Colour, _, _, _, _>(room, side);
    assert!(
        apart(both, wrong) > FAR_OFF,
        "{} passes without weights",
        wrong.mean
    );
}

/// The same word for ever.
struct Stuck<const WORD: u32>;

impl<const WORD: u32> TryRng for Stuck<WORD> {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok(WORD)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(u64::from(WORD) << 32 | u64::from(WORD))
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        bytes.fill(WORD as u8);
        Ok(())
    }
}

impl<const WORD: u32> Source for Stuck<WORD> {
    fn of_pixel(_: &Plan, _: [u32; 2]) -> Self {
        Self
    }

    fn begin(&mut self, _: u32) {}

    fn skip_to(&mut self, _: u32) {}
}

/// Every number is checked by `picture`.
#[test]
fn no_words_make_light_that_is_none() {
    fn all<P: Film, M: Material, L: Light, E: Sky, F: Fog>(
        scene: &Scene<'_, M, L, E, F>,
        camera: Camera,
    ) {
        let scene = (scene, camera);
        let means = [
            picture::<Poly, Power, Random, P, _, _, _, _>(scene, 96),
            picture::<Libm, Power, Set<Owen>, P, _, _, _, _>(scene, 96),
            picture::<Poly, Power, Set<Strata>, P, _, _, _, _>(scene, 48),
        ];
        assert!(means.iter().all(|mean| mean.mean > 0.0));
        picture::<Poly, Power, Stuck<0>, P, _, _, _, _>(scene, 48);
        picture::<Libm, Power, Stuck<{ u32::MAX }>, P, _, _, _, _>(scene, 48);
        picture::<Poly, Power, Stuck<{ 1 << 31 }>, P, _, _, _, _>(scene, 48);
    }
    all::<Colour, _, _, _, _>(&room::SCENE, room::CAMERA);
    all::<Colour, _, _, _, _>(&fog::SCENE, fog::CAMERA);
    all::<Colour, _, _, _, _>(&slivers::SCENE, slivers::CAMERA);
    all::<Colour, _, _, _, _>(&slit::SCENE, slit::CAMERA);
    all::<Echo, _, _, _, _>(&sensor::SCENE, sensor::CAMERA);
}

#[test]
fn scenes_without_light_are_black() {
    fn black<M: Material, L: Light, E: Sky, F: Fog>(scene: &Scene<'_, M, L, E, F>, camera: Camera) {
        let mean = picture::<Poly, Power, Random, Colour, _, _, _, _>((scene, camera), 32);
        assert!(mean.mean == 0.0, "{}", mean.mean);
    }
    let choice = Choice::NONE;
    // No light, with and without fog.
    black(
        &Scene {
            lights: &[],
            choice,
            ..room::SCENE
        },
        room::CAMERA,
    );
    black(
        &Scene {
            lights: &[],
            choice,
            ..fog::SCENE
        },
        fog::CAMERA,
    );
    // No light, but a table that chooses one.
    black(
        &Scene {
            lights: &[],
            ..room::SCENE
        },
        room::CAMERA,
    );
    // A black sky.
    let dark = furnace::<Matte, Clear>(&[], Clear);
    black(
        &Scene {
            sky: Dome(0.0),
            ..dark
        },
        slivers::CAMERA,
    );
    // Lights of no area.
    let line = Quad::new([0.0, 1.0, 1.5], [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    let point = Quad::new([0.0, 1.0, 1.5], [[0.0; 3]; 2]);
    let lights = [line, point].map(|shape| Lamp {
        shape,
        radiance: [9.0; 3],
    });
    black(
        &Scene {
            lights: &lights,
            ..room::SCENE
        },
        room::CAMERA,
    );
    let point = Sphere {
        centre: [0.0, 0.0, 1.0],
        radius: 0.0,
    };
    let radiance = [9.0; 3];
    let lights = [Lamp {
        shape: point,
        radiance,
    }; 3];
    black(
        &Scene {
            lights: &lights,
            ..fog::SCENE
        },
        fog::CAMERA,
    );
    // Lamps that send out nothing.
    let lights = room::SCENE.lights;
    let lights = [0, 1].map(|i| Lamp {
        radiance: [0.0; 3],
        ..lights[i]
    });
    black(
        &Scene {
            lights: &lights,
            ..room::SCENE
        },
        room::CAMERA,
    );
    // Cameras that see nothing are refused.
    let (eye, target) = ([0.0; 3], [0.0, 0.0, 1.0]);
    let up = Camera {
        eye,
        target,
        ..room::CAMERA
    };
    assert!(View::<Poly>::new(up, [8, 8]).is_err());
    assert!(View::<Poly>::new(room::CAMERA, [0, 8]).is_err());
}

/// The strata of a pair of dimensions that points of a source have met.
fn met<S: Source>(dimension: u32, columns: u32) -> usize {
    let mut words = S::of_pixel(&in_a_row(5, columns * columns), [9, 0]);
    let cells = (0..columns * columns).map(|i| {
        words.begin(i);
        words.skip_to(dimension);
        [0, 1].map(|_| (grid(&mut words) * columns as f32) as u32)
    });
    cells.collect::<std::collections::BTreeSet<_>>().len()
}

#[test]
fn strata_are_met_once_in_each_pair_of_dimensions() {
    for pair in [0, 2, 4, 30] {
        assert_eq!(met::<Set<Strata>>(pair, 8), 64);
        // Of a number that is no power of two, too.
        assert_eq!(met::<Set<Strata>>(pair, 6), 36);
        assert!(met::<Set<ByPosition>>(pair, 8) < 60);
    }
    assert_eq!(met::<Set<Owen>>(0, 8), 64);
}

/// The most that the halves of two dimensions are tied together, of all pairs among the first twelve: the mean square of
/// the correlation of their highest bits over 64 samples of a pixel, for many pixels. Independent ones have 1/64.
fn tied<S: Source>() -> f64 {
    const DIMENSIONS: usize = 12;
    const PIXELS: u32 = 1000;
    let mut squares = [[0.0; DIMENSIONS]; DIMENSIONS];
    for pixel in 0..PIXELS {
        let mut words = S::of_pixel(&in_a_row(3, 64), [pixel, 0]);
        let mut sums = [[0.0_f64; DIMENSIONS]; DIMENSIONS];
        for sample in 0..64 {
            words.begin(sample);
            let signs: [f64; DIMENSIONS] = std::array::from_fn(|_| {
                if words.next_u32() >> 31 == 0 {
                    1.0
                } else {
                    -1.0
                }
            });
            for (i, row) in sums.iter_mut().enumerate() {
                (0..i).for_each(|k| row[k] += signs[i] * signs[k] / 64.0);
            }
        }
        for (squares, sums) in squares
            .as_flattened_mut()
            .iter_mut()
            .zip(sums.as_flattened())
        {
            *squares += sums * sums / f64::from(PIXELS);
        }
    }
    squares.as_flattened().iter().copied().fold(0.0, f64::max)
}

/// Strata whose orders are not shuffled first.
#[derive(Clone, Copy)]
struct Unshuffled(u32);

impl Points for Unshuffled {
    fn word(self, index: u32, dimension: u32) -> u32 {
        let seed = ByPosition::new(self.0, 0).word(0, dimension);
        Sobol::<1>::new(seed).unwrap().word(index, 0)
    }
}

impl OfPixel for Unshuffled {
    fn of_pixel(plan: &Plan, pixel: [u32; 2]) -> Self {
        Self(ByPosition::of_pixel(plan, pixel).word(0, 0))
    }
}

/// Independent points have 1/64. Sobol' points have 2/64 between two groups, since their order is shuffled so that samples
/// `2i` and `2i + 1` stay together. A mean of 1,000 squares of a nearly normal number has a standard error of 4.5 %; eight of
/// these are allowed, over 66 pairs of dimensions.
#[test]
fn dimensions_of_a_source_are_independent() {
    const MOST: f64 = 1.36;
    for (name, tied, expected) in [
        ("random", tied::<Random>(), 1.0),
        ("by position", tied::<Set<ByPosition>>(), 1.0),
        ("strata", tied::<Set<Strata>>(), 1.0),
        ("Sobol'", tied::<Set<Owen>>(), 2.0),
    ] {
        let tied = 64.0 * tied;
        println!("{name}: {tied:.3} of 1/64");
        assert!(tied <= MOST * expected, "{name}: {tied}");
    }
    let control = 64.0 * tied::<Set<Unshuffled>>();
    assert!(
        control > 2.0 * MOST,
        "orders that are not shuffled: {control}"
    );
}
