//! What each warp should do, in `f64`, written from the definitions and not from the crate's code.
//!
//! Formulas here are the textbook ones wherever doubles bear them; where even doubles would cancel
//! (cones of 1e-7 rad), they are written in the complementary quantity. `tests/laws` checks every
//! truth against itself: that its density is the derivative of its map, and its inverse the inverse.

mod directions;
mod discrete;
mod line;
mod plane;
mod polygon;
mod shapes;
mod surfaces;
mod visible_sphere;

pub use directions::*;
pub use discrete::*;
pub use line::*;
pub use plane::*;
pub use polygon::*;
pub use shapes::*;
pub use surfaces::*;
pub use visible_sphere::*;

use std::f64::consts::TAU;

pub type Uniforms = [f64; 4];
pub type Point = [f64; 3];

/// The exact counterpart of one warp with its parameters.
pub trait Truth: Send + Sync {
    /// The exact point of the uniforms.
    fn sample(&self, u: Uniforms) -> Point;
    /// The exact density at a point of the domain.
    fn pdf(&self, x: Point) -> f64;
    /// The exact density at the point of the uniforms, where even the `f64` of the point would have lost digits of it.
    fn density(&self, u: Uniforms) -> f64 {
        self.pdf(self.sample(u))
    }
    /// The exact uniforms of a point of the domain.
    fn invert(&self, x: Point) -> Uniforms;
    /// The exact fourth coordinate, of points that have one.
    fn fourth(&self, _: Uniforms) -> Option<f64> {
        None
    }
}

/// The azimuth of (x, y) in turns, in [0, 1).
pub fn turn(x: f64, y: f64) -> f64 {
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

pub fn dot(p: Point, q: Point) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
