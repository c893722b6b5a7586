//! How far a function is from the truth, and what the documentation of a tier says about it.

use crate::sweep::Input;
use std::path::{Path, PathBuf};

/// The largest errors of a function. What is not a number counts as infinitely wrong.
#[derive(Clone, Copy, Debug, Default)]
pub struct Figures {
    pub ulp: f64,
    pub absolute: f64,
    /// Where the error in ulp was met.
    pub worst: Input,
}

impl Figures {
    pub fn observe(&mut self, input: Input, got: f32, truth: f64) {
        // Past the largest finite value the next power of two stands for infinity.
        const TOP: f64 = 340_282_366_920_938_463_463_374_607_431_768_211_456.0;
        let got = f64::from(got).clamp(-TOP, TOP);
        let truth = truth.clamp(-TOP, TOP);
        let absolute = (got - truth).abs();
        self.join(Self {
            ulp: absolute / ulp(truth),
            absolute,
            worst: input,
        });
    }

    pub fn join(&mut self, other: Self) {
        raise(&mut self.absolute, other.absolute);
        if raise(&mut self.ulp, other.ulp) {
            self.worst = other.worst;
        }
    }
}

/// Raises a maximum, and says whether it did.
fn raise(maximum: &mut f64, error: f64) -> bool {
    let error = if error.is_nan() { f64::INFINITY } else { error };
    let higher = error > *maximum;
    if higher {
        *maximum = error;
    }
    higher
}

/// The spacing of `f32` at the magnitude of an exact value; that of the subnormals below them.
fn ulp(x: f64) -> f64 {
    let exponent = ((x.abs().to_bits() >> 52) as i32 - 1023).clamp(-126, 127);
    2.0_f64.powi(exponent - 23)
}

/// A row of the table in a tier's documentation: a dash stands for a figure that says nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub function: String,
    pub domain: String,
    pub ulp: Option<f64>,
    pub absolute: Option<f64>,
}

pub fn source(tier: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("src/tier/{tier}.rs"))
}

/// The rows of a table in doc comments whose first column names a function.
pub fn rows(text: &str) -> Vec<Row> {
    let cells = |line: &str| -> Option<Vec<String>> {
        let row = line.trim().strip_prefix("/// |")?.strip_suffix('|')?;
        Some(row.split('|').map(|cell| cell.trim().to_owned()).collect())
    };
    text.lines()
        .filter_map(cells)
        .filter_map(|cells| {
            let [function, domain, ulp, absolute] = cells.try_into().ok()?;
            let function = function.strip_prefix('`')?.strip_suffix('`')?.to_owned();
            Some(Row {
                function,
                domain,
                ulp: ulp.parse().ok(),
                absolute: absolute.parse().ok(),
            })
        })
        .collect()
}

/// Whether a stated figure holds and has not become too loose: it may be a quarter above the measured
/// one, and a little more where that is next to nothing.
pub fn agrees(stated: Option<f64>, measured: f64, slack: f64) -> bool {
    stated.is_none_or(|stated| measured <= stated && stated <= 1.25 * measured + slack)
}

/// Rounded up to two digits, as it is to be stated.
pub fn rounded_up(x: f64) -> f64 {
    if !(x > 0.0 && x.is_finite()) {
        return x;
    }
    let unit = 10.0_f64.powi(x.log10().floor() as i32 - 1);
    let text = format!("{:.1e}", (x / unit).ceil() * unit);
    text.parse().unwrap_or(x)
}
