//! The integrated autocorrelation time: Geyer's initial monotone sequence in f64 on the same runs, and theory.

use crate::autocorrelation::{AUTOCORRELATION, pushed};
use crate::exact::stated_error;
use crate::series::{SHAPES, Truth, autoregression, normal, shaped};
use host::speed;
use host::stats;
use rand_pcg::Pcg32;

/// No fewer than the p-values that are computed in this file.
const TESTS: usize = 10;

/// The time against that of the same run in f64: of how many runs, and its largest error.
fn against_truth<const LAGS: usize>(rng: &mut Pcg32) -> ([u32; 3], f64) {
    let (mut cases, mut worst) = ([0; 3], 0.0_f64);
    for turn in 0..400 {
        let n = [2, 3, 10, 64, 65, 300, 4000][turn % 7];
        let mean = [0.0, 3.0, 1000.0][turn % 3];
        let run: Vec<f32> = shaped(turn % SHAPES, n, rng)
            .iter()
            .map(|x| (x + mean) as f32)
            .collect();
        let health = pushed::<LAGS>(&run);
        let truth = Truth::new(&run);
        // Where a pair is 0 but for rounding, either may end there.
        match (health.integrated_time(), truth.integrated_time(LAGS)) {
            (_, Some((_, nearest))) if nearest < 1e-6 => cases[0] += 1,
            (Some(got), Some((exact, _))) => {
                cases[1] += 1;
                let error = (f64::from(got) - exact).abs() / exact.max(1.0);
                assert!(!error.is_nan(), "{got}");
                worst = worst.max(error);
                let size = health.effective_sample_size().unwrap();
                let product = f64::from(size) * f64::from(got) / n as f64;
                assert!((product - 1.0).abs() < 3e-7, "{product}");
            }
            (None, None) => {
                cases[2] += 1;
                assert_eq!(health.effective_sample_size(), None);
            }
            // An alternating run, whose pairs are all 1/n.
            (_, None)
                if truth
                    .autocorrelation(1)
                    .is_some_and(|r| r + 1.0 < 2.0 / n as f64) => {}
            other => panic!("{other:?} of turn {turn}, {LAGS} lags"),
        }
    }
    println!("{LAGS} lags: {cases:?} (too near, known, unknown), error {worst:.2e} of the time");
    (cases, worst)
}

#[test]
fn the_time_is_that_of_the_initial_monotone_sequence() {
    let mut rng = Pcg32::new(0x71e5, 54);
    // The first pair, 1 + ρ₁, is positive: the sum ends with the second at the earliest, that of lag 3.
    assert_eq!(against_truth::<0>(&mut rng).0[1], 0);
    assert_eq!(against_truth::<1>(&mut rng).0[1], 0);
    assert_eq!(against_truth::<2>(&mut rng).0[1], 0);
    let (some, first) = against_truth::<3>(&mut rng);
    let (few, second) = against_truth::<4>(&mut rng);
    let (more, third) = against_truth::<16>(&mut rng);
    let (most, fourth) = against_truth::<65>(&mut rng);
    for worst in [first, second, third, fourth] {
        // Each of the 33 pairs may be off by twice the stated error of an autocorrelation, and counts twice.
        assert!(
            worst <= 33.0 * 4.0 * stated_error(AUTOCORRELATION),
            "{worst:e}"
        );
    }
    for known in [some, few, more, most] {
        assert!(known[1] > 10, "{known:?}");
    }
    assert!(more[1] > 150 && more[2] > 20, "{more:?}");
}

/// How far from theory a time is: the p-value by the limiting variance of a sum of that many lags.
fn p_value(time: f64, rho: f64, n: usize) -> f64 {
    let theory = (1.0 + rho) / (1.0 - rho);
    // Madras and Sokal: var τ = 2(2W + 1)/n τ², for a window W that holds the correlations; of τ no less than
    // that of white noise, whose pairs are noise as well.
    let decay = -rho.abs().max(0.01).ln();
    let window = (0.5 * (n as f64).ln() / decay).max(2.0);
    let deviation = theory.max(1.0) * (2.0 * (2.0 * window + 1.0) / n as f64).sqrt();
    let z = (time - theory) / deviation;
    println!("{time:.4} for {theory:.4}: {z:.2} deviations");
    stats::two_sided(z)
}

