//! Three mutations, one target: what a chain needs to reach every state.
//! `cargo run --release --example mutations -- --help`
//!
//! The target and the mutations are in `target.rs`, what is true of them in `kernel.rs`. This file runs the steps.

mod args;
mod controls;
mod figure;
mod kernel;
mod ladder;
mod report;
mod run;
mod study;
mod target;
mod thinned;

use args::Args;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;
use study::Study;

fn main() -> ExitCode {
    support::cli::run("mutations", args::HELP, args::parse(), run)
}

/// Runs everything and returns the complaints.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    support::progress::folder(&args.out)?;
    let rules = target::Rule::all()?;
    let progress = support::progress::progress(rules.len() as u64 + 2, support::progress::STEPS)?;
    let mut studies = Vec::new();
    for (stream, rule) in rules.iter().enumerate() {
        progress.set_message(format!("chains with the mutation {}", rule.name()));
        studies.push(Study::new(
            rule,
            args.relaxations,
            args.seed,
            100 * stream as u64,
        )?);
        progress.inc(1);
    }
    progress.set_message("chains that are wrong on purpose");
    let controls = controls::all(&studies, args.seed)?;
    progress.inc(1);
    progress.set_message("drawing");
    let path = args.out.join("mutations.png");
    figure::draw(&studies).save(&path)?;
    progress.finish_and_clear();

    report::runs(&studies);
    report::truths(&studies);
    report::controls(&controls);
    let mut complaints: Vec<String> = studies.iter().flat_map(Study::complaints).collect();
    complaints.extend(controls::complaints(&controls, &studies));
    println!(
        "\nThe picture is {}; {:.1} s.",
        path.display(),
        start.elapsed().as_secs_f64()
    );
    Ok(complaints)
}
