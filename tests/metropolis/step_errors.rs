//! The errors of steps, over every word, against f64.

use crate::exact::assert_stated;
use crate::laws::{HALF, Law, exponential, normal};
use host::docs::Doc;
use host::errors::ulp;
use host::speed::{self, sampled};
use microwarp::tier::{Libm, Poly, Tier};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// The words looked at whose leading bit is 0.
fn halves() -> Vec<u32> {
    sampled(0..HALF, speed::of("one word of", 64, 1)).collect()
}

/// Words with the sizes of their normal steps: the quantiles of odd multiples of 2⁻²⁵ up to 1/2, by Newton's method
/// of third order from each to the next. Its function is libm's erf in f64, which no tier uses.
fn quantiles(words: &[u32]) -> Vec<(u32, f64)> {
    let mut z = 0.0_f64;
    let mut sizes: Vec<(u32, f64)> = words
        .iter()
        .rev()
        .map(|&high| {
            let p = (2.0 * f64::from(high) + 1.0) * 2f64.powi(-25);
            // Where words are left out, and far out, the steps between neighbours are long.
            let near = words.len() == HALF as usize && p >= 1e-5;
            for _ in 0..if near { 2 } else { 6 } {
                let density = (-0.5 * z * z).exp() / TAU.sqrt();
                let miss = if p > 0.25 {
                    (0.5 - p) - 0.5 * libm::erf(z * FRAC_1_SQRT_2)
                } else {
                    0.5 * libm::erfc(z * FRAC_1_SQRT_2) - p
                };
                let newton = miss / density;
                z += newton * (1.0 + 0.5 * z * newton);
            }
            (high, z)
        })
        .collect();
    sizes.reverse();
    sizes
}

/// The largest error of a normal step in ulp, and the deviation of the largest that its word could have with
/// another deviation.
fn normal_error<T: Tier>(deviation: f32, quantiles: &[(u32, f64)]) -> (f64, f32) {
    let law = normal::<T>(deviation);
    let (mut worst, mut worst_anywhere, mut there) = (0.0_f64, 0.0, 1.0);
    for &(high, size) in quantiles {
        let exact = size * f64::from(deviation);
        let got = f64::from((law.step)(high << 8)).abs();
        assert!(got.is_finite(), "{}", law.name);
        let error = (got - exact).abs() / ulp(exact);
        worst = worst.max(error);
        // An ulp is smallest beside a number just below a power of two: a deviation moves any step there.
        let significand = size / 2f64.powf(size.log2().floor());
        if error / significand > worst_anywhere {
            worst_anywhere = error / significand;
            there = 1.999_99 / significand;
        }
    }
    (worst, there as f32)
}

fn normal_errors<T: Tier>(column: usize, quantiles: &[(u32, f64)]) {
    let (mut worst, there) = normal_error::<T>(1.0, quantiles);
    for deviation in [there, 1e-38, 1e37, 6e37, 1.1, 1.7, 0.3] {
        let (error, _) = normal_error::<T>(deviation, quantiles);
        println!("{} NormalStep {deviation:e}: {error:.2} ulp", T::NAME);
        worst = worst.max(error);
    }
    let stated = Doc::of("metropolis", "NormalStep").figure("step, ulp", column);
    assert_stated(&format!("{} NormalStep, ulp", T::NAME), worst, stated);
    // Subnormal deviations, whose steps have their own spacing.
    for deviation in [1.0e-39, f32::from_bits(77), f32::from_bits(1)] {
        let (error, _) = normal_error::<T>(deviation, quantiles);
        println!("{} NormalStep {deviation:e}: {error:.2} ulp", T::NAME);
        assert!(error <= stated);
    }
    // A deviation that is off by a millionth shows.
    let (right, wrong) = (1.5_f64, normal::<T>(1.500_001_5));
    let shows = quantiles.iter().any(|&(high, size)| {
        let exact = size * right;
        (f64::from((wrong.step)(high << 8)).abs() - exact).abs() / ulp(exact) > stated
    });
    assert!(shows);
}

