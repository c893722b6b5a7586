//! The stated bounds: where they stand in the documentation, how they are read, checked and written.

use crate::adversary::statement::Statement;
use crate::figures::{Figures, ROWS};
use crate::registry::Measure;
use crate::{root, speed};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// What one parameter set showed, in both tiers.
pub struct Measured {
    pub name: &'static str,
    pub parameters: &'static str,
    pub measure: Measure,
    /// `libm`, then `poly`.
    pub figures: [Figures; 2],
}

fn unit(measure: Measure) -> &'static str {
    match measure {
        Measure::Ulp => "ulp",
        Measure::UlpOf(_) => "ulp of the scale",
        Measure::UlpFrom(_) => "ulp of mean or deviate",
        Measure::Length(_) => "of the size",
    }
}

/// Two significant digits, rounded up, so that the printed bound holds.
fn rounded_up(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let magnitude = 10f64.powi(x.log10().floor() as i32 - 1);
    let up = (x / magnitude * (1.0 - 1e-12)).ceil() * magnitude;
    if (0.01..1000.0).contains(&up) {
        let text = format!("{up:.3}");
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        format!("{up:.1e}")
    }
}

/// The rows of one warp's table: title, bound in `libm`, bound in `poly`.
fn summary(group: &[&Measured]) -> Vec<(String, [f64; 2])> {
    let mut worst = [Figures::default(); 2];
    for m in group {
        for (worst, figures) in worst.iter_mut().zip(m.figures) {
            worst.join(figures);
        }
    }
    let mut rows = Vec::new();
    for (title, row) in ROWS {
        let values = worst.map(|mut f| *row(&mut f));
        let polar = title.contains('θ') || title == "unit length";
        let shown = !polar || values != [0.0; 2];
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

/// The source file and the lines of the doc comment of a struct.
fn doc_comment(name: &str) -> (PathBuf, Vec<String>, std::ops::Range<usize>) {
    let mut found = None;
    let rooms = ["src/warp", "src/discrete"].map(|room| fs::read_dir(root().join(room)).unwrap());
    for path in rooms.into_iter().flatten().map(|e| e.unwrap().path()) {
        let text = fs::read_to_string(&path).unwrap();
        let lines: Vec<String> = text.lines().map(Into::into).collect();
        let is_struct = |l: &String| {
            l.strip_prefix("pub struct ")
                .is_some_and(|r| r.split(['<', '(', ' ', ';']).next() == Some(name))
        };
        if let Some(end) = lines.iter().position(is_struct) {
            let start = (0..end)
                .rev()
                .find(|&i| !lines[i].starts_with("///") && !lines[i].starts_with("#["))
                .map_or(0, |i| i + 1);
            found = Some((path, lines, start..end));
        }
    }
    found.unwrap_or_else(|| panic!("no struct {name} in src/warp or src/discrete"))
}

const HEADER: &str = "| error | `libm` | `poly` |";

/// The table of a doc comment as title and the two bounds.
pub fn stated(name: &str) -> Vec<(String, [Statement; 2])> {
    let (path, lines, range) = doc_comment(name);
    let table = lines[range]
        .iter()
        .map(|l| l.trim_start_matches("///").trim())
        .skip_while(|l| *l != HEADER)
        .skip(2)
        .take_while(|l| l.starts_with('|'));
    let rows: Vec<_> = table.map(|l| parse_row(l, &path)).collect();
    assert!(
        !rows.is_empty(),
        "{name} states no errors in {}",
        path.display()
    );
    rows
}

fn parse_row(line: &str, path: &Path) -> (String, [Statement; 2]) {
    let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
    let statement = |i: usize| {
        cells
            .get(i)
            .and_then(|c| Statement::parse(c))
            .unwrap_or_else(|| panic!("no bound in {line:?} of {}", path.display()))
    };
    (cells[0].to_string(), [statement(1), statement(2)])
}

/// Complains of every number that is exceeded, and of every row that is missing or made up. Formulas, and whether a
/// bound is too large, are the adversary's business.
pub fn check(measured: &[Measured]) {
    let mut complaints = String::new();
    for (name, group) in by_struct(measured) {
        compare(name, &summary(&group), &stated(name), &mut complaints);
    }
    let text = fs::read_to_string(root().join("docs/accuracy.md")).unwrap_or_default();
    if !Page(&text).states(&full_table(measured)) {
        complaints.push_str("docs/accuracy.md is not what is measured\n");
    }
    assert!(complaints.is_empty(), "\n{complaints}");
}

fn compare(
    name: &str,
    measured: &[(String, [f64; 2])],
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
        for (tier, (found, bound)) in ["libm", "poly"].iter().zip(found.iter().zip(bound)) {
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

/// A page of the documentation that says what was measured.
pub struct Page<'a>(pub &'a str);

impl Page<'_> {
    /// Whether the page says what has been measured now, but for the last digit of a figure: the exact formulas run on
    /// the host's own `f64` functions. In the quick speed, which measures less, no figure may be above the page's.
    pub fn states(&self, measured: &str) -> bool {
        self.agrees(measured, speed::full())
    }

    fn agrees(&self, measured: &str, both_ways: bool) -> bool {
        let cells = |text: &str| -> Vec<String> {
            let cells = text.split(['|', '\n', '/']).map(str::trim);
            let cells = cells.filter(|cell| !cell.is_empty());
            cells.map(str::to_owned).collect()
        };
        let agree = |(stated, measured): (&String, &String)| {
            stated == measured
                || matches!((stated.parse::<f64>(), measured.parse::<f64>()),
                    (Ok(a), Ok(b)) if b - a <= 0.1 * a.abs().max(b.abs())
                        && (!both_ways || a - b <= 0.1 * a.abs().max(b.abs())))
        };
        let (stated, measured) = (cells(self.0), cells(measured));
        stated.len() == measured.len() && stated.iter().zip(&measured).all(agree)
    }
}

/// The table of every parameter set.
fn full_table(measured: &[Measured]) -> String {
    let mut text = String::from(
        "# Measured errors\n\n\
         Written by `MICROWARP_WRITE=1 cargo test --test accuracy` and compared with what is measured by every\n\
         `MICROWARP_FULL=1 cargo test`. Largest errors against `f64` formulas: of a sample over all 2^24 grid inputs (warps of\n\
         one uniform, and sin θ and cos θ of directions; every 13th input for further parameter sets of the same\n\
         warp) or over 2^24 points of the grid (several uniforms; 2^21 for further sets), always with all edges;\n\
         of the density at the returned point, and against the density with which the map arrives\n\
         there (realised); of the inverse at the returned point, and of u after sample and inverse. Each cell\n\
         is `libm` / `poly`. A dash: not applicable, or `f32` cannot hold the distribution well enough\n\
         to bring u back.\n\n\
         | warp | parameters | sample | unit | sin θ, ulp | cos θ, ulp | unit length | pdf, rel. | realised, rel. | inverse | round trip |\n\
         |---|---|--:|---|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for m in measured {
        let mut cells = Vec::new();
        for (title, row) in ROWS {
            let [a, b] = m.figures.map(|mut f| *row(&mut f));
            let dash = (a, b) == (0.0, 0.0)
                && (title.contains('θ') || title.contains("length") || title == "round trip");
            let cell = if dash {
                "–".to_string()
            } else {
                format!("{} / {}", rounded_up(a), rounded_up(b))
            };
            cells.push(cell);
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

#[cfg(test)]
mod tests {
    use super::Page;

    #[test]
    fn a_page_is_held_to_its_figures() {
        let page = Page("| Disk | 1.5e-7 / 2 |\n| Cone | – | 0 |\n");
        let agrees = |text: &str| [true, false].map(|both| page.agrees(text, both));
        assert_eq!(agrees(page.0), [true; 2]);
        assert_eq!(agrees("| Disk | 1.4e-7 / 2 |\n| Cone | – | 0 |"), [true; 2]);
        assert_eq!(
            agrees("| Disk | 1.0e-7 / 2 |\n| Cone | – | 0 |"),
            [false, true]
        );
        for wrong in [
            "| Disk | 1.9e-7 / 2 |\n| Cone | – | 0 |",
            "| Disk | NaN / 2 |\n| Cone | – | 0 |",
            "| Disk | 1.5e-7 / 2 |\n| Cone | – | 1e-9 |",
            "| Disk | 1.5e-7 / 2 |\n| Disk | – | 0 |",
            "| Disk | 1.5e-7 / 2 |",
        ] {
            assert_eq!(agrees(wrong), [false; 2], "{wrong}");
        }
    }
}
