//! A scene's constants in `f64`.

use super::samplers::{Panel, SeenBall, minus, mix, plus, unit};
use crate::truth::{Point, cross, dot};
use microwarp_scene::material::{Any, Glossy, Matte, Metal};
use microwarp_scene::vector::Vector;
use microwarp_scene::{Clear, Colour, Echo, Film, Haze, Lamp, Quad, Sphere};

pub(super) fn wide(v: Vector) -> Point {
    v.map(f64::from)
}

/// A film that the twin can expose.
pub trait Record: Film {
    fn record(sum: &mut Point, light: Point, way: f64);
}

impl Record for Colour {
    fn record(sum: &mut Point, light: Point, _: f64) {
        *sum = plus(*sum, light);
    }
}

impl Record for Echo {
    fn record(sum: &mut Point, light: Point, way: f64) {
        *sum = mix(*sum, 1.0, [1.0, way, way * way], light[0]);
    }
}

#[derive(Clone, Copy, Debug)]
pub enum Stuff {
    Matte(Point),
    Glossy {
        ground: Point,
        coat: f64,
        exponent: f64,
    },
    Metal {
        colour: Point,
        roughness: f64,
    },
}

impl From<Matte> for Stuff {
    fn from(matte: Matte) -> Self {
        Self::Matte(wide(matte.0))
    }
}

impl From<Any> for Stuff {
    fn from(any: Any) -> Self {
        match any {
            Any::Matte(matte) => matte.into(),
            Any::Glossy(Glossy {
                ground,
                coat,
                exponent,
            }) => Self::Glossy {
                ground: wide(ground),
                coat: coat.into(),
                exponent: exponent.into(),
            },
            Any::Metal(Metal { colour, roughness }) => Self::Metal {
                colour: wide(colour),
                roughness: roughness.into(),
            },
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub enum Form {
    Quad { corner: Point, edges: [Point; 2] },
    Ball { centre: Point, radius: f64 },
}

impl From<Quad> for Form {
    fn from(quad: Quad) -> Self {
        Self::Quad {
            corner: wide(quad.corner()),
            edges: quad.edges().map(wide),
        }
    }
}

impl From<Sphere> for Form {
    fn from(Sphere { centre, radius }: Sphere) -> Self {
        Self::Ball {
            centre: wide(centre),
            radius: radius.into(),
        }
    }
}

impl Form {
    /// The distance at which a ray meets it, between two others.
    pub(super) fn hit(&self, from: Point, along: Point, [least, most]: [f64; 2]) -> Option<f64> {
        let good = |way: &f64| *way >= least && *way < most;
        match *self {
            Self::Quad { corner, edges } => {
                let [x, y] = edges;
                let (normal, away) = (cross(x, y), minus(from, corner));
                let way = -dot(normal, away) / dot(normal, along);
                // Cramer's rule, for the coordinates along the edges.
                let place = mix(away, 1.0, along, way);
                let square = dot(normal, normal);
                let s = dot(cross(place, y), normal) / square;
                let t = dot(cross(x, place), normal) / square;
                let inside = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
                Some(way).filter(|way| good(way) && inside)
            }
            Self::Ball { centre, radius } => {
                // The quadratic equation.
                let to = minus(centre, from);
                let b = dot(to, along);
                let root = (b * b - dot(to, to) + radius * radius).sqrt();
                [b - root, b + root].into_iter().find(good)
            }
        }
    }

    pub(super) fn normal(&self, place: Point) -> Point {
        unit(match *self {
            Self::Quad { edges: [x, y], .. } => cross(x, y),
            Self::Ball { centre, .. } => minus(place, centre),
        })
    }

    pub(super) fn middle(&self) -> Point {
        match *self {
            Self::Quad {
                corner,
                edges: [x, y],
            } => mix(corner, 1.0, plus(x, y), 0.5),
            Self::Ball { centre, .. } => centre,
        }
    }

    /// A direction to it by solid angle, and its density.
    pub(super) fn towards(&self, from: Point, u: [f64; 2]) -> Option<(Point, f64)> {
        match *self {
            Self::Quad { corner, edges } => {
                let panel = Panel::new(from, corner, edges)?;
                Some((panel.sample(u), 1.0 / panel.solid_angle()))
            }
            Self::Ball { centre, radius } => {
                let ball = SeenBall::new(from, centre, radius);
                Some((ball.sample(u), 1.0 / ball.solid_angle()))
            }
        }
    }
}

/// What sends out light, on its outer side.
#[derive(Clone, Copy, Debug)]
pub struct Source64 {
    pub form: Form,
    pub radiance: Point,
}

impl<S> From<Lamp<S>> for Source64
where
    Form: From<S>,
{
    fn from(Lamp { shape, radiance }: Lamp<S>) -> Self {
        Self {
            form: shape.into(),
            radiance: wide(radiance),
        }
    }
}

/// Fog of so many events in a metre; none of 0.
#[derive(Clone, Copy, Debug)]
pub struct Air {
    pub density: f64,
    pub albedo: f64,
    pub asymmetry: f64,
}

impl From<Clear> for Air {
    fn from(_: Clear) -> Self {
        Self {
            density: 0.0,
            albedo: 0.0,
            asymmetry: 0.0,
        }
    }
}

impl From<Haze> for Air {
    fn from(haze: Haze) -> Self {
        Self {
            density: haze.density.into(),
            albedo: haze.albedo.into(),
            asymmetry: haze.asymmetry.into(),
        }
    }
}
