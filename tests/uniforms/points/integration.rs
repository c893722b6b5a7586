//! Errors of means against exact integrals: how they fall with the number of points, over seeds; and what would spoil them.

use super::{Set, plain, random, recurrence, second_pair, sobol};
use host::parallel::{in_parallel, threads};
use host::speed;
use host::stats::{passes, threshold, two_sided};
use microwarp::uniform::{Points, Sobol, deep_from_word, grid_from_word, open_from_word};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use std::f64::consts::{E, FRAC_PI_4};

/// The middle of a word's cell.
fn middle(word: u32) -> f64 {
    (f64::from(word) + 0.5) / f64::from(1_u32 << 16).powi(2)
}

fn smooth([x, y]: [f64; 2]) -> f64 {
    (x + y).exp()
}

fn disk([x, y]: [f64; 2]) -> f64 {
    f64::from(u8::from(x * x + y * y < 1.0))
}

/// The slope of the straight line of least squares through the logarithms of points.
fn slope(points: &[[f64; 2]]) -> f64 {
    let logs: Vec<[f64; 2]> = points.iter().map(|point| point.map(f64::log10)).collect();
    let count = logs.len() as f64;
    let sum = |of: &dyn Fn(&[f64; 2]) -> f64| logs.iter().map(of).sum::<f64>();
    let [x, y] = [sum(&|p| p[0]) / count, sum(&|p| p[1]) / count];
    sum(&|p| (p[0] - x) * (p[1] - y)) / sum(&|p| (p[0] - x).powi(2))
}

struct Integrand {
    f: fn([f64; 2]) -> f64,
    exact: f64,
    /// Of one random point.
    deviation: f64,
}

fn integrands() -> [Integrand; 2] {
    let mean = (E - 1.0).powi(2);
    let square = ((E * E - 1.0) / 2.0).powi(2);
    [
        Integrand {
            f: smooth,
            exact: mean,
            deviation: (square - mean * mean).sqrt(),
        },
        Integrand {
            f: disk,
            exact: FRAC_PI_4,
            deviation: (FRAC_PI_4 * (1.0 - FRAC_PI_4)).sqrt(),
        },
    ]
}

/// The numbers of points: 2^8 to 2^16.
const SIZES: std::ops::RangeInclusive<u32> = 8..=16;

/// What comes of a set: for each integrand the slope, and by how much the error at 2^10 is below that of random points.
#[derive(Debug)]
struct Fall {
    slope: [f64; 2],
    gain: [f64; 2],
}

impl Fall {
    fn of(name: &str, set: Set, seeds: u32) -> Self {
        let integrands = integrands();
        let seeds: Vec<u32> = (0..seeds).collect();
        let squares = in_parallel(threads(), &seeds, |seed| {
            let mut sums = [0.0; 2];
            let mut squares = Vec::new();
            for index in 0..1_u32 << SIZES.end() {
                let point = set(*seed, index).map(middle);
                for (sum, integrand) in sums.iter_mut().zip(&integrands) {
                    *sum += (integrand.f)(point);
                }
                let count = index + 1;
                if count.is_power_of_two() && count >> SIZES.start() > 0 {
                    let square = |k: usize| {
                        let error: f64 = sums[k] / f64::from(count) - integrands[k].exact;
                        error * error
                    };
                    squares.push([0, 1].map(square));
                }
            }
            squares
        });
        let rms = |k: usize, size: usize| {
            let sum: f64 = squares.iter().map(|of_seed| of_seed[size][k]).sum();
            (sum / squares.len() as f64).sqrt()
        };
        let count = |size: usize| 2f64.powi(*SIZES.start() as i32 + size as i32);
        let points = |k| -> Vec<[f64; 2]> {
            (0..squares[0].len())
                .map(|s| [count(s), rms(k, s)])
                .collect()
        };
        let fall = Self {
            slope: [0, 1].map(|k| slope(&points(k))),
            gain: [0, 1].map(|k| integrands[k].deviation / count(2).sqrt() / rms(k, 2)),
        };
        println!("{name}: {fall:.3?} over {} seeds", seeds.len());
        fall
    }

