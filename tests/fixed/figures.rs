//! How far a kernel is from the truth, and what the documentation of the grades says about it.

use std::path::{Path, PathBuf};

/// The errors of one kernel over a sweep. What is not a number counts as infinitely wrong.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    pub max: f64,
    /// The word with the largest error.
    pub worst: u32,
    sum: f64,
    squares: f64,
    count: f64,
}

impl Errors {
    pub fn observe(&mut self, word: u32, error: f64) {
        self.raise(word, error.abs());
        self.sum += error;
        self.squares += error * error;
        self.count += 1.0;
    }

    fn raise(&mut self, word: u32, error: f64) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if error > self.max {
            (self.max, self.worst) = (error, word);
        }
    }

    pub fn join(&mut self, other: &Self) {
        self.raise(other.worst, other.max);
        self.sum += other.sum;
        self.squares += other.squares;
        self.count += other.count;
    }

    /// Of edges only the largest error counts: there are more of them than in a fair sample.
    pub fn join_edges(&mut self, other: &Self) {
        self.raise(other.worst, other.max);
    }

    pub fn figures(&self) -> Figures {
        Figures {
            max: self.max,
            rms: (self.squares / self.count).sqrt(),
            mean: self.sum / self.count,
        }
    }
}

/// The figures of one kernel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    pub max: f64,
    pub rms: f64,
    pub mean: f64,
}

/// A mean smaller than this part of the rms is none: a sweep over some of the words does not see it.
const NONE: f64 = 1.0 / 512.0;

impl Figures {
    /// What is stated of measured figures: a tenth more, to two digits.
    fn stating(self) -> Self {
        let mean = if self.mean.abs() < NONE * self.rms {
            0.0
        } else {
            self.mean
        };
        Self {
            max: rounded(1.1 * self.max),
            rms: rounded(1.1 * self.rms),
            mean: rounded(1.1 * mean),
        }
    }

    /// Whether figures measured keep to these, and these are not stale; the largest error only if so
    /// many words have been tried that it must have been met.
    pub fn agree_with(self, measured: Self, many: bool) -> bool {
        let within = |stated: f64, found: f64, slack: f64| {
            found.is_finite() && found <= stated + slack && 0.8 * stated <= found + slack
        };
        let largest = if many {
            within(self.max, measured.max, 0.0)
        } else {
            measured.max.is_finite() && measured.max <= self.max
        };
        let slack = NONE * measured.rms;
        let signed = measured.mean * if self.mean < 0.0 { -1.0 } else { 1.0 };
        largest
            && within(self.rms, measured.rms, 0.0)
            && within(self.mean.abs(), signed, slack)
            && (self.mean != 0.0 || measured.mean.abs() <= slack)
    }

    fn cell(self) -> String {
        let number = |x: f64| {
            if x == 0.0 {
                "0".to_owned()
            } else {
                format!("{x:e}")
            }
        };
        [self.max, self.rms, self.mean].map(number).join(", ")
    }
}

/// To two digits.
fn rounded(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap()
}

/// A row of the table: the function, then the figures in each grade.
pub type Row = (String, [Figures; 3]);

const HEAD: [&str; 2] = [
    "/// | function | [`Fine`] | [`Coarse`] | [`Compact`] |",
    "/// |---|--:|--:|--:|",
];

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/fixed/grade.rs")
}

/// The rows of the table in the source.
pub fn stated() -> Vec<Row> {
    let text = std::fs::read_to_string(source()).unwrap();
    text.lines().filter_map(row).collect()
}

fn row(line: &str) -> Option<Row> {
    let line = line.strip_prefix("/// | `")?.strip_suffix(" |")?;
    let mut cells = line.split(" | ");
    let name = format!("`{}", cells.next()?);
    let figures: Vec<Figures> = cells.map(figures).collect::<Option<_>>()?;
    Some((name, figures.try_into().ok()?))
}

fn figures(cell: &str) -> Option<Figures> {
    let mut numbers = cell.split(", ").map(str::parse);
    Some(Figures {
        max: numbers.next()?.ok()?,
        rms: numbers.next()?.ok()?,
        mean: numbers.next()?.ok()?,
    })
}

/// Replaces the table in the source by one that states these figures.
pub fn write(rows: &[Row]) {
    let text = std::fs::read_to_string(source()).unwrap();
    let is_table = |line: &&str| line.starts_with("/// |");
    let before = text.lines().take_while(|line| !is_table(line));
    let after = text.lines().skip_while(|line| !is_table(line));
    let after = after.skip_while(is_table);
    let rows = rows.iter().map(|(name, figures)| {
        let cells = figures.map(|figures| figures.stating().cell());
        format!("/// | {name} | {} |", cells.join(" | "))
    });
    let lines: Vec<String> = before
        .chain(HEAD)
        .map(str::to_owned)
        .chain(rows)
        .chain(after.map(str::to_owned))
        .collect();
    std::fs::write(source(), lines.join("\n") + "\n").unwrap();
}
