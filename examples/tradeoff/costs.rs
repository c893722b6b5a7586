//! The costs of functions on other targets, as measured by `benches/cores`.

use std::collections::BTreeMap;
use support::COSTS;

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
}

/// One line of measurements: instructions, stack, and code with tables.
#[derive(Clone, Copy)]
struct Line {
    instructions: Option<f64>,
    stack: Option<f64>,
    flash: Option<f64>,
}

pub struct Costs(BTreeMap<(String, String, String), Line>);

impl Costs {
    pub fn checked_in() -> Result<Self, String> {
        Self::read(COSTS)
    }

    /// Reads lines of `function,core,opt,instructions,stack,code,tables`, by the names at their head.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut lines = text.lines();
        let head: Vec<&str> = lines.next().unwrap_or("").split(',').collect();
        let column = |name: &str| {
            let place = head.iter().position(|title| *title == name);
            place.ok_or_else(|| format!("benches/cores/costs.csv has no column {name}"))
        };
        let names = [column("function")?, column("core")?, column("opt")?];
        let [instructions, stack] = [column("instructions")?, column("stack")?];
        let [code, tables] = [column("code")?, column("tables")?];
        let mut costs = BTreeMap::new();
        for line in lines {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |i: usize| cells.get(i).and_then(|cell| cell.parse::<f64>().ok());
            let [Some(function), Some(core), Some(opt)] =
                names.map(|i| cells.get(i).map(|c| (*c).to_owned()))
            else {
                return Err(format!("benches/cores/costs.csv: {line}"));
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
        Ok(Self(costs))
    }

    /// What belongs to no tier, as a table does, is counted without the name of one.
    fn line(&self, function: &str, core: &str, opt: &str) -> Option<&Line> {
        let counted = |name: &str| self.0.get(&(name.into(), core.into(), opt.into()));
        counted(function).or_else(|| counted(function.split_once('_')?.1))
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
        }
    }
}
