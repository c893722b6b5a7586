//! Hands the linker script to the linker, by a path that holds wherever cargo is started.

fn main() {
    let here = std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR");
    println!("cargo:rerun-if-changed=link.ld");
    println!("cargo:rerun-if-changed=build.rs");
    // The host, where clippy looks at this package, has a linker layout of its own.
    if std::env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("none") {
        println!("cargo:rustc-link-arg-bins=-T{here}/link.ld");
        // `ld.lld` and `arm-none-eabi-ld` both know it; it gives `.text` of the used functions only.
        println!("cargo:rustc-link-arg-bins=--gc-sections");
    }
}
