//! How fast the error of an integral falls: three classical rules and three random methods in 1, 2 and 6
//! dimensions. `cargo run --release --example convergence -- --help`
//!
//! This file runs the steps. The program fails when a slope is not the one theory gives.

mod args;
mod figure;
mod fit;
mod integrand;
mod method;
mod plot;
mod random;
mod rules;
mod table;

use args::Args;
use fit::{Line, Point};
use method::{DIMENSIONS, METHODS, Method};
use rand_pcg::Pcg32;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    support::cli::run("convergence", args::HELP, args::parse(), run)
}

/// Runs everything and returns the complaints about the slopes.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    let path = args.out.join("convergence.png");
    support::progress::folder(&args.out)?;

    let kinds: Vec<(u32, Method)> = DIMENSIONS
        .iter()
        .flat_map(|&s| METHODS.map(|method| (s, method)))
        .collect();
    let all: u64 = kinds
        .iter()
        .flat_map(|&(s, method)| method.sizes(s).into_iter().map(move |n| (s, method, n)))
        .map(|(s, method, size)| work(method, size, s, args.repetitions))
        .sum();
    let progress = support::progress::progress(all, "{percent:>3} %")?;
    let mut lines = Vec::new();
    for (stream, &(s, method)) in kinds.iter().enumerate() {
        progress.set_message(format!("{} in {s}-D", method.name()));
        // Each line has its own stream, so that no two share their errors.
        let mut rng = Pcg32::new(args.seed, stream as u64);
        let points = method.sizes(s).into_iter().map(|size| {
            let error = if method.is_random() {
                random::error(method, size, s, args.repetitions, &mut rng)
            } else {
                rules::error(method, size, s)
            };
            progress.inc(work(method, size, s, args.repetitions));
            Point::new(method, size, s, error)
        });
        lines.push(Line::new(method, s, points.collect()));
    }
    progress.finish_and_clear();

    figure::draw(&lines, args.repetitions).save(&path)?;
    table::print(&lines, args.repetitions);
    let (complaints, refused) = fit::check(&lines);
    println!(
        "Control: {refused} times a slope was held against the rate of another line, and refused.\n\n\
         The picture is {}; {:.1} s.",
        path.display(),
        start.elapsed().as_secs_f64()
    );
    Ok(complaints)
}

/// The rough cost of a point in nanoseconds.
fn work(method: Method, size: u32, s: u32, repetitions: u32) -> u64 {
    let axis = match method {
        Method::Importance => 25,
        Method::Stratified => 10,
        Method::Plain => 4,
        _ => return method.evaluations(size, s),
    };
    axis * u64::from(s) * method.evaluations(size, s) * u64::from(repetitions)
}
