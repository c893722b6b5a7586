//! The costs of functions on other targets, as measured by `crates/cores`.

use host::counts::Counts;

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

pub struct Costs(Counts);

impl Costs {
    pub fn checked_in() -> Result<Self, String> {
        Counts::read().map(Self)
    }

    /// What belongs to no tier, as a table does, is counted without the name of one.
    fn number(&self, function: &str, core: &str, column: &str) -> Option<f64> {
        let counted = |name: &str| self.0.number(name, core, column);
        counted(function).or_else(|| counted(function.split_once('_')?.1))
    }

    /// The inputs of a warp are swept where they are given, and the generator takes what a mean is longer with it.
    fn cycles(&self, function: &str, core: &str, calls: f64) -> Option<Cycles> {
        let of = |name: &str| {
            let number = |column| self.0.number(name, core, column);
            Some(Cycles {
                least: number("least")?,
                mean: number("cycles_high")?,
                longest: number("longest")?,
            })
        };
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
        let either = |column| {
            let names = [function, &with].into_iter();
            names
                .filter_map(|name| self.number(name, core, column))
                .next()
        };
        Cost {
            given: self
                .number(function, core, "instructions")
                .map(|n| n * calls),
            drawn: self.number(&with, core, "instructions").map(|n| n * calls),
            flash: Option::zip(either("code_s"), either("tables_s"))
                .map(|(code, tables)| code + tables),
            stack: either("stack"),
            cycles: self.cycles(function, core, calls),
        }
    }
}
