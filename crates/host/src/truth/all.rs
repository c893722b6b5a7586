//! What each warp should do, in `Real`, written from the definitions and not from the crate's code.
//!
//! Formulas here are the textbook ones wherever doubles bear them; where even doubles would cancel
//! (cones of 1e-7 rad), they are written in the complementary quantity. `tests/laws` checks every
//! truth against itself: that its density is the derivative of its map, and its inverse the inverse.

mod directions;
mod discrete;
mod line;
mod multivariate_normal;
mod plane;
mod polygon;
mod shapes;
mod surfaces;
mod visible_sphere;

pub use directions::*;
pub use discrete::*;
pub use line::*;
pub use multivariate_normal::MultivariateNormal;
pub use plane::*;
pub use polygon::*;
pub use shapes::*;
pub use surfaces::*;
pub use visible_sphere::*;

use super::{FRAC_1_PI, FRAC_1_SQRT_2, PI, Real, TAU, erf, erfc, ln_gamma, real, to_f64};

pub type Uniforms = [Real; 4];
pub type Point = [Real; 3];

/// The exact counterpart of one warp with its parameters.
pub trait Truth: Send + Sync {
    /// The exact point of the uniforms.
    fn sample(&self, u: Uniforms) -> Point;
    /// The exact density at a point of the domain.
    fn pdf(&self, x: Point) -> Real;
    /// The exact density at the point of the uniforms, where even the `Real` of the point would have lost digits of it.
    fn density(&self, u: Uniforms) -> Real {
        self.pdf(self.sample(u))
    }
    /// The exact uniforms of a point of the domain.
    fn invert(&self, x: Point) -> Uniforms;
    /// The exact fourth coordinate, of points that have one.
    fn fourth(&self, _: Uniforms) -> Option<Real> {
        None
    }
}

impl<T: Truth + ?Sized> Truth for Box<T> {
    fn sample(&self, u: Uniforms) -> Point {
        (**self).sample(u)
    }
    fn pdf(&self, x: Point) -> Real {
        (**self).pdf(x)
    }
    fn density(&self, u: Uniforms) -> Real {
        (**self).density(u)
    }
    fn invert(&self, x: Point) -> Uniforms {
        (**self).invert(x)
    }
    fn fourth(&self, u: Uniforms) -> Option<Real> {
        (**self).fourth(u)
    }
}

/// How many turns lie between two angles in turns; one that counts as whole in `f32` is a whole one.
pub fn width([from, to]: [Real; 2]) -> Real {
    let width = to - from;
    if (to_f64(width) as f32) < 1.0 {
        width
    } else {
        real(1.0)
    }
}

/// Numbers that doubles hold.
pub fn reals(all: &[f64]) -> Vec<Real> {
    all.iter().map(|x| Real::from(*x)).collect()
}

/// What lies below a number, as an index; 0 for what is negative.
fn index(x: Real) -> usize {
    to_f64(x) as usize
}

/// The azimuth of (x, y) in turns, in [0, 1).
pub fn turn(x: Real, y: Real) -> Real {
    let t = y.atan2(x) / TAU;
    if t < 0.0 { t + 1.0 } else { t }
}

pub fn cross(p: Point, q: Point) -> Point {
    [
        p[1] * q[2] - p[2] * q[1],
        p[2] * q[0] - p[0] * q[2],
        p[0] * q[1] - p[1] * q[0],
    ]
}

pub fn dot(p: Point, q: Point) -> Real {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
