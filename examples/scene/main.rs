//! A small path tracer, whose every random number is microwarp's: six scenes, and what tiers, point sets and chains do for them.
//! `cargo run --release --example scene -- --help`
//!
//! The tracer itself is the package in `core`, which needs no `std`. This file runs the steps.

mod accuracy;
mod args;
mod chains;
mod chart;
mod kits;
mod render;
mod report;
mod sheet;
mod shots;
mod study;

use args::Args;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    host::cli::run("scene", args::HELP, args::parse(), run)
}

/// Runs everything and returns the complaints.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    host::cli::folder(&args.out)?;
    let shots = shots::all();
    if args.accuracy {
        return accuracy::run(&shots, args);
    }
    if args.pictures {
        return sheet::run(&shots, args);
    }
    let steps = shots.len() as u64 * study::steps(args) + chains::steps();
    let progress = host::cli::progress(steps, "{percent:>3} %")?;
    let mut studies = Vec::new();
    for shot in &shots {
        progress.set_message(shot.name);
        studies.push(study::of(shot, args, &progress));
    }
    progress.set_message("Metropolis");
    let comparisons = chains::all(&shots, args, &progress);
    progress.finish_and_clear();

    for (shot, study) in shots.iter().zip(&studies) {
        let path = args.out.join(format!("{}.png", shot.name));
        sheet::save(&path, shot, &study.picture, args.size)?;
    }
    let path = args.out.join("scene.png");
    let pictures: Vec<_> = studies.iter().map(|study| &study.picture).collect();
    sheet::draw(&shots, &pictures, args).save(&path)?;
    report::errors(&shots, &studies);
    chains::print(&comparisons);
    println!(
        "The sheet is {}, each picture beside it; {:.1} s.",
        path.display(),
        start.elapsed().as_secs_f64()
    );
    let mut complaints = report::complaints(&shots, &studies);
    complaints.extend(chains::complaints(&comparisons));
    Ok(complaints)
}
