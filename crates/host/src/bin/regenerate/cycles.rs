//! The tables of docs/worst_case.md, from crates/cores/cycles.csv.

use crate::sources::{Sources, TIERS, grouped};
use crate::tables::rows;
use microwarp_host::upkeep::{Outcome, read};
use microwarp_list::Listed;
use std::collections::BTreeSet;

/// The processors as cycles.csv names their timings.
pub const TIMINGS: [(&str, &str); 5] = [
    ("m0", "Cortex-M0"),
    ("m0_slow", "M0, multiplying in 32"),
    ("m0plus", "Cortex-M0+"),
    ("m3", "Cortex-M3"),
    ("m4f", "Cortex-M4F"),
];

fn title(timing: &str) -> Outcome<&'static str> {
    let found = TIMINGS.iter().find(|(name, _)| *name == timing);
    found
        .map(|(_, title)| *title)
        .ok_or_else(|| format!("no timing {timing}"))
}

/// A row of cycles.csv.
pub struct Row {
    pub kernel: String,
    pub timing: String,
    pub path: String,
    /// Of instructions: the mean, the fewest, the most.
    pub instructions: [f64; 3],
    /// Of the mean, the lower and the upper end.
    pub mean: [f64; 2],
    pub least: f64,
    pub longest: f64,
}

impl Row {
    /// Somebody else's, or only another row's function with a generator or with other parameters.
    fn is_beside(&self, all: &BTreeSet<&str>) -> bool {
        let alone = self.kernel.strip_suffix("_pcg32");
        self.kernel.starts_with("peer_")
            || self.kernel.ends_with("_any")
            || alone.is_some_and(|alone| all.contains(alone))
    }
}

/// The rows of functions alone.
fn alone(all: &[Row]) -> Vec<&Row> {
    let names = all.iter().map(|row| row.kernel.as_str()).collect();
    all.iter().filter(|row| !row.is_beside(&names)).collect()
}

/// In the order of the file.
pub fn all() -> Outcome<Vec<Row>> {
    const FILE: &str = "crates/cores/cycles.csv";
    let text = read(FILE)?;
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| cells.get(i)?.parse::<f64>().ok();
        Some(Row {
            kernel: cells[0].into(),
            timing: (*cells.get(1)?).into(),
            path: (*cells.get(3)?).into(),
            instructions: [number(4)?, number(5)?, number(6)?],
            mean: [number(7)?, number(8)?],
            least: number(9)?,
            longest: number(10)?,
        })
    };
    text.lines()
        .skip(1)
        .map(|line| row(line).ok_or_else(|| format!("{FILE}: {line}")))
        .collect()
}

pub fn whole(number: f64) -> String {
    grouped(number.round_ties_even() as u64)
}

/// One figure where the manual leaves nothing open.
fn range([low, high]: [f64; 2]) -> String {
    let (low, high) = (whole(low), whole(high));
    if low == high {
        low
    } else {
        format!("{low} to {high}")
    }
}

/// One figure of a row.
pub fn figure(timing: &str, kernel: &str, of: fn(&Row) -> f64) -> Outcome<u64> {
    let all = all()?;
    let row = all
        .iter()
        .find(|row| row.kernel == kernel && row.timing == timing);
    row.map(|row| of(row).round_ties_even() as u64)
        .ok_or_else(|| format!("cycles.csv has no {kernel} on {timing}"))
}

/// What the inputs decide.
fn decided(path: &str) -> Outcome<&'static str> {
    match path {
        "constant" => Ok("nothing"),
        "operands" => Ok("how long operands take"),
        "same" => Ok("nothing seen"),
        "varies" => Ok("the path"),
        _ => Err(format!("cycles.csv: {path}?")),
    }
}

