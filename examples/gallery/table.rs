//! The table: one row for each warp, its parameters and a tier.

use crate::check::{ALARM, Figures, p_text};
use host::draw::text::thousands;
use host::registry::{Entry, Measure};
use host::table;

/// An error with its unit: ulp, or a distance as a share of the size of the domain.
pub fn error_text(entry: &Entry, error: f64) -> String {
    match entry.measure {
        Measure::Ulp => format!("{error:.2} ulp"),
        Measure::UlpAbove(_) => format!("{error:.2} ulp of itself or of a length"),
        Measure::UlpFrom(..) => format!("{error:.2} ulp of mean or deviate"),
        Measure::UlpOf(scale) => format!("{error:.2} ulp of {}", short(scale)),
        Measure::Length(1.0) => format!("{error:.2e}"),
        Measure::From(_) => format!("{error:.2e} of the distance or the location"),
        Measure::Length(length) => format!("{error:.2e} of {}", short(length)),
    }
}

fn short(x: f64) -> String {
    if (1e-3..1e4).contains(&x) {
        format!("{x}")
    } else {
        format!("{x:.0e}")
    }
}

pub fn print(rows: &[(&Entry, &Figures)]) {
    let header = [
        "warp",
        "parameters",
        "tier",
        "samples",
        "χ² p-value",
        "largest error",
        "ns a sample",
    ];
    let rows = rows.iter().map(|(entry, figures)| {
        vec![
            entry.name.to_string(),
            entry.parameters.to_string(),
            entry.tier.to_string(),
            thousands(figures.shape.samples),
            p_text(&figures.shape),
            error_text(entry, figures.error),
            format!("{:.1}", figures.nanoseconds),
        ]
    });
    table::print(&header, rows.collect(), 3);
    println!(
        "χ² p-value: samples against the density the crate reports, integrated over cells in f64; \
         below {ALARM:.0e} is a failure.\n\
         largest error: of a sample against f64, over as many samples; in ulp of the exact value, or as a \
         distance where no unit stands (\"of s\": in units of s).\n\
         ns a sample: through `fill` into this program's table, generator included, one thread of several at work."
    );
}
