//! Where figures come from: what was counted, measured, linked and stated. Each is looked up by name, and one that is
//! not there is an error.

use microwarp_host::counts::{CORES, Counts};
use microwarp_host::docs;
use microwarp_host::upkeep::{Outcome, read, root};
use microwarp_list::{FLOAT_WARPS, GRADED_WARPS, Listed, PLAIN_WARPS};
use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::path::Path;

pub struct Sources {
    pub counts: Counts,
    /// Instructions that no kernel of crates/cores counts, on an M4F and an M0.
    counted: HashMap<String, Vec<String>>,
    /// Nanoseconds, by bench and name.
    host: HashMap<String, Vec<String>>,
    /// The rows of the table of peers, by the family's first words.
    pub peers: Vec<Vec<String>>,
    /// Likewise of what renderers sample.
    pub renderers: Vec<Vec<String>>,
    /// All files of src: their paths from the root, and what stands in them.
    pub code: Vec<(String, String)>,
    golden: String,
}

/// A table by its first `keys` columns; comments and the header are left out.
fn by_keys(path: &str, keys: usize) -> Outcome<HashMap<String, Vec<String>>> {
    let text = read(path)?;
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let cells = rows.map(|row| row.split(',').map(String::from).collect::<Vec<_>>());
    Ok(cells
        .map(|mut row| {
            let values = row.split_off(keys.min(row.len()));
            (row.join(" "), values)
        })
        .collect())
}

fn all_code(folder: &Path, into: &mut Vec<(String, String)>) {
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            all_code(&path, into);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let name = path.strip_prefix(root()).unwrap().display().to_string();
            into.push((name, fs::read_to_string(&path).unwrap()));
        }
    }
}

/// The cells of a row of a Markdown table.
pub fn cells(row: &str) -> Vec<String> {
    let row = row.trim().trim_start_matches('|').trim_end_matches('|');
    row.split('|').map(|cell| cell.trim().into()).collect()
}

/// Digits in groups of three.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

impl Sources {
    pub fn read() -> Outcome<Self> {
        let mut code = Vec::new();
        all_code(&root().join("src"), &mut code);
        let peers = read("docs/measured/peers.md")?;
        let mut tables = peers.split("\n\n").filter(|part| part.starts_with('|'));
        let mut table = || {
            tables
                .next()
                .map(|table| table.lines().map(cells).collect())
        };
        Ok(Self {
            counts: Counts::read()?,
            counted: by_keys("docs/measured/cores.csv", 1)?,
            host: by_keys("docs/measured/host.csv", 2)?,
            peers: table().ok_or("peers.md is empty")?,
            renderers: table().unwrap_or_default(),
            code,
            golden: read("tests/golden/golden.csv")?,
        })
    }

    pub fn has_kernel(&self, kernel: &str) -> bool {
        self.counts.cell(kernel, "m0", "stack").is_some()
    }

    pub fn whole(&self, core: &str, function: &str, column: &str) -> Outcome<u64> {
        let figure = self.counts.figure(function, core, column)?;
        Ok(figure.round_ties_even() as u64)
    }

    /// Instructions at opt-level 3, of a kernel or, on two cores, of what was counted without one.
    pub fn instructions(&self, core: &str, name: &str) -> Outcome<u64> {
        let column = match core {
            "m4f" => 0,
            _ => 1,
        };
        if let Some(row) = self.counted.get(name) {
            return row[column]
                .parse()
                .map_err(|_| format!("cores.csv: {name}"));
        }
        self.whole(core, name, "instructions")
    }

    pub fn code_at_s(&self, core: &str, kernel: &str) -> Outcome<u64> {
        self.whole(core, kernel, "code_s")
    }

    pub fn stack(&self, core: &str, kernel: &str) -> Outcome<u64> {
        self.whole(core, kernel, "stack")
    }

    /// Bytes of flash of a function or program that .ci/sizes links.
    pub fn flash(&self, core: &str, name: &str) -> Outcome<u64> {
        self.whole(core, name, "flash_s")
    }

    pub fn nanoseconds(&self, bench: &str, name: &str) -> Outcome<String> {
        let row = self.host.get(&format!("{bench} {name}"));
        row.map(|row| row[0].clone())
            .ok_or_else(|| format!("host.csv has no {bench} {name}"))
    }

    /// A cell of the table of peers, of the family that begins so.
    pub fn peer(&self, family: &str, column: &str) -> Outcome<&str> {
        let header = self.peers.first().ok_or("peers.md has no row")?;
        let column = header.iter().position(|title| title == column);
        let row = self.peers.iter().find(|row| row[0].starts_with(family));
        let cell = column.zip(row).and_then(|(i, row)| row.get(i));
        cell.map(String::as_str)
            .ok_or_else(|| format!("peers.md has no such cell of {family}"))
    }

    /// A cell of a table in the doc comment that ends at a line which begins with `item`: that of the row whose title begins
    /// so, under a header. The code is that of the room whose comment has such a column.
    pub fn stated(&self, item: &str, title: &str, header: &str) -> Outcome<String> {
        for (_, text) in &self.code {
            let lines: Vec<&str> = text.lines().collect();
            for (end, _) in lines.iter().enumerate().filter(|(_, line)| is(line, item)) {
                let comment = lines[..end].iter().rev();
                let comment = comment.take_while(|l| l.starts_with("///") || l.starts_with("#["));
                let mut table: Vec<_> = comment
                    .filter_map(|line| line.strip_prefix("/// |"))
                    .map(cells)
                    .collect();
                table.reverse();
                let mut rows = table.iter();
                let place = rows.find_map(|row| docs::column(row, header));
                let row = rows.find(|row| row[0].starts_with(title));
                if let Some((place, row)) = place.zip(row) {
                    return Ok(row[place].clone());
                }
            }
        }
        Err(format!("no {title:?} under {header:?} is stated of {item}"))
    }

