//! Which moments of the samples are tested over each kind of domain, and in which coordinates.

use host::registry::Domain;
use host::truth::{self, Point};

/// A function of a point whose mean is tested.
#[derive(Clone, Copy)]
pub enum Moment {
    First(usize),
    Second(usize),
    Mixed(usize, usize),
}

impl Moment {
    pub fn of(self, t: &Point) -> f64 {
        match self {
            Self::First(i) => t[i],
            Self::Second(i) => t[i] * t[i],
            Self::Mixed(i, j) => t[i] * t[j],
        }
    }

    pub fn name(self) -> String {
        let axis = |i| ["x", "y", "z"][i];
        match self {
            Self::First(i) => format!("mean {}", axis(i)),
            Self::Second(i) => format!("mean {}²", axis(i)),
            Self::Mixed(i, j) => format!("mean {}{}", axis(i), axis(j)),
        }
    }
}

/// Which moments are tested over a domain.
pub fn moments(domain: Domain) -> Vec<Moment> {
    use Moment::{First, Mixed, Second};
    match domain {
        Domain::Line => vec![First(0), Second(0)],
        Domain::Plane => vec![First(0), First(1), Second(0), Second(1), Mixed(0, 1)],
        _ => (0..3).map(First).chain((0..3).map(Second)).collect(),
    }
}

/// How many uniforms the charts of a domain have.
pub fn axes(domain: Domain) -> usize {
    match domain {
        Domain::Line => 1,
        Domain::Solid | Domain::Rotations => 3,
        _ => 2,
    }
}

/// How many tests one run over a domain makes.
pub fn tests(domain: Domain) -> usize {
    1 + axes(domain) + moments(domain).len()
}

/// In which coordinates moments are taken.
#[derive(Clone, Copy, PartialEq)]
pub enum Coordinates {
    Point,
    /// 1 − cos θ in the place of z, where the lobe is so narrow that z itself is rounded away.
    Complement,
    /// The place in the chart's unit square, and the product of its coordinates, where the tail of x is too heavy for its
    /// moments to be normal, or x jumps; in a cube with its third coordinate. On the line that is F(x).
    Quantile,
}

impl Coordinates {
    pub fn of(self, x: Point, [u, v, w]: Point) -> Point {
        match self {
            Self::Point => x,
            Self::Complement => [x[0], x[1], truth::complements(x).0],
            Self::Quantile => [u, v, u * v + w],
        }
    }
}
