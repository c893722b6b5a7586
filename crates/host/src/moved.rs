//! What the rounding of a point does by itself to its density and its inverse.

use crate::errors::{apart, ulp};
use crate::figures::{Exact, is_azimuth, wide};
use crate::registry::{Domain, Entry, Measure};
use crate::truth::Truth;

/// What rounding the point by one unit does to the exact density, relatively, and to the exact inverse: `s` and `r` of the
/// formulas. The larger of what it does at the exact point and at the returned one.
#[derive(Default)]
pub struct Moved {
    pub density: f64,
    pub inverse: f64,
}

impl Moved {
    pub fn of(entry: &Entry, exact: &Exact, x: [f32; 3]) -> Self {
        let (a, b) = (Self::at(entry, exact.point), Self::at(entry, wide(x)));
        Self {
            density: a.density.max(b.density),
            inverse: a.inverse.max(b.inverse),
        }
    }

    fn at(entry: &Entry, point: [f64; 3]) -> Self {
        let truth: &dyn Truth = entry.truth.as_ref();
        let (density, inverse) = (truth.pdf(point), truth.invert(point));
        let mut moved = Self::default();
        for (k, unit) in units(entry, point).into_iter().enumerate() {
            if unit == 0.0 {
                continue;
            }
            let (mut relative, mut turned): (f64, f64) = (0.0, 0.0);
            for by in [unit, -unit] {
                let mut there = point;
                there[k] += by;
                // What is not a number lies outside the domain and says nothing; `max` passes it over.
                relative = relative.max((truth.pdf(there) - density).abs() / density);
                let back = truth.invert(there);
                for i in 0..entry.uniforms {
                    turned = turned.max(apart(back[i], inverse[i], is_azimuth(entry, i)));
                }
            }
            moved.density += relative;
            moved.inverse += turned;
        }
        moved
    }
}

/// The unit of rounding of each coordinate; 0 for those that a point of the domain does not have.
fn units(entry: &Entry, point: [f64; 3]) -> [f64; 3] {
    const HALF_STEP: f64 = 1.0 / 16_777_216.0;
    match (entry.domain, entry.measure) {
        (Domain::Line, Measure::UlpOf(scale)) => [ulp(scale), 0.0, 0.0],
        (Domain::Line, Measure::UlpFrom(mean, least)) => {
            let size = (point[0] - mean).abs().max(mean.abs()).max(least);
            [ulp(size), 0.0, 0.0]
        }
        (Domain::Line, Measure::UlpAbove(least)) => [ulp(point[0].abs().max(least)), 0.0, 0.0],
        (Domain::Line, _) => [ulp(point[0]), 0.0, 0.0],
        (Domain::Plane, Measure::Length(size)) => [size * HALF_STEP, size * HALF_STEP, 0.0],
        (Domain::Plane, Measure::From(middle)) => {
            let size = Measure::far(middle, point);
            [size * HALF_STEP, size * HALF_STEP, 0.0]
        }
        (Domain::Directions, _) => {
            let sine = point[0].hypot(point[1]);
            [ulp(sine), ulp(sine), ulp(point[2])]
        }
        (_, Measure::Length(size)) => [size * HALF_STEP; 3],
        _ => point.map(ulp),
    }
}
