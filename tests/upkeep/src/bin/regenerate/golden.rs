//! The golden table: lines of new cases are added, lines that exist change only where that is asked for by name.

use microwarp_golden::{cases, describe, evaluate};
use microwarp_upkeep::{Outcome, read, write};
use std::collections::BTreeMap;
use std::fmt::Write as _;

const PATH: &str = "tests/golden/golden.csv";
const HEAD: &str = "# The bits that every target yields; compared, never edited. Columns: case, then words in hex.";

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

fn case(line: &str) -> &str {
    line.split(',').next().unwrap_or(line)
}

/// The table anew, and what has been asked for of it, line by line. Complains of lines that differ or are gone and have
/// not been named.
fn merge(old: &str, now: &[String], named: &[String]) -> Outcome<(String, String)> {
    let mut kept: BTreeMap<&str, &str> = old
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| (case(line), line))
        .collect();
    let asked = |line: &str| named.iter().any(|text| case(line).contains(text.as_str()));
    let (mut table, mut report, mut complaints) =
        (format!("{HEAD}\n"), String::new(), String::new());
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
    let refused = merge(table, &flipped, &[]).is_err() && merge(table, rest, &[]).is_err();
    let let_through =
        merge(table, &flipped, &named).is_ok_and(|(_, report)| report.lines().count() == 2);
    let added =
        merge(&rest.join("\n"), now, &[]).is_ok_and(|(_, report)| report.lines().count() == 1);
    if refused && let_through && added {
        Ok(())
    } else {
        Err("control: a changed line passes for an old one, or a new one is refused".into())
    }
}

pub fn step(check: bool, named: &[String]) -> Outcome {
    let (old, now) = (read(PATH).unwrap_or_default(), computed());
    let (table, report) = merge(&old, &now, named)?;
    control(&table, &now)?;
    print!("{report}");
    if !check {
        return write(PATH, &table);
    }
    if table == old {
        println!("golden: {} cases, as checked in", now.len());
        Ok(())
    } else {
        Err(format!(
            "{PATH} lacks the lines above, or its order is another"
        ))
    }
}
