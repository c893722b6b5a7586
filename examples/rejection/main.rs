//! Rejection in pictures: the proposals, the accepted points, and the measured efficiency next to the exact one. `cargo run --release --example rejection -- --help`
//!
//! What is drawn is one list, `scenes.rs`. This file runs the steps.

mod args;
mod measure;
mod page;
mod scenes;

use args::Args;
use comfy_table::{CellAlignment, Table, presets};
use measure::Measured;
use scenes::Scene;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;
use support::draw::text::thousands;

/// A measured efficiency may be this many standard errors off the exact one.
const ALARM: f64 = 6.0;

fn main() -> ExitCode {
    support::cli::run("rejection", args::HELP, args::parse(), run)
}

/// Runs everything and returns the complaints about the efficiencies.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    let scenes = scenes::all()?;
    support::progress::folder(&args.out)?;
    let progress = support::progress::progress(2 * scenes.len() as u64, support::progress::STEPS)?;
    let mut rows = Vec::new();
    for scene in &scenes {
        progress.set_message(format!("sampling {}", scene.name));
        let measured = measure::measure(scene, args)?;
        progress.inc(1);
        progress.set_message(format!("drawing {}", scene.name));
        let path = args.out.join(format!("{}.png", scene.file));
        page::draw(scene, &measured, args).save(&path)?;
        progress.inc(1);
        rows.push((scene, measured));
    }
    progress.finish_and_clear();
    print(&rows);
    println!(
        "\n{} pictures in {}; {:.1} s.",
        rows.len(),
        args.out.display(),
        start.elapsed().as_secs_f64()
    );
    let complaints = rows.iter().filter_map(|(scene, measured)| {
        let off = measured.deviation(scene);
        // Written so that NaN is no success.
        let right = off.abs() <= ALARM;
        (!right).then(|| format!("{}: the efficiency is off by {off:+.1} σ", scene.name))
    });
    Ok(complaints.collect())
}

fn print(rows: &[(&Scene, Measured)]) {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN);
    table.set_header([
        "density",
        "proposed from",
        "points",
        "tries",
        "efficiency",
        "exact",
        "off by",
        "most tries",
        "budget",
        "ns a point",
    ]);
    for (scene, measured) in rows {
        table.add_row([
            scene.name.to_string(),
            scene.proposal.to_string(),
            thousands(measured.points),
            thousands(measured.tries),
            format!("{:.3} %", 100.0 * measured.efficiency()),
            format!("{} = {:.3} %", scene.formula, 100.0 * scene.efficiency),
            format!("{:+.2} σ", measured.deviation(scene)).replace('-', "−"),
            measured.most().to_string(),
            scene.budget.to_string(),
            format!("{:.1}", measured.nanoseconds),
        ]);
    }
    for column in (2..5).chain(6..10) {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    println!("{table}");
    println!(
        "efficiency: accepted points over tries. off by: in standard errors; beyond {ALARM} is a failure.\n\
         ns a point: through `draw`, generator, tally and a call through a pointer included."
    );
}
