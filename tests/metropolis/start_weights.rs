//! The weight of a start: against exact sums, over all magnitudes, in logarithms; and its stated error.

use microwarp::metropolis::{Chain, HastingsRatio, LogDensity, Start, StateSource, TargetDensity};
use microwarp::rejection::Failure;
use microwarp::tier::{Libm, Poly, Tier};
use rand_core::TryRng;
use rand_pcg::Pcg32;

/// Indices, each a word modulo their number, with given densities.
pub struct Listed<'a> {
    pub pdf: &'a [f32],
}

impl StateSource<usize> for Listed<'_> {
    type Correction = HastingsRatio;
    fn try_draw_state<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<usize, R::Error> {
        Ok(rng.try_next_u32()? as usize % self.pdf.len())
    }
    fn pdf_of_state(&self, state: usize) -> f32 {
        self.pdf[state]
    }
    fn ratio_of_states(&self, from: usize, to: usize) -> HastingsRatio {
        HastingsRatio::new(self.pdf[to], self.pdf[from])
    }
}

/// What `resample` should have found, from the words that it took.
struct Replay {
    /// ln W, but for the shift.
    log_weight: f64,
    relative_error: f64,
    positive: u32,
}

/// Replays the words of a run: a state, then a word that decides.
fn replay(pdf: &[f32], log: &[f64], candidates: u32, mut rng: Pcg32) -> Replay {
    let source = Listed { pdf };
    let mut weights = Vec::new();
    for _ in 0..candidates {
        let Ok(state) = source.try_draw_state(&mut rng);
        let Ok(_) = rng.try_next_u32();
        weights.push(log[state] - f64::from(pdf[state]).ln());
    }
    let largest = weights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let scaled: Vec<f64> = weights.iter().map(|w| (w - largest).exp()).collect();
    let n = f64::from(candidates);
    let mean = scaled.iter().sum::<f64>() / n;
    let squares = scaled.iter().map(|w| w * w).sum::<f64>() / n;
    Replay {
        log_weight: largest + mean.ln(),
        relative_error: ((squares / (mean * mean) - 1.0) / (n - 1.0)).sqrt(),
        positive: weights.iter().filter(|w| w.is_finite()).count() as u32,
    }
}

/// The base of the weights rises a hundred times, each time by a little, while the weights fall.
#[test]
fn a_density_that_rises_in_many_steps_leaves_the_sums_in_range() {
    for (rise, fall) in [
        (1.01_f32, 4.0_f32),
        (1.001, 2.0),
        (1.3, 3.0),
        (1.01, 1.0),
        (1.99, 2.5),
    ] {
        let target: Vec<f32> = (0..100).map(|i| 1e-20 * rise.powi(i)).collect();
        let ratio = f64::from(rise * fall);
        let pdf: Vec<f32> = (0..100).map(|i| (1e-37 * ratio.powi(i)) as f32).collect();
        // Each in its turn, and a word that decides.
        let words: Vec<u32> = (0..100).flat_map(|i| [i, 0xffff_ffff]).collect();
        let mut rng = host::generators::Cycle::new(&words);
        let found =
            Chain::resample(|i: usize| target[i], &Listed { pdf: &pdf }, 100, &mut rng).unwrap();
        let weights: Vec<f64> = (0..100)
            .map(|i| f64::from(target[i]) / f64::from(pdf[i]))
            .collect();
        let mean = weights.iter().sum::<f64>() / 100.0;
        let squares = weights.iter().map(|w| w * w).sum::<f64>() / 100.0;
        let exact = ((squares / (mean * mean) - 1.0).max(0.0) / 99.0).sqrt();
        let error = f64::from(found.relative_error.unwrap());
        println!("rise {rise}, fall {fall}: {error} for {exact}");
        assert!(spread_off(error, exact, 100) <= SPREAD_ERROR * 10.0);
        assert!((f64::from(found.weight) / mean - 1.0).abs() <= 1e-5);
    }
}

/// Densities of 97 indices over 76 decades; some are 0 and some none at all.
fn densities(decades: f32) -> Vec<f32> {
    let of = |i: usize| match i % 16 {
        5 => 0.0,
        9 => f32::NAN,
        13 => -1.0,
        _ => 10_f32.powf(decades * (((i * 53) % 97) as f32 / 48.0 - 1.0)),
    };
    (0..97).map(of).collect()
}

/// The natural logarithms, as f64; −∞ where a candidate counts as none.
fn logarithms(densities: &[f32]) -> Vec<f64> {
    let log = |d: &f32| {
        if *d > 0.0 {
            f64::from(*d).ln()
        } else {
            f64::NEG_INFINITY
        }
    };
    densities.iter().map(log).collect()
}

fn start<D: TargetDensity>(
    target: impl Fn(usize) -> D,
    pdf: &[f32],
    candidates: u32,
    seed: u64,
) -> Option<Start<usize, D>> {
    let mut rng = Pcg32::new(seed, candidates.into());
    match Chain::resample(target, &Listed { pdf }, candidates, &mut rng) {
        Ok(start) => Some(start),
        Err(failure) => {
            assert_eq!(failure, Failure::BudgetSpent { tries: candidates });
            None
        }
    }
}