fn time_of<const LAGS: usize>(rho: f64, n: usize, rng: &mut Pcg32) -> Option<f64> {
    let run: Vec<f32> = autoregression(rho, n, rng)
        .iter()
        .map(|x| (x * 3.0 + 50.0) as f32)
        .collect();
    pushed::<LAGS>(&run).integrated_time().map(f64::from)
}

#[test]
fn the_time_of_an_autoregression_is_that_of_theory() {
    let mut rng = Pcg32::new(0xa401, 54);
    let n = speed::of("numbers", 100_000, 1_000_000);
    for rho in [0.0, 0.5, 0.9, -0.5] {
        let time = time_of::<256>(rho, n, &mut rng).unwrap();
        assert!(p_value(time, rho, n) >= stats::threshold(TESTS), "{rho}");
    }
    // Runs of another law do not pass for these.
    let white = time_of::<256>(0.0, n, &mut rng).unwrap();
    let nine = time_of::<256>(0.9, n, &mut rng).unwrap();
    for (time, rho) in [
        (white, 0.5),
        (white, 0.05),
        (white, -0.5),
        (nine, 0.87),
        (nine, 0.0),
    ] {
        assert!(
            p_value(time, rho, n) < stats::threshold(TESTS),
            "{time} for {rho}"
        );
    }
}

#[test]
fn a_time_beyond_the_lags_is_none() {
    let mut rng = Pcg32::new(0xbe70, 54);
    let run: Vec<f32> = autoregression(0.99, speed::of("numbers", 60_000, 300_000), &mut rng)
        .iter()
        .map(|x| *x as f32)
        .collect();
    assert_eq!(pushed::<64>(&run).integrated_time(), None);
    assert_eq!(pushed::<64>(&run).effective_sample_size(), None);
    let time = pushed::<1500>(&run).integrated_time().unwrap();
    assert!((120.0..280.0).contains(&time), "{time}");
    // What the documentation advises: every 10th, and times 10.
    let thinned: Vec<f32> = run.iter().step_by(10).copied().collect();
    let thinned = 10.0 * pushed::<200>(&thinned).integrated_time().unwrap();
    println!("{time} by 1500 lags, {thinned} by every 10th");
    assert!((thinned / time - 1.0).abs() < 0.15, "{thinned} for {time}");
}

/// Runs that alternate nearly perfectly, of which the sum alone may say less than nothing.
#[test]
fn the_time_has_a_floor() {
    let mut rng = Pcg32::new(0xf100, 54);
    let mut floored = 0;
    for turn in 0..400 {
        let power = 3 + turn % 10;
        let n = (1 << power) + turn % 3;
        let sign = |i: usize| if i % 2 == 0 { 1.0 } else { -1.0 };
        let run: Vec<f32> = (0..n)
            .map(|i| sign(i) + 0.3 * normal(&mut rng) as f32)
            .collect();
        let health = pushed::<64>(&run);
        let Some(time) = health.integrated_time() else {
            continue;
        };
        let least = 1.0 / power as f32;
        assert!(time >= least, "{time}");
        assert!(health.effective_sample_size().unwrap() <= (n * power) as f32 * 1.000_001);
        let first = 1.0 + Truth::new(&run).autocorrelation(1).unwrap();
        let second: f64 = (2..4)
            .filter_map(|lag| Truth::new(&run).autocorrelation(lag))
            .sum();
        // The sum alone, where it has one pair.
        if second < -1e-6 && 2.0 * first - 1.0 < f64::from(least) {
            assert_eq!(time, least);
            floored += 1;
        }
    }
    println!("{floored} times at the floor");
    assert!(floored > 10, "{floored}");
}
