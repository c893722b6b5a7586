//! The tables on the terminal: the runs, the truth beside what long runs measure, and the controls.

use crate::controls::Control;
use crate::ladder::{Ladder, Time};
use crate::run::variation;
use crate::study::{AGREED, Study};
use support::draw::text::thousands;
use support::mean::deviation_text;
use support::table;
use support::verdict::{ALARM, Outcome};

/// A time in steps, to three digits.
pub fn steps_text(steps: f64) -> String {
    match steps {
        s if s >= 1000.0 => {
            let unit = 10f64.powf(s.log10().floor() - 2.0);
            thousands(((s / unit).round() * unit) as usize)
        }
        s if s >= 100.0 => format!("{s:.0}"),
        s if s >= 10.0 => format!("{s:.1}"),
        s => format!("{s:.2}"),
    }
}

pub fn time_text(ladder: &Ladder<64>) -> String {
    ladder
        .time()
        .map_or("unknown".into(), |time| steps_text(time.steps))
}

fn p_text(outcome: &Outcome) -> String {
    match outcome {
        Err(fault) => fault.clone(),
        Ok((chi2, dof, p)) => format!("{chi2:.1} / {dof}, p {}", table::p_text(*p)),
    }
}

pub fn runs(studies: &[Study]) {
    let mut rows = Vec::new();
    for study in studies {
        for pair in &study.pairs {
            let run = &pair.runs[0];
            let theory = |k: usize| match study.is_long(pair.steps) {
                true => format!(
                    "{:.4}",
                    study.truth.variation[k] / (pair.steps as f64).sqrt()
                ),
                false => "none".into(),
            };
            let size = run.x.time().map_or("unknown".into(), |time: Time| {
                steps_text(pair.steps as f64 / time.steps)
            });
            rows.push(vec![
                study.rule.name().to_string(),
                thousands(pair.steps as usize),
                format!("{:.2} %", 100.0 * run.acceptance),
                format!("{:.4}", variation(&run.plain)),
                theory(0),
                format!("{:.4}", variation(&run.expected)),
                theory(1),
                time_text(&run.x),
                time_text(&run.left),
                size,
                format!("{:.4}", pair.r_hat),
                format!("{:.1} %", 100.0 * run.left_share()),
                thousands(run.crossings as usize),
                pair.outcome.as_ref().map_or("too short".into(), p_text),
            ]);
        }
    }
    let header = [
        "mutation",
        "steps",
        "accepted",
        "TV",
        "theory",
        "TV, weighted",
        "theory",
        "τ of x",
        "τ of left",
        "ESS of x",
        "split R̂",
        "time left",
        "crossings",
        "χ² / dof",
    ];
    table::print(&header, rows, 1);
    println!(
        "TV: total variation between the histogram and exact probabilities; weighted: both \
         states of each step, by 1 − a and a.\n\
         theory: what it should be on average, where the run is at least 100 relaxation times long. τ: integrated \
         autocorrelation time\n\
         in steps, of x and of whether x < 1/2, by `Autocorrelation` of every state, every 4th, every 16th ...: the first \
         that knows it.\n\
         ESS: steps over τ. split R̂: of this run, which starts at 0.1, and another, from 0.9; above {AGREED} they \
         do not agree.\n\
         χ²: of states 8 relaxation times apart."
    );
    for study in studies {
        for pair in study.pairs.iter().filter(|pair| pair.r_hat > AGREED) {
            println!(
                "{}, {} steps: not converged. R̂ {:.3} from starts in both humps; from two in the left one it \
                 is {:.3}.",
                study.rule.name(),
                thousands(pair.steps as usize),
                pair.r_hat,
                pair.together
            );
        }
    }
    println!();
}

pub fn truths(studies: &[Study]) {
    let mut rows = Vec::new();
    for study in studies {
        let (truth, long) = (&study.truth, &study.long);
        let mut row = vec![
            study.rule.name().to_string(),
            steps_text(truth.relaxation()),
            thousands(long.steps as usize),
            format!("{:.3}", 100.0 * truth.acceptance),
            long.acceptance.beside(truth.acceptance, 3, 100.0),
        ];
        for (time, exact) in long.times.iter().zip(truth.times) {
            row.push(steps_text(exact));
            row.push(time.map_or("unknown".into(), |time| {
                let off = deviation_text((time.steps / exact - 1.0) / long.spread);
                format!("{} ({off})", steps_text(time.steps))
            }));
        }
        row.push(format!("{:.1}", 1e6 * truth.crossing));
        row.push(long.crossing.beside(truth.crossing, 1, 1e6));
        row.push(long.left.beside(0.5, 2, 100.0));
        row.push(format!(
            "{}: {}",
            thousands(long.samples as usize),
            p_text(&long.outcome)
        ));
        rows.push(row);
    }
    let header = [
        "mutation",
        "relaxation",
        "long run",
        "acceptance, %",
        "measured",
        "τ of x",
        "measured",
        "τ of left",
        "measured",
        "crossings / 10⁶",
        "measured",
        "time left, %",
        "χ² / dof of states apart",
    ];
    table::print(&header, rows, 1);
    let doubt = studies.iter().map(|s| s.doubt).fold(0.0, f64::max);
    println!(
        "Truth: transition matrices of 400 and 800 cells in f64, extrapolated; the finer is at most {:.2} % off \
         that. relaxation: −1/ln λ₂ steps.",
        100.0 * doubt
    );
    for study in studies {
        if let Some(time) = study.long.times[0].filter(|time| time.stride > 1) {
            println!(
                "τ of {} measured from {} states, {} steps apart: ± {:.1} %.",
                study.rule.name(),
                thousands(time.numbers as usize),
                thousands(time.stride as usize),
                100.0 * study.long.spread
            );
        }
    }
    println!();
}

pub fn controls(controls: &[Control]) {
    let rows = controls.iter().map(|control| {
        vec![
            control.name.clone(),
            thousands(control.samples as usize),
            p_text(&control.outcome),
        ]
    });
    table::print(
        &["wrong on purpose", "states apart", "χ² / dof"],
        rows.collect(),
        1,
    );
    println!("A p-value below {ALARM:.0e} is a rejection.");
}
