//! What the documentation of the crate states: tables of figures, found by the item they document, read, held to what
//! is measured, and written in place.

mod statement;

pub use statement::{Kind, Statement};

use crate::root;
use crate::speed;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

/// The sources of a room, such as `warp` or `tier/libm`: the file of that name and what lies in its folder.
pub fn sources(room: &str) -> Vec<(PathBuf, String)> {
    let place = root().join("src").join(room);
    let mut found = Vec::new();
    let mut open = vec![place.with_extension("rs"), place];
    while let Some(path) = open.pop() {
        if path.is_dir() {
            let entries = std::fs::read_dir(path).expect("a folder of the sources");
            open.extend(entries.map(|entry| entry.expect("a source").path()));
        } else if path.extension().is_some_and(|e| e == "rs") && path.exists() {
            let text = std::fs::read_to_string(&path).expect("a source is text");
            found.push((path, text));
        }
    }
    assert!(!found.is_empty(), "no room {room}");
    found.sort();
    found
}

/// A row of a table: what its first cell says, the others, and the kind of its bounds where the table has such a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub title: String,
    pub cells: Vec<String>,
    pub kind: Option<Kind>,
}

impl Row {
    pub fn new(title: &str, cells: impl IntoIterator<Item = String>) -> Self {
        Self {
            title: title.to_owned(),
            cells: cells.into_iter().collect(),
            kind: None,
        }
    }

    /// Reads a line of a table with this head: whether its last column is the kind, and whether it has one bound of both
    /// tiers, which is a cell of each.
    fn read(line: &str, head: &str) -> Self {
        let (has_kind, has_one) = (head.ends_with("| kind |"), head.contains("| bound |"));
        let line = line.trim_start_matches('|').trim_end_matches('|');
        let mut cells = line.split('|').map(|cell| cell.trim().to_owned());
        let title = cells.next().unwrap_or_default();
        let mut cells: Vec<String> = cells.collect();
        let kind = has_kind.then(|| cells.pop().unwrap_or_default());
        let kind = kind.map(|kind| {
            Kind::parse(&kind).unwrap_or_else(|| panic!("{title:?} is of no kind: {kind:?}"))
        });
        if has_one {
            cells.extend_from_within(..);
        }
        Self { title, cells, kind }
    }

    /// The row as it stands in a doc comment.
    pub fn line(&self) -> String {
        let kind = self.kind.map(|kind| format!(" {} |", kind.name()));
        let cells = self.cells.join(" | ");
        format!(
            "/// | {} | {cells} |{}",
            self.title,
            kind.unwrap_or_default()
        )
    }

    /// The numbers and formulas of a row of so many cells besides the title.
    pub fn statements<const N: usize>(&self) -> [Statement; N] {
        let cells = self.cells.iter().map(|cell| {
            Statement::parse(cell).unwrap_or_else(|| panic!("{:?} states {cell:?}", self.title))
        });
        let cells: Vec<_> = cells.collect();
        let count = cells.len();
        let array = cells.try_into();
        array.unwrap_or_else(|_| panic!("{:?} has {count} cells, not {N}", self.title))
    }
}

/// Where a column stands in the head of a table of errors. One bound is that of both float tiers.
pub fn column(head: &[String], name: &str) -> Option<usize> {
    let both = ["libm", "poly"].contains(&name);
    head.iter()
        .map(|cell| cell.trim_matches('`'))
        .position(|cell| cell == name || (both && cell == "bound"))
}

/// The doc comment of a public item.
pub struct Doc {
    path: PathBuf,
    lines: Vec<String>,
    /// The lines of the comment in the file, attributes among them.
    range: Range<usize>,
}

impl Doc {
    /// That of a type, trait or function of a room, by its name; nothing where the room has none.
    pub fn find(room: &str, item: &str) -> Option<Self> {
        let declares = |line: &str| {
            let rest = ["struct ", "trait ", "enum ", "fn "].iter();
            let mut rest = rest.filter_map(|kind| line.strip_prefix("pub ")?.strip_prefix(kind));
            let name = |c: char| c.is_alphanumeric() || c == '_';
            rest.any(|rest| rest.split(|c| !name(c)).next() == Some(item))
        };
        let comment = |line: &str| line.starts_with("///") || line.starts_with("#[");
        sources(room).into_iter().find_map(|(path, text)| {
            let lines: Vec<String> = text.lines().map(Into::into).collect();
            let end = lines.iter().position(|line| declares(line))?;
            let start = lines[..end].iter().rposition(|line| !comment(line));
            let range = start.map_or(0, |i| i + 1)..end;
            Some(Self { path, lines, range })
        })
    }

    pub fn of(room: &str, item: &str) -> Self {
        Self::find(room, item).unwrap_or_else(|| panic!("{room} has no {item}"))
    }

    /// The comment as it stands, its attributes among it.
    pub fn text(&self) -> String {
        self.lines[self.range.clone()].join("\n")
    }

