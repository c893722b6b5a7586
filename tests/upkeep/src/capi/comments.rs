//! What the crate's documentation says of a type, for comments in C.

use crate::{Outcome, root};
use std::collections::HashMap;
use std::fs;
use std::path::Path;

/// What is known of the types of some folders of `src`, by name.
pub struct Comments {
    sentences: HashMap<String, String>,
    /// The rows of the tables of errors, with their heads.
    errors: HashMap<String, Vec<Vec<String>>>,
}

impl Comments {
    /// Those of a list of warps, and of the folder with their files.
    pub fn read(list: &str, folder: &str) -> Outcome<Self> {
        let mut comments = Self {
            sentences: sentences(&crate::read(list)?),
            errors: HashMap::new(),
        };
        comments.collect(&root().join(folder))?;
        Ok(comments)
    }

    fn collect(&mut self, folder: &Path) -> Outcome {
        let failed = |e| format!("{}: {e}", folder.display());
        for entry in fs::read_dir(folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            if path.is_dir() {
                self.collect(&path)?;
                continue;
            }
            let text = fs::read_to_string(&path).map_err(failed)?;
            let mut rows = Vec::new();
            for line in text.lines() {
                if let Some(row) = line.strip_prefix("/// |") {
                    let cells = row.trim_end_matches('|').split('|');
                    rows.push(cells.map(|cell| cell.trim().to_owned()).collect());
                } else if let Some(rest) = line.strip_prefix("pub struct ") {
                    let name = rest.split(|c: char| !c.is_alphanumeric()).next();
                    let name = name.unwrap_or_default().to_owned();
                    self.errors.insert(name, std::mem::take(&mut rows));
                } else if !line.starts_with("///") && !line.starts_with("#[") {
                    rows.clear();
                }
            }
        }
        Ok(())
    }

    /// A type in one sentence.
    pub fn sentence(&self, name: &str) -> Outcome<&str> {
        let sentence = self.sentences.get(name);
        sentence
            .map(String::as_str)
            .ok_or_else(|| format!("the lists of warps say nothing of {name}"))
    }

    /// The stated errors of a sample and of its density in one column, where they are numbers and not formulas.
    pub fn errors(&self, name: &str, column: &str) -> Vec<String> {
        let none = Vec::new();
        let rows = self.errors.get(name).unwrap_or(&none);
        let Some(head) = rows.iter().position(|row| row[0] == "error") else {
            return none.into_iter().flatten().collect();
        };
        let Some(place) = rows[head]
            .iter()
            .position(|cell| cell.trim_matches('`') == column)
        else {
            return Vec::new();
        };
        let stated = rows[head + 2..].iter().filter(|row| {
            let is_one = ["sample", "pdf, relative"].iter().any(|start| {
                row[0].starts_with(start) && !row[0].ends_with("mean") && !row[0].ends_with("rms")
            });
            is_one
                && row
                    .get(place)
                    .is_some_and(|cell| cell.parse::<f64>().is_ok())
        });
        stated
            .map(|row| format!("{}: {}", row[0], row[place]))
            .collect()
    }
}

/// The lines `file::Name… "sentence",` of a list.
fn sentences(list: &str) -> HashMap<String, String> {
    let lines = list.lines().map(str::trim);
    let lines = lines.filter_map(|line| line.strip_suffix("\",")?.split_once(" \""));
    lines
        .filter_map(|(place, sentence)| {
            let name = place.split_once("::")?.1;
            let name = name.split(['<', '[']).next()?;
            Some((name.to_owned(), sentence.to_owned()))
        })
        .collect()
}
