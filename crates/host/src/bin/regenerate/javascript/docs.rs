//! Doc comments of Rust as those of JavaScript.

use super::{Class, camel};
use microwarp::Error;
use microwarp_host::docs::Kind;
use microwarp_host::upkeep::{Outcome, errors, read, root, wrapped};
use std::collections::BTreeSet;
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
        let text = read("src/warp/location_scale.rs")?;
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
    fn above(&self, line: usize) -> Vec<&str> {
        let above = self.lines[..line].iter().rev().map(|line| line.trim());
        let comment = above.take_while(|line| line.starts_with("///") || line.starts_with("#["));
        let comment = comment.filter_map(|line| line.strip_prefix("///"));
        let mut lines: Vec<&str> = comment
            .map(|line| line.strip_prefix(' ').unwrap_or(line))
            .collect();
        lines.reverse();
        lines
    }

    /// The comment of the class.
    pub fn class(&self, names: &Names) -> Outcome<String> {
        let line = self.declared().ok_or("not declared")?;
        let (mut taken, mut blocks) = (true, Vec::new());
        for block in blocks_of(&self.above(line)) {
            match block {
                Block::Heading(heading) => {
                    taken = SECTIONS.contains(&heading.as_str());
                    if taken {
                        blocks.push(Block::Heading(format!("**{heading}**")));
                    }
                }
                block if taken => blocks.extend(spoken(block, names)),
                _ => {}
            }
        }
        if blocks.is_empty() {
            return Err(format!("{} has no documentation", self.name));
        }
        names.sound(&blocks)?;
        Ok(comment("", &blocks))
    }

    /// The comment of a constructor, by its name in Rust.
    pub fn constructor(&self, name: &str, names: &Names) -> Outcome<String> {
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
                _ => Self::family()?.constructor(name, names),
            };
        };
        let errors = errors()?;
        let (mut taken, mut blocks) = (true, Vec::new());
        for block in blocks_of(&self.above(line)) {
            match block {
                Block::Heading(heading) => {
                    taken = heading == "Errors";
                    if taken {
                        blocks.push(Block::Heading("@throws RangeError:".into()));
                    }
                }
                block if taken => blocks.extend(match spoken(block, names) {
                    Some(Block::Text(text, lead)) => Some(Block::Text(coded(&text, &errors), lead)),
                    other => other,
                }),
                _ => {}
            }
        }
        names.sound(&blocks)?;
        Ok(comment("  ", &blocks))
    }
}

