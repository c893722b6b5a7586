//! What C programs link: bindings/c/tests/sizes/link and examples/firmware-c/check have put them under target/c.
//!
//! Nothing that a small core lacks is brought in; a function that draws costs no more than its counterpart in Rust, as
//! docs/measured/counts.csv has it; and programs of one sampler are as bindings/c/tests/sizes/sizes.csv says.

use crate::forbidden::{self, Kind, Kind::*};
use crate::image::Image;
use crate::must_fail;
use crate::sizes::recorded;
use crate::sizes::{self, Row, compare};
use microwarp_host::counts::{Counts, FILE as OF_RUST};
use microwarp_host::upkeep::{Outcome, read, write};
use regex_lite::Regex;
use std::fs;
use std::path::Path;

const RECORD: &str = "bindings/c/tests/sizes/sizes.csv";
const TITLES: [&str; 2] = ["bytes of the function alone", "bytes of the program"];
const FLOATS: [&str; 5] = ["disk", "exponential", "normal_pair", "phong_lobe", "cdf"];
const INTEGERS: [&str; 2] = ["fixed_disk", "fixed_exponential"];
/// By how many bytes a function in C may be larger.
const MORE: u64 = 72;
/// Functions that are smaller in Rust: their parameters are constants there, which the compiler has folded into less code than their
/// warp has, or, of a rectangle, nothing else calls what several functions of the archive call. With floats, and in the integer tier.
const SMALLER: [&[&str]; 2] = [
    &[
        "annulus",
        "gamma",
        "linear",
        "spherical_rectangle",
        "student_pair",
        "student_t",
    ],
    &[
        "annulus",
        "bilinear",
        "cone",
        "henyey_greenstein",
        "normal_pair",
        "phong_lobe",
    ],
];

fn nothing_forbidden(target_name: &str, directory: &Path) -> Outcome {
    let sizes = directory.join("sizes");
    for (control, kind) in [("F64", F64), ("ALLOC", Alloc), ("PANIC", Panic)] {
        forbidden::caught(&sizes.join(format!("control_{control}")), "main", kind)?;
    }
    if !target_name.ends_with("hf") {
        forbidden::caught(&sizes.join("control_F64"), "main", F32)?;
    }
    forbidden::clean(&directory.join("golden"), "main", &[Panic, Alloc, F64])?;
    let of = |programs: &[&str], kinds: &[Kind]| -> Outcome {
        for program in programs {
            forbidden::clean(&sizes.join(format!("program_{program}")), "main", kinds)?;
        }
        Ok(())
    };
    of(&FLOATS, &[Panic, Alloc, F64])?;
    of(&INTEGERS, &[Panic, Alloc, F64, F32])
}

/// The size of a function in Rust of the same name, with or without numbers behind it.
fn counterpart(function: &str, target_name: &str, rust: &[Row]) -> Outcome<Option<u64>> {
    let name = function.trim_start_matches("mw_").trim_end_matches("_draw");
    let (tier, warp) = match name.split_once('_') {
        Some(("fixed", warp)) => ("fine", warp),
        Some((grade @ ("coarse" | "compact"), warp)) => (grade, warp),
        _ => ("poly", name),
    };
    if SMALLER[usize::from(tier != "poly")].contains(&warp) {
        return Ok(None);
    }
    let pattern = format!(r"^{tier}_{warp}(_\d+)*_pcg32,{target_name}$");
    let pattern = Regex::new(&pattern).map_err(|e| e.to_string())?;
    let found = rust.iter().find(|(name, _)| pattern.is_match(name));
    Ok(found.map(|(_, [bytes, _])| *bytes))
}

/// Every function alone, beside that of Rust.
fn functions(target_name: &str, directory: &Path, rust: &[Row], more: u64) -> Outcome {
    let files = fs::read_dir(directory).map_err(|e| format!("{}: {e}", directory.display()))?;
    let (mut compared, mut all, mut largest, mut failures) = (0, 0, 0, String::new());
    for file in files {
        let function = file.unwrap().file_name().to_string_lossy().into_owned();
        if !function.starts_with("mw_") {
            continue;
        }
        all += 1;
        let Some(in_rust) = counterpart(&function, target_name, rust)? else {
            continue;
        };
        compared += 1;
        let (bytes, _) = Image::read(&directory.join(&function))?.size();
        largest = largest.max(bytes.saturating_sub(in_rust));
        if bytes > in_rust + more {
            failures += &format!("\nLARGER: {function},{target_name}: {bytes}, in Rust {in_rust}");
        }
    }
    if compared * 2 < all || compared == 0 {
        return Err(format!(
            "{target_name}: {compared} of {all} functions have a counterpart"
        ));
    }
    println!("{target_name}: {compared} of {all} functions compared, {largest} bytes more at most");
    match failures.is_empty() {
        true => Ok(()),
        false => Err(failures),
    }
}

fn programs(target_name: &str, directory: &Path) -> Outcome<Vec<Row>> {
    let bytes = |file: String| Image::read(&directory.join(file)).map(|image| image.size().0);
    let programs = FLOATS.iter().chain(&INTEGERS);
    programs
        .map(|program| {
            let name = format!("{program},{target_name}");
            let alone = bytes(match *program {
                "cdf" => "mw_cdf_draw_index".into(),
                warp => format!("mw_{warp}_draw"),
            })?;
            Ok((name, [alone, bytes(format!("program_{program}"))?]))
        })
        .collect()
}

/// Each target with its compiler, as TARGET=COMPILER; those that are no core of counts.csv are read for symbols only.
pub fn check(targets: &[&str], writes: bool) -> Outcome {
    forbidden::control()?;
    sizes::control(TITLES)?;
    let counts = Counts::read()?;
    let (mut text, mut rows, mut same) = (String::new(), Vec::new(), true);
    for target in targets {
        let (name, compiler) = target.split_once('=').ok_or("TARGET=COMPILER")?;
        let directory = crate::target("c").join(name);
        nothing_forbidden(name, &directory)?;
        if crate::core(name).is_err() {
            continue;
        }
        let rust = recorded(&counts, name)?;
        let sizes = directory.join("sizes");
        let head = format!("# {name}: {compiler}");
        // Another compiler makes other sizes.
        if counts.comments.contains(&head) {
            functions(name, &sizes, &rust, MORE)?;
            must_fail(
                &format!("any function that is larger on {name}"),
                "LARGER",
                functions(name, &sizes, &rust, 0),
            )?;
        } else {
            println!("*** {head}; {OF_RUST} is of another, so functions are not compared");
            same = false;
        }
        text += &format!("{head}\n");
        rows.extend(programs(name, &sizes)?);
    }
    if writes {
        text += "program,target,alone,program\n";
        for (name, [alone, program]) in &rows {
            text += &format!("{name},{alone},{program}\n");
        }
        write(RECORD, &text)?;
    }
    let recorded = sizes::parse(&read(RECORD)?)?;
    compare(&recorded, &rows, TITLES, if same { 3 } else { 15 }, false)?;
    println!(
        "flash of {} programs is as recorded in {RECORD}",
        rows.len()
    );
    Ok(())
}
