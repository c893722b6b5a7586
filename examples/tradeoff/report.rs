//! The tables on the terminal, and the same as CSV.

use crate::bias::Shows;
use crate::controls::Control;
use crate::costs::{CORES, Cost};
use crate::study::Study;
use host::draw::text::thousands;
use host::table::{self, p_text};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Stands for a value that is unknown or does not apply.
pub const DASH: &str = "–";

/// An error, to two digits.
pub fn error_text(error: f64) -> String {
    if error == 0.0 {
        "0".into()
    } else {
        format!("{error:.1e}")
    }
}

/// A cost, to the instruction or to three digits.
pub fn cost_text(cost: Option<f64>) -> String {
    match cost {
        None => DASH.into(),
        Some(cost) if cost < 100.0 => format!("{cost:.1}"),
        Some(cost) => thousands(cost.round() as usize),
    }
}

pub fn shows_text(shows: Shows) -> String {
    match shows {
        Shows::After(samples) => format!("{samples:.1e}"),
        Shows::NotBelow(samples) => format!("> {samples:.0e}"),
    }
}

/// The name of a row, with its family if that differs from the row before.
fn heads(studies: &[Study]) -> impl Iterator<Item = Vec<String>> {
    let before = std::iter::once("").chain(studies.iter().map(|s| s.sampler.family));
    studies.iter().zip(before).map(|(study, before)| {
        let sampler = &study.sampler;
        let family = if sampler.family == before {
            ""
        } else {
            sampler.family
        };
        let peer = if sampler.ours { "" } else { " ◆" };
        vec![
            family.into(),
            sampler.name.clone(),
            format!("{}{peer}", sampler.tier),
        ]
    })
}

/// The table of errors.
pub fn quality(studies: &[Study], samples: usize, threshold: f64) {
    let rows = heads(studies).zip(studies).map(|(mut row, study)| {
        let (point, density) = (&study.errors.point, &study.errors.density);
        let least = if study.sampler.errs_at_least() {
            "≥ "
        } else {
            ""
        };
        for (figures, least) in [(point, least), (density, "")] {
            let cells = [figures.max, figures.rms(), figures.mean()];
            let text = |x| format!("{least}{}", error_text(x));
            row.extend(cells.map(|x| {
                if figures.is_known() {
                    text(x)
                } else {
                    DASH.into()
                }
            }));
        }
        row.push(p_text(study.shape.worst()));
        row.push(shows_text(study.shows));
        row
    });
    let header = [
        "family",
        "sampler",
        "tier",
        "point, max",
        "rms",
        "mean",
        "density, max",
        "rms",
        "mean",
        "worst p",
        "bias shows after",
    ];
    table::print(&header, rows.collect(), 3);
    println!(
        "◆ somebody else's. point: distance from the exact map of the same uniforms, in f64; of samplers that reject, \
         which are exact\nin law, what rounding to the numbers they return adds (a point of the law to the nearest \
         number: half an ulp a coordinate), and\nof those that compute with what they accept, what is seen of that (≥); of \
         tables, the probability of an entry. The grid of uniforms\nis counted against nobody. mean: the shift of the \
         mean. density: at the returned point, of the largest. worst p: chi-square and\nKolmogorov-Smirnov of {} \
         samples mapped back by the exact inverse; below {threshold:.1e} is a failure. bias shows after: so many\n\
         samples make a chi-square test over the same cells ({} on the line, {} in the plane) reject at 1 % one time \
         in two, by what the\nmap does to every cell's probability, uniforms of 24 or 32 bits included; \
         > where only a bound is known, by the noise of that\nestimate or, of samplers whose uniforms cannot be \
         chosen, by the samples of the test itself.\n",
        thousands(samples),
        crate::cells::count(1),
        crate::cells::count(2),
    );
}

/// The table of costs.
pub fn costs(studies: &[Study], spread: f64) {
    let rows = heads(studies).zip(studies).map(|(mut row, study)| {
        row.push(cost_text(study.times.draw));
        row.push(cost_text(study.times.fill));
        for ((core, _), cost) in CORES.iter().zip(study.costs) {
            row.extend(cells(core, cost).into_iter().map(cost_text));
        }
        row
    });
    let mut header: Vec<String> = ["family", "sampler", "tier", "ns, drawn", "ns, filled"]
        .map(String::from)
        .into();
    for (core, _) in CORES {
        let title = |title: &&str| format!("{} {title}", core.to_uppercase());
        header.extend(titles(core).iter().map(title));
    }
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    table::print(&header, rows.collect(), 3);
    println!(
        "ns: on this host, with PCG32, one by one and into a slice of 1024. Of the cores: executed instructions (of WASM, \
         operators) at\nopt-level 3, the uniforms given and with PCG32; cycles with PCG32 by the manuals' tables at zero \
         wait states, the mean and the\nlongest seen; bytes of code and tables at opt-level s, of stack at 3; from \
         crates/cores.\n{DASH}: not measured. Two normals: what gives one at a time is drawn twice. Half of all times lay within \
         {:.0} % of each other.\n",
        100.0 * spread
    );
}

