//! The tables of docs/worst_case.md, from docs/measured/counts.csv.

use crate::sources::grouped;
use crate::tables::rows;
use microwarp_host::counts::Counts;
use microwarp_host::upkeep::Outcome;
use std::collections::BTreeSet;

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
