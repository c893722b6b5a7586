//! A mutation that moves the eye's end of a path: it starts from another place of the picture, goes to the same second
//! surface, and from there on as before.

use crate::camera::{DIMENSIONS, View};
use crate::fog::Fog;
use crate::kit::Kit;
use crate::light::Light;
use crate::material::{Lobe as _, Material};
use crate::metropolis::{State, pixel_of};
use crate::path::{FOG, LOBE, Met, PER_BOUNCE, Scene, leave};
use crate::shape::Ray;
use crate::sky::Sky;
use crate::source::{Numbers, Source as _};
use crate::vector::{Vector, dot, minus, unit};
use microwarp::metropolis::{HastingsRatio, Mutation, Proposal, Symmetric};
use microwarp::warp::Frame;
use rand_core::TryRng;

/// Moves the place of a path by a mutation of two numbers that is symmetric, and keeps its second surface: the numbers of
/// the first bounce become those that lead there, by the inverse of the lobe.
///
/// Where that cannot be, it proposes [`NOWHERE`]: the second surface is hidden, the lobe has no inverse, or the light meets
/// a lamp or fog before. The way back has the same conditions.
pub struct Shift<'a, S, K: Kit, M> {
    pub scene: &'a S,
    pub view: &'a View<K>,
    pub size: [u32; 2],
    pub place: M,
}

/// A place outside the picture, which has no light.
pub const NOWHERE: [f32; 2] = [1.0; 2];

/// How far apart hits of the same place are at most, squared, and the least cosine between their normals.
const SAME: f32 = 1e-6;
const ALIKE: f32 = 0.999;

/// Where light leaves a surface.
type Leaving<K, M> = (Vector, Frame, <M as Material>::Lobe<K>);

/// A place of the second surface, and the density per area with which the first bounce leads there.
struct Second {
    place: Vector,
    normal: Vector,
    pdf: f32,
}

impl<M: Material, L: Light, E: Sky, F: Fog> Scene<'_, M, L, E, F> {
    /// The surface that a ray of a bounce meets first.
    fn surface<K: Kit>(
        &self,
        ray: Ray,
        bounce: u32,
        numbers: &mut Numbers,
    ) -> Option<(f32, Vector, M)> {
        let (way, Met::Surface(normal, material)) = self.meet(ray) else {
            return None;
        };
        numbers.skip_to(DIMENSIONS.wrapping_add(bounce.wrapping_mul(PER_BOUNCE).wrapping_add(FOG)));
        let lights = (self.lights, &self.choice);
        let scattered = self.fog.scattered::<K, L>(ray, way, lights, numbers);
        scattered.is_none().then_some((way, normal, material))
    }

    fn first<K: Kit>(
        &self,
        view: &View<K>,
        pixel: [u32; 2],
        numbers: &mut Numbers,
    ) -> Option<Leaving<K, M>> {
        let ray = view.ray(pixel, numbers);
        let (way, normal, material) = self.surface::<K>(ray, 0, numbers)?;
        leave::<K, M>(ray, way, normal, &material)
    }

    fn second<K: Kit>(
        &self,
        (origin, frame, lobe): &Leaving<K, M>,
        numbers: &mut Numbers,
    ) -> Option<Second> {
        numbers.skip_to(DIMENSIONS.wrapping_add(LOBE));
        let bounce = lobe.draw(numbers)?;
        // Without an inverse there is no way back.
        lobe.invert(bounce.direction)?;
        let direction = frame.to_world(bounce.direction);
        let ray = Ray {
            origin: *origin,
            direction,
        };
        let (way, normal, _) = self.surface::<K>(ray, 1, numbers)?;
        let normal = unit(normal);
        Some(Second {
            place: ray.at(way),
            normal,
            pdf: bounce.pdf * dot(normal, direction).abs() / (way * way),
        })
    }

    /// A path from another place, and the Hastings ratio of that: by how much the numbers of the first bounce are spread,
    /// which is the inverse of both densities per area.
    fn shifted<K: Kit>(
        &self,
        view: &View<K>,
        size: [u32; 2],
        (from, mut path): State,
        to: [f32; 2],
    ) -> Option<(State, HastingsRatio)> {
        let mut numbers = Numbers::new(path);
        let first = self.first(view, pixel_of(from, size), &mut numbers)?;
        let old = self.second::<K>(&first, &mut numbers)?;
        let first = self.first(view, pixel_of(to, size), &mut numbers)?;
        let (origin, frame, lobe) = &first;
        let direction = frame.to_local(unit(minus(old.place, *origin)));
        let [_, _, z] = direction;
        let bounce = lobe.invert(direction).filter(|_| z > 0.0)?;
        let places = path.iter_mut().skip(DIMENSIONS.wrapping_add(LOBE) as usize);
        places.zip(bounce).for_each(|(number, new)| *number = new);
        let new = self.second::<K>(&first, &mut Numbers::new(path))?;
        let off = minus(new.place, old.place);
        let same = dot(off, off) < SAME && dot(new.normal, old.normal) > ALIKE;
        same.then(|| ((to, path), HastingsRatio::new(old.pdf, new.pdf)))
    }
}

impl<K, M, L, E, F, P> Mutation<State> for Shift<'_, Scene<'_, M, L, E, F>, K, P>
where
    K: Kit,
    M: Material,
    L: Light,
    E: Sky,
    F: Fog,
    P: Mutation<[f32; 2], Correction = Symmetric>,
{
    type Correction = HastingsRatio;

    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: State,
        rng: &mut R,
    ) -> Result<Proposal<State, HastingsRatio>, R::Error> {
        let to = self.place.try_propose(from.0, rng)?.state;
        let shifted = self.scene.shifted(self.view, self.size, from, to);
        let (state, ratio) = shifted.unwrap_or(((NOWHERE, from.1), HastingsRatio::ONE));
        Ok(Proposal::new(state, ratio))
    }
}
