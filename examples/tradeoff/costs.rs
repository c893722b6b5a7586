//! The costs of functions on other targets, as measured by `crates/cores`.

use host::{COSTS, CYCLES};
use std::collections::BTreeMap;

/// The cores, by their names in the measurements and in print.
pub const CORES: [(&str, &str); 3] = [("m0", "Cortex-M0"), ("m4f", "Cortex-M4F"), ("wasm", "WASM")];

/// The measurements of a function on a core.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Executed instructions of a sample at level 3, its uniforms being given.
    pub given: Option<f64>,
    /// The same with PCG32.
    pub drawn: Option<f64>,
    /// Bytes of code and tables at level s, without a generator where that has been measured.
    pub flash: Option<f64>,
    /// Bytes at level 3.
    pub stack: Option<f64>,
    /// With PCG32, on a core whose cycles are known.
    pub cycles: Option<Cycles>,
}

/// Cycles of a sample by the tables of the manuals, at the upper end of what they leave open; at the lower one for the
/// least.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cycles {
    pub least: f64,
    pub mean: f64,
    pub longest: f64,
}

impl Cost {
    /// What a sample with PCG32 costs: cycles where they are known, as of WASM they are not.
    pub fn whole(&self, core: &str) -> Option<f64> {
        match core {
            "wasm" => self.drawn,
            _ => self.cycles.map(|cycles| cycles.mean),
        }
    }
}

/// One line of measurements: instructions, stack, and code with tables.
#[derive(Clone, Copy)]
struct Line {
    instructions: Option<f64>,
    stack: Option<f64>,
    flash: Option<f64>,
}

pub struct Costs {
    lines: BTreeMap<(String, String, String), Line>,
    cycles: BTreeMap<(String, String), Cycles>,
}

/// The columns of a table that has names at its head.
fn columns<const N: usize>(head: &str, names: [&str; N]) -> Result<[usize; N], String> {
    let head: Vec<&str> = head.split(',').collect();
    let mut places = [0; N];
    for (place, name) in places.iter_mut().zip(names) {
        let found = head.iter().position(|title| *title == name);
        *place = found.ok_or_else(|| format!("crates/cores: no column {name}"))?;
    }
    Ok(places)
}

/// Reads `crates/cores/cycles.csv`.
fn cycles(text: &str) -> Result<BTreeMap<(String, String), Cycles>, String> {
    let (head, rows) = text.split_once('\n').unwrap_or((text, ""));
    let names = ["function", "timing", "least", "high", "longest"];
    let places = columns(head, names)?;
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let cell = |i: usize| cells.get(places[i]).copied();
        let number = |i| cell(i)?.parse().ok();
        let cycles = Cycles {
            least: number(2)?,
            mean: number(3)?,
            longest: number(4)?,
        };
        Some(((cell(0)?.into(), cell(1)?.into()), cycles))
    };
    let rows = rows.lines();
    rows.map(|line| row(line).ok_or_else(|| format!("crates/cores/cycles.csv: {line}")))
        .collect()
}

impl Costs {
    pub fn checked_in() -> Result<Self, String> {
        Self::read(COSTS, CYCLES)
    }

    /// Reads lines of `function,core,opt,instructions,stack,code,tables`, by the names at their head, and those of cycles.
    pub fn read(text: &str, of_cycles: &str) -> Result<Self, String> {
        let mut lines = text.lines();
        let head = lines.next().unwrap_or("");
        let names = columns(head, ["function", "core", "opt"])?;
        let [instructions, stack, code, tables] =
            columns(head, ["instructions", "stack", "code", "tables"])?;
        let mut costs = BTreeMap::new();
        for line in lines {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |i: usize| cells.get(i).and_then(|cell| cell.parse::<f64>().ok());
            let [Some(function), Some(core), Some(opt)] =
                names.map(|i| cells.get(i).map(|c| (*c).to_owned()))
            else {
                return Err(format!("crates/cores/costs.csv: {line}"));
            };
            let line = Line {
                instructions: number(instructions),
                stack: number(stack),
                flash: number(code)
                    .zip(number(tables))
                    .map(|(code, tables)| code + tables),
            };
            costs.insert((function, core, opt), line);
        }
        Ok(Self {
            lines: costs,
            cycles: cycles(of_cycles)?,
        })
    }

    /// What belongs to no tier, as a table does, is counted without the name of one.
    fn line(&self, function: &str, core: &str, opt: &str) -> Option<&Line> {
        let counted = |name: &str| self.lines.get(&(name.into(), core.into(), opt.into()));
        counted(function).or_else(|| counted(function.split_once('_')?.1))
    }

    /// The inputs of a warp are swept where they are given, and the generator takes what a mean is longer with it.
    fn cycles(&self, function: &str, core: &str, calls: f64) -> Option<Cycles> {
        let of = |name: &str| self.cycles.get(&(name.into(), core.into()));
        let plain = |name: &str| {
            let drawn = of(&format!("{name}_pcg32"))?;
            let given = of(name).unwrap_or(drawn);
            let generator = drawn.mean - given.mean;
            Some(Cycles {
                least: drawn.least.min(given.least + generator) * calls,
                mean: drawn.mean * calls,
                longest: drawn.longest.max(given.longest + generator) * calls,
            })
        };
        plain(function).or_else(|| plain(function.split_once('_')?.1))
    }

    /// The cost of a sample, which takes so many calls of a function.
    pub fn of(&self, function: &str, core: &str, calls: f64) -> Cost {
        let with = format!("{function}_pcg32");
        let instructions = |name| {
            self.line(name, core, "3")
                .and_then(|line| line.instructions)
        };
        let either = |opt, of: fn(&Line) -> Option<f64>| {
            let lines = [self.line(function, core, opt), self.line(&with, core, opt)];
            lines.into_iter().flatten().find_map(of)
        };
        Cost {
            given: instructions(function).map(|n| n * calls),
            drawn: instructions(&with).map(|n| n * calls),
            flash: either("s", |line| line.flash),
            stack: either("3", |line| line.stack),
            cycles: self.cycles(function, core, calls),
        }
    }
}
