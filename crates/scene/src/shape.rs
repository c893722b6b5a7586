//! The two shapes, how a ray meets them, and how a light of that shape is sampled.

use crate::kit::Kit;
use crate::vector::{Vector, cross, dot, minus, plus, scaled, sqrt};
use microwarp::Warp;
use microwarp::warp::{SphericalRectangle, VisibleSphere};
use rand_core::Rng;

/// A way that light goes: an origin and a unit direction.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub origin: Vector,
    pub direction: Vector,
}

/// How far a ray starts from the surface that it leaves, and the shortest distance that counts as a hit.
pub const STEP: f32 = 1e-4;

impl Ray {
    #[inline]
    pub fn at(self, distance: f32) -> Vector {
        plus(self.origin, scaled(self.direction, distance))
    }
}

/// A surface that rays hit, and that is sampled by solid angle where it is a light.
pub trait Shape: Copy {
    /// The distance to the first place from [`STEP`] to `within` that the ray meets.
    fn hit(&self, ray: Ray, within: f32) -> Option<f32>;

    /// The outer normal at a place on it, of any length.
    fn normal(&self, place: Vector) -> Vector;

    /// A direction from a point to the shape, with its density per steradian; none for a shape that is not seen.
    fn draw<K: Kit>(&self, from: Vector, words: &mut impl Rng) -> Option<(Vector, f32)>;

    /// The density of a direction that meets the shape.
    fn pdf<K: Kit>(&self, from: Vector, direction: Vector) -> f32;
}

/// A parallelogram: a corner and two edges, whose cross product is the outer normal.
#[derive(Clone, Copy, Debug)]
pub struct Quad {
    corner: Vector,
    edges: [Vector; 2],
    normal: Vector,
    /// What the coordinates along the edges are read off with.
    duals: [Vector; 2],
}

impl Quad {
    /// A parallelogram without an area is one that no ray meets.
    pub const fn new(corner: Vector, edges: [Vector; 2]) -> Self {
        let [x, y] = edges;
        let normal = cross(x, y);
        let square = dot(normal, normal);
        let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
        let duals = [
            scaled(cross(y, normal), inverse),
            scaled(cross(normal, x), inverse),
        ];
        Self {
            corner,
            edges,
            normal,
            duals,
        }
    }

    /// The sides and the top of an upright box, seen from outside: the middle of its floor, half of one side of the
    /// floor, how long the other side is in units of that, and the height.
    pub const fn cuboid(middle: Vector, [x, y]: [f32; 2], aspect: f32, height: f32) -> [Self; 5] {
        let (a, b) = ([x, y, 0.0], [-y * aspect, x * aspect, 0.0]);
        let (up, wide, deep) = ([0.0, 0.0, height], scaled(a, 2.0), scaled(b, 2.0));
        let low = minus(minus(middle, a), b);
        let far = plus(plus(middle, a), b);
        let back = [scaled(wide, -1.0), scaled(deep, -1.0)];
        let [left, near] = back;
        [
            Self::new(low, [wide, up]),
            Self::new(plus(low, wide), [deep, up]),
            Self::new(far, [left, up]),
            Self::new(plus(low, deep), [near, up]),
            Self::new(plus(low, up), [wide, deep]),
        ]
    }

    pub const fn corner(&self) -> Vector {
        self.corner
    }

    pub const fn edges(&self) -> [Vector; 2] {
        self.edges
    }

    fn seen<K: Kit>(&self, from: Vector) -> Option<SphericalRectangle<K::Tier>> {
        SphericalRectangle::new(from, self.corner, self.edges).ok()
    }
}

impl Shape for Quad {
    #[inline]
    fn hit(&self, ray: Ray, within: f32) -> Option<f32> {
        let away = minus(self.corner, ray.origin);
        let distance = dot(self.normal, away) / dot(self.normal, ray.direction);
        // False for a ray along the plane, too, whose distance is infinite or NaN.
        if !(distance >= STEP && distance < within) {
            return None;
        }
        let place = minus(scaled(ray.direction, distance), away);
        let inside = |dual| (0.0..=1.0).contains(&dot(place, dual));
        let [x, y] = self.duals;
        (inside(x) && inside(y)).then_some(distance)
    }

    #[inline]
    fn normal(&self, _: Vector) -> Vector {
        self.normal
    }

    fn draw<K: Kit>(&self, from: Vector, words: &mut impl Rng) -> Option<(Vector, f32)> {
        Some(self.seen::<K>(from)?.draw_with_pdf(words))
    }

    fn pdf<K: Kit>(&self, from: Vector, _: Vector) -> f32 {
        self.seen::<K>(from).map_or(0.0, |seen| seen.density())
    }
}

/// A sphere, hit from outside and from inside.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    pub centre: Vector,
    pub radius: f32,
}

impl Sphere {
    fn seen<K: Kit>(&self, from: Vector) -> Option<VisibleSphere<K::Tier>> {
        VisibleSphere::new(from, self.centre, self.radius).ok()
    }
}

impl Shape for Sphere {
    /// The discriminant is taken from the distance at which the ray passes the centre, which keeps its digits far away.
    #[inline]
    fn hit(&self, ray: Ray, within: f32) -> Option<f32> {
        let to = minus(self.centre, ray.origin);
        let along = dot(to, ray.direction);
        let beside = minus(to, scaled(ray.direction, along));
        let square = self.radius * self.radius - dot(beside, beside);
        if square <= 0.0 {
            return None;
        }
        let half = sqrt(square);
        let good = |distance: &f32| *distance >= STEP && *distance < within;
        [along - half, along + half].into_iter().find(good)
    }

    #[inline]
    fn normal(&self, place: Vector) -> Vector {
        minus(place, self.centre)
    }

    fn draw<K: Kit>(&self, from: Vector, words: &mut impl Rng) -> Option<(Vector, f32)> {
        Some(self.seen::<K>(from)?.draw_with_pdf(words))
    }

    fn pdf<K: Kit>(&self, from: Vector, _: Vector) -> f32 {
        self.seen::<K>(from).map_or(0.0, |seen| seen.density())
    }
}
