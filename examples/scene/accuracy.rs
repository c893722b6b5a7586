//! How much accuracy a scene needs: the bias of a kit against the twin in `f64`, and the noise that hides it.
//!
//! Kit and twin follow their paths from the same words, so that the noise of their difference is small. The difference is averaged
//! over blocks of pixels, in batches of samples, whose spread is the error of the bias.

use crate::args::Args;
use crate::chart;
use crate::render::{By, Pixels, Plan, PointSet, Tier};
use crate::shots::Shot;
use crate::study::SMALL;
use host::cli::print;
use host::parallel::{in_parallel, threads};
use std::error::Error;
use std::time::Instant;

/// What is measured, controls last.
pub const KITS: [By; 6] = [
    By::Libm,
    By::Poly,
    By::Fine,
    By::Coarse,
    By::Textbook,
    By::FourPercent,
];

/// Batches of samples, and columns and rows of a block of pixels.
const BATCHES: usize = 8;
const BLOCK: usize = 6;
const BLOCKS: usize = (SMALL[0] as usize / BLOCK) * (SMALL[1] as usize / BLOCK);

/// The part of the noise of a pixel at which a bias counts as seen.
const SEEN: f64 = 0.1;

/// Standard errors from which on a bias is measured rather than bounded: the chance is 3e-7.
const SURE: f64 = 5.0;

/// The samples a pixel by which the control must show, and before which none of the tiers may.
const SHOWS_BY: f64 = 1024.0;

/// The root of a mean square, or what it is below.
#[derive(Clone, Copy)]
pub struct Size {
    pub value: f64,
    pub measured: bool,
}

impl Size {
    /// Of a mean square without noise, and the standard error of that.
    fn of((square, error): (f64, f64)) -> Self {
        let measured = square > SURE * error;
        let most = if measured {
            square
        } else {
            square.max(0.0) + SURE * error
        };
        Self {
            value: most.sqrt(),
            measured,
        }
    }

    fn text(self, digits: impl Fn(f64) -> String) -> String {
        format!(
            "{}{}",
            if self.measured { "" } else { "< " },
            digits(self.value)
        )
    }
}

pub struct Found {
    pub by: By,
    /// The bias of a block, as a part of the light of the picture.
    pub bias: Size,
    /// The same in steps of 8 bits, developed.
    pub steps: Size,
    /// Nanoseconds of a path.
    pub ns: f64,
}

impl Found {
    /// The samples a pixel from which on the bias is a tenth of the noise, or more than which it takes.
    fn samples(&self, noise: f64) -> f64 {
        (SEEN * noise / self.bias.value).powi(2)
    }
}

pub struct Scene<'a> {
    pub shot: &'a Shot,
    /// That of a pixel of one sample, as a part of the light of the picture.
    pub noise: f64,
    pub kits: Vec<Found>,
}

/// The paths of a row by each kit and by the twin.
struct Row {
    twin: Pixels,
    kits: [Pixels; KITS.len()],
    /// Nanoseconds of a path, pixel by pixel.
    ns: [Vec<f64>; KITS.len()],
}

/// Both halves of the paths are timed, and the shorter time counts: another program may have run in between.
fn row(shot: &Shot, args: &Args, row: u32) -> Row {
    let plans = [0, 1].map(|half| Plan {
        tier: Tier::Poly,
        points: PointSet::ByPosition,
        size: SMALL,
        samples: args.paths / 2,
        seed: args.seed ^ half,
    });
    let mut found = Row {
        twin: Vec::new(),
        kits: Default::default(),
        ns: Default::default(),
    };
    for column in 0..SMALL[0] {
        let mut ns = [f64::INFINITY; KITS.len()];
        for plan in &plans {
            let paths = |by| shot.scene.paths(by, plan, [column, row]);
            found.twin.extend(paths(By::Twin));
            for (k, kit) in KITS.into_iter().enumerate() {
                let start = Instant::now();
                found.kits[k].extend(paths(kit));
                let time = start.elapsed().as_nanos() as f64 / f64::from(plan.samples);
                ns[k] = ns[k].min(time);
            }
        }
        (0..KITS.len()).for_each(|k| found.ns[k].push(ns[k]));
    }
    found
}

/// The middle one of the pixels.
fn median(rows: &[Row], kit: usize) -> f64 {
    let mut ns: Vec<f64> = rows.iter().flat_map(|row| &row.ns[kit]).copied().collect();
    ns.sort_by(f64::total_cmp);
    ns[ns.len() / 2]
}

/// The means of batches of a block.
type Batches = [[f64; 3]; BATCHES];

