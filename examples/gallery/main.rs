//! The gallery: draws every warp in both tiers, checks the samples against the density and against
//! exact values, and prints a table. `cargo run --release --example gallery -- --help`
//!
//! What is drawn is one list, `list.rs`; what it should be is `tests/catalogue`. Here lives the order of
//! the work.

mod area;
mod args;
mod check;
mod line;
mod list;
mod sheet;
mod strata;
mod table;

use args::Args;
use check::Figures;
use list::{PICTURES, Picture, Subject, View};
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;
use support::registry::Entry;

/// The tier of the contact sheet, by its place in the catalogue's order.
const SHEET_TIER: usize = 1;

fn main() -> ExitCode {
    support::cli::run("gallery", args::HELP, args::parse(), run)
}

/// Does everything; returns what is wrong with the warps.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    let entries = support::registry::entries();
    let mut complaints = without_picture(&entries);
    let subjects = subjects(&entries, args)?;
    support::progress::folder(&args.out)?;

    let rows: Vec<&Entry> = subjects
        .iter()
        .flat_map(|s| s.entries.iter().copied())
        .collect();

    let progress = support::progress::progress(
        (rows.len() + subjects.len()) as u64,
        support::progress::STEPS,
    )?;
    let figures = support::parallel::in_parallel(args.threads, &rows, |entry| {
        progress.set_message(format!("sampling {}", entry.label()));
        let figures = check::measure(entry, args.seed, args.samples);
        progress.inc(1);
        figures
    });
    let of = |entry: &Entry| {
        rows.iter()
            .position(|e| std::ptr::eq(*e, entry))
            .map(|i| &figures[i])
    };

    let saved = support::parallel::in_parallel(args.threads, &subjects, |subject| {
        progress.set_message(format!("drawing {}", subject.picture.name));
        let known: Vec<Option<&Figures>> = subject.entries.iter().map(|entry| of(entry)).collect();
        let path = args.out.join(file_name(subject.picture));
        let saved = sheet::single(subject, &known, args).save(&path);
        progress.inc(1);
        saved
    });
    saved.into_iter().collect::<Result<Vec<()>, String>>()?;
    let mut places = vec![format!(
        "{} pictures in {}",
        subjects.len(),
        args.out.display()
    )];
    if args.only.is_none() {
        progress.set_message("drawing the contact sheet");
        let path = args
            .sheet
            .clone()
            .unwrap_or_else(|| args.out.join("gallery.png"));
        if let Some(folder) = path.parent() {
            support::progress::folder(folder)?;
        }
        sheet::contact(&subjects, SHEET_TIER, args).save(&path)?;
        places.push(format!("the contact sheet in {}", path.display()));
    }
    progress.finish_and_clear();

    let measured: Vec<(&Entry, &Figures)> = rows.iter().copied().zip(&figures).collect();
    table::print(&measured);
    for (entry, figures) in measured {
        complaints.extend(
            figures
                .shape
                .complaint()
                .map(|c| format!("{}: {c}", entry.label())),
        );
    }
    println!(
        "\n{}; {:.1} s.",
        places.join(", "),
        start.elapsed().as_secs_f64()
    );
    Ok(complaints)
}

/// Warps of the catalogue that the list of pictures has forgotten.
fn without_picture(entries: &[Entry]) -> Vec<String> {
    let mut names: Vec<&str> = entries.iter().map(|entry| entry.name).collect();
    names.dedup();
    names.retain(|name| PICTURES.iter().all(|picture| picture.name != *name));
    names.sort_unstable();
    names.dedup();
    names
        .iter()
        .map(|name| format!("{name}: no picture in examples/gallery/list.rs"))
        .collect()
}

/// The pictures asked for, each with its entries.
fn subjects<'a>(entries: &'a [Entry], args: &Args) -> Result<Vec<Subject<'a>>, String> {
    let mut subjects = Vec::new();
    for picture in PICTURES.iter().filter(|picture| args.wants(picture.name)) {
        let same =
            |entry: &&Entry| entry.name == picture.name && entry.parameters == picture.parameters;
        let entries: Vec<&Entry> = entries.iter().filter(same).collect();
        if entries.is_empty() && !matches!(picture.view, View::Strata1d | View::Strata2d) {
            return Err(format!(
                "tests/catalogue has no {} with {}",
                picture.name, picture.parameters
            ));
        }
        subjects.push(Subject { picture, entries });
    }
    if subjects.is_empty() {
        return Err("no warp has a name like that; the names are those in the table".into());
    }
    Ok(subjects)
}

/// "PhongLobe n=1e6" becomes "phonglobe-n-1e6.png".
fn file_name(picture: &Picture) -> PathBuf {
    let parameters = picture
        .parameters
        .replace("=-", "-minus-")
        .replace("[-", "minus-");
    let name = format!("{} {parameters}", picture.name).to_lowercase();
    let words = name.split(|c: char| !c.is_alphanumeric() && c != '.');
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    format!("{}.png", words.join("-")).into()
}
