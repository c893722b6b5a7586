//! A path of light links what its scene is made of, and nothing of another ingredient.

use crate::image::Image;
use crate::must_fail;
use microwarp_host::upkeep::Outcome;
use regex_lite::Regex;
use std::fs;
use std::path::Path;

/// The kernels' names begin so.
const PATHS: &str = "poly_path_";

/// What the names of an ingredient's functions have in them, and the paths that have it. Each must be seen where it is:
/// otherwise it would prove nothing where it is not. (The materials of `slivers` are of the type that can be any of three.)
#[rustfmt::skip]
const INGREDIENTS: [(&str, &[&str]); 9] = [
    ("regular_polygon", &["with_lens", "with_metropolis", "room", "fog", "slivers", "slit", "sensor"]),
    ("spherical_rectangle", &["plain", "with_lens", "with_metropolis", "with_glossy", "with_ggx", "with_fog", "with_sky", "with_sobol", "room", "slit"]),
    ("visible_sphere", &["with_sphere", "fog", "sensor"]),
    ("phong_lobe", &["with_glossy", "fog", "slivers"]),
    ("ggx", &["with_ggx", "fog", "slivers"]),
    ("henyey|equi_angular|truncated", &["with_fog", "fog", "sensor"]),
    ("lat_long", &["with_sky", "slivers"]),
    ("sobol|Owen", &["with_sobol"]),
    ("metropolis", &["with_metropolis"]),
];

/// Fails where a file, as the path of this name, has an ingredient too many or too few.
fn hold(file: &Path, path: &str) -> Outcome {
    let names = Image::read(file)?.names;
    let mut wrong = Vec::new();
    for (pattern, with) in INGREDIENTS {
        // In both of Rust's manglings, and demangled.
        let modules = format!("microwarp(?:_scene)?(?:[0-9]+|::|\\.\\.)[a-z0-9_:.]*(?:{pattern})");
        let modules = Regex::new(&modules).map_err(|e| e.to_string())?;
        let found = names.iter().find(|name| modules.is_match(name));
        match (found, with.contains(&path)) {
            (Some(name), false) => wrong.push(format!("{path} links {pattern}: {name}")),
            (None, true) => wrong.push(format!("{path} links no {pattern}: nothing is seen")),
            _ => {}
        }
    }
    if wrong.is_empty() {
        Ok(())
    } else {
        Err(wrong.join("\n"))
    }
}

pub fn check(target: &str, place: &Path) -> Outcome {
    let directory = place.join(target);
    let files = fs::read_dir(&directory).map_err(|e| format!("{}: {e}", directory.display()))?;
    let names = files.map(|file| file.unwrap().file_name().to_string_lossy().into_owned());
    let paths: Vec<String> = names
        .filter_map(|name| name.strip_prefix(PATHS).map(String::from))
        .collect();
    let file = |path: &str| directory.join(format!("{PATHS}{path}"));
    for path in &paths {
        hold(&file(path), path)?;
    }
    for (pattern, with) in INGREDIENTS {
        // The one of these two that does not have it.
        let other = ["plain", "with_sphere"]
            .into_iter()
            .find(|other| !with.contains(other));
        let wrong = hold(&file(with[0]), other.unwrap_or_default());
        must_fail(
            &format!("{} as a path without it on {target}", with[0]),
            pattern,
            wrong,
        )?;
    }
    println!(
        "{target}: {} paths of light, each with its ingredients alone",
        paths.len()
    );
    Ok(())
}
