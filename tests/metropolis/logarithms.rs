//! The acceptance from logarithms of densities, in both tiers, as exact as stated.

use super::acceptance::{acceptance, positive, step};
use host::docs::Doc;
use host::errors::ulp;
use host::speed::{self, sampled};
use microwarp::metropolis::{Chain, HastingsRatio, LogDensity, Outcome, Symmetric};
use microwarp::poly;
use microwarp::tier::{Libm, Poly, Tier};
use rand_core::Rng as _;
use rand_pcg::Pcg32;

const SYMMETRIC: &str = "acceptance at a symmetric mutation, ulp";
const WITH_RATIO: &str = "acceptance at one with a [`HastingsRatio`](super::HastingsRatio), ulp";

/// The figure that the documentation states for a tier.
fn figure<T: Tier>(row: &str) -> f64 {
    Doc::of("metropolis", "LogDensity").figure(row, usize::from(T::NAME == Poly::NAME))
}

/// How far an acceptance is off min(1, e^log), in ulp of that.
fn off(got: f32, log: f64) -> f64 {
    let exact = log.min(0.0).exp();
    (f64::from(got) - exact).abs() / ulp(exact)
}

/// Two logarithms whose difference is `by`, exactly, of the magnitude of `at`; none if there are none.
fn apart(at: f32, by: f32) -> Option<[f32; 2]> {
    let other = at + by;
    (f64::from(other) - f64::from(at) == f64::from(by)).then_some([at, other])
}

fn uniform(rng: &mut Pcg32) -> f64 {
    rng.next_u64() as f64 / 2_f64.powi(64)
}

/// Logarithms of any magnitude from 1e-9 to 1e9, of either sign.
fn logarithm(rng: &mut Pcg32) -> f32 {
    let size = 10_f64.powf(18.0 * uniform(rng) - 9.0);
    (if rng.next_u32() % 2 == 0 { size } else { -size }) as f32
}

fn symmetric<T: Tier>() {
    let mut rng = Pcg32::new(1, 1);
    let log = LogDensity::<T>::new;
    let mut worst = 0.0_f64;
    // Every difference that may matter, and many that do not.
    let mut exactly_apart = |at: f32, by: f32| {
        let Some([from, to]) = apart(at, by) else {
            return;
        };
        worst = worst.max(off(acceptance(log(from), log(to), Symmetric), by.into()));
    };
    let (stride, rounds) = speed::of("one difference of, rounds", (101, 100_000), (1, 2_000_000));
    for bits in sampled(1.0_f32.to_bits()..105.0_f32.to_bits() + 1, stride) {
        exactly_apart(0.0, -f32::from_bits(bits));
    }
    for _ in 0..rounds {
        exactly_apart(0.0, -(logarithm(&mut rng).abs()));
        let near = logarithm(&mut rng).rem_euclid(1000.0);
        exactly_apart(
            near,
            (-110.0 * uniform(&mut rng) * 1024.0).round() as f32 / 1024.0,
        );
    }
    let promised = figure::<T>(SYMMETRIC);
    println!("{}, symmetric: {worst:.3} ulp, {promised} stated", T::NAME);
    // No more than stated, and that no more than a tenth more.
    assert!(worst <= promised && promised <= worst + 0.15);
}

/// Rounding the difference d adds 2^-24 |d| at most, in proportion.
fn rounded_difference<T: Tier>() {
    let mut rng = Pcg32::new(2, 2);
    let log = LogDensity::<T>::new;
    let (mut worst, mut inexact) = (0.0_f64, 0);
    let rounds = speed::of("rounds", 30_000, 500_000);
    let promised = figure::<T>(SYMMETRIC);
    for _ in 0..rounds {
        let from = logarithm(&mut rng);
        let to = match rng.next_u32() % 2 {
            0 => logarithm(&mut rng),
            _ => (f64::from(from) - 105.0 * uniform(&mut rng)) as f32,
        };
        let exact = f64::from(to) - f64::from(from);
        let a = acceptance(log(from), log(to), Symmetric);
        let ideal = exact.min(0.0).exp();
        let allowed = promised * ulp(ideal) + 6e-8 * exact.abs() * ideal;
        let share = (f64::from(a) - ideal).abs() / allowed;
        assert!(share <= 1.0, "{from} -> {to}: {a}");
        if f64::from(to - from) != exact && a > 0.0 && a < 1.0 {
            worst = worst.max(share);
            inexact += 1;
        }
    }
    println!(
        "{}: {worst:.3} of what rounded differences allow, in {inexact}",
        T::NAME
    );
    assert!(worst > 0.5 && inexact > rounds / 5);
}

/// The error in ulp where two logarithms are `by` apart, exactly.
fn with_ratio<T: Tier>([from, to]: [f32; 2], forward: f32, backward: f32) -> f64 {
    let log = LogDensity::<T>::new;
    let a = acceptance(log(from), log(to), HastingsRatio::new(forward, backward));
    let ratio = (f64::from(backward) / f64::from(forward)).ln();
    off(a, f64::from(to) - f64::from(from) + ratio)
}