#[test]
fn normal_steps_have_the_stated_error() {
    // A known value, from tables of more digits: Φ⁻¹(1/4), between two words.
    let [(_, below), (_, above)] = quantiles(&[HALF / 2 - 1, HALF / 2])[..] else {
        unreachable!("one size a word")
    };
    let quarter = 0.5 * (below + above);
    assert!((quarter - 0.674_489_750_196_081_7).abs() < 1e-13);
    let quantiles = quantiles(&halves());
    normal_errors::<Libm>(0, &quantiles);
    normal_errors::<Poly>(1, &quantiles);
}

/// The largest relative error of the sizes that are no subnormal numbers; of the others, what is left of the
/// error in spacings when that is granted.
fn sizes_off(words: &[u32], law: &Law, [smallest, largest]: [f64; 2], granted: f64) -> (f64, f64) {
    let span = smallest.ln() - largest.ln();
    let (mut relative, mut spacings) = (0.0_f64, 0.0_f64);
    for &high in words {
        let u = (2.0 * f64::from(high) + 1.0) * 2f64.powi(-24);
        let exact = largest * (u * span).exp();
        let got = f64::from((law.step)(high << 8));
        assert!(got.is_finite() && got > 0.0, "{}: {high:x}", law.name);
        let off = (got - exact).abs();
        if exact < f64::from(f32::MIN_POSITIVE) {
            spacings = spacings.max((off - granted * exact) / 2f64.powi(-149));
        } else {
            relative = relative.max(off / exact);
        }
    }
    (relative, spacings)
}

fn exponential_errors<T: Tier>(column: usize) {
    let words = halves();
    let tiny = f32::from_bits(1);
    let stated = Doc::of("metropolis", "LogUniformStep").figure("step, relative", column);
    let mut worst = 0.0_f64;
    for (smallest, largest) in [
        (1.0 / 1024.0, 1.0 / 64.0),
        (0.001, 0.1),
        (1e-6, 1.0),
        (1e-10, 3.0),
        (1e-20, 1e10),
        (1e-30, 1e30),
        (1e-38, 1e38),
        (1e-30, 1.1e-30),
        (1e30, 1.000_01e30),
        (3e37, 3.3e38),
        (7.0, 7.000_001),
        (tiny, f32::MAX),
        (tiny, 1.0),
        (1e-40, 1e-39),
        (1.1e-40, 1.2e-40),
        (6.198e-42, 6.528_65e-42),
        (3.0 * tiny, 5.0 * tiny),
        (1.3e-38, f32::MAX),
        (1.08, f32::MAX),
        (1.7, f32::MAX),
        (2.6e9, f32::MAX),
    ] {
        let law = exponential::<T>(smallest, largest);
        let sizes = [smallest, largest].map(f64::from);
        let (relative, spacings) = sizes_off(&words, &law, sizes, stated);
        println!("{}: {relative:.2e}, {spacings:.2} spacings", law.name);
        worst = worst.max(relative);
        // Among subnormal numbers each rounding is half a spacing: one of the size, the other on the way.
        assert!(spacings <= 1.0, "{}: {spacings}", law.name);
        let sound = |&high: &u32| (smallest..=largest).contains(&(law.step)(high << 8));
        assert!(words.iter().all(sound), "{}: outside", law.name);
    }
    assert_stated(&format!("{} LogUniformStep", T::NAME), worst, stated);
    let wrong = exponential::<T>(1.000_01e-6, 1.0);
    let (off, _) = sizes_off(&words, &wrong, [1e-6, 1.0], stated);
    assert!(off > stated, "a size off by 1e-5 passes: {off:e}");
}

#[test]
fn log_uniform_steps_have_the_stated_error() {
    exponential_errors::<Libm>(0);
    exponential_errors::<Poly>(1);
}

/// Where there is nothing to choose every step is the one size, to the bit.
#[test]
fn equal_sizes_give_that_size_always() {
    let words = halves();
    for size in [
        1.0,
        1e-30,
        1e30,
        f32::MAX,
        f32::MIN_POSITIVE,
        f32::from_bits(1),
    ] {
        for law in [
            exponential::<Libm>(size, size),
            exponential::<Poly>(size, size),
        ] {
            assert!(
                words.iter().all(|&high| (law.step)(high << 8) == size),
                "{}",
                law.name
            );
        }
    }
}
