//! Every sampler next to its peers in one process: rand, rand_distr, micromath, textbook formulas over libm, the
//! maps that renderers write by hand, and the generator alone. `cargo bench --bench peers -- --help`
//!
//! How times are taken and compared is in `host::contest`, what the peers are in `host::peers`, who meets
//! whom in `families.rs`. This file runs the steps.

mod anew;
mod args;
mod draws;
mod families;
mod fills;
mod kit;
mod lamps;
mod report;
mod tables;

use args::Args;
use families::{Family, Kind};
use host::contest::Standings;
use std::error::Error;
use std::process::ExitCode;

fn main() -> ExitCode {
    host::cli::run("peers", args::HELP, args::parse(), run)
}

/// Runs everything. A slow sampler is reported but is not a failure, since times depend on the machine's load.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let wanted = |family: &Family| args.wants(family.name);
    let families: Vec<Family> = families::all().into_iter().filter(wanted).collect();
    if families.is_empty() {
        // As with every bench: what is asked for may be in another.
        println!("no family of such a name; --help lists them");
        return Ok(Vec::new());
    }
    host::cli::folder(&args.out)?;
    let progress = host::cli::progress((families.len() * args.rounds) as u64, "{percent:>3} %")?;
    let mut results: Vec<(Family, Standings)> = Vec::new();
    for family in families {
        progress.set_message(family.title());
        let standings = (family.run)(args.rounds, &mut || progress.inc(1));
        results.push((family, standings));
    }
    progress.finish_and_clear();

    if args.markdown {
        report::summary(&results);
        report::weighed(&results);
    } else {
        report::tables(&results, Kind::Draw);
        report::tables(&results, Kind::Fill);
        report::tables(&results, Kind::Weighed);
        report::targets(&results);
    }
    report::noise(&results);
    let path = args.out.join("peers.csv");
    std::fs::write(&path, report::csv(&results))?;
    println!(
        "\n{} rounds; every figure is in {}.",
        args.rounds,
        path.display()
    );
    Ok(Vec::new())
}
