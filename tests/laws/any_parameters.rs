//! Whatever parameters a constructor accepts, the warp is total: finite samples of positive, finite
//! density, inverses in [0, 1), and a warp that equals itself. Parameters are random bit patterns.

use microwarp::discrete::{PiecewiseConstant1d, PiecewiseConstant2d};
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::warp::*;
use microwarp::{Error, Frame, Warp};
use rand_core::Rng;
use rand_pcg::Pcg32;
use std::fmt::Debug;
use support::registry::Flat;

const ROUNDS: u32 = 6_000;

/// Uniforms at which maps break, and some between.
const UNIFORMS: [[f32; 4]; 10] = [
    [0.0; 4],
    [1.0; 4],
    [f32::NAN; 4],
    [0.0, 0.999_999_94, 0.5, 0.5],
    [0.999_999_94, 0.0, 0.5, 0.5],
    [1e-45, 0.5, 1e-45, 0.5],
    [5.960_464_5e-8, 0.123, 0.7, 0.2],
    [0.5, 0.25, 0.75, 0.125],
    [0.3, 0.898, 0.4, 0.6],
    [0.82, 0.374_9, 0.9, 0.1],
];

/// A float of any kind: any bits, any magnitude, or a small comfortable number.
pub fn any(rng: &mut Pcg32) -> f32 {
    let word = rng.next_u32();
    match word % 4 {
        0 => f32::from_bits(rng.next_u32()),
        1 => {
            (1.0 + (rng.next_u32() >> 9) as f32 * f32::EPSILON)
                * 2f32.powi((word >> 8) as i32 % 127)
        }
        2 => ((rng.next_u32() >> 8) as f32 / 16_777_216.0 - 0.5) * 4.0,
        _ => (rng.next_u32() >> 8) as f32 / 16_777_216.0,
    }
}

struct Tally(u32);

impl Tally {
    /// Checks the laws on an accepted warp, and counts it.
    fn check<W>(&mut self, built: Result<W, Error>, parameters: &[f32])
    where
        W: Warp<Density = f32> + Debug + PartialEq + Copy,
        W::Uniforms: Flat<4>,
        W::Point: Flat<3>,
    {
        let Ok(warp) = built else { return };
        self.0 += 1;
        let copy = warp;
        assert!(warp == copy, "{parameters:?}: {warp:?} is not itself");
        for u in UNIFORMS {
            let x = warp.sample(W::Uniforms::unflat(u));
            let pdf = warp.pdf(x);
            let back = warp.invert(x).flat();
            let point = x.flat();
            assert!(
                point.iter().all(|c| c.is_finite()) && pdf > 0.0 && pdf <= f32::MAX,
                "{parameters:?} at {u:?}: {point:?} has {pdf}: {warp:?}"
            );
            assert!(
                back.iter().all(|u| (0.0..1.0).contains(u)),
                "{parameters:?} at {u:?}: {point:?} comes from {back:?}: {warp:?}"
            );
        }
    }
}

fn every_constructor<T: Tier>() {
    let mut rng = Pcg32::new(2_026, 11);
    let mut tally = [const { Tally(0) }; 17];
    for _ in 0..ROUNDS {
        let p: [f32; 9] = std::array::from_fn(|_| any(&mut rng));
        let [a, b, c, d, ..] = p;
        let (low, high) = if a < b { (a, b) } else { (b, a) };
        let [t0, t1] = [c, d].map(|t| t.abs() % 0.5);
        let (t0, t1) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
        tally[0].check(Interval::new(low, high), &p);
        tally[0].check(Interval::decreasing(low, high), &p);
        tally[1].check(
            Power::<T>::new(c, low.abs().min(high.abs()), low.abs().max(high.abs())),
            &p,
        );
        tally[1].check(Power::<T>::decreasing(c, 0.0, high.abs()), &p);
        tally[2].check(Exponential::<T>::new(a), &p);
        tally[2].check(ExponentialTail::<T>::new(b), &p);
        tally[3].check(TruncatedExponential::<T>::new(a, b), &p);
        tally[4].check(Tent::new(a), &p);
        tally[5].check(Linear::new(a, b), &p);
        tally[6].check(Normal::<T>::new(a, b), &p);
        tally[7].check(NormalPair::<T>::new([a, b], c), &p);
        tally[8].check(TriangleOn::new([[a, b], [c, d], [p[4], p[5]]]), &p);
        tally[9].check(
            TriangleOn::new([[a, b, c], [d, p[4], p[5]], [p[6], p[7], p[8]]]),
            &p,
        );
        tally[10].check(PhongLobe::<T>::new(a), &p);
        tally[11].check(Cone::<T>::from_angle(a), &p);
        tally[11].check(Cone::<T>::from_sphere(b), &p);
        tally[12].check(Cone::<T>::from_one_minus_cos(c), &p);
        let phi = if a.abs() <= 1.0 { a } else { 0.25 };
        tally[13].check(
            SphericalPatch::<T>::new(t0, t1, phi, phi + b.abs() % 1.0),
            &p,
        );
        let weights = [c, d, p[4], p[5]].map(f32::abs);
        tally[15].check(
            PiecewiseConstant1d::<[u32; 4]>::from_weights(&weights, low, high),
            &p,
        );
        tally[15].check(
            PiecewiseConstant1d::<[u64; 4]>::from_weights(&weights, low, high),
            &p,
        );
        let rows = [
            [weights[0], 0.0, weights[1]],
            [0.0; 3],
            [0.0, weights[2], weights[3]],
        ];
        let (across, along) = ([low, high], [p[6].min(p[7]), p[6].max(p[7])]);
        tally[16].check(
            PiecewiseConstant2d::<[u32; 3], [[u32; 3]; 3]>::new(&rows, across, along),
            &p,
        );
        tally[16].check(
            PiecewiseConstant2d::<[u64; 3], [[u64; 3]; 3]>::new(&rows, across, along),
            &p,
        );
        let frame = Frame::new([p[4], p[5], p[6]]);
        tally[14].check(frame.map(|f| Oriented::new(Hemisphere::<T>::new(), f)), &p);
        tally[14].check(
            frame.map(|f| Oriented::new(MalleyHemisphere::<T>::new(), f)),
            &p,
        );
        tally[14].check(
            frame.and_then(|f| Ok(Oriented::new(PhongLobe::<T>::new(a)?, f))),
            &p,
        );
        tally[14].check(
            frame.and_then(|f| Ok(Oriented::new(Cone::<T>::from_angle(a)?, f))),
            &p,
        );
    }
    for (i, Tally(accepted)) in tally.iter().enumerate() {
        assert!(
            *accepted >= ROUNDS / 20,
            "constructor {i} accepted only {accepted}"
        );
    }
}

#[test]
fn accepted_parameters_are_total_in_libm() {
    every_constructor::<Libm>();
}

#[test]
fn accepted_parameters_are_total_in_poly() {
    every_constructor::<Poly>();
}
