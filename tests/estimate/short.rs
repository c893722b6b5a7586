//! Many short runs of all magnitudes and shapes against two passes in f64, pushed and merged at random.

use crate::at_most;
use host::docs::{Doc, assert_within};
use host::mean::mean_and_variance;
use host::speed;
use microwarp::estimate::{Moments, WeightedMean};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::sync::LazyLock;

static RUNS: LazyLock<u32> = LazyLock::new(|| speed::of("short runs", 200_000, 1_000_000));

/// A number in [0, 1).
fn unit(rng: &mut Pcg32) -> f64 {
    f64::from(rng.next_u32()) / 2f64.powi(32)
}

/// One of several.
fn below(rng: &mut Pcg32, n: u32) -> u32 {
    (unit(rng) * f64::from(n)) as u32
}

/// A run of samples, and how many powers of ten their mean may be above their deviation.
fn run(rng: &mut Pcg32) -> Vec<f32> {
    // Half of them of a few samples, where a single rounding weighs most.
    let most = if rng.next_u32() & 1 == 0 { 6.0 } else { 300.0 };
    let n = 2 + (unit(rng) * unit(rng) * most) as usize;
    let scale = 2f64.powf(unit(rng) * 270.0 - 146.0);
    let mean = 10f64.powf(unit(rng) * 5.0 - 1.5) * if rng.next_u32() & 1 == 0 { 1.0 } else { -1.0 };
    let shape = below(rng, 8);
    let shaped = |i: usize, rng: &mut Pcg32| match shape {
        0 => unit(rng),
        1 => -unit(rng).max(1e-9).ln(),
        // The first is far away, and so is the first centre.
        2 => {
            if i == 0 {
                -mean
            } else {
                unit(rng)
            }
        }
        // Sorted.
        3 => i as f64 / n as f64 + 0.01 * unit(rng),
        // Two values.
        4 => f64::from(rng.next_u32() & 1),
        // Two clusters on both sides of 0.
        5 => match rng.next_u32() & 1 {
            0 => 1.0 + 1e-6 * unit(rng) - mean,
            _ => -0.2 * unit(rng) - mean,
        },
        // About 0.
        6 => 4.0 * unit(rng) - 2.0 - mean,
        // A late outlier.
        _ => {
            if i + 1 == n {
                1e4
            } else {
                unit(rng)
            }
        }
    };
    (0..n)
        .map(|i| ((mean + shaped(i, rng)) * scale) as f32)
        .filter(|x| x.is_finite())
        .collect()
}

/// Pushes a run in one, or in parts that are then merged.
fn gather<S: Copy, E: Default + Copy>(
    rng: &mut Pcg32,
    samples: &[S],
    push: impl Fn(&mut E, S),
    merge: impl Fn(&mut E, &E),
) -> E {
    let mut parts = [E::default(); 4];
    let used = 1 + below(rng, 4);
    for &sample in samples {
        push(&mut parts[below(rng, used) as usize], sample);
    }
    let [mut all, rest @ ..] = parts;
    rest.iter().for_each(|part| merge(&mut all, part));
    all
}

/// Whether a result has full precision in f32.
fn normal(x: f64) -> bool {
    (1.2e-38..3.4e38).contains(&x.abs())
}

#[derive(Default)]
struct Worst(f64, Vec<f32>);

impl Worst {
    fn take(&mut self, error: f64, samples: &[f32]) {
        assert!(!error.is_nan(), "{samples:?}");
        if error > self.0 {
            *self = Self(error, samples.to_vec());
        }
    }
}

/// Runs that a search found, worse than any of the random ones.
const SEARCHED: [&[f32]; 3] = [
    &[-1.538_736_2, -1.834_177_3, 0.352_888],
    &[1.000_432_6, -1.008_122, 0.156_299_68],
    &[
        3.303_484_5e-5,
        6.141_699e-5,
        0.060_705_777,
        -0.103_255_96,
        -0.562_890_05,
        -0.772_021,
        -0.718_866_33,
    ],
];
const SEARCHED_WEIGHTED: [&[(f32, f32)]; 4] = [
    &[
        (0.515_462_7, 0.008_643_727),
        (0.006_909_802_6, 0.008_839_271),
        (0.698_921_3, 2.655_649_4e-5),
    ],
    &[
        (0.675_126_43, 1.269_353_8e-4),
        (-0.600_743_23, 1.025_093e-4),
        (-2.634_525_1e-5, 1.166_797_7e-4),
    ],
    &[
        (1.000_000_6, 0.239_375_35),
        (-0.178_386_9, 0.273_221_28),
        (1.000_001, 1.603_741_7e-4),
        (1.000_000_1, 0.248_284_52),
        (-0.007_596_548, 9.009_303e-6),
    ],
    &[
        (1.000_000_8, 0.235_932_47),
        (-0.182_465_45, 0.288_923_68),
        (1.000_000_5, 6.313_309e-4),
        (-0.028_557_254, 7.398_776e-6),
        (-0.157_985_24, 0.009_267_917),
        (1.0, 0.450_672_98),
        (1.000_001, 0.004_487_137_3),
    ],
];

