//! The figures: as stated in the documentation of the maps, as proven, as found, and their table in `docs/proofs.md`.

use crate::maps::{MAPS, Outcome, Row};
use host::docs::{self, Page, STALE};
use host::speed;
use std::fmt::Write as _;
use std::sync::{Mutex, PoisonError};

/// The rows that are proven, as the table of a map calls them.
const TITLES: [&str; 4] = ["sample", "sin θ, ulp", "cos θ, ulp", "unit length"];

/// Three digits, rounded up.
fn rounded_up(x: f64) -> String {
    let up = docs::rounded_up(x, 3);
    if up > 0.01 {
        format!("{up:.3}")
    } else {
        format!("{up:.2e}")
    }
}

/// What a map states of each row, in `libm` and in `poly`; not a number where it states nothing.
pub fn stated(name: &str) -> [[f64; 2]; 4] {
    let table = docs::of_floats(name);
    // The size of a pair is its reach, 5.77 deviations.
    let size = if name == "NormalPair" { 5.77 } else { 1.0 };
    TITLES.map(|title| {
        let row = table.iter().find(|(t, _)| t.starts_with(title));
        row.map_or([f64::NAN; 2], |(_, cells)| {
            cells.each_ref().map(|cell| size * cell.number().unwrap())
        })
    })
}

/// By how much what is found may exceed what is proven of some of the inputs, which are not those that are searched.
const UNTRIED: f64 = 1.02;

/// What is wrong with a row whose proof is to come near what a search finds.
pub fn complaint(row: Row, stated: f64) -> Option<String> {
    judged(row, stated, row.proven <= STALE * row.found)
}

/// The same where half of what is stated is to be found.
pub fn complaint_of_half(row: Row, stated: f64) -> Option<String> {
    judged(row, stated, stated <= 2.0 * row.found)
}

fn judged(Row { proven, found }: Row, stated: f64, near: bool) -> Option<String> {
    // Each written so that NaN fails.
    let slack = if speed::full() { 1.0 } else { UNTRIED };
    let (holds, said) = (found <= proven * slack, proven <= stated);
    if !holds {
        Some(format!("found {found:.4e}, proven {proven:.4e}"))
    } else if !said {
        Some(format!("stated {stated}, proven {proven:.4e}"))
    } else if !near {
        Some(format!("proven {proven:.4e}, found only {found:.4e}"))
    } else {
        None
    }
}

/// Complains of rows that do not hold, of stated bounds beyond what is proven, and of a table that says otherwise. Each map
/// comes in both tiers, each tier with any uniforms and with those of the grid.
pub fn check(outcomes: &[[[Outcome; 2]; 2]]) {
    let mut complaints = String::new();
    let mut table = String::from(
        "| map | error | stated | proven | found | proven, grid | found, grid |\n\
         |---|---|--:|--:|--:|--:|--:|\n",
    );
    for (name, tiers) in MAPS.into_iter().zip(outcomes) {
        for (i, (title, stated)) in TITLES.into_iter().zip(stated(name)).enumerate() {
            if stated[0].is_nan() {
                continue;
            }
            let mut columns = [const { Vec::new() }; 5];
            for (tier, stated) in tiers.iter().zip(stated) {
                let [any, grid] = tier.each_ref().map(|outcome| outcome.rows[i]);
                for row in [any, grid] {
                    if let Some(complaint) = complaint(row, stated) {
                        let _ = writeln!(complaints, "{name}: {title}: {complaint}");
                    }
                }
                // What a normal pair states holds for all its parameters, too.
                let tight = stated <= 1.1 * any.proven || name == "NormalPair";
                if !tight {
                    let _ = writeln!(complaints, "{name}: {title}: {stated} may be less: {any:?}");
                }
                let figures = [stated, any.proven, any.found, grid.proven, grid.found];
                for (column, figure) in columns.iter_mut().zip(figures) {
                    column.push(rounded_up(figure));
                }
            }
            let cells = columns.map(|column| column.join(" / "));
            let _ = writeln!(table, "| {name} | {title} | {} |", cells.join(" | "));
        }
    }
    complaints.extend(differs("## The figures", &table));
    assert!(complaints.is_empty(), "\n{complaints}");
}

/// A row of a law of the line, in each tier that it has.
pub struct Line {
    pub name: &'static str,
    pub title: String,
    pub stated: Vec<f64>,
    pub rows: Vec<Row>,
    /// What is stated as a formula, of which the figures are parts.
    pub formula: Option<String>,
}

impl Line {
    /// Of samples for which a formula is stated: how `figures` come from it, as parts of what it gives.
    pub fn of_samples(
        name: &'static str,
        figures: impl FnOnce(&docs::Statement) -> Vec<Row>,
    ) -> Self {
        let mut rows = docs::of_floats(name).into_iter();
        let row = rows.find(|(title, _)| title.starts_with("sample"));
        let (title, [stated, _]) = row.expect("a row");
        let rows = figures(&stated);
        Self {
            name,
            title,
            stated: vec![1.0; rows.len()],
            rows,
            formula: Some(docs::rows_of_floats(name)[0].cells[0].clone()),
        }
    }
}

/// The same for laws of the line.
pub fn check_line(lines: &[Line]) {
    let mut complaints = String::new();
    for line in lines {
        for (row, stated) in line.rows.iter().zip(&line.stated) {
            if let Some(complaint) = complaint_of_half(*row, *stated) {
                let _ = writeln!(complaints, "{}: {}: {complaint}", line.name, line.title);
            }
        }
    }
    complaints.extend(differs("On the line *found*", &table_of(lines)));
    assert!(complaints.is_empty(), "\n{complaints}");
}

/// What is stated, proven and found, each in both tiers.
pub fn table_of(lines: &[Line]) -> String {
    let mut table = String::from(
        "| warp | error | stated | proven | found |\n\
         |---|---|--:|--:|--:|\n",
    );
    for Line {
        name,
        title,
        stated,
        rows,
        formula,
    } in lines
    {
        let proven = rows.iter().map(|row| row.proven).collect();
        let found = rows.iter().map(|row| row.found).collect();
        let cells = [stated.clone(), proven, found].map(|figures: Vec<f64>| {
            let figures: Vec<_> = figures.into_iter().map(rounded_up).collect();
            figures.join(" / ")
        });
        let [stated, proven, found] = cells;
        let stated = formula.clone().unwrap_or(stated);
        let _ = writeln!(
            table,
            "| {name} | {title} | {stated} | {proven} | {found} |"
        );
    }
    table
}

/// Writes a table into its place on the page, the first table behind these words, or says that the page has another. Nothing where it
/// has the rows of some warps alone.
pub fn differs(behind: &str, table: &str) -> Option<String> {
    // Tests that run at once write to one file.
    static PAGE: Mutex<()> = Mutex::new(());
    let _one = PAGE.lock().unwrap_or_else(PoisonError::into_inner);
    print!("{table}");
    if speed::is_narrowed() {
        return None;
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/proofs.md");
    let text = std::fs::read_to_string(path).unwrap();
    let words = text.find(&format!("\n{behind}")).unwrap() + 1;
    let start = words + text[words..].find("\n| ").unwrap() + 1;
    let end = text[start..]
        .find("\n\n")
        .map_or(text.len(), |end| start + end + 1);
    if std::env::var_os("MICROWARP_WRITE").is_some() {
        let text = [&text[..start], table, &text[end..]].concat();
        std::fs::write(path, text).unwrap();
        return None;
    }
    let same = Page(&text[start..end]).states(table);
    (!same).then(|| format!("{behind}: docs/proofs.md is not what is computed\n"))
}
