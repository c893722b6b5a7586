//! Exact counterparts of the uniform shapes: rings, balls, rotations, polygons and simplices.

use super::{Point, Truth, Uniforms, turn};
use std::f64::consts::{PI, TAU};

/// A ring between two radii, or the sector of it between two azimuths in turns.
pub struct Annulus {
    pub radii: [f64; 2],
    pub turns: [f64; 2],
}

impl Annulus {
    /// The width in turns, at most a whole one.
    pub fn width(&self) -> f64 {
        let width = self.turns[1] - self.turns[0];
        if (width as f32) < 1.0 { width } else { 1.0 }
    }
    fn squares(&self) -> f64 {
        let [inner, outer] = self.radii;
        (outer - inner) * (outer + inner)
    }
}

impl Truth for Annulus {
    fn sample(&self, u: Uniforms) -> Point {
        let [inner, _] = self.radii;
        let r = (inner * inner + u[0] * self.squares()).sqrt();
        let (s, c) = (TAU * (self.turns[0] + u[1] * self.width())).sin_cos();
        [r * c, r * s, 0.0]
    }
    fn pdf(&self, _: Point) -> f64 {
        1.0 / (PI * self.squares() * self.width())
    }
    fn invert(&self, x: Point) -> Uniforms {
        let (r, [inner, _]) = (x[0].hypot(x[1]), self.radii);
        let width = self.width();
        let off = x[1].atan2(x[0]) / TAU - self.turns[0] - 0.5 * width;
        let across = (r - inner) * (r + inner) / self.squares();
        [across, (off - off.round()) / width + 0.5, 0.0, 0.0]
    }
}

/// The unit ball.
pub struct Ball;

impl Truth for Ball {
    fn sample(&self, u: Uniforms) -> Point {
        let (r, cos) = (u[0].cbrt(), 1.0 - 2.0 * u[1]);
        let sin = 2.0 * (u[1] * (1.0 - u[1])).sqrt();
        let (s, c) = (TAU * u[2]).sin_cos();
        [r * sin * c, r * sin * s, r * cos]
    }
    fn pdf(&self, _: Point) -> f64 {
        3.0 / (4.0 * PI)
    }
    fn invert(&self, x: Point) -> Uniforms {
        let across = x[0].hypot(x[1]);
        // Half the angle from +z, whose squared sine is the second uniform.
        let half = 0.5 * across.atan2(x[2]);
        let height = half.sin().powi(2);
        [across.hypot(x[2]).powi(3), height, turn(x[0], x[1]), 0.0]
    }
}

/// Unit quaternions with w ≥ 0, of which x, y and z are shown: w is what is left of their length.
pub struct Rotations;

impl Rotations {
    /// All four coordinates.
    pub fn quaternion(u: Uniforms) -> [f64; 4] {
        let (sin, cos) = (TAU * u[2]).sin_cos();
        let (half_sin, half_cos) = (PI * (u[1] - 0.5)).sin_cos();
        let (a, b) = (u[0].sqrt(), (1.0 - u[0]).sqrt());
        [a * cos, a * sin, b * half_sin, b * half_cos]
    }
    /// The uniforms of a quaternion of about unit length.
    pub fn uniforms([x, y, z, w]: [f64; 4]) -> Uniforms {
        let (a, b) = (x * x + y * y, z * z + w * w);
        [a / (a + b), 0.5 + z.atan2(w) / PI, turn(x, y), 0.0]
    }
}

impl Truth for Rotations {
    fn sample(&self, u: Uniforms) -> Point {
        let [x, y, z, _] = Self::quaternion(u);
        [x, y, z]
    }
    fn pdf(&self, _: Point) -> f64 {
        1.0 / (PI * PI)
    }
    fn invert(&self, [x, y, z]: Point) -> Uniforms {
        let w = (1.0 - (x * x + y * y + z * z)).max(0.0).sqrt();
        Self::uniforms([x, y, z, w])
    }
    fn fourth(&self, u: Uniforms) -> Option<f64> {
        Some(Self::quaternion(u)[3])
    }
}

/// A regular polygon on the unit circle, its first corner at (1, 0).
pub struct RegularPolygon(pub u16);

impl RegularPolygon {
    fn corner(&self, k: f64) -> [f64; 2] {
        let (s, c) = (TAU * k / f64::from(self.0)).sin_cos();
        [c, s]
    }
    fn cross(p: [f64; 2], q: [f64; 2]) -> f64 {
        p[0] * q[1] - p[1] * q[0]
    }
}

impl Truth for RegularPolygon {
    fn sample(&self, u: Uniforms) -> Point {
        let place = u[1] * f64::from(self.0);
        let (a, b) = (self.corner(place.floor()), self.corner(place.floor() + 1.0));
        let along = place - place.floor();
        let [x, y] = [0, 1].map(|k| u[0].sqrt() * ((1.0 - along) * a[k] + along * b[k]));
        [x, y, 0.0]
    }
    fn pdf(&self, _: Point) -> f64 {
        let n = f64::from(self.0);
        2.0 / (n * (TAU / n).sin())
    }
    fn invert(&self, x: Point) -> Uniforms {
        let n = f64::from(self.0);
        let side = (turn(x[0], x[1]) * n).floor().min(n - 1.0);
        // The point as shares of both corners, by areas.
        let (p, a, b) = ([x[0], x[1]], self.corner(side), self.corner(side + 1.0));
        let whole = Self::cross(a, b);
        let (first, second) = (Self::cross(p, b) / whole, Self::cross(a, p) / whole);
        let s = first + second;
        let along = if s > 0.0 { second / s } else { 0.0 };
        [s * s, (side + along) / n, 0.0, 0.0]
    }
}

/// So many shares, and the rest as the coordinate after the last where a point has room for it.
pub struct Simplex(pub usize);

impl Simplex {
    /// The shares and the rest of so many uniforms.
    pub fn shares(u: &[f64]) -> Vec<f64> {
        let mut shares = Vec::new();
        let mut rest = 1.0;
        for (u, m) in u.iter().zip((1..=u.len()).rev()) {
            let log = (-u).ln_1p() / m as f64;
            shares.push(-rest * log.exp_m1());
            rest *= log.exp();
        }
        shares.push(rest);
        shares
    }
    /// The uniforms of shares and the rest.
    pub fn uniforms(shares: &[f64]) -> Vec<f64> {
        let n = shares.len() - 1;
        let left = |j: usize| shares[j..].iter().sum::<f64>();
        (0..n)
            .map(|j| {
                let (m, kept) = ((n - j) as f64, left(j + 1));
                -(m * (kept / (kept + shares[j])).ln()).exp_m1()
            })
            .collect()
    }
}

impl Truth for Simplex {
    fn sample(&self, u: Uniforms) -> Point {
        let shares = Self::shares(&u[..self.0]);
        std::array::from_fn(|k| shares.get(k).copied().unwrap_or(0.0))
    }
    fn pdf(&self, _: Point) -> f64 {
        (1..=self.0).map(|k| k as f64).product()
    }
    fn invert(&self, x: Point) -> Uniforms {
        let mut shares: Vec<f64> = x.into_iter().take(self.0 + 1).collect();
        if self.0 == 3 {
            shares.push((1.0 - x.iter().sum::<f64>()).max(0.0));
        }
        let uniforms = Self::uniforms(&shares);
        std::array::from_fn(|k| uniforms.get(k).copied().unwrap_or(0.0))
    }
    fn fourth(&self, u: Uniforms) -> Option<f64> {
        Self::shares(&u[..self.0]).get(3).copied()
    }
}
