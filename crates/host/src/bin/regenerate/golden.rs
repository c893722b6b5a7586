//! The golden tables, of functions and of pictures: lines of new cases are added, lines that exist change only where that is
//! asked for by name.

use microwarp_host::upkeep::{Outcome, read, write};
use microwarp_list::{cases, describe, evaluate};
use microwarp_scene::golden::Case;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// A table: where it is, its first line, and the lines that it should have.
type Table = (&'static str, &'static str, fn() -> Outcome<Vec<String>>);

const TABLES: [Table; 2] = [
    (
        "tests/golden/golden.csv",
        "# The bits that every target yields; compared, never edited. Columns: case, then words in hex.",
        || Ok(computed()),
    ),
    (
        "tests/golden/scene.csv",
        "# The hashes that pictures of the example `scene` have on every target; compared, never edited. Columns: scene, tier, points, size, samples a pixel and seed; then the hash.",
        pictures,
    ),
];

/// The line of every case: its name, then the words it yields.
fn computed() -> Vec<String> {
    let line = |index| {
        let mut words = [0; 16];
        let len = evaluate(index, &mut words);
        let (name, input, tier) = describe(index);
        let mut line = format!("{tier} {name} #{input}");
        for word in &words[..len] {
            let _ = write!(line, ",{word:08x}");
        }
        line
    };
    (0..cases()).map(line).collect()
}

fn pictures() -> Outcome<Vec<String>> {
    let line = |case: Case| match (case.hash)(&case.plan) {
        Ok(hash) => Ok(format!("{case},{:08x}", hash.word())),
        Err(error) => Err(format!("{case}: {error}")),
    };
    microwarp_scene::golden::cases().map(line).collect()
}

fn case(line: &str) -> &str {
    line.split(',').next().unwrap_or(line)
}

/// The table anew, and what has been asked for of it, line by line. Complains of lines that differ or are gone and have
/// not been named.
fn merge(head: &str, old: &str, now: &[String], named: &[String]) -> Outcome<(String, String)> {
    let mut kept: BTreeMap<&str, &str> = old
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| (case(line), line))
        .collect();
    let asked = |line: &str| named.iter().any(|text| case(line).contains(text.as_str()));
    let (mut table, mut report, mut complaints) =
        (format!("{head}\n"), String::new(), String::new());
    for line in now {
        let before = kept.remove(case(line));
        match before {
            Some(before) if before != line => {
                let into = if asked(line) {
                    &mut report
                } else {
                    &mut complaints
                };
                let _ = write!(into, "- {before}\n+ {line}\n");
            }
            None if !old.is_empty() => {
                let _ = writeln!(report, "+ {line}");
            }
            _ => {}
        }
        table += line;
        table.push('\n');
    }
    for line in kept.into_values() {
        let into = if asked(line) {
            &mut report
        } else {
            &mut complaints
        };
        let _ = writeln!(into, "- {line}");
    }
    if complaints.is_empty() {
        Ok((table, report))
    } else {
        Err(format!(
            "bits differ that have not been named (--golden TEXT names them):\n{complaints}"
        ))
    }
}

/// A flipped bit and a case that is gone are refused, and let through by name alone; a new case is added.
fn control(table: &str, now: &[String]) -> Outcome {
    let Some((first, rest)) = now.split_first() else {
        return Err("control: there are no cases".into());
    };
    let mut flipped = now.to_vec();
    flipped[0] = format!("{}0", first);
    let named = [case(first).to_string()];
    let merged = |old: &str, now: &[String], named: &[String]| merge("", old, now, named);
    let refused = merged(table, &flipped, &[]).is_err() && merged(table, rest, &[]).is_err();
    let let_through =
        merged(table, &flipped, &named).is_ok_and(|(_, report)| report.lines().count() == 2);
    let added =
        merged(&rest.join("\n"), now, &[]).is_ok_and(|(_, report)| report.lines().count() == 1);
    if refused && let_through && added {
        Ok(())
    } else {
        Err("control: a changed line passes for an old one, or a new one is refused".into())
    }
}

fn one(check: bool, named: &[String], (path, head, computed): Table) -> Outcome {
    let (old, now) = (read(path).unwrap_or_default(), computed()?);
    let (table, report) =
        merge(head, &old, &now, named).map_err(|error| format!("{path}: {error}"))?;
    control(&table, &now)?;
    print!("{report}");
    if !check {
        return write(path, &table);
    }
    if table == old {
        println!("{path}: {} cases, as checked in", now.len());
        Ok(())
    } else {
        Err(format!(
            "{path} lacks the lines above, or its order is another"
        ))
    }
}

pub fn step(check: bool, named: &[String]) -> Outcome {
    TABLES
        .into_iter()
        .try_for_each(|table| one(check, named, table))
}
