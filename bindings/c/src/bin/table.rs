//! Writes a table of weights as constants in C, laid out as the library would at run time: `table --help`.

use core_crate::discrete::{Alias, AliasEntry, Cdf, PiecewiseConstant2d};
use core_crate::poly::LatLongMap;
use lexopt::prelude::*;
use std::fmt::Write;
use std::process::ExitCode;

const HELP: &str = "\
table [OPTIONS] WEIGHTS NAME

Reads weights from a file, separated by commas, spaces or lines, and prints constants for C.

    --alias    bins and a handle for mw_alias_*; without it, words and a handle for mw_cdf_*
    --grid     a line of the file is a row: words for mw_piecewise_constant_2d_init_trusted
    --sky      a line is a row of a picture of the sphere: words for mw_lat_long_map_init_trusted";

#[derive(Clone, Copy)]
enum Kind {
    Cdf,
    Alias,
    Grid,
    Sky,
}

fn main() -> ExitCode {
    match run() {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("table: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<String, Box<dyn std::error::Error>> {
    let (mut kind, mut places) = (Kind::Cdf, Vec::new());
    let mut parser = lexopt::Parser::from_env();
    while let Some(argument) = parser.next()? {
        match argument {
            Long("alias") => kind = Kind::Alias,
            Long("grid") => kind = Kind::Grid,
            Long("sky") => kind = Kind::Sky,
            Long("help") => return Ok(HELP.into()),
            Value(place) => places.push(place.string()?),
            other => return Err(other.unexpected().into()),
        }
    }
    let [path, name] = &places[..] else {
        return Err(HELP.into());
    };
    let letters = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if !name.chars().all(letters)
        || name.starts_with(|c: char| c.is_ascii_digit())
        || name.is_empty()
    {
        return Err(format!("{name:?} is no name in C").into());
    }
    let text = std::fs::read_to_string(path).map_err(|e| format!("{path}: {e}"))?;
    let rows = read(&text)?;
    let weights = rows.concat();
    let table = match kind {
        Kind::Cdf => cdf(&weights, name),
        Kind::Alias => alias(&weights, name),
        Kind::Grid | Kind::Sky => {
            let columns = rows.first().map_or(0, Vec::len);
            if let Some(i) = rows.iter().position(|row| row.len() != columns) {
                return Err(
                    format!("row {} has {} weights, not {columns}", i + 1, rows[i].len()).into(),
                );
            }
            grid(
                &weights,
                [columns, rows.len()],
                name,
                matches!(kind, Kind::Sky),
            )
        }
    };
    let table = table.map_err(|e| format!("{path}: {e}"))?;
    Ok(format!(
        "/* Written by microwarp's table from {path}. */\n#include \"microwarp.h\"\n\n{table}"
    )
    .trim_end()
    .into())
}

/// The weights of each line that has some.
fn read(text: &str) -> Result<Vec<Vec<f32>>, String> {
    let number = |word: &str| word.parse().map_err(|_| format!("{word:?} is no number"));
    let separator = |c: char| c == ',' || c == ';' || c.is_whitespace();
    let row = |line: &str| -> Result<Vec<f32>, String> {
        line.split(separator)
            .filter(|word| !word.is_empty())
            .map(number)
            .collect()
    };
    let rows: Result<Vec<_>, _> = text.lines().map(row).collect();
    Ok(rows?.into_iter().filter(|row| !row.is_empty()).collect())
}

fn cdf(weights: &[f32], name: &str) -> Result<String, core_crate::Error> {
    let mut words = vec![0; weights.len()];
    Cdf::<&[u32]>::new_in(weights, &mut words)?;
    let words = array(
        "uint32_t",
        &format!("{name}_words"),
        words.iter().map(|word| format!("0x{word:08x}")),
    );
    Ok(format!(
        "{words}\nstatic const mw_cdf {name} = MW_CDF({name}_words);\n"
    ))
}

fn alias(weights: &[f32], name: &str) -> Result<String, core_crate::Error> {
    let mut bins = vec![AliasEntry::EMPTY; weights.len().next_power_of_two()];
    Alias::<&[AliasEntry<u32>]>::new_in(weights, &mut bins)?;
    let bins = bins.iter().map(|bin| {
        format!(
            "{{0x{:08x}, 0x{:08x}, {}}}",
            bin.threshold(),
            bin.numerator(),
            bin.alias()
        )
    });
    let bins = array("mw_alias_bin", &format!("{name}_bins"), bins);
    Ok(format!(
        "{bins}\nstatic const mw_alias {name} = {{{name}_bins, {}}};\n",
        weights.len()
    ))
}

fn grid(
    weights: &[f32],
    shape: [usize; 2],
    name: &str,
    sky: bool,
) -> Result<String, core_crate::Error> {
    let [columns, rows] = shape;
    let (mut marginal, mut conditional) = (vec![0_u32; rows], vec![0_u32; weights.len()]);
    if sky {
        LatLongMap::<&[u32], &[u32]>::new_in(weights, shape, &mut marginal, &mut conditional)?;
    } else {
        let unit = [0.0, 1.0];
        PiecewiseConstant2d::new_in(weights, shape, unit, unit, &mut marginal, &mut conditional)?;
    }
    let words = |part: &str, words: &[u32]| {
        array(
            "uint32_t",
            &format!("{name}_{part}"),
            words.iter().map(|word| format!("0x{word:08x}")),
        )
    };
    Ok(format!(
        "enum {{ {name}_columns = {columns}, {name}_rows = {rows} }};\n{}\n{}",
        words("marginal", &marginal),
        words("conditional", &conditional),
    ))
}

fn array(of: &str, name: &str, entries: impl ExactSizeIterator<Item = String>) -> String {
    let mut text = format!("static const {of} {name}[{}] = {{", entries.len());
    let mut room = 0;
    for entry in entries {
        if entry.len() + 2 > room {
            text.push_str("\n    ");
            room = 96;
        } else {
            text.push(' ');
        }
        room = room.saturating_sub(entry.len() + 2);
        write!(text, "{entry},").expect("a text can be written to");
    }
    text + "\n};\n"
}