    /// Whether errors fall at least as fast as these slopes, and are as much smaller.
    fn holds(&self, slope: [f64; 2], gain: [f64; 2]) -> bool {
        (0..2).all(|k| self.slope[k] <= slope[k] && self.gain[k] >= gain[k])
    }
}

/// The first is smooth, the second a disk; on the disk the law is N^-3/4, and its slope known to some hundredths only.
const SCRAMBLED: ([f64; 2], [f64; 2]) = ([-1.35, -0.72], [450.0, 4.5]);
const RECURRENT: ([f64; 2], [f64; 2]) = ([-0.85, -0.72], [8.0, 4.5]);

#[test]
fn errors_fall_as_stated() {
    let seeds = speed::of("seeds of errors", 40, 1000);
    for (name, set) in [("sobol", sobol as Set), ("second pair", second_pair)] {
        let fall = Fall::of(name, set, seeds);
        assert!(fall.holds(SCRAMBLED.0, SCRAMBLED.1));
        if speed::full() && name == "sobol" {
            assert!(fall.slope[1] <= -0.75);
        }
    }
    let fall = Fall::of("recurrence", recurrence, seeds);
    assert!(fall.holds(RECURRENT.0, RECURRENT.1));
    assert!(!fall.holds(SCRAMBLED.0, SCRAMBLED.1));
}

/// Random points, a rotation of Sobol', and points that keep one dimension from another set.
#[test]
fn worse_points_are_rejected() {
    let seeds = speed::of("seeds of worse points", 10, 200);
    let rotated: Set = |seed, index| {
        let mut rng = Pcg32::new(u64::from(seed), 7);
        plain(index).map(|x| x.wrapping_add(rng.next_u32()))
    };
    let apart: Set = |seed, index| [sobol(seed, index)[0], second_pair(seed, index)[1]];
    for (name, set) in [
        ("random", random as Set),
        ("rotated", rotated),
        ("apart", apart),
    ] {
        let fall = Fall::of(name, set, seeds);
        assert!(!fall.holds(SCRAMBLED.0, SCRAMBLED.1), "{name}");
        // A rotation is as good as a recurrence.
        assert!(name == "rotated" || !fall.holds(RECURRENT.0, RECURRENT.1));
    }
}

/// The mean of the product of 1 + (x - 1/2) over 8 dimensions is 1, its variance (13/12)^8 - 1.
#[test]
fn eight_dimensions_beat_random_points() {
    let seeds = speed::of("seeds in 8 dimensions", 100, 1000);
    let gain = |words: &dyn Fn(u32, u32) -> [u32; 8]| {
        let error = |seed| {
            let value = |index| -> f64 {
                let point = words(seed, index).map(middle);
                point.iter().map(|x| 0.5 + x).product()
            };
            (0..1024).map(value).sum::<f64>() / 1024.0 - 1.0
        };
        let square = (0..seeds).map(|s| error(s).powi(2)).sum::<f64>() / f64::from(seeds);
        (((13.0_f64 / 12.0).powi(8) - 1.0) / 1024.0 / square).sqrt()
    };
    let whole = gain(&|seed, index| Sobol::<8>::new(seed).unwrap().words(index));
    let pairs = gain(&|seed, index| Sobol::<2>::new(seed).unwrap().words(index));
    println!("8 dimensions at 2^10: {whole:.1} times smaller, by pairs {pairs:.1}");
    assert!(whole >= 10.0 && (1.5..10.0).contains(&pairs));
}

/// Warnock's formula for the discrepancy in mean square over boxes at 0.
fn discrepancy(set: Set) -> f64 {
    let square = |seed| {
        let points: Vec<[f64; 2]> = (0..1024).map(|i| set(seed, i).map(middle)).collect();
        let count = points.len() as f64;
        let single = |[x, y]: &[f64; 2]| (1.0 - x * x) * (1.0 - y * y) / 2.0;
        let pair = |p: &[f64; 2], q: &[f64; 2]| (1.0 - p[0].max(q[0])) * (1.0 - p[1].max(q[1]));
        let singles: f64 = points.iter().map(single).sum();
        let pairs = points
            .iter()
            .map(|p| points.iter().map(|q| pair(p, q)).sum::<f64>());
        1.0 / 9.0 - singles / count + pairs.sum::<f64>() / count / count
    };
    let seeds = speed::of("seeds of the discrepancy", 20, 100);
    ((0..seeds).map(square).sum::<f64>() / f64::from(seeds)).sqrt()
}

