//! Whether R̂, ranks and the time tell chains that have been everywhere from chains that have not, and whether the error of a
//! mean that is stated is the one that is made.

use crate::draws::figures;
use crate::series::{autoregression, unit};
use host::speed;
use microwarp::estimate::Moments;
use microwarp::metropolis::{
    Autocorrelation, BoxStep, Chain, Halves, Mixture, Mutation, UniformStep, WrappedWalk, r_hat,
    split_r_hat,
};
use rand_pcg::Pcg32;

const STEPS: usize = 20_000;

/// Of runs: R̂ of the whole ones, and split.
fn both(runs: &[Vec<f32>]) -> (f32, f32) {
    let (mut whole, mut split) = (Vec::new(), Vec::new());
    for run in runs {
        let (mut moments, mut halves) = (Moments::new(), Halves::new(run.len() as u64 / 2));
        for &x in run {
            moments.push(x);
            halves.push(x);
        }
        whole.push(moments);
        split.push(halves);
    }
    (
        r_hat(whole.iter()).unwrap_or(f32::NAN),
        split_r_hat(&split).unwrap(),
    )
}

fn correlated(mean: impl Fn(usize) -> f64, seed: u64) -> Vec<f32> {
    let mut rng = Pcg32::new(seed, 54);
    let run = autoregression(0.8, STEPS, &mut rng);
    let numbers = (0..).zip(run).map(|(i, x)| (mean(i) + x) as f32);
    numbers.collect()
}

#[test]
fn runs_of_one_law_agree() {
    // The halves' means are of 10⁴ numbers with a time of 9: their variance is 9e-4 of that within.
    for seed in 0..20 {
        let runs: Vec<_> = (0..4)
            .map(|k| correlated(|_| 3.0, 100 * seed + k))
            .collect();
        let (whole, split) = both(&runs);
        assert!((0.999_9..1.004).contains(&whole), "{whole}");
        assert!((0.999_9..1.006).contains(&split), "{split}");
    }
}

#[test]
fn runs_that_are_apart_do_not_agree() {
    let apart = [correlated(|_| 0.0, 1), correlated(|_| 3.0, 2)];
    let (whole, split) = both(&apart);
    println!("apart by three deviations: {whole:.3}, split {split:.3}");
    assert!(whole > 1.5 && split > 1.5);
    let near = [correlated(|_| 0.0, 1), correlated(|_| 1.0, 2)];
    assert!(both(&near).0 > 1.1 && both(&near).1 > 1.1);
    // Alone, a run that drifts is told by its halves; where all drift alike, too, but not by whole runs.
    let drift = |i: usize| 4.0 * i as f64 / STEPS as f64;
    let drifting: Vec<_> = (0..4).map(|k| correlated(drift, 10 + k)).collect();
    let (whole, split) = both(&drifting);
    println!("drifting: {whole:.3}, split {split:.3}");
    assert!(split > 1.2 && whole < 1.05);
    let (_, alone) = both(&drifting[..1]);
    assert!(alone > 1.2, "{alone}");
    let (_, steady) = both(&[correlated(|_| 0.0, 1)]);
    assert!(steady < 1.01, "{steady}");
}

/// Two humps of equal weight, on opposite sides of the circle that the unit interval is to a wrapped walk: the
/// valleys, of density 3e-11, are far wider than a small step.
fn humps(x: f32) -> f32 {
    let hump = |centre: f32| (-400.0 * (x - centre) * (x - centre)).exp();
    hump(0.25) + hump(0.75)
}

/// Split R̂, R̂, the share of the right hump and the time of chains that start in both humps in turn.
fn chains<M: Mutation<f32>>(mutation: &M) -> (f32, f32, f64, Option<f32>) {
    let (mut runs, mut right) = (Vec::new(), 0);
    let mut health = Autocorrelation::<200>::new();
    for k in 0..4 {
        let start = if k % 2 == 0 { 0.25 } else { 0.75 };
        let mut chain = Chain::new(start, humps).unwrap();
        let mut rng = Pcg32::new(k, 77);
        chain.burn_in(humps, mutation, 500, &mut rng);
        let run: Vec<f32> = (0..STEPS)
            .map(|_| chain.step(humps, mutation, &mut rng).state())
            .collect();
        right += run.iter().filter(|&&x| x > 0.5).count();
        if k == 0 {
            run.iter().for_each(|&x| health.push(x));
        }
        runs.push(run);
    }
    let (whole, split) = both(&runs);
    let share = right as f64 / (4 * STEPS) as f64;
    (split, whole, share, health.integrated_time())
}

#[test]
fn chains_stuck_in_two_humps_are_told_from_chains_that_cross() {
    let small = WrappedWalk::new(BoxStep::new(0.1).unwrap());
    let (split, whole, share, time) = chains(&small);
    println!("small steps: split {split:.3}, whole {whole:.3}, {share:.3} right, time {time:?}");
    assert!(split > 1.5 && whole > 1.5, "{split} {whole}");
    let crossing = Mixture::new((small, UniformStep::new()), &[0.7, 0.3]).unwrap();
    let (split, whole, share, time) = chains(&crossing);
    println!("mixture: split {split:.3}, whole {whole:.3}, {share:.3} right, time {time:?}");
    assert!(split < 1.02 && whole < 1.02, "{split} {whole}");
    let time = f64::from(time.unwrap());
    // Of shares: half of the time in each hump, with the error that the time says, seven times.
    let error = (0.25 * time / (4 * STEPS) as f64).sqrt();
    assert!((share - 0.5).abs() <= 7.0 * error, "{share} ± {error}");
    // One that starts right and is stuck there would be a half off: a hundred errors.
    assert!(7.0 * error < 0.2, "{error}");
}

