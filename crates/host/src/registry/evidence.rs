//! What a block gives to the tests of distributions and to the benches: wrong maps that must be rejected, moments, and the
//! same law of another crate. And what wrong maps have in common.

use super::Registered;
use crate::contest::Block;
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

/// What is averaged, of a point and its density.
pub type Averaged = dyn Fn(f64, &dyn Fn() -> f64) -> f64 + Send + Sync;

/// A moment that draws have because they read their word more deeply than the grid.
pub struct Moment {
    pub parameters: Vec<f32>,
    pub name: &'static str,
    pub of: Box<Averaged>,
    /// Its value under the law.
    pub due: f64,
    /// How far off it may be, relatively.
    pub bound: f64,
}

/// The same law in rand_distr.
pub struct Peer {
    /// The law, as tables of times name it.
    pub law: &'static str,
    pub parameters: Vec<f32>,
    /// What rand_distr calls it.
    pub name: &'static str,
    /// Draws a block of it.
    pub block: fn() -> Block<f32>,
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

    /// A moment under these parameters.
    pub(super) fn moment(
        mut self,
        parameters: &[f32],
        name: &'static str,
        of: impl Fn(f64, &dyn Fn() -> f64) -> f64 + Send + Sync + 'static,
        due: f64,
        bound: f64,
    ) -> Self {
        self.moments.push(Moment {
            parameters: parameters.to_vec(),
            name,
            of: Box::new(of),
            due,
            bound,
        });
        self
    }

    /// 1/p where p vanishes at an end: its mean is the width of the domain, if nothing stands next to the end that has more
    /// than its share.
    pub(super) fn width(self, parameters: &[f32], due: f64, bound: f64) -> Self {
        self.moment(parameters, "1/p", |_, density| 1.0 / density(), due, bound)
    }

    /// The law of rand_distr under these parameters.
    pub(super) fn peer(
        mut self,
        law: &'static str,
        parameters: &[f32],
        name: &'static str,
        block: fn() -> Block<f32>,
    ) -> Self {
        self.peers.push(Peer {
            law,
            parameters: parameters.to_vec(),
            name,
            block,
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

// The headings under which samplers of one law are compared.

pub const DISK: &str = "disk";
pub const SPHERE: &str = "sphere";
pub const HEMISPHERE: &str = "hemisphere";
pub const COSINE: &str = "cosine hemisphere";
pub const LOBE: &str = "lobe n = 50";
pub const EXPONENTIAL: &str = "exponential";
pub const NORMAL: &str = "two normals";

/// All, in the order of the picture.
pub const PICTURED: [&str; 7] = [DISK, SPHERE, HEMISPHERE, COSINE, LOBE, EXPONENTIAL, NORMAL];
