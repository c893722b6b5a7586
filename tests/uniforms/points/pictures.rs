//! Errors of pictures whose pixels share a set: of single pixels, of means over neighbours, and by frequency.

use host::docs::Doc;
use host::mean::over_neighbours;
use host::parallel::{in_parallel, threads};
use host::speed;
use microwarp::uniform::{ByPosition, Points, Screen, Sobol};
use std::f64::consts::FRAC_PI_4;

/// A function of a point and of a place in the picture, and its mean over the points.
struct Integrand {
    name: &'static str,
    value: fn([f64; 2], [f64; 2]) -> f64,
    exact: fn([f64; 2]) -> f64,
}

fn radius([x, y]: [f64; 2]) -> f64 {
    0.6 + 0.15 * (x + y)
}

/// The normal of a line and its distance from the origin.
fn line([x, y]: [f64; 2]) -> ([f64; 2], f64) {
    let (sin, cos) = (0.3 + x).sin_cos();
    ([cos, sin], (0.2 + 0.6 * y) * (sin + cos))
}

const INTEGRANDS: [Integrand; 3] = [
    Integrand {
        name: "e^(ax + by)",
        value: |[u, v], [x, y]| ((1.0 + x) * u + (1.0 + y) * v).exp(),
        exact: |at| at.map(|c| (1.0 + c).exp_m1() / (1.0 + c)).iter().product(),
    },
    Integrand {
        name: "a part of a disk",
        value: |[u, v], at| f64::from(u8::from(u.hypot(v) < radius(at))),
        exact: |at| FRAC_PI_4 * radius(at).powi(2),
    },
    Integrand {
        name: "a half-plane",
        value: |[u, v], at| {
            let ([a, b], distance) = line(at);
            f64::from(u8::from(a * u + b * v < distance))
        },
        // A triangle, less those beyond the square.
        exact: |at| {
            let ([a, b], distance) = line(at);
            let square = |rest: f64| rest.max(0.0).powi(2);
            let beyond = square(distance - a) + square(distance - b) - square(distance - a - b);
            (square(distance) - beyond) / (2.0 * a * b)
        },
    },
];

/// The words of a sample of a pixel: by the logarithm of the side of the picture and of the number of samples, and a seed.
type Way = fn([u32; 2], u32, [u32; 2], u32) -> [u32; 2];

fn own([_, _]: [u32; 2], seed: u32, [x, y]: [u32; 2], sample: u32) -> [u32; 2] {
    let seeds = ByPosition::new(seed, y << 16 | x);
    Sobol::<2>::new(seeds.word(0, 0)).unwrap().words(sample)
}

fn other_own(logs: [u32; 2], seed: u32, at: [u32; 2], sample: u32) -> [u32; 2] {
    own(logs, seed ^ 1 << 20, at, sample)
}

fn screen([side, samples]: [u32; 2], seed: u32, [x, y]: [u32; 2], sample: u32) -> [u32; 2] {
    let set = Sobol::new(seed).unwrap();
    let screen: Screen<Sobol<2>> = Screen::new(set, [1 << side; 2], samples, seed).unwrap();
    screen.pixel(x, y).words(sample)
}

/// The sample before the place: a pixel's samples are far from each other along the curve, and uneven.
fn sample_leads([side, _]: [u32; 2], seed: u32, [x, y]: [u32; 2], sample: u32) -> [u32; 2] {
    let corner = [x | (sample & 3) << side, y | (sample >> 2) << side];
    screen([side + 2, 0], seed, corner, 0)
}

/// The first of four times as many samples.
fn part([side, samples]: [u32; 2], seed: u32, at: [u32; 2], sample: u32) -> [u32; 2] {
    screen([side, samples + 2], seed, at, sample)
}

