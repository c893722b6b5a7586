//! What `Draws` sees and split R̂ does not, and whether the error of a mean that is stated is the one that is made.

use crate::draws::figures;
use crate::series::{autoregression, unit};
use host::speed;
use microwarp::estimate::Moments;
use microwarp::metropolis::{Autocorrelation, Halves, split_r_hat};
use rand_pcg::Pcg32;

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