/// How far the square of a relative error of a mean of n is off. With n − 1 and 1 it makes the mean square over
/// the square of the mean, of which f32 keeps its digits; of a small difference from 1 it cannot.
fn spread_off(found: f64, exact: f64, n: u32) -> f64 {
    let quotient = |error: f64| 1.0 + error * error * f64::from(n - 1);
    (quotient(found) / quotient(exact) - 1.0).abs()
}

/// Half an ulp each: of the two sums, two quotients by the count, two by the mean, where the error of the mean
/// counts twice; of the weights themselves, in both sums; and of the last difference, quotient and root.
const SPREAD_ERROR: f64 = 6.0 / 8_388_608.0;

#[test]
fn weights_of_all_magnitudes_and_counts_are_exact() {
    let (mut worst, mut worst_error) = (0.0_f64, 0.0_f64);
    let flat = vec![1.0 / 97.0; 97];
    let skewed: Vec<f32> = (0..97).map(|i| 2_f32.powi(i % 11 - 5) / 97.0).collect();
    for (decades, pdf) in [(38.0, &flat), (30.0, &skewed), (3.0, &skewed), (0.1, &flat)] {
        let target = densities(decades);
        let log = logarithms(&target);
        for candidates in [1, 2, 3, 7, 8, 100, 999, 10_000, 100_000] {
            for seed in 0..(200_000 / candidates).clamp(1, 300) {
                let rng = Pcg32::new(seed.into(), candidates.into());
                let exact = replay(pdf, &log, candidates, rng);
                let found = start(|i| target[i], pdf, candidates, seed.into());
                let Some(found) = found else {
                    assert_eq!(exact.positive, 0);
                    continue;
                };
                assert_eq!(found.positive, exact.positive);
                let state = found.chain.state();
                assert_eq!(found.chain.density().to_bits(), target[state].to_bits());
                assert_eq!(found.relative_error.is_none(), candidates == 1);
                // A weight beyond f32 is the largest one.
                if exact.log_weight >= f64::from(f32::MAX).ln() {
                    assert_eq!(found.weight, f32::MAX);
                } else {
                    let exact = exact.log_weight.exp();
                    // Below the normal numbers half of their step comes on top.
                    let off = (f64::from(found.weight) - exact).abs() - 2_f64.powi(-150);
                    worst = worst.max(off / exact);
                    assert!(!off.is_nan());
                }
                if let Some(error) = found.relative_error {
                    let off = spread_off(error.into(), exact.relative_error, candidates);
                    assert!(!off.is_nan());
                    worst_error = worst_error.max(off);
                }
            }
        }
    }
    // The quotient's half an ulp, and 2⁻²³ as stated.
    println!("weight off by {:.2} · 2⁻²³", worst * 8_388_608.0);
    println!(
        "1 + n error² off by {:.2} · 2⁻²³",
        worst_error * 8_388_608.0
    );
    assert!(worst <= 1.5 * 2_f64.powi(-23));
    assert!(worst_error <= SPREAD_ERROR);
}

/// Logarithms that f32 holds exactly even when shifted by 1e4: multiples of 1/64.
fn exact_logarithms() -> Vec<f32> {
    (0..97)
        .map(|i| (((i * 53) % 97) as f32 - 48.0) * (17.0 / 64.0))
        .collect()
}

fn logarithms_agree<T: Tier>() {
    let log = exact_logarithms();
    let linear: Vec<f32> = log.iter().map(|l| f64::from(*l).exp() as f32).collect();
    let pdf = vec![1.0 / 97.0; 97];
    let mut worst = 0.0_f64;
    for shift in [-1e4_f32, -90.0, 0.0, 90.0, 1e4] {
        let target = |i: usize| LogDensity::<T>::new(log[i] + shift);
        for candidates in [1, 2, 5, 30, 300] {
            for seed in 0..300 {
                let plain = start(|i| linear[i], &pdf, candidates, seed).unwrap();
                let found = start(target, &pdf, candidates, seed).unwrap();
                assert_eq!(found.chain.state(), plain.chain.state());
                assert_eq!(found.chain.density(), target(plain.chain.state()));
                assert_eq!(found.positive, plain.positive);
                let exact = f64::from(plain.weight).ln() + f64::from(shift);
                let off = (f64::from(found.weight.get()) - exact).abs();
                // In units of the stated 2⁻²³, of W and, as f32 has to, of its logarithm.
                let unit = 2_f64.powi(-23) * (1.0 + exact.abs());
                assert!(!off.is_nan());
                worst = worst.max(off / unit);
                match (found.relative_error, plain.relative_error) {
                    (Some(a), Some(b)) => {
                        let off = spread_off(a.into(), b.into(), candidates);
                        assert!(off <= 2.0 * SPREAD_ERROR, "{a} {b}");
                    }
                    (a, b) => assert_eq!(a, b),
                }
            }
        }
    }
    println!("logarithm of a weight off by {worst:.2} · 2⁻²³ (1 + its size)");
    // The plain weight that it is compared with 1.5, its own exponential half an ulp; and in proportion to
    // the logarithm a product and a sum, half an ulp each.
    assert!(worst <= 2.0);
}

#[test]
fn logarithms_choose_the_same_starts_and_have_the_logarithms_of_the_weights() {
    logarithms_agree::<Poly>();
    logarithms_agree::<Libm>();
}