/// The sums of paths, by block and by batch, over their number.
fn blocks<'a>(rows: impl Iterator<Item = &'a Pixels>, samples: usize) -> Vec<Batches> {
    let mut sums = vec![[[0.0; 3]; BATCHES]; BLOCKS];
    let [width, _] = SMALL.map(|n| n as usize);
    let part = BATCHES as f64 / (BLOCK * BLOCK * samples) as f64;
    for (row, paths) in rows.enumerate() {
        for (k, light) in paths.iter().enumerate() {
            let (column, sample) = (k / samples, k % samples);
            let block = row / BLOCK * (width / BLOCK) + column / BLOCK;
            let batch = &mut sums[block][sample * BATCHES / samples];
            (0..3).for_each(|c| batch[c] += part * light[c]);
        }
    }
    sums
}

/// Mean and squared standard error of a channel of batches.
fn moments(batches: &Batches, channel: usize) -> (f64, f64) {
    let count = BATCHES as f64;
    let mean = batches.iter().map(|b| b[channel]).sum::<f64>() / count;
    let squares: f64 = batches.iter().map(|b| (b[channel] - mean).powi(2)).sum();
    (mean, squares / (count - 1.0) / count)
}

/// The mean square of the blocks' means without that of their errors, and its standard error. Channels have their errors in
/// common.
fn square(blocks: &[Batches]) -> (f64, f64) {
    let (mut sum, mut variance) = (0.0, 0.0);
    for batches in blocks {
        for channel in 0..3 {
            let (mean, error) = moments(batches, channel);
            sum += (mean * mean - error) / 3.0;
            variance += (2.0 * error * error + 4.0 * mean * mean * error) / 3.0;
        }
    }
    let count = blocks.len() as f64;
    (sum / count, variance.sqrt() / count)
}

fn of<'a>(shot: &'a Shot, args: &Args, done: impl Fn() + Sync) -> Scene<'a> {
    let numbers: Vec<u32> = (0..SMALL[1]).collect();
    let rows = in_parallel(threads(), &numbers, |number| {
        let row = row(shot, args, *number);
        done();
        row
    });
    let samples = args.paths as usize / 2 * 2;
    let twin = blocks(rows.iter().map(|row| &row.twin), samples);
    let count = BLOCKS as f64;
    let scale = [0, 1, 2].map(|c| twin.iter().map(|b| moments(b, c).0).sum::<f64>() / count);
    // The variance of a path, averaged over pixels.
    let pixels = rows.iter().flat_map(|row| row.twin.chunks(samples));
    let variance = |paths: &[[f64; 3]], c: usize| {
        let mean = paths.iter().map(|p| p[c]).sum::<f64>() / samples as f64;
        let squares: f64 = paths.iter().map(|p| (p[c] - mean).powi(2)).sum();
        squares / (samples - 1) as f64 / scale[c] / scale[c]
    };
    let noise = pixels.map(|paths| (0..3).map(|c| variance(paths, c)).sum::<f64>() / 3.0);
    let noise = (noise.sum::<f64>() / f64::from(SMALL[0] * SMALL[1])).sqrt();
    let kits = KITS.iter().enumerate().map(|(k, by)| {
        let mut off = blocks(rows.iter().map(|row| &row.kits[k]), samples);
        let mut steps = off.clone();
        for (block, due) in twin.iter().enumerate() {
            let mean = [0, 1, 2].map(|c| moments(due, c).0);
            let shown = (shot.develop)(mean);
            for batch in 0..BATCHES {
                let less = |c: usize| off[block][batch][c] - due[batch][c];
                let less = [0, 1, 2].map(less);
                let here = (shot.develop)([0, 1, 2].map(|c| (mean[c] + less[c]).max(0.0)));
                steps[block][batch] = [0, 1, 2].map(|c| here[c] - shown[c]);
                off[block][batch] = [0, 1, 2].map(|c| less[c] / scale[c]);
            }
        }
        Found {
            by: *by,
            bias: Size::of(square(&off)),
            steps: Size::of(square(&steps)),
            ns: median(&rows, k),
        }
    });
    Scene {
        shot,
        noise,
        kits: kits.collect(),
    }
}

/// Samples a pixel that nobody takes.
const MOST: f64 = 1e9;

/// A number of samples, to two digits, rounded down.
fn rounded(samples: f64) -> String {
    let samples = samples.clamp(1.0, MOST);
    let power = 10f64.powf((samples.log10() - 1.0).floor().max(0.0));
    let number = (samples / power).floor() * power;
    let digits = format!("{number:.0}");
    let groups = digits.as_bytes().rchunks(3).rev();
    let groups: Vec<_> = groups.map(String::from_utf8_lossy).collect();
    groups.join(",")
}

/// Instructions of a path on a core, where `crates/cores` has counted them.
fn instructions(scene: &str, kit: By, core: &str) -> String {
    let counts = host::counts::Counts::read().ok();
    let kernel = format!("{}_path_{scene}", kit.name());
    let number = counts.and_then(|counts| counts.number(&kernel, core, "instructions"));
    number.map_or_else(|| "-".into(), |n| format!("{n:.0}"))
}

