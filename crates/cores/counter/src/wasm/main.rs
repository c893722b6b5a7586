//! What a function costs as WASM, for `crates/cores/run`: counts the operators that it executes, and reads the sizes of its
//! module.
//!
//! `count IMAGE` runs the harness in the image and prints the eight words that it prints on a Cortex-M, `sizes
//! MODULE` the bytes of a module without its data, and those of the data.

mod count;
mod instrument;

use count::measure;
use std::process::ExitCode;
use wasmparser::{Parser, Payload};

/// Any error, for display.
type Failure = Box<dyn std::error::Error>;

fn answer() -> Result<String, Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [what, file] = arguments.as_slice() else {
        return Err("usage: count IMAGE | sizes MODULE".into());
    };
    let module = std::fs::read(file)?;
    match what.as_str() {
        "count" => measure(&module),
        "sizes" => sizes(&module),
        _ => Err(format!("no command {what}").into()),
    }
}

/// The bytes of a module without those of its data, and those. Names and other notes, which nothing reads at run
/// time, are left out.
fn sizes(module: &[u8]) -> Result<String, Failure> {
    let (mut notes, mut data) = (0, 0);
    for payload in Parser::new(0).parse_all(module) {
        match payload? {
            Payload::CustomSection(note) => {
                // Its kind and its size come before it.
                let size = note.range().len();
                let digits = size.max(1).ilog2() as usize / 7 + 1;
                notes += 1 + digits + size;
            }
            Payload::DataSection(segments) => {
                for segment in segments {
                    data += segment?.data.len();
                }
            }
            _ => {}
        }
    }
    Ok(format!("{} {data}", module.len() - notes - data))
}

fn main() -> ExitCode {
    match answer() {
        Ok(answer) => {
            println!("{answer}");
            ExitCode::SUCCESS
        }
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::FAILURE
        }
    }
}
