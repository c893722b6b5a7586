//! Fog that fills the scene evenly.

use crate::kit::Kit;
use crate::light::{Choice, Light};
use crate::material::{Bounce, Lobe};
use crate::shape::Ray;
use crate::vector::{Vector, dot, length, minus, scaled};
use core::convert::Infallible;
use microwarp::estimate::balance_heuristic;
use microwarp::tier::Tier;
use microwarp::uniform::Chance;
use microwarp::warp::{EquiAngular, Frame, Oriented};
use microwarp::{Warp, constant};
use rand_core::Rng;

/// What is between the surfaces.
pub trait Fog: Copy {
    /// The part of light that is neither scattered nor absorbed along a way.
    fn passed<K: Kit>(&self, way: f32) -> f32;

    /// Where a ray is scattered before it has gone `way`; none for a ray that goes all the way, whose light is unchanged.
    fn scattered<K: Kit, L: Light>(
        &self,
        ray: Ray,
        way: f32,
        lights: (&[L], &Choice<'_>),
        words: &mut impl Rng,
    ) -> Option<Scattered>;

    /// The law of directions at a place where light is scattered. Clear air has no value of this type, by which the compiler
    /// knows that light is never scattered there.
    type Lobe<K: Kit>: Lobe;

    /// The law about the way that light goes, a unit vector.
    fn phase<K: Kit>(&self, direction: Vector) -> Option<Self::Lobe<K>>;
}

/// A place where a ray is scattered.
#[derive(Clone, Copy, Debug)]
pub struct Scattered {
    pub way: f32,
    /// By what the light from there is multiplied.
    pub weight: f32,
    /// The light that the place was chosen for, with its probability: it is to be the light that shines on it. Another one
    /// may be so close to it that its light has no bound.
    pub light: Option<(usize, f32)>,
}

/// None.
#[derive(Clone, Copy, Debug)]
pub struct Clear;

impl Fog for Clear {
    #[inline]
    fn passed<K: Kit>(&self, _: f32) -> f32 {
        1.0
    }

    #[inline]
    fn scattered<K: Kit, L: Light>(
        &self,
        _: Ray,
        _: f32,
        _: (&[L], &Choice<'_>),
        _: &mut impl Rng,
    ) -> Option<Scattered> {
        None
    }

    type Lobe<K: Kit> = Infallible;

    #[inline]
    fn phase<K: Kit>(&self, _: Vector) -> Option<Infallible> {
        None
    }
}

impl Lobe for Infallible {
    #[inline]
    fn draw(&self, _: &mut impl Rng) -> Option<Bounce> {
        match *self {}
    }

    #[inline]
    fn weigh(&self, _: Vector) -> (Vector, f32) {
        match *self {}
    }
}

/// The same fog everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Haze {
    /// Events in a metre.
    pub density: f32,
    /// The part of events that scatter; the others absorb.
    pub albedo: f32,
    /// The mean cosine of the angle by which light turns.
    pub asymmetry: f32,
}

/// Whether a place is chosen for a light.
const HALF: Chance = constant!(Chance::from_ratio(1, 2));

impl Haze {
    /// Light that passes, and the rest.
    #[inline]
    fn parts<K: Kit>(self, way: f32) -> (f32, f32) {
        let depth = self.density * way;
        // Beyond that the pair is not stated; what passes is below the smallest normal number.
        K::Tier::exp_neg_pair(if depth < 87.0 { depth } else { 87.0 })
    }

    /// Distances by the angle in which a light sees them, from the place on the ray that is nearest to it.
    /// None for the sky.
    fn towards<K: Kit, L: Light>(
        ray: Ray,
        way: f32,
        lights: &[L],
        index: usize,
    ) -> Option<(f32, EquiAngular<K::Tier>)> {
        let to = minus(lights.get(index)?.middle(), ray.origin);
        let foot = dot(to, ray.direction);
        let beside = length(minus(to, scaled(ray.direction, foot)));
        let law = EquiAngular::new(beside, -foot, way - foot).ok()?;
        Some((foot, law))
    }
}

impl Fog for Haze {
    #[inline]
    fn passed<K: Kit>(&self, way: f32) -> f32 {
        self.parts::<K>(way).0
    }

    /// Whether a ray is scattered is decided by the chance of that, which words realise to 2⁻³². Where, is drawn from an even
    /// mixture of both laws, and weighed by the density of the mixture (the balance heuristic for one sample). The four words are
    /// the event, the law, the light and the distance.
    fn scattered<K: Kit, L: Light>(
        &self,
        ray: Ray,
        way: f32,
        (lights, choice): (&[L], &Choice<'_>),
        words: &mut impl Rng,
    ) -> Option<Scattered> {
        let (_, chance) = self.parts::<K>(way);
        if !Chance::new(chance).ok()?.draw(words) {
            return None;
        }
        let free = K::free(self.density, way).ok()?;
        let by_light = HALF.draw(words);
        let light = choice.draw(words);
        let seen = light.and_then(|(index, _)| Self::towards::<K, L>(ray, way, lights, index));
        let Some((foot, seen)) = seen else {
            let (way, weight) = (free.draw(words), self.albedo);
            return Some(Scattered { way, weight, light });
        };
        let drawn = if by_light {
            seen.draw(words) + foot
        } else {
            free.draw(words)
        };
        let way = drawn.max(0.0).min(way);
        let (own, other) = (free.pdf(way), seen.pdf(way - foot));
        // In proportion to the density of `free` is what is to be found; the mean of both is what was drawn from.
        let weight = self.albedo * (2.0 * balance_heuristic(1, own, 1, other));
        Some(Scattered { way, weight, light })
    }

    type Lobe<K: Kit> = HazeLobe<K>;

    fn phase<K: Kit>(&self, direction: Vector) -> Option<HazeLobe<K>> {
        let frame = Frame::new(direction).ok()?;
        let phase = K::phase(self.asymmetry).ok()?;
        Some(HazeLobe(Oriented::new(phase, frame)))
    }
}

/// The law of [`Haze`], which is its own density.
pub struct HazeLobe<K: Kit>(Oriented<K::Phase>);

impl<K: Kit> Lobe for HazeLobe<K> {
    #[inline]
    fn draw(&self, words: &mut impl Rng) -> Option<Bounce> {
        let (direction, pdf) = self.0.draw_with_pdf(words);
        let value = [pdf; 3];
        Some(Bounce {
            direction,
            value,
            pdf,
        })
    }

    #[inline]
    fn weigh(&self, direction: Vector) -> (Vector, f32) {
        let pdf = self.0.pdf(direction);
        ([pdf; 3], pdf)
    }
}
