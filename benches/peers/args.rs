//! The command line: its options and its error messages.

use host::cli::within;
use lexopt::Error;
use lexopt::prelude::*;
use std::path::PathBuf;

pub const HELP: &str = "\
Times every sampler beside its peers, in interleaved rounds, and prints nanoseconds a sample and the ratios within
a round: medians, and quartiles in brackets.

    cargo bench --bench peers [-- [OPTIONS] [TEXT]...]

    TEXT           only families whose name contains one of these: disk, circle, sphere, hemisphere,
                   cosine hemisphere, lobe, exponential, normal, ball, a law, cdf of 8, alias of 8, lamp, cone
    --rounds N     rounds of a family, 2 to 100000 [1000]
    --quick        60 rounds, as also under `cargo test --benches`
    --markdown     two tables for docs/peers.md in place of the tables of every family
    --out DIR      where peers.csv goes [target/peers]
    --bench        says that cargo bench is at work
    --help         this text";

/// Rounds of a run that is to end soon.
const QUICK: usize = 60;

pub struct Args {
    pub only: Vec<String>,
    pub rounds: usize,
    pub markdown: bool,
    pub out: PathBuf,
}

impl Args {
    /// Whether a family of this name is asked for.
    pub fn wants(&self, name: &str) -> bool {
        let name = name.to_lowercase();
        self.only.is_empty() || self.only.iter().any(|text| name.contains(text.as_str()))
    }
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        only: Vec::new(),
        rounds: 1000,
        markdown: false,
        out: PathBuf::from("target/peers"),
    };
    let (mut benching, mut chosen) = (false, None);
    let mut parser = lexopt::Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Value(text) => args.only.push(text.string()?.to_lowercase()),
            Long("rounds") => chosen = Some(within(&mut parser, "--rounds", 2, 100_000)?),
            Long("quick") => chosen = Some(QUICK),
            Long("markdown") => args.markdown = true,
            Long("out") => args.out = parser.value()?.into(),
            Long("bench") => benching = true,
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    args.rounds = chosen.unwrap_or(if benching { args.rounds } else { QUICK });
    Ok(Some(args))
}
