//! What functions and programs take in flash, compared with docs/measured/counts.csv.
//!
//! .ci/sizes has linked into target/sizes, for each target: `TARGET/NAME`, every function alone, and the programs of
//! crates/cores; `TARGET.two`, a program of two warps; `TARGET.grown`, `poly_disk` with another warp; and two modules.

use crate::image::Image;
use crate::{ingredients, must_fail, one_warp, target};
use microwarp_host::counts::Counts;
use microwarp_host::upkeep::Outcome;
use std::fs;
use std::path::Path;

/// The columns of what is recorded.
const COLUMNS: [&str; 2] = ["flash_s", "symbols_s"];
const TITLES: [&str; 2] = ["bytes", "symbols"];
/// In percent.
const TOLERANCE: u64 = 3;
/// Another compiler makes other sizes: then only what has more than doubled fails. The level of
/// optimisation changes most of what a compiler decides; between the two levels of counts.csv all functions differ by less than that
/// (1.73 times at most), except one kernel (coarse_atan2_turns, 2.6 times). What brings in formatted panics or double
/// precision more than doubles nearly every function here.
const OF_ANOTHER: u64 = 100;

/// The row of a linked file.
fn row(name: &str, target: &str, file: &Path) -> Outcome<Row> {
    let (bytes, symbols) = Image::read(file)?.size();
    Ok((format!("{name},{target}"), [bytes, symbols as u64]))
}

/// Every file of a target, by its name.
fn measure(target: &str, directory: &Path) -> Outcome<Vec<Row>> {
    let files = fs::read_dir(directory).map_err(|e| format!("{}: {e}", directory.display()))?;
    let mut names: Vec<String> = files
        .map(|file| file.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
        .iter()
        .map(|name| row(name, target, &directory.join(name)))
        .collect()
}

/// One function that has really grown, by another that is linked with it, is named.
fn control_of_growth(target: &str, rows: &[Row], grown: &Path) -> Outcome {
    let disk = format!("poly_disk,{target}");
    let mut now = rows.to_vec();
    match now.iter_mut().find(|(name, _)| *name == disk) {
        Some(entry) => *entry = row("poly_disk", target, grown)?,
        None => return Err(format!("control: no {disk}")),
    }
    let what = format!("a function that has grown on {target}");
    must_fail(
        &what,
        &format!("GROWN: {disk}"),
        compare(rows, &now, TITLES, TOLERANCE, false),
    )
}

fn below_1_kib(file: &Path) -> Outcome {
    let bytes = fs::metadata(file)
        .map_err(|e| format!("{}: {e}", file.display()))?
        .len();
    println!("{}: {bytes} bytes", file.display());
    if bytes < 1024 {
        Ok(())
    } else {
        Err(format!("{bytes} bytes, which is not below 1024"))
    }
}

/// What is recorded of a target.
pub fn recorded(counts: &Counts, target: &str) -> Outcome<Vec<Row>> {
    let core = crate::core(target)?;
    let figure = |name, column| Ok::<_, String>(counts.figure(name, core, column)? as u64);
    counts
        .functions(core, COLUMNS[0])
        .map(|name| {
            let [bytes, symbols] = COLUMNS.map(|column| figure(name, column));
            Ok((format!("{name},{target}"), [bytes?, symbols?]))
        })
        .collect()
}

/// Each target with its compiler, as TARGET=COMPILER.
pub fn check(targets: &[&str], writes: bool) -> Outcome {
    let place = target("sizes");
    control(TITLES)?;
    let (mut heads, mut measured, mut failed) = (Vec::new(), Vec::new(), Vec::new());
    for target in targets {
        let (target, compiler) = target.split_once('=').ok_or("TARGET=COMPILER")?;
        let rows = measure(target, &place.join(target))?;
        control_of_growth(target, &rows, &place.join(format!("{target}.grown")))?;
        one_warp::check(target, &place)?;
        failed.extend(ingredients::check(target, &place).err());
        heads.push((target, format!("# {target}: {compiler}")));
        measured.push(rows);
    }
    let mut counts = Counts::read()?;
    if writes {
        counts.comments = heads.iter().map(|(_, head)| head.clone()).collect();
        for ((target, _), rows) in heads.iter().zip(&measured) {
            for (i, column) in COLUMNS.iter().enumerate() {
                let cell = |(name, figures): &Row| {
                    let name = name.split(',').next().unwrap_or_default();
                    (name.to_owned(), figures[i].to_string())
                };
                counts.set(
                    crate::core(target)?,
                    column,
                    &rows.iter().map(cell).collect(),
                );
            }
        }
        counts.write()?;
    }
    for ((target, head), rows) in heads.iter().zip(&measured) {
        let same = counts.comments.contains(head);
        if !same {
            println!(
                "*** {head}; the recorded sizes are of another. Up to {OF_ANOTHER} % of growth pass."
            );
        }
        let recorded = recorded(&counts, target)?;
        let percent = if same { TOLERANCE } else { OF_ANOTHER };
        failed.extend(compare(&recorded, rows, TITLES, percent, false).err());
    }
    must_fail(
        "a module of everything",
        "not below",
        below_1_kib(&place.join("everything.wasm")),
    )?;
    failed.extend(below_1_kib(&place.join("disk.wasm")).err());
    if !failed.is_empty() {
        return Err(failed.join("\n"));
    }
    let count: usize = measured.iter().map(Vec::len).sum();
    println!(
        "sizes: {count} functions and programs, none larger than recorded by more than {TOLERANCE} %"
    );
    Ok(())
}

// Tables of sizes that are checked in: how they are read, and how what is measured is compared with them.

/// A name with its target, and two figures.
pub type Row = (String, [u64; 2]);

/// The rows of a table, without its comments and its header. The first two columns are the name.
pub fn parse(text: &str) -> Outcome<Vec<Row>> {
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let &[name, target, first, second] = &cells[..] else {
            return None;
        };
        Some((
            format!("{name},{target}"),
            [first.parse().ok()?, second.parse().ok()?],
        ))
    };
    lines
        .map(|line| row(line).ok_or_else(|| format!("no row of sizes: {line}")))
        .collect()
}

