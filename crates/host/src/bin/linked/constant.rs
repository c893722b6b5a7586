//! Functions that take the same time for all inputs stay so.
//!
//! One whose linked code decides nothing executes the same instructions for every input: that is a proof, and needs no
//! emulator. The column `constant_s` of docs/measured/counts.csv has the functions of which it holds; all code that they
//! reach is read. Between two calls at zero wait states nothing else differs either: what takes longer for some operands, a
//! division of integers, is refused too. (On a Cortex-M3 the long multiplications would be; no code for one is linked here.)

use crate::image::Image;
use crate::must_fail;
use microwarp_host::counts::Counts;
use microwarp_host::upkeep::Outcome;
use std::fs;
use std::path::Path;

const COLUMN: &str = "constant_s";

/// Of 32 bits, by its first halfword.
fn long(half: u16) -> bool {
    half >> 11 >= 0b11101
}

/// A branch that is not always taken, one to a place that is computed, or a division of integers.
fn decides(first: u16, second: u16) -> bool {
    if !long(first) {
        let condition = first >> 12 == 0xd && (first >> 8) & 15 < 14;
        let zero = first & 0xf500 == 0xb100;
        // `bx` and `blx` but for the return; `mov` and `add` into the program counter.
        let jump = first & 0xff00 == 0x4700 && first != 0x4770;
        let moved = matches!(first & 0xff87, 0x4487 | 0x4687) && first != 0x46f7;
        return condition || zero || jump || moved;
    }
    let condition = first >> 11 == 0b11110 && second & 0xd000 == 0x8000 && (first >> 6) & 14 != 14;
    let table = first & 0xfff0 == 0xe8d0 && second & 0xffe0 == 0xf000;
    let loaded = first & 0xff70 == 0xf850 && second >> 12 == 15;
    let division = first & 0xffd0 == 0xfb90;
    condition || table || loaded || division
}

/// Takes one cycle whether its condition holds or not: data processing, and sums, products and moves of the
/// floating-point unit.
fn one_cycle(first: u16, second: u16) -> bool {
    if !long(first) {
        return first < 0x4700;
    }
    let immediate = first >> 11 == 0b11110 && second >> 15 == 0;
    let root = first & 0xbf == 0xb1 && second & 0xc0 == 0xc0;
    let unit = first >> 8 == 0xee
        && second & 0x0e10 == 0x0a00
        && matches!(first & 0xb0, 0x20 | 0x30 | 0xb0)
        && !root;
    immediate || first >> 9 == 0xea00 >> 9 || unit
}

/// Whether code executes the same for every input.
fn constant(code: &[u16]) -> bool {
    let (mut rest, mut governed) = (code, 0);
    while let [first, after @ ..] = rest {
        let second = after.first().copied().unwrap_or(0);
        let predicated = governed > 0;
        if decides(*first, second) || (predicated && !one_cycle(*first, second)) {
            return false;
        }
        governed = u32::saturating_sub(governed, 1);
        // `it`: how many follow is said by the lowest bit that is set.
        if first & 0xff00 == 0xbf00 && first & 15 != 0 {
            governed = 4 - (first & 15).trailing_zeros();
        }
        rest = &rest[if long(*first) { 2.min(rest.len()) } else { 1 }..];
    }
    !code.is_empty()
}

fn is_constant(file: &Path) -> Outcome<bool> {
    Ok(constant(&Image::read(file)?.code))
}

/// The functions of a target of which it holds.
fn found(directory: &Path) -> Outcome<Vec<String>> {
    let files = fs::read_dir(directory).map_err(|e| format!("{}: {e}", directory.display()))?;
    let mut rows = Vec::new();
    for file in files {
        let file = file.map_err(|e| e.to_string())?;
        let name = file.file_name().to_string_lossy().into_owned();
        if !name.starts_with("program_") && is_constant(&file.path())? {
            rows.push(name);
        }
    }
    rows.sort();
    Ok(rows)
}

fn compare(recorded: &[String], found: &[String]) -> Outcome {
    let lost: Vec<_> = recorded.iter().filter(|row| !found.contains(row)).collect();
    for row in found.iter().filter(|row| !recorded.contains(row)) {
        println!("{row}: now executes the same for every input; --write records it");
    }
    if lost.is_empty() {
        Ok(())
    } else {
        Err(format!(
            "NO LONGER CONSTANT, or gone: {lost:?}; --write forgets it"
        ))
    }
}

/// What must be seen in code, one of each kind, and what must not.
fn control() -> Outcome {
    let wrong: [&[u16]; 12] = [
        &[0xd1fc],
        &[0xb108],
        &[0x4718],
        &[0x4687],
        &[0xf47f, 0xaffe],
        &[0xe8df, 0xf000],
        &[0xf851, 0xf020],
        &[0xfbb1, 0xf0f2],
        &[0xbf08, 0x6808],
        &[0xbf08, 0xee80, 0x0a81],
        &[0xbf08, 0xeeb1, 0x0ae0],
        &[0xbf08, 0x4770],
    ];
    // Long branches without a condition, a multiplication, a root, `moveq`, `vmoveq`, the return.
    let right = [
        0xf000, 0xf801, 0xf000, 0xb801, 0xfba2, 0x0103, 0xeeb1, 0x0ae0, 0xbf08, 0x4608, 0xbf08,
        0xeeb0, 0x0a60, 0x4770,
    ];
    match wrong.iter().find(|code| constant(code)) {
        Some(code) => Err(format!("control: {code:04x?} passes as constant")),
        None if !constant(&right) => Err("control: straight code is refused".into()),
        None => Ok(()),
    }
}

/// In the directories of .ci/sizes.
pub fn check(targets: &[&str], writes: bool) -> Outcome {
    control()?;
    let mut counts = Counts::read()?;
    let (mut all, mut recorded) = (Vec::new(), Vec::new());
    for target in targets {
        let core = crate::core(target)?;
        let found = found(&crate::target("sizes").join(target))?;
        if writes {
            let cells = found.iter().map(|name| (name.clone(), "constant".into()));
            counts.set(core, COLUMN, &cells.collect());
        }
        let row = |name: &str| format!("{name},{target}");
        all.extend(found.iter().map(|name| row(name)));
        recorded.extend(counts.functions(core, COLUMN).map(row));
    }
    if writes {
        counts.write()?;
    }
    // The soft-float routines of a Cortex-M0 decide.
    let mut more = recorded.clone();
    more.push("poly_disk,thumbv6m-none-eabi".into());
    must_fail("a function that decides", "poly_disk", compare(&more, &all))?;
    compare(&recorded, &all)?;
    println!(
        "constant: {} functions execute the same for every input",
        recorded.len()
    );
    Ok(())
}
