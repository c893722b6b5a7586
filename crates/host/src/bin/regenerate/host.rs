//! What is measured by the clock: the benches' figures, with the machine and the day.

use crate::sources::grouped;
use crate::tables::rows;
use crate::{command, tradeoff};
use microwarp_host::counts::Counts;
use microwarp_host::upkeep::{Outcome, root, write};
use std::collections::BTreeSet;
use std::fs;

pub fn measure() -> Outcome {
    let mut rows = String::new();
    for bench in ["warps", "tables", "chains"] {
        let said = command(&["cargo", "bench", "--locked", "--bench", bench], &[], true)?;
        for (name, ns) in medians(&said)? {
            rows += &format!("{bench},{name},{ns}\n");
        }
    }
    let head = format!(
        "# {}: one core, baseline instructions.\n# Nanoseconds an item of `cargo bench`, the generator included. \
         `cargo regenerate --host` measures anew.\nbench,name,ns\n",
        machine_and_day()?
    );
    write("docs/measured/host.csv", &(head + &rows))?;
    let line = [
        "cargo",
        "bench",
        "--locked",
        "--bench",
        "peers",
        "--",
        "--markdown",
    ];
    let said = command(&line, &[], true)?;
    let tables: String = said
        .lines()
        .filter(|line| line.is_empty() || line.starts_with('|'))
        .map(|line| {
            if line.is_empty() {
                "\n".into()
            } else {
                plain(line) + "\n"
            }
        })
        .collect();
    let head = format!(
        "What `cargo bench --bench peers -- --markdown` printed on {}.\n`cargo regenerate --host` measures anew.\n\n",
        machine_and_day()?
    );
    write("docs/measured/peers.md", &(head + tables.trim() + "\n"))?;
    let said = command(
        &["cargo", "bench", "--locked", "--bench", "tradeoff"],
        &[],
        true,
    )?;
    let head = format!(
        "# {}: one core, baseline instructions. What `cargo bench --bench tradeoff` prints.\n\
         # The largest distance of a point from the exact one, and nanoseconds a sample, the generator included.\n",
        machine_and_day()?
    );
    write(tradeoff::record::FILE, &(head + &said))
}

/// Runs an example, and takes its picture over into docs.
pub fn example(name: &str, arguments: &[&str]) -> Outcome {
    let line = [
        "cargo",
        "run",
        "--locked",
        "--release",
        "--example",
        name,
        "--",
    ];
    command(&[&line, arguments].concat(), &[], false)?;
    picture(&format!("{name}/{name}"), name)
}

/// Takes a picture of an example over into docs.
pub fn picture(made: &str, name: &str) -> Outcome {
    let (from, to) = (format!("target/{made}.png"), format!("docs/{name}.png"));
    fs::copy(root().join(&from), root().join(&to)).map_err(|e| format!("{from}: {e}"))?;
    Ok(())
}

fn machine_and_day() -> Outcome<String> {
    let model = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = model
        .lines()
        .find_map(|line| line.strip_prefix("model name"));
    let model = model.map_or("an unknown processor", |m| {
        m.trim_start_matches([' ', '\t', ':'])
    });
    let day = command(&["date", "-u", "+%F"], &[], true)?;
    Ok(format!("{model}, {}", day.trim()))
}

/// A row of a table for the terminal without its padding.
fn plain(row: &str) -> String {
    let cells = crate::sources::cells(row);
    if cells
        .iter()
        .all(|cell| cell.trim_matches(['-', ':']).is_empty() && !cell.is_empty())
    {
        let cells = cells
            .iter()
            .map(|cell| if cell.ends_with(':') { "--:" } else { "---" });
        return format!("|{}|", cells.collect::<Vec<_>>().join("|"));
    }
    format!("| {} |", cells.join(" | "))
}