/// A part of a comment.
#[derive(Clone)]
enum Block {
    Heading(String),
    /// A row of a table.
    Row(String),
    /// A paragraph, or with `- ` as its lead an item of a list; in one line.
    Text(String, &'static str),
    /// What parts paragraphs.
    Gap,
}

/// The blocks of a comment, without its programs.
fn blocks_of(lines: &[&str]) -> Vec<Block> {
    let (mut blocks, mut program) = (Vec::new(), false);
    for line in lines {
        let mark = line.starts_with("```");
        program ^= mark;
        if mark || program {
            continue;
        }
        let (text, lead) = match line.strip_prefix("- ") {
            Some(item) => (item, "- "),
            None => (line.trim(), ""),
        };
        match blocks.last_mut() {
            _ if text.is_empty() => blocks.push(Block::Gap),
            _ if line.starts_with("# ") => blocks.push(Block::Heading(line[2..].into())),
            _ if line.starts_with('|') => blocks.push(Block::Row((*line).into())),
            Some(Block::Text(before, _)) if lead.is_empty() => {
                before.push(' ');
                before.push_str(text);
            }
            _ => blocks.push(Block::Text(text.into(), lead)),
        }
    }
    blocks
}

/// A block as JavaScript says it, or nothing where all of it is about what JavaScript does not have.
fn spoken(block: Block, names: &Names) -> Option<Block> {
    match block {
        Block::Row(row) => {
            // Of a table of errors the column of `poly` alone, and the kind. Where both tiers have one bound, there is no other.
            let cells: Vec<&str> = row.split('|').collect();
            let is_kind = |cell: &str| {
                matches!(cell.trim(), "kind" | "---") || Kind::parse(cell.trim()).is_some()
            };
            Some(Block::Row(match cells[..] {
                [_, _, _, kind, _] if is_kind(kind) => row,
                [_, title, _, poly, _] => format!("|{title}|{poly}|"),
                [_, title, _, poly, kind, _] => format!("|{title}|{poly}|{kind}|"),
                _ => row,
            }))
        }
        Block::Text(text, lead) => {
            let kept: Vec<String> = sentences(&text)
                .into_iter()
                .filter_map(|sentence| names.spoken(sentence))
                .collect();
            (!kept.is_empty()).then(|| Block::Text(kept.join(" "), lead))
        }
        block => Some(block),
    }
}

/// The sentences of a text: each ends with a full stop, and the next begins with something else than a small letter.
fn sentences(text: &str) -> Vec<&str> {
    let (mut sentences, mut from) = (Vec::new(), 0);
    for (at, _) in text.match_indices(". ") {
        let next = text[at + 2..].chars().next();
        let word = text[from..at].rsplit(' ').next().unwrap_or_default();
        let initial = word.chars().count() == 1 && word.chars().all(char::is_uppercase);
        if !initial && next.is_some_and(|next| !next.is_lowercase()) {
            sentences.push(&text[from..=at]);
            from = at + 2;
        }
    }
    sentences.push(&text[from..]);
    sentences
}

/// What the typings may name within a class.
pub struct Names {
    class: String,
    /// Classes, their constructors, and the methods of all: `Normal`, `new Normal`, `Exponential.fromRate`, `Warp.draw`.
    known: BTreeSet<String>,
    /// Parameters.
    parameters: BTreeSet<String>,
}

/// What is no class of a warp.
const OTHERS: [&str; 11] = [
    "Alias",
    "Cdf",
    "LatLongMap",
    "Mixture",
    "PiecewiseConstant1d",
    "PiecewiseConstant2d",
    "PiecewiseLinear1d",
    "Reflected",
    "Sobol",
    "SumTree",
    "Warp",
];
const METHODS: [&str; 8] = [
    "draw", "sample", "pdf", "invert", "fill", "map", "pdfs", "inverts",
];
/// Methods of Rust that are functions.
const FUNCTIONS: [&str; 2] = ["sample_with_pdf", "draw_with_pdf"];
/// What some classes have beside.
const MEMBERS: [&str; 3] = [
    "GgxVisible.reflect",
    "GgxVisible.reflectedPdf",
    "VisibleSphere.sampleLight",
];
/// Code that is no name of the package: types and the tier of the crate, and a word of a formula.
const WORDS: [&str; 3] = ["f32", "poly", "near"];

impl Names {
    pub fn of(class: &Class, all: &[Class]) -> Self {
        let mut known: BTreeSet<String> = OTHERS.map(String::from).into();
        known.extend(MEMBERS.map(String::from));
        known.extend(FUNCTIONS.map(|name| camel(name, false)));
        for class in all {
            known.insert(class.name.clone());
            known.extend(class.constructors.iter().map(|constructor| {
                match constructor.name().as_str() {
                    "new" => format!("new {}", class.name),
                    name => format!("{}.{name}", class.name),
                }
            }));
        }
        for method in METHODS {
            known.insert(format!("Warp.{method}"));
            known.insert(format!("{}.{method}", class.name));
        }
        let parameters = class.constructors.iter().flat_map(|made| &made.parameters);
        Self {
            class: class.name.clone(),
            known,
            parameters: parameters.map(|(name, _)| camel(name, false)).collect(),
        }
    }

    /// A sentence as JavaScript says it; nothing where it refers to what is not there.
    fn spoken(&self, sentence: &str) -> Option<String> {
        let mut text = String::new();
        let sentence = sentence.replace(
            "a [`SurfacePoint`]",
            "position and outward normal, six numbers",
        );
        for piece in pieces(&sentence) {
            match piece {
                Piece::Text(piece) => {
                    for (i, part) in piece.split('`').enumerate() {
                        if i > 0 {
                            text.push('`');
                        }
                        match (i % 2, part.contains("::")) {
                            (1, true) => text += &self.reference(part)?,
                            (1, false) => text += &self.code(part),
                            _ => text += part,
                        }
                    }
                }
                Piece::Link(name, target) => match name.trim_matches('`') {
                    code if code != name => text += &format!("`{}`", self.reference(code)?),
                    _ => {
                        let page = target.strip_prefix("crate::").unwrap_or(target);
                        let page = page.replace("::", "/").replace('#', "/#");
                        let address = match target.starts_with("http") {
                            true => target.into(),
                            false => format!("https://docs.rs/microwarp/latest/microwarp/{page}"),
                        };
                        text += &format!("[{name}]({address})");
                    }
                },
            }
        }
        Some(text)
    }

    /// A name of the crate by its name in JavaScript: `Cone::from_sine` is `Cone.fromSine`, and `Cone::new` is `new Cone`.
    fn reference(&self, rust: &str) -> Option<String> {
        if rust.starts_with("Error::") {
            return Some(rust.into());
        }
        let (class, method) = match rust.split_once("::") {
            Some((class, method)) => (class, method),
            None if rust.starts_with(char::is_uppercase) => (rust, ""),
            None => (self.class.as_str(), rust),
        };
        if FUNCTIONS.contains(&method) {
            return Some(camel(method, false));
        }
        let name = match method {
            "" => class.into(),
            "new" => format!("new {class}"),
            method => format!("{class}.{}", camel(method, false)),
        };
        let known = self.known.contains(&name);
        let bare = name.strip_prefix(&format!("{}.", self.class));
        known.then(|| match bare {
            Some(method) if !rust.contains("::") => method.into(),
            _ => name.clone(),
        })
    }

