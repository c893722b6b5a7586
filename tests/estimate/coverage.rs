//! The bounds hold as often as they say: Chebyshev's at least, the normal one about as often.

use crate::{Z, at_most};
use microwarp::estimate::Integral;
use microwarp::tier::{Libm, Poly, Tier};
use microwarp::{Warp, poly as mw};
use rand_pcg::Pcg32;

const REPEATS: u32 = 20_000;

/// How often the error is at least each of several bounds.
fn misses<const N: usize>(
    samples: u32,
    exact: f32,
    mut quotient: impl FnMut() -> f32,
    bounds: impl Fn(&Integral) -> [f32; N],
) -> [f64; N] {
    let mut misses = [0_u32; N];
    for _ in 0..REPEATS {
        let mut integral = Integral::new();
        for _ in 0..samples {
            integral.push(quotient() * 0.5, 0.5);
        }
        let error = (integral.estimate().unwrap() - exact).abs();
        for (miss, bound) in misses.iter_mut().zip(bounds(&integral)) {
            *miss += u32::from(bound <= error);
        }
    }
    misses.map(|miss| f64::from(miss) / f64::from(REPEATS))
}

/// The standard deviation of a frequency.
fn deviation(p: f64) -> f64 {
    (p * (1.0 - p) / f64::from(REPEATS)).sqrt()
}

#[test]
fn chebyshevs_bound_is_missed_no_more_often_than_it_says() {
    let exponential = mw::Exponential::from_rate(1.0).unwrap();
    let interval = mw::Interval::new(-1.0, 1.0).unwrap();
    let mut rng = Pcg32::new(41, 54);
    let deltas = [0.25_f32, 0.1, 0.01];
    let bounds = |integral: &Integral| {
        let [a, b, c] = deltas.map(|delta| integral.chebyshev_bound(delta).unwrap());
        // The controls: half the widest, and one standard error for the others.
        let error = integral.standard_error().unwrap();
        [a, b, c, 0.5 * a, error, error]
    };
    let skewed = misses(50, 1.0, || exponential.draw(&mut rng), bounds);
    let flat = misses(50, 0.0, || interval.draw(&mut rng), bounds);
    // Rare and large: 100 in one sample of 100.
    let rare = || {
        if interval.draw(&mut rng) < -0.98 {
            100.0
        } else {
            0.0
        }
    };
    let rare = misses(1000, 1.0, rare, bounds);
    for (what, missed) in [("skewed", skewed), ("flat", flat), ("rare", rare)] {
        for (i, delta) in deltas.map(f64::from).into_iter().enumerate() {
            let (missed, control) = (missed[i], missed[i + 3]);
            println!("{what}, delta {delta}: missed {missed:.4}, control {control:.4}");
            let most = delta + Z * deviation(delta);
            assert!(missed <= most, "{what}: {missed} for {delta}");
            assert!(!at_most(control, most), "{what}: the control passes");
        }
    }
}

/// Whether a frequency of misses is that of a confidence; N is large enough for a thousandth.
fn about(missed: f64, confidence: f64) -> bool {
    let expected = 1.0 - confidence;
    (missed - expected).abs() <= Z * deviation(expected) + 0.001
}

fn normal_bound_of<T: Tier>() {
    let interval = mw::Interval::new(-1.0, 1.0).unwrap();
    let mut rng = Pcg32::new(42, 54);
    let confidences = [0.5_f32, 0.9, 0.95, 0.99];
    let missed = misses(
        500,
        0.0,
        || interval.draw(&mut rng),
        |integral| {
            let [a, b, c, d] = confidences.map(|c| integral.normal_bound::<T>(c).unwrap());
            [a, b, c, d, 0.5 * a, 0.5 * b, 0.5 * c, 0.5 * d]
        },
    );
    for (i, confidence) in confidences.map(f64::from).into_iter().enumerate() {
        let (missed, halved) = (missed[i], missed[i + 4]);
        println!(
            "{}, {confidence}: missed {missed:.4}, half {halved:.4}",
            T::NAME
        );
        assert!(about(missed, confidence), "{missed} for {confidence}");
        assert!(!about(halved, confidence), "half the bound passes");
    }
}

#[test]
fn the_normal_bound_is_missed_as_often_as_it_says() {
    normal_bound_of::<Poly>();
}

#[test]
fn bounds_are_the_standard_error_times_the_right_factor() {
    let mut integral = Integral::new();
    for x in [1.0, 2.0, 4.0, 8.0] {
        integral.push(x, 0.5);
    }
    let error = f64::from(integral.standard_error().unwrap());
    let off = |got: f32, factor: f64| (f64::from(got) - factor * error).abs() / (factor * error);
    for delta in [1e-45_f32, 1e-20, 1e-3, 0.05, 0.5, 0.999_999_94] {
        let bound = integral.chebyshev_bound(delta).unwrap();
        assert!(
            off(bound, f64::from(delta).sqrt().recip()) <= 3e-7,
            "{delta}"
        );
    }
    // Quantiles of the standard normal, from tables.
    for (confidence, factor) in [
        (0.5, 0.674_489_750_196_082),
        (0.9, 1.644_853_626_951_473),
        (0.95, 1.959_963_984_540_054),
        (0.99, 2.575_829_303_548_901),
        (0.999, 3.290_526_731_491_926),
    ] {
        // The confidence itself is rounded to 24 bits, which moves its tail by up to 3e-8.
        let slope = (factor * factor / 2.0_f64).exp() * 2.506_628_274_631 / factor;
        let tolerance = 5e-7 + 3e-8 * slope;
        for bound in [
            integral.normal_bound::<Libm>(confidence).unwrap(),
            integral.normal_bound::<Poly>(confidence).unwrap(),
        ] {
            assert!(off(bound, factor) <= tolerance, "{confidence}: {bound}");
        }
        assert!(!at_most(
            off(integral.chebyshev_bound(1.0 - confidence).unwrap(), factor),
            tolerance
        ));
    }
}
