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
                   cosine hemisphere, lobe, exponential, normal, ball, a law, cdf of 8, alias of 8, lamp, cone, filter
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

// The names of contestants, the same in all contests.

/// The words that the map of the family takes, and nothing made of them.
pub const FLOOR: &str = "generator alone";
pub const LIBM: &str = "libm";
pub const POLY: &str = "poly";
pub const FINE: &str = "fixed, in f32";
pub const COARSE: &str = "fixed::coarse, in f32";
pub const COMPACT: &str = "fixed::compact, in f32";
pub const REJECTION: &str = "rejection";
pub const RAND_DISTR: &str = "rand_distr";
pub const MICROMATH: &str = "micromath";
pub const TEXTBOOK: &str = "plain libm";
/// The maps that renderers write by hand, in `f32` over std.
pub const PUBLISHED: &str = "published form";
/// Of normals, which the tiers draw in pairs: one at a time.
pub const LIBM_SINGLE: &str = "libm, one at a time";
pub const POLY_SINGLE: &str = "poly, one at a time";
/// Of slices, which the tiers fill: one point after the other.
pub const DRAWN: &str = "poly, one by one";
/// Of tables, which have no tier: the index alone, and the index with its probability and the leftover uniform.
pub const INDEX: &str = "index";
pub const SELECTION: &str = "index, pmf, leftover";
/// Of integers, by two words in place of one; of orders, by a word an item.
pub const WIDE: &str = "by two words";
pub const EACH: &str = "a word an item";
