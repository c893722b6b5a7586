//! Metropolis light transport against plain paths, on the scenes that paths find hard: at equal numbers of paths, and at equal
//! time.

use crate::args::Args;
use crate::render::{Pixels, Plan, PointSet, Tier};
use crate::shots::Shot;
use crate::study::error;
use indicatif::ProgressBar;
use microwarp_scene::Walk;
use std::time::Instant;

/// The scenes, by the names of their files, and samples a pixel of their references: about as long for both. A path that finds
/// the caustic is rare, so its reference needs more.
const HARD: [(&str, u32); 2] = [("slit", 2048), ("caustic", 16_384)];

/// Samples of the reference of a scene; none where paths are good enough.
pub fn reference_of(name: &str) -> Option<u32> {
    let found = HARD.iter().find(|(hard, _)| *hard == name)?;
    Some(found.1)
}

/// A chain gains by neighbours, so its pictures are larger than those of the other study.
const SIZE: [u32; 2] = [72, 48];
const PIXELS: u32 = SIZE[0] * SIZE[1];

/// Random paths a pixel.
const SAMPLES: u32 = 16;

/// Pictures of each kind.
const SEEDS: u32 = 7;

/// Pictures of one kind: their errors in order, and the time of a path in microseconds.
pub struct Kind {
    pub errors: Vec<f64>,
    pub cost: f64,
    pub invalid: usize,
}

impl Kind {
    pub fn median(&self) -> f64 {
        self.errors[self.errors.len() / 2]
    }
}

pub struct Comparison {
    pub title: &'static str,
    pub plain: Kind,
    pub same_paths: Kind,
    pub same_time: Kind,
}

/// Paths of both comparisons.
pub fn steps() -> u64 {
    let samples = HARD.map(|(_, reference)| u64::from(reference + 3 * SEEDS * SAMPLES));
    u64::from(PIXELS) * samples.iter().sum::<u64>()
}

/// One picture of plain paths, on this thread.
fn plain(shot: &Shot, points: PointSet, samples: u32, seed: u32) -> Pixels {
    let plan = Plan {
        tier: Tier::Poly,
        points,
        size: SIZE,
        samples,
        seed,
    };
    (0..SIZE[1])
        .flat_map(|row| shot.scene.row(&plan, row))
        .collect()
}

/// One picture of a chain: an eighth of its paths are candidates for the start.
fn chain(shot: &Shot, paths: u32, seed: u32) -> Pixels {
    let (guesses, candidates) = (paths / 32, paths / 8);
    shot.scene.chain(&Walk {
        size: SIZE,
        guesses,
        candidates,
        steps: paths - guesses - candidates,
        seed,
    })
}

/// Pictures of all seeds. The time is that of the fastest: others have waited for other programs.
fn kind(seed: u32, paths: u32, reference: &Pixels, picture: impl Fn(u32) -> Pixels + Sync) -> Kind {
    let seeds: Vec<u32> = (0..SEEDS).map(|k| seed.wrapping_add(k)).collect();
    let job = |seed: &u32| {
        let start = Instant::now();
        let pixels = picture(*seed);
        let time = start.elapsed().as_secs_f64();
        (
            error(&pixels, reference),
            time,
            crate::study::invalid(&pixels),
        )
    };
    let found = host::parallel::in_parallel(host::parallel::threads(), &seeds, job);
    let mut errors: Vec<f64> = found.iter().map(|f| f.0).collect();
    errors.sort_by(f64::total_cmp);
    let time = found.iter().map(|f| f.1).fold(f64::INFINITY, f64::min);
    Kind {
        errors,
        cost: 1e6 * time / f64::from(paths),
        invalid: found.iter().map(|f| f.2).sum(),
    }
}

fn compare(shot: &Shot, samples: u32, args: &Args, progress: &ProgressBar) -> Comparison {
    let seeds: Vec<u32> = (0..8).collect();
    // The mean of eight, each on a thread.
    let part = |k: &u32| {
        plain(
            shot,
            PointSet::Sobol,
            samples / 8,
            args.seed ^ 0x5ce7e ^ k << 24,
        )
    };
    let parts = host::parallel::in_parallel(host::parallel::threads(), &seeds, part);
    let mean = |i: usize| std::array::from_fn(|k| parts.iter().map(|p| p[i][k]).sum::<f64>() / 8.0);
    let reference: Pixels = (0..PIXELS as usize).map(mean).collect();
    let paths = PIXELS * SAMPLES;
    progress.inc(u64::from(PIXELS) * u64::from(samples));
    let done = |kind: Kind| {
        progress.inc(u64::from(paths) * u64::from(SEEDS));
        kind
    };
    let random = |seed| plain(shot, PointSet::Random, SAMPLES, seed);
    let plain = done(kind(args.seed, paths, &reference, random));
    let by_chain = |paths| {
        let picture = |seed| chain(shot, paths, seed);
        done(kind(args.seed, paths, &reference, picture))
    };
    let same_paths = by_chain(paths);
    let fewer = (f64::from(paths) * plain.cost / same_paths.cost) as u32;
    Comparison {
        title: shot.title,
        same_time: by_chain(fewer),
        same_paths,
        plain,
    }
}

pub fn all(shots: &[Shot], args: &Args, progress: &ProgressBar) -> Vec<Comparison> {
    let compared = |shot: &Shot| Some(compare(shot, reference_of(shot.name)?, args, progress));
    shots.iter().filter_map(compared).collect()
}

pub fn print(comparisons: &[Comparison]) {
    let row = |c: &Comparison| {
        let beside = |kind: &Kind| {
            let change = 100.0 * (kind.median() / c.plain.median() - 1.0);
            format!("{:.0} % ({change:+.0} %)", 100.0 * kind.median())
        };
        vec![
            c.title.to_owned(),
            format!("{:.0} %", 100.0 * c.plain.median()),
            beside(&c.same_paths),
            beside(&c.same_time),
            format!("{:.1} µs", c.plain.cost),
            format!("{:.1} µs", c.same_paths.cost),
        ]
    };
    let header = [
        "scene",
        "plain",
        "chain, equal paths",
        "chain, equal time",
        "a plain path",
        "a chain's",
    ];
    println!(
        "Metropolis light transport: the median error of {SEEDS} pictures of {} × {} pixels, {SAMPLES} paths each:",
        SIZE[0], SIZE[1]
    );
    host::cli::print(&header, comparisons.iter().map(row).collect(), 1);
    println!();
}

/// How much less the error of a chain is at equal numbers of paths, at least. Times are told, not judged: they are another
/// program's as well.
const GAIN: f64 = 0.3;

/// What there is to complain of.
pub fn complaints(comparisons: &[Comparison]) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut hold = |good: bool, text: String| complaints.extend((!good).then_some(text));
    for c in comparisons {
        let invalid = c.plain.invalid + c.same_paths.invalid + c.same_time.invalid;
        let less = 1.0 - c.same_paths.median() / c.plain.median();
        hold(
            invalid == 0,
            format!("{}: {invalid} numbers are no light", c.title),
        );
        hold(
            less >= GAIN,
            format!("{}: chains have {:.0} % less error", c.title, 100.0 * less),
        );
    }
    complaints
}
