//! The identities of expectation and variance: multiples, sums, groups, constants, and a die; and the factors of bounds.

use crate::{Z, at_most, relative};
use host::mean::mean_and_variance;
use microwarp::estimate::{Integral, Moments, WeightedMean};
use microwarp::tier::{Libm, Poly};
use microwarp::{Warp, poly as mw, uniform};
use rand_pcg::Pcg32;

fn moments(samples: impl IntoIterator<Item = f32>) -> Moments {
    let mut moments = Moments::new();
    samples.into_iter().for_each(|x| moments.push(x));
    moments
}

fn merged<'a>(parts: impl IntoIterator<Item = &'a Moments>) -> Moments {
    parts.into_iter().fold(Moments::new(), |mut all, part| {
        all.merge(part);
        all
    })
}

fn exponential(n: usize, seed: u64) -> Vec<f32> {
    let mut samples = vec![0.0; n];
    let warp = mw::Exponential::from_rate(1.0).unwrap();
    warp.fill(&mut Pcg32::new(seed, 54), &mut samples);
    samples
}

#[test]
fn the_variance_of_a_multiple_is_the_variance_times_its_square() {
    let samples = exponential(10_001, 1);
    let plain = moments(samples.iter().copied());
    let (mean, variance) = (plain.mean().unwrap(), plain.variance().unwrap());
    // Powers of two change no digit, even where the variance no longer fits f32.
    for power in [-100, -60, -1, 1, 10, 60, 120] {
        let c = 2f32.powi(power);
        let multiple = moments(samples.iter().map(|x| c * x));
        assert_eq!(multiple.mean(), Some(c * mean));
        assert_eq!(multiple.std_dev().unwrap(), c * plain.std_dev().unwrap());
        assert_eq!(
            multiple.standard_error().unwrap(),
            c * plain.standard_error().unwrap()
        );
        let exact = f64::from(c) * f64::from(c) * f64::from(variance);
        assert_eq!(
            multiple.variance(),
            Some(exact.min(f64::from(f32::MAX)) as f32)
        );
    }
    // Other multiples do, each sample being rounded.
    for c in [-1.0_f32, 3.0, -0.1, 1e-15, 12345.678, 1e15] {
        let multiple = moments(samples.iter().map(|x| c * x));
        let c = f64::from(c);
        assert!(relative(multiple.mean(), c * f64::from(mean)) <= 2e-7);
        assert!(relative(multiple.variance(), c * c * f64::from(variance)) <= 3e-7);
        // The control: the multiple itself.
        let control = relative(multiple.variance(), c * f64::from(variance));
        assert!(!at_most(control, 3e-7), "{c} passes for its square");
    }
}

#[test]
fn the_mean_of_a_sum_is_the_sum_of_the_means() {
    let f = exponential(1 << 20, 2);
    let g: Vec<f32> = exponential(1 << 20, 3).iter().map(|x| x.sqrt()).collect();
    let sums = |of: &dyn Fn(f32, f32) -> f32| moments(f.iter().zip(&g).map(|(&f, &g)| of(f, g)));
    let (only_f, only_g, both) = (sums(&|f, _| f), sums(&|_, g| g), sums(&|f, g| f + g));
    let mean = |m: Moments| f64::from(m.mean().unwrap());
    let variance = |m: Moments| f64::from(m.variance().unwrap());
    assert!(relative(both.mean(), mean(only_f) + mean(only_g)) <= 2e-7);

    // Variances add up where f and g are independent: what is left is twice their covariance, whose standard
    // error is the product of the deviations over √n.
    let left = variance(both) - variance(only_f) - variance(only_g);
    let error = 2.0 * (variance(only_f) * variance(only_g) / f64::from(1 << 20)).sqrt();
    println!("independent: {left:.2e} left, standard error {error:.2e}");
    assert!(left.abs() <= Z * error, "{left} for {error}");
    // The control: f and √f are not.
    let dependent = sums(&|f, _| f + f.sqrt());
    let root = sums(&|f, _| f.sqrt());
    assert!(relative(dependent.mean(), mean(only_f) + mean(root)) <= 2e-7);
    let left = variance(dependent) - variance(only_f) - variance(root);
    assert!(!at_most(left.abs(), Z * error), "dependence passes");
}

