//! The weights of any number of techniques: in [0, 1], summing to 1, and accurate, whatever the densities.

use crate::heuristics::{DENSITIES, SEARCHED};
use host::docs::assert_within;
use host::errors::ulps;
use host::speed;
use microwarp::estimate::{
    balance_heuristic, balance_heuristic_of, power_heuristic, power_heuristic_of,
};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

type Technique = (u32, f32);
type Heuristic = fn(&[Technique], usize) -> f32;

/// Each with its exponent, and by how many ulp its stated errors exceed the number of techniques, for counts of 1 and for any.
const HEURISTICS: [(Heuristic, i32, [usize; 2]); 2] = [(balance, 1, [0, 4]), (power, 2, [2, 10])];

fn balance(techniques: &[Technique], own: usize) -> f32 {
    let (counts, densities): (Vec<_>, Vec<_>) = techniques.iter().copied().unzip();
    balance_heuristic_of(&counts, &densities, own)
}

fn power(techniques: &[Technique], own: usize) -> f32 {
    let (counts, densities): (Vec<_>, Vec<_>) = techniques.iter().copied().unzip();
    power_heuristic_of(&counts, &densities, own)
}

/// What each technique has of the sum, in f64.
fn parts(techniques: &[Technique], exponent: i32) -> Vec<f64> {
    let valid = |&(n, p): &Technique| if n > 0 && p > 0.0 { p } else { 0.0 };
    let infinite = techniques.iter().any(|t| valid(t) == f32::INFINITY);
    let part = |technique: &Technique| {
        let p = match valid(technique) {
            p if infinite => f64::from(u8::from(p == f32::INFINITY)),
            p => f64::from(p),
        };
        (f64::from(technique.0) * p).powi(exponent)
    };
    techniques.iter().map(part).collect()
}

/// The largest error of the weights of all, in ulp.
fn worst(heuristic: Heuristic, exponent: i32, techniques: &[Technique]) -> f64 {
    let parts = parts(techniques, exponent);
    let (sum, mut weights) = (parts.iter().sum::<f64>(), 0.0);
    let mut worst = 0.0_f64;
    for (own, part) in parts.iter().enumerate() {
        let w = heuristic(techniques, own);
        assert!((0.0..=1.0).contains(&w), "{w} of {techniques:?}");
        weights += f64::from(w);
        worst = worst.max(ulps(w, if sum > 0.0 { part / sum } else { 0.0 }));
    }
    let should = f64::from(u8::from(sum > 0.0));
    let slack = (techniques.len() + 10) as f64 * f64::from(f32::EPSILON);
    assert!(
        (weights - should).abs() <= slack,
        "{weights} of {techniques:?}"
    );
    worst
}

#[test]
fn weights_of_three_survive_all_densities() {
    let all = DENSITIES
        .into_iter()
        .chain([f32::NAN, -1.0, f32::NEG_INFINITY]);
    let all: Vec<f32> = all.collect();
    for (heuristic, exponent, [_, over]) in HEURISTICS {
        for &f in &all {
            for &g in &all {
                for h in [0.0, 1e-45, 1.0, f32::MAX] {
                    for [a, b, c] in [[1, 1, 1], [0, 7, u32::MAX], [u32::MAX, 0, 0]] {
                        let techniques = [(a, f), (b, g), (c, h)];
                        let error = worst(heuristic, exponent, &techniques);
                        assert!(error <= (3 + over) as f64, "{techniques:?}: {error}");
                    }
                }
            }
        }
        assert_eq!(heuristic(&[], 0), 0.0);
        assert_eq!(heuristic(&[(1, 1.0)], 0), 1.0);
        assert_eq!(heuristic(&[(1, 1.0)], 1), 0.0);
        let many = vec![(u32::MAX, f32::MAX); 1 << 16];
        assert!((heuristic(&many, 9) * 65_536.0 - 1.0).abs() < 1e-2);
    }
}

