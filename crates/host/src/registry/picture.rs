//! How the points of a warp come onto paper: what the gallery draws of an entry.

use std::f64::consts::FRAC_1_SQRT_2;

/// One picture of the gallery.
#[derive(Clone, Copy, Debug)]
pub struct Picture {
    /// What stands under the name in the picture.
    pub caption: &'static str,
    pub view: View,
}

/// How points come onto paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// A histogram with the density between two values.
    Line(Axes),
    /// A square window of the plane.
    Plane {
        centre: [f64; 2],
        half: f64,
    },
    /// Directions up to the given angle from +z (in radians), in Lambert's equal-area projection.
    Sky(f64),
    /// A triangle, through a linear map of its points onto the paper.
    Triangle([[f64; 3]; 2]),
    /// Faces of a mesh, each by its corners on the paper. A point is the number of its face and the shares of the second and
    /// the third corner.
    Faces(&'static [[[f64; 2]; 3]]),
    /// Rectangles of a box's faces side by side, within so far of the middle.
    Net(&'static [Face], f64),
    /// A solid seen from a corner, z upwards.
    Solid(Body),
    /// Plain and jittered uniforms, side by side.
    Strata1d,
    Strata2d,
    /// Plain uniforms beside points.
    Sobol,
    Recurrence,
    ByPosition,
    /// Errors of neighbouring pixels, with a set each and with one for all.
    Screen,
}

/// A rectangle of points, and where its corner lies on paper; lengths are the same there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    pub corner: [f64; 3],
    pub sides: [[f64; 3]; 2],
    pub at: [f64; 2],
}

/// Convex bodies that stand on the plane z = 0, but for what lies below a capsule's axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body {
    /// Radii below and above, height.
    Frustum([f64; 2], f64),
    /// Height and radius.
    Capsule(f64, f64),
}

impl Body {
    /// So far from the surface a point is at least, with a sign: negative inside, 0 on the surface alone.
    pub fn distance(self, [x, y, z]: [f64; 3]) -> f64 {
        match self {
            Self::Frustum([lower, upper], height) => {
                let wider = upper - lower;
                let side = ((x.hypot(y) - lower) * height - z * wider) / height.hypot(wider);
                side.max(-z).max(z - height)
            }
            Self::Capsule(height, radius) => x.hypot(y).hypot(z - z.clamp(0.0, height)) - radius,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    pub from: f64,
    pub to: f64,
    /// The lowest density shown: 0 for a linear axis, more for a logarithmic one.
    pub bottom: f64,
    /// The highest density shown; infinite for whatever the density needs.
    pub top: f64,
    /// Whether x runs logarithmically.
    pub log_x: bool,
}

/// A histogram between two values.
pub const fn between(from: f64, to: f64) -> Axes {
    Axes {
        from,
        to,
        bottom: 0.0,
        top: f64::INFINITY,
        log_x: false,
    }
}

/// A square window of the plane.
pub const fn window(x: f64, y: f64, half: f64) -> View {
    View::Plane {
        centre: [x, y],
        half,
    }
}

impl Axes {
    pub const fn log_y(self, bottom: f64) -> Self {
        Self { bottom, ..self }
    }

    pub const fn log_x(self) -> Self {
        Self {
            log_x: true,
            ..self
        }
    }

    pub const fn top(self, top: f64) -> Self {
        Self { top, ..self }
    }
}

/// Barycentric coordinates onto an equilateral triangle, u at the top.
pub const EQUILATERAL: View = View::Triangle([[0.5, 0.0, 1.0], [0.866_025, 0.0, 0.0]]);
/// The plane as it is.
pub const FLAT: View = View::Triangle([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
/// Space seen from a corner, z upwards.
pub const CORNER: View = View::Triangle([
    [-FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0],
    [-0.408_248, -0.408_248, 0.816_497],
]);
