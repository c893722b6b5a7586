//! Contests of slices: our `fill` against single draws, ours and the peers'.

use crate::args::{DRAWN, FLOOR, LIBM, POLY, RAND_DISTR};
use crate::draws::{EXPONENT, lobe_power, with_pairs, word};
use host::contest::Contest;
use host::peers::rejecting;
use microwarp::{Warp, libm, poly};
use rand_pcg::Pcg32;

/// Points per fill.
const FILLED: usize = 4_096;
/// Fills timed together.
const REPEATS: usize = 2;

fn filled<P, L, W>(
    contest: Contest<P>,
    libm: L,
    poly: W,
    peer: impl Fn(&mut Pcg32) -> P + 'static,
) -> Contest<P>
where
    P: Copy + 'static,
    L: Warp<Point = P> + 'static,
    W: Warp<Point = P> + Copy + 'static,
{
    contest
        .warp_fill(LIBM, libm)
        .warp_fill(POLY, poly)
        .warp(DRAWN, poly)
        .draw(RAND_DISTR, peer)
}

/// A contest with the generator alone, which draws two words a point.
fn of_pairs<const N: usize>() -> Contest<[f32; N]> {
    with_pairs(Contest::of_blocks([0.0; N], FILLED, REPEATS))
}

pub fn disk() -> Contest<[f32; 2]> {
    filled(
        of_pairs(),
        libm::Disk::new(),
        poly::Disk::new(),
        rejecting::disk,
    )
}

pub fn sphere() -> Contest<[f32; 3]> {
    filled(
        of_pairs(),
        libm::Sphere::new(),
        poly::Sphere::new(),
        rejecting::sphere,
    )
}

pub fn hemisphere() -> Contest<[f32; 3]> {
    let (libm, poly) = (libm::Hemisphere::new(), poly::Hemisphere::new());
    filled(of_pairs(), libm, poly, rejecting::hemisphere)
}

pub fn cosine_hemisphere() -> Contest<[f32; 3]> {
    let (libm, poly) = (libm::CosineHemisphere::new(), poly::CosineHemisphere::new());
    filled(of_pairs(), libm, poly, rejecting::cosine_hemisphere)
}

pub fn lobe() -> Contest<[f32; 3]> {
    let n = f32::from(EXPONENT);
    let (libm, poly) = (libm::PhongLobe::new(n), poly::PhongLobe::new(n));
    let power = lobe_power();
    let peer = move |rng: &mut Pcg32| rejecting::lobe(power, rng);
    filled(of_pairs(), libm.unwrap(), poly.unwrap(), peer)
}

pub fn exponential() -> Contest<f32> {
    let (libm, poly) = (
        libm::Exponential::from_rate(1.0),
        poly::Exponential::from_rate(1.0),
    );
    let floor = Contest::of_blocks(0.0, FILLED, REPEATS).draw(FLOOR, word);
    filled(floor, libm.unwrap(), poly.unwrap(), rejecting::exponential)
}

/// Pairs, of which each counts as two.
pub fn normal() -> Contest<[f32; 2]> {
    let libm = libm::NormalPair::new([0.0; 2], 1.0);
    let poly = poly::NormalPair::new([0.0; 2], 1.0);
    let peer = |rng: &mut Pcg32| [rejecting::normal(rng), rejecting::normal(rng)];
    filled(of_pairs(), libm.unwrap(), poly.unwrap(), peer).counting(2)
}