/// The text of samples: from a measured bias a number, from a bound the least that it is.
fn up_to(found: &Found, noise: f64) -> String {
    let samples = found.samples(noise);
    let more = if found.bias.measured && samples < MOST {
        ""
    } else {
        "> "
    };
    format!("{more}{}", rounded(samples))
}

/// The cores, by their names in the measurements and in print.
const CORES: [(&str, &str); 3] = [("m0", "M0"), ("m4f", "M4F"), ("wasm", "WASM")];

fn table(scenes: &[Scene]) {
    let mut rows = Vec::new();
    for Scene { shot, noise, kits } in scenes {
        for found in kits {
            // Less than half a step is rounded away, and more shows once noise does not hide it.
            let shows = found.steps.value >= 0.5;
            let bits = if shows {
                up_to(found, *noise)
            } else {
                "any".into()
            };
            let mut row = vec![
                shot.title.to_owned(),
                found.by.name().to_owned(),
                found.bias.text(|x| format!("{x:.1e}")),
                up_to(found, *noise),
                found.steps.text(|x| format!("{x:.2}")),
                bits,
                format!("{:.0}", found.ns),
            ];
            row.extend(CORES.map(|(core, _)| instructions(shot.name, found.by, core)));
            rows.push(row);
        }
    }
    let header = [
        "scene",
        "samplers",
        "bias",
        "up to N samples",
        "steps of 8 bits",
        "up to N at 8 bits",
        "ns a path",
    ];
    print(
        &[&header[..], &CORES.map(|(_, name)| name)].concat(),
        rows,
        2,
    );
}

/// Over all scenes: the fewest samples, and the mean time.
fn summary(scenes: &[Scene]) {
    let row = |k: usize| {
        let all = || scenes.iter().map(|scene| (&scene.kits[k], scene.noise));
        let fewest = all().min_by(|(a, m), (b, n)| a.samples(*m).total_cmp(&b.samples(*n)));
        let (least, noise) = fewest.expect("there are scenes");
        let ns = all().map(|(found, _)| found.ns).sum::<f64>() / scenes.len() as f64;
        vec![
            KITS[k].name().to_owned(),
            up_to(least, noise),
            format!("{ns:.0}"),
        ]
    };
    let rows = (0..KITS.len()).map(row).collect();
    print(&["in every scene", "up to N samples", "ns a path"], rows, 1);
}

pub fn run(shots: &[Shot], args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    let steps = shots.len() as u64 * u64::from(SMALL[1]);
    let progress = host::cli::progress(steps, "{percent:>3} %")?;
    let scenes: Vec<_> = shots
        .iter()
        .map(|shot| of(shot, args, || progress.inc(1)))
        .collect();
    progress.finish_and_clear();
    println!(
        "Bias against a twin in f64, {} paths of each of {} × {} pixels, by blocks of {BLOCK} × {BLOCK}.\n\
         Up to N samples a pixel it is below a tenth of the noise of a pixel:\n",
        args.paths, SMALL[0], SMALL[1]
    );
    summary(&scenes);
    table(&scenes);
    for Scene { shot, noise, .. } in &scenes {
        println!(
            "{}: a pixel of one sample is off by {:.0} %.",
            shot.title,
            100.0 * noise
        );
    }
    let path = args.out.join("accuracy.png");
    chart::draw(&scenes).save_in_full_colour(&path)?;
    println!(
        "The chart is {}; {:.1} s.",
        path.display(),
        start.elapsed().as_secs_f64()
    );
    Ok(complaints(&scenes))
}

/// No tier may show by [`SHOWS_BY`] samples, and 4 % must in all scenes but one: the noise of the caustic hides them for longer.
fn complaints(scenes: &[Scene]) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut hidden = Vec::new();
    for Scene { shot, noise, kits } in scenes {
        for found in kits {
            let samples = found.samples(*noise);
            // The bias of a picture with a few very bright paths is hard to measure; what is seen of it is not.
            let seen = found.steps.measured && found.steps.value >= 0.5;
            let shows = samples <= SHOWS_BY;
            match found.by {
                By::FourPercent if seen || (found.bias.measured && shows) => {}
                By::FourPercent => hidden.push(shot.title),
                By::Textbook => {}
                _ if shows => complaints.push(format!(
                    "{}, {}: shows from {samples:.0} samples on",
                    shot.title,
                    found.by.name()
                )),
                _ => {}
            }
        }
    }
    if hidden.len() > 1 {
        let scenes = hidden.join(", ");
        complaints.push(format!(
            "errors of 4 % do not show by {SHOWS_BY} samples in {scenes}"
        ));
    }
    complaints
}
