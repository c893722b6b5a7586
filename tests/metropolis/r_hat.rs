//! R̂ against its definition in f64, over stored runs of any magnitude, and whether it distinguishes chains that agree
//! from chains that do not.

use crate::diagnosis;
use crate::exact::assert_stated;
use crate::series::{SHAPES, normal, shaped};
use host::docs::Doc;
use host::speed;
use microwarp::estimate::Moments;
use microwarp::metropolis::{Halves, r_hat, split_r_hat};
use rand_core::Rng;
use rand_pcg::Pcg32;

/// The definition, on the scale of the largest number, about one of them.
fn exact(runs: &[&[f32]]) -> Option<f64> {
    let wide = runs
        .iter()
        .flat_map(|run| run.iter())
        .map(|&x| f64::from(x));
    let first = wide.clone().next()?;
    let scale = wide.clone().fold(0.0_f64, |a, x| a.max((x - first).abs()));
    if runs.len() < 2 || runs.iter().any(|run| run.len() < 2) || scale == 0.0 {
        return None;
    }
    let scaled = |run: &&[f32]| {
        run.iter()
            .map(|&x| (f64::from(x) - first) / scale)
            .collect()
    };
    Some(diagnosis::r_hat(
        &runs.iter().map(scaled).collect::<Vec<_>>(),
    ))
}

fn moments(run: &[f32]) -> Moments {
    let mut moments = Moments::new();
    run.iter().for_each(|&x| moments.push(x));
    moments
}

fn halves(run: &[f32], half: usize) -> Halves {
    let mut halves = Halves::new(half as u64);
    run.iter().for_each(|&x| halves.push(x));
    halves
}

/// R̂ of runs and its relative error; split, too, where that is asked for.
fn error(runs: &[Vec<f32>], split: bool) -> (f64, f64) {
    let (got, exact) = if split {
        let half = runs[0].len() / 2;
        let all: Vec<Halves> = runs.iter().map(|run| halves(run, half)).collect();
        let parts = runs.iter().flat_map(|run| [&run[..half], &run[half..]]);
        (split_r_hat(&all), exact(&parts.collect::<Vec<_>>()))
    } else {
        let all: Vec<Moments> = runs.iter().map(|run| moments(run)).collect();
        let parts: Vec<&[f32]> = runs.iter().map(Vec::as_slice).collect();
        (r_hat(all.iter()), exact(&parts))
    };
    let (got, exact) = (f64::from(got.unwrap()), exact.unwrap());
    assert!(got.is_finite() && got >= 0.0);
    // Beyond f32 it is the largest there is.
    let error = (got - exact.min(f64::from(f32::MAX))).abs() / exact;
    assert!(!error.is_nan(), "{got} for {exact}");
    (error, exact)
}

/// Runs of some shapes: so many deviations from 0, on a scale, and apart by some deviations.
fn runs(turn: usize, mean: f64, scale: f64, rng: &mut Pcg32) -> Vec<Vec<f32>> {
    let apart = [0.0, 0.01, 1.0, 30.0][turn % 4];
    (0..2 + turn % 3)
        .map(|_| {
            let shift = apart * normal(rng);
            let n = [4, 30, 500, 5000][turn / 4 % 4];
            let numbers = shaped(turn % SHAPES, n, rng);
            let place = |x: &f64| ((x + shift + mean) * scale) as f32;
            let place = |x: &f64| place(x).clamp(f32::MIN, f32::MAX);
            numbers.iter().map(place).collect()
        })
        .collect()
}

fn largest_error(mean: f64, scales: &[f64]) -> f64 {
    let mut rng = Pcg32::new(0x4a7, 54);
    let mut worst = 0.0_f64;
    for &scale in scales {
        for turn in 0..150 {
            let runs = runs(turn, mean, scale, &mut rng);
            worst = worst.max(error(&runs, turn % 2 == 0).0);
        }
    }
    worst
}

#[test]
fn r_hat_has_the_stated_error() {
    let mut worst = 0.0_f64;
    for mean in [0.0, 1.0, 100.0, 1e4, 1e6] {
        // Up to the end of f32, where the runs that are apart are clamped.
        let scales = [1.0, 1e-30, 1e30, 3e38 / (40.0 + mean)];
        let at = largest_error(mean, &scales);
        println!("mean of {mean:e} deviations: {at:.2e}");
        worst = worst.max(at);
    }
    let subnormal = largest_error(0.0, &[1e-38, 1e-40, 1e-42, 3e-44]);
    println!("subnormal deviations: {subnormal:.2e}");
    worst = worst.max(subnormal);
    let figure = Doc::of("metropolis", "r_hat").figure("mean up to 10⁶ deviations, relative", 0);
    assert_stated("r_hat", worst, figure);
    // What takes the means in f32 does not keep it.
    let mut rng = Pcg32::new(0x4a8, 54);
    let far: Vec<Vec<f32>> = runs(12, 1e6, 1.0, &mut rng);
    let mut means = Moments::new();
    let mut within = 0.0;
    for run in &far {
        means.push(moments(run).mean().unwrap());
        within += moments(run).variance().unwrap() / far.len() as f32;
    }
    let n = far[0].len() as f64;
    let naive = (n - 1.0) / n + f64::from(means.variance().unwrap() / within);
    let (_, exact) = error(&far, false);
    assert!(
        (naive.sqrt() / exact - 1.0).abs() > figure,
        "{naive} {exact}"
    );
}

