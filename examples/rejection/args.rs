//! The command line: its options and its error messages.

use lexopt::Error;
use lexopt::prelude::*;
use std::path::PathBuf;
use support::cli::{number, within};

pub const HELP: &str = "\
Draws accepted and rejected points, and measures efficiencies beside the exact ones.

    cargo run --release --example rejection [-- OPTIONS]

    --seed N       seed of the generator [42]; the same seed gives the same pictures
    --out DIR      where the pictures go [target/rejection]
    --points N     accepted points of each sampler, 1000 to 100000000 [1000000]
    --shown N      proposals shown in a picture, 10 to 100000 [4000]
    --help         this text

The exit code is 1 if a measured efficiency is off by more than six standard errors; it is 2 for
arguments that make no sense.";

pub struct Args {
    pub seed: u64,
    pub out: PathBuf,
    pub points: usize,
    pub shown: usize,
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        seed: 42,
        out: PathBuf::from("target/rejection"),
        points: 1_000_000,
        shown: 4000,
    };
    let mut parser = lexopt::Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("out") => args.out = parser.value()?.into(),
            Long("points") => {
                args.points = within(&mut parser, "--points", 1000, 100_000_000)?;
            }
            Long("shown") => {
                args.shown = within(&mut parser, "--shown", 10, 100_000)?;
            }
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Some(args))
}
