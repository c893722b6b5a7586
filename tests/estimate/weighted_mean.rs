//! The ratio estimator: its bias vanishes as 1/N at the rate of its first-order formula, where the unbiased
//! estimator has none; and its standard error is that of its own scatter.

use crate::{Z, at_most};
use host::mean::mean_and_variance;
use host::speed;
use microwarp::estimate::{Integral, Moments, WeightedMean};
use microwarp::uniform;
use rand_pcg::Pcg32;

/// Σwf/Σw of f = x, w = 2x, for X uniform on [0, 1]: E[w] = 1 and the ratio is 2/3.
const RATIO: f64 = 2.0 / 3.0;

/// (R V[w] − Cov[w, wf])/E[w]² = (2/3 · 1/3 − 1/3)/1.
const BIAS_TIMES_N: f64 = -1.0 / 9.0;

struct Bias {
    n: u32,
    bias: f64,
    error: f64,
}

/// The mean errors over many repetitions of the ratio and the unbiased estimate.
fn biases(n: u32, repeats: usize) -> [Bias; 2] {
    let mut rng = Pcg32::new(u64::from(50 + n), 54);
    let (ratios, integrals): (Vec<f64>, Vec<f64>) = (0..repeats)
        .map(|_| {
            let (mut ratio, mut integral) = (WeightedMean::new(), Integral::new());
            for _ in 0..n {
                let x = uniform::open(&mut rng);
                ratio.push(x, 2.0 * x);
                integral.push(2.0 * x * x, 1.0);
            }
            let of = |x: Option<f32>| f64::from(x.unwrap());
            (of(ratio.mean()), of(integral.estimate()))
        })
        .unzip();
    [ratios, integrals].map(|estimates| {
        let (mean, variance) = mean_and_variance(estimates.iter().copied());
        Bias {
            n,
            bias: mean - RATIO,
            error: (variance / repeats as f64).sqrt(),
        }
    })
}

/// The slope of ln|bias| over ln N by weighted least squares, and its standard error.
fn slope(biases: &[Bias]) -> (f64, f64) {
    let points = || {
        biases.iter().map(|b| {
            let relative = b.error / b.bias.abs();
            (f64::from(b.n).ln(), b.bias.abs().ln(), relative.powi(-2))
        })
    };
    let total: f64 = points().map(|(_, _, w)| w).sum();
    let mean_x = points().map(|(x, _, w)| w * x).sum::<f64>() / total;
    let spread: f64 = points().map(|(x, _, w)| w * (x - mean_x).powi(2)).sum();
    let rise: f64 = points().map(|(x, y, w)| w * (x - mean_x) * y).sum();
    (rise / spread, spread.sqrt().recip())
}

#[test]
fn the_bias_vanishes_as_one_over_n() {
    let runs = [1, 2, 4, 8, 16, 32, 64];
    let repetitions = speed::of("repetitions of weighted means", 150_000, 300_000);
    let (mut of_ratio, mut of_integral) = (Vec::new(), Vec::new());
    println!("   N       bias  N times it  standard error   unbiased  standard error");
    for n in runs {
        let [ratio, integral] = biases(n, repetitions);
        println!(
            "{n:>4}  {:>9.2e}  {:>10.4}  {:>14.1e}  {:>9.1e}  {:>14.1e}",
            ratio.bias,
            ratio.bias * f64::from(n),
            ratio.error,
            integral.bias,
            integral.error
        );
        of_ratio.push(ratio);
        of_integral.push(integral);
    }
    let is_biased = |b: &Bias| b.bias.abs() > Z * b.error;
    assert!(of_ratio.iter().all(is_biased));
    assert!(
        !of_integral.iter().any(is_biased),
        "the unbiased estimator is biased"
    );

    // One sample estimates the plain mean of f, 1/2.
    let first = &of_ratio[0];
    assert!((first.bias + 1.0 / 6.0).abs() <= Z * first.error);
    // From 8 on the second order, which falls as 1/N², is below an eighth of the first.
    let (slope_of_ratio, error) = slope(&of_ratio[3..]);
    println!("slope {slope_of_ratio:.3}, standard error {error:.3}");
    let tolerance = 0.05 + Z * error;
    assert!(tolerance <= 0.25, "too few repetitions to tell");
    assert!(
        (slope_of_ratio + 1.0).abs() <= tolerance,
        "{slope_of_ratio}"
    );
    for b in &of_ratio[3..] {
        let n = f64::from(b.n);
        let off = b.bias * n / BIAS_TIMES_N - 1.0;
        let tolerance = 1.0 / n + Z * b.error * n / BIAS_TIMES_N.abs();
        assert!(off.abs() <= tolerance, "N = {n}: {off}");
    }
    // The control: errors that fall as 1/√N, as the scatter does.
    let scatter: Vec<Bias> = of_ratio[3..]
        .iter()
        .map(|b| Bias {
            n: b.n,
            bias: -0.01 / f64::from(b.n).sqrt(),
            error: b.error,
        })
        .collect();
    assert!(
        !at_most((slope(&scatter).0 + 1.0).abs(), tolerance),
        "1/√N passes"
    );
}

#[test]
fn the_standard_error_is_the_scatter_of_the_estimates() {
    const REPEATS: usize = 40_000;
    let mut rng = Pcg32::new(51, 54);
    let (mut errors, mut naive) = (Moments::new(), Moments::new());
    let estimates: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let (mut ratio, mut products) = (WeightedMean::new(), Moments::new());
            for _ in 0..256 {
                let x = uniform::open(&mut rng);
                ratio.push(x, 2.0 * x);
                products.push(2.0 * x * x);
            }
            errors.push(ratio.standard_error().unwrap().powi(2));
            naive.push(products.standard_error().unwrap().powi(2));
            f64::from(ratio.mean().unwrap())
        })
        .collect();
    let (_, scatter) = mean_and_variance(estimates.iter().copied());
    // 4 E[x²(x − 2/3)²] = 8/135 to first order; the second is one part in N.
    let tolerance = Z * (2.0 / REPEATS as f64).sqrt() + 2.0 / 256.0;
    let off = |squared: &Moments| f64::from(squared.mean().unwrap()) / scatter - 1.0;
    println!(
        "squared error {:+.4} from the scatter, naive {:+.3}",
        off(&errors),
        off(&naive)
    );
    assert!((scatter * 256.0 * 135.0 / 8.0 - 1.0).abs() <= tolerance);
    assert!(off(&errors).abs() <= tolerance, "{}", off(&errors));
    // The control: the standard error of the mean of wf, as if Σw were known.
    assert!(!at_most(off(&naive).abs(), tolerance));
}
