//! The command line: its options and its error messages.

use host::cli::{number, within};
use lexopt::prelude::*;
use lexopt::{Error, Parser};
use std::path::PathBuf;

pub const HELP: &str = "\
Measures what every sampler of microwarp gives and what it costs, beside those of rand_distr, micromath and plain
libm, and draws error against cost on the host, on two microcontrollers and in WASM.

    cargo run --release --example tradeoff [-- OPTIONS]

    --seed N       seed of the generators [42]
    --out DIR      where tables and pictures go [target/tradeoff]
    --samples N    samples of each test of distribution, 100000 to 100000000 [1000000]
    --rounds N     rounds of the contest by the clock, 8 to 10000 [200]
    --only TEXT    only samplers whose family or name contains TEXT
    --quick        a tenth of everything: for a first look
    --threads N    threads that measure errors [one a core]; the clock has the machine to itself
    --help         this text

The exit code is 1 if an error exceeds its documented bound, if samples do not follow their distribution, if a
sampler of the registry is missing, or if a map that is wrong on purpose passes; it is 2 for arguments that
make no sense.";

pub struct Args {
    pub seed: u64,
    pub out: PathBuf,
    pub samples: usize,
    pub rounds: usize,
    pub only: Option<String>,
    pub quick: bool,
    pub threads: usize,
}

impl Args {
    /// Whether the options select a sampler of this family and name.
    pub fn wants(&self, family: &str, name: &str) -> bool {
        let has =
            |text: &str| family.to_lowercase().contains(text) || name.to_lowercase().contains(text);
        self.only.as_deref().is_none_or(has)
    }

    /// Of a number for a thorough look, as many as are asked for.
    pub fn share(&self, thorough: usize) -> usize {
        if self.quick { thorough / 10 } else { thorough }
    }
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        seed: 42,
        out: PathBuf::from("target/tradeoff"),
        samples: 1_000_000,
        rounds: 200,
        only: None,
        quick: false,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
    };
    let (mut samples, mut rounds) = (None, None);
    let mut parser = Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("out") => args.out = parser.value()?.into(),
            Long("samples") => {
                samples = Some(within(&mut parser, "--samples", 100_000, 100_000_000)?);
            }
            Long("rounds") => rounds = Some(within(&mut parser, "--rounds", 8, 10_000)?),
            Long("only") => args.only = Some(parser.value()?.string()?.to_lowercase()),
            Long("quick") => args.quick = true,
            Long("threads") => args.threads = within(&mut parser, "--threads", 1, 256)?,
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    args.samples = samples.unwrap_or(args.share(args.samples));
    args.rounds = rounds.unwrap_or(args.share(args.rounds));
    Ok(Some(args))
}
