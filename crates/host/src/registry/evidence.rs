//! What a block gives to the tests of distributions: wrong maps that they must reject, and what maps have in common that are
//! wrong.

use super::Registered;
use std::f64::consts::TAU;

/// A map that is nearly right, of up to three uniforms and how wrong it is.
pub type Map = fn([f64; 3], f64) -> [f64; 3];

/// A wrong map to the domain of a case: the examination of samples must reject it.
pub struct Control {
    /// The case, by its place.
    pub case: usize,
    pub what: &'static str,
    pub map: Map,
    /// The tests, or faults, by which it is rejected.
    pub by: &'static [&'static str],
}

impl Registered {
    /// A wrong map for the case before it.
    pub(super) fn control(
        mut self,
        what: &'static str,
        map: Map,
        by: &'static [&'static str],
    ) -> Self {
        let case = self.cases.len() - 1;
        self.controls.push(Control {
            case,
            what,
            map,
            by,
        });
        self
    }
}

pub(super) fn disk(u: f64, v: f64) -> [f64; 3] {
    [u.sqrt() * (TAU * v).cos(), u.sqrt() * (TAU * v).sin(), 0.0]
}

pub(super) fn normal(u: f64, v: f64) -> f64 {
    (-2.0 * (-u).ln_1p()).sqrt() * (TAU * v).cos()
}

/// The direction at this angle from +z and this turn about it.
pub(super) fn direction(theta: f64, turn: f64) -> [f64; 3] {
    let (sine, cosine) = theta.sin_cos();
    [sine * (TAU * turn).cos(), sine * (TAU * turn).sin(), cosine]
}

/// Barycentric coordinates, of each uniform a part of what is left: too many points near one corner.
pub(super) fn leftover(u: f64, v: f64) -> [f64; 3] {
    [u, v * (1.0 - u), (1.0 - u) * (1.0 - v)]
}

/// Uniform between 0 and 1 by a density that runs linearly from one number to another.
pub(super) fn ramp(u: f64, a: f64, b: f64) -> f64 {
    u * (a + b) / (a + ((1.0 - u) * a * a + u * b * b).sqrt())
}
