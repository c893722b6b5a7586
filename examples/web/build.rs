//! Reads a sentence and the stated bounds of each type from the crate's documentation into a JSON text for the page. So
//! no figure is written twice.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Where each family's types are.
const FAMILIES: [(&str, &[&str]); 2] = [
    ("float", &["warp", "discrete", "rejection", "metropolis"]),
    ("integer", &["fixed"]),
];

/// What the documentation of a type, or of a function, says.
struct Documented {
    summary: String,
    /// The rows of its table of errors: the quantity, and a number or a formula a tier, as written.
    bounds: Vec<(String, Vec<String>)>,
}

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let families = FAMILIES.map(|(family, directories)| (family, read(directories)));
    let summaries = families.iter().map(|(family, types)| {
        let sentences = types.iter().map(|(name, of)| (name, quoted(&of.summary)));
        (family, object(sentences))
    });
    let bounds = families.iter().map(|(family, types)| {
        let tables = types.iter().filter(|(_, of)| !of.bounds.is_empty());
        (family, object(tables.map(|(name, of)| (name, table(of)))))
    });
    let json = object([("summaries", object(summaries)), ("bounds", object(bounds))]);
    let out = env::var("OUT_DIR").expect("cargo names a directory for what is generated");
    fs::write(Path::new(&out).join("documented.json"), json).expect("it can be written to");
}

/// The types of some directories of the crate by name.
fn read(directories: &[&str]) -> BTreeMap<String, Documented> {
    let mut types = BTreeMap::new();
    for directory in directories {
        let directory = Path::new("../../src").join(directory);
        println!("cargo:rerun-if-changed={}", directory.display());
        for file in sources(&directory) {
            let text = fs::read_to_string(&file).expect("a source file is text");
            // If two types have one name, the first directory's counts.
            for (name, of) in documented(&text) {
                types.entry(name).or_insert(of);
            }
        }
    }
    assert!(!types.is_empty(), "no documentation in {directories:?}");
    types
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

/// Every public type and function of a file that has documentation.
fn documented(source: &str) -> Vec<(String, Documented)> {
    let (mut found, mut lines) = (Vec::new(), Vec::new());
    for line in source.lines() {
        if let Some(doc) = line.strip_prefix("///") {
            lines.push(doc.trim());
        } else if let Some(name) = name(line) {
            let summary = summary(&lines);
            let bounds = errors(&lines);
            found.push((name, Documented { summary, bounds }));
            lines.clear();
        } else if !line.starts_with('#') {
            lines.clear();
        }
    }
    found
}

fn name(line: &str) -> Option<String> {
    let rest = ["pub struct ", "pub fn "]
        .iter()
        .find_map(|start| line.strip_prefix(start))?;
    Some(
        rest.chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect(),
    )
}

/// The first sentence, without the marks of its type setting.
fn summary(lines: &[&str]) -> String {
    let paragraph: Vec<&str> = lines
        .iter()
        .take_while(|line| !line.is_empty())
        .copied()
        .collect();
    let paragraph = paragraph.join(" ");
    let sentence = paragraph.split_inclusive(". ").next().unwrap_or("").trim();
    // Links first, since brackets are also the ends of intervals.
    let plain = sentence.replace("[`", "").replace("`]", "");
    plain.replace('`', "")
}

/// The rows of the table whose first column is headed `error`, below its rule. A bound of both tiers is a cell of each.
fn errors(lines: &[&str]) -> Vec<(String, Vec<String>)> {
    let mut table = lines
        .iter()
        .skip_while(|line| !line.starts_with("| error |"));
    let one = table.next().is_some_and(|head| head.contains("| bound |"));
    let rows = table.skip(1).map_while(|line| row(line));
    let of_each_tier = |(title, mut cells): (String, Vec<String>)| {
        if one {
            cells.insert(0, cells[0].clone());
        }
        (title, cells)
    };
    rows.map(of_each_tier).collect()
}

fn row(line: &str) -> Option<(String, Vec<String>)> {
    let cells = line.strip_prefix('|')?.strip_suffix('|')?;
    let mut cells = cells.split('|').map(str::trim);
    let quantity = cells.next()?.to_owned();
    Some((quantity, cells.map(str::to_owned).collect()))
}

fn table(of: &Documented) -> String {
    let rows = of.bounds.iter().map(|(quantity, stated)| {
        let stated: Vec<_> = stated.iter().map(|cell| quoted(cell)).collect();
        (quantity, format!("[{}]", stated.join(",")))
    });
    object(rows)
}

fn object<K: AsRef<str>>(members: impl IntoIterator<Item = (K, String)>) -> String {
    let members = members.into_iter();
    let members: Vec<_> = members
        .map(|(key, value)| format!("{}:{value}", quoted(key.as_ref())))
        .collect();
    format!("{{{}}}", members.join(","))
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
