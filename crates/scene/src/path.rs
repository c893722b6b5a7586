//! The path of light, from the eye back to a lamp.

use crate::camera::{DIMENSIONS, View};
use crate::film::Film;
use crate::fog::Fog;
use crate::kit::Kit;
use crate::light::{Choice, Light};
use crate::material::{Bounce, Lobe, Material};
use crate::shape::{Quad, Ray, STEP, Shape, Sphere};
use crate::sky::Sky;
use crate::source::Source;
use crate::vector::{Vector, dot, largest, plus, scaled, times};
use microwarp::Warp;
use microwarp::estimate::{balance_heuristic, power_heuristic, roulette};
use microwarp::warp::Frame;
use rand_core::Rng;

/// The most bounces of a path, by surfaces and by fog. Light that takes more is lost.
pub const BOUNCES: u32 = 8;

/// From this bounce on a path ends by Russian roulette.
pub const ROULETTE: u32 = 2;

/// How far rays go that hit nothing.
pub const FAR: f32 = 100.0;

/// The dimensions of a bounce: two for the place on the light, one for which light, one for roulette, two for the lobe and two
/// that are spare, four for the fog. What is two-dimensional begins at an even one, since points come in pairs. With those of the camera the first
/// eight end with roulette, so that what a picture sees first is in one group.
pub const PER_BOUNCE: u32 = 12;
pub const PLACE: u32 = 0;
pub const LIGHT: u32 = 2;
pub const ROULETTE_WORD: u32 = 3;
pub const LOBE: u32 = 4;
pub const FOG: u32 = 8;

/// All numbers that a path takes.
pub const NUMBERS: usize = DIMENSIONS.wrapping_add(BOUNCES.wrapping_mul(PER_BOUNCE)) as usize;

/// How samples of lights and of lobes are weighed together.
pub trait Heuristic {
    /// The weight of a sample of density `own`, where the other technique has density `other`.
    fn light(own: f32, other: f32) -> f32;

    #[inline]
    fn lobe(own: f32, other: f32) -> f32 {
        Self::light(own, other)
    }
}

/// Multiple importance sampling by the balance heuristic.
pub struct Balance;

impl Heuristic for Balance {
    #[inline]
    fn light(own: f32, other: f32) -> f32 {
        balance_heuristic(1, own, 1, other)
    }
}

/// Multiple importance sampling by the power heuristic.
pub struct Power;

impl Heuristic for Power {
    #[inline]
    fn light(own: f32, other: f32) -> f32 {
        power_heuristic(1, own, 1, other)
    }
}

/// Directions are drawn to lights alone: all of the light that they send is found by that.
pub struct LightOnly;

impl Heuristic for LightOnly {
    #[inline]
    fn light(_: f32, _: f32) -> f32 {
        1.0
    }

    #[inline]
    fn lobe(_: f32, _: f32) -> f32 {
        0.0
    }
}

/// Lights are met by chance.
pub struct LobeOnly;

impl Heuristic for LobeOnly {
    #[inline]
    fn light(_: f32, _: f32) -> f32 {
        0.0
    }

    #[inline]
    fn lobe(_: f32, _: f32) -> f32 {
        1.0
    }
}

/// What a picture is taken of: shapes with what they are made of, lights, and how one of them is chosen.
#[derive(Clone, Copy)]
pub struct Scene<'a, M, L, E, F> {
    pub quads: &'a [(&'a [Quad], M)],
    pub spheres: &'a [(Sphere, M)],
    pub lights: &'a [L],
    pub choice: Choice<'a>,
    pub sky: E,
    pub fog: F,
}

/// What a ray meets first.
pub(crate) enum Met<M> {
    Nothing,
    /// A light, by its index, and whether on its outer side.
    Light(usize, bool),
    Surface(Vector, M),
}

/// A place where light is scattered, with the directions that are drawn there.
enum Vertex<K: Kit, M: Material, F: Fog> {
    Surface(Frame, M::Lobe<K>),
    Fog(F::Lobe<K>),
}

