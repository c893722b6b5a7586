//! The path tracer of `crates/scene` once more: in `f64`, by the formulas of textbooks, with no sampler of the crate.
//!
//! It reads the constants of the same scenes and the words of the same points in the same dimensions, and maps them in the same
//! way. A path of the twin is therefore the path of the core as it would be without rounding, and the difference of both is
//! the error of the core, without noise.

mod model;
mod samplers;
mod sky;

pub use model::{Air, Form, Record, Source64, Stuff};
pub use sky::Heaven;

use self::model::wide;
use self::samplers::{
    EquiAngular, free, free_pdf, grid, middle, minus, mix, plus, polygon, scaled, tent, unit,
};
use self::sky::Entries;
use self::sky::{Place, power};
use crate::truth::{Point, cross, dot};
use microwarp_scene::path::{BOUNCES, FAR, FOG, LIGHT, LOBE, PER_BOUNCE, PLACE, ROULETTE};
use microwarp_scene::path::{Heuristic, ROULETTE_WORD};
use microwarp_scene::shape::STEP;
use microwarp_scene::{Camera, Scene, Source, camera};

/// No weights, an error on purpose: light that two techniques find counts twice.
pub struct Forgotten;

impl Heuristic for Forgotten {
    fn light(_: f32, _: f32) -> f32 {
        1.0
    }
}

/// A scene with its camera.
pub struct Twin {
    things: Vec<(Form, Stuff)>,
    lights: Vec<Source64>,
    choice: Entries,
    sky: Heaven,
    air: Air,
    camera: Camera,
    size: [u32; 2],
}

/// What a ray meets.
enum Met {
    /// A light by its index, and what it sends back; the sky is the last one.
    Light(usize, Point),
    Surface(Point, Stuff),
}

fn largest(light: Point) -> f64 {
    light.into_iter().fold(0.0, f64::max)
}

fn times(p: Point, q: Point) -> Point {
    std::array::from_fn(|k| p[k] * q[k])
}

impl Twin {
    pub fn new<M: Copy, L: Copy, E: Copy, F: Copy>(
        scene: &Scene<'_, M, L, E, F>,
        camera: Camera,
        size: [u32; 2],
    ) -> Self
    where
        Stuff: From<M>,
        Source64: From<L>,
        Heaven: From<E>,
        Air: From<F>,
    {
        let quads = scene.quads.iter().flat_map(|(quads, stuff)| {
            let form = |quad| (Form::from(quad), Stuff::from(*stuff));
            quads.iter().copied().map(form)
        });
        let balls = scene
            .spheres
            .iter()
            .map(|(ball, stuff)| ((*ball).into(), (*stuff).into()));
        Self {
            things: quads.chain(balls).collect(),
            lights: scene.lights.iter().map(|light| (*light).into()).collect(),
            choice: scene
                .choice
                .table()
                .map_or_else(Entries::default, |table| Entries::of(*table)),
            sky: scene.sky.into(),
            air: scene.fog.into(),
            camera,
            size,
        }
    }

    /// The light of one path through a pixel.
    pub fn sample<P: Record>(&self, [column, row]: [u32; 2], source: &mut impl Source) -> Point {
        let (camera, [width, height]) = (&self.camera, self.size.map(f64::from));
        source.skip_to(0);
        let [x, y] = [column, row].map(|i| f64::from(i) + 0.5 + tent(fold(source.next_u32())));
        let lens = polygon(camera.blades, pair(source)).map(|c| c * f64::from(camera.lens));
        let eye = wide(camera.eye);
        let ahead = unit(minus(wide(camera.target), eye));
        let across = unit(cross(ahead, [0.0, 0.0, 1.0]));
        let place = |right: f64, up: f64, far: f64| {
            plus(
                mix(across, right, cross(across, ahead), up),
                scaled(ahead, far),
            )
        };
        let focus = f64::from(camera.focus);
        let size = 2.0 * f64::from(camera.spread) / width * focus;
        let sharp = place((x - 0.5 * width) * size, (0.5 * height - y) * size, focus);
        let off = place(lens[0], lens[1], 0.0);
        self.follow::<P>(plus(eye, off), unit(minus(sharp, off)), source)
    }

    fn meet(&self, from: Point, along: Point) -> (f64, Met) {
        let (mut way, mut met) = (f64::from(FAR), None);
        let step = f64::from(STEP);
        for (form, stuff) in &self.things {
            if let Some(t) = form.hit(from, along, [step, way]) {
                (way, met) = (
                    t,
                    Some(Met::Surface(form.normal(mix(from, 1.0, along, t)), *stuff)),
                );
            }
        }
        for (index, Source64 { form, radiance }) in self.lights.iter().enumerate() {
            if let Some(t) = form.hit(from, along, [step, way]) {
                let outside = dot(form.normal(mix(from, 1.0, along, t)), along) < 0.0;
                let sent = if outside { *radiance } else { [0.0; 3] };
                (way, met) = (t, Some(Met::Light(index, sent)));
            }
        }
        let sky = || Met::Light(self.lights.len(), self.sky.radiance(along));
        (way, met.unwrap_or_else(sky))
    }

