//! The gallery: draws every warp in both tiers, checks the samples against the density and against
//! exact values, and prints a table. `cargo run --release --example gallery -- --help`
//!
//! The registry in `crates/host` lists what is drawn, with its exact maps. This file runs the steps.

mod area;
mod args;
mod banner;
mod check;
mod line;
#[cfg(test)]
mod panels;
mod sheet;
mod strata;

use args::Args;
use check::Figures;
use host::registry::Entry;
use host::registry::picture::{Picture, View};
use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// The tier of the contact sheet, by its place in the registry's order.
const SHEET_TIER: usize = 1;

/// A picture and what the registry knows of it in each tier; nothing for strata and points.
pub struct Subject<'a> {
    pub name: &'static str,
    pub parameters: &'static str,
    pub picture: Picture,
    pub entries: Vec<&'a Entry>,
}

fn main() -> ExitCode {
    host::cli::run("gallery", args::HELP, args::parse(), run)
}

/// Runs everything and returns the complaints about the warps.
fn run(args: &Args) -> Result<Vec<String>, Box<dyn Error>> {
    let start = Instant::now();
    let entries = host::registry::entries_of_each_tier();
    let mut complaints = without_picture(&entries);
    let subjects = subjects(&entries, args)?;
    host::cli::folder(&args.out)?;

    let rows: Vec<&Entry> = subjects
        .iter()
        .flat_map(|s| s.entries.iter().copied())
        .collect();

    let progress = host::cli::progress((rows.len() + subjects.len()) as u64, host::cli::STEPS)?;
    let figures = host::parallel::in_parallel(args.threads, &rows, |entry| {
        progress.set_message(format!("sampling {entry}"));
        let figures = check::measure(entry, args.seed, args.samples);
        progress.inc(1);
        figures
    });
    let of = |entry: &Entry| {
        rows.iter()
            .position(|e| std::ptr::eq(*e, entry))
            .map(|i| &figures[i])
    };

    let saved = host::parallel::in_parallel(args.threads, &subjects, |subject| {
        progress.set_message(format!("drawing {}", subject.name));
        let known: Vec<Option<&Figures>> = subject.entries.iter().map(|entry| of(entry)).collect();
        let path = args.out.join(file_name(subject));
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
            host::cli::folder(folder)?;
        }
        sheet::contact(&subjects, SHEET_TIER, args).save(&path)?;
        places.push(format!("the contact sheet in {}", path.display()));
    }
    if let Some(folder) = &args.rustdoc {
        host::cli::folder(folder)?;
        for_rustdoc(&subjects, folder, args)?;
        places.push(format!(
            "those for the documentation in {}",
            folder.display()
        ));
    }
    if let Some(room) = &args.room {
        let path = args.out.join("banner.png");
        let room = host::draw::canvas::read_rgb(room)?;
        banner::draw(&subjects, &room, args).save_in_full_colour(&path)?;
        places.push(format!("the banner in {}", path.display()));
    }
    progress.finish_and_clear();

    let measured: Vec<(&Entry, &Figures)> = rows.iter().copied().zip(&figures).collect();
    check::print(&measured);
    for (entry, figures) in measured {
        complaints.extend(figures.shape.complaint().map(|c| format!("{entry}: {c}")));
    }
    println!(
        "\n{}; {:.1} s.",
        places.join(", "),
        start.elapsed().as_secs_f64()
    );
    Ok(complaints)
}

/// A small picture of each warp, as a line of HTML that its documentation includes: rustdoc takes no files along.
fn for_rustdoc(subjects: &[Subject], folder: &Path, args: &Args) -> Result<(), String> {
    let mut done = BTreeSet::new();
    // "Interval, decreasing" is an interval too, and the first of each is shown.
    let kind = |s: &Subject| snake(s.name.split(' ').next().unwrap_or_default());
    for subject in subjects.iter().filter(|s| done.insert(kind(s))) {
        let picture = sheet::thumbnail(subject, SHEET_TIER, args).data_address()?;
        let html = format!(
            "<img alt=\"Samples of {} over its density: {}\" src=\"{picture}\">\n",
            subject.name, subject.picture.caption
        );
        let path = folder.join(kind(subject)).with_extension("html");
        std::fs::write(&path, html).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    Ok(())
}

/// "PhongLobe" becomes "phong_lobe".
fn snake(name: &str) -> String {
    let mut snake = String::new();
    for c in name.chars() {
        if c.is_uppercase() && !snake.is_empty() {
            snake.push('_');
        }
        snake.extend(c.to_lowercase());
    }
    snake
}

/// Warps none of whose cases has a picture.
fn without_picture(entries: &[Entry]) -> Vec<String> {
    let mut names: Vec<&str> = entries.iter().map(|entry| entry.name).collect();
    let pictured = |name: &str| {
        entries
            .iter()
            .any(|e| e.name == name && e.picture.is_some())
    };
    names.retain(|name| !pictured(name));
    names.sort_unstable();
    names.dedup();
    let complaint = |name: &&str| format!("{name}: no picture in the registry");
    names.iter().map(complaint).collect()
}

/// What has no density: strata and points, beside plain uniforms.
const STRATA: [(&str, &str, Picture); 6] = [
    (
        "Strata1d",
        "24",
        Picture {
            caption: "24 strata, one point in each",
            view: View::Strata1d,
        },
    ),
    (
        "Strata2d",
        "10 × 16",
        Picture {
            caption: "10 × 16 strata, one point in each",
            view: View::Strata2d,
        },
    ),
    (
        "Sobol",
        "256",
        Picture {
            caption: "256 points, one in each box",
            view: View::Sobol,
        },
    ),
    (
        "Recurrence",
        "256",
        Picture {
            caption: "256 points of R₂",
            view: View::Recurrence,
        },
    ),
    (
        "ByPosition",
        "256",
        Picture {
            caption: "256 samples of a pixel",
            view: View::ByPosition,
        },
    ),
    (
        "Screen",
        "1",
        Picture {
            caption: "errors of pixels with one sample each; below, after a mean over 3 × 3",
            view: View::Screen,
        },
    ),
];

/// The pictures asked for, each with its entries.
fn subjects<'a>(entries: &'a [Entry], args: &Args) -> Result<Vec<Subject<'a>>, String> {
    let mut subjects: Vec<Subject> = Vec::new();
    for entry in entries {
        let Some(picture) = entry.picture else {
            continue;
        };
        let same = |s: &&mut Subject| s.name == entry.name && s.parameters == entry.parameters;
        match subjects.iter_mut().find(same) {
            Some(subject) => subject.entries.push(entry),
            None => subjects.push(Subject {
                name: entry.name,
                parameters: entry.parameters,
                picture,
                entries: vec![entry],
            }),
        }
    }
    subjects.extend(STRATA.map(|(name, parameters, picture)| Subject {
        name,
        parameters,
        picture,
        entries: Vec::new(),
    }));
    subjects.retain(|subject| args.wants(subject.name));
    if subjects.is_empty() {
        return Err("no warp has a name like that; the names are those in the table".into());
    }
    Ok(subjects)
}

/// "PhongLobe n=1e6" becomes "phonglobe-n-1e6.png".
fn file_name(subject: &Subject) -> PathBuf {
    let parameters = subject
        .parameters
        .replace("=-", "-minus-")
        .replace("[-", "minus-");
    let name = format!("{} {parameters}", subject.name).to_lowercase();
    let words = name.split(|c: char| !c.is_alphanumeric() && c != '.');
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    format!("{}.png", words.join("-")).into()
}
