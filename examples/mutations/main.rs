//! Three mutations, one target: what a chain needs to be everywhere.
//! `cargo run --release --example mutations -- --help`
//!
//! The target and the mutations are in `target.rs`, what is true of them in `kernel.rs`. Here lives the order
//! of the work.

mod args;
#[path = "../common/canvas.rs"]
mod canvas;
#[path = "../../tests/catalogue/mod.rs"]
mod catalogue;
#[path = "../common/cli.rs"]
mod cli;
mod controls;
mod figure;
mod kernel;
mod ladder;
#[path = "../common/mean.rs"]
mod mean;
#[path = "../common/plot.rs"]
mod plot;
mod report;
mod run;
#[path = "../common/scale.rs"]
mod scale;
mod study;
#[path = "../common/table.rs"]
mod table;
mod target;
#[path = "../common/text.rs"]
mod text;
mod thinned;
#[path = "../common/verdict.rs"]
mod verdict;
#[path = "../common/work.rs"]
mod work;

use args::Args;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;
use study::Study;

fn main() -> ExitCode {
    cli::run("mutations", args::HELP, args::parse(), run)
}

/// Does everything; returns what is wrong.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    work::folder(&args.out)?;
    let rules = target::Rule::all()?;
    let progress = work::progress(rules.len() as u64 + 2, work::STEPS)?;
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
