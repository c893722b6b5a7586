//! The command line: its options and its error messages.

use lexopt::Error;
use lexopt::prelude::*;
use std::path::PathBuf;
use support::cli::{number, within};

pub const HELP: &str = "\
Runs chains with three mutations over a density of two humps, draws their histograms, and holds acceptance,
autocorrelation and crossings to what linear algebra says of them.

    cargo run --release --example mutations [-- OPTIONS]

    --seed N           seed of the generators [42]; the same seed gives the same picture
    --out DIR          where the picture goes [target/mutations]
    --relaxations N    length of the runs that are held to the truth, in relaxation times of their mutation,
                       1000 to 100000 [3000]; at least 2000000 steps
    --help             this text

The exit code is 1 if a measured figure is not the true one, if a chain that should have converged has not, or
if what is wrong on purpose or too short passes for right; it is 2 for arguments that make no sense.";

pub struct Args {
    pub seed: u64,
    pub out: PathBuf,
    pub relaxations: u64,
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        seed: 42,
        out: PathBuf::from("target/mutations"),
        relaxations: 3000,
    };
    let mut parser = lexopt::Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("out") => args.out = parser.value()?.into(),
            Long("relaxations") => {
                args.relaxations = within(&mut parser, "--relaxations", 1000, 100_000)? as u64;
            }
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Some(args))
}
