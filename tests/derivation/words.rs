//! The integer constants as they stand in the sources of the integer tier, found by what stands before them; and how
//! they are written.

use std::ops::Range;
use std::path::{Path, PathBuf};

fn room() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/fixed")
}

/// The text of a source file, and where in it the numbers after a place are: one, or a list up to its bracket.
/// Nothing where there is no such place, or more than one.
fn find(file: &str, before: &str) -> Option<(String, Range<usize>)> {
    let text = std::fs::read_to_string(room().join(file)).unwrap();
    let mut places = text.match_indices(before);
    let (place, _) = places.next().filter(|_| places.next().is_none())?;
    let start = place + before.len();
    let end = if before.ends_with('[') {
        start + text[start..].find(']')?
    } else {
        let number = |c: char| c.is_ascii_digit() || c == '_';
        start + text[start..].find(|c| !number(c))?
    };
    Some((text, start..end))
}

/// The numbers at a place.
pub fn read(file: &str, before: &str) -> Option<Vec<u64>> {
    let (text, range) = find(file, before)?;
    text[range]
        .replace('_', "")
        .split(',')
        .map(str::trim)
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().ok())
        .collect()
}

/// Writes the numbers at a place, a list as `rustfmt` lays it out.
pub fn write(file: &str, before: &str, words: &[u64]) {
    let (mut text, range) = find(file, before).unwrap_or_else(|| panic!("{file}: no {before}"));
    let words: Vec<String> = words.iter().map(|word| literal(*word)).collect();
    let line = words.join(", ");
    let line = if line.len() <= 58 {
        line
    } else {
        let lines: String = words.iter().map(|word| format!("    {word},\n")).collect();
        format!("\n{lines}")
    };
    text.replace_range(range, &line);
    std::fs::write(room().join(file), text).unwrap();
}

/// A number in groups of three digits, from four digits on.
pub fn literal(word: u64) -> String {
    let digits = word.to_string();
    if digits.len() < 4 {
        return digits;
    }
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push('_');
        }
        text.push(digit);
    }
    text
}

/// All decimal numbers of four digits and more in the code of the integer tier, with the file each stands in.
pub fn long_literals() -> Vec<(String, String)> {
    let mut found = Vec::new();
    for folder in ["", "kernel/"] {
        for entry in std::fs::read_dir(room().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|e| e != "rs") {
                continue;
            }
            let file = format!("{folder}{}", path.file_name().unwrap().to_str().unwrap());
            let text = std::fs::read_to_string(&path).unwrap();
            let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
            for word in code.flat_map(|l| l.split(|c: char| !(c.is_alphanumeric() || c == '_'))) {
                if word.starts_with(|c: char| c.is_ascii_digit())
                    && word.chars().all(|c| c.is_ascii_digit() || c == '_')
                    && word.contains('_')
                {
                    found.push((file.clone(), word.to_owned()));
                }
            }
        }
    }
    assert!(found.len() > 20, "{found:?}");
    found
}
