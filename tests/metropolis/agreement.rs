//! Whether R̂ and the time tell chains that have been everywhere from chains that have not.

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
