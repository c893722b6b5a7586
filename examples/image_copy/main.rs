//! A picture as the density of a chain: what comes back, and how fast.
//! `cargo run --release --example image_copy -- --help`
//!
//! The picture is made by `scene.rs`, what is true of its copies is in `theory.rs`. This file runs the steps.

mod args;
mod copy;
mod figure;
mod report;
mod scene;
mod study;
mod theory;

use args::Args;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;
use study::Study;

fn main() -> ExitCode {
    support::cli::run("image_copy", args::HELP, args::parse(), run)
}

/// Runs everything and returns the complaints.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    support::progress::folder(&args.out)?;
    let progress = support::progress::progress(args.repetitions, support::progress::STEPS)?;
    progress.set_message("copying");
    let texels = scene::picture();
    let luminance: Vec<f32> = texels
        .iter()
        .map(|&t| support::draw::tone::luminance(t) as f32)
        .collect();
    let study = Study::new(&luminance, args.most, args.repetitions, args.seed, || {
        progress.inc(1)
    })?;
    progress.set_message("drawing");
    let path = args.out.join("image_copy.png");
    figure::draw(&study, &texels).save(&path)?;
    progress.finish_and_clear();

    report::errors(&study);
    report::recordings(&study);
    println!(
        "\nThe figure is {}; {:.1} s.",
        path.display(),
        start.elapsed().as_secs_f64()
    );
    Ok(study.complaints())
}
