//! No sampler without its names: what is generic over a tier or a grade has an alias in each, and every warp is in
//! the list of warps.

use std::collections::BTreeSet;

/// What a header of an `impl` says.
struct Impl<'a> {
    /// The trait, without its arguments; empty where there is none.
    of: &'a str,
    name: &'a str,
    /// Whether the type is generic over something of this trait.
    over: BTreeSet<&'a str>,
}

/// The text up to the bracket that closes the one it begins with; and what follows. Arrows close nothing.
fn bracketed(text: &str) -> (&str, &str) {
    let mut open = 0;
    let closing = text.char_indices().find(|(i, c)| {
        open += i32::from(*c == '<') - i32::from(*c == '>' && !text[..*i].ends_with('-'));
        open == 0
    });
    let (end, _) = closing.expect("a closing bracket");
    (&text[1..end], &text[end + 1..])
}

fn name_of(path: &str) -> &str {
    let plain = path.split('<').next().unwrap();
    plain.trim().rsplit("::").next().unwrap()
}

impl<'a> Impl<'a> {
    /// Of a header, without the word itself.
    fn new(header: &'a str) -> Self {
        let generic = header.starts_with('<');
        let (generics, rest) = if generic {
            bracketed(header)
        } else {
            ("", header)
        };
        let head = rest.split('{').next().unwrap();
        let (subject, bounds) = head.split_once("where").unwrap_or((head, ""));
        let (of, name) = subject.split_once(" for ").unwrap_or(("", subject));
        let arguments = name.split_once('<').map_or("", |(_, arguments)| arguments);
        let names = |variable: &str| {
            let mut words = arguments.split(|c: char| !c.is_alphanumeric());
            words.any(|word| word == variable)
        };
        let bounds = generics.split(',').chain(bounds.split(','));
        let over = bounds
            .filter_map(|bound| bound.split_once(':'))
            .filter(|(variable, _)| names(variable.trim()))
            .flat_map(|(_, traits)| traits.split('+').map(name_of));
        Self {
            of: name_of(of),
            name: name_of(name),
            over: over.collect(),
        }
    }
}

/// The headers of a source's `impl`s.
fn impls(text: &str) -> Vec<Impl<'_>> {
    text.split("\nimpl").skip(1).map(Impl::new).collect()
}

/// Which names are missing in a house, and where: of the texts of its files, by their paths below `src`.
pub fn missing(sources: &[(String, String)]) -> Vec<String> {
    let text = |file: &str| {
        let found = sources.iter().find(|(path, _)| path == file);
        found.map_or("", |(_, text)| text)
    };
    let has = |file: &str, entry: &str| {
        let mut lines = text(file).lines().map(str::trim);
        lines.any(|line| !line.starts_with("//") && line.contains(entry))
    };
    let mut missing = BTreeSet::new();
    for (path, source) in sources {
        let stem = path
            .strip_suffix(".rs")
            .unwrap()
            .rsplit('/')
            .next()
            .unwrap();
        for item in impls(source) {
            let Impl { of, name, over } = &item;
            let public = |kind| {
                let mut lines = source.lines().filter_map(|l| l.strip_prefix(kind));
                lines.any(|line| name_of(line.split(['(', ' ', ';']).next().unwrap()) == *name)
            };
            if !public("pub struct ") && !public("pub enum ") {
                continue;
            }
            let entry = format!("{stem}::{name}");
            if over.contains("Tier")
                && !has("warp.rs", &format!("{entry}<T> \""))
                && !has("warp.rs", &format!("{entry}<T, N> \""))
                && !has("lib.rs", &format!("pub type {name}<"))
                && !has("lib.rs", &format!("pub type {name} "))
            {
                missing.insert(format!("{name} in the tiers"));
            }
            if *of == "Warp"
                && path.starts_with("warp/")
                && !has("warp.rs", &format!("{entry}<"))
                && !has("warp.rs", &format!("{entry} "))
            {
                missing.insert(format!("{name} in the list of warps"));
            }
            if over.contains("Grade")
                && !has("fixed.rs", &format!("{entry} \""))
                && !has("fixed.rs", &format!("{entry}["))
            {
                missing.insert(format!("{name} in the grades"));
            }
        }
    }
    missing.into_iter().collect()
}

/// How many types are generic over a trait.
pub fn count_over(sources: &[(String, String)], bound: &str) -> usize {
    let all = sources.iter().flat_map(|(_, source)| impls(source));
    let names: BTreeSet<_> = all
        .filter(|i| i.over.contains(bound))
        .map(|i| i.name)
        .collect();
    names.len()
}
