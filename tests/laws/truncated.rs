//! The steep rise of a truncated exponential, whose power e^|z| leaves the range of `f32`: right down to
//! x = 0. The map that was there before, measured from the far end alone, fails here. And of a truncated normal the least
//! uniforms, and how far it turns back between neighbours.

use host::errors::{ulp, ulps};
use host::truth::{self, Truth};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::{TruncatedExponential, TruncatedNormal};
use microwarp::{Error, Warp, poly};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// What the documentation states, in ulp.
const STATED: f64 = 4.4;

/// The steep form as it was.
fn from_the_far_end<T: Tier>(rate: f32, length: f32, u: f32) -> f32 {
    let least = T::exp(rate * length);
    (length + T::ln(u + (1.0 - u) * least) / -rate).clamp(0.0, length)
}

/// By how many ulp a sample of the uniform is off.
fn error_of<T: Tier>(warp: &TruncatedExponential<T>, rate: f32, length: f32, u: f32) -> f64 {
    let truth = truth::truncated_exponential(rate, length);
    let [exact, ..] = truth.sample([f64::from(u), 0.0, 0.0, 0.0]);
    ulps(warp.sample(u), exact)
}

/// Up to |z| = 1/2 the map is a series; each of its terms counts somewhere.
fn gentle_slopes_are_right<T: Tier>() {
    let mut rng = Pcg32::new(17, 3);
    let mut unit = move || (f64::from(rng.next_u32()) / 4_294_967_296.0) as f32;
    for k in 0..20_000 {
        let z = if k % 2 == 0 {
            0.499_999_97
        } else {
            unit() * 0.5
        };
        let rate = if k % 3 == 0 { z } else { -z };
        let warp = TruncatedExponential::<T>::from_rate(rate, 1.0).unwrap();
        let u = unit();
        let error = error_of(&warp, rate, 1.0, u);
        assert!(error <= STATED, "{rate} at {u}: {error} ulp");
    }
}

#[test]
fn gentle_slopes_are_right_in_both_tiers() {
    gentle_slopes_are_right::<Libm>();
    gentle_slopes_are_right::<Poly>();
}

fn steep_rises_are_right<T: Tier>() {
    let mut rng = Pcg32::new(13, 3);
    let mut unit = move || f64::from(rng.next_u32()) / 4_294_967_296.0;
    let mut control = [0.0, 0.0];
    for _ in 0..200_000 {
        let length = 10_f64.powf(-30.0 + 60.0 * unit()) as f32;
        let rate = -((75.0 + 115.0 * unit()) / f64::from(length)) as f32;
        let warp = TruncatedExponential::<T>::from_rate(rate, length).unwrap();
        let start = warp.sample(0.0);
        assert!(start == 0.0, "{rate} {length}: {start} at 0");
        let z = f64::from(rate) * f64::from(length);
        if z > -104.0 && z < -87.3 {
            let old = from_the_far_end::<T>(rate, length, 0.0);
            control[0] = f64::max(control[0], f64::from(old / length));
        }
        let u = 10_f64.powf(-45.0 * unit().powi(2)) as f32;
        let u = if u > 0.0 && u < 1.0 { u } else { 0.5 };
        let truth = truth::truncated_exponential(rate, length);
        let [exact, ..] = truth.sample([f64::from(u), 0.0, 0.0, 0.0]);
        let off = |x: f32| ulps(x, exact);
        let error = off(warp.sample(u));
        assert!(error <= STATED, "{rate} {length} at {u}: {error} ulp");
        control[1] = f64::max(control[1], off(from_the_far_end::<T>(rate, length, u)));
    }
    assert!(control[0] > 1e-3 && control[1] > 1e3, "{control:?}");
}

#[test]
fn steep_rises_are_right_in_both_tiers() {
    steep_rises_are_right::<Libm>();
    steep_rises_are_right::<Poly>();
}

/// Uniforms off the grid, small enough that a product by the power is subnormal or a length per uniform
/// overflows.
#[test]
fn the_least_uniforms_keep_their_digits() {
    for (rate, length) in [
        (-60e-30, 1e30),
        (-2e-39, 3.4e38),
        (1e-39, 3.4e38),
        (0.3, 1.0),
    ] {
        let warp = TruncatedExponential::<Poly>::from_rate(rate, length).unwrap();
        let truth = truth::truncated_exponential(rate, length);
        for k in 1..1_000 {
            let u = f32::from_bits(k * 15_000);
            let [exact, ..] = truth.sample([f64::from(u), 0.0, 0.0, 0.0]);
            let error = ulps(warp.sample(u), exact);
            assert!(error <= STATED, "{rate} {length} at {u:e}: {error} ulp");
        }
    }
}

/// From 0 up a sample is nearly u times a length, in `f32` once a subnormal uniform times a number near 1.
#[test]
fn a_truncated_normal_keeps_the_digits_of_the_least_uniforms() {
    fn worst<T: Tier>(law: Result<TruncatedNormal<T>, Error>, truth: &dyn Truth) -> f64 {
        let law = law.unwrap();
        let error = |k: u32| {
            let u = f32::from_bits(k * k);
            let [exact, ..] = truth.sample([f64::from(u), 0.0, 0.0, 0.0]);
            ulps(law.sample(u), exact)
        };
        (1..3_000).map(error).fold(0.0, f64::max)
    }
    for deviation in [1.0, 1e10, 1e30, 1e36] {
        let truth = truth::TruncatedNormal::new(0.0, deviation, 0.0, f32::INFINITY);
        let libm = TruncatedNormal::<Libm>::above(0.0, deviation, 0.0);
        let poly = TruncatedNormal::<Poly>::above(0.0, deviation, 0.0);
        let off = worst(libm, &truth).max(worst(poly, &truth));
        assert!(off <= 14.0, "deviation {deviation}: {off} ulp");
    }
    let [exact, ..] = truth::TruncatedNormal::new(0.0, 1e30, 0.0, f32::INFINITY).sample([
        2f64.powi(-149),
        0.0,
        0.0,
        0.0,
    ]);
    let rounded_first = (f32::from_bits(1) * 1.253_314_1) * 1e30;
    assert!(ulps(rounded_first, exact) > 1e6);
}

/// It turns back, but by no more than its page says.
#[test]
fn a_truncated_normal_turns_back_by_two_ulp_at_most() {
    const STEP: f32 = 1.0 / 16_777_216.0;
    let (mut back, mut most) = (0, 0.0_f64);
    for (low, high) in [(-1.0, 2.0), (-0.5, 0.5), (0.25, 3.0), (-6.0, 1.0)] {
        let law = poly::TruncatedNormal::new(0.0, 1.0, low, high).unwrap();
        for k in 1..1 << 20 {
            // Neighbours in 64 runs over the grid.
            let at = (k % 64) * (1 << 18) + k / 64;
            let (here, next) = (
                law.sample(at as f32 * STEP),
                law.sample((at + 1) as f32 * STEP),
            );
            if next < here {
                back += 1;
                let unit = ulp(f64::from(here).abs().max(1.0));
                most = most.max(f64::from(here - next) / unit);
            }
        }
    }
    println!("{back} steps back, by up to {most} ulp");
    assert!(
        back > 0 && most <= 2.0,
        "{back} steps back, by up to {most} ulp"
    );
}