#[test]
fn weights_of_several_keep_the_stated_errors() {
    let source = include_str!("../../src/estimate/heuristic.rs");
    let mut rng = Pcg32::new(62, 54);
    for (heuristic, exponent, [single, counted]) in HEURISTICS {
        let ulp = |over: usize| match over {
            0 => "N ulp".into(),
            over => format!("N + {over} ulp"),
        };
        let statement = format!(
            "{} for counts of 1, {} for any counts",
            ulp(single),
            ulp(counted)
        );
        assert!(source.contains(&statement), "{statement}");
        let mut most = [[0.0_f64; 2]; 9];
        for ([n, m], [p, q]) in SEARCHED {
            let error = worst(heuristic, exponent, &[(n, p), (m, q)]);
            let most = &mut most[2][usize::from([n, m] != [1, 1])];
            *most = most.max(error);
        }
        for i in 0..speed::of("weights of several techniques", 60_000, 2_000_000) {
            let n = 1 + i % 8;
            // Densities within a factor of up to 2^±160, and mostly of much less.
            let middle = f32::from_bits(rng.next_u32() % f32::INFINITY.to_bits());
            let spread = f64::from(1 << (rng.next_u32() % 8));
            let techniques: [Technique; 8] = std::array::from_fn(|_| {
                let apart = (f64::from(rng.next_u32()) / 2f64.powi(31) - 1.0) * spread;
                let p = (f64::from(middle) * apart.exp2()).min(f64::from(f32::MAX)) as f32;
                (1 + (rng.next_u32() >> (rng.next_u32() % 32)), p)
            });
            let ones = techniques.map(|(_, p)| (1, p));
            for (most, techniques) in most[n].iter_mut().zip([ones, techniques]) {
                *most = most.max(worst(heuristic, exponent, &techniques[..n]));
            }
        }
        println!("ulp by number, for counts of 1 and any: {most:.1?}");
        for (n, most) in most.into_iter().enumerate() {
            for (most, over) in most.into_iter().zip([single, counted]) {
                assert!(most <= (n + over) as f64, "{n}: {most}");
            }
        }
        // The bounds of two are not far from what happens.
        assert_within("ulp of two", most[2][0], (2 + single) as f64);
        assert_within("ulp of two", most[2][1], (2 + counted) as f64);
    }
}

/// The same tests reject the weights of the textbook, and those without the counts.
#[test]
fn wrong_weights_are_rejected() {
    let textbook: Heuristic = |techniques, own| {
        let part = |(n, p): Technique| (n as f32 * p) * (n as f32 * p);
        part(techniques[own]) / techniques.iter().map(|t| part(*t)).sum::<f32>()
    };
    let uncounted: Heuristic = |techniques, own| {
        let ones: Vec<Technique> = techniques.iter().map(|(_, p)| (1, *p)).collect();
        power(&ones, own)
    };
    let rejects = |heuristic: Heuristic, techniques: &[Technique]| {
        let what = std::panic::catch_unwind(|| worst(heuristic, 2, techniques));
        what.is_err() || what.is_ok_and(|error| error > (techniques.len() + 10) as f64)
    };
    let tame = [(1, 1.0), (1, 2.0), (1, 5.0)];
    let counted = [(1, 1.0), (4, 2.0), (1, 5.0)];
    assert!(!rejects(textbook, &tame) && !rejects(uncounted, &tame));
    assert!(rejects(uncounted, &counted) && !rejects(textbook, &counted));
    for p in [1e-25, 1e25] {
        let wild = [(1, p), (1, 2.0 * p), (1, p)];
        assert!(rejects(textbook, &wild) && !rejects(power, &wild));
    }
}

#[test]
fn two_of_several_are_the_two() {
    for f in DENSITIES {
        for g in DENSITIES {
            for (n_f, n_g) in [(1, 1), (7, 3), (0, 2)] {
                let two = [(n_f, f), (n_g, g)];
                let [balance, power] = [balance as Heuristic, power].map(|of| of(&two, 0));
                let near = |x: f32, y: f32| (x - y).abs() <= 20.0 * f32::EPSILON * y + 1e-44;
                assert!(near(balance, balance_heuristic(n_f, f, n_g, g)), "{two:?}");
                assert!(near(power, power_heuristic(n_f, f, n_g, g)), "{two:?}");
            }
        }
    }
}