    /// Code that is no reference.
    fn code(&self, rust: &str) -> String {
        let plain = |c: char| c.is_ascii_lowercase() || c == '_';
        match rust {
            "new" => format!("new {}", self.class),
            name if name.chars().all(plain) => camel(name, false),
            formula => formula.into(),
        }
    }

    /// Whether each text is whole and names nothing that JavaScript does not have.
    fn sound(&self, blocks: &[Block]) -> Outcome {
        for block in blocks {
            if let Block::Text(text, _) = block {
                self.whole(text)
                    .map_err(|what| format!("{}: {what} in \"{text}\"", self.class))?;
            }
        }
        Ok(())
    }

    fn whole(&self, text: &str) -> Outcome {
        // An interval has a bracket of each kind.
        let open = text.matches(['(', '[']).count();
        if open != text.matches([')', ']']).count() {
            return Err("a parenthesis without another".into());
        }
        if text.matches('`').count() % 2 != 0 {
            return Err("code without an end".into());
        }
        if !text.ends_with(['.', ':']) {
            return Err("a sentence without an end".into());
        }
        let is_name = |code: &&str| {
            let mut chars = code.chars();
            chars.next().is_some_and(|c| c.is_ascii_alphabetic())
                && chars.all(|c| c.is_ascii_alphanumeric() || "_.".contains(c))
                && code.chars().count() > 1
                && !code.ends_with(".md")
        };
        let unknown = text.split('`').skip(1).step_by(2).find(|code| {
            let known = |name: &str| self.known.contains(name);
            is_name(code)
                && !known(code)
                && !known(&format!("{}.{code}", self.class))
                && !self.parameters.contains(*code)
                && !WORDS.contains(code)
        });
        unknown.map_or(Ok(()), |name| Err(format!("`{name}`, which is not there,")))
    }

    /// What is cut, or names what is not there, is seen.
    pub fn control(&self) -> Outcome {
        let wrong = [
            "The density is |x|x|",
            "Take `open`), which is never 0.",
            "Never 0 (where it matters.",
            "`Strata1d.draw` has more.",
            "It has `locate`.",
            "An end of `code.",
        ];
        match wrong.iter().find(|text| self.whole(text).is_ok()) {
            Some(text) => Err(format!("control: \"{text}\" passes")),
            None => self.whole("On [0, 1), by `draw` or `Warp.draw`."),
        }
    }
}

/// Text, or a link with its target; a link to a name of the crate may have none.
enum Piece<'a> {
    Text(&'a str),
    Link(&'a str, &'a str),
}

fn pieces(text: &str) -> Vec<Piece<'_>> {
    let (mut pieces, mut from, mut at) = (Vec::new(), 0, 0);
    while let Some(open) = text[at..].find('[').map(|i| at + i) {
        at = open + 1;
        let Some((name, behind)) = text[at..].split_once(']') else {
            break;
        };
        let target = behind.strip_prefix('(').map(inside).unwrap_or_default();
        // Another bracket within is the link, if any is.
        if name.contains('[')
            || target.is_empty() && !(name.starts_with('`') && name.ends_with('`'))
        {
            continue;
        }
        pieces.push(Piece::Text(&text[from..open]));
        pieces.push(Piece::Link(name, target));
        let marks = if target.is_empty() { 1 } else { 3 };
        from = at + name.len() + target.len() + marks;
        at = from;
    }
    pieces.push(Piece::Text(&text[from..]));
    pieces
}

/// The text up to the parenthesis that closes.
fn inside(text: &str) -> &str {
    let mut depth = 1;
    for (at, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &text[..at];
        }
    }
    ""
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

/// A comment of JavaScript.
fn comment(indent: &str, blocks: &[Block]) -> String {
    let mut lines: Vec<String> = Vec::new();
    for (i, block) in blocks.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| &blocks[i]);
        match block {
            Block::Gap if matches!(before, None | Some(Block::Gap)) => {}
            Block::Gap => lines.push(String::new()),
            Block::Heading(line) | Block::Row(line) => lines.push(line.clone()),
            Block::Text(text, lead) => {
                let width = 120 - indent.len() - 3 - lead.len();
                for (i, line) in wrapped(text, width).into_iter().enumerate() {
                    let lead = if i == 0 { *lead } else { &"  "[..lead.len()] };
                    lines.push(format!("{lead}{line}"));
                }
            }
        }
    }
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    let lines = lines
        .iter()
        .map(|line| format!("{indent} * {line}").trim_end().to_owned() + "\n");
    format!("{indent}/**\n{}{indent} */\n", lines.collect::<String>())
}