/// The errors of a picture.
fn errors(way: Way, of: &Integrand, logs: [u32; 2], seed: u32) -> Vec<f64> {
    let [side, samples] = logs;
    let middle = |word: u32| (f64::from(word) + 0.5) / 2f64.powi(32);
    let pixels = (0..1 << side).flat_map(|y| (0..1 << side).map(move |x| [x, y]));
    let error = |at: [u32; 2]| {
        let place = at.map(|c| f64::from(c) / f64::from(1_u32 << side));
        let value = |s| (of.value)(way(logs, seed, at, s).map(middle), place);
        let sum: f64 = (0..1 << samples).map(value).sum();
        sum / f64::from(1_u32 << samples) - (of.exact)(place)
    };
    pixels.map(error).collect()
}

/// The sums of the squares of errors, and of their means over 3 × 3 neighbours within the picture.
fn squares(errors: &[f64], side: usize) -> [f64; 2] {
    let sum = |errors: &[f64]| errors.iter().map(|e| e * e).sum();
    [sum(errors), sum(&over_neighbours(errors, side))]
}

/// By what factors errors are below those of another way: of single pixels, and of means over neighbours.
fn factors([way, beside]: [Way; 2], of: &Integrand, logs: [u32; 2], seeds: u32) -> [f64; 2] {
    let seeds: Vec<u32> = (0..seeds).collect();
    let sums = in_parallel(threads(), &seeds, |seed| {
        [way, beside].map(|way| squares(&errors(way, of, logs, *seed), 1 << logs[0]))
    });
    let sum = |way: usize, k: usize| sums.iter().map(|both| both[way][k]).sum::<f64>();
    [0, 1].map(|k| (sum(1, k) / sum(0, k)).sqrt())
}

#[test]
fn errors_of_neighbours_cancel_and_those_of_pixels_stay() {
    let page = Doc::find("uniform", "Screen").unwrap();
    let (side, seeds) = speed::of(
        "side, its logarithm, and seeds of pictures",
        (5, 12),
        (7, 24),
    );
    // What the promise says, and what noise leaves of it.
    let (least, raw) = speed::of(
        "least gain and change of a pixel",
        (1.18, 0.15),
        (1.25, 0.06),
    );
    for (of, (column, samples)) in INTEGRANDS
        .iter()
        .flat_map(|of| [(0, 0), (1, 2), (2, 4)].map(|k| (of, k)))
    {
        let logs = [side, samples];
        let found = |way| factors([way, own], of, logs, seeds);
        let holds = |[pixel, mean]: [f64; 2]| (pixel - 1.0).abs() <= raw && mean >= least;
        let (ours, stated) = (found(screen), page.figure(of.name, column));
        println!(
            "{}, {} samples: {ours:.3?}, stated {stated}",
            of.name,
            1 << samples
        );
        assert!(holds(ours), "{}: {ours:?}", of.name);
        assert!((ours[1] / stated - 1.0).abs() <= speed::of("noise of gains", 0.1, 0.02));
        let again = found(other_own);
        assert!(!holds(again) && again[1] < 1.08, "a set a pixel: {again:?}");
        if samples > 0 {
            let wrong = found(sample_leads);
            println!("  control, the sample before the place: {wrong:.2?}");
            assert!(!holds(wrong) && wrong[0] < 0.75, "{wrong:?}");
        }
        let few = found(part);
        println!("  control, the first of four times as many samples: {few:.2?}");
        assert!(!holds(few) && few[1] < 1.12, "{few:?}");
    }
}