/// What is known of a core, by the names in the table.
fn titles(core: &str) -> &'static [&'static str] {
    match core {
        "wasm" => &["insn", "+ PCG32", "flash", "stack"],
        _ => &["insn", "+ PCG32", "cycles", "longest", "flash", "stack"],
    }
}

fn cells(core: &str, cost: Cost) -> Vec<Option<f64>> {
    let cycles = match core {
        "wasm" => vec![],
        _ => vec![
            cost.cycles.map(|cycles| cycles.mean),
            cost.cycles.map(|cycles| cycles.longest),
        ],
    };
    let (first, last) = ([cost.given, cost.drawn], [cost.flash, cost.stack]);
    [&first[..], &cycles, &last].concat()
}

pub fn controls(controls: &[Control]) {
    let rows = controls.iter().map(|control| {
        let rejected = control
            .rejected
            .map(|(rejected, of)| format!("{rejected} of {of}"));
        vec![
            control.name.into(),
            p_text(control.shape.worst()),
            format!("{:.4e} ± {:.0e}", control.bias.lambda, control.bias.error),
            format!("{:.4e}", control.exact),
            shows_text(control.bias.shows()),
            format!("{:.1e}", control.due()),
            rejected.unwrap_or(DASH.into()),
        ]
    });
    let header = [
        "control",
        "worst p",
        "noncentrality a sample",
        "in truth",
        "shows after",
        "in truth",
        "tests that reject then",
    ];
    table::print(&header, rows.collect(), 1);
}

/// The whole table, one line per sampler.
pub fn write(studies: &[Study], path: &Path) -> Result<(), String> {
    let mut text = String::from(
        "family,sampler,tier,ours,point_max,point_rms,point_mean,coordinate_max,density_max,density_rms,density_mean,\
         density_relative_max,p_chi_square,p_kolmogorov_smirnov,noncentrality,noncentrality_error,bias_shows_after,\
         bias_is_bound,ns_drawn,ns_filled",
    );
    for (core, _) in CORES {
        for title in titles(core) {
            let _ = write!(
                text,
                ",{core}_{}",
                title.replace("+ ", "insn_").to_lowercase()
            );
        }
    }
    text.push('\n');
    for study in studies {
        let (sampler, errors) = (&study.sampler, &study.errors);
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        let mut cells = vec![
            quoted(sampler.family),
            quoted(&sampler.name),
            quoted(sampler.tier),
            sampler.ours.to_string(),
        ];
        let number = |x: f64| format!("{x:e}");
        let known = |known: bool, x: f64| if known { number(x) } else { String::new() };
        let (point, density) = (&errors.point, &errors.density);
        let at = point.is_known();
        cells.extend(
            [point.max, point.rms(), point.mean(), errors.coordinate].map(|x| known(at, x)),
        );
        let of = density.is_known();
        cells.extend(
            [density.max, density.rms(), density.mean(), errors.relative].map(|x| known(of, x)),
        );
        let distances = study.shape.p[1..].iter().copied();
        cells.push(number(study.shape.p[0]));
        cells.push(number(distances.fold(f64::INFINITY, f64::min)));
        let bias = study.bias.map(|bias| [bias.lambda, bias.error].map(number));
        cells.extend(bias.unwrap_or_default());
        let (samples, bound) = match study.shows {
            Shows::After(samples) => (samples, false),
            Shows::NotBelow(samples) => (samples, true),
        };
        cells.extend([number(samples), bound.to_string()]);
        let cost = |cost: Option<f64>| {
            cost.map_or(String::new(), |x| format!("{}", (x * 10.0).round() / 10.0))
        };
        cells.extend([study.times.draw, study.times.fill].map(cost));
        for ((core, _), costs) in CORES.iter().zip(study.costs) {
            cells.extend(self::cells(core, costs).into_iter().map(cost));
        }
        let _ = writeln!(text, "{}", cells.join(","));
    }
    fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}
