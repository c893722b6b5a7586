//! What a function costs as WASM, for `crates/cores/run`: counts the operators that it executes, and reads the sizes of its
//! module.
//!
//! `count IMAGE` runs the harness in the image and prints the eight words that it prints on a Cortex-M, `sizes
//! MODULE` the bytes of a module without its data, and those of the data.

mod count;
mod instrument;
mod sizes;

use count::measure;
use sizes::sizes;
use std::process::ExitCode;

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
