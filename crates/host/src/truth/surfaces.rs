//! Exact counterparts of the warps over surfaces: meshes, boxes, frustums and capsules.

use super::{Barycentric, PI, Point, Real, TAU, Truth, Uniforms, index, real, turn};

/// A triangle mesh by the words of its table, in coordinates of its own: the number of the face, and the shares of the
/// second and the third vertex. The densities are those of these coordinates.
pub struct Faces {
    /// The probability below each face, and that of all, from 0 to 1.
    ends: Vec<Real>,
}

impl Faces {
    /// Of the words of each face; what lies below a step of doubles is 0 anyway.
    pub fn new(words: &[Real]) -> Self {
        let total: Real = words.iter().sum();
        let mut ends = vec![real(0.0)];
        let mut sum = real(0.0);
        for count in words {
            sum += count;
            ends.push(sum / total);
        }
        Self { ends }
    }

    pub fn probability(&self, face: usize) -> Real {
        self.ends[face + 1] - self.ends[face]
    }

    fn last(&self) -> usize {
        self.ends.len() - 2
    }

    fn face(&self, x: Point) -> usize {
        index(x[0].round()).min(self.last())
    }

    /// The face of the first uniform, and the barycentric coordinates.
    pub fn place(&self, u: Uniforms) -> (usize, Point) {
        let above = self.ends[1..].iter().position(|end| u[0] < *end);
        let lit = (0..=self.last()).rev().find(|k| self.probability(*k) > 0.0);
        let face = above.or(lit).expect("a face of positive probability");
        let part = (u[0] - self.ends[face]) / self.probability(face);
        (face, Barycentric.sample([part, u[1], real(0.0), real(0.0)]))
    }
}

impl Truth for Faces {
    fn sample(&self, u: Uniforms) -> Point {
        let (face, [_, v, w]) = self.place(u);
        [Real::from(face as u32), v, w]
    }
    fn pdf(&self, x: Point) -> Real {
        2.0 * self.probability(self.face(x))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let face = self.face(x);
        let s = x[1] + x[2];
        let second = if s > 0.0 { x[1] / s } else { real(0.0) };
        let first = self.ends[face] + s * s * self.probability(face);
        [first, second, real(0.0), real(0.0)]
    }
}

/// The faces of a box, taken apart: the coordinate across a face is beyond all others, on the side of the face.
pub struct BoxFaces {
    pub low: Point,
    pub high: Point,
    /// The axis across the faces that first uniforms select, and from where to where.
    pub pieces: Vec<(usize, Real, Real)>,
    pub beyond: Real,
}

impl BoxFaces {
    fn side(&self, k: usize) -> Real {
        self.high[k % 3] - self.low[k % 3]
    }

    fn axis(&self, x: Point) -> usize {
        let far = (0..3).find(|k| x[*k].abs() > 0.75 * self.beyond);
        far.unwrap_or(2)
    }

    fn piece(&self, axis: usize) -> (Real, Real) {
        let piece = self.pieces.iter().find(|piece| piece.0 == axis);
        piece.map_or((real(0.0), real(0.0)), |piece| (piece.1, piece.2))
    }
}

impl Truth for BoxFaces {
    fn sample(&self, u: Uniforms) -> Point {
        let piece = self.pieces.iter().find(|piece| u[0] < piece.2);
        let (k, start, end) = *piece.unwrap_or(&self.pieces[self.pieces.len() - 1]);
        let (s, upper) = ((u[0] - start) / (end - start), u[1] >= 0.5);
        let t = 2.0 * u[1] - Real::from(u8::from(upper));
        let mut point = [real(0.0); 3];
        point[k] = if upper { self.beyond } else { -self.beyond };
        for (k, part) in [((k + 1) % 3, s), ((k + 2) % 3, t)] {
            point[k] = self.low[k] + part * self.side(k);
        }
        point
    }
    fn pdf(&self, x: Point) -> Real {
        let k = self.axis(x);
        let (start, end) = self.piece(k);
        (end - start) / (2.0 * self.side(k + 1) * self.side(k + 2))
    }
    fn invert(&self, x: Point) -> Uniforms {
        let k = self.axis(x);
        let part = |k: usize| (x[k % 3] - self.low[k % 3]) / self.side(k);
        let (start, end) = self.piece(k);
        let first = start + (end - start) * part(k + 1);
        let second = 0.5 * part(k + 2) + if x[k] > 0.0 { 0.5 } else { 0.0 };
        [first, second, real(0.0), real(0.0)]
    }
}

