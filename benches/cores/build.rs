//! Leaves one kernel in the archive, the one named in `CORES_KERNEL`; without it all of them are checked.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=CORES_KERNEL");
    if let Ok(name) = std::env::var("CORES_KERNEL") {
        println!("cargo:rustc-cfg=one_kernel");
        println!("cargo:rustc-cfg=kernel=\"{name}\"");
    }
}
