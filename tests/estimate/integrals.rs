//! Integrals of the documents, and that the estimate and its variance are unbiased.

use crate::Z;
use core::f32::consts::PI;
use host::mean::Mean;
use microwarp::estimate::{Integral, Moments, WeightedMean};
use microwarp::{Warp, poly as mw, uniform};
use rand_pcg::Pcg32;

const SAMPLES: u32 = 4_000_000;

/// Whether an estimate is within its own error of the exact value, and the error small enough to tell.
fn agrees(what: &str, integral: &Integral, exact: f64, telling: f64) -> bool {
    assert_eq!(integral.refused(), 0);
    let estimate = f64::from(integral.estimate().unwrap());
    let error = f64::from(integral.standard_error().unwrap());
    println!("{what}: {estimate:.5} for {exact:.5}, standard error {error:.1e}");
    assert!(error > 0.0 && Z * error <= telling, "{what}: {error:e}");
    (estimate - exact).abs() <= Z * error
}

#[test]
fn pi_is_four_times_the_quarter_disk() {
    let mut rng = Pcg32::new(21, 54);
    let (mut quarter, mut diamond) = (Integral::new(), Integral::new());
    for _ in 0..SAMPLES {
        let [x, y] = [uniform::grid(&mut rng), uniform::grid(&mut rng)];
        quarter.push(if x * x + y * y < 1.0 { 4.0 } else { 0.0 }, 1.0);
        diamond.push(
            if x.powi(3) + y.powi(3) < 1.0 {
                4.0
            } else {
                0.0
            },
            1.0,
        );
    }
    assert!(agrees("pi", &quarter, std::f64::consts::PI, 0.01));
    assert!(!agrees("the control", &diamond, std::f64::consts::PI, 0.01));
}

#[test]
fn the_cosine_over_half_a_turn_integrates_to_nothing() {
    let angle = mw::Interval::new(0.0, PI).unwrap();
    let mut rng = Pcg32::new(22, 54);
    let (mut cosine, mut control, mut mean) = (Integral::new(), Integral::new(), Moments::new());
    for _ in 0..SAMPLES {
        let x = angle.draw(&mut rng);
        cosine.push(x.cos(), angle.pdf(x));
        mean.push(x.cos());
        // A thousandth of a turn too far.
        control.push((x + 0.001 * 2.0 * PI).cos(), angle.pdf(x));
    }
    assert!(agrees("cosine", &cosine, 0.0, 0.01));
    assert!(!agrees("the control", &control, 0.0, 0.01));
    let off = mean.mean().unwrap().abs();
    assert!(f64::from(off) <= Z * f64::from(mean.standard_error().unwrap()));
}

/// The mean over many repetitions.
fn repeated(repeats: usize, mut once: impl FnMut() -> Option<f32>) -> Mean {
    Mean::of((0..repeats).map(|_| f64::from(once().unwrap())))
}

fn is(repeated: Mean, what: &str, exact: f64) -> bool {
    let Mean { mean, error } = repeated;
    println!("{what}: {mean:.6} for {exact:.6}, standard error {error:.1e}");
    assert!(error > 0.0);
    repeated.deviation(exact).abs() <= Z
}

/// Five samples for the integral of e^x over [0, 1], of density 2(1 + x)/3.
fn five(rng: &mut Pcg32, mut take: impl FnMut(f32, f32)) {
    let warp = mw::Linear::new(1.0, 2.0).unwrap();
    for _ in 0..5 {
        let x = warp.draw(rng);
        take(x.exp(), warp.pdf(x));
    }
}

#[test]
fn five_samples_are_as_right_on_average_as_a_million() {
    let mut rng = Pcg32::new(23, 54);
    let mut integral = || {
        let mut integral = Integral::new();
        five(&mut rng, |f, pdf| integral.push(f, pdf));
        integral
    };
    const REPEATS: usize = 500_000;
    let exact = 1f64.exp() - 1.0;
    let estimates = repeated(REPEATS, || integral().estimate());
    assert!(is(estimates, "integral", exact));

    // ∫f²/p − I², with p = 2(1 + x)/3, by Simpson's rule.
    let squares = |x: f64| (2.0 * x).exp() * 1.5 / (1.0 + x);
    let simpson = |i: u32| match i {
        0 | 1000 => 1.0,
        _ => 2.0 * f64::from(1 + i % 2),
    };
    let second: f64 = (0..=1000)
        .map(|i| simpson(i) * squares(f64::from(i) / 1000.0))
        .sum();
    let variance = second / 3000.0 - exact * exact;
    let of_variance = repeated(REPEATS, || integral().moments().variance());
    assert!(is(of_variance, "variance", variance));
    let squared = repeated(REPEATS, || integral().standard_error().map(|e| e * e));
    assert!(is(squared, "standard error squared", variance / 5.0));
    // The controls: n under the line, and weights that are made to sum to 1.
    let population = repeated(REPEATS, || integral().moments().population_variance());
    assert!(!is(population, "n under the line", variance));
    let mut rng = Pcg32::new(24, 54);
    let normalised = repeated(REPEATS, || {
        let mut ratio = WeightedMean::new();
        five(&mut rng, |f, pdf| ratio.push(f, 1.0 / pdf));
        ratio.mean()
    });
    assert!(!is(normalised, "normalised weights", exact));
}
