//! Maps made of others: a direction times a radius, two points of a disk, and a normal pair scaled and moved.

use crate::bounds::Roundings;
use crate::inputs::{STRIDE, Uniforms, in_parallel};
use crate::radii::{Bin, Radii, radii};
use crate::range::Range;
use crate::rounding::UNIT;
use crate::several::Cells;
use host::errors::raise;
use microwarp::Warp;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::Ball;
use std::f64::consts::SQRT_2;

/// How many ulp the cube root is off, over every `f32` from 2⁻⁸⁹ to 1. Below 2⁻⁸⁸ it is that of 2⁶⁰ times the number, over 2²⁰.
fn cube_root() -> f64 {
    let first = 2.0_f32.powi(-89).to_bits();
    let ball = Ball::<Poly>::new();
    let worst = in_parallel(512, |part| {
        let mut worst = 0.0_f64;
        for bits in (first + part..1.0_f32.to_bits()).step_by(512 * *STRIDE as usize) {
            let u = f32::from_bits(bits);
            let [_, _, r] = ball.sample([u, 0.0, 0.0]);
            let (u, r) = (f64::from(u), f64::from(r));
            // r - ∛u is (r³ - u)/3r², but for the square of its relative size.
            let off = (r * r * r - u).abs() / (3.0 * r * r) * (1.0 + 1e-6);
            let ulp = f64::from_bits(((r.to_bits() >> 52) - 23) << 52);
            let error = off / ulp;
            raise(&mut worst, error);
        }
        worst
    });
    worst.into_iter().fold(0.0, f64::max)
}

/// The ball's point is the sphere's times the radius. Its products with the radius are rounded by at most half an ulp of 1.
pub fn ball(cells: &Cells) -> [f64; 2] {
    let root = cube_root() * UNIT;
    assert!(root <= 0.51 * UNIT, "the cube root is off by {root:e}");
    let spheres = [
        radii::<Libm>("Sphere", Uniforms::Any, 0),
        radii::<Poly>("Sphere", Uniforms::Any, 0),
    ];
    let mut bounds = [0.0; 2];
    for ((mut sphere, cells), bound) in spheres.into_iter().zip(cells).zip(&mut bounds) {
        for bin in &mut sphere.bins {
            bin.off = bin.off.wider(root * bin.r + 0.5 * UNIT);
            bin.height = bin.height.wider(root + 0.5 * UNIT);
        }
        *bound = Roundings::PLAIN.sample(&sphere, cells).bound;
    }
    bounds
}

/// √u₁ at one angle and √(1 - u₁) at another, of which the phase u₂/2 - 1/4 is rounded by 2⁻²⁷ at most.
fn rotation_of<T: Tier>(cells: &[crate::phases::Cell]) -> f64 {
    let halves = radii::<T>("CosineHemisphere", Uniforms::Any, 0);
    let turned = std::f64::consts::TAU * UNIT / 8.0;
    let bounds = halves.bins.iter().map(|bin| {
        let flat = |r: f64, off: Range, turn: f64| {
            let height = Range::only(0.0);
            let radii = Radii::of(vec![Bin {
                r,
                off,
                height,
                ..*bin
            }]);
            let roundings = Roundings {
                turn,
                ..Roundings::PLAIN
            };
            roundings.sample(&radii, cells).bound
        };
        let other = (1.0 - bin.uniforms.low).sqrt() + UNIT;
        flat(bin.r, bin.off, 0.0).hypot(flat(other.min(1.0), bin.height, turned))
    });
    bounds.fold(0.0, f64::max)
}

pub fn rotation([libm, poly]: &Cells) -> [f64; 2] {
    [rotation_of::<Libm>(libm), rotation_of::<Poly>(poly)]
}

/// The farthest that a pair lies from its mean, in deviations, as its size counts.
const REACH: f64 = 5.77;

/// A pair of any parameters, in units of its size. To the errors of the standard pair's radius and angle come three roundings: of
/// the radius times the deviation and of both products, each relative to the radius, and of the sums with the mean, each of which is
/// no larger than the size. Deviations are above 1e-20, and what is subnormal has steps of 2^-149.
fn normal_pair_of<T: Tier>(cells: &[crate::phases::Cell]) -> f64 {
    let radii = radii::<T>("NormalPair", Uniforms::Any, 0);
    let exact = Roundings {
        products: false,
        ..Roundings::PLAIN
    };
    let factors = exact.sample(&radii, cells).bound;
    let reach = radii.bins.iter().map(|bin| bin.r).fold(0.0, f64::max);
    assert!(reach <= REACH, "{reach}");
    (factors + 2.0 * UNIT * reach) / REACH * (1.0 + 1e-6) + SQRT_2 * UNIT
}

pub fn normal_pair([libm, poly]: &Cells) -> [f64; 2] {
    [normal_pair_of::<Libm>(libm), normal_pair_of::<Poly>(poly)]
}