fn with_a_ratio<T: Tier>() {
    let mut rng = Pcg32::new(3, 3);
    let (mut worst, mut cases) = (0.0_f64, 0);
    let (rounds, of_the_worst) = speed::of("rounds", (150_000, 600_000), (3_000_000, 15_000_000));
    for round in 0..rounds {
        // A ratio from 2^-276 to 2^276, and a difference that all but makes up for it, exactly.
        let [forward, backward] = [(); 2].map(|()| match round % 3 {
            0 => positive(&mut rng),
            _ => (1.0 + 3.0 * uniform(&mut rng)) as f32,
        });
        let ratio = (f64::from(backward) / f64::from(forward)).ln();
        let by = (-106.0 * uniform(&mut rng) * uniform(&mut rng) - ratio) as f32;
        let at = [0.0, (by * 0.75 * 64.0).round() / -64.0][round % 2];
        if let Some(both) = apart(at, by) {
            let error = with_ratio::<T>(both, forward, backward);
            worst = worst.max(error);
            cases += u32::from(error > 0.0);
        }
    }
    // The worst are found where an exponential is furthest from a power of two, which leaves its argument
    // longest, and the product just below one, where errors count most.
    for _ in 0..of_the_worst {
        let turns = f64::from(rng.next_u32() % 40) + 0.4 + 0.2 * uniform(&mut rng);
        let by = -(turns * std::f64::consts::LN_2) as f32;
        let forward = (1.0 + uniform(&mut rng)) as f32;
        let product = 0.5 - 0.01 * uniform(&mut rng);
        let backward = (product * f64::from(forward) / f64::from(by).exp()) as f32;
        worst = worst.max(with_ratio::<T>([0.0, by], forward, backward));
    }
    let promised = figure::<T>(WITH_RATIO);
    println!(
        "{}, with a ratio: {worst:.3} ulp, {promised} stated",
        T::NAME
    );
    assert!(worst <= promised && promised <= worst + 0.2 && cases > rounds as u32 / 3);
}

#[test]
fn acceptances_are_as_exact_as_stated() {
    symmetric::<Libm>();
    symmetric::<Poly>();
}

#[test]
fn a_rounded_difference_adds_what_is_stated() {
    rounded_difference::<Libm>();
    rounded_difference::<Poly>();
}

#[test]
fn acceptances_with_a_ratio_are_as_exact_as_stated() {
    with_a_ratio::<Libm>();
    with_a_ratio::<Poly>();
}

/// Differences that no `f32` holds, or whose exponential none does, are 0 or 1 and nothing else.
fn huge<T: Tier>() {
    let log = LogDensity::<T>::new;
    let huge = [105.0, 1e3, 1e6, 1e9, 2e9, 1e20, f32::MAX];
    let ratios = [
        HastingsRatio::ONE,
        HastingsRatio::new(f32::MAX, 1e-45),
        HastingsRatio::new(1e-45, f32::MAX),
    ];
    for l in huge {
        for (from, to) in [(0.0, l), (-l, 0.0), (-l, l), (1.0, l)] {
            assert_eq!(acceptance(log(from), log(to), Symmetric), 1.0);
            assert_eq!(acceptance(log(to), log(from), Symmetric), 0.0);
            for ratio in ratios {
                // The ratio of most makes up for 277 binary orders.
                if l > 1e3 || ratio == HastingsRatio::ONE {
                    assert_eq!(acceptance(log(from), log(to), ratio), 1.0);
                    assert_eq!(acceptance(log(to), log(from), ratio), 0.0);
                }
            }
        }
        assert_eq!(acceptance(log(l), log(l), Symmetric), 1.0);
        assert_eq!(acceptance(log(-l), log(-l), HastingsRatio::ONE), 1.0);
    }
}

#[test]
fn huge_differences_are_certain() {
    huge::<Libm>();
    huge::<Poly>();
}

fn unsound<T: Tier>() {
    let log = LogDensity::<T>::new;
    for word in [0, 1 << 31, u32::MAX] {
        for (to, outcome) in [
            (f32::NEG_INFINITY, Outcome::Rejected),
            (f32::INFINITY, Outcome::Refused),
            (f32::NAN, Outcome::Refused),
            (-f32::NAN, Outcome::Refused),
        ] {
            for from in [-1e9, 0.0, 1e9, f32::MAX, f32::MIN] {
                let symmetric = step(log(from), log(to), Symmetric, word);
                let with = step(log(from), log(to), HastingsRatio::new(1.0, f32::MAX), word);
                for step in [symmetric, with] {
                    assert_eq!((step.outcome, step.acceptance), (outcome, 0.0));
                }
            }
        }
    }
}

#[test]
fn invalid_logarithms_are_refused() {
    unsound::<Libm>();
    unsound::<Poly>();
}

/// The regression of 1,000 observations: their densities multiply to less than `f32` holds by e^-30,000. `bindings/c/tests`
/// asks the chain in C for the same words.
#[test]
fn a_chain_of_a_thousand_observations() {
    let mut noise = Pcg32::new(7, 0);
    let observed: Vec<(f32, f32)> = (0..1000)
        .map(|i: u16| {
            let z = f32::from(i) / 1000.0;
            let noise = (noise.next_u32() >> 8) as f32 / 16_777_216.0 - 0.5;
            (z, 1.0 + 2.0 * z + noise)
        })
        .collect();
    let log = |[a, b]: [f32; 2]| {
        let mut sum = 0.0;
        for (z, y) in &observed {
            let rest = y - a - b * z;
            sum += rest * rest;
        }
        poly::LogDensity::new(-8.0 * sum)
    };
    let mut rng = Pcg32::new(42, 54);
    let step = poly::NormalStep::new([0.05, 0.08]).unwrap();
    let mut chain = Chain::new([0.0; 2], log).unwrap();
    assert!(chain.density().get() < -30_000.0);
    let mut hash = 2_166_136_261_u32;
    for _ in 0..2000 {
        let step = chain.step(log, &step, &mut rng);
        for x in [step.acceptance, chain.state()[0], chain.state()[1]] {
            hash = (hash ^ x.to_bits()).wrapping_mul(16_777_619);
        }
    }
    let [a, b] = chain.state();
    assert!((a - 1.0).abs() < 0.1 && (b - 2.0).abs() < 0.2, "{a}, {b}");
    assert_eq!((hash, chain.accepted()), (175_079_190, 210));
}
