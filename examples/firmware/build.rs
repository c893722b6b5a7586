//! Gives the linker the memory of the target's board, and the scripts of cortex-m-rt and defmt.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=memory");
    // defmt leaves out of the program what is below this level, and by itself all but errors.
    println!("cargo:rerun-if-env-changed=DEFMT_LOG");
    let level = env::var("DEFMT_LOG").unwrap_or_else(|_| "info".into());
    println!("cargo:rustc-env=DEFMT_LOG={level}");
    // The host, where this package is checked as code, has a layout of its own.
    if env::var("CARGO_CFG_TARGET_OS").as_deref() != Ok("none") {
        return;
    }
    let variable = |name: &str| env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"));
    let target = variable("TARGET");
    let core = target.split('-').next().unwrap_or_default();
    let memory = PathBuf::from(variable("CARGO_MANIFEST_DIR")).join(format!("memory/{core}.x"));
    let out = PathBuf::from(variable("OUT_DIR"));
    fs::copy(&memory, out.join("memory.x"))
        .unwrap_or_else(|error| panic!("{target} needs {}: {error}", memory.display()));
    println!("cargo:rustc-link-search={}", out.display());
    // `rust-lld`, `ld.lld` and `arm-none-eabi-ld` all take these.
    for argument in ["--nmagic", "--gc-sections", "-Tlink.x", "-Tdefmt.x"] {
        println!("cargo:rustc-link-arg-bins={argument}");
    }
}
