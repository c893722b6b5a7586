//! Doc comments of Rust as those of JavaScript.

use super::camel;
use microwarp::Error;
use microwarp_upkeep::{Outcome, errors, read, root};
use std::fs;

/// The file that declares a type, and where.
pub struct Docs {
    name: String,
    lines: Vec<String>,
}

/// What is taken of a type's comment, besides what stands before the first heading.
const SECTIONS: [&str; 4] = ["Density", "Domain", "Accuracy", "Source"];

impl Docs {
    pub fn of(name: &str) -> Outcome<Self> {
        for entry in fs::read_dir(root().join("src/warp")).map_err(|e| e.to_string())? {
            let path = entry.map_err(|e| e.to_string())?.path();
            if path.is_dir() {
                continue;
            }
            let text = fs::read_to_string(&path).map_err(|e| e.to_string())?;
            let docs = Self {
                name: name.into(),
                lines: text.lines().map(String::from).collect(),
            };
            if docs.declared().is_some() {
                return Ok(docs);
            }
        }
        Err(format!("src/warp has no struct {name}"))
    }

    /// The file of the family of laws with a location and a scale.
    fn family() -> Outcome<Self> {
        let text = read("src/warp/located.rs")?;
        Ok(Self {
            name: "$name".into(),
            lines: text.lines().map(String::from).collect(),
        })
    }

    fn declared(&self) -> Option<usize> {
        let start = format!("pub struct {}", self.name);
        self.lines.iter().position(|line| {
            let rest = line.strip_prefix(&start);
            rest.is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()))
        })
    }

    /// The lines of the comment that ends above a line, without its marks and attributes.
    fn above(&self, line: usize) -> Vec<String> {
        let above = self.lines[..line].iter().rev().map(|line| line.trim());
        let comment = above.take_while(|line| line.starts_with("///") || line.starts_with("#["));
        let comment = comment.filter_map(|line| line.strip_prefix("///"));
        let mut lines: Vec<&str> = comment
            .map(|line| line.strip_prefix(' ').unwrap_or(line))
            .collect();
        lines.reverse();
        // A link may go over the end of a line.
        spoken(&plain(&lines.join("\n")))
            .lines()
            .map(String::from)
            .collect()
    }

    /// The comment of the class.
    pub fn class(&self) -> Outcome<String> {
        let line = self.declared().ok_or("not declared")?;
        let (mut taken, mut text) = (true, Vec::new());
        for line in self.above(line) {
            if let Some(heading) = line.strip_prefix("# ") {
                taken = SECTIONS.contains(&heading);
                if taken {
                    text.push(format!("**{heading}**"));
                    text.push(String::new());
                }
            } else if taken {
                text.push(of_poly(&line));
            }
        }
        if text.iter().all(String::is_empty) {
            return Err(format!("{} has no documentation", self.name));
        }
        Ok(comment("", &text))
    }

    /// The comment of a constructor, by its name in Rust.
    pub fn constructor(&self, name: &str) -> Outcome<String> {
        let start = format!("fn {name}(");
        let (mut of, mut found) = (false, None);
        for (i, line) in self.lines.iter().enumerate() {
            if let Some((_, rest)) = line
                .split_once("impl")
                .filter(|_| line.trim_start().starts_with("impl"))
            {
                // A macro may make the same for several types.
                of = rest.contains(&format!(" {}<", self.name))
                    || rest.contains(&format!(" {} ", self.name))
                    || rest.contains(" $name");
            }
            if of && line.trim_start().starts_with("pub ") && line.contains(&start) {
                found = Some(i);
            }
        }
        let Some(line) = found else {
            // That of a family, whose members are made by a macro.
            return match self.name.as_str() {
                "$name" => Err(format!("no {name} in the documentation")),
                _ => Self::family()?.constructor(name),
            };
        };
        let (lines, errors) = (self.above(line), errors()?);
        let text = lines.iter().map(|line| match line.as_str() {
            "# Errors" => "@throws RangeError:".into(),
            line => coded(line, &errors),
        });
        Ok(comment("  ", &text.collect::<Vec<_>>()))
    }
}

/// A line of a table of errors with the column of `poly` alone; another as it is.
fn of_poly(line: &str) -> String {
    let cells: Vec<&str> = line.split('|').collect();
    match cells[..] {
        [_, title, _, poly, _] => format!("|{title}|{poly}|"),
        _ => line.into(),
    }
}

/// A line of the errors of a constructor with the codes of the errors, which JavaScript knows them by.
fn coded(line: &str, errors: &[(Error, String)]) -> String {
    let mut line = line.to_owned();
    for (error, name) in errors {
        line = line.replace(
            &format!("`Error::{name}`"),
            &format!("{name} (code {})", error.code()),
        );
    }
    line
}

/// Code within text as JavaScript writes it: `Cone::from_sine` as `Cone.fromSine`, and `Cone::new` as `new Cone`.
fn spoken(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let parts = parts.map(|(i, part)| {
        let plain = |c: char| c.is_ascii_lowercase() || c == '_';
        match part.split_once("::") {
            _ if i % 2 == 0 => part.into(),
            Some(("Error", _)) => part.into(),
            Some((class, "new")) => format!("new {class}"),
            Some((class, method)) => format!("{class}.{}", camel(method, false)),
            None if part.chars().all(plain) => camel(part, false),
            None => part.into(),
        }
    });
    parts.collect::<Vec<_>>().join("`")
}

/// Text without the targets of its links.
fn plain(text: &str) -> String {
    let (mut text, mut rest) = (String::new(), text);
    while let Some((before, after)) = rest.split_once('[') {
        let link = after
            .split_once(']')
            .filter(|(name, behind)| name.starts_with('`') || behind.starts_with('('));
        let Some((name, behind)) = link else {
            text += before;
            text.push('[');
            rest = after;
            continue;
        };
        text += before;
        text += name;
        rest = match behind
            .strip_prefix('(')
            .and_then(|target| target.split_once(')'))
        {
            Some((_, behind)) => behind,
            None => behind,
        };
    }
    text + rest
}

/// A comment of JavaScript.
fn comment(indent: &str, lines: &[String]) -> String {
    let mut text = format!("{indent}/**\n");
    let mut empty = true;
    let last = lines.iter().rposition(|line| !line.is_empty()).unwrap_or(0);
    for line in &lines[..=last] {
        // Two empty lines are one.
        if !(line.is_empty() && empty) {
            text += format!("{indent} * {line}").trim_end();
            text.push('\n');
        }
        empty = line.is_empty();
    }
    text + indent + " */\n"
}
