//! The command line: its options and its error messages.

use host::cli::{number, within};
use lexopt::prelude::*;
use lexopt::{Error, Parser};
use std::path::PathBuf;

pub const HELP: &str = "\
Draws every warp of microwarp in both tiers, checks the samples against the density and prints a table.

    cargo run --release --example gallery [-- OPTIONS]

    --seed N       seed of the generator [42]; the same seed gives the same pictures
    --out DIR      where the pictures go [target/gallery]
    --sheet FILE   where the contact sheet goes [DIR/gallery.png]
    --rustdoc DIR  where small pictures for the documentation go, as HTML [none]
    --room PNG     a picture of the path tracer's room, beside which a banner of twelve warps goes to DIR/banner.png
    --samples N    samples of each warp and tier for the table, 100000 to 100000000 [1000000]
    --points N     points drawn in a picture, 10 to 100000 [800]
    --only TEXT    only warps whose name contains TEXT; makes no contact sheet
    --threads N    threads at work [one a core]
    --help         this text

The exit code is 1 if a p-value is below 1e-9, if a sample lies where the density is 0, or if a warp of
the registry has no picture; it is 2 for arguments that make no sense.";

#[derive(Clone)]
pub struct Args {
    pub seed: u64,
    pub out: PathBuf,
    pub sheet: Option<PathBuf>,
    pub rustdoc: Option<PathBuf>,
    pub room: Option<PathBuf>,
    pub samples: usize,
    pub points: usize,
    pub only: Option<String>,
    pub threads: usize,
}

impl Args {
    /// Whether a warp of this name is asked for.
    pub fn wants(&self, name: &str) -> bool {
        self.only
            .as_ref()
            .is_none_or(|text| name.to_lowercase().contains(text))
    }
}

impl Default for Args {
    fn default() -> Self {
        Self {
            seed: 42,
            out: PathBuf::from("target/gallery"),
            sheet: None,
            rustdoc: None,
            room: None,
            samples: 1_000_000,
            points: 800,
            only: None,
            threads: std::thread::available_parallelism().map_or(1, usize::from),
        }
    }
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args::default();
    let mut parser = Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("out") => args.out = parser.value()?.into(),
            Long("sheet") => args.sheet = Some(parser.value()?.into()),
            Long("rustdoc") => args.rustdoc = Some(parser.value()?.into()),
            Long("room") => args.room = Some(parser.value()?.into()),
            Long("samples") => {
                args.samples = within(&mut parser, "--samples", 100_000, 100_000_000)?
            }
            Long("points") => args.points = within(&mut parser, "--points", 10, 100_000)?,
            Long("only") => args.only = Some(parser.value()?.string()?.to_lowercase()),
            Long("threads") => args.threads = within(&mut parser, "--threads", 1, 256)?,
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Some(args))
}