#[test]
fn the_variance_is_that_within_the_groups_and_that_of_their_means() {
    let mut rng = Pcg32::new(4, 54);
    let groups: Vec<Moments> = (0..200)
        .map(|_| {
            let (n, mean) = (
                1.0 + 300.0 * uniform::grid(&mut rng),
                5.0 * uniform::grid(&mut rng),
            );
            moments((0..n as usize).map(|_| mean + uniform::grid(&mut rng)))
        })
        .collect();
    let all = merged(&groups);
    let n = all.count() as f64;
    let parts = || {
        groups.iter().map(|g| {
            let of = |x: Option<f32>| f64::from(x.unwrap());
            (
                g.count() as f64 / n,
                of(g.mean()),
                of(g.population_variance()),
            )
        })
    };
    let mean: f64 = parts().map(|(p, mean, _)| p * mean).sum();
    let within: f64 = parts().map(|(p, _, variance)| p * variance).sum();
    let between: f64 = parts().map(|(p, m, _)| p * (m - mean) * (m - mean)).sum();
    println!(
        "within {within:.4}, between {between:.4}, all {:?}",
        all.population_variance()
    );
    assert!(relative(all.mean(), mean) <= 1e-6);
    assert!(relative(all.population_variance(), within + between) <= 1e-6);
    // The controls: either part forgotten.
    assert!(!at_most(relative(all.population_variance(), within), 1e-6));
    assert!(!at_most(relative(all.population_variance(), between), 1e-6));
}

#[test]
fn a_die_shows_three_and_a_half() {
    let faces = || (1_u8..=6).map(f32::from);
    let fair = moments(faces());
    assert_eq!(fair.mean(), Some(3.5));
    assert_eq!(fair.population_variance(), Some(35.0 / 12.0));
    // Not 0.916.
    assert!(!at_most(relative(fair.population_variance(), 0.916), 0.1));
}

#[test]
fn a_constant_has_no_variance() {
    for c in [
        0.0,
        1.0,
        -0.1,
        1.0 / 3.0,
        16_777_217.0,
        1e-45,
        -1e-40,
        3.4e38,
        f32::MAX,
    ] {
        for n in [1_usize, 2, 3, 7, 1000, 100_003] {
            let constant = moments(core::iter::repeat_n(c, n));
            let parts = [1, 5, 17, 170].map(|k| moments(core::iter::repeat_n(c, k)));
            for all in [constant, merged(&parts), merged(&[constant, parts[1]])] {
                assert_eq!(all.mean(), Some(c));
                assert_eq!(all.population_variance(), Some(0.0), "{c} {n} times");
                if all.count() > 1 {
                    assert_eq!(all.variance(), Some(0.0));
                    assert_eq!(all.standard_error(), Some(0.0));
                }
            }
        }
        let mut rng = Pcg32::new(6, 54);
        let (mut ratio, mut other) = (WeightedMean::new(), WeightedMean::new());
        for _ in 0..1000 {
            ratio.push(c, uniform::grid(&mut rng) * 1e10);
            other.push(c, uniform::grid(&mut rng) * 1e-10);
        }
        ratio.merge(&other);
        assert_eq!((ratio.mean(), ratio.standard_error()), (Some(c), Some(0.0)));
    }
    // The integral of a constant over an interval, from any uniforms.
    let interval = mw::Interval::new(2.0, 6.0).unwrap();
    let mut integral = Integral::new();
    let mut rng = Pcg32::new(7, 54);
    for _ in 0..1000 {
        integral.push(0.3, interval.pdf(interval.draw(&mut rng)));
    }
    assert_eq!(integral.estimate(), Some(1.2));
    assert_eq!(integral.standard_error(), Some(0.0));
    // The control: one sample in 100 000 that is one step off.
    let mut almost = moments(core::iter::repeat_n(0.1, 100_000));
    almost.push(0.1_f32.next_up());
    assert!(almost.variance().unwrap() > 0.0);
}

#[test]
fn a_ratio_of_equal_weights_is_a_mean() {
    let samples = exponential(10_000, 8);
    let plain = moments(samples.iter().copied());
    for w in [1.0, 0.3, 1e-30, 1e30] {
        let mut ratio = WeightedMean::new();
        samples.iter().for_each(|&x| ratio.push(x, w));
        let (mean, error) = (ratio.mean(), ratio.standard_error());
        assert!(relative(mean, f64::from(plain.mean().unwrap())) <= 3e-7);
        assert!(relative(error, f64::from(plain.standard_error().unwrap())) <= 5e-7);
    }
    let (mean, variance) = mean_and_variance(samples.iter().map(|&x| f64::from(x)));
    assert!(relative(plain.mean(), mean) <= 2e-7);
    assert!(relative(plain.variance(), variance) <= 3e-7);
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