/// A function of which hump a chain is in has a longer time than the place within it.
#[test]
fn the_time_of_a_rare_crossing_is_seen() {
    let small = WrappedWalk::new(BoxStep::new(0.1).unwrap());
    let rare = Mixture::new((small, UniformStep::new()), &[0.9, 0.1]).unwrap();
    let mut chain = Chain::new(0.25, humps).unwrap();
    let mut rng = Pcg32::new(5, 77);
    let (mut which, mut within) = (Autocorrelation::<600>::new(), Autocorrelation::<600>::new());
    for _ in 0..speed::of("steps", 50_000, 200_000) {
        let x = chain.step(humps, &rare, &mut rng).state();
        which.push(if x > 0.5 { 1.0 } else { 0.0 });
        within.push((x - if x > 0.5 { 0.75 } else { 0.25 }).abs());
    }
    let (which, within) = (
        which.integrated_time().unwrap(),
        within.integrated_time().unwrap(),
    );
    println!("which hump: {which:.1} steps; place within it: {within:.1}");
    assert!(which > 1.5 * within, "{which} {within}");
}

/// Chains of one mean, of which one is wider, and chains without a variance, of which one is apart.
#[test]
fn ranks_see_what_the_means_of_draws_do_not() {
    let mut rng = Pcg32::new(0xf01d, 54);
    let mut hats = |wide: f64| {
        let run = |k: usize, rng: &mut Pcg32| -> Vec<f32> {
            let scale = if k == 0 { wide } else { 1.0 };
            let run = autoregression(0.5, 2000, rng);
            run.iter().map(|x| (7.0 + scale * x) as f32).collect()
        };
        let runs: Vec<_> = (0..4).map(|k| run(k, &mut rng)).collect();
        // In fixed memory: the distance from a number near the median.
        let mut folds = [Halves::new(1000); 4];
        for (fold, run) in folds.iter_mut().zip(&runs) {
            run.iter().for_each(|x| fold.push((x - 7.0).abs()));
        }
        let [split, rank, folded, ..] = figures(&runs);
        [split, rank, folded, f64::from(split_r_hat(&folds).unwrap())]
    };
    let (equal, unequal) = (hats(1.0), hats(3.0));
    println!("spreads alike {equal:.3?}, unequal {unequal:.3?}");
    assert!(equal.iter().all(|r| *r < 1.01));
    assert!(unequal[0] < 1.01 && unequal[1..].iter().all(|r| *r > 1.1));
    let cauchy = |rng: &mut Pcg32| (std::f64::consts::PI * (unit(rng) - 0.5)).tan();
    let mut apart = |by: f64| {
        let run = |k: usize, rng: &mut Pcg32| -> Vec<f32> {
            let shift = if k == 0 { by } else { 0.0 };
            (0..2000).map(|_| (shift + cauchy(rng)) as f32).collect()
        };
        figures(&(0..4).map(|k| run(k, &mut rng)).collect::<Vec<_>>())
    };
    let (equal, unequal) = (apart(0.0), apart(2.0));
    println!("heavy tails alike {equal:.3?}, apart {unequal:.3?}");
    assert!(equal[1] < 1.01 && unequal[0] < 1.01 && unequal[1] > 1.05);
}

/// The error of a mean that is stated is the one that is made, of independent draws and of dependent ones.
#[test]
fn the_standard_error_is_that_of_the_mean() {
    let mut rng = Pcg32::new(0x5e, 54);
    let (runs, n) = (speed::of("runs", 400, 2000), 500);
    for rho in [0.0, 0.8] {
        let (mut squares, mut lost) = ([0.0; 3], 0);
        for _ in 0..runs {
            let run: Vec<f32> =
                (autoregression(rho, n, &mut rng).iter().map(|&x| x as f32)).collect();
            let mean = run.iter().map(|&x| f64::from(x)).sum::<f64>() / n as f64;
            let mut health = Autocorrelation::<99>::new();
            let mut naive = Moments::new();
            for &x in &run {
                health.push(x);
                naive.push(x);
            }
            // The definition in the one run, of its own effective size.
            let Some(size) = health.effective_sample_size() else {
                lost += 1;
                continue;
            };
            let streamed = health.standard_error().unwrap();
            let product = f64::from(naive.std_dev().unwrap()) / f64::from(size).sqrt();
            assert!((f64::from(streamed) / product - 1.0).abs() < 1e-6);
            let errors = [
                figures(&[run])[6],
                f64::from(streamed),
                f64::from(naive.standard_error().unwrap()),
            ];
            for (square, error) in squares.iter_mut().zip(errors) {
                *square += (mean / error).powi(2);
            }
        }
        assert!(lost * 20 <= runs, "{lost}");
        let squares = squares.map(|square| square / f64::from(runs - lost));
        println!("ρ = {rho}: mean square of an error beside the stated {squares:.2?}");
        // A mean of squares of about normal numbers: 7 of its deviations, and some bias of the sizes.
        let limit = 7.0 * (2.0 / f64::from(runs)).sqrt() + 0.2;
        assert!(
            squares[..2]
                .iter()
                .all(|square| (square - 1.0).abs() < limit)
        );
        // What takes them for independent is found out.
        assert!(
            rho == 0.0 || (squares[2] - 1.0).abs() > limit,
            "{squares:?}"
        );
    }
}
