//! What is measured of each parameter set: held to what the documentation states, and written as `docs/accuracy.md`.

use host::docs::{Page, Statement, of_floats, rounded_up};
use host::figures::{Figures, ROWS};
use host::registry::Measure;
use host::root;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;

/// What one parameter set showed.
pub struct Measured {
    pub name: &'static str,
    pub parameters: &'static str,
    pub measure: Measure,
    /// In `libm`, then in `poly`; once where there is no tier.
    pub figures: Vec<Figures>,
}

fn unit(measure: Measure) -> &'static str {
    match measure {
        Measure::Ulp => "ulp",
        Measure::UlpOf(_) => "ulp of the scale",
        Measure::UlpFrom(..) => "ulp of location or distance",
        Measure::UlpAbove(_) => "ulp of itself or of a length",
        Measure::Length(_) => "of the size",
        Measure::From(_) => "of the distance or the location",
    }
}

/// Two significant digits, rounded up, so that the printed bound holds.
fn printed(x: f64) -> String {
    let up = rounded_up(x, 2);
    if up == 0.0 {
        "0".into()
    } else if (0.01..1000.0).contains(&up) {
        let text = format!("{up:.3}");
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        format!("{up:.1e}")
    }
}

/// Whether a row is one that some warps have and others do not.
fn some(title: &str) -> bool {
    title.contains('θ')
        || [
            "unit length",
            "place on it",
            "pdf with the sample, relative",
        ]
        .contains(&title)
}

/// The rows of one warp's table: the title, and what was found in each tier.
fn summary(group: &[&Measured]) -> Vec<(String, Vec<f64>)> {
    let mut worst = vec![Figures::default(); group[0].figures.len()];
    for m in group {
        assert_eq!(m.figures.len(), worst.len(), "{}", m.name);
        for (worst, figures) in worst.iter_mut().zip(&m.figures) {
            worst.join(*figures);
        }
    }
    let mut rows = Vec::new();
    for (title, row) in ROWS {
        let values: Vec<f64> = worst.iter().map(|f| *row(&mut f.clone())).collect();
        let shown = !some(title) || values.iter().any(|x| *x != 0.0);
        if shown {
            let title = match title {
                "sample" => format!("sample, {}", unit(group[0].measure)),
                other => other.into(),
            };
            rows.push((title, values));
        }
    }
    rows
}

/// The warps by the name of their struct: `"Power decreasing"` belongs to `Power`.
fn by_struct(measured: &[Measured]) -> BTreeMap<&str, Vec<&Measured>> {
    let mut groups: BTreeMap<&str, Vec<&Measured>> = BTreeMap::new();
    for m in measured {
        let name = m.name.split(' ').next().unwrap();
        groups.entry(name).or_default().push(m);
    }
    groups
}

/// Complains of every number that is exceeded, and of every row that is missing or made up. Formulas, and whether a
/// bound is too large, are the adversary's business.
pub fn check(measured: &[Measured]) {
    let mut complaints = String::new();
    for (name, group) in by_struct(measured) {
        compare(name, &summary(&group), &of_floats(name), &mut complaints);
    }
    let text = fs::read_to_string(root().join("docs/accuracy.md")).unwrap_or_default();
    if !Page(&text).states(&full_table(measured)) {
        complaints.push_str("docs/accuracy.md is not what is measured\n");
    }
    assert!(complaints.is_empty(), "\n{complaints}");
}

fn compare(
    name: &str,
    measured: &[(String, Vec<f64>)],
    stated: &[(String, [Statement; 2])],
    complaints: &mut String,
) {
    let (found, titles): (Vec<_>, Vec<_>) = (
        measured.iter().map(|r| &r.0).collect(),
        stated.iter().map(|r| &r.0).collect(),
    );
    if found != titles {
        let _ = writeln!(complaints, "{name}: rows {titles:?}, measured {found:?}");
        return;
    }
    for ((title, found), (_, bound)) in measured.iter().zip(stated) {
        if found.len() == 1 && !bound[0].is(&bound[1]) {
            let _ = writeln!(complaints, "{name} has no tier, and two bounds: {title}");
        }
        let found = found.iter().cycle().zip(bound);
        for (tier, (found, bound)) in ["libm", "poly"].iter().zip(found) {
            let Some(bound) = bound.number() else {
                continue;
            };
            let holds = *found <= bound;
            if !holds {
                let _ = writeln!(
                    complaints,
                    "{name} {tier}: {title}: stated {bound}, measured {found:.4e}"
                );
            }
        }
    }
}

/// What the page says before the rows of its table.
const HEAD: &str = "\
# Measured errors

Largest errors found against formulas in `f64`, for listed parameter sets. Each cell is `libm` / `poly`; what has no
tier has one figure. The bounds that hold for every parameter are on each warp's page.

There the last column says of which kind the bounds of a row are. *Proven*: no input exceeds them, by an argument that
`docs/proofs.md` gives. *Exhaustive*: all inputs have been tried. *Found*: a search over parameters and uniforms has met no
case that exceeds them. It goes on for as long as one likes and might still meet more, so that what is found is stated with a
margin: at least 1.3 times the worst that a long search has met. The tests search anew, know the worst cases of earlier
searches (`tests/*/worst.csv`), and refuse a bound that is exceeded, one that no known case reaches 1/2.5 of, and one that a
known case leaves no such margin.

- Warps of one uniform, and sin θ and cos θ of directions: every 5th of the 2^24 inputs of the grid for the first parameter set of
  a warp, every 325th for the others; draws, densities and inverses at every 7th of these. `MICROWARP_FULL=all` tries all
  inputs (`tests/accuracy/inputs.rs`).
- Warps of several uniforms: 2^19 points of the grid for the first set, 2^17 for the others.
- All edges of the unit cube are always included.
- *pdf*: the density at the returned point. *Realised*: against the density with which the map arrives there.
- *Place*: on a light, in barycentric coordinates or along its edges.
- *With the sample*: the density that `sample_with_pdf` hands over, against the same; a dash where that is `pdf` of the point.
- *Inverse*: at the returned point. *Round trip*: the uniforms after `sample` and `invert`.
- A dash: the figure does not apply, or `f32` cannot hold the distribution well enough to recover the uniforms.

`MICROWARP_WRITE=1 cargo test --test accuracy` writes this page, and `MICROWARP_FULL=1 cargo test` compares it with what it
measures.

| warp | parameters | sample | unit | sin θ, ulp | cos θ, ulp | unit length | place | pdf, rel. | realised, rel. | with the sample, rel. | inverse | round trip |
|---|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|
";

/// The table of every parameter set.
fn full_table(measured: &[Measured]) -> String {
    let mut text = String::from(HEAD);
    for m in measured {
        let mut cells = Vec::new();
        for (title, row) in ROWS {
            let values: Vec<f64> = m.figures.iter().map(|f| *row(&mut f.clone())).collect();
            let nothing = values.iter().all(|x| *x == 0.0);
            let figures: Vec<String> = values.into_iter().map(printed).collect();
            let dash = nothing && (some(title) || title == "round trip");
            cells.push(if dash {
                "–".into()
            } else {
                figures.join(" / ")
            });
            if title == "sample" {
                cells.push(unit(m.measure).into());
            }
        }
        let _ = writeln!(
            text,
            "| {} | {} | {} |",
            m.name,
            m.parameters,
            cells.join(" | ")
        );
    }
    text
}

/// Writes the table anew. What doc comments state is written by hand.
pub fn write(measured: &[Measured]) {
    fs::create_dir_all(root().join("docs")).unwrap();
    fs::write(root().join("docs/accuracy.md"), full_table(measured)).unwrap();
}