    /// The density with which a direction is drawn to a light that it meets.
    fn light_pdf(&self, index: usize, from: Point, along: Point) -> f64 {
        let pdf = match self.lights.get(index) {
            Some(light) => light
                .form
                .towards(from, [0.5; 2])
                .map_or(0.0, |(_, pdf)| pdf),
            None => self.sky.pdf(along),
        };
        self.choice.probability(index) * pdf
    }

    /// Where a ray is scattered by fog: how far, by what its light is multiplied, and for which light.
    fn scattered(
        &self,
        (from, along, way): (Point, Point, f64),
        source: &mut impl Source,
    ) -> Option<(f64, f64, Option<usize>)> {
        let Air {
            density, albedo, ..
        } = self.air;
        let words = -(-density * way).exp_m1() * 4_294_967_296.0;
        if density == 0.0 || f64::from(source.next_u32()) >= words {
            return None;
        }
        let by_light = grid(source.next_u32()) < 0.5;
        let chosen = self
            .choice
            .choose(source.next_u32())
            .map(|(index, _)| index);
        let word = source.next_u32();
        let Some(light) = chosen.and_then(|index| self.lights.get(index)) else {
            return Some((free(density, way, middle(word)), albedo, chosen));
        };
        let seen = EquiAngular::new(from, along, light.form.middle(), way);
        let there = if by_light {
            seen.sample(grid(word))
        } else {
            free(density, way, middle(word))
        };
        let (own, other) = (free_pdf(density, way, there), seen.pdf(there));
        Some((there, albedo * own / (0.5 * own + 0.5 * other), chosen))
    }

    fn follow<P: Record>(
        &self,
        mut from: Point,
        mut along: Point,
        source: &mut impl Source,
    ) -> Point {
        let (mut sum, mut light, mut gone) = ([0.0; 3], [1.0; 3], 0.0);
        // The density by which the ray was drawn; none from the eye.
        let mut drawn = None;
        for bounce in 0..BOUNCES {
            let first = camera::DIMENSIONS + bounce * PER_BOUNCE;
            let (way, met) = self.meet(from, along);
            source.skip_to(first + FOG);
            let (at, place, chosen) = match self.scattered((from, along, way), source) {
                Some((there, weight, chosen)) => {
                    light = scaled(light, weight);
                    gone += there;
                    (
                        mix(from, 1.0, along, there),
                        Place::fog(along, &self.air),
                        chosen,
                    )
                }
                None => {
                    gone += way;
                    match met {
                        Met::Light(index, radiance) => {
                            let weight = drawn
                                .map_or(1.0, |own| power(own, self.light_pdf(index, from, along)));
                            P::record(&mut sum, times(light, scaled(radiance, weight)), gone);
                            return sum;
                        }
                        Met::Surface(normal, stuff) => {
                            let front = dot(normal, along) < 0.0;
                            let normal = scaled(normal, if front { 1.0 } else { -1.0 });
                            let hit = mix(from, 1.0, along, way);
                            let off = mix(hit, 1.0, normal, f64::from(STEP));
                            (
                                off,
                                Place::surface(normal, scaled(along, -1.0), stuff),
                                None,
                            )
                        }
                    }
                }
            };
            source.skip_to(first + LIGHT);
            let chosen = chosen.or_else(|| Some(self.choice.choose(source.next_u32())?.0));
            source.skip_to(first + PLACE);
            if let Some((found, way)) = chosen.and_then(|i| self.lit(at, &place, i, source)) {
                P::record(&mut sum, times(light, found), gone + way);
            }
            source.skip_to(first + LOBE);
            let Some((next, value, pdf)) = place.draw(source) else {
                return sum;
            };
            light = times(light, scaled(value, 1.0 / pdf));
            if bounce >= ROULETTE {
                source.skip_to(first + ROULETTE_WORD);
                let chance = largest(light).min(f64::from(0.95_f32));
                if grid(source.next_u32()) >= chance {
                    return sum;
                }
                light = scaled(light, 1.0 / chance);
            }
            (from, along, drawn) = (at, next, Some(pdf));
        }
        sum
    }

    /// The light that a place scatters from one light.
    fn lit(
        &self,
        at: Point,
        place: &Place,
        index: usize,
        source: &mut impl Source,
    ) -> Option<(Point, f64)> {
        let words = [(); 2].map(|()| source.next_u32());
        let (along, pdf) = match self.lights.get(index) {
            Some(light) => light.form.towards(at, words.map(grid))?,
            None => self.sky.sample(words)?,
        };
        let pdf = self.choice.probability(index) * pdf;
        let (value, other) = place.weigh(along);
        let (way, met) = self.meet(at, along);
        let Met::Light(met, radiance) = met else {
            return None;
        };
        let passed = (-self.air.density * way).exp();
        let weight = power(pdf, other) * passed / pdf;
        (met == index).then(|| (times(value, scaled(radiance, weight)), way))
    }
}

fn pair(source: &mut impl Source) -> [f64; 2] {
    [(); 2].map(|()| grid(source.next_u32()))
}

/// The uniform of a word of a law with two tails: the middle of the words.
fn fold(word: u32) -> f64 {
    (f64::from(word) + 0.5) / 4_294_967_296.0
}
