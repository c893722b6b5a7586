//! The tables on the terminal: the sampling tables, the controls, and the light estimates.

use crate::controls::Control;
use crate::light::{DIRECTIONS, Quantity, REPETITIONS};
use crate::study::Study;
use support::draw::text::thousands;
use support::table::{self, print};
use support::verdict::{ALARM, Outcome};

/// A p-value, in scientific notation where it is extreme.
pub fn p_text(outcome: &Outcome) -> String {
    match outcome {
        Err(fault) => fault.clone(),
        Ok((_, _, p)) => table::p_text(*p),
    }
}

fn chi_text(outcome: &Outcome) -> String {
    match outcome {
        Err(_) => "none".into(),
        Ok((chi2, dof, _)) => format!("{chi2:.0} / {dof}"),
    }
}

pub fn studies(studies: &[Study], mapping: Option<&str>) {
    let mut header = vec![""];
    header.extend(studies.iter().map(|study| study.name));
    let row = |name: &str, text: &dyn Fn(&Study) -> String| {
        let mut row = vec![name.to_string()];
        row.extend(studies.iter().map(text));
        row
    };
    let compiled = |study: &Study| study.build.is_none();
    let rows = vec![
        row("columns × rows", &|s| {
            format!("{} × {}", s.shape[0], s.shape[1])
        }),
        row("bytes of words", &|s| thousands(s.bytes[0])),
        row("of these in RAM", &|s| match compiled(s) {
            true => "0".into(),
            false => thousands(s.bytes[0]),
        }),
        row("size_of_val of the table", &|s| thousands(s.bytes[1])),
        row("build time", &|s| match s.build {
            None => "none: compiled".into(),
            Some(seconds) => format!("{:.2} ms", 1e3 * seconds),
        }),
        row("samples a second", &|s| {
            format!("{:.1} million", 1e-6 * s.samples_a_second)
        }),
        row("χ² / degrees of freedom", &|s| chi_text(&s.outcome)),
        row("p-value", &|s| p_text(&s.outcome)),
        row("pdf of the brightest texel, per sr", &|s| {
            format!("{:.3}", s.peak)
        }),
        row("largest relative error of a pdf", &|s| {
            format!("{:.1e}", s.worst)
        }),
    ];
    print(&header, rows, 1);
    if let Some(permissions) = mapping {
        println!(
            "The 32 × 16 table is a `static` that lies in a mapping {permissions}, like a device's flash.\n"
        );
    }
}

pub fn controls(controls: &[Control]) {
    let rows = controls.iter().map(|control| {
        vec![
            control.name.to_string(),
            chi_text(&control.outcome),
            p_text(&control.outcome),
        ]
    });
    print(
        &["wrong on purpose", "χ² / degrees of freedom", "p-value"],
        rows.collect(),
        1,
    );
    println!(
        "χ²: samples against the picture's own probabilities in f64, cells expecting fewer than 5 pooled; \
         a p-value below {ALARM:.0e},\nor a sample in a black cell, is a rejection.\n"
    );
}

pub fn light(quantities: &[Quantity]) {
    let mut rows = Vec::new();
    for quantity in quantities {
        let best = quantity.ways.first().map_or(f64::NAN, |way| way.rms);
        for way in &quantity.ways {
            rows.push(vec![
                quantity.name.to_string(),
                way.name.to_string(),
                format!("{:.5}", quantity.exact),
                format!("{:.5}", way.mean),
                format!("{:.5}", way.rms),
                format!("{:.3} %", 100.0 * way.rms / quantity.exact),
                match (way.rms / best).powi(2) {
                    ratio if ratio < 1e9 => format!("{ratio:.0}"),
                    ratio => format!("{ratio:.0e}"),
                },
            ]);
        }
    }
    let header = [
        "quantity",
        "directions",
        "exact",
        "mean",
        "RMS error",
        "relative",
        "variance / table's",
    ];
    print(&header, rows, 2);
    println!(
        "RMS error: of an estimate from {DIRECTIONS} directions, over {REPETITIONS} of them; the mean \
         is that of all.\n\
         Of the mean radiance the table is the very integrand: what is left is the rounding of its densities."
    );
}