    /// Words and cases of the golden table.
    pub fn golden(&self) -> (u64, u64) {
        let rows = self.golden.lines().filter(|line| !line.starts_with('#'));
        rows.fold((0, 0), |(words, cases), row| {
            (words + row.matches(',').count() as u64, cases + 1)
        })
    }
}

/// Whether a line of code is where an item is declared.
fn is(line: &str, item: &str) -> bool {
    let rest = ["pub struct ", "pub trait "]
        .iter()
        .find_map(|keyword| line.strip_prefix(keyword));
    rest.is_some_and(|rest| rest.split(['<', '(', ' ', ';', ':']).next() == Some(item))
}

/// The lists of warps, and how the names of their kernels begin.
pub const TIERS: [(&[Listed], &[&str]); 3] = [
    (FLOAT_WARPS, &["poly_", "libm_"]),
    (GRADED_WARPS, &["fine_", "coarse_", "compact_"]),
    (PLAIN_WARPS, &[""]),
];

/// The names of the kernels: those of the warps in the lists for cores, each in its tiers and drawn, and the string
/// literals with which lines of crates/cores begin.
fn kernels() -> BTreeSet<String> {
    let mut code = Vec::new();
    all_code(&root().join("crates/cores/src/measured/kernels"), &mut code);
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let mut names = BTreeSet::new();
    for (warps, tiers) in TIERS {
        for (kernel, tier) in warps
            .iter()
            .flat_map(|w| w.kernels)
            .flat_map(|k| tiers.iter().map(move |t| (k, t)))
        {
            names.extend([format!("{tier}{kernel}"), format!("{tier}{kernel}_pcg32")]);
        }
    }
    for line in code.iter().flat_map(|(_, text)| text.lines()) {
        let mut rest = line.trim_start();
        while let Some((name, after)) = rest.strip_prefix('"').and_then(|r| r.split_once('"')) {
            if !name.chars().all(plain) {
                break;
            }
            names.insert(name.into());
            rest = after.trim_start();
        }
    }
    names
}

/// Every kernel but the paths has been counted on every core and, where it may take longer for some inputs, swept; what was
/// counted is a kernel.
pub fn tidy() -> Outcome {
    let counts = Sources::read()?.counts;
    let kernels = kernels();
    let mut wrong = Vec::new();
    let mut due = |kernel: &str, cores: &[&str], column: &str| {
        let has = |core: &&str| counts.cell(kernel, core, column).is_some();
        if !cores.iter().all(has) {
            let how = match column {
                "flash_s" => "--only sizes".into(),
                _ => format!("--costs --kernel '^{kernel}$'"),
            };
            wrong.push(format!("{kernel} has no {column} in counts.csv: {how}"));
        }
    };
    for kernel in &kernels {
        // Paths take long: of a scene's only what is shown is counted, and those for sizes alone are not.
        match kernel.strip_prefix("poly_path_") {
            Some(path) if path == "plain" || path.starts_with("with_") => {}
            Some(_) => due(kernel, &["m0", "m4f", "wasm"], "instructions"),
            None => due(kernel, &["m0", "m3", "m4f", "wasm"], "instructions_s"),
        }
        // What only draws for another is not swept.
        let alone = kernel.strip_suffix("_pcg32");
        if !kernel.contains("_path_") && !alone.is_some_and(|alone| kernels.contains(alone)) {
            due(kernel, &["m0", "m0plus", "m3", "m4f"], "longest");
        }
        if !kernel.starts_with("peer_") {
            due(kernel, &["m0", "m4f", "wasm"], "flash_s");
        }
    }
    let varied: BTreeSet<String> = varied().collect();
    let of_grade = ["libm_", "coarse_", "compact_"];
    for kernel in &varied {
        // Those of the other tiers may be there.
        if !of_grade.iter().any(|tier| kernel.starts_with(tier)) {
            due(kernel, &["m0", "m0plus", "m3", "m4f"], "longest");
        }
    }
    for core in CORES {
        for kernel in counts.functions(core, "function") {
            let known = kernels.contains(kernel) || varied.contains(kernel);
            if !known && !kernel.starts_with("program_") {
                wrong.push(format!(
                    "counts.csv has {kernel}, and there is no such kernel"
                ));
            }
        }
    }
    if kernels.is_empty() {
        wrong.push("no kernel is found in crates/cores/src/measured/kernels".into());
    }
    if wrong.is_empty() {
        println!("tidy: {} kernels, all counted", kernels.len());
        Ok(())
    } else {
        Err(wrong.join("\n"))
    }
}

/// The kernels of warps that take any parameters.
fn varied() -> impl Iterator<Item = String> {
    TIERS.into_iter().flat_map(|(warps, tiers)| {
        let names = warps.iter().flat_map(Listed::varied);
        names.flat_map(move |name| tiers.iter().map(move |tier| format!("{tier}{name}_any")))
    })
}
