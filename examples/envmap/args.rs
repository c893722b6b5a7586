//! The command line: its options and its error messages.

use lexopt::prelude::*;
use lexopt::{Error, Parser};
use std::path::PathBuf;
use support::cli::{number, within};

pub const HELP: &str = "\
Turns a picture of the sky into a table, samples it, checks the samples against the picture's own
probabilities, lights a plane with it, and draws all that.

    cargo run --release --example envmap [-- OPTIONS]

    --seed N             seed of the generators [42]; the same seed gives the same figure
    --out DIR            where the figure goes [target/envmap]
    --samples N          samples of each table, 100000 to 10000000 [1000000]
    --make-picture DIR   only writes sky.png and small_weights.rs, the two generated files of this
                         example, whose place is examples/envmap
    --help               this text

The exit code is 1 if a p-value is below 1e-9, if a sample lies where the picture is black, if a table
that is wrong on purpose passes, if a Monte Carlo estimate is off, or if the picture is not the one that
--make-picture makes; it is 2 for arguments that make no sense.";

pub struct Args {
    pub seed: u64,
    pub out: PathBuf,
    pub samples: usize,
    pub make_picture: Option<PathBuf>,
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        seed: 42,
        out: PathBuf::from("target/envmap"),
        samples: 1_000_000,
        make_picture: None,
    };
    let mut parser = Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("out") => args.out = parser.value()?.into(),
            Long("samples") => {
                args.samples = within(&mut parser, "--samples", 100_000, 10_000_000)?;
            }
            Long("make-picture") => args.make_picture = Some(parser.value()?.into()),
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Some(args))
}