/// Runs of magnitudes and spreads so far apart that R̂ is far out of the usual.
#[test]
fn r_hat_of_far_magnitudes_is_right_too() {
    let figure = Doc::of("metropolis", "r_hat").figure("mean up to 10⁶ deviations, relative", 0);
    let tiny = f32::from_bits(1);
    let cases = [
        vec![vec![1.0, 1.0, 1.0], vec![1e-30, 2e-30, 4e-30]],
        vec![
            vec![f32::MAX, f32::MIN, f32::MAX],
            vec![f32::MIN, f32::MAX, f32::MIN],
        ],
        vec![
            vec![f32::MAX, f32::MAX.next_down()],
            vec![f32::MIN, f32::MIN],
        ],
        vec![vec![tiny, 0.0, tiny], vec![0.0, tiny, 0.0, 0.0]],
        vec![vec![tiny, 0.0], vec![1e-20, 1e-20], vec![-1e-12, -1e-12]],
        vec![vec![1e38, -1e38], vec![tiny, 2.0 * tiny], vec![1.0, 2.0]],
        vec![vec![1e38; 5], vec![1e10, 1e-10, 0.0]],
        vec![vec![1e38; 5], vec![tiny, tiny, 0.0]],
    ];
    for case in cases {
        let (error, exact) = error(&case, false);
        println!("{exact:e}: {error:.1e}");
        assert!(
            error <= figure || exact > f64::from(f32::MAX),
            "{case:?}: {error:e}"
        );
    }
    // No number differs within a run, but from run to run.
    let constant = [moments(&[1.0; 4]), moments(&[1.0_f32.next_up(); 4])];
    assert_eq!(r_hat(constant.iter()), Some(f32::MAX));
    // Results are numbers in range whatever is pushed.
    let mut rng = Pcg32::new(0x4a9, 54);
    for turn in 0..speed::of("runs", 10_000, 100_000) {
        let mut all = [Halves::new(3), Halves::new(1 + turn % 4)];
        for _ in 0..2 + turn % 17 {
            for run in &mut all {
                run.push(f32::from_bits(rng.next_u32()));
            }
        }
        if let Some(r) = split_r_hat(&all) {
            assert!((0.0..=f32::MAX).contains(&r), "{all:?}: {r}");
        }
    }
}

#[test]
fn too_few_numbers_give_none() {
    let (some, one, none) = (moments(&[1.0, 2.0, 4.0]), moments(&[1.0]), Moments::new());
    assert_eq!(r_hat([].iter()), None);
    assert_eq!(r_hat([some].iter()), None);
    assert_eq!(r_hat([some, one].iter()), None);
    assert_eq!(r_hat([none, some].iter()), None);
    assert_eq!(r_hat([some, some, none].iter()), None);
    for x in [0.0, -0.0, 3.3, 1e-45, f32::MAX] {
        assert_eq!(r_hat([moments(&[x; 5]); 3].iter()), None, "{x:e}");
    }
    assert!(r_hat([some, some].iter()).is_some());
    assert_eq!(split_r_hat(&[]), None);
    // A first half without end, and one of nothing.
    let run = [1.0, 2.0, 0.0, 1.0];
    assert_eq!(split_r_hat(&[halves(&run, 9)]), None);
    assert_eq!(split_r_hat(&[halves(&run, 0)]), None);
    assert_eq!(split_r_hat(&[halves(&run, 3)]), None);
    assert!(split_r_hat(&[halves(&run, 2)]).is_some());
    // What is no number is counted where it would have gone, and leaves no trace.
    let mut with = Halves::new(2);
    for x in [
        f32::NAN,
        1.0,
        f32::INFINITY,
        2.0,
        f32::NEG_INFINITY,
        0.0,
        1.0,
    ] {
        with.push(x);
    }
    let [first, second] = with.parts();
    assert_eq!((first.count(), first.refused()), (2, 2));
    assert_eq!((second.count(), second.refused()), (2, 1));
    assert_eq!(split_r_hat(&[with]), split_r_hat(&[halves(&run, 2)]));
}