#[test]
fn short_runs_keep_the_stated_errors() {
    let doc = Doc::of("estimate", "Moments");
    let mut rng = Pcg32::new(0x5047, 54);
    let (mut of_mean, mut of_variance) = (Worst::default(), Worst::default());
    let (mut naive, mut compared) = (0, 0);
    for k in 0..*RUNS {
        let searched = SEARCHED.get(k as usize);
        let samples = searched.map_or_else(|| run(&mut rng), |samples| samples.to_vec());
        if samples.len() < 2 {
            continue;
        }
        let moments: Moments = if searched.is_some() {
            let mut moments = Moments::new();
            samples.iter().for_each(|&x| moments.push(x));
            moments
        } else {
            gather(&mut rng, &samples, Moments::push, Moments::merge)
        };
        assert_eq!(moments.count(), samples.len() as u64);
        let (mean, variance) = mean_and_variance(samples.iter().map(|&x| f64::from(x)));
        let deviation = variance.sqrt();
        if normal(mean) {
            let error = (f64::from(moments.mean().unwrap()) - mean).abs();
            of_mean.take(error / mean.abs().max(deviation), &samples);
        }
        let n = samples.len() as f64;
        let pairs = [
            (moments.variance(), variance, 1.0),
            (moments.population_variance(), variance * (n - 1.0) / n, 1.0),
            // Twice the relative error of a root is that of the square.
            (moments.std_dev(), deviation, 2.0),
            (moments.standard_error(), deviation / n.sqrt(), 2.0),
        ];
        for (got, exact, times) in pairs {
            let got = f64::from(got.unwrap());
            if normal(exact) {
                of_variance.take(times * (got - exact).abs() / exact, &samples);
            } else if exact == 0.0 {
                assert!(got == 0.0, "{got} of {samples:?}");
            } else {
                // Saturated above, within the spacing below.
                let nearest = exact.min(f64::from(f32::MAX));
                assert!(
                    (got - nearest).abs() <= 2e-45 + 1e-6 * nearest,
                    "{got} for {exact}"
                );
            }
        }
        if normal(variance) && normal(mean * mean) {
            // The textbook formula, as a control.
            let (sum, squares) = samples
                .iter()
                .fold((0.0, 0.0), |(s, q), x| (s + x, q + x * x));
            let textbook = (squares - sum * sum / n as f32) / (n as f32 - 1.0);
            compared += 1;
            let off = (f64::from(textbook) - variance).abs() / variance;
            naive += u32::from(!at_most(off, doc.figure("variance", 2)));
        }
    }
    println!("mean: {:?}\nvariance: {:?}", of_mean.1, of_variance.1);
    assert_within("mean", of_mean.0, doc.figure("mean", 2));
    assert_within("variance", of_variance.0, doc.figure("variance", 2));
    println!("the textbook formula fails {naive} of {compared}");
    assert!(naive > compared / 4, "the textbook formula passes");
}

#[test]
fn short_weighted_runs_keep_the_stated_errors() {
    let doc = Doc::of("estimate", "WeightedMean");
    let mut rng = Pcg32::new(0x5048, 54);
    let (mut of_ratio, mut of_error) = (Worst::default(), Worst::default());
    for k in 0..*RUNS as usize {
        let values = run(&mut rng);
        if values.len() < 2 {
            continue;
        }
        // Weights over up to six powers of ten, of any magnitude.
        let spread = 6.0 * unit(&mut rng);
        let scale = 2f64.powf(unit(&mut rng) * 220.0 - 120.0);
        let samples: Vec<(f32, f32)> = values
            .iter()
            .map(|&x| (x, (scale * 10f64.powf(spread * unit(&mut rng))) as f32))
            .collect();
        let push = |ratio: &mut WeightedMean, (x, w)| ratio.push(x, w);
        let (samples, ratio) = match SEARCHED_WEIGHTED.get(k) {
            Some(&searched) => {
                let mut ratio = WeightedMean::new();
                searched.iter().for_each(|&sample| push(&mut ratio, sample));
                (searched.to_vec(), ratio)
            }
            None => {
                let ratio = gather(&mut rng, &samples, push, WeightedMean::merge);
                (samples, ratio)
            }
        };
        let values: Vec<f32> = samples.iter().map(|&(x, _)| x).collect();
        let exact = || samples.iter().map(|&(x, w)| (f64::from(x), f64::from(w)));
        let weights: f64 = exact().map(|(_, w)| w).sum();
        let near = f64::from(values[0]);
        // From a value near the ratio: differences from the ratio itself may be far below its last digit.
        let from_near = exact().map(|(x, w)| w * (x - near)).sum::<f64>() / weights;
        let r = near + from_near;
        let off_ratio = |x: f64| (x - near) - from_near;
        let n = samples.len() as f64;
        let squares: f64 = exact().map(|(x, w)| (w * off_ratio(x)).powi(2)).sum();
        let error = (n / (n - 1.0) * squares).sqrt() / weights;
        let spread = exact().map(|(x, w)| w * off_ratio(x).powi(2)).sum::<f64>() / weights;
        if normal(r) {
            let off = (f64::from(ratio.mean().unwrap()) - r).abs();
            of_ratio.take(off / r.abs().max(spread.sqrt()), &values);
        }
        if normal(error) {
            let off = (f64::from(ratio.standard_error().unwrap()) - error).abs();
            of_error.take(off / error, &values);
        }
    }
    assert_within("ratio", of_ratio.0, doc.figure("ratio", 2));
    assert_within(
        "standard error",
        of_error.0,
        doc.figure("standard error", 2),
    );
}
