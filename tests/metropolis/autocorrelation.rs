//! Autocorrelations against their definition in f64, over stored runs: short ones after every push, of any
//! magnitude, far from 0.

use crate::exact::{assert_stated, stated_error};
use crate::series::{SHAPES, Truth, normal, shaped, unit};
use host::speed;
use microwarp::metropolis::Autocorrelation;
use rand_core::Rng;
use rand_pcg::Pcg32;

pub const AUTOCORRELATION: &str = include_str!("../../src/metropolis/autocorrelation.rs");

pub fn pushed<const LAGS: usize>(run: &[f32]) -> Autocorrelation<LAGS> {
    let mut health = Autocorrelation::new();
    run.iter().for_each(|&x| health.push(x));
    health
}

/// The largest error of any autocorrelation, and that those are unknown which should be.
pub fn largest_error<const LAGS: usize>(health: &Autocorrelation<LAGS>, run: &[f32]) -> f64 {
    let truth = Truth::new(run);
    let mut worst = 0.0_f64;
    for lag in 0..=LAGS {
        match (health.at_lag(lag), truth.autocorrelation(lag)) {
            (Some(got), Some(exact)) => {
                let error = (f64::from(got) - exact).abs();
                assert!(!error.is_nan() && got.abs() <= 1.0);
                worst = worst.max(error);
            }
            (None, None) => {}
            other => panic!("lag {lag} of {run:?}: {other:?}"),
        }
    }
    assert_eq!(health.at_lag(LAGS + 1), None);
    assert_eq!(health.at_lag(usize::MAX), None);
    worst
}

/// A run of `f32`, its mean that many deviations from 0, on a scale of its own.
fn placed(shape: usize, n: usize, mean: f64, scale: f64, rng: &mut Pcg32) -> Vec<f32> {
    let numbers = shaped(shape, n, rng);
    numbers
        .iter()
        .map(|x| ((x + mean) * scale) as f32)
        .collect()
}

/// The error after every push of a short run: neither a new centre nor a new scale shows.
fn after_every_push<const LAGS: usize>() -> f64 {
    let mut rng = Pcg32::new(0x4ea1 + LAGS as u64, 54);
    let mut worst = 0.0_f64;
    for turn in 0..60 {
        let shape = turn % SHAPES;
        let mean = [0.0, 1.0, -100.0][turn % 3];
        let run = placed(
            shape,
            70 + turn,
            mean,
            10f64.powi(turn as i32 - 30),
            &mut rng,
        );
        let mut health = Autocorrelation::<LAGS>::new();
        assert_eq!(health.at_lag(0), None);
        for n in 1..=run.len() {
            health.push(run[n - 1]);
            assert_eq!(health.count(), n as u64);
            worst = worst.max(largest_error(&health, &run[..n]));
        }
    }
    println!("after every push, {LAGS} lags: {worst:.2e}");
    worst
}

#[test]
fn autocorrelations_are_right_after_every_push() {
    let stated = stated_error(AUTOCORRELATION);
    for worst in [
        after_every_push::<0>(),
        after_every_push::<1>(),
        after_every_push::<2>(),
        after_every_push::<7>(),
        after_every_push::<64>(),
    ] {
        assert!(worst <= stated, "{worst:e}");
    }
}

/// Where few numbers make a sum, a single rounding weighs most.
#[test]
fn autocorrelations_of_short_runs_have_the_stated_error() {
    let mut rng = Pcg32::new(0x5407, 54);
    let (mut worst, mut of) = (0.0_f64, Vec::new());
    for turn in 0..speed::of("runs", 200_000, 2_000_000) {
        let n = 2 + turn % 5;
        let mean = [0.0, 0.5, 2.0, 30.0][turn / 5 % 4];
        let run: Vec<f32> = match turn % 3 {
            0 => (0..n).map(|_| (mean + normal(&mut rng)) as f32).collect(),
            1 => (0..n).map(|_| (mean + unit(&mut rng)) as f32).collect(),
            // All but the same, alternating or not.
            _ => (0..n)
                .map(|_| {
                    let sign = if rng.next_u32() & 1 == 0 { 1.0 } else { -1.0 };
                    ((mean + sign) * (1.0 + 1e-6 * unit(&mut rng))) as f32
                })
                .collect(),
        };
        let error = largest_error(&pushed::<3>(&run), &run);
        if error > worst {
            (worst, of) = (error, run);
        }
    }
    println!("worst of {of:?}");
    assert_stated("autocorrelation", worst, stated_error(AUTOCORRELATION));
}

/// Longer runs, of each shape, and how far their mean may be from 0.
#[test]
fn autocorrelations_are_right_far_from_0() {
    let mut rng = Pcg32::new(0xfa20, 54);
    let stated = stated_error(AUTOCORRELATION);
    for mean in [0.0, 1.0, 100.0, 1e3, 1e4, 1e6] {
        let mut worst = 0.0_f64;
        for shape in 0..SHAPES {
            for n in [100, 1000, 30_000] {
                let run = placed(shape, n, mean, 0.37, &mut rng);
                worst = worst.max(largest_error(&pushed::<16>(&run), &run));
            }
        }
        println!("mean of {mean:e} deviations: {worst:.2e}");
        assert!(worst <= stated, "{mean}: {worst:e}");
    }
}

