//! The weights of combined techniques: in [0, 1], summing to 1, and accurate, whatever the densities. Roulette keeps the mean by
//! the chance that it realises; the usual ways to weigh or to decide fail the same test.

use host::docs::assert_within;
use host::errors::ulps;
use host::speed;
use host::words::first_without;
use microwarp::estimate::{balance_heuristic, power_heuristic, roulette};
use microwarp::uniform::{Chance, grid_from_word};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

pub const DENSITIES: [f32; 16] = [
    0.0,
    1e-45,
    1e-40,
    f32::MIN_POSITIVE,
    1e-25,
    1e-19,
    1e-3,
    1.0,
    3.0,
    1e5,
    1e19,
    1e20,
    1.2e29,
    3e38,
    f32::MAX,
    f32::INFINITY,
];
const COUNTS: [u32; 6] = [0, 1, 2, 7, 16_777_217, u32::MAX];

type Heuristic = fn(u32, f32, u32, f32) -> f32;

/// Each with its exponent, and its stated errors for counts of 1 and for any counts.
const HEURISTICS: [(Heuristic, i32, [&str; 2]); 2] = [
    (balance_heuristic, 1, ["3", "7"]),
    (power_heuristic, 2, ["5", "13"]),
];

/// The weight in f64: 1 of infinity against less, nothing where both are nothing.
fn exact(n_f: u32, f: f32, n_g: u32, g: f32, exponent: i32) -> f64 {
    let (f, g) = (if n_f > 0 { f } else { 0.0 }, if n_g > 0 { g } else { 0.0 });
    let [f, g] = if f == f32::INFINITY || g == f32::INFINITY {
        [f, g].map(|p| f64::from(u8::from(p == f32::INFINITY)))
    } else {
        [f64::from(f), f64::from(g)]
    };
    let (f, g) = (
        (f64::from(n_f) * f).powi(exponent),
        (f64::from(n_g) * g).powi(exponent),
    );
    if f == 0.0 { 0.0 } else { f / (f + g) }
}

/// Checks a pair of densities; returns the error.
fn check(heuristic: Heuristic, exponent: i32, [n_f, n_g]: [u32; 2], [f, g]: [f32; 2]) -> f64 {
    let (w, other) = (heuristic(n_f, f, n_g, g), heuristic(n_g, g, n_f, f));
    let what = format!("{n_f} of {f:e} against {n_g} of {g:e}: {w:e}, {other:e}");
    assert!(
        (0.0..=1.0).contains(&w) && (0.0..=1.0).contains(&other),
        "{what}"
    );
    if n_f > 0 && f > 0.0 || n_g > 0 && g > 0.0 {
        assert!((w + other - 1.0).abs() <= f32::EPSILON, "{what}");
    } else {
        assert!(w == 0.0 && other == 0.0, "{what}");
    }
    ulps(w, exact(n_f, f, n_g, g, exponent))
}

/// Counts and densities that a search found, where all roundings go one way.
pub const SEARCHED: [([u32; 2], [f32; 2]); 4] = [
    ([1, 1], [1.841_285, 234.452_09]),
    ([1, 1], [1.694_926_5, 27.112_032]),
    ([44_575_522, 34_782_094], [1.506_556_5, 247.100_11]),
    ([33_577_658, 49_031_934], [1.055_197_7, 5.755_644_3]),
];

#[test]
fn weights_survive_all_densities() {
    for (heuristic, exponent, [_, stated]) in HEURISTICS {
        for f in DENSITIES {
            for g in DENSITIES {
                for n_f in COUNTS {
                    for n_g in COUNTS {
                        let error = check(heuristic, exponent, [n_f, n_g], [f, g]);
                        let stated: f64 = stated.parse().unwrap();
                        assert!(error <= stated, "{n_f} of {f:e}, {n_g} of {g:e}: {error}");
                    }
                }
                if f == g && f > 0.0 {
                    assert_eq!(heuristic(1, f, 1, g), 0.5);
                }
            }
        }
        // No densities at all count as 0.
        for none in [f32::NAN, -1.0, -0.0, f32::NEG_INFINITY] {
            assert_eq!(heuristic(1, none, 1, 1.0), 0.0);
            assert_eq!(heuristic(1, 1.0, 1, none), 1.0);
            assert_eq!(heuristic(1, none, 1, none), 0.0);
        }
    }
    // The control: the textbook formula does not survive.
    let textbook = |f: f32, g: f32| f * f / (f * f + g * g);
    let survives = |f: f32, g: f32| (0.0..=1.0).contains(&textbook(f, g));
    assert!(survives(3.0, 1.0) && !survives(1e-25, 1e-25) && !survives(1e20, 1.0));
}

