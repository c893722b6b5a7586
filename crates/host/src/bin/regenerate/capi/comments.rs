//! What the crate's documentation says of a type, for comments in C.

use super::header::upper_case;
use microwarp_host::docs;
use microwarp_host::upkeep::{Outcome, root};
use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::path::{Path, PathBuf};

/// What is known of the types of some folders of `src`, by name.
pub struct Comments {
    sentences: HashMap<String, String>,
    /// The rows of the tables of errors, with their heads.
    errors: HashMap<String, Vec<Vec<String>>>,
    /// Where the points lie.
    points: HashMap<String, String>,
    /// The file that a type is in.
    files: HashMap<String, PathBuf>,
    refusals: Vec<Refusals>,
}

/// When a constructor refuses.
struct Refusals {
    file: PathBuf,
    /// The head of its `impl`.
    of: String,
    constructor: String,
    /// As the documentation says it.
    text: String,
}

impl Comments {
    /// Those of a list of warps, and of the folder with their files.
    pub fn read(list: &str, folder: &str) -> Outcome<Self> {
        let mut comments = Self {
            sentences: sentences(&microwarp_host::upkeep::read(list)?),
            errors: HashMap::new(),
            points: HashMap::new(),
            files: HashMap::new(),
            refusals: Vec::new(),
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
            let (mut comment, mut of) = (Vec::new(), String::new());
            for line in text.lines() {
                let code = line.trim();
                if let Some(said) = code.strip_prefix("///") {
                    comment.push(said.strip_prefix(' ').unwrap_or(said));
                } else if !code.starts_with("#[") {
                    if code.starts_with("impl") {
                        of = code.into();
                    }
                    let name = code.split_once("fn ").map(|(_, name)| name);
                    if let Some(name) = name.filter(|_| code.starts_with("pub ")) {
                        self.refusals
                            .extend(section(&comment, "Errors").map(|text| Refusals {
                                file: path.clone(),
                                of: of.clone(),
                                constructor:
                                    name.split(['(', '<']).next().unwrap_or_default().into(),
                                text,
                            }));
                    }
                    if let Some(name) = line.strip_prefix("pub struct ") {
                        let name = name.split(|c: char| !c.is_alphanumeric()).next();
                        let name = name.unwrap_or_default().to_owned();
                        let point = section(&comment, "Domain").map(|domain| point(&domain));
                        self.points.extend(point.map(|point| (name.clone(), point)));
                        self.files.insert(name, path.clone());
                    }
                    comment.clear();
                }
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

    /// Where the points of a type lie.
    pub fn point(&self, name: &str, symbol: &str) -> Outcome<String> {
        let point = self.points.get(name);
        let point = point.ok_or_else(|| format!("{name} has no domain"))?;
        Ok(self.in_c(name, symbol, point))
    }

    /// What the documentation says of the refusals of a constructor.
    fn documented(&self, name: &str, constructor: &str) -> Option<&str> {
        let file = self.files.get(name)?;
        let made = |of: &Refusals| of.constructor == constructor;
        let own = self.refusals.iter().rev().find(|of| {
            let ours = [format!(" {name}<"), format!(" {name} "), " $name".into()];
            made(of) && of.file == *file && ours.iter().any(|ours| of.of.contains(ours))
        });
        // Some laws have theirs from a macro for all of them.
        let family = || {
            let family = |of: &&Refusals| made(of) && of.file.ends_with("location_scale.rs");
            self.refusals.iter().find(family)
        };
        own.or_else(family).map(|of| of.text.as_str())
    }

    /// When a constructor of a type refuses, with the codes of C; those of another constructor by its name in C.
    pub fn refusals(&self, name: &str, constructor: &str, symbol: &str) -> Outcome<String> {
        let text = self.documented(name, constructor);
        let Some(text) = text else {
            eprintln!("{name}::{constructor}");
            return Ok(String::new());
        };
        Ok(self.in_c(name, symbol, &linked(text)))
    }

    /// A text with the names of C for code: of errors, constructors and structs.
    fn in_c(&self, name: &str, symbol: &str, text: &str) -> String {
        let parts = text.split('`').enumerate().map(|(i, part)| {
            let init = |of: &str| match of {
                "new" => format!("{symbol}_init"),
                of => format!("{symbol}_init_{of}"),
            };
            match part.split_once("::") {
                _ if i % 2 == 0 => part.into(),
                Some(("Error", error)) => format!("MW_{}", upper_case(error)),
                Some((_, of)) => init(of),
                None if part == "SurfacePoint" => "mw_surface_point".into(),
                None if self.documented(name, part).is_some() => init(part),
                None => part.into(),
            }
        });
        ascii(&parts.collect::<String>())
    }

    /// The codes that a constructor may return, those of others that it refers to among them.
    pub fn codes(&self, name: &str, constructor: &str) -> BTreeSet<String> {
        let mut codes = BTreeSet::new();
        let text = linked(self.documented(name, constructor).unwrap_or_default());
        for part in text.split('`').skip(1).step_by(2) {
            match part.split_once("::") {
                Some(("Error", error)) => drop(codes.insert(format!("MW_{}", upper_case(error)))),
                Some((of, other)) if (of, other) != (name, constructor) => {
                    codes.extend(self.codes(of, other));
                }
                None if part != constructor => codes.extend(self.codes(name, part)),
                _ => {}
            }
        }
        codes
    }

    /// The stated errors of a sample and of its density in one column, where they are numbers and not formulas.
    pub fn errors(&self, name: &str, column: &str) -> Vec<String> {
        let none = Vec::new();
        let rows = self.errors.get(name).unwrap_or(&none);
        let Some(head) = rows.iter().position(|row| row[0] == "error") else {
            return none.into_iter().flatten().collect();
        };
        let Some(place) = docs::column(&rows[head], column) else {
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

/// The text under a heading of a comment, up to the next, in one line.
fn section(comment: &[&str], heading: &str) -> Option<String> {
    let from = comment
        .iter()
        .position(|line| line.strip_prefix("# ") == Some(heading))?;
    let lines = comment[from + 1..].iter();
    let lines: Vec<&str> = lines
        .take_while(|line| !line.starts_with("# "))
        .map(|line| line.trim())
        .collect();
    Some(lines.join(" ").trim().into())
}

/// Where points lie, in the words of a domain: its first sentence, or that of the item about points.
fn point(domain: &str) -> String {
    let text = domain.strip_prefix("- Point: ").unwrap_or(domain);
    let end = [". ", " - "].iter().filter_map(|end| text.find(end)).min();
    let text = &text[..end.unwrap_or(text.len())];
    linked(text).trim_end_matches('.').into()
}

/// A text with the names of its links, without their targets.
fn linked(text: &str) -> String {
    let mut parts = text.split("`](");
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        plain.push('`');
        plain += part.split_once(')').map_or("", |(_, behind)| behind);
    }
    plain.replace("[`", "`").replace("`]", "`")
}

/// A text as the header may write it.
fn ascii(text: &str) -> String {
    const DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";
    const BELOW: &str = "₀₁₂₃₄₅₆₇₈₉";
    let (mut plain, mut raised) = (String::new(), false);
    for c in text.chars() {
        if let Some(digit) = DIGITS.chars().position(|digit| digit == c) {
            if !raised {
                plain.push('^');
            }
            plain.push(b"0123456789-"[digit].into());
            raised = true;
            continue;
        }
        raised = false;
        if let Some(digit) = BELOW.chars().position(|digit| digit == c) {
            plain.push(b"0123456789"[digit].into());
            continue;
        }
        match c {
            '−' => plain.push('-'),
            '≤' => plain.push_str("<="),
            '≥' => plain.push_str(">="),
            '√' => plain.push_str("sqrt "),
            '½' => plain.push_str("1/2"),
            '±' => plain.push_str("+-"),
            '·' => plain.push('*'),
            'σ' => plain.push_str(" sigma"),
            'γ' => plain.push_str(" gamma"),
            'β' => plain.push_str(" beta"),
            'λ' => plain.push_str(" lambda"),
            'κ' => plain.push_str("kappa"),
            'μ' => plain.push_str("mu"),
            'θ' => plain.push_str("theta"),
            'φ' => plain.push_str("phi"),
            'π' => plain.push_str("pi"),
            'α' => plain.push_str("alpha"),
            'ν' => plain.push_str("nu"),
            'ᵢ' => plain.push_str("_i"),
            c => plain.push(c),
        }
    }
    plain.replace("sqrt (", "sqrt(").replace("* ", "*")
}

/// The lines `file::Name… "sentence",` of a list.
fn sentences(list: &str) -> HashMap<String, String> {
    // A place, its sentence in quotes, and a measure where there is one.
    let lines = list.lines().map(str::trim);
    let lines = lines.filter_map(|line| line.strip_suffix(',')?.split_once(" \""));
    lines
        .filter_map(|(place, rest)| {
            let (sentence, _) = rest.rsplit_once('"')?;
            let name = place.split_once("::")?.1;
            let name = name.split(['<', '[']).next()?;
            Some((name.to_owned(), sentence.to_owned()))
        })
        .collect()
}
