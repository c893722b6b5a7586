//! The command line: its options and its error messages.

use crate::study::DRAWN;
use lexopt::Error;
use lexopt::prelude::*;
use std::path::PathBuf;
use support::cli::{number, within};

pub const HELP: &str = "\
Copies a picture by a chain over its pixels, records the chain in two ways, and holds the errors of the copies
to what theory says of them.

    cargo run --release --example image_copy [-- OPTIONS]

    --seed N           seed of the generators [42]; the same seed gives the same figure
    --out DIR          where the figure goes [target/image_copy]
    --most N           mutations a pixel of the longest copy, 256 to 65536 [512]; a power of two, or the one
                       below
    --repetitions N    copies behind each error, 8 to 1000 [16]
    --help             this text

The exit code is 1 if errors are not those of theory or do not fall as they should, if a black pixel is not
black, or if a chain that is wrong on purpose passes for right; it is 2 for arguments that make no sense.";

pub struct Args {
    pub seed: u64,
    pub out: PathBuf,
    pub most: u64,
    pub repetitions: u64,
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        seed: 42,
        out: PathBuf::from("target/image_copy"),
        most: 512,
        repetitions: 16,
    };
    let mut parser = lexopt::Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("out") => args.out = parser.value()?.into(),
            Long("most") => {
                args.most = within(&mut parser, "--most", DRAWN[2] as usize, 65_536)? as u64;
            }
            Long("repetitions") => {
                args.repetitions = within(&mut parser, "--repetitions", 8, 1000)? as u64;
            }
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Some(args))
}