/// Whether a figure has changed by more than so many percent.
fn off(old: u64, new: u64, percent: u64) -> Option<&'static str> {
    if new * 100 > old * (100 + percent) {
        Some("GROWN")
    } else if new * 100 < old * 100u64.saturating_sub(percent) {
        Some("shrunk")
    } else {
        None
    }
}

/// Fails for what has grown by more than so many percent, or is in one table alone. What has shrunk fails too where
/// `both_ways`, and is said otherwise.
pub fn compare(
    recorded: &[Row],
    measured: &[Row],
    titles: [&str; 2],
    percent: u64,
    both_ways: bool,
) -> Outcome {
    let mut failures = String::new();
    for (name, now) in measured {
        let Some((_, before)) = recorded.iter().find(|(other, _)| other == name) else {
            failures += &format!("\nNOT RECORDED: {name}; --write records it");
            continue;
        };
        for ((old, new), title) in before.iter().zip(now).zip(titles) {
            let Some(how) = off(*old, *new, percent) else {
                continue;
            };
            let said = format!("{how}: {name}: {new} {title}, {old} recorded");
            if how == "GROWN" || both_ways {
                failures += &format!("\n{said}");
            } else {
                println!("{said}; --write records it");
            }
        }
    }
    for (name, _) in recorded {
        if !measured.iter().any(|(other, _)| other == name) {
            failures += &format!("\nGONE: {name}; --write forgets it");
        }
    }
    if failures.is_empty() {
        Ok(())
    } else {
        Err(failures)
    }
}

/// The edge itself: growth by 3 % passes, by 3.1 % it does not.
pub fn control(titles: [&str; 2]) -> Outcome {
    let one = |first, second| vec![("f,t".to_string(), [first, second])];
    let old = one(1000, 100);
    compare(&old, &one(1030, 103), titles, 3, true)
        .map_err(|e| format!("control: growth by 3 %: {e}"))?;
    let refused = |new: Vec<Row>, both_ways| compare(&old, &new, titles, 3, both_ways);
    crate::must_fail("growth by 3.1 %", titles[0], refused(one(1031, 100), false))?;
    crate::must_fail("4 more than 100", titles[1], refused(one(1000, 104), false))?;
    crate::must_fail(
        "loss by 3.1 %, where both count",
        "shrunk",
        refused(one(969, 100), true),
    )?;
    crate::must_fail("a row that is gone", "GONE", refused(Vec::new(), false))?;
    crate::must_fail(
        "a row that is new",
        "NOT RECORDED",
        compare(&[], &old, titles, 3, false),
    )
}
