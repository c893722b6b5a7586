//! The picture of error against cost, from what is recorded: errors and times on the host in `docs/measured/tradeoff.csv`,
//! cycles and instructions in `counts.csv`. And the table of what is cheapest.

mod figure;
mod labels;
mod panel;
pub mod record;

use crate::sources::grouped;
use crate::tables::rows;
use microwarp_host::counts::Counts;
use microwarp_host::registry::evidence::PICTURED;
use microwarp_host::upkeep::{Outcome, root};
use record::Row;

/// Where costs are known: how it is called, and its name in `counts.csv`.
pub const TARGETS: [(&str, &str); 4] = [
    ("host", ""),
    ("Cortex-M0", "m0"),
    ("Cortex-M4F", "m4f"),
    ("WASM", "wasm"),
];

/// A sampler on a target.
#[derive(Clone, PartialEq)]
pub struct Point {
    pub tier: String,
    pub name: String,
    pub ours: bool,
    pub error: f64,
    /// What a sample costs, the generator included: nanoseconds, cycles, or instructions of WASM.
    pub cost: f64,
    /// The longest that a sample has been seen to take, where that is known.
    pub longest: Option<f64>,
}

impl Point {
    /// Whether this is as cheap and as accurate as the other, or better.
    fn covers(&self, other: &Self) -> bool {
        self.cost <= other.cost && self.error <= other.error
    }
}

/// The places of the points that no other one covers, the cheapest first; of equal ones the first.
pub fn front(points: &[Point]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| {
        let (a, b) = (&points[a], &points[b]);
        a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error))
    });
    let mut least = f64::INFINITY;
    order.retain(|&i| {
        let leads = points[i].error < least;
        least = least.min(points[i].error);
        leads
    });
    order
}

/// The points of a family on a target.
fn points(rows: &[Row], counts: &Counts, family: &str, core: &str) -> Vec<Point> {
    let of_family = rows.iter().filter(|row| row.family == family);
    let point = |row: &Row| {
        let (cost, longest) = match core {
            "" => (row.ns, None),
            _ => of_core(counts, &row.kernel, core)?,
        };
        Some(Point {
            tier: row.tier.clone(),
            name: row.name.clone(),
            ours: !["plain libm", "micromath", "rand_distr"].contains(&&*row.tier),
            error: row.error,
            cost: if core.is_empty() {
                cost
            } else {
                cost * row.calls
            },
            longest: longest.map(|longest| longest * row.calls),
        })
    };
    of_family.filter_map(point).collect()
}

/// The mean of a call and the longest one, in cycles; of WASM, instructions. The inputs of a warp are swept where they are
/// given, and the generator takes what a mean is longer with it.
fn of_core(counts: &Counts, kernel: &str, core: &str) -> Option<(f64, Option<f64>)> {
    let drawn = format!("{kernel}_pcg32");
    let of = |name: &str, column| counts.number(name, core, column);
    if core == "wasm" {
        return Some((of(&drawn, "instructions")?, None));
    }
    let (mean, longest) = (of(&drawn, "cycles_high")?, of(&drawn, "longest")?);
    let given = of(kernel, "longest").zip(of(kernel, "cycles_high"));
    let given = given.map_or(longest, |(longest, given)| longest + mean - given);
    Some((mean, Some(longest.max(given))))
}

/// The points in every panel of the picture: a row for each family, a column for each target.
pub type Panels = Vec<(&'static str, [Vec<Point>; TARGETS.len()])>;

fn panels(counts: &Counts) -> Outcome<Panels> {
    let rows = record::read()?;
    let of = |family| TARGETS.map(|(_, core)| points(&rows, counts, family, core));
    let panels = PICTURED.map(|family| (family, of(family))).to_vec();
    for (family, columns) in &panels {
        for points in columns {
            let front = front(points);
            let covered = |point| front.iter().any(|i| points[*i].covers(point));
            let covers = |i: usize, j: usize| i != j && points[i].covers(&points[j]);
            let alone = |i: &usize| !front.iter().any(|j| covers(*j, *i));
            if front.is_empty() || !points.iter().all(covered) || !front.iter().all(alone) {
                return Err(format!("{family}: the front is none"));
            }
        }
    }
    Ok(panels)
}

pub fn step(check: bool) -> Outcome {
    record::check()?;
    let canvas = figure::draw(&panels(&Counts::read()?)?)?;
    if check {
        Ok(())
    } else {
        canvas.save(&root().join("docs/tradeoff.png"))
    }
}

/// Errors that a user may want to stay below.
const CLASSES: [(&str, f64); 4] = [
    ("1e-3", 1e-3),
    ("1e-5", 1e-5),
    ("1e-6", 1e-6),
    ("5e-7", 5e-7),
];

/// The cheapest of ours whose largest error is within a bound; of bounds with the same answers the tightest.
pub fn cheapest(counts: &Counts) -> Outcome<String> {
    let panels = panels(counts)?;
    let mut text = format!("| | error to | {} |\n", PICTURED.join(" | "));
    text += &format!("|---|--:|{}\n", "---|".repeat(PICTURED.len()));
    for (target, (title, core)) in TARGETS.iter().enumerate() {
        let cheapest = |bound: f64, points: &[Point]| {
            let good = points.iter().filter(|p| p.ours && p.error <= bound);
            match good.min_by(|a, b| a.cost.total_cmp(&b.cost)) {
                None => "-".into(),
                Some(Point { tier, cost, .. }) if core.is_empty() => format!("{tier} {cost:.1}"),
                Some(best) => format!("{} {}", best.tier, grouped(best.cost.round() as u64)),
            }
        };
        let answers = |bound| -> Vec<String> {
            let columns = panels.iter().map(|(_, columns)| &columns[target]);
            columns.map(|points| cheapest(bound, points)).collect()
        };
        for (i, (class, bound)) in CLASSES.into_iter().enumerate() {
            let tighter = CLASSES.get(i + 1).map(|(_, bound)| answers(*bound));
            if tighter.as_ref() != Some(&answers(bound)) {
                let cells = [vec![(*title).into(), class.into()], answers(bound)];
                text += &rows(&[cells.concat()]);
            }
        }
    }
    Ok(text)
}
