//! The error and cost of each tier on every target, next to its peers.
//! `cargo run --release --example tradeoff -- --help`
//!
//! Which samplers there are is said in `list`, `tables_list` and `peer_list`, what is exact in the registry of `crates/host`. This file runs the steps.

mod advice;
mod args;
mod bias;
mod bounds;
mod cells;
mod clock;
mod controls;
mod costs;
mod error;
mod figure;
mod front;
mod labels;
mod list;
mod panel;
mod peer_list;
mod power;
mod report;
mod sampler;
mod shape;
mod study;
mod subject;
mod tables_list;

use args::Args;
use clock::Times;
use indicatif::ProgressBar;
use sampler::{Block, Row};
use std::error::Error;
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::Instant;
use study::Study;

fn main() -> ExitCode {
    host::cli::run("tradeoff", args::HELP, args::parse(), run)
}

/// Runs everything and returns the complaints.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    host::progress::folder(&args.out)?;
    let costs = costs::Costs::checked_in()?;
    let (rows, mut complaints) = list::rows(args)?;
    if rows.is_empty() {
        return Err(
            "no family and no sampler has a name like that; the names are those in the table"
                .into(),
        );
    }
    complaints.extend(front::check());
    complaints.extend(bounds::check());
    let tests = rows
        .iter()
        .map(|row| shape::tests(row.sampler.law.axes))
        .sum();
    let threshold = host::stats::threshold(tests);

    let progress =
        host::progress::progress((rows.len() + args.rounds + 2) as u64, host::progress::STEPS)?;
    let (studies, spread) = study(rows, &costs, args, &progress);
    progress.set_message("maps that are wrong on purpose");
    let controls = controls::all(args);
    progress.inc(1);
    progress.set_message("drawing");
    let path = args.out.join("tradeoff.png");
    figure::draw(&studies).save(&path)?;
    report::write(&studies, &args.out.join("tradeoff.csv"))?;
    progress.finish_and_clear();

    report::quality(&studies, args.samples, threshold);
    report::costs(&studies, spread);
    report::controls(&controls);
    advice::which(&studies);
    advice::print(&advice::outside(&studies));
    for study in &studies {
        complaints.extend(study.complaints.iter().cloned());
        if study.sampler.ours && !study.shape.passes(threshold) {
            let (label, p) = (study.sampler.label(), study.shape.worst());
            complaints.push(format!(
                "{label}: samples do not follow their distribution, p = {p:.1e}"
            ));
        }
    }
    complaints.extend(
        controls
            .iter()
            .flat_map(|control| control.complaints(threshold)),
    );
    println!(
        "{} samplers; the picture is {}, the table {}; {:.1} s.",
        studies.len(),
        path.display(),
        args.out.join("tradeoff.csv").display(),
        start.elapsed().as_secs_f64()
    );
    Ok(complaints)
}

/// Errors and distributions on several threads, then times on one, and the spread of those.
fn study(
    rows: Vec<Row>,
    costs: &costs::Costs,
    args: &Args,
    progress: &ProgressBar,
) -> (Vec<Study>, f64) {
    let mut blocks: Vec<(String, Block)> = Vec::new();
    let mut samplers = Vec::new();
    for (i, row) in rows.into_iter().enumerate() {
        blocks.push((format!("{i} drawn"), row.draw));
        blocks.extend(row.fill.map(|fill| (format!("{i} filled"), fill)));
        samplers.push(Mutex::new(Some(row.sampler)));
    }
    let mut studies = host::parallel::in_parallel(args.threads, &samplers, |sampler| {
        let sampler = sampler.lock().expect("no thread has panicked").take();
        let sampler = sampler.expect("each is taken once");
        progress.set_message(sampler.label());
        let study = Study::new(sampler, costs, args);
        progress.inc(1);
        study
    });
    progress.set_message("by the clock");
    let (times, spread) = clock::run(blocks, args.rounds, || progress.inc(1));
    for (i, study) in studies.iter_mut().enumerate() {
        let time = |what| {
            times
                .get(&format!("{i} {what}"))
                .map(|ns| ns * study.sampler.calls)
        };
        study.times = Times {
            draw: time("drawn"),
            fill: time("filled"),
        };
    }
    (studies, spread)
}
