//! Prints a part of the C interface: `capi header`, `capi layout`, `capi golden`.

use microwarp_upkeep::{Outcome, capi, end};
use std::process::ExitCode;

fn main() -> ExitCode {
    end(run())
}

fn run() -> Outcome {
    let part = std::env::args().nth(1).unwrap_or_default();
    let text = match part.as_str() {
        "header" => capi::header()?,
        "layout" => capi::layout(),
        "golden" => capi::golden(),
        _ => return Err("name a part: header, layout or golden".into()),
    };
    print!("{text}");
    Ok(())
}