impl<K: Kit, M: Material, F: Fog> Vertex<K, M, F> {
    /// Value and density of a direction of the world.
    #[inline]
    fn weigh(&self, direction: Vector) -> (Vector, f32) {
        match self {
            Self::Surface(frame, lobe) => lobe.weigh(frame.to_local(direction)),
            Self::Fog(phase) => phase.weigh(direction),
        }
    }

    #[inline]
    fn draw(&self, words: &mut impl Rng) -> Option<Bounce> {
        match self {
            Self::Surface(frame, lobe) => {
                let local = lobe.draw(words)?;
                let direction = frame.to_world(local.direction);
                Some(Bounce { direction, ..local })
            }
            Self::Fog(phase) => phase.draw(words),
        }
    }
}

/// Where light leaves a surface that a ray has met, the frame there, and the law of directions.
#[inline]
pub(crate) fn leave<K: Kit, M: Material>(
    ray: Ray,
    way: f32,
    normal: Vector,
    material: &M,
) -> Option<(Vector, Frame, M::Lobe<K>)> {
    let front = dot(normal, ray.direction) < 0.0;
    let frame = Frame::new(if front { normal } else { scaled(normal, -1.0) }).ok()?;
    // Next to the horizon, rounding may take the view below it.
    let [x, y, z] = frame.to_local(scaled(ray.direction, -1.0));
    let lobe = material
        .seen::<K>([x, y, if z > 0.0 { z } else { 0.0 }])
        .ok()?;
    // What leaves, leaves on the side that was met.
    let off = scaled(frame.normal(), STEP);
    Some((plus(ray.at(way), off), frame, lobe))
}