    /// The sentence that it begins with.
    pub fn sentence(&self) -> String {
        let lines = self.range.clone().map(|i| self.line(i));
        let first: Vec<_> = lines.take_while(|line| !line.is_empty()).collect();
        let text = first.join(" ");
        let end = text.find(". ").unwrap_or(text.len());
        text[..end].trim_end_matches('.').to_owned()
    }

    fn line(&self, i: usize) -> &str {
        self.lines[i].trim_start_matches("///").trim()
    }

    /// Where its tables stand in the file, without their heads and the rules below them.
    fn places(&self) -> Vec<Range<usize>> {
        let is_table = |i: &usize| self.line(*i).starts_with('|');
        let mut places = Vec::new();
        let mut from = self.range.start;
        while let Some(start) = (from..self.range.end).find(is_table) {
            from = (start..self.range.end)
                .find(|i| !is_table(i))
                .unwrap_or(self.range.end);
            places.push(start + 2..from);
        }
        places
    }

    /// The rows of its tables.
    pub fn tables(&self) -> Vec<Vec<Row>> {
        let rows = |place: Range<usize>| {
            // The head, and the rule below it.
            let head = self.line(place.start - 2);
            place.map(|i| Row::read(self.line(i), head)).collect()
        };
        self.places().into_iter().map(rows).collect()
    }

    /// The one row of this title.
    pub fn row(&self, title: &str) -> Option<Row> {
        let tables = self.tables();
        let mut rows = tables
            .into_iter()
            .flatten()
            .filter(|row| row.title == title);
        let row = rows.next();
        assert!(
            rows.next().is_none(),
            "two rows {title:?} in {}",
            self.path.display()
        );
        row
    }

    /// The number in a row, by the title of the row and the place of the cell after it.
    pub fn figure(&self, title: &str, cell: usize) -> f64 {
        let row = self.row(title);
        let figure = row
            .as_ref()
            .and_then(|row| row.cells.get(cell)?.parse().ok());
        figure.unwrap_or_else(|| panic!("no figure of {title:?} in {}", self.path.display()))
    }

    /// The number that follows some words of the text, up to a comma.
    pub fn figure_after(&self, words: &str) -> f64 {
        let text: Vec<&str> = self.range.clone().map(|i| self.line(i)).collect();
        let text = text.join(" ");
        let rest = text.split_once(words).map(|(_, rest)| rest);
        let figure = rest.and_then(|rest| rest.split(',').next()?.trim().parse().ok());
        figure.unwrap_or_else(|| panic!("no figure after {words:?} in {}", self.path.display()))
    }
}

/// Replaces the rows of one of the tables of an item.
pub fn write(room: &str, item: &str, table: usize, rows: &[Row]) {
    // Tests that run at once may write to one file.
    static FILES: Mutex<()> = Mutex::new(());
    let _one = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    let mut doc = Doc::of(room, item);
    let place = doc.places()[table].clone();
    doc.lines.splice(place, rows.iter().map(Row::line));
    std::fs::write(&doc.path, doc.lines.join("\n") + "\n").expect("sources can be written");
}

/// Every table of errors of a room, as the item that it documents and its rows.
pub fn of_errors(room: &str) -> Vec<(String, Vec<Row>)> {
    let mut found = Vec::new();
    for (_, text) in sources(room) {
        let lines: Vec<&str> = text.lines().collect();
        let heads = lines.iter().enumerate();
        for (i, head) in heads.filter(|(_, line)| line.starts_with("/// | error |")) {
            let rows = lines[i + 2..].iter().map_while(|line| {
                let row = line.strip_prefix("/// ")?;
                row.starts_with('|').then(|| Row::read(row, head))
            });
            let item = lines[i..].iter().find_map(|line| {
                let item = line.strip_prefix("pub ")?.split_once(' ')?.1;
                item.split(|c: char| !c.is_alphanumeric()).next()
            });
            let item = item.unwrap_or_else(|| panic!("a table of {room} without an item"));
            found.push((item.to_owned(), rows.collect()));
        }
    }
    found
}

/// What a float warp or table states of its errors.
pub fn rows_of_floats(name: &str) -> Vec<Row> {
    let rooms = ["warp", "discrete"].iter();
    let doc = rooms.filter_map(|room| Doc::find(room, name)).next();
    let doc = doc.unwrap_or_else(|| panic!("no {name} in the rooms of warps and tables"));
    let rows = doc.tables().into_iter().next().unwrap_or_default();
    assert!(!rows.is_empty(), "{name} states no errors");
    rows
}

/// The same as the title of each row, and the bounds in `libm` and `poly`.
pub fn of_floats(name: &str) -> Vec<(String, [Statement; 2])> {
    let rows = rows_of_floats(name).into_iter();
    rows.map(|row| (row.title.clone(), row.statements()))
        .collect()
}

/// What a row that begins so states in one tier.
pub fn row_of(name: &str, tier: &str, row: &str) -> Option<Statement> {
    let mut rows = of_floats(name).into_iter();
    let (_, [libm, poly]) = rows.find(|(title, _)| title.starts_with(row))?;
    Some(if tier == "poly" { poly } else { libm })
}

