//! The table of slopes and what is to be said beside it.

use crate::fit::{Line, TOLERANCE, Use};
use crate::rules::FLOOR;
use comfy_table::{CellAlignment, Table, presets};
use support::draw::text::signed;

pub fn print(lines: &[Line], repetitions: u32) {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN);
    table.set_header([
        "dimensions",
        "method",
        "evaluations fitted",
        "points",
        "slope",
        "± (fit)",
        "theory",
        "difference",
        "smallest error",
    ]);
    for line in lines {
        let ends = |pick: fn(f64, f64) -> f64, start| {
            line.fitted().map(|p| p.evaluations).fold(start, pick)
        };
        let smallest = line.points.iter().map(|p| p.error).fold(f64::MAX, f64::min);
        table.add_row([
            line.dimension.to_string(),
            line.method.name().into(),
            format!("{} to {}", ends(f64::min, f64::MAX), ends(f64::max, 0.0)),
            line.fitted().count().to_string(),
            signed(line.fit.slope, 3),
            format!("{:.4}", line.fit.scatter),
            line.theory().to_string(),
            signed(line.fit.slope - line.theory().slope(), 3),
            format!("{smallest:.1e}"),
        ]);
    }
    for column in [0, 2, 3, 4, 5, 6, 7, 8] {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    println!("{table}");
    println!(
        "Integrand: the product over the axes of 2/(1 + x)², integral 1. Errors of random methods: root mean \
         square of {repetitions} runs.\n\
         Slopes: least squares in the logarithms; ± is the standard error that the residuals give. A slope may \
         differ from theory by {TOLERANCE}: four standard deviations of the line that scatters most over seeds \
         (0.012), and its mean distance.\n\
         Trapezoid and Simpson evaluate n + 1 points an axis for n intervals: finite n makes their slopes steeper \
         by the factor 1 + 1/n."
    );
    for line in lines {
        let lost = line.points.iter().filter(|p| p.used == Use::Floor).count();
        if lost > 0 {
            println!("{}", lost_text(line, lost));
        }
    }
}

/// Says of a line where it stops falling and why.
fn lost_text(line: &Line, lost: usize) -> String {
    let (name, s) = (line.method.name(), line.dimension);
    let points = if lost == 1 { "point" } else { "points" };
    format!("Floor: {name} in {s}-D, {lost} {points} below {FLOOR:.1e} left out: rounding in f64.")
}