/// `PATTERN TIMING...`: the kernels of a tier, those of any parameters (`poly_any`), or those named with `|` between, by some
/// timings of one core.
pub fn table(words: &str) -> Outcome<String> {
    let mut words = words.split(' ');
    let (pattern, timings) = (words.next().unwrap_or_default(), words.collect::<Vec<_>>());
    let (first, others) = timings.split_first().ok_or("which timings?")?;
    let all = all()?;
    let chosen = |kernel: &str| match pattern.strip_suffix("any") {
        Some(tier) => kernel.starts_with(tier) && kernel.ends_with("_any"),
        None => pattern
            .split('|')
            .any(|part| kernel == part || (part.ends_with('_') && kernel.starts_with(part))),
    };
    let considered = match pattern.ends_with("any") {
        true => all.iter().collect(),
        false => alone(&all),
    };
    let mut head = vec!["".into(), "instructions: mean".into(), "most".into()];
    head.push(format!("{}: least", title(first)?));
    head.extend(["mean".into(), "longest".into()]);
    for timing in others {
        head.extend([format!("{}: mean", title(timing)?), "longest".into()]);
    }
    head.push("inputs decide".into());
    let line = |i: usize| {
        if i == 0 || i + 1 == head.len() {
            "---"
        } else {
            "--:"
        }
    };
    let mut table = vec![
        head.clone(),
        (0..head.len()).map(|i| line(i).into()).collect(),
    ];
    for row in considered
        .into_iter()
        .filter(|row| row.timing == *first && chosen(&row.kernel))
    {
        let mut cells = vec![
            format!("`{}`", row.kernel),
            whole(row.instructions[0]),
            whole(row.instructions[2]),
        ];
        cells.extend([whole(row.least), range(row.mean), whole(row.longest)]);
        for timing in others {
            let other = all
                .iter()
                .find(|other| other.kernel == row.kernel && other.timing == *timing);
            let other =
                other.ok_or_else(|| format!("cycles.csv has no {} on {timing}", row.kernel))?;
            cells.extend([range(other.mean), whole(other.longest)]);
        }
        cells.push(decided(&row.path)?.into());
        table.push(cells);
    }
    if table.len() == 2 {
        return Err(format!("cycles.csv has no {pattern} on {first}"));
    }
    Ok(rows(&table))
}

/// Which functions take the same time for every input, by timing.
pub fn constant() -> Outcome<String> {
    let all = all()?;
    let all = alone(&all);
    let mut table = vec![
        vec![
            "".into(),
            "functions".into(),
            "constant, proven".into(),
            "the same for all inputs tried".into(),
            "constant".into(),
        ],
        vec![
            "---".into(),
            "--:".into(),
            "--:".into(),
            "--:".into(),
            "---".into(),
        ],
    ];
    for (timing, title) in TIMINGS {
        let of = |path: &str| {
            all.iter()
                .filter(|row| row.timing == timing && row.path == path)
                .collect::<Vec<_>>()
        };
        let constant = of("constant");
        let names: Vec<String> = constant
            .iter()
            .map(|row| format!("`{}`", row.kernel))
            .collect();
        let count = all.iter().filter(|row| row.timing == timing).count();
        let cells = [count, constant.len(), of("same").len()].map(|count| count.to_string());
        table.push([&[title.to_string()], &cells[..], &[names.join(", ")]].concat());
    }
    Ok(rows(&table))
}

/// cycles.csv counts the instructions of costs.csv, and has every function by every timing but for paths, and what takes any
/// parameters in a tier's first grade. What only draws for another, and any parameters in the others, may be there.
pub fn tidy(sources: &Sources, kernels: &BTreeSet<String>) -> Outcome<Vec<String>> {
    let mut wrong = Vec::new();
    let mut found = BTreeSet::new();
    let varied: BTreeSet<String> = varied().collect();
    for row in all()? {
        let (kernel, timing) = (&row.kernel, &row.timing);
        let core = if timing.starts_with("m0") {
            "m0"
        } else {
            timing
        };
        if !kernels.contains(kernel) && !varied.contains(kernel) {
            wrong.push(format!(
                "cycles.csv has {kernel}, and there is no such kernel"
            ));
        } else if kernels.contains(kernel)
            && (sources.cost(kernel, core, "3", 0)? - row.instructions[0]).abs() > 0.101
        {
            wrong.push(format!(
                "{kernel} on {timing}: cycles.csv and costs.csv differ: --costs --kernel '^{kernel}$'"
            ));
        }
        found.insert((row.kernel, row.timing));
    }
    let draws = |kernel: &str| {
        let alone = kernel.strip_suffix("_pcg32");
        alone.is_some_and(|alone| kernels.contains(alone))
    };
    let timed = |kernel: &&String| !kernel.contains("_path_") && !draws(kernel);
    let of_grade = |kernel: &str| {
        ["libm_", "coarse_", "compact_"]
            .iter()
            .any(|tier| kernel.starts_with(tier))
    };
    let any = varied.iter().filter(|kernel| !of_grade(kernel));
    for kernel in kernels.iter().filter(timed).chain(any) {
        let all = TIMINGS
            .iter()
            .all(|(timing, _)| found.contains(&(kernel.clone(), timing.to_string())));
        if !all {
            wrong.push(format!(
                "{kernel} is not in cycles.csv: --costs --kernel '^{kernel}$'"
            ));
        }
    }
    Ok(wrong)
}

/// The kernels of warps that take any parameters.
fn varied() -> impl Iterator<Item = String> {
    TIERS.into_iter().flat_map(|(warps, tiers)| {
        let names = warps.iter().flat_map(Listed::varied);
        names.flat_map(move |name| tiers.iter().map(move |tier| format!("{tier}{name}_any")))
    })
}
