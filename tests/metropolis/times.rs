//! The integrated autocorrelation time: Geyer's initial monotone sequence in f64 on the same runs.

use crate::autocorrelation::{AUTOCORRELATION, pushed};
use crate::exact::stated_error;
use crate::series::{SHAPES, Truth, autoregression, normal, shaped};
use host::speed;
use microwarp::estimate::Moments;
use rand_pcg::Pcg32;

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
                let mut moments = Moments::new();
                run.iter().for_each(|&x| moments.push(x));
                let error = f64::from(health.standard_error().unwrap());
                let due = f64::from(moments.std_dev().unwrap()) / f64::from(size).sqrt();
                assert!((error / due - 1.0).abs() < 1e-6, "{error} {due}");
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
