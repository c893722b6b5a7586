//! Reads what was linked for firmware and WASM, and fails for what must not be there or has grown. No emulator.
//!
//! ```text
//! linked probe DIRECTORY...             the programs of crates/cores, in the directory of each target
//! linked sizes [--write] TARGET=COMPILER...    in target/sizes: see .ci/sizes
//! linked constant [--write] TARGET...   in target/sizes: which functions execute the same for every input
//! linked firmware [--write] COMPILER    in target/firmware: see examples/firmware/check
//! linked c [--write] TARGET=COMPILER...    in target/c: see bindings/c/check
//! linked bytes FILE SECTION...          their bytes together
//! ```
//!
//! The scripts that link call this; each check is tried on something that it must refuse.

mod c;
mod constant;
mod firmware;
mod forbidden;
mod image;
mod ingredients;
mod one_warp;
mod probe;
mod sizes;

use microwarp_host::upkeep::{Outcome, end};
use std::env;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut args: Vec<String> = env::args().skip(1).collect();
    let write = args.iter().any(|arg| arg == "--write");
    args.retain(|arg| arg != "--write");
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    end(match &args[..] {
        ["probe", directories @ ..] if !directories.is_empty() => probe::check(directories),
        ["sizes", targets @ ..] if !targets.is_empty() => sizes::check(targets, write),
        ["constant", targets @ ..] if !targets.is_empty() => constant::check(targets, write),
        ["firmware", compiler] => firmware::check(compiler, write),
        ["c", targets @ ..] if !targets.is_empty() => c::check(targets, write),
        ["bytes", file, sections @ ..] => bytes(Path::new(file), sections),
        _ => Err(format!(
            "what to read: {args:?}? The head of linked/main.rs says"
        )),
    })
}

fn bytes(file: &Path, sections: &[&str]) -> Outcome {
    println!("{}", image::Image::read(file)?.bytes(sections));
    Ok(())
}

/// How docs/measured/counts.csv calls the core of a target.
fn core(target: &str) -> Outcome<&'static str> {
    match target {
        "thumbv6m-none-eabi" => Ok("m0"),
        "thumbv7em-none-eabihf" => Ok("m4f"),
        "wasm32-unknown-unknown" => Ok("wasm"),
        _ => Err(format!("no core has the target {target}")),
    }
}

/// A directory under that of cargo's artifacts.
fn target(directory: &str) -> PathBuf {
    let target = env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    target
        .unwrap_or_else(|| microwarp_host::upkeep::root().join("target"))
        .join(directory)
}

/// The control of a check: what is wrong is refused, and for this reason.
fn must_fail(what: &str, reason: &str, outcome: Outcome) -> Outcome {
    match outcome {
        Ok(()) => Err(format!("control: {what} was not refused")),
        Err(said) if !said.contains(reason) => Err(format!(
            "control: {what} was refused for another reason: {said}"
        )),
        Err(_) => {
            println!("control: refused, {what}");
            Ok(())
        }
    }
}
