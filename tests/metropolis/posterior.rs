//! A posterior of the field's own collection, by a tuned chain: eight schools (non-centred) of posteriordb at 28f8d3d, whose
//! reference is 10,000 nearly independent draws by Stan. The chain agrees within the errors of both; wrong priors do not.

use host::speed;
use microwarp::metropolis::{Chain, Draws, LogDensity, NormalStep, Tuning};
use microwarp::tier::{Poly, Tier as _};
use rand_pcg::Pcg32;

/// Effects of coaching in eight schools, and their standard errors.
const EFFECTS: [(f32, f32); 8] = [
    (28.0, 15.0),
    (8.0, 10.0),
    (-3.0, 16.0),
    (7.0, 11.0),
    (-1.0, 9.0),
    (1.0, 11.0),
    (18.0, 10.0),
    (12.0, 18.0),
];

/// The eight means, their mean and their deviation: of each its expectation, that of its square, and the errors of both.
const REFERENCE: [[f64; 4]; 10] = [
    [6.150_502_3, 69.363_45, 0.055_737_5, 1.169_210_2],
    [4.939_581_1, 45.978_7, 0.046_229_4, 0.634_649_4],
    [3.905_906_1, 43.139_23, 0.054_231_4, 0.653_941_8],
    [4.796_016_8, 45.761_35, 0.047_493_6, 0.619_368_9],
    [3.614_436_3, 34.357_67, 0.046_145_1, 0.455_048_9],
    [4.051_147_6, 39.413_5, 0.048_519_5, 0.539_021_3],
    [6.317_169_8, 64.932_69, 0.049_876_7, 0.921_613_2],
    [4.883_996_9, 52.128_45, 0.054_251_2, 0.902_474_8],
    [4.410_518_3, 30.403_02, 0.033_037_5, 0.335_135_6],
    [3.602_059_5, 23.204_07, 0.031_861_5, 0.484_887_2],
];

const CHAINS: usize = 4;

/// The eight means in units of their deviation about their mean; then these two, whose priors have these scales.
fn density(x: [f32; 10], scales: [f32; 2]) -> LogDensity<Poly> {
    let [.., mean, deviation] = x;
    if deviation <= 0.0 {
        return LogDensity::new(f32::NEG_INFINITY);
    }
    let mut squares = (mean / scales[0]).powi(2);
    for (unit, (effect, error)) in x.iter().zip(EFFECTS) {
        let residual = (effect - mean - deviation * unit) / error;
        squares += unit * unit + residual * residual;
    }
    let of_deviation = deviation / scales[1];
    LogDensity::new(-0.5 * squares - Poly::ln_1p(of_deviation * of_deviation))
}

/// By how many errors an expectation is off at most, how large an error is at most beside that of the reference, and the largest R̂:
/// of chains with priors of these scales, with so many draws each, one of so many states.
fn off(scales: [f32; 2], draws: usize, thinned: u32) -> [f64; 3] {
    let target = |x| density(x, scales);
    let run = |seed| -> Vec<[f32; 10]> {
        let mut rng = Pcg32::new(seed, 54);
        // From places that differ, by steps that are too long.
        let start = std::array::from_fn(|i| {
            if i < 9 {
                seed as f32 - 1.5
            } else {
                1.0 + seed as f32
            }
        });
        let step =
            NormalStep::<_, Poly>::new(std::array::from_fn(|i| if i < 8 { 3.0 } else { 10.0 }))
                .unwrap();
        let mut tuning = Tuning::new(Chain::new(start, target).unwrap(), step, 0.234).unwrap();
        for _ in 0..3000 {
            tuning.step(target, &mut rng);
        }
        let (mut chain, step) = tuning.freeze();
        let collect = |_| {
            for _ in 0..thinned {
                chain.step(target, &step, &mut rng);
            }
            chain.state()
        };
        let run = (0..draws).map(collect).collect();
        let rate = chain.acceptance_rate().unwrap();
        assert!((rate - 0.234).abs() < 0.08, "{rate}");
        run
    };
    let runs: [_; CHAINS] = std::array::from_fn(|seed| run(seed as u64));
    let mut scratch = vec![0.0; 2 * CHAINS * draws];
    let mut worst = [0.0_f64; 3];
    for (i, reference) in REFERENCE.iter().enumerate() {
        let number = |x: &[f32; 10]| if i < 8 { x[8] + x[9] * x[i] } else { x[i] };
        for power in 0..2 {
            let of = |x: &[f32; 10]| number(x).powi(1 + power as i32);
            let numbers: Vec<Vec<f32>> =
                (runs.iter().map(|run| run.iter().map(of).collect())).collect();
            let mut judged = Draws::new(&numbers, &mut scratch).unwrap();
            let error = f64::from(judged.standard_error());
            let hat = f64::from(judged.r_hat().unwrap());
            let mean = numbers.iter().flatten().map(|&x| f64::from(x)).sum::<f64>()
                / (CHAINS * draws) as f64;
            let [expected, known] = [reference[power], reference[2 + power]];
            let figures = [
                (mean - expected).abs() / error.hypot(known),
                error / known,
                hat,
            ];
            assert!(figures.iter().all(|x| x.is_finite()));
            for (worst, figure) in worst.iter_mut().zip(figures) {
                *worst = worst.max(figure);
            }
        }
    }
    println!(
        "priors of {scales:?}: off by {:.1} errors, of {:.1} those of the reference; R̂ {:.4}",
        worst[0], worst[1], worst[2]
    );
    worst
}

#[test]
fn eight_schools_are_those_of_posteriordb() {
    let (draws, thinned) = (
        speed::of("draws", 1000, 10_000),
        if speed::full() { 150 } else { 40 },
    );
    let [off_by, error, hat] = off([5.0, 5.0], draws, thinned);
    assert!(off_by <= 5.0 && hat < 1.05, "{off_by} {hat}");
    // At full length the chain knows as much as the reference.
    assert!(
        !speed::full() || (error <= 1.2 && hat < 1.01),
        "{error} {hat}"
    );
    // Priors of half the scale are noticed, each.
    for wrong in [[2.5, 5.0], [5.0, 2.5]] {
        let [off_by, _, hat] = off(wrong, draws, thinned);
        assert!(off_by > 7.0 && hat < 1.05, "{wrong:?}: {off_by}");
    }
}
