//! What is measured of one scene.

use crate::args::Args;
use crate::render::{Pixels, Plan, PointSet, Tier, picture};
use crate::shots::Shot;
use indicatif::ProgressBar;

/// The pictures whose errors are measured are small.
pub const SMALL: [u32; 2] = [36, 24];

/// Samples a pixel of these.
pub const SAMPLES: [u32; 2] = [16, 64];

/// What they are rendered by: every point set, and one of them in both tiers.
pub const KINDS: [(Tier, PointSet); 5] = [
    (Tier::Poly, PointSet::Random),
    (Tier::Poly, PointSet::ByPosition),
    (Tier::Poly, PointSet::Strata),
    (Tier::Poly, PointSet::Sobol),
    (Tier::Libm, PointSet::Sobol),
];

/// Small pictures of a kind, each from a seed of its own: a single path that finds much light spoils one of them.
const SEEDS: u32 = 5;

/// Small pictures of one kind, beside the reference.
pub struct Measured {
    pub tier: Tier,
    pub points: PointSet,
    pub samples: u32,
    /// The root of the mean square of relative errors: the median of the pictures.
    pub error: f64,
    /// How much brighter their mean is than the reference, over the whole picture, and in standard errors of that.
    pub excess: f64,
    pub deviation: f64,
    /// The mean of the pictures.
    pixels: Pixels,
}

pub struct Study {
    /// The picture that is shown.
    pub picture: Pixels,
    pub measured: Vec<Measured>,
    /// How far the mean pictures of both tiers are apart, which get the same points, as a part of the error that both have.
    pub apart: f64,
    /// A renderer that is wrong on purpose.
    pub control: Measured,
    /// Pixels of any of the pictures that are no light.
    pub invalid: usize,
}

fn work(size: [u32; 2], samples: u32) -> u64 {
    u64::from(size[0]) * u64::from(size[1]) * u64::from(samples)
}

/// Paths of one scene.
pub fn steps(args: &Args) -> u64 {
    let small: u64 = SAMPLES.iter().map(|&n| work(SMALL, n)).sum();
    work(args.size, args.samples)
        + work(SMALL, args.reference)
        + u64::from(SEEDS) * (KINDS.len() as u64 * small + work(SMALL, SAMPLES[1]))
}

/// The root of the mean square of errors, each relative to the light of its pixel and a little of that of the picture, so
/// that dark pixels do not outweigh all others.
pub fn error(pixels: &Pixels, reference: &Pixels) -> f64 {
    let all = || pixels.iter().flatten().zip(reference.iter().flatten());
    let count = all().count() as f64;
    let mut mean = [0.0; 3];
    for pixel in reference {
        (0..3).for_each(|k| mean[k] += 3.0 * pixel[k] / count);
    }
    let relative = |(k, (x, r)): (usize, (&f64, &f64))| ((x - r) / (r + 0.1 * mean[k % 3])).powi(2);
    (all().enumerate().map(relative).sum::<f64>() / count).sqrt()
}

fn mean(pictures: &[Pixels]) -> Pixels {
    let pixel = |i: usize| {
        let sum = |k: usize| pictures.iter().map(|picture| picture[i][k]).sum::<f64>();
        [0, 1, 2].map(|k| sum(k) / pictures.len() as f64)
    };
    (0..pictures[0].len()).map(pixel).collect()
}

fn total(pixels: &Pixels) -> f64 {
    pixels.iter().flatten().sum()
}

/// How many standard errors brighter a picture is than the reference: pixels have errors of their own, of mean 0.
fn deviation(pixels: &Pixels, reference: &Pixels) -> f64 {
    let light = |pixel: &[f64; 3]| pixel.iter().sum::<f64>();
    let off = pixels
        .iter()
        .zip(reference)
        .map(|(x, r)| light(x) - light(r));
    let (sum, squares) = off.fold((0.0, 0.0), |(sum, squares), d| (sum + d, squares + d * d));
    sum / squares.sqrt()
}

pub fn invalid(pixels: &Pixels) -> usize {
    let valid = |light: &&f64| **light >= 0.0 && light.is_finite();
    3 * pixels.len() - pixels.iter().flatten().filter(valid).count()
}

pub fn of(shot: &Shot, args: &Args, progress: &ProgressBar) -> Study {
    let render = |plan: Plan| {
        let row = work([plan.size[0], 1], plan.samples);
        picture(&*shot.scene, &plan, || progress.inc(row))
    };
    let picture = render(Plan {
        tier: Tier::Poly,
        points: args.points,
        size: args.size,
        samples: args.samples,
        seed: args.seed,
    });
    // The reference has points of its own.
    let reference = render(Plan {
        tier: Tier::Libm,
        points: PointSet::Sobol,
        size: SMALL,
        samples: args.reference,
        seed: args.seed ^ 0x5ce7e,
    });
    let measure = |tier, points, samples| {
        let plan = |k| Plan {
            tier,
            points,
            size: SMALL,
            samples,
            seed: args.seed.wrapping_add(k),
        };
        let pictures: Vec<Pixels> = (0..SEEDS).map(|k| render(plan(k))).collect();
        let mut errors: Vec<f64> = pictures.iter().map(|p| error(p, &reference)).collect();
        errors.sort_by(f64::total_cmp);
        let pixels = mean(&pictures);
        Measured {
            tier,
            points,
            samples,
            error: errors[errors.len() / 2],
            excess: total(&pixels) / total(&reference) - 1.0,
            deviation: deviation(&pixels, &reference),
            pixels,
        }
    };
    let mut measured = Vec::new();
    for (tier, points) in KINDS {
        measured.extend(SAMPLES.map(|samples| measure(tier, points, samples)));
    }
    let control = measure(Tier::Forgotten, PointSet::Random, SAMPLES[1]);
    let find = |tier| find(&measured, tier, PointSet::Sobol, SAMPLES[1]);
    let (poly, libm) = (find(Tier::Poly), find(Tier::Libm));
    let apart = error(&poly.pixels, &libm.pixels) / error(&libm.pixels, &reference);
    let pictures = [&picture, &reference].into_iter();
    let pictures = pictures.chain(measured.iter().map(|m| &m.pixels));
    let invalid = pictures.map(invalid).sum();
    Study {
        picture,
        measured,
        apart,
        control,
        invalid,
    }
}

impl Study {
    pub fn find(&self, tier: Tier, points: PointSet, samples: u32) -> &Measured {
        find(&self.measured, tier, points, samples)
    }
}

fn find(all: &[Measured], tier: Tier, points: PointSet, samples: u32) -> &Measured {
    let is = |m: &&Measured| (m.tier, m.points, m.samples) == (tier, points, samples);
    all.iter().find(is).expect("it is measured")
}
