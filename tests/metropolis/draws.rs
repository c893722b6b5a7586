//! `Draws` against arviz, and against the definitions in f64 over runs of any kind.

use crate::diagnosis::{Figures, exact, reference};
use crate::exact::assert_stated;
use crate::series::{SHAPES, shaped};
use host::docs::Doc;
use host::errors::or_infinite;
use host::speed;
use microwarp::Error;
use microwarp::metropolis::Draws;
use rand_core::Rng;
use rand_pcg::Pcg32;

/// All figures; NaN where there is none.
pub fn figures(runs: &[Vec<f32>]) -> Figures {
    let mut scratch = vec![f32::NAN; 2 * runs.len() * runs[0].len()];
    let mut draws = Draws::new(runs, &mut scratch).unwrap();
    let hats = [draws.split_r_hat(), draws.r_hat(), draws.folded_r_hat()];
    assert!(hats.iter().flatten().all(|r| !r.is_nan()));
    let [split, rank, folded] = hats.map(|r| r.map_or(f64::NAN, f64::from));
    let sizes = [
        draws.effective_sample_size(),
        draws.bulk_effective_sample_size(),
        draws.tail_effective_sample_size(),
        draws.standard_error(),
    ];
    let [mean, bulk, tail, error] = sizes.map(f64::from);
    [split, rank, folded, mean, bulk, tail, error]
}

/// The largest relative errors of R̂ and of sizes and the error of the mean.
fn errors(got: &Figures, truth: &Figures) -> [f64; 2] {
    let error = |i: usize| {
        let same = got[i] == truth[i];
        if same {
            0.0
        } else {
            or_infinite((got[i] / truth[i] - 1.0).abs())
        }
    };
    let worst = |range: std::ops::Range<usize>| range.map(error).fold(0.0, f64::max);
    assert!(got.iter().all(|x| x.is_finite()), "{got:?}");
    [worst(0..3), worst(3..7)]
}

#[test]
fn figures_are_those_of_arviz() {
    let doc = Doc::of("metropolis", "Draws");
    let stated = ["R̂, relative", "effective size, relative"].map(|row| doc.figure(row, 0));
    let mut worst = [0.0_f64; 2];
    for (case, runs, arviz) in reference() {
        let got = figures(&runs);
        match case.as_str() {
            "constant" => {
                assert!(got[..3].iter().chain(&arviz[..3]).all(|r| r.is_nan()));
                assert_eq!(got[3..], arviz[3..]);
                continue;
            }
            "stuck" => {
                assert_eq!(got[..3], [f64::from(f32::MAX); 3]);
                assert!(arviz[..3].iter().all(|r| r.is_infinite()));
            }
            _ => {}
        }
        // Of one chain arviz has no R̂, and of stuck ones an infinite one.
        let known = |i: usize| {
            if arviz[i].is_finite() {
                arviz[i]
            } else {
                got[i]
            }
        };
        let errors = errors(&got, &std::array::from_fn(known));
        println!("{case}: {:.1e} {:.1e} {got:.4?}", errors[0], errors[1]);
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error);
        }
    }
    println!("R̂ {:.2e}, sizes {:.2e}", worst[0], worst[1]);
    assert!(worst[0] <= stated[0] && worst[1] <= stated[1], "{worst:?}");
}

/// The definitions in f64 are those of arviz too, so they can stand for it where no reference was recorded.
#[test]
fn the_definitions_are_those_of_arviz() {
    for (case, runs, arviz) in reference() {
        let (exact, _) = exact(&runs);
        for (ours, theirs) in exact.iter().zip(arviz) {
            let same = (ours / theirs - 1.0).abs() < 1e-9 || *ours == theirs;
            assert!(same || !theirs.is_finite(), "{case}: {exact:?} {arviz:?}");
        }
    }
}

