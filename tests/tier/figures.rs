//! How far a function is from the truth, and what the documentation of a tier says about it.

use crate::sweep::Input;
use host::docs::{self, Doc, rounded_up, states};
use host::errors::{raise, relative, ulp};

/// The largest errors of a function. What is not a number counts as infinitely wrong.
#[derive(Clone, Copy, Debug, Default)]
pub struct Figures {
    pub ulp: f64,
    pub absolute: f64,
    /// Over results that are not subnormal.
    pub relative: f64,
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
            relative: if truth.abs() < f64::from(f32::MIN_POSITIVE) {
                0.0
            } else {
                relative(got, truth)
            },
            worst: input,
        });
    }

    pub fn join(&mut self, other: Self) {
        raise(&mut self.absolute, other.absolute);
        raise(&mut self.relative, other.relative);
        if raise(&mut self.ulp, other.ulp) {
            self.worst = other.worst;
        }
    }
}

/// A row of the table in a tier's documentation: a dash stands for a figure that says nothing there.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub function: String,
    pub domain: String,
    pub ulp: Option<f64>,
    pub absolute: Option<f64>,
    pub relative: Option<f64>,
}

impl Row {
    /// What is worth stating of measured figures, rounded up to two digits.
    pub fn stating(function: &str, domain: &str, figures: Figures) -> Self {
        // Ulp say nothing of a difference from 1, absolute errors nothing of results without bound, and
        // relative errors nothing new unless results span many magnitudes.
        let state = |told: bool, x: f64| told.then_some(rounded_up(x, 2));
        Self {
            function: function.to_owned(),
            domain: domain.to_owned(),
            ulp: state(!function.contains('²'), figures.ulp),
            absolute: state(figures.absolute < 1.0e-4, figures.absolute),
            relative: state(function.starts_with("normal"), figures.relative),
        }
    }

    pub fn written(&self) -> docs::Row {
        let cell = |x: Option<f64>, text: fn(f64) -> String| x.map_or("-".to_owned(), text);
        let e = |x| format!("{x:e}");
        docs::Row::new(
            &format!("`{}`", self.function),
            [
                self.domain.clone(),
                cell(self.ulp, |x| x.to_string()),
                cell(self.absolute, e),
                cell(self.relative, e),
            ],
        )
    }

    /// Every figure as stated and as measured, and by how much it may be loose whatever its size.
    fn figures(&self, measured: Figures) -> [(Option<f64>, f64, f64); 3] {
        [
            (self.ulp, measured.ulp, 0.05),
            (self.absolute, measured.absolute, 1.0e-9),
            (self.relative, measured.relative, 1.0e-9),
        ]
    }

    /// Whether every stated figure holds. Written so that NaN does not.
    pub fn holds(&self, measured: Figures) -> bool {
        let mut figures = self.figures(measured).into_iter();
        figures.all(|(stated, measured, _)| stated.is_none_or(|x| measured <= x))
    }

    /// Whether every stated figure holds and none has become too loose.
    pub fn agrees_with(&self, figures: Figures) -> bool {
        let told = |row: &Self| [row.ulp, row.absolute, row.relative].map(|x| x.is_some());
        told(self) == told(&Self::stating(&self.function, &self.domain, figures))
            && self.holds(figures)
            && self
                .figures(figures)
                .into_iter()
                .all(|(stated, measured, _)| stated.is_none_or(|x| states(x, measured, 0.0)))
    }
}

/// The name of a tier's type, which its tables document.
fn item(tier: &str) -> &'static str {
    if tier == "libm" { "Libm" } else { "Poly" }
}

/// The rows of the table in a tier's doc comment.
pub fn stated(tier: &str) -> Vec<Row> {
    let tables = Doc::of("tier", item(tier)).tables();
    tables.into_iter().flatten().map(row).collect()
}

fn row(docs::Row { title, cells, .. }: docs::Row) -> Row {
    let [domain, ulp, absolute, relative] = cells.try_into().expect("four cells");
    Row {
        function: title.trim_matches('`').to_owned(),
        domain,
        ulp: ulp.parse().ok(),
        absolute: absolute.parse().ok(),
        relative: relative.parse().ok(),
    }
}

/// Replaces the table in a tier's doc comment.
pub fn write(tier: &str, rows: &[Row]) {
    let rows: Vec<docs::Row> = rows.iter().map(Row::written).collect();
    docs::write("tier", item(tier), 0, &rows);
}