impl<M: Material, L: Light, E: Sky, F: Fog> Scene<'_, M, L, E, F> {
    /// The first thing that a ray meets, and how far away.
    pub(crate) fn meet(&self, ray: Ray) -> (f32, Met<M>) {
        let (mut way, mut met) = (FAR, Met::Nothing);
        for (quads, material) in self.quads {
            for quad in *quads {
                if let Some(t) = quad.hit(ray, way) {
                    (way, met) = (t, Met::Surface(quad.normal(ray.at(t)), *material));
                }
            }
        }
        for (sphere, material) in self.spheres {
            if let Some(t) = sphere.hit(ray, way) {
                (way, met) = (t, Met::Surface(sphere.normal(ray.at(t)), *material));
            }
        }
        for (index, light) in self.lights.iter().enumerate() {
            if let Some(t) = light.shape().hit(ray, way) {
                let outside = dot(light.shape().normal(ray.at(t)), ray.direction) < 0.0;
                (way, met) = (t, Met::Light(index, outside));
            }
        }
        (way, met)
    }

    /// The index of the sky among the lights.
    #[inline]
    fn sky_index(&self) -> usize {
        self.lights.len()
    }

    /// What a light sends along a ray that has met it, and the index of the light.
    fn shine(&self, met: &Met<M>, direction: Vector) -> Option<(Vector, usize)> {
        match met {
            Met::Surface(..) => None,
            Met::Nothing => Some((self.sky.radiance(direction), self.sky_index())),
            Met::Light(index, outside) => {
                let light = self.lights.get(*index).filter(|_| *outside)?;
                Some((light.radiance(), *index))
            }
        }
    }

    /// The density with which a direction that meets a light is drawn to it.
    fn light_pdf<K: Kit>(&self, index: usize, from: Vector, direction: Vector) -> f32 {
        let pdf = match self.lights.get(index) {
            Some(light) => light.shape().pdf::<K>(from, direction),
            None => self
                .sky
                .table::<K::Tier>()
                .map_or(0.0, |sky| sky.pdf(direction)),
        };
        self.choice.pmf(index) * pdf
    }

    /// A direction to a light or to the sky, and its density.
    fn draw_light<K: Kit>(
        &self,
        index: usize,
        from: Vector,
        words: &mut impl Rng,
    ) -> Option<(Vector, f32)> {
        match self.lights.get(index) {
            Some(light) => light.shape().draw::<K>(from, words),
            None => Some(self.sky.table::<K::Tier>()?.draw_with_pdf(words)),
        }
    }

    /// The light of one path through a pixel.
    pub fn sample<K: Kit, H: Heuristic, P: Film>(
        &self,
        view: &View<K>,
        pixel: [u32; 2],
        source: &mut impl Source,
    ) -> Vector {
        let ray = view.ray(pixel, source);
        self.follow::<K, H, P>(ray, source)
    }

    /// The light that comes back along a ray, as one path finds it.
    pub fn follow<K: Kit, H: Heuristic, P: Film>(
        &self,
        mut ray: Ray,
        source: &mut impl Source,
    ) -> Vector {
        let mut film = P::default();
        let (mut light, mut gone) = ([1.0; 3], 0.0);
        // The place from which the ray was drawn by a lobe, and with what density; none from the eye.
        let mut drawn: Option<(Vector, f32)> = None;
        for bounce in 0..BOUNCES {
            let dimension = DIMENSIONS.wrapping_add(bounce.wrapping_mul(PER_BOUNCE));
            let (way, met) = self.meet(ray);
            source.skip_to(dimension.wrapping_add(FOG));
            let scattered =
                self.fog
                    .scattered::<K, L>(ray, way, (self.lights, &self.choice), source);
            let (place, vertex, chosen) = if let Some(at) = scattered {
                let Some(phase) = self.fog.phase::<K>(ray.direction) else {
                    break;
                };
                light = scaled(light, at.weight);
                gone += at.way;
                (ray.at(at.way), Vertex::<K, M, F>::Fog(phase), at.light)
            } else {
                gone += way;
                if let Some((radiance, index)) = self.shine(&met, ray.direction) {
                    let weight = drawn.map_or(1.0, |(from, own)| {
                        H::lobe(own, self.light_pdf::<K>(index, from, ray.direction))
                    });
                    film.add(times(light, scaled(radiance, weight)), gone);
                }
                let Met::Surface(normal, material) = met else {
                    break;
                };
                let Some((from, frame, lobe)) = leave::<K, M>(ray, way, normal, &material) else {
                    break;
                };
                (from, Vertex::Surface(frame, lobe), None)
            };
            source.skip_to(dimension.wrapping_add(LIGHT));
            let chosen = chosen.or_else(|| self.choice.draw(source));
            source.skip_to(dimension.wrapping_add(PLACE));
            if let Some((found, way)) = self.lit::<K, H>(place, &vertex, chosen, source) {
                film.add(times(light, found), gone + way);
            }
            source.skip_to(dimension.wrapping_add(LOBE));
            let Some(next) = vertex.draw(source) else {
                break;
            };
            light = times(light, scaled(next.value, 1.0 / next.pdf));
            if bounce >= ROULETTE {
                source.skip_to(dimension.wrapping_add(ROULETTE_WORD));
                let Some(weight) = roulette(largest(light).min(0.95), source.next_u32()) else {
                    break;
                };
                light = scaled(light, weight);
            }
            let direction = next.direction;
            ray = Ray {
                origin: place,
                direction,
            };
            drawn = Some((place, next.pdf));
        }
        film.value()
    }

    /// The light that a place scatters from one light, drawn by its solid angle, and how far away that is.
    fn lit<K: Kit, H: Heuristic>(
        &self,
        place: Vector,
        vertex: &Vertex<K, M, F>,
        chosen: Option<(usize, f32)>,
        words: &mut impl Rng,
    ) -> Option<(Vector, f32)> {
        let (index, chance) = chosen?;
        let (direction, pdf) = self.draw_light::<K>(index, place, words)?;
        let pdf = chance * pdf;
        let (value, other) = vertex.weigh(direction);
        if largest(value) <= 0.0 {
            return None;
        }
        let (way, met) = self.meet(Ray {
            origin: place,
            direction,
        });
        let (radiance, met) = self.shine(&met, direction)?;
        if met != index {
            return None;
        }
        let weight = H::light(pdf, other) * self.fog.passed::<K>(way) / pdf;
        Some((times(value, scaled(radiance, weight)), way))
    }
}
