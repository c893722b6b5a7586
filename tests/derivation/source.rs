//! The constants as they stand in the sources of the tiers, found by name; and how they are written.

use std::path::{Path, PathBuf};

/// The source files that may hold a derived constant.
const FILES: [&str; 6] = [
    "src/tier/libm.rs",
    "src/tier/normal.rs",
    "src/tier/poly/trig.rs",
    "src/tier/poly/log.rs",
    "src/tier/poly/exp.rs",
    "src/tier/power.rs",
];

fn path(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(file)
}

/// Where a constant's list of values stands: file, text, and the range between its brackets.
fn find(name: &str) -> Option<(PathBuf, String, std::ops::Range<usize>)> {
    let start = format!("const {name}: [f32; ");
    FILES.iter().find_map(|file| {
        let path = path(file);
        let text = std::fs::read_to_string(&path).ok()?;
        let declared = text.find(&start)?;
        // Past the type, which has a bracket of its own; the list may stand on a line below.
        let value = declared + text[declared..].find('=')?;
        let open = value + text[value..].find('[')? + 1;
        let close = open + text[open..].find("];")?;
        Some((path, text, open..close))
    })
}

/// The names of all lists of constants in the sources.
pub fn names() -> Vec<String> {
    let texts = FILES.map(|file| std::fs::read_to_string(path(file)).unwrap());
    let lines = texts.iter().flat_map(|text| text.lines());
    lines
        .filter_map(|line| line.split_once("const ")?.1.split_once(": [f32; "))
        .map(|(name, _)| name.to_owned())
        .collect()
}

/// The values of a constant in the sources.
pub fn constants(name: &str) -> Option<Vec<f32>> {
    let (_, text, range) = find(name)?;
    text[range]
        .replace('_', "")
        .split(',')
        .map(str::trim)
        .filter(|value| !value.is_empty())
        .map(|value| value.parse().ok())
        .collect()
}

/// Writes the values of a constant into its source.
pub fn write(name: &str, values: &[f32]) {
    let (path, mut text, range) = find(name).unwrap_or_else(|| panic!("no constant {name}"));
    let list: String = values
        .iter()
        .map(|&value| format!("\n    {},", literal(value)))
        .collect();
    text.replace_range(range, &(list + "\n"));
    std::fs::write(path, text).unwrap();
}

/// The shortest decimals that name the value, in groups of three.
fn literal(value: f32) -> String {
    let text = format!("{value:?}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, ""));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
    let groups: Vec<String> = fraction
        .as_bytes()
        .chunks(3)
        .map(|group| String::from_utf8_lossy(group).into_owned())
        .collect();
    let exponent = if exponent.is_empty() {
        String::new()
    } else {
        format!("e{exponent}")
    };
    format!("{whole}.{}{exponent}", groups.join("_"))
}