#[test]
fn figures_are_those_of_the_definitions() {
    let doc = Doc::of("metropolis", "Draws");
    let mut rng = Pcg32::new(0xd4a5, 54);
    let (mut worst, mut near) = ([0.0_f64; 2], 0);
    let turns = speed::of("kinds of draws", 300, 10_000);
    for turn in 0..turns {
        let chains = 1 + turn % 5;
        let n = [4, 5, 6, 7, 9, 20, 64, 101, 300][turn / 5 % 9];
        let (mean, scale) = (
            [0.0, 3.0, 100.0][turn % 3],
            2f64.powi((turn % 7) as i32 * 20 - 60),
        );
        let mut run = |chain: usize| -> Vec<f32> {
            let apart = if turn % 4 == 0 { chain as f64 } else { 0.0 };
            let digits = if turn % 6 == 0 { 4.0 } else { 1e9 };
            let run = shaped(turn % SHAPES, n, &mut rng);
            let wide = run
                .iter()
                .map(|x| (x * digits).round() / digits + mean + apart);
            let mut run: Vec<f32> = wide.map(|x| (x * scale) as f32).collect();
            // Some runs have a draw beside which the others are tiny.
            if turn % 11 == 0 {
                run[n / 2] = [1e38, -1e30, 1e20][turn % 3];
            }
            run
        };
        let runs: Vec<_> = (0..chains).map(&mut run).collect();
        let (truth, nearest) = exact(&runs);
        if nearest < 1e-5 || truth.iter().any(|x| !x.is_finite()) {
            near += 1;
            figures(&runs);
            continue;
        }
        let got = figures(&runs);
        let errors = errors(&got, &truth);
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error);
        }
    }
    println!(
        "{turns} kinds, {near} on an edge: R̂ {:.2e}, sizes {:.2e}",
        worst[0], worst[1]
    );
    assert!(near * 2 < turns);
    let [hat, size] = ["R̂, relative", "effective size, relative"].map(|row| doc.figure(row, 0));
    assert!(worst[0] <= hat && worst[1] <= size, "{worst:?}");
    if speed::full() {
        assert_stated("R̂", worst[0], hat);
        assert_stated("sizes", worst[1], size);
    }
}

#[test]
fn bad_draws_are_refused() {
    let (good, mut scratch) = ([[1.0, 2.0, 3.0, 4.0_f32]; 2], [0.0; 16]);
    assert!(Draws::new(&good, &mut scratch).is_ok());
    assert_eq!(
        Draws::new(&good, &mut scratch[..15]),
        Err(Error::OutOfRange(1))
    );
    assert_eq!(
        Draws::new(&[[0.0; 3]; 4], &mut scratch),
        Err(Error::OutOfRange(0))
    );
    assert_eq!(
        Draws::new(&[[0.0; 0]; 4], &mut scratch),
        Err(Error::OutOfRange(0))
    );
    assert_eq!(
        Draws::new(&[[0.0; 4]; 0], &mut scratch),
        Err(Error::OutOfRange(0))
    );
    let unequal: [&[f32]; 2] = [&[1.0, 2.0, 3.0, 4.0], &[1.0, 2.0, 3.0, 4.0, 5.0]];
    assert_eq!(
        Draws::new(&unequal, &mut [0.0; 99]),
        Err(Error::OutOfRange(0))
    );
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let mut draws = good;
        draws[1][2] = bad;
        assert_eq!(Draws::new(&draws, &mut scratch), Err(Error::NotFinite(0)));
        assert_eq!(scratch, [0.0; 16]);
    }
}

/// Whatever finite numbers there are, results are numbers in range, and a power of two changes only the error of the mean.
#[test]
fn figures_of_any_draws_are_in_range() {
    let mut rng = Pcg32::new(0xa11, 54);
    let tiny = f32::from_bits(1);
    for turn in 0..speed::of("draws", 2000, 100_000) {
        let n = 4 + turn % 9;
        let mut any = || match turn % 3 {
            0 => f32::from_bits(rng.next_u32()),
            1 => [f32::MAX, f32::MIN, tiny, -tiny, 0.0, -0.0][rng.next_u32() as usize % 6],
            _ => (rng.next_u32() % 3) as f32,
        };
        let run = |any: &mut dyn FnMut() -> f32| (0..n).map(|_| any()).collect::<Vec<f32>>();
        let mut runs = vec![run(&mut any), run(&mut any)];
        for x in runs.iter_mut().flatten().filter(|x| !x.is_finite()) {
            *x = 1.0;
        }
        let got = figures(&runs);
        let count = 2.0 * n as f64;
        assert!(
            got[..3]
                .iter()
                .all(|r| r.is_nan() || (0.0..=f64::from(f32::MAX)).contains(r)),
            "{runs:?} {got:?}"
        );
        assert!(
            got[3..6]
                .iter()
                .all(|size| *size > 0.0 && *size <= count * count.log10() * 1.001),
            "{runs:?} {got:?}"
        );
        assert!(
            (0.0..=f64::from(f32::MAX)).contains(&got[6]),
            "{runs:?} {got:?}"
        );
        if turn % 3 == 2 {
            let twice: Vec<Vec<f32>> = runs
                .iter()
                .map(|run| run.iter().map(|x| 2f32.powi(90) * x).collect())
                .collect();
            assert_eq!(
                figures(&twice).map(f64::to_bits)[..6],
                got.map(f64::to_bits)[..6]
            );
        }
    }
}