/// A frustum from z = 0 up, with its disks or without.
pub struct Frustum {
    radii: [Real; 2],
    height: Real,
    slant: Real,
    /// The areas of the lower disk, the side and the upper disk, over that of all.
    shares: [Real; 3],
    area: Real,
}

/// The part of the way from a radius to another within which a part of the area lies, by bisection.
fn way(from: Real, to: Real, area: Real) -> Real {
    let (mut low, mut high) = (real(0.0), real(1.0));
    while high - low > 1e-16 * high {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        // The mean circumference of the part, times its length.
        let within = middle * (from + 0.5 * middle * (to - from)) / (0.5 * (from + to));
        *(if within < area { &mut low } else { &mut high }) = middle;
    }
    if area <= 0.0 {
        real(0.0)
    } else {
        0.5 * (low + high)
    }
}

impl Frustum {
    pub fn new(radii: [Real; 2], height: Real, closed: bool) -> Self {
        let [lower, upper] = radii;
        let slant = height.hypot(lower - upper);
        let disk = |radius: Real| {
            if closed {
                PI * radius * radius
            } else {
                real(0.0)
            }
        };
        let areas = [disk(lower), PI * (lower + upper) * slant, disk(upper)];
        let area = areas.iter().sum();
        Self {
            radii,
            height,
            slant,
            shares: areas.map(|part| part / area),
            area,
        }
    }

    /// The normal of the side: outwards and upwards.
    pub fn slope(&self) -> [Real; 2] {
        [
            self.height / self.slant,
            (self.radii[0] - self.radii[1]) / self.slant,
        ]
    }

    /// The share of the side over its length.
    pub fn side(&self) -> Real {
        if self.slant > 0.0 {
            self.shares[1] / self.slant
        } else {
            real(0.0)
        }
    }
}

impl Truth for Frustum {
    fn sample(&self, u: Uniforms) -> Point {
        let ([lower, upper], [p, side, q]) = (self.radii, self.shares);
        let down = 1.0 - u[0];
        let (radius, z) = if u[0] < p {
            (lower * (u[0] / p).sqrt(), real(0.0))
        } else if down <= q {
            (upper * (down / q).sqrt(), self.height)
        } else {
            // From the nearer end.
            let [v, w] = [(u[0] - p) / side, (down - q) / side];
            if v < w {
                let up = way(lower, upper, v);
                (lower + up * (upper - lower), up * self.height)
            } else {
                let down = way(upper, lower, w);
                (upper + down * (lower - upper), (1.0 - down) * self.height)
            }
        };
        let (s, c) = (TAU * u[1]).sin_cos();
        [radius * c, radius * s, z]
    }
    fn pdf(&self, _: Point) -> Real {
        1.0 / self.area
    }
    fn invert(&self, x: Point) -> Uniforms {
        let ([lower, upper], [p, side, q]) = (self.radii, self.shares);
        let radius = x[0].hypot(x[1]);
        let first = if x[2] == 0.0 && p > 0.0 {
            p * (radius / lower).powi(2)
        } else if x[2] == self.height && q > 0.0 {
            1.0 - q * (radius / upper).powi(2)
        } else {
            let [steep, flat] = self.slope();
            let up = (x[2] * steep + (lower - radius) * flat) / self.slant;
            p + side * up * (2.0 * lower + up * (upper - lower)) / (lower + upper)
        };
        [first, turn(x[0], x[1]), real(0.0), real(0.0)]
    }
}

/// A capsule around the segment from z = 0 up.
pub struct Capsule {
    pub height: Real,
    pub radius: Real,
}

impl Capsule {
    fn whole(&self) -> Real {
        self.height + 2.0 * self.radius
    }
}

impl Truth for Capsule {
    fn sample(&self, u: Uniforms) -> Point {
        let r = self.radius;
        let [up, down] = [u[0] * self.whole(), (1.0 - u[0]) * self.whole()];
        let z = if up < down {
            up - r
        } else {
            self.height + r - down
        };
        let (s, c) = (TAU * u[1]).sin_cos();
        // Pythagoras, of the distances from both poles of a hemisphere.
        let part = up.min(down).min(r);
        let ring = (part * (2.0 * r - part)).sqrt();
        [ring * c, ring * s, z]
    }
    fn pdf(&self, _: Point) -> Real {
        1.0 / (TAU * self.radius * self.whole())
    }
    fn invert(&self, x: Point) -> Uniforms {
        let first = (x[2] + self.radius) / self.whole();
        [first, turn(x[0], x[1]), real(0.0), real(0.0)]
    }
}
