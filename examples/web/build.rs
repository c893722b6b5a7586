//! Reads the bounds that the crate states, out of its documentation, into one JSON text for the page: the page
//! then holds a sample against what its own documentation promises, and no figure is written twice.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The rows of a table of errors: the name of the quantity and a number a tier, as written.
type Table = Vec<(String, Vec<String>)>;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let crate_source = Path::new("../../src");
    let families = [
        ("float", vec!["warp", "discrete"]),
        ("integer", vec!["fixed"]),
    ];
    let mut json = String::from("{");
    for (family, directories) in families {
        let mut tables = BTreeMap::new();
        for directory in directories {
            let directory = crate_source.join(directory);
            println!("cargo:rerun-if-changed={}", directory.display());
            for file in sources(&directory) {
                let text = fs::read_to_string(&file).expect("a source file is text");
                tables.extend(stated(&text));
            }
        }
        assert!(!tables.is_empty(), "no bounds of the {family} warps found");
        append(&mut json, family, &tables);
    }
    json.push('}');
    let out = env::var("OUT_DIR").expect("cargo names a directory for what is generated");
    fs::write(Path::new(&out).join("stated.json"), json).expect("that directory can be written to");
}

fn sources(directory: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(directory).expect("the crate's sources are two levels up");
    let mut files: Vec<_> = entries
        .map(|entry| entry.expect("readable").path())
        .collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    files
}

/// The tables in front of each public type of a file.
fn stated(source: &str) -> Vec<(String, Table)> {
    let (mut found, mut table) = (Vec::new(), Table::new());
    for line in source.lines() {
        if let Some(doc) = line.strip_prefix("///") {
            if let Some(row) = row(doc.trim()) {
                table.push(row);
            }
        } else if let Some(rest) = line.strip_prefix("pub struct ") {
            let name: String = rest
                .chars()
                .take_while(char::is_ascii_alphanumeric)
                .collect();
            if !table.is_empty() {
                found.push((name, std::mem::take(&mut table)));
            }
        } else if !line.starts_with('#') {
            table.clear();
        }
    }
    found
}

/// A row whose columns but the first are numbers.
fn row(line: &str) -> Option<(String, Vec<String>)> {
    let mut cells = line
        .strip_prefix('|')?
        .strip_suffix('|')?
        .split('|')
        .map(str::trim);
    let quantity = cells.next()?.to_owned();
    let numbers: Vec<String> = cells.map(str::to_owned).collect();
    let all = !numbers.is_empty() && numbers.iter().all(|cell| cell.parse::<f64>().is_ok());
    all.then_some((quantity, numbers))
}

fn append(json: &mut String, family: &str, tables: &BTreeMap<String, Table>) {
    let separator = if json.ends_with('{') { "" } else { "," };
    let types: Vec<String> = tables
        .iter()
        .map(|(name, table)| {
            let rows: Vec<String> = table
                .iter()
                .map(|(quantity, numbers)| format!("{quantity:?}:[{}]", numbers.join(",")))
                .collect();
            format!("{name:?}:{{{}}}", rows.join(","))
        })
        .collect();
    write!(json, "{separator}{family:?}:{{{}}}", types.join(",")).expect("a string grows");
}
