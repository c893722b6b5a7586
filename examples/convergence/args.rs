//! The command line of the convergence figure.

use lexopt::prelude::*;
use lexopt::{Error, Parser};
use std::path::PathBuf;
use support::cli::{number, within};

pub const HELP: &str = "\
Draws the error of six ways to integrate against the number of evaluations, in 1, 2 and 6 dimensions, fits
the slopes and holds them to the theory.

    cargo run --release --example convergence [-- OPTIONS]

    --out DIR          where the picture goes [target/convergence]
    --seed N           seed of the generators [42]; the same seed gives the same picture
    --repetitions N    runs behind each error of a random method, 128 to 10000 [128]
    --help             this text

The exit code is 1 if a fitted slope differs from its theory by more than the tolerance that the output
states, or if it agrees with the theory of another rate as well; it is 2 for arguments that make no sense.";

/// With fewer, slopes scatter more than the tolerance of the check allows for.
const LEAST: u32 = 128;

pub struct Args {
    pub out: PathBuf,
    pub seed: u64,
    pub repetitions: u32,
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        out: PathBuf::from("target/convergence"),
        seed: 42,
        repetitions: LEAST,
    };
    let mut parser = Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("out") => args.out = parser.value()?.into(),
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("repetitions") => {
                args.repetitions =
                    within(&mut parser, "--repetitions", LEAST as usize, 10_000)? as u32;
            }
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Some(args))
}
