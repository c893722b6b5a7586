//! A picture of the sky as a distribution of directions: built, sampled, checked, used and drawn.
//! `cargo run --release --example envmap -- --help`
//!
//! The picture is `sky.png`, made by `scene.rs` and read by `picture.rs`. This file runs the steps.

mod args;
mod controls;
mod develop;
mod figure;
mod light;
mod picture;
mod report;
mod scene;
mod small;
mod small_weights;
mod study;

use args::Args;
use figure::Figure;
use microwarp::{Warp, poly as mw};
use picture::Picture;
use rand_pcg::Pcg32;
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;
use study::{Memory, Study, Truth};
use support::verdict::passes;

const SKY: &[u8] = include_bytes!("sky.png");
/// Samples that are drawn as points.
const POINTS: usize = 4000;
/// How much darker than the sun the rest of the picture is made for the table that needs `u64`.
const NIGHT: f32 = 1e-9;

fn main() -> ExitCode {
    support::cli::run("envmap", args::HELP, args::parse(), |args| {
        match &args.make_picture {
            Some(folder) => make_picture(folder).map(|()| Vec::new()),
            None => run(args),
        }
    })
}

/// Writes the two generated files.
fn make_picture(folder: &Path) -> Result<(), Box<dyn Error>> {
    let picture = scene::sky();
    support::progress::folder(folder)?;
    picture.write(&folder.join("sky.png"))?;
    std::fs::write(folder.join("small_weights.rs"), small::source(&picture))?;
    println!("sky.png and small_weights.rs in {}", folder.display());
    Ok(())
}

/// Runs everything and returns the complaints.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    support::progress::folder(&args.out)?;
    let progress = support::progress::progress(7, support::progress::STEPS)?;
    let step = |text: &'static str| {
        progress.inc(1);
        progress.set_message(text);
    };

    step("reading the picture");
    let picture = Picture::read(SKY)?;
    let mut complaints = generated(&picture);
    let (weights, luminance) = (picture.weights(), picture.luminance());
    let shape = picture.shape;
    let truth = Truth::new(&weights, shape);
    let rng = |stream| Pcg32::new(args.seed, stream);

    step("a table of u32");
    let mut memory = Memory::<u32>::new(shape);
    let seconds = memory.time(&weights, shape)?;
    let table = memory.build(&weights, shape)?;
    let mut in_u32 = Study::new("u32", &table, &truth, args.samples, &mut rng(1));
    in_u32.build = Some(seconds);

    step("a table of u64");
    let mut wide = Memory::<u64>::new(shape);
    let seconds = wide.time(&weights, shape)?;
    let wide_table = wide.build(&weights, shape)?;
    let mut in_u64 = Study::new("u64", &wide_table, &truth, args.samples, &mut rng(2));
    in_u64.build = Some(seconds);

    step("the table that the compiler built");
    let small = small::picture(&picture);
    let small_truth = Truth::new(small_weights::WEIGHTS.as_flattened(), small::SHAPE);
    let in_flash = Study::new(
        "u32, const",
        &small::SKY,
        &small_truth,
        args.samples,
        &mut rng(3),
    );

    step("tables that are wrong on purpose");
    let controls = controls::all(&truth, &weights, &luminance, args.samples, args.seed)?;
    step("light");
    let radiance: Vec<f32> = luminance.iter().map(|&l| l as f32).collect();
    let (mut rows, mut texels) = (vec![0; shape[1]], vec![0; radiance.len()]);
    let sky = mw::LatLongMap::<&[u32], &[u32]>::new_in(&radiance, shape, &mut rows, &mut texels)?;
    let light = light::quantities(&sky, &luminance, args.seed);
    let night = night(&weights, &truth);

    step("drawing");
    let mut points = [[0.0; 2]; POINTS];
    table.fill(&mut rng(4), &mut points);
    let figure = Figure {
        picture: &picture,
        small: &small,
        truth: &truth,
        study: &in_u32,
        small_study: &in_flash,
        control: &controls[0],
        points: &points,
        samples: args.samples,
    };
    let path = args.out.join("envmap.png");
    figure.draw().save(&path)?;
    progress.finish_and_clear();

    let studies = [in_u32, in_u64, in_flash];
    let mapping = small::mapping();
    report::studies(&studies, mapping.as_deref());
    report::controls(&controls);
    report::light(&light);
    match night {
        Ok(text) => println!("\n{text}"),
        Err(complaint) => complaints.push(complaint),
    }
    complaints.extend(studies.into_iter().flat_map(|s| s.complaints));
    complaints.extend(light.into_iter().flat_map(|q| q.complaints));
    for control in controls.iter().filter(|c| passes(&c.outcome)) {
        let name = control.name;
        complaints.push(format!("{name}: the test lets this pass"));
    }
    if mapping.is_some_and(|permissions| permissions.contains('w')) {
        complaints.push("the table that should be in flash may be written to".into());
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("\nThe figure is {}; {seconds:.1} s.", path.display());
    Ok(complaints)
}

/// Whether the two generated files are those that this program generates.
fn generated(picture: &Picture) -> Vec<String> {
    let mut complaints = Vec::new();
    if *picture != scene::sky() {
        complaints.push("sky.png is not what --make-picture makes".into());
    }
    if !small::source(picture)
        .lines()
        .eq(include_str!("small_weights.rs").lines())
    {
        complaints.push("small_weights.rs is not what --make-picture makes".into());
    }
    complaints
}

/// A picture that needs more than 32 bits, a lamp in the darkest night, and how a program handles it.
fn night(weights: &[f32], truth: &Truth) -> Result<String, String> {
    let lamp = 1e-3 * weights[truth.brightest()];
    let darken = |&w: &f32| if w < lamp { NIGHT * w } else { w };
    let dark: Vec<f32> = weights.iter().map(darken).collect();
    let mut narrow = Memory::<u32>::new(truth.shape);
    let Err(refusal) = narrow.build(&dark, truth.shape) else {
        return Err("a table of u32 takes the night".into());
    };
    let mut wide = Memory::<u64>::new(truth.shape);
    let table = wide
        .build(&dark, truth.shape)
        .map_err(|e| format!("a table of u64 does not take the night: {e}"))?;
    let lit = (0..dark.len()).filter(|&cell| dark[cell] > 0.0);
    let unreached = lit.filter(|&cell| table.pdf(truth.middle(cell)) <= 0.0);
    match unreached.count() {
        0 => Ok(format!(
            "All but the sun made {NIGHT:.0e} times as bright, u32 says: {refusal:?}, \"{refusal}\".\n\
             A table of u64 takes that picture too, and every lit texel has a density."
        )),
        n => Err(format!("{n} lit texels of the night have no density")),
    }
}