#[test]
fn any_magnitude_is_taken_in() {
    let mut rng = Pcg32::new(0x3a97, 54);
    let stated = stated_error(AUTOCORRELATION);
    let mut worst = 0.0_f64;
    for power in -45..=38 {
        for shape in 0..SHAPES {
            // The outliers of some are 300 times as large.
            let run = placed(shape, 200, 0.0, 10f64.powi(power), &mut rng);
            let run: Vec<f32> = run.iter().map(|x| x.clamp(f32::MIN, f32::MAX)).collect();
            worst = worst.max(largest_error(&pushed::<5>(&run), &run));
        }
    }
    println!("magnitudes from 1e-45 to 1e38: {worst:.2e}");
    assert!(worst <= stated, "{worst:e}");
    // Rising by some orders at every push, so that the scale changes at each; falling; at random.
    let mut worst = 0.0_f64;
    for turn in 0..300 {
        let n = 3 + turn % 80;
        let run: Vec<f32> = (0..n)
            .map(|i| {
                let power = match turn % 3 {
                    0 => 83.0 * i as f64 / n as f64 - 45.0,
                    1 => 38.0 - 83.0 * i as f64 / n as f64,
                    _ => 83.0 * unit(&mut rng) - 45.0,
                };
                (normal(&mut rng) * 10f64.powf(power)) as f32
            })
            .filter(|x| x.is_finite())
            .collect();
        let mut health = Autocorrelation::<5>::new();
        for n in 1..=run.len() {
            health.push(run[n - 1]);
            worst = worst.max(largest_error(&health, &run[..n]));
        }
    }
    println!("all magnitudes in one run: {worst:.2e}");
    assert!(worst <= stated, "{worst:e}");
}

#[test]
fn runs_without_autocorrelation_have_none() {
    for x in [
        0.0,
        -0.0,
        1.0,
        -3.3,
        1e-45,
        f32::MIN_POSITIVE,
        f32::MAX,
        f32::MIN,
        1e38,
        0.1,
    ] {
        let mut health = Autocorrelation::<3>::new();
        for n in 0..100 {
            for lag in 0..5 {
                assert_eq!(health.at_lag(lag), None, "{n} of {x:e}");
            }
            assert_eq!(health.integrated_time(), None);
            assert_eq!(health.effective_sample_size(), None);
            health.push(x);
        }
        // One that differs by the least there is.
        let other = if x > 0.0 { x.next_down() } else { x.next_up() };
        health.push(other);
        assert_eq!(health.at_lag(0), Some(1.0), "{x:e}");
    }
}

#[test]
fn what_is_no_number_leaves_no_trace() {
    let mut rng = Pcg32::new(0x2ace, 54);
    let (mut with, mut without) = (Autocorrelation::<4>::new(), Autocorrelation::<4>::new());
    for i in 0..500 {
        let x = normal(&mut rng) as f32;
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY]
            .into_iter()
            .take(i % 4)
        {
            with.push(bad);
        }
        with.push(x);
        without.push(x);
        for lag in 0..=4 {
            assert_eq!(with.at_lag(lag), without.at_lag(lag));
        }
        assert_eq!(with.integrated_time(), without.integrated_time());
    }
    assert_eq!((with.count(), without.count()), (500, 500));
    assert_eq!((with.refused(), without.refused()), (125 * 6, 0));
}

/// Whatever is pushed, a result is a number in range or none.
#[test]
fn no_result_is_out_of_range() {
    let mut rng = Pcg32::new(0x0b17, 54);
    let (mut known, mut times) = (0, 0);
    let turns = speed::of("runs", 4_000, 20_000);
    for turn in 0..turns {
        let mut health = Autocorrelation::<6>::new();
        let n = 1 + turn % 40;
        for _ in 0..n {
            let bits = rng.next_u32();
            // Half of the runs within some binades, where the results are of all kinds.
            health.push(f32::from_bits(if turn % 2 == 0 {
                bits
            } else {
                bits >> 4 | 0x3000_0000
            }));
            for lag in 0..8 {
                if let Some(rho) = health.at_lag(lag) {
                    assert!((-1.0..=1.0).contains(&rho));
                    known += 1;
                }
            }
            let count = health.count() as f32;
            match (health.integrated_time(), health.effective_sample_size()) {
                (Some(time), Some(size)) => {
                    let log2 = count.log2().max(1.0);
                    assert!(time.is_finite() && time * log2 >= 1.0 - 1e-6, "{time}");
                    assert!(size > 0.0 && size <= count * log2 * (1.0 + 1e-6), "{size}");
                    times += 1;
                }
                (None, None) => {}
                other => panic!("{other:?}"),
            }
        }
    }
    println!("{known} autocorrelations, {times} times");
    assert!(known > 50 * turns && times > 2 * turns);
}

#[test]
fn the_memory_is_as_stated() {
    assert_eq!(size_of::<Autocorrelation<0>>(), 40);
    assert_eq!(size_of::<Autocorrelation<1>>(), 16 + 40);
    assert_eq!(size_of::<Autocorrelation<64>>(), 16 * 64 + 40);
    assert!(AUTOCORRELATION.contains("/// Memory: 16 bytes per lag and 40 more."));
}
