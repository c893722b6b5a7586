//! The command line: its options and its error messages.

use crate::render::PointSet;
use host::cli::{number, within};
use lexopt::Error;
use lexopt::prelude::*;
use std::path::PathBuf;

pub const HELP: &str = "\
Renders six scenes by path tracing, and measures the error of small pictures of them by tier and by point set, and of
Metropolis light transport on the two that are hard.

    cargo run --release --example scene [-- OPTIONS]

    --seed N         seed of the points [42]; the same seed gives the same pictures
    --out DIR        where the pictures go [target/scene]
    --width N        columns of the pictures, 48 to 1920 [144]; rows are two thirds of them
    --samples N      samples a pixel of the pictures, 1 to 65536 [64]
    --screen         one set of points for all pixels of the pictures, in an order by which the errors of neighbours
                     cancel: for direct light, a filter or a screen behind; samples should be a power of two
    --reference N    samples a pixel that errors are measured against, 256 to 1048576 [1024]
    --pictures       instead: the pictures alone, hard scenes with more samples, and their sheet
    --accuracy       instead: how much accuracy each scene needs, against a twin in f64
    --paths N        paths of a pixel for that, 256 to 65536 [256]
    --help           this text

The exit code is 1 if a pixel is not a number, if a picture is brighter or darker than its reference, if Sobol'
points are not better than random ones, if chains do not have 30 % less error at equal time, if the tiers do not
agree, if a renderer that is wrong on purpose passes, or if an error of 4 % does not show; it is 2 for arguments that
make no sense.";

pub struct Args {
    pub seed: u32,
    pub out: PathBuf,
    pub size: [u32; 2],
    pub samples: u32,
    /// Those of the pictures.
    pub points: PointSet,
    pub reference: u32,
    pub pictures: bool,
    pub accuracy: bool,
    pub paths: u32,
}

/// The parsed command line; `None` for help.
pub fn parse() -> Result<Option<Args>, Error> {
    let mut args = Args {
        seed: 42,
        out: PathBuf::from("target/scene"),
        size: [144, 96],
        samples: 64,
        points: PointSet::Sobol,
        reference: 1024,
        pictures: false,
        accuracy: false,
        paths: 256,
    };
    let mut parser = lexopt::Parser::from_env();
    while let Some(arg) = parser.next()? {
        match arg {
            Long("seed") => args.seed = number(&mut parser, "--seed")?,
            Long("out") => args.out = parser.value()?.into(),
            Long("width") => {
                let width = within(&mut parser, "--width", 48, 1920)? as u32;
                args.size = [width, width * 2 / 3];
            }
            Long("samples") => args.samples = within(&mut parser, "--samples", 1, 65_536)? as u32,
            Long("screen") => args.points = PointSet::Screen,
            Long("reference") => {
                args.reference = within(&mut parser, "--reference", 256, 1_048_576)? as u32;
            }
            Long("pictures") => args.pictures = true,
            Long("accuracy") => args.accuracy = true,
            Long("paths") => args.paths = within(&mut parser, "--paths", 256, 65_536)? as u32,
            Short('h') | Long("help") => return Ok(None),
            _ => return Err(arg.unexpected()),
        }
    }
    Ok(Some(args))
}