/// A figure is stale where it is more than so many times what is measured.
pub const STALE: f64 = 1.25;

/// Whether a stated figure is that of a measured one: of its sign, no smaller, and not stale. What is within `noise` of
/// what is measured cannot be told from it.
pub fn states(stated: f64, measured: f64, noise: f64) -> bool {
    let measured = match stated {
        0.0 => measured.abs(),
        _ => measured * stated.signum(),
    };
    let stated = stated.abs();
    measured.is_finite() && measured <= stated + noise && stated <= STALE * (measured + noise)
}

/// Holds a measured figure to the stated one.
pub fn assert_stated(what: &str, measured: f64, stated: f64) {
    println!("{what}: {measured:.3e} measured, {stated:.2e} stated");
    // Of fewer samples the largest errors are smaller.
    let holds = states(stated, measured, 0.0) || !speed::full() && measured <= stated;
    assert!(
        holds,
        "{what}: {measured:e} measured, {stated:e} is too small or stale"
    );
}

/// Holds a measured figure to a stated one that is proven, or has a margin over what a longer search found.
pub fn assert_within(what: &str, measured: f64, stated: f64) {
    println!("{what}: {measured:.3e} measured, {stated:.2e} stated");
    let stale = speed::full() && stated > 2.5 * measured;
    assert!(
        measured <= stated && !stale,
        "{what}: {measured:e} measured, {stated:e} is too small or stale"
    );
}

/// To so many significant digits, away from 0, so that a printed bound holds.
pub fn rounded_up(x: f64, digits: i32) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let unit = 10f64.powi(x.abs().log10().floor() as i32 + 1 - digits);
    // A number of so many digits already stays, though the quotient is rounded.
    let up = (x.abs() / unit * (1.0 - 1e-12)).ceil() * unit;
    let text = format!("{up:.*e}", digits as usize - 1);
    text.parse::<f64>().map_or(x, |up| up.copysign(x))
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

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn tables_are_found_by_what_they_document() {
        let rows = of_floats("Disk");
        assert!(rows.iter().any(|(title, _)| title.starts_with("sample")));
        assert!(Doc::find("warp", "Square").is_none());
        let grades = Doc::of("fixed", "Grade").tables();
        assert_eq!(grades.len(), 2);
        assert!(grades[1].iter().all(|row| row.cells.len() == 3));
        let disk = Doc::of("fixed", "Disk");
        assert!(disk.row("sample, max").is_some() && disk.row("sample, best").is_none());
        assert!(disk.figure("sample, max", 0) < disk.figure("sample, max", 1));
    }

    const KINDS: &str = "| error | `libm` | `poly` | kind |";

    #[test]
    fn lines_are_read_as_they_are_written() {
        let row = Row::new("`exp_m1`, x < 1/8", ["1e-7, 2e-8".into(), "-".into()]);
        let line = row.line();
        assert_eq!(line, "/// | `exp_m1`, x < 1/8 | 1e-7, 2e-8 | - |");
        assert_eq!(
            Row::read(
                line.trim_start_matches("///").trim(),
                "| error | `libm` | `poly` |"
            ),
            row
        );
        let row = Row {
            kind: Some(Kind::Proven),
            ..row
        };
        let line = row.line();
        assert!(line.ends_with("| - | proven |"), "{line}");
        assert_eq!(Row::read(line.trim_start_matches("///").trim(), KINDS), row);
        // One bound is that of both tiers.
        let one = Row::read("| inverse | 2e-7 | proven |", "| error | bound | kind |");
        assert_eq!(one, Row::read("| inverse | 2e-7 | 2e-7 | proven |", KINDS));
    }

    #[test]
    #[should_panic(expected = "of no kind")]
    fn a_row_of_an_unknown_kind_is_refused() {
        Row::read("| round trip | 2e-7 | 2e-7 | likely |", KINDS);
    }

    #[test]
    fn a_stated_figure_that_is_too_small_or_stale_or_of_the_other_sign_is_refused() {
        assert!(states(1.1e-6, 1e-6, 0.0) && states(-1.1e-6, -1e-6, 0.0) && states(0.0, 0.0, 0.0));
        assert!(states(0.0, -1e-9, 1e-9) && states(1e-9, 0.0, 1e-9));
        for (stated, measured) in [
            (0.9e-6, 1e-6),
            (1.3e-6, 1e-6),
            (-1.1e-6, 1e-6),
            (0.0, 1e-9),
            (1e-9, 0.0),
            (1e-6, f64::NAN),
            (1e-6, f64::INFINITY),
            (f64::INFINITY, f64::INFINITY),
            (f64::NAN, 1e-6),
        ] {
            assert!(!states(stated, measured, 0.0), "{stated} {measured}");
        }
        assert_eq!(rounded_up(1.01e-6, 2), 1.1e-6);
        assert_eq!(rounded_up(1.1e-6, 2), 1.1e-6);
        assert_eq!(rounded_up(-2.30e-7, 2), -2.3e-7);
        assert_eq!(rounded_up(1.0001, 3), 1.01);
    }
}
