//! The one table of what functions and programs cost on cores: `docs/measured/counts.csv`. A row is a function on a core. A
//! cell is empty where nothing was counted.

use crate::upkeep::{Outcome, read, write};
use std::collections::HashMap;

pub const FILE: &str = "docs/measured/counts.csv";

/// The cores in the order of the rows.
pub const CORES: [&str; 5] = ["m0", "m0plus", "m3", "m4f", "wasm"];

pub struct Counts {
    /// By which compilers the sizes were linked.
    pub comments: Vec<String>,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
    places: HashMap<(String, String), usize>,
}

impl Counts {
    pub fn read() -> Outcome<Self> {
        Self::parse(&read(FILE)?)
    }

    pub fn parse(text: &str) -> Outcome<Self> {
        let cells = |line: &str| line.split(',').map(String::from).collect::<Vec<_>>();
        let (comments, lines): (Vec<_>, Vec<_>) = text.lines().partition(|l| l.starts_with('#'));
        let (head, rows) = lines.split_first().ok_or("counts.csv is empty")?;
        let columns = cells(head);
        let rows: Vec<_> = rows.iter().map(|line| cells(line)).collect();
        if let Some(row) = rows.iter().find(|row| row.len() != columns.len()) {
            return Err(format!("{FILE}: {row:?}"));
        }
        let place = |(place, row): (usize, &Vec<String>)| ((row[0].clone(), row[1].clone()), place);
        Ok(Self {
            comments: comments.into_iter().map(String::from).collect(),
            places: rows.iter().enumerate().map(place).collect(),
            columns,
            rows,
        })
    }

    fn column(&self, column: &str) -> usize {
        let place = self.columns.iter().position(|title| title == column);
        place.unwrap_or_else(|| panic!("{FILE} has no column {column}"))
    }

    /// A cell that is not empty.
    pub fn cell(&self, function: &str, core: &str, column: &str) -> Option<&str> {
        let place = self.places.get(&(function.into(), core.into()))?;
        let cell = self.rows[*place][self.column(column)].as_str();
        (!cell.is_empty()).then_some(cell)
    }

    pub fn number(&self, function: &str, core: &str, column: &str) -> Option<f64> {
        self.cell(function, core, column)?.parse().ok()
    }

    /// A number that must be there.
    pub fn figure(&self, function: &str, core: &str, column: &str) -> Outcome<f64> {
        let number = self.number(function, core, column);
        number.ok_or_else(|| format!("counts.csv has no {column} of {function} on {core}"))
    }

    /// The functions of which a column is filled on a core, in the order of the rows.
    pub fn functions<'a>(&'a self, core: &'a str, column: &str) -> impl Iterator<Item = &'a str> {
        let column = self.column(column);
        let rows = self.rows.iter();
        rows.filter(move |row| row[1] == core && !row[column].is_empty())
            .map(|row| row[0].as_str())
    }

    /// Writes cells of a core anew: those of functions that are not named are emptied, and rows of which nothing is left go.
    pub fn set(&mut self, core: &str, column: &str, figures: &HashMap<String, String>) {
        let column = self.column(column);
        for (function, figure) in figures {
            let key = (function.clone(), core.to_owned());
            let rows = &mut self.rows;
            let width = self.columns.len();
            let place = *self.places.entry(key).or_insert_with(|| {
                let mut row = vec![String::new(); width];
                (row[0], row[1]) = (function.clone(), core.into());
                rows.push(row);
                rows.len() - 1
            });
            rows[place][column].clone_from(figure);
        }
        for row in &mut self.rows {
            if row[1] == core && !figures.contains_key(&row[0]) {
                row[column].clear();
            }
        }
    }

    /// Functions stay in their order, and what is new comes last.
    pub fn write(&self) -> Outcome {
        let mut first = HashMap::new();
        for (place, row) in self.rows.iter().enumerate() {
            first.entry(row[0].as_str()).or_insert(place);
        }
        let of_core = |core: &str| CORES.iter().position(|other| *other == core);
        let filled = |row: &&Vec<String>| row[2..].iter().any(|cell| !cell.is_empty());
        let mut rows: Vec<_> = self.rows.iter().filter(filled).collect();
        rows.sort_by_key(|row| (first[row[0].as_str()], of_core(&row[1])));
        let lines = rows.into_iter().chain([&self.columns]);
        let mut lines: Vec<String> = lines.map(|row| row.join(",")).collect();
        lines.rotate_right(1);
        let text = self.comments.iter().chain(&lines);
        write(
            FILE,
            &text.map(|line| format!("{line}\n")).collect::<String>(),
        )
    }
}