/// Out of the tree that divan prints: each leaf by its path, with the median of an item, in nanoseconds. The line of
/// times is that of all items; the line below it says how many of them pass in a second.
fn medians(said: &str) -> Outcome<Vec<(String, String)>> {
    let mut path: Vec<&str> = Vec::new();
    let mut found = Vec::new();
    for line in said.lines() {
        let branch = line.find("├─ ").or_else(|| line.find("╰─ "));
        let cells: Vec<&str> = line.split('│').map(str::trim).collect();
        if let Some(at) = branch {
            let depth = line[..at].chars().count() / 3;
            let name = line[at + "├─ ".len()..].split_whitespace().next();
            path.truncate(depth);
            path.push(name.unwrap_or_default());
        } else if let Some(rate) = cells.iter().filter(|cell| cell.contains("item/s")).nth(2) {
            let (number, unit) = rate.split_once(' ').ok_or("divan prints another table")?;
            let scale = match unit.trim_end_matches("item/s") {
                "G" => 1.0,
                "M" => 1e3,
                "K" => 1e6,
                _ => return Err(format!("divan prints another rate: {rate}")),
            };
            let rate: f64 = number
                .parse()
                .map_err(|_| format!("divan prints another rate: {rate}"))?;
            let ns = scale / rate;
            let text = if ns < 100.0 {
                format!("{ns:.1}")
            } else {
                format!("{ns:.0}")
            };
            found.push((path.join("::"), text));
        }
    }
    if found.is_empty() {
        Err("no bench has printed a rate".into())
    } else {
        Ok(found)
    }
}

// The tables of docs/worst_case.md, from docs/measured/counts.csv.

/// The processors, and their rows.
pub const CORES: [(&str, &str); 4] = [
    ("Cortex-M0", "m0"),
    ("Cortex-M0+", "m0plus"),
    ("Cortex-M3", "m3"),
    ("Cortex-M4F", "m4f"),
];

pub fn whole(number: f64) -> String {
    grouped(number.round_ties_even() as u64)
}

/// The functions that were swept on a core, but for somebody else's, and what is only another's with a generator.
fn swept(counts: &Counts, core: &str) -> Vec<String> {
    let all: Vec<_> = counts.functions(core, "longest").collect();
    let known: BTreeSet<_> = all.iter().copied().collect();
    let alone = |kernel: &&str| {
        let draws = kernel.strip_suffix("_pcg32");
        !kernel.starts_with("peer_") && !draws.is_some_and(|alone| known.contains(alone))
    };
    all.into_iter().filter(alone).map(String::from).collect()
}

/// Which functions take the same time for every input. A Cortex-M0 and an M0+ execute the same code.
pub fn constant(counts: &Counts) -> Outcome<String> {
    const HEAD: [&str; 5] = [
        "",
        "functions",
        "constant, proven",
        "the same for all inputs tried",
        "constant",
    ];
    let mut table = vec![
        HEAD.map(String::from).into(),
        ["---", "--:", "--:", "--:", "---"].map(String::from).into(),
    ];
    for (title, core) in [
        ("Cortex-M0, M0+", "m0"),
        ("Cortex-M3", "m3"),
        ("Cortex-M4F", "m4f"),
    ] {
        let mut all = swept(counts, core);
        all.retain(|kernel| !kernel.ends_with("_any"));
        let of = |path: &str| {
            let is = |kernel: &&String| counts.cell(kernel, core, "path") == Some(path);
            all.iter().filter(is).collect::<Vec<_>>()
        };
        let (constant, same) = (of("constant"), of("same").len());
        let names: Vec<String> = constant
            .iter()
            .map(|kernel| format!("`{kernel}`"))
            .collect();
        let mut row = vec![title.to_owned()];
        row.extend([all.len(), constant.len(), same].map(|count| count.to_string()));
        row.push(names.join(", "));
        table.push(row);
    }
    Ok(rows(&table))
}

/// The ten whose longest call is the most times the mean, by cycles on a Cortex-M0.
pub fn extremes(counts: &Counts) -> Outcome<String> {
    let times = |kernel: &String| {
        let of = |column| counts.figure(kernel, "m0", column);
        Ok((of("longest")? / of("cycles_high")?, kernel.clone()))
    };
    let all: Outcome<Vec<_>> = swept(counts, "m0").iter().map(times).collect();
    let mut all = all?;
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut text = String::from(
        "| | Cortex-M0: mean | longest | times the mean | Cortex-M4F: mean | longest |\n|---|--:|--:|--:|--:|--:|\n",
    );
    for (times, kernel) in &all[..10] {
        let of = |core, column| counts.figure(kernel, core, column).map(whole);
        text += &rows(&[vec![
            format!("`{kernel}`"),
            of("m0", "cycles_high")?,
            of("m0", "longest")?,
            format!("{times:.1}"),
            of("m4f", "cycles_high")?,
            of("m4f", "longest")?,
        ]]);
    }
    Ok(text)
}
