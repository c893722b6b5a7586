//! Contests of slices: our `fill` beside single draws, ours and the peers'.

use crate::contest::Contest;
use crate::draws::{EXPONENT, lobe_power};
use crate::families::{LIBM, POLY, POLY_SINGLE, RAND_DISTR};
use crate::peers::rejecting;
use microwarp::{Warp, libm, poly};
use rand_pcg::Pcg32;

/// Points that are filled at once.
const FILLED: usize = 4_096;
/// How often, timed together.
const REPEATS: usize = 2;

fn filled<P, L, W>(
    blank: P,
    libm: L,
    poly: W,
    peer: impl Fn(&mut Pcg32) -> P + 'static,
) -> Contest<P>
where
    P: Copy + 'static,
    L: Warp<Point = P> + 'static,
    W: Warp<Point = P> + Copy + 'static,
{
    Contest::of_blocks(blank, FILLED, REPEATS)
        .warp_fill(LIBM, libm)
        .warp_fill(POLY, poly)
        .warp(POLY_SINGLE, poly)
        .draw(RAND_DISTR, peer)
}

pub fn disk() -> Contest<[f32; 2]> {
    filled(
        [0.0; 2],
        libm::Disk::new(),
        poly::Disk::new(),
        rejecting::disk,
    )
}

pub fn sphere() -> Contest<[f32; 3]> {
    filled(
        [0.0; 3],
        libm::Sphere::new(),
        poly::Sphere::new(),
        rejecting::sphere,
    )
}

pub fn hemisphere() -> Contest<[f32; 3]> {
    let (libm, poly) = (libm::Hemisphere::new(), poly::Hemisphere::new());
    filled([0.0; 3], libm, poly, rejecting::hemisphere)
}

pub fn cosine_hemisphere() -> Contest<[f32; 3]> {
    let (libm, poly) = (libm::CosineHemisphere::new(), poly::CosineHemisphere::new());
    filled([0.0; 3], libm, poly, rejecting::cosine_hemisphere)
}

pub fn lobe() -> Contest<[f32; 3]> {
    let n = f32::from(EXPONENT);
    let (libm, poly) = (libm::PhongLobe::new(n), poly::PhongLobe::new(n));
    let power = lobe_power();
    let peer = move |rng: &mut Pcg32| rejecting::lobe(power, rng);
    filled([0.0; 3], libm.unwrap(), poly.unwrap(), peer)
}

pub fn exponential() -> Contest<f32> {
    let (libm, poly) = (libm::Exponential::new(1.0), poly::Exponential::new(1.0));
    filled(0.0, libm.unwrap(), poly.unwrap(), rejecting::exponential)
}

/// Pairs, of which each counts as two.
pub fn normal() -> Contest<[f32; 2]> {
    let libm = libm::NormalPair::new([0.0; 2], 1.0);
    let poly = poly::NormalPair::new([0.0; 2], 1.0);
    let peer = |rng: &mut Pcg32| [rejecting::normal(rng), rejecting::normal(rng)];
    filled([0.0; 2], libm.unwrap(), poly.unwrap(), peer).counting(2)
}
