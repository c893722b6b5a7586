//! Prints a part of the C interface: `capi headers`, `capi layout`, `capi golden`,
//! `capi hostile`.

use microwarp_host::upkeep::{Outcome, capi, end};
use std::process::ExitCode;

fn main() -> ExitCode {
    end(run())
}

fn run() -> Outcome {
    let part = std::env::args().nth(1).unwrap_or_default();
    let text = match part.as_str() {
        "headers" => capi::headers()?.concat(),
        "layout" => capi::layout(),
        "golden" => capi::golden(),
        "hostile" => capi::hostile()?,
        _ => return Err("name a part: headers, layout, golden or hostile".into()),
    };
    print!("{text}");
    Ok(())
}