#[test]
fn the_discrepancy_is_that_of_the_exact_scrambling() {
    let of = [sobol as Set, second_pair, recurrence, random].map(discrepancy);
    println!(
        "L2* of 2^10 points: {:.2e} {:.2e} {:.2e} {:.2e}",
        of[0], of[1], of[2], of[3]
    );
    assert!(of[0] <= 7.6e-4 && of[1] <= 7.6e-4 && of[2] <= 1.9e-3);
    assert!(of[3] > 5e-3);
}

/// p-values of no correlation between the errors of sets whose seeds differ by 1, 2, 4, ..., or in one bit.
fn correlations(set: Set) -> Vec<f64> {
    let (seeds, count) = (4096_u32, 64);
    let mean = |seed| {
        (0..count)
            .map(|i| smooth(set(seed, i).map(middle)))
            .sum::<f64>()
    };
    let means: Vec<f64> = (0..seeds).map(mean).collect();
    let centre = means.iter().sum::<f64>() / f64::from(seeds);
    let errors: Vec<f64> = means.iter().map(|m| m - centre).collect();
    let variance = errors.iter().map(|e| e * e).sum::<f64>() / f64::from(seeds);
    let p = |other: &dyn Fn(usize) -> usize| {
        let products = (0..errors.len()).map(|s| errors[s] * errors[other(s) % errors.len()]);
        let mean = products.sum::<f64>() / f64::from(seeds) / variance;
        // A bit exchanges seeds in pairs, each of which counts twice.
        two_sided(mean * f64::from(seeds).sqrt() / 2f64.sqrt())
    };
    (0..12)
        .flat_map(|bit| [p(&|s| s + (1 << bit)), p(&|s| s ^ 1 << bit)])
        .collect()
}

/// The same scrambling from seeds as they are, and of equal seeds.
#[test]
fn neighbouring_seeds_are_independent() {
    let raw: Set = |seed, index| {
        plain(index).map(|x| {
            let x = x.reverse_bits();
            let x = x ^ x.wrapping_mul(0x1705_b884);
            let x = x.wrapping_add(seed).wrapping_mul(seed >> 16 | 1);
            let x = x ^ x.wrapping_mul(0x7c2f_1220);
            (x ^ x.wrapping_mul(0xe2a6_5e92)).reverse_bits()
        })
    };
    let halved: Set = |seed, index| sobol(seed >> 1, index);
    let limit = threshold(24);
    for set in [sobol as Set, second_pair, recurrence] {
        let found = correlations(set);
        println!(
            "smallest p {:.1e}",
            found.iter().copied().fold(1.0, f64::min)
        );
        assert!(passes(&found, limit), "{found:?}");
    }
    for set in [raw, halved] {
        assert!(!passes(&correlations(set), limit));
    }
}

/// The grid is low by half its step in each coordinate, which is a part 2^-24 of this mean; the middles of cells are not.
#[test]
fn centred_cells_have_no_bias_of_truncation() {
    let seeds = speed::of("seeds of truncation", 2, 16);
    let exact = integrands()[0].exact;
    let off = |uniform: fn(u32) -> f32| {
        let error = |seed| {
            let set = Sobol::<2>::new(seed).unwrap();
            let value = |i| smooth(set.words(i).map(|w| f64::from(uniform(w))));
            (0..1 << 20).map(value).sum::<f64>() / f64::from(1 << 20) / exact - 1.0
        };
        let squares = (0..seeds).map(|seed| error(seed).powi(2)).sum::<f64>();
        (squares / f64::from(seeds)).sqrt()
    };
    let [grid, open, deep] = [grid_from_word, open_from_word, deep_from_word].map(off);
    println!(
        "2^20 points: {grid:.1e} on the grid, {open:.1e} open, {deep:.1e} in the middles of cells"
    );
    assert!((grid / 2f64.powi(-24) - 1.0).abs() < 0.1);
    assert!(deep < 2.5e-9 && open < 2.5e-9);
}
