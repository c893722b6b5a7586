//! Starts by logarithms of any size: the greater candidate is chosen however far the logarithms are from 0 or
//! from one another, and no weight leaves the range of `f32`.

use crate::start_weights::Listed;
use microwarp::metropolis::{Chain, LogDensity, UniformIndex};
use microwarp::tier::{Libm, Poly, Tier};
use rand_pcg::Pcg32;

/// The share of starts at the second of two states whose logarithms differ by 1, at a distance from 0.
fn second<T: Tier>(shift: f32, spacing: f32) -> f64 {
    let target = |i: usize| LogDensity::<T>::new(shift + if i == 0 { 0.0 } else { spacing });
    let either = UniformIndex::new(2).unwrap();
    let runs = 20_000;
    let chosen = (0..runs).filter(|&seed| {
        let start = Chain::resample(target, &either, 8, &mut Pcg32::new(seed, 3)).unwrap();
        start.chain.state() == 1
    });
    chosen.count() as f64 / f64::from(runs as u32)
}

/// By the law of the counts of both among 8 candidates.
fn exact(spacing: f64) -> f64 {
    let choose = [1.0, 8.0, 28.0, 56.0, 70.0, 56.0, 28.0, 8.0, 1.0];
    let share = |(k, ways): (usize, &f64)| {
        let heavy = k as f64 * spacing.exp();
        let light = 8.0 - k as f64;
        let share = if heavy.is_infinite() {
            1.0
        } else {
            heavy / (heavy + light)
        };
        ways / 256.0 * if k == 0 { 0.0 } else { share }
    };
    choose.iter().enumerate().map(share).sum()
}

fn far<T: Tier>() {
    for (shift, spacing) in [
        (0.0, 1.0),
        (1e4, 1.0),
        (-1e6, 1.0),
        (3e9, 256.0),
        (-3e9, 512.0),
        (-1e30, 1e29),
        (1e38, 2e38),
        (-f32::MAX, f32::MAX),
    ] {
        let (found, due) = (second::<T>(shift, spacing), exact(spacing.into()));
        let off = (found - due) / (due * (1.0 - due) / 20_000.0).sqrt();
        println!(
            "{} {shift:e} + {spacing:e}: {found:.4}, due {due:.4}, {off:.1} deviations",
            T::NAME
        );
        assert!(off.abs() <= 6.0, "{shift:e} {spacing:e}: {found} for {due}");
    }
    // The control: logarithms that count as equal choose both alike.
    let off = (second::<T>(3e9, 0.0) - exact(256.0)) / 0.000_5;
    assert!(off.abs() > 6.0);
}

#[test]
fn the_greater_candidate_is_chosen_however_large_the_logarithms() {
    far::<Libm>();
    far::<Poly>();
}

/// Weights below and above what `f32` holds are the nearest positive ones.
#[test]
fn weights_out_of_range_are_the_nearest_in_range() {
    let tiny = f32::from_bits(1);
    for (density, pdf, weight) in [
        (tiny, 100.0, tiny),
        (tiny, f32::MAX, tiny),
        (f32::MAX, 1e-3, f32::MAX),
        (f32::MAX, tiny, f32::MAX),
        (3.0, 2.0, 1.5),
    ] {
        let source = Listed { pdf: &[pdf] };
        let start = Chain::resample(|_| density, &source, 5, &mut Pcg32::new(1, 1)).unwrap();
        assert_eq!(start.weight, weight, "{density:e} {pdf:e}");
        let log = |_| LogDensity::<Poly>::new(f32::MAX);
        let start = Chain::resample(log, &source, 5, &mut Pcg32::new(1, 1)).unwrap();
        assert!(start.weight.get().is_finite());
    }
}
