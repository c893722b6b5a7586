//! How far a kernel is from the truth, and what the documentation of the grades says about it.

use host::docs::{self, Doc, states};
use host::errors;

/// The errors of one kernel over a sweep of words.
pub type Errors = errors::Errors<u32>;

/// The figures of a sweep.
pub fn figures(errors: &Errors) -> Figures {
    Figures {
        max: errors.max,
        rms: errors.rms(),
        mean: errors.mean(),
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
        let largest = if many {
            states(self.max, measured.max, 0.0)
        } else {
            measured.max.is_finite() && measured.max <= self.max
        };
        largest
            && states(self.rms, measured.rms, 0.0)
            && states(self.mean, measured.mean, NONE * measured.rms)
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

/// The rows of the first table of the grades.
pub fn stated() -> Vec<Row> {
    let mut tables = Doc::of("fixed", "Grade").tables();
    tables.swap_remove(0).into_iter().map(row).collect()
}

fn row(docs::Row { title, cells, .. }: docs::Row) -> Row {
    let figures: Option<Vec<Figures>> = cells.iter().map(|cell| read(cell)).collect();
    let figures = figures.and_then(|figures| figures.try_into().ok());
    (title, figures.expect("three figures in each grade"))
}

fn read(cell: &str) -> Option<Figures> {
    let mut numbers = cell.split(", ").map(str::parse);
    Some(Figures {
        max: numbers.next()?.ok()?,
        rms: numbers.next()?.ok()?,
        mean: numbers.next()?.ok()?,
    })
}

/// Replaces the table in the source by one that states these figures.
pub fn write(rows: &[Row]) {
    let rows = rows.iter().map(|(name, figures)| {
        docs::Row::new(name, figures.map(|figures| figures.stating().cell()))
    });
    docs::write("fixed", "Grade", 0, &rows.collect::<Vec<_>>());
}
