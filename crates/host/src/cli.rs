//! What the command lines of the examples have in common: how a run ends, and how numbers are read.

use comfy_table::{CellAlignment, Table, presets};
use indicatif::{ProgressBar, ProgressStyle};
use lexopt::{Error, Parser, ValueExt};
use std::num::ParseIntError;
use std::path::Path;
use std::process::ExitCode;
use std::str::FromStr;

/// Runs an example on its arguments: 0 where all is well and for help, 1 where the run complains or fails,
/// 2 for arguments that are none.
pub fn run<A>(
    program: &str,
    help: &str,
    args: Result<Option<A>, Error>,
    run: impl FnOnce(&A) -> Result<Vec<String>, Box<dyn std::error::Error>>,
) -> ExitCode {
    let args = match args {
        Ok(Some(args)) => args,
        Ok(None) => {
            println!("{help}");
            return ExitCode::SUCCESS;
        }
        Err(error) => {
            eprintln!("{program}: {error}\nTry --help.");
            return ExitCode::from(2);
        }
    };
    match run(&args) {
        Ok(complaints) if complaints.is_empty() => ExitCode::SUCCESS,
        Ok(complaints) => {
            eprintln!("\nFAILED:");
            complaints
                .iter()
                .for_each(|complaint| eprintln!("  {complaint}"));
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("{program}: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The number that follows an option; `_` may part its digits.
pub fn number<T: FromStr<Err = ParseIntError>>(
    parser: &mut Parser,
    name: &str,
) -> Result<T, Error> {
    let value = parser.value()?.string()?;
    let digits = value.replace('_', "");
    digits
        .parse()
        .map_err(|error| format!("{name} {value}: {error}").into())
}

/// The number that follows an option, from `least` to `most`.
pub fn within(parser: &mut Parser, name: &str, least: usize, most: usize) -> Result<usize, Error> {
    let value = number(parser, name)?;
    if (least..=most).contains(&value) {
        Ok(value)
    } else {
        Err(format!("{name} {value}: must lie between {least} and {most}").into())
    }
}

// What every run of an example begins with: a folder for the pictures, and a bar that shows how far it is.

/// Makes a folder where there is none.
pub fn folder(path: &Path) -> Result<(), String> {
    std::fs::create_dir_all(path).map_err(|e| format!("{}: {e}", path.display()))
}

/// A bar of this length; `count` is how the place on it is written.
pub fn progress(length: u64, count: &str) -> Result<ProgressBar, Box<dyn std::error::Error>> {
    let progress = ProgressBar::new(length);
    let template = format!("{{elapsed:>4}} [{{bar:40}}] {count} {{msg}}");
    progress.set_style(ProgressStyle::with_template(&template)?.progress_chars("=> "));
    Ok(progress)
}

/// Steps of work that take about as long as each other.
pub const STEPS: &str = "{pos}/{len}";

// Tables on the terminal, as Markdown that a README can take over.

/// A table whose columns are aligned to the right, but for so many.
pub fn print(header: &[&str], rows: Vec<Vec<String>>, left: usize) {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN);
    table.set_header(header.to_vec());
    table.add_rows(rows);
    for column in table.column_iter_mut().skip(left) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    println!("{table}\n");
}

/// A p-value, in scientific notation where it is extreme.
pub fn p_text(p: f64) -> String {
    match p {
        0.0 => "< 1e-300".into(),
        p if p < 1e-3 => format!("{p:.1e}"),
        p => format!("{p:.3}"),
    }
}
