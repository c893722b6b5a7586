//! Tables of sizes that are checked in: how they are read, and how what is measured is compared with them.

use microwarp_host::upkeep::Outcome;

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