#[test]
fn weights_keep_the_stated_errors() {
    let source = include_str!("../../src/estimate/heuristic.rs");
    let mut rng = Pcg32::new(61, 54);
    for (heuristic, exponent, [single, counted]) in HEURISTICS {
        let statement =
            format!("Error: {single} ulp for counts of 1, {counted} ulp for any counts");
        assert!(source.contains(&statement), "{statement}");
        let mut worst = [0.0_f64; 2];
        for (counts, densities) in SEARCHED {
            let error = check(heuristic, exponent, counts, densities);
            let any = usize::from(counts != [1, 1]);
            worst[any] = worst[any].max(error);
        }
        for i in 0..speed::of("weights of each heuristic", 200_000, 2_000_000) {
            // Any density against one within a factor of up to 2^±160.
            let f = f32::from_bits(rng.next_u32() % f32::INFINITY.to_bits());
            let apart = (f64::from(rng.next_u32()) / 2f64.powi(31) - 1.0) * f64::from(1 + i % 160);
            let g = (f64::from(f) * apart.exp2()).min(f64::from(f32::MAX)) as f32;
            let shift = rng.next_u32() % 32;
            let counts = [
                1 + (rng.next_u32() >> shift),
                1 + (rng.next_u32() >> (31 - shift)),
            ];
            for (worst, counts) in worst.iter_mut().zip([[1, 1], counts]) {
                *worst = worst.max(check(heuristic, exponent, counts, [f, g]));
            }
        }
        for (worst, stated) in worst.into_iter().zip([single, counted]) {
            assert_within("ulp", worst, stated.parse().unwrap());
        }
    }
}

type Roulette = fn(f32, u32) -> Option<f32>;

const ALL: f64 = 4_294_967_296.0;

/// By how much the mean of the weights of all words is off 1. The words that go on are the smallest, all with one weight.
fn off(roulette: Roulette, p: f32) -> f64 {
    let weight = roulette(p, 0).map_or(0.0, f64::from);
    let goes_on = |word: u64| {
        let also = roulette(p, word as u32);
        assert!(also.is_none_or(|also| f64::from(also) == weight));
        also.is_some()
    };
    let below = first_without(0..1 << 32, goes_on);
    (below as f64 / ALL * weight - 1.0).abs()
}

/// The largest over chances above 1e-5, where a weight is rounded and chances are not whole words.
fn worst(roulette: Roulette, chances: u32) -> f64 {
    let mut rng = Pcg32::new(63, 54);
    let chance = |_| 1e-5_f32.powf(grid_from_word(rng.next_u32()));
    (0..chances)
        .map(chance)
        .map(|p| off(roulette, p))
        .fold(0.0, f64::max)
}

#[test]
fn what_goes_on_keeps_the_mean() {
    let chances = speed::of("chances of roulette", 20_000, 1_000_000);
    let ours = worst(roulette, chances);
    let by_p = worst(
        |p, word| Chance::new(p).unwrap().accepts(word).then(|| 1.0 / p),
        chances,
    );
    let by_24_bits = worst(
        |p, word| (grid_from_word(word) < p).then(|| 1.0 / p),
        chances,
    );
    println!("off the mean: {ours:.1e}; weight 1/p {by_p:.1e}; 24 bits {by_24_bits:.1e}");
    assert!(ours <= 6e-8);
    assert!(by_p > 1e-5 && by_24_bits > 1e-3);
    // Down to the least chance, which is one word.
    for p in [1.0_f32.next_down(), 0.95, 1e-9, 1e-38, 1e-45] {
        assert!(off(roulette, p) <= 6e-8, "{p:e}");
    }
}

#[test]
fn any_chance_has_an_end() {
    let mut rng = Pcg32::new(64, 54);
    for word in [0, 1, u32::MAX]
        .into_iter()
        .chain((0..100).map(|_| rng.next_u32()))
    {
        for sure in [1.0, 1.5, f32::MAX, f32::INFINITY] {
            assert_eq!(roulette(sure, word), Some(1.0));
        }
        for none in [0.0, -0.0, -1e-45, -1.0, f32::NEG_INFINITY, f32::NAN] {
            assert_eq!(roulette(none, word), None);
        }
    }
    assert_eq!(
        (roulette(1e-45, 0), roulette(1e-45, 1)),
        (Some(ALL as f32), None)
    );
    assert_eq!(Chance::new(0.0).unwrap().weight(), 0.0);
    assert_eq!(Chance::from_ratio(1, 5).unwrap().weight(), 5.0);
}
