//! What the command lines of the examples have in common: how a run ends, and how numbers are read.

use lexopt::{Error, Parser, ValueExt};
use std::num::ParseIntError;
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
