//! A program with one warp links nothing of another.

use crate::image::Image;
use crate::must_fail;
use microwarp_host::upkeep::Outcome;
use regex_lite::Regex;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A function, and the modules of `microwarp::warp` that are its own.
const OWN: [(&str, &[&str]); 5] = [
    ("poly_disk_pcg32", &["disk"]),
    ("poly_exponential_1_pcg32", &["exponential"]),
    ("poly_cone_pcg32", &["cone", "direction"]),
    ("poly_sphere_pcg32", &["sphere", "direction"]),
    ("poly_phong_lobe_50_pcg32", &["phong", "direction"]),
];

/// Fails for symbols of functions other than this one, and of modules of `microwarp::warp` other than its own.
fn foreign(file: &Path, function: &str, own: &[&str], functions: &BTreeSet<String>) -> Outcome {
    let names = Image::read(file)?.names;
    if !names.iter().any(|name| name == function) {
        return Err(format!(
            "{}: the check reads no symbol {function}",
            file.display()
        ));
    }
    // The modules stand readable in both of Rust's manglings, and demangled.
    let module = Regex::new(r"microwarp(?:4warp[0-9]+|(?:::|\.\.)warp(?:::|\.\.))([a-z0-9]+)")
        .map_err(|e| e.to_string())?;
    // Behind a module's name may stand digits and letters of the mangling. The methods of the trait are every warp's.
    let of_own = Regex::new(&format!("^(?:contract|{})[0-9]*[a-z]*$", own.join("|")))
        .map_err(|e| e.to_string())?;
    let mut found = BTreeSet::new();
    for name in &names {
        if name != function && functions.contains(name) {
            found.insert(name.as_str());
        }
        let modules = module.captures_iter(name).filter_map(|parts| parts.get(1));
        found.extend(
            modules
                .map(|part| part.as_str())
                .filter(|part| !of_own.is_match(part)),
        );
    }
    if found.is_empty() {
        Ok(())
    } else {
        Err(format!("{function} links: {found:?}"))
    }
}

pub fn check(target: &str, place: &Path) -> Outcome {
    let directory = place.join(target);
    let files = fs::read_dir(&directory).map_err(|e| format!("{}: {e}", directory.display()))?;
    let functions: BTreeSet<String> = files
        .map(|file| file.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    for (function, own) in OWN {
        foreign(&directory.join(function), function, own, &functions)?;
    }
    let two = foreign(
        &place.join(format!("{target}.two")),
        "poly_disk_pcg32",
        &["disk"],
        &functions,
    );
    must_fail(
        &format!("a program of two warps on {target}"),
        "poly_sphere",
        two,
    )?;
    println!("{target}: one warp links nothing of another");
    Ok(())
}
