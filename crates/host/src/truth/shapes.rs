//! Exact counterparts of the uniform shapes: rings, balls, rotations, polygons and simplices.

use super::plane::{minus, plus, times};
use super::{PI, Point, Real, TAU, Truth, Uniforms, real, turn, width};

/// A ring between two radii, or the sector of it between two azimuths in turns.
pub struct Annulus {
    pub radii: [Real; 2],
    pub turns: [Real; 2],
}

impl Annulus {
    fn width(&self) -> Real {
        width(self.turns)
    }
    fn squares(&self) -> Real {
        let [inner, outer] = self.radii;
        (outer - inner) * (outer + inner)
    }
}

impl Truth for Annulus {
    fn sample(&self, u: Uniforms) -> Point {
        let [inner, _] = self.radii;
        let r = (inner * inner + u[0] * self.squares()).sqrt();
        let (s, c) = (TAU * (self.turns[0] + u[1] * self.width())).sin_cos();
        [r * c, r * s, real(0.0)]
    }
    fn pdf(&self, _: Point) -> Real {
        1.0 / (PI * self.squares() * self.width())
    }
    fn invert(&self, x: Point) -> Uniforms {
        let [x, y, inner] = [x[0], x[1], self.radii[0]].map(|a| (a, real(0.0)));
        let width = self.width();
        let off = y.0.atan2(x.0) / TAU - self.turns[0] - 0.5 * width;
        // What is left of the squares of a narrow ring, in sums of two doubles.
        let squares = plus(plus(times(x, x), times(y, y)), minus(times(inner, inner)));
        let across = squares.0 / self.squares();
        [
            across,
            (off - off.round()) / width + 0.5,
            real(0.0),
            real(0.0),
        ]
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
    fn pdf(&self, _: Point) -> Real {
        3.0 / (4.0 * PI)
    }
    fn invert(&self, x: Point) -> Uniforms {
        let across = x[0].hypot(x[1]);
        // Half the angle from +z, whose squared sine is the second uniform.
        let half = 0.5 * across.atan2(x[2]);
        let height = half.sin().powi(2);
        [
            across.hypot(x[2]).powi(3),
            height,
            turn(x[0], x[1]),
            real(0.0),
        ]
    }
}

/// Unit quaternions with w ≥ 0, of which x, y and z are shown: w is what is left of their length.
pub struct Rotations;

impl Rotations {
    /// All four coordinates.
    pub fn quaternion(u: Uniforms) -> [Real; 4] {
        let (sin, cos) = (TAU * u[2]).sin_cos();
        let (half_sin, half_cos) = (PI * (u[1] - 0.5)).sin_cos();
        let (a, b) = (u[0].sqrt(), (1.0 - u[0]).sqrt());
        [a * cos, a * sin, b * half_sin, b * half_cos]
    }
    /// The uniforms of a quaternion of about unit length.
    pub fn uniforms([x, y, z, w]: [Real; 4]) -> Uniforms {
        let (a, b) = (x * x + y * y, z * z + w * w);
        [a / (a + b), 0.5 + z.atan2(w) / PI, turn(x, y), real(0.0)]
    }
}

impl Truth for Rotations {
    fn sample(&self, u: Uniforms) -> Point {
        let [x, y, z, _] = Self::quaternion(u);
        [x, y, z]
    }
    fn pdf(&self, _: Point) -> Real {
        1.0 / (PI * PI)
    }
    fn invert(&self, [x, y, z]: Point) -> Uniforms {
        let w = (1.0 - (x * x + y * y + z * z)).max(0.0).sqrt();
        Self::uniforms([x, y, z, w])
    }
    fn fourth(&self, u: Uniforms) -> Option<Real> {
        Some(Self::quaternion(u)[3])
    }
}

/// A regular polygon on the unit circle, its first corner at (1, 0).
pub struct RegularPolygon(pub u16);

impl RegularPolygon {
    fn corner(&self, k: Real) -> [Real; 2] {
        let (s, c) = (TAU * k / Real::from(self.0)).sin_cos();
        [c, s]
    }
    fn cross(p: [Real; 2], q: [Real; 2]) -> Real {
        p[0] * q[1] - p[1] * q[0]
    }
}

impl Truth for RegularPolygon {
    fn sample(&self, u: Uniforms) -> Point {
        let place = u[1] * Real::from(self.0);
        let (a, b) = (self.corner(place.floor()), self.corner(place.floor() + 1.0));
        let along = place - place.floor();
        let [x, y] = [0, 1].map(|k| u[0].sqrt() * ((1.0 - along) * a[k] + along * b[k]));
        [x, y, real(0.0)]
    }
    fn pdf(&self, _: Point) -> Real {
        let n = Real::from(self.0);
        2.0 / (n * (TAU / n).sin())
    }
    fn invert(&self, x: Point) -> Uniforms {
        let n = Real::from(self.0);
        let side = (turn(x[0], x[1]) * n).floor().min(n - 1.0);
        // The point as shares of both corners, by areas.
        let (p, a, b) = ([x[0], x[1]], self.corner(side), self.corner(side + 1.0));
        let whole = Self::cross(a, b);
        let (first, second) = (Self::cross(p, b) / whole, Self::cross(a, p) / whole);
        let s = first + second;
        let along = if s > 0.0 { second / s } else { real(0.0) };
        [s * s, (side + along) / n, real(0.0), real(0.0)]
    }
}

/// So many shares, and the rest as the coordinate after the last where a point has room for it.
pub struct Simplex(pub usize);

impl Simplex {
    /// The shares and the rest of so many uniforms.
    pub fn shares(u: &[Real]) -> Vec<Real> {
        let mut shares = Vec::new();
        let mut rest = real(1.0);
        for (u, m) in u.iter().zip((1..=u.len()).rev()) {
            let log = (-u).ln_1p() / Real::from(m as u32);
            shares.push(-rest * log.exp_m1());
            rest *= log.exp();
        }
        shares.push(rest);
        shares
    }
    /// The uniforms of shares and the rest.
    pub fn uniforms(shares: &[Real]) -> Vec<Real> {
        let n = shares.len() - 1;
        let left = |j: usize| shares[j..].iter().sum::<Real>();
        (0..n)
            .map(|j| {
                let (m, kept) = (Real::from((n - j) as u32), left(j + 1));
                -(m * (kept / (kept + shares[j])).ln()).exp_m1()
            })
            .collect()
    }
}

impl Truth for Simplex {
    fn sample(&self, u: Uniforms) -> Point {
        let shares = Self::shares(&u[..self.0]);
        std::array::from_fn(|k| shares.get(k).copied().unwrap_or(real(0.0)))
    }
    fn pdf(&self, _: Point) -> Real {
        (1..=self.0 as u32).map(Real::from).product()
    }
    fn invert(&self, x: Point) -> Uniforms {
        let mut shares: Vec<Real> = x.into_iter().take(self.0 + 1).collect();
        if self.0 == 3 {
            shares.push((1.0 - x.iter().sum::<Real>()).max(0.0));
        }
        let uniforms = Self::uniforms(&shares);
        std::array::from_fn(|k| uniforms.get(k).copied().unwrap_or(real(0.0)))
    }
    fn fourth(&self, u: Uniforms) -> Option<Real> {
        Self::shares(&u[..self.0]).get(3).copied()
    }
}
