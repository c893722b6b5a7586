//! The list of pictures: one line each, naming an entry of `tests/catalogue` and how it is looked at.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};
use support::registry::Entry;

/// A picture and what the catalogue knows of it in each tier; nothing for strata.
pub struct Subject<'a> {
    pub picture: &'static Picture,
    pub entries: Vec<&'a Entry>,
}

/// One picture of the gallery.
pub struct Picture {
    /// Name and parameters of the entry, as `tests/catalogue` has them.
    pub name: &'static str,
    pub parameters: &'static str,
    /// What stands under the name in the picture.
    pub caption: &'static str,
    pub view: View,
}

/// How the points of a warp come onto paper.
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
    /// Plain and jittered uniforms, side by side.
    Strata1d,
    Strata2d,
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

impl Axes {
    const fn log_y(self, bottom: f64) -> Self {
        Self { bottom, ..self }
    }
    const fn log_x(self) -> Self {
        Self {
            log_x: true,
            ..self
        }
    }
    const fn top(self, top: f64) -> Self {
        Self { top, ..self }
    }
}

const fn from(from: f64, to: f64) -> Axes {
    Axes {
        from,
        to,
        bottom: 0.0,
        top: f64::INFINITY,
        log_x: false,
    }
}

const fn line(
    name: &'static str,
    parameters: &'static str,
    caption: &'static str,
    axes: Axes,
) -> Picture {
    Picture {
        name,
        parameters,
        caption,
        view: View::Line(axes),
    }
}

const fn area(
    name: &'static str,
    parameters: &'static str,
    caption: &'static str,
    view: View,
) -> Picture {
    Picture {
        name,
        parameters,
        caption,
        view,
    }
}

const fn window(x: f64, y: f64, half: f64) -> View {
    View::Plane {
        centre: [x, y],
        half,
    }
}

/// Barycentric coordinates onto an equilateral triangle, u at the top.
const EQUILATERAL: View = View::Triangle([[0.5, 0.0, 1.0], [0.866_025, 0.0, 0.0]]);
/// The plane as it is.
const FLAT: View = View::Triangle([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
/// Space seen from a corner, z upwards.
const CORNER: View = View::Triangle([
    [-FRAC_1_SQRT_2, FRAC_1_SQRT_2, 0.0],
    [-0.408_248, -0.408_248, 0.816_497],
]);

#[rustfmt::skip] // one line a picture
pub const PICTURES: &[Picture] = &[
    line("Interval", "[-3, 5]", "uniform on [−3, 5)", from(-4.0, 6.0)),
    line("Interval decreasing", "[-3, 5]", "the same, 5 first", from(-4.0, 6.0)),
    line("Linear", "1 to 3", "p ∝ 1 + 2x", from(-0.1, 1.1)),
    line("Tent", "r=1", "p = 1 − |x|", from(-1.2, 1.2)),
    line("Inversion", "p=1/2+x", "a user's inverse CDF: p = ½ + x", from(-0.1, 1.1)),
    line("Power", "n=2.5 [0, 1]", "p ∝ x^2.5 on [0, 1]", from(-0.1, 1.1)),
    line("Power", "n=-1 [1, 100]", "p ∝ 1/x on [1, 100]", from(0.794_328, 125.892_54).log_x().log_y(1e-3)),
    line("Power decreasing", "n=-0.5 [0, 4]", "p ∝ 1/√x on [0, 4], 4 first", from(-0.3, 4.3).top(1.7)),
    line("PowerMax", "N=4", "largest of 4 uniforms: p = 4x³", from(-0.1, 1.1)),
    line("Transform", "y=sin x", "y = sin x, with p(x) = 2x", from(-0.1, 1.0)),
    line("Exponential", "a=1", "p = exp(−x)", from(-0.4, 6.0)),
    line("ExponentialTail", "a=1", "p = exp(−x), the tail first", from(-0.4, 9.3).log_y(1e-4)),
    line("TruncatedExponential", "c=2 X=3", "p ∝ exp(−2x) on [0, 3]", from(-0.3, 3.3)),
    line("TruncatedExponential", "c=-2 X=3", "p ∝ exp(2x) on [0, 3]", from(-0.3, 3.3)),
    line("Normal", "0, 1", "mean 0, deviation 1", from(-4.0, 4.0)),
    line("PiecewiseConstant1d", "2:0:4:1 on [0, 8]", "cells of weight 2, 0, 4 and 1", from(-0.4, 8.4)),
    area("NormalPair", "0, 1", "Box and Muller, within 3σ", window(0.0, 0.0, 3.0)),
    area("Disk", "", "polar map", window(0.0, 0.0, 1.02)),
    area("DiskConcentric", "", "Shirley's concentric map", window(0.0, 0.0, 1.02)),
    area("MarginalConditional", "0<y<x<1", "p(x) = 2x, p(y | x) = 1/x", window(0.5, 0.5, 0.51)),
    area("Aabb", "[-1, 1] x [2, 2.5]", "uniform on a box", window(0.0, 2.25, 1.05)),
    area("PiecewiseConstant2d", "32 x 16 sky", "clouds, a sun, a dark row", window(0.5, 0.5, 0.51)),
    area("SphericalPatch", "octant", "0 ≤ θ ≤ 90°, 0 ≤ φ ≤ 90°", View::Sky(FRAC_PI_2)),
    area("Triangle", "", "barycentric coordinates", EQUILATERAL),
    area("TriangleOn", "plane", "(0, 0), (4, 0), (1, 3)", FLAT),
    area("TriangleOn", "space", "three vertices in space", CORNER),
    area("Strata1d", "24", "24 strata, one point in each", View::Strata1d),
    area("Strata2d", "10 × 16", "10 × 16 strata, one point in each", View::Strata2d),
    area("Sphere", "", "all directions", View::Sky(PI)),
    area("SphericalPatch", "band", "72° ≤ θ ≤ 108°, every φ", View::Sky(PI)),
    area("Oriented", "cosine about (1, 2, 3)", "cosine about (1, 2, 3)", View::Sky(PI)),
    area("Hemisphere", "", "the upper half", View::Sky(FRAC_PI_2)),
    area("CosineHemisphere", "", "p = cos θ / π, by inversion", View::Sky(FRAC_PI_2)),
    area("MalleyHemisphere", "", "p = cos θ / π, Malley's method", View::Sky(FRAC_PI_2)),
    area("PhongLobe", "n=50", "p ∝ cosⁿθ, n = 50", View::Sky(0.5)),
    area("PhongLobe", "n=1e6", "p ∝ cosⁿθ, n = 10⁶", View::Sky(0.0035)),
    area("Cone", "0.1 rad", "half angle 0.1 rad", View::Sky(0.102)),
    area("Cone", "1e-7 rad", "half angle 10⁻⁷ rad", View::Sky(1.02e-7)),
];