/// The power of errors by frequency, in rings of cycles a pixel below 1/16, 1/8, 1/4, 1/2, and in the corners.
fn rings(errors: &[f64], side: usize) -> [f64; 5] {
    let turn = |k: usize| (std::f64::consts::TAU * (k % side) as f64 / side as f64).sin_cos();
    // Rows, then columns of what comes of them.
    let transformed = |lines: &[Vec<[f64; 2]>]| -> Vec<Vec<[f64; 2]>> {
        (0..side)
            .map(|k| {
                let of = |line: &Vec<[f64; 2]>| {
                    line.iter()
                        .enumerate()
                        .fold([0.0; 2], |[re, im], (i, [a, b])| {
                            let (sin, cos) = turn(i * k);
                            [re + a * cos + b * sin, im + b * cos - a * sin]
                        })
                };
                lines.iter().map(of).collect()
            })
            .collect()
    };
    let rows: Vec<Vec<[f64; 2]>> = errors
        .chunks(side)
        .map(|row| row.iter().map(|e| [*e, 0.0]).collect())
        .collect();
    let mut sums = [[0.0; 2]; 5];
    for (i, line) in transformed(&transformed(&rows)).iter().enumerate() {
        for (j, [re, im]) in line.iter().enumerate() {
            let cycles = |k: usize| k.min(side - k) as f64 / side as f64;
            let frequency = cycles(i).hypot(cycles(j));
            let ring = [1.0 / 16.0, 0.125, 0.25, 0.5]
                .iter()
                .filter(|end| frequency >= **end)
                .count();
            sums[ring][0] += re * re + im * im;
            sums[ring][1] += 1.0;
        }
    }
    sums.map(|[sum, count]| sum / count)
}

/// Errors move to high frequencies, where an eye or a filter does not see them.
#[test]
fn errors_are_blue() {
    let (side, seeds) = speed::of("side, its logarithm, and seeds of spectra", (5, 6), (6, 24));
    for of in &INTEGRANDS[1..] {
        let power = |way| {
            (0..seeds).fold([0.0; 5], |all: [f64; 5], seed| {
                let ring = rings(&errors(way, of, [side, 2], seed), 1 << side);
                std::array::from_fn(|k| all[k] + ring[k])
            })
        };
        let (beside, blue) = (power(own), power(screen));
        let shares: [f64; 5] = std::array::from_fn(|k| blue[k] / beside[k]);
        println!(
            "{}, 4 samples, power from low frequencies to high: {shares:.2?}",
            of.name
        );
        let rises = |[lowest, low, middle, _, corners]: [f64; 5]| {
            lowest < 0.45 && low < 0.45 && middle < 0.8 && corners > 1.1
        };
        assert!(rises(shares), "{shares:?}");
        let few = power(part);
        let control: [f64; 5] = std::array::from_fn(|k| few[k] / beside[k]);
        assert!(!rises(control), "{control:?}");
    }
}

/// Samples behind the last are those of another set: independent of the first, and as even.
#[test]
fn further_samples_are_those_of_independent_sets() {
    let seeds = speed::of("seeds of pixels of two sets", 4_000, 100_000);
    let of = &INTEGRANDS[1];
    let place = [0.3, 0.4];
    let middle = |word: u32| (f64::from(word) + 0.5) / 2f64.powi(32);
    // The root of the mean square error of a pixel, over the seeds, of samples by their number.
    let rms = |sample: fn(u32) -> u32, count: u32| {
        let off = |seed: u32| {
            let set = Sobol::<2>::new(seed).unwrap();
            let pixel = Screen::new(set, [16; 2], 3, seed).unwrap().pixel(5, 9);
            let value = |s| (of.value)(pixel.words(sample(s)).map(middle), place);
            (0..count).map(value).sum::<f64>() / f64::from(count) - (of.exact)(place)
        };
        ((0..seeds).map(|seed| off(seed).powi(2)).sum::<f64>() / f64::from(seeds)).sqrt()
    };
    let [first, second, far] = [rms(|s| s, 8), rms(|s| s + 8, 8), rms(|s| s + (77 << 3), 8)];
    println!("errors of sets: {first:.4}, {second:.4}, {far:.4}");
    for other in [second, far] {
        assert!((other / first - 1.0).abs() <= 0.06);
    }
    // Of independent ones the errors of two are smaller by the root of two; of the same one twice they are not.
    let independent = |both: f64| (first / both / 2f64.sqrt() - 1.0).abs() <= 0.06;
    let [both, twice] = [rms(|s| s, 16), rms(|s| s & 7, 16)];
    println!("of two: {both:.4}; control, of one twice: {twice:.4}");
    assert!(independent(both) && !independent(twice));
}
